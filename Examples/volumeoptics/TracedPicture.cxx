// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TracedPicture.h"

#include "UserError.h"
#include "VolumeScene.h"

#include "ConeIntegral.h"
#include "RayCaster.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeCollection.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

namespace
{
struct KeptPicture
{
  const char* Name;
  const unsigned char* Bytes;
  std::size_t Size;
};

#include "TracedPictures.inc" // KeptPictures, made by CMake

// Of the scene's steps: light falls steeply within a surface, and coarser ones show as rings.
constexpr double StepShare = 0.25;

void WritePng(const reference::Image& image, const std::string& file)
{
  vtkNew<vtkImageData> bytes;
  bytes->SetDimensions(image.width, image.height, 1);
  bytes->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* byte = static_cast<unsigned char*>(bytes->GetScalarPointer());
  for (const glm::dvec4& pixel : image.pixels)
  {
    for (int i = 0; i < 3; ++i)
    {
      *byte++ = static_cast<unsigned char>(std::lround(255.0 * std::clamp(pixel[i], 0.0, 1.0)));
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(bytes);
  writer->SetFileName(file.c_str());
  writer->SetCompressionLevel(9);
  writer->Write();
}
}

void TracePicture(VolumeScene& scene, double angle, int rays, const std::string& pngFile)
{
  scene.Render();
  auto* volume = vtkVolume::SafeDownCast(scene.GetRenderer()->GetVolumes()->GetItemAsObject(0));
  const int* size = scene.GetWindow()->GetSize();
  reference::Scene traced = reference::SceneFromVTK(scene.GetRenderer(), volume, size[0], size[1]);
  traced.step *= StepShare;
  const reference::Occluders things(traced, traced.grid.SmallestSpacing());
  const reference::ConeRays cone{ angle, rays, 1 };
  traced.visibility = [&](const reference::Vector& point, const reference::Vector& toViewer) {
    return reference::ConeVisibility(things, point, toViewer, cone);
  };
  const double* background = scene.GetRenderer()->GetBackground();
  WritePng(reference::Over(
             reference::Render(traced), reference::Vector(background[0], background[1], background[2])),
    pngFile);
}

void WriteTracedPicture(const std::string& name, const std::string& pngFile)
{
  for (const KeptPicture& kept : KeptPictures)
  {
    if (kept.Name == name)
    {
      std::ofstream file(pngFile, std::ios::binary);
      file.write(reinterpret_cast<const char*>(kept.Bytes), static_cast<std::streamsize>(kept.Size));
      return;
    }
  }
  throw UserError("The traced picture '" + name +
    "' is not kept with this program. Make it with `volumeoptics gallery --trace FOLDER`.");
}
