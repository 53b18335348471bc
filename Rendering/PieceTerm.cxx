// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceTerm.h"

#include "vtkOpticsVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <limits>

namespace
{
bool IsEmpty(const int extent[6])
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

// As VTK, which begins the rays of a camera inside a volume that far behind the near plane.
float FindNearest(vtkCamera* camera)
{
  const double* range = camera->GetClippingRange();
  const double least = 1000.0 * std::numeric_limits<float>::epsilon();
  return static_cast<float>(range[0] + std::max(0.001 * (range[1] - range[0]), least));
}

// A box of VTK's texture coordinates, of which a volume has some from its first point to its last.
struct Box
{
  float Least[3];
  float Greatest[3];
};

// The coordinates of an extent, with those of the input's.
Box Place(const int extent[6], const int input[6], const Box& ofInput)
{
  Box box = ofInput;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int size = input[2 * axis + 1] - input[2 * axis];
    if (size > 0)
    {
      const float length = (ofInput.Greatest[axis] - ofInput.Least[axis]) / static_cast<float>(size);
      box.Least[axis] += length * static_cast<float>(extent[2 * axis] - input[2 * axis]);
      box.Greatest[axis] += length * static_cast<float>(extent[2 * axis + 1] - input[2 * axis + 1]);
    }
  }
  return box;
}

// Where the whole would be cropped, as a plane of the input. VTK takes a plane's share of the bounds for its texture
// coordinate, and so is off by up to half a voxel, which each piece would be by another length.
double AlignPlane(
  double plane, vtkImageData* input, int axis, const int whole[6], const Box& ofInput, const Box& ofWhole)
{
  const int first = input->GetExtent()[2 * axis];
  const int size = input->GetExtent()[2 * axis + 1] - first;
  const double sizeOfWhole = whole[2 * axis + 1] - whole[2 * axis];
  if (size == 0 || sizeOfWhole <= 0.0)
  {
    return plane;
  }
  const double origin = input->GetOrigin()[axis];
  const double spacing = input->GetSpacing()[axis];
  const double share = std::clamp(((plane - origin) / spacing - whole[2 * axis]) / sizeOfWhole, 0.0, 1.0);
  const double margin = ofInput.Least[axis] > 0.0F ? 0.5 / (sizeOfWhole + 1.0) : 0.0; // of points
  const double place = (share - margin) / (1.0 - 2.0 * margin);
  const double inInput = ofWhole.Least[axis] + place * (ofWhole.Greatest[axis] - ofWhole.Least[axis]);
  return origin + spacing * (first + inInput * size);
}

// Of an image whose axes are those of its coordinates, as cropping is only there in its place.
void AlignCropping(vtkOpticsVolumeMapper* mapper, const int whole[6], const Box& ofInput, const Box& ofWhole,
  vtkShaderProgram* program)
{
  vtkImageData* input = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  if (!mapper->GetCropping() || !input->GetDirectionMatrix()->IsIdentity())
  {
    return;
  }
  float planes[6];
  for (int side = 0; side < 6; ++side)
  {
    const double plane = mapper->GetCroppingRegionPlanes()[side];
    planes[side] = static_cast<float>(AlignPlane(plane, input, side / 2, whole, ofInput, ofWhole));
  }
  program->SetUniform1fv("in_croppingPlanes", 6, planes);
}

bool HasClippingPlanes(vtkOpticsVolumeMapper* mapper)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  return planes && planes->GetNumberOfItems() > 0;
}

// Not beyond the input.
void FindDrawn(vtkOpticsVolumeMapper* mapper, const int input[6], int drawn[6])
{
  mapper->GetDrawnExtent(drawn);
  if (IsEmpty(drawn))
  {
    std::copy(input, input + 6, drawn);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    drawn[2 * axis] = std::max(drawn[2 * axis], input[2 * axis]);
    drawn[2 * axis + 1] = std::min(drawn[2 * axis + 1], input[2 * axis + 1]);
  }
}
}

//------------------------------------------------------------------------------
bool PieceTerm::IsActive(const OpticsScene& scene)
{
  return (!IsEmpty(scene.Mapper->GetDrawnExtent()) || !IsEmpty(scene.Mapper->GetWholeExtent())) &&
    vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput()) && scene.Mapper->GetInputCount() == 1 &&
    scene.Mapper->GetBlendMode() != vtkVolumeMapper::SLICE_BLEND && !scene.Mapper->HasPartitions();
}

//------------------------------------------------------------------------------
void PieceTerm::AddFeatures(const OpticsScene&, OpticsFeatures& features)
{
  const bool hasSegments = features.Has(OpticsFeature::Integral);
  features.Add(OpticsFeature::Piece);
  features.Add(hasSegments ? OpticsFeature::PieceOfSegments : OpticsFeature::PieceOfSamples);
}

//------------------------------------------------------------------------------
// Now, when VTK has set the box of the input. What has sampled the volume before, a visibility sweep, has seen all.
void PieceTerm::BeforeDraw(const OpticsScene& scene, vtkShaderProgram* program)
{
  int input[6];
  vtkImageData::SafeDownCast(scene.Mapper->GetDataSetInput())->GetExtent(input);
  int drawn[6];
  FindDrawn(scene.Mapper, input, drawn);
  int whole[6];
  scene.Mapper->GetWholeExtent(whole);
  Box ofInput;
  scene.Mapper->GetTextureBox(ofInput.Least, ofInput.Greatest);
  const Box ofDrawn = Place(drawn, input, ofInput);
  if (IsEmpty(whole))
  {
    std::copy(drawn, drawn + 6, whole);
  }
  const Box ofWhole = Place(whole, input, ofInput);
  // VTK counts samples from a clipping plane, if one cuts the ray's beginning off, and places it by each piece's size
  const Box ofSamples = HasClippingPlanes(scene.Mapper) ? ofDrawn : ofWhole;
  program->SetUniform3f("in_opticsWholeMin", ofSamples.Least);
  program->SetUniform3f("in_opticsWholeMax", ofSamples.Greatest);
  program->SetUniform3f("in_opticsInputMin", ofInput.Least);
  program->SetUniform3f("in_opticsInputMax", ofInput.Greatest);
  program->SetUniformf("in_opticsNearest", FindNearest(scene.Renderer->GetActiveCamera()));
  AlignCropping(scene.Mapper, whole, ofInput, ofWhole, program);
  program->SetUniform3fv("in_texMin", 1, &ofDrawn.Least);
  program->SetUniform3fv("in_texMax", 1, &ofDrawn.Greatest);
}
