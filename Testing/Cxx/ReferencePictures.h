// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A TestScene as the double-precision reference sees it.

#ifndef ReferencePictures_h
#define ReferencePictures_h

#include "RayCaster.h"
#include "TestScene.h"

#include "vtkAmbientCovarianceFilter.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkSobelNormalFilter.h"

#include <memory>

namespace
{
// Normals and covariance for the mapper and for the reference alike.
struct Frames
{
  vtkNew<vtkSobelNormalFilter> normals;
  vtkNew<vtkAmbientCovarianceFilter> covariance;

  explicit Frames(TestScene& scene)
  {
    this->normals->SetInputConnection(scene.Mapper->GetInputConnection(0, 0));
    this->covariance->SetInputConnection(scene.Mapper->GetInputConnection(0, 0));
    this->covariance->SetRadius(6.0);
    this->covariance->SetStorage(scene.Optics->GetAmbientCovarianceFilter()->GetStorage());
    this->normals->Update();
    this->covariance->Update();
    scene.Optics->SetNormalsInputData(this->normals->GetOutput());
    scene.Optics->SetAnisotropyInputData(this->covariance->GetOutput());
    scene.Optics->SetFramePrecision(32);
  }
  std::shared_ptr<reference::FrameField> Stored()
  {
    return std::make_shared<reference::GridFrameField>(this->normals->GetOutput(),
      this->covariance->GetOutput(), static_cast<reference::Storage>(this->covariance->GetStorage()));
  }
};

inline vtkSmartPointer<vtkImageData> FloatPicture(TestScene& scene)
{
  const std::vector<float> pixels = scene.RenderFloat();
  auto picture = vtkSmartPointer<vtkImageData>::New();
  const int* size = scene.Window->GetSize();
  picture->SetDimensions(size[0], size[1], 1);
  picture->AllocateScalars(VTK_FLOAT, 4);
  std::copy(pixels.begin(), pixels.end(), static_cast<float*>(picture->GetScalarPointer()));
  return picture;
}

// As far as the reference goes: what the mapper has beyond SceneFromVTK().
inline reference::Scene SceneOf(TestScene& stage, Frames& frames)
{
  reference::Scene scene = reference::SceneFromVTK(
    stage.Renderer, stage.Volume, stage.Window->GetSize()[0], stage.Window->GetSize()[1]);
  scene.frames = frames.Stored();
  scene.gradientEstimate = static_cast<reference::GradientEstimate>(stage.Optics->GetExtinctionGradient());
  const int gradient = stage.Optics->GetScalarGradient();
  const bool isStored = gradient == vtkOpticsVolumeMapper::Automatic
    ? scene.lighting || scene.rules
    : gradient == vtkOpticsVolumeMapper::Stored;
  scene.pairGradient =
    isStored ? reference::GradientEstimate::StoredNormal : reference::GradientEstimate::CentralDifferences;
  return scene;
}

// The reference over the stage's background, against its picture.
inline reference::Difference CompareShown(
  TestScene& stage, const reference::Image& truth, vtkImageData* picture)
{
  const double* background = stage.Renderer->GetBackground();
  return reference::Compare(truth, picture, reference::Vector(background[0], background[1], background[2]));
}
}

#endif
