// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A scene by a seed: data, every setting of the property and knob of the mapper, lights, camera, what cuts and what else
// is in the scene.

#ifndef RandomScene_h
#define RandomScene_h

#include "RandomKnobs.h"
#include "RandomSettings.h"

#include "vtkActor.h"
#include "vtkConeSource.h"
#include "vtkLODProp3D.h"
#include "vtkLight.h"
#include "vtkMultiVolume.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTransform.h"

namespace
{
class RandomScene : public TestScene
{
public:
  // mapper: ours where null
  explicit RandomScene(std::uint32_t seed, vtkGPUVolumeRayCastMapper* mapper = nullptr)
    : TestScene(mapper)
    , Random(seed)
    , Data(this->Random, *this)
    , Settings(this->Random, *this, this->Data)
    , Knobs(this->Random, *this, this->Data)
  {
    this->SetWindow();
    this->Settings.Change();
    this->Knobs.Change();
    this->SetLights();
    this->SetVolume();
    this->SetCuts();
    this->SetCamera();
    this->AddOthers();
  }

  // As a user would, between two frames.
  void Change()
  {
    if (this->Random.Is(0.7))
    {
      this->Settings.Change();
    }
    if (this->Random.Is(0.7))
    {
      this->Knobs.Change();
    }
    this->SetCamera();
  }

private:
  void SetWindow()
  {
    this->Window->SetSize(1 + this->Random.Number(20), 1 + this->Random.Number(20));
    this->Window->SetDesiredUpdateRate(this->Random.PowerOfTen(-3.0, 3.0));
    if (this->Random.Is(0.05))
    {
      this->Window->SetMultiSamples(4);
    }
    if (this->Random.Is(0.05))
    {
      this->Window->SetStereoTypeToAnaglyph();
      this->Window->StereoRenderOn();
    }
  }

  void SetLights()
  {
    const double size = this->Size();
    for (int i = this->Random.Is(0.05) ? 9 : this->Random.Number(4); i > 0; --i)
    {
      vtkNew<vtkLight> light;
      light->SetLightType(1 + this->Random.Number(3));
      const double reach = size * this->Random.PowerOfTen(-1.0, 1.0);
      double place[3];
      this->Place(reach, place);
      light->SetPosition(place);
      light->SetFocalPoint(this->Mapper->GetCenter());
      light->SetPositional(this->Random.Is(0.5));
      light->SetConeAngle(this->Random.Between(1.0, 180.0));
      light->SetIntensity(this->Random.Between(0.0, 2.0));
      light->SetAttenuationValues(this->Random.Number(2), this->Random.Between(0.0, 1.0) / size, 0.0);
      light->SetShadowAttenuation(static_cast<float>(this->Random.Between(0.0, 1.0)));
      light->SetSwitch(this->Random.Is(0.9));
      this->Renderer->AddLight(light);
    }
    this->Renderer->SetAutomaticLightCreation(this->Random.Is(0.9));
    this->Renderer->SetTwoSidedLighting(this->Random.Is(0.7));
  }

  double Size() { return std::max(this->Mapper->GetLength(), 1.0e-30); }

