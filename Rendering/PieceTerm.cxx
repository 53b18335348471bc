// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceTerm.h"

#include "vtkOpticsVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
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
  const Box ofWhole = Place(IsEmpty(whole) ? drawn : whole, input, ofInput);
  program->SetUniform3f("in_opticsWholeMin", ofWhole.Least);
  program->SetUniform3f("in_opticsWholeMax", ofWhole.Greatest);
  program->SetUniform3f("in_opticsInputMin", ofInput.Least);
  program->SetUniform3f("in_opticsInputMax", ofInput.Greatest);
  program->SetUniformf("in_opticsNearest", FindNearest(scene.Renderer->GetActiveCamera()));
  program->SetUniform3fv("in_texMin", 1, &ofDrawn.Least);
  program->SetUniform3fv("in_texMax", 1, &ofDrawn.Greatest);
}
