// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryField.h"

#include "TransferFunction.h"
#include "UserError.h"

#include "vtkAnalyticVolumeSource.h"

#include <vtkDataSetTriangleFilter.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <map>

namespace
{
// Voxels of unit length, so that steps and extinctions mean the same in all fields.
vtkSmartPointer<vtkImageData> InVoxels(vtkAnalyticVolumeSource* source)
{
  source->Update();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->ShallowCopy(source->GetOutput());
  image->SetSpacing(1.0, 1.0, 1.0);
  image->SetOrigin(0.0, 0.0, 0.0);
  return image;
}

vtkSmartPointer<vtkUnstructuredGrid> CutIntoTetrahedra(vtkImageData* image)
{
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(image);
  cut->Update();
  return cut->GetOutput();
}

using Maker = void (*)(vtkAnalyticVolumeSource*);

const std::map<std::string, Maker> Makers = {
  { "marschner-lobb",
    [](vtkAnalyticVolumeSource* source) {
      source->SetFieldToMarschnerLobb();
      source->SetDimensions(128, 128, 128);
    } },
  { "sphere",
    [](vtkAnalyticVolumeSource* source) {
      source->SetFieldToSphere();
      source->SetRadius(0.6);
      source->SetDimensions(96, 96, 96);
    } },
  { "ellipsoid",
    [](vtkAnalyticVolumeSource* source) {
      source->SetFieldToEllipsoid();
      source->SetSemiAxes(0.38, 0.38, 0.76);
      source->SetDimensions(96, 96, 96);
    } },
  { "cylinder",
    [](vtkAnalyticVolumeSource* source) {
      source->SetFieldToCylinder();
      source->SetRadius(0.38);
      source->SetDimensions(96, 96, 96);
    } },
  { "packed",
    [](vtkAnalyticVolumeSource* source) {
      source->SetFieldToPackedEllipsoids();
      source->SetBoundsToPackedEllipsoids();
      source->SetDimensions(125, 46, 256);
    } },
  { "plant",
    [](vtkAnalyticVolumeSource* source) {
      source->SetFieldToPlant();
      source->SetDimensions(128, 128, 128);
    } },
  { "tubes",
    [](vtkAnalyticVolumeSource* source) {
      source->SetFieldToVortexTubes();
      source->SetDimensions(144, 144, 144);
    } },
  { "coulomb",
    [](vtkAnalyticVolumeSource* source) {
      source->SetFieldToCoulombPotentials();
      source->SetDimensions(128, 128, 128);
    } },
  { "orbital",
    [](vtkAnalyticVolumeSource* source) {
      source->SetFieldToHydrogenOrbital();
      source->SetDimensions(128, 128, 128);
    } },
  { "bucky-tetrahedra",
    [](vtkAnalyticVolumeSource* source) {
      source->SetFieldToBuckyball();
      source->SetDimensions(32, 32, 32);
    } },
};
}

Volume GalleryField(const std::string& name, const std::string& craniumFile)
{
  Volume volume;
  if (name == "cranium")
  {
    volume = ReadVolume(craniumFile);
    volume.Image = IsolateLargestRegion(volume.Image, Preset("cranium").Isolate);
    return volume;
  }
  vtkNew<vtkAnalyticVolumeSource> source;
  Makers.at(name)(source);
  volume.Image = InVoxels(source);
  volume.Name = name;
  if (name == "bucky-tetrahedra")
  {
    volume.Tetrahedra = CutIntoTetrahedra(volume.Image);
  }
  return volume;
}
