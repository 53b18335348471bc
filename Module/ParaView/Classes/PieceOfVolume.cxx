// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceOfVolume.h"

#include "vtkOpticsVolumeMapper.h"

#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"
#include "vtkVolume.h"

#include <algorithm>

namespace
{
// The whole volume's box in units of the piece's, and the ray's steps from its entry there, or from the eye if
// that is inside, to the entry into the piece. 1e-4: rounding, so that no first sample is lost.
const char* const AlignedSamples = R"***(//VTK::Base::Init
  vec3 opticsPieceSize = in_texMax[0] - in_texMin[0];
  vec3 opticsFaces = in_texMin[0] + opticsPieceSize * mix(in_opticsWholeMin, in_opticsWholeMax,
    vec3(lessThan(g_dirStep, vec3(0.0))));
  vec3 opticsStep = mix(g_dirStep, vec3(1e-20), lessThan(abs(g_dirStep), vec3(1e-20)));
  vec3 opticsToFaces = mix((opticsFaces - ip_textureCoords) / opticsStep, vec3(-1e20),
    lessThan(abs(g_dirStep), vec3(1e-20)));
  vec4 opticsEye = ip_inverseTextureDataAdjusted * g_eyePosObj;
  float opticsToEye = dot(opticsEye.xyz / opticsEye.w - ip_textureCoords, g_dirStep) / dot(g_dirStep, g_dirStep);
  float opticsToEntry = max(max(opticsToFaces.x, opticsToFaces.y), max(opticsToFaces.z, opticsToEye));
  float opticsFirst = opticsToEntry + jitterValue;
  opticsFirst += max(ceil(-opticsFirst - 1e-4), 0.0);
  g_rayJitter = g_dirStep * opticsFirst;
  g_rayOrigin = ip_textureCoords + g_rayJitter;
)***";

const char* const LimitedLight =
  "//VTK::Base::Exit\n  g_fragColor.rgb = min(g_fragColor.rgb, vec3(g_fragColor.a));\n";

bool IsEmpty(const int extent[6])
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

// As vtkVolumeMapper::SpacingAdjustedSampleDistance(), which is protected.
struct VTKSampleDistance : vtkOpticsVolumeMapper
{
  static double Find(vtkOpticsVolumeMapper* mapper, double spacing[3], int extent[6])
  {
    return (mapper->*(&VTKSampleDistance::SpacingAdjustedSampleDistance))(spacing, extent);
  }
};
}

//------------------------------------------------------------------------------
bool DrawsPieces()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
void LimitLightToOpacity(vtkVolume* volume)
{
  volume->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Base::Exit", true, LimitedLight, false);
}

//------------------------------------------------------------------------------
void TakeSampleDistanceOf(const int wholeExtent[6], vtkImageData* piece, vtkOpticsVolumeMapper* mapper)
{
  if (IsEmpty(wholeExtent) || !mapper->GetLockSampleDistanceToInputSpacing())
  {
    return;
  }
  double spacing[3];
  piece->GetSpacing(spacing);
  int extent[6];
  std::copy(wholeExtent, wholeExtent + 6, extent);
  mapper->LockSampleDistanceToInputSpacingOff();
  mapper->SetSampleDistance(static_cast<float>(VTKSampleDistance::Find(mapper, spacing, extent)));
}

//------------------------------------------------------------------------------
void AlignSamples(const int wholeExtent[6], vtkImageData* piece, vtkVolume* volume)
{
  float least[3] = { 0.0f, 0.0f, 0.0f };
  float greatest[3] = { 1.0f, 1.0f, 1.0f };
  for (int axis = 0; piece && !IsEmpty(wholeExtent) && axis < 3; ++axis)
  {
    const int* extent = piece->GetExtent() + 2 * axis;
    const auto size = static_cast<float>(extent[1] - extent[0]);
    if (size > 0.0f)
    {
      least[axis] = static_cast<float>(wholeExtent[2 * axis] - extent[0]) / size;
      greatest[axis] = static_cast<float>(wholeExtent[2 * axis + 1] - extent[0]) / size;
    }
  }
  vtkShaderProperty* shader = volume->GetShaderProperty();
  shader->AddFragmentShaderReplacement("//VTK::Base::Init", true, AlignedSamples, false);
  shader->GetFragmentCustomUniforms()->SetUniform3f("in_opticsWholeMin", least);
  shader->GetFragmentCustomUniforms()->SetUniform3f("in_opticsWholeMax", greatest);
}
