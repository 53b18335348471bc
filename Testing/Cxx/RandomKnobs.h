// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every knob of the mapper, within and outside of its range: ours, and VTK's.

#ifndef RandomKnobs_h
#define RandomKnobs_h

#include "RandomData.h"

#include "vtkAmbientCovarianceFilter.h"
#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkSobelNormalFilter.h"

namespace
{
class RandomKnobs
{
public:
  RandomKnobs(Dice& dice, TestScene& scene, RandomData& data)
    : Random(dice)
    , Optics(scene.Optics)
    , Mapper(vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(scene.Mapper))
    , Window(scene.Window)
    , Data(data)
  {
  }

  // All of them anew.
  void Change()
  {
    this->SetSteps();
    this->SetFrames();
    this->SetTables();
    this->SetVisibility();
    this->SetLines();
    this->SetPieces();
    this->SetDrawing();
    if (this->Random.Is(0.15))
    {
      this->Optics->SetQuality(this->Random.Choice(4));
    }
  }

private:
  int Bits()
  {
    const int bits[] = { 8, 16, 32, 7 };
    return this->Random.Of(bits);
  }

  void SetSteps()
  {
    this->Mapper->SetAutoAdjustSampleDistances(this->Random.Is(0.3));
    this->Mapper->SetLockSampleDistanceToInputSpacing(this->Random.Is(0.1));
    this->Mapper->SetSampleDistance(
      static_cast<float>(this->Data.GetScale() * this->Random.PowerOfTen(-1.0, 1.0)));
    this->Mapper->SetUseJittering(this->Random.Is(0.3));
    // VTK's own pictures of less than two pixels fail, or end in a crash
    const int* size = this->Window->GetSize();
    const double most = std::clamp(std::min(size[0], size[1]) / 2, 1, 4);
    this->Mapper->SetImageSampleDistance(
      this->Random.Is(0.9) ? 1.0F : static_cast<float>(this->Random.Between(0.5, most)));
    this->Optics->SetSkipEmptySpace(this->Random.Is(0.5));
    this->Optics->SetMacrocellSize(this->Random.Number(12));
  }

  void SetFrames()
  {
    this->Optics->SetFrameResolutionFactor(this->Random.Setting(0.25, 1.0));
    this->Optics->SetFramePrecision(this->Bits());
    this->Optics->SetExtinctionGradient(this->Random.Number(2));
    this->Optics->SetScalarGradient(this->Random.Number(3));
    vtkAmbientCovarianceFilter* filter = this->Optics->GetAmbientCovarianceFilter();
    filter->SetStorage(this->Random.Choice(3));
    filter->SetRadius(this->Random.Setting(1.0, 8.0));
    filter->SetScalarTolerance(this->Random.Setting(0.0, 1.0));
    filter->SetNumberOfSamples(this->Random.Is(0.1) ? 2 : 3 + this->Random.Number(100));
    filter->SetSamplingPattern(this->Random.Choice(4));
    filter->SetSampleInterpolation(this->Random.Choice(2));
    filter->SetNoiseCorrection(this->Random.Is(0.5));
    const bool areConnected = this->Random.Is(0.05);
    this->Optics->SetNormalsInputData(areConnected ? this->Normals() : nullptr);
  }