  // So far from the middle of the data along each axis, at most.
  void Place(double reach, double (&place)[3])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = this->Mapper->GetCenter()[axis] + reach * this->Random.Between(-1.0, 1.0);
    }
  }

  void SetVolume()
  {
    if (this->Random.Is(0.2))
    {
      vtkNew<vtkTransform> transform;
      transform->RotateWXYZ(this->Random.Between(0.0, 360.0), 1.0, 2.0, 3.0);
      transform->Scale(this->Random.PowerOfTen(-1.0, 1.0), 1.0, this->Random.Is(0.3) ? -1.0 : 1.0);
      this->Volume->SetUserTransform(transform);
    }
    if (this->Random.Is(0.1))
    {
      this->Volume->SetScale(this->Random.PowerOfTen(-3.0, 3.0));
      this->Volume->SetOrientation(this->Random.Between(0.0, 360.0), 20.0, 0.0);
    }
  }

  void SetCuts()
  {
    const double* center = this->Mapper->GetCenter();
    const double size = this->Mapper->GetLength();
    if (this->Random.Is(0.2))
    {
      this->Mapper->SetCropping(1);
      this->Mapper->SetCroppingRegionPlanes(center[0] - 0.2 * size, center[0] + 0.1 * size,
        center[1] - 0.1 * size, center[1] + 0.2 * size, center[2] - 0.1 * size, center[2] + 0.1 * size);
      this->Mapper->SetCroppingRegionFlags(this->Random.Number(1 << 27));
    }
    for (int i = this->Random.Is(0.2) ? 1 + this->Random.Number(6) : 0; i > 0; --i)
    {
      vtkNew<vtkPlane> plane;
      double place[3];
      this->Place(0.3 * size, place);
      plane->SetOrigin(place);
      plane->SetNormal(this->Random.Between(-1.0, 1.0), this->Random.Between(-1.0, 1.0), 1.0);
      this->Mapper->AddClippingPlane(plane);
    }
  }

  void SetCamera()
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(this->Random.Between(-1.0, 1.0), this->Random.Between(-1.0, 1.0), 1.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetViewAngle(this->Random.Is(0.8) ? 30.0 : this->Random.Between(1.0, 150.0));
    camera->SetParallelProjection(this->Random.Is(0.3));
    this->Renderer->ResetCamera();
    camera->Dolly(this->Random.Is(0.3) ? this->Random.PowerOfTen(0.0, 1.5) : 1.0); // into the volume, too
    this->Renderer->ResetCameraClippingRange();
  }

  // Geometry, levels of detail, a second volume in the mapper.
  void AddOthers()
  {
    if (this->Random.Is(0.15))
    {
      this->AddCone();
    }
    if (this->Random.Is(0.05))
    {
      vtkNew<vtkLODProp3D> prop;
      prop->AddLOD(this->Mapper, this->Property, 0.0);
      this->Replace(prop);
    }
    else if (this->Random.Is(0.03))
    {
      this->AddVolume();
    }
  }

  void Replace(vtkProp* prop)
  {
    this->Renderer->RemoveVolume(this->Volume);
    this->Renderer->AddViewProp(prop);
  }

  // The same data once more, elsewhere.
  void AddVolume()
  {
    vtkNew<vtkVolume> second;
    second->SetProperty(this->Property);
    second->SetPosition(0.3 * this->Size(), 0.0, 0.2 * this->Size());
    vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(this->Mapper)->SetPartitions(1, 1, 1);
    this->Mapper->SetMaskInput(nullptr); // VTK ends in a crash where several volumes have a mask of labels
    this->Mapper->SetInputConnection(1, this->Mapper->GetInputConnection(0, 0));
    vtkNew<vtkMultiVolume> both;
    both->SetMapper(this->Mapper);
    both->SetVolume(this->Volume, 0);
    both->SetVolume(second, 1);
    this->Replace(both);
  }

  // Opaque, or translucent and peeled.
  void AddCone()
  {
    vtkNew<vtkConeSource> cone;
    double place[3];
    this->Place(0.3 * this->Size(), place);
    cone->SetCenter(place);
    cone->SetHeight(this->Size() * this->Random.Between(0.1, 1.0));
    cone->SetRadius(this->Size() * this->Random.Between(0.1, 1.0));
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(cone->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    if (this->Random.Is(0.5))
    {
      actor->GetProperty()->SetOpacity(this->Random.Between(0.0, 1.0));
      this->Renderer->SetUseDepthPeeling(this->Random.Is(0.8));
      this->Renderer->SetUseDepthPeelingForVolumes(this->Random.Is(0.7));
      this->Window->SetAlphaBitPlanes(1);
    }
  }

  Dice Random;
  RandomData Data;
  RandomSettings Settings;
  RandomKnobs Knobs;
};
}

#endif