  // Of the data's size or of another one, by which they cannot be used.
  vtkSmartPointer<vtkImageData> Normals()
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    const int* size = this->Data.GetDimensions();
    image->SetDimensions(this->Random.Is(0.7) ? size[0] : 1 + this->Random.Number(9), size[1], size[2]);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    vtkNew<vtkFloatArray> magnitudes;
    magnitudes->SetName("GradientMagnitude");
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      normals->InsertNextTuple3(
        this->Random.Between(-1.0, 1.0), this->Random.Between(-1.0, 1.0), this->Random.Setting(-1.0, 1.0));
      magnitudes->InsertNextValue(static_cast<float>(this->Random.Setting(0.0, 1.0)));
    }
    image->GetPointData()->AddArray(normals);
    image->GetPointData()->AddArray(magnitudes);
    return image;
  }

  void SetTables()
  {
    this->Optics->SetLightingTableSize(1 + this->Random.Number(300));
    this->Optics->SetLightingSamples(this->Random.Number(2));
    this->Optics->SetPreIntegrationTableSize(this->Random.Number(300));
    this->Optics->SetTablePrecision(this->Bits());
    this->Mapper->SetColorRangeType(this->Random.Number(2));
    this->Mapper->SetScalarOpacityRangeType(this->Random.Number(2));
    this->Mapper->SetGradientOpacityRangeType(this->Random.Number(2));
  }

  void SetVisibility()
  {
    const int samples[] = { 4, 8, 16, 5 };
    this->Optics->SetVisibilityGridSize(this->Random.Number(24));
    this->Optics->SetVisibilitySliceDistance(this->Random.Setting(0.5, 10.0));
    this->Optics->SetVisibilitySamples(this->Random.Of(samples));
    this->Optics->SetVisibilityAlgorithm(this->Random.Number(3));
    this->Optics->SetVisibilityDiskSize(this->Random.Count(1, 16));
    this->Optics->SetVisibilityTrueDistances(this->Random.Is(0.5));
    this->Optics->SetVisibilityGatherSamples(this->Random.Count(0, 8));
    this->Optics->SetVisibilityPrecision(this->Bits());
  }

  void SetLines()
  {
    this->Optics->SetLinePrecision(this->Bits());
    this->Optics->SetLineRadiusScale(this->Random.Number(2), this->Random.Setting(0.0, 10.0));
    this->Optics->SetLineOpacityScale(this->Random.Number(2), this->Random.Setting(0.0, 1.0));
    vtkNew<vtkPiecewiseFunction> function;
    function->AddPoint(0.0, this->Random.Between(0.0, 1.0));
    function->AddPoint(this->Random.Between(0.0, 1.0), 1.0);
    this->Optics->SetLineOpacityFunction(this->Random.Is(0.3) ? function.Get() : nullptr);
    this->Optics->SetLineBlockInputData(
      this->Random.Is(0.05) ? this->Data.MakeLines() : vtkSmartPointer<vtkImageData>());
  }

  // Of a larger whole; sometimes there is no such piece.
  void SetPieces()
  {
    if (!this->Random.Is(0.08))
    {
      return;
    }
    int drawn[6], whole[6];
    for (int side = 0; side < 6; ++side)
    {
      const int last = side % 2 == 0 ? 0 : this->Data.GetDimensions()[side / 2] - 1;
      drawn[side] = this->Random.Is(0.5) ? last : this->Random.Number(8) - 1;
      whole[side] = last + (side % 2 == 0 ? -1 : 1) * this->Random.Number(6);
    }
    this->Optics->SetDrawnExtent(drawn);
    this->Optics->SetWholeExtent(whole);
  }

  void SetDrawing()
  {
    this->Mapper->SetBlendMode(this->Random.Is(0.9) ? 0 : this->Random.Number(7));
    this->Mapper->SetUseDepthPass(this->Random.Is(0.05));
    this->Mapper->GetDepthPassContourValues()->SetValue(0, this->Data.Scalar());
    this->Mapper->SetRenderToImage(this->Random.Is(0.03));
    const bool isAlone =
      this->Mapper->GetNumberOfInputConnections(1) == 0; // VTK has no blocks of two volumes
    if (this->Random.Is(0.08) && isAlone)
    {
      this->Mapper->SetPartitions(static_cast<unsigned short>(1 + this->Random.Number(3)),
        static_cast<unsigned short>(1 + this->Random.Number(3)),
        static_cast<unsigned short>(1 + this->Random.Number(3)));
    }
    const bool hasWindow = this->Random.Is(0.05);
    this->Mapper->SetFinalColorWindow(hasWindow ? 0.7F : 1.0F);
    this->Mapper->SetFinalColorLevel(hasWindow ? 0.6F : 0.5F);
  }

  Dice& Random;
  vtkOpticsVolumeMapper* Optics;
  vtkOpenGLGPUVolumeRayCastMapper* Mapper;
  vtkRenderWindow* Window;
  RandomData& Data;
};
}

#endif
