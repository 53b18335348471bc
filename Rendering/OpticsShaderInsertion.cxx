// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpticsShaderPlaces.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// Where VTK hands a sample to computeLighting(), the sample's scalar is handed on with it.
struct Statement
{
  const char* Text;
  const char* Replacement;
};
const Statement LightingCalls[] = {
  { "return clamp(computeLighting(", "g_opticsScalar = scalar;\n  return opticsUnclamped(computeLighting(" },
  { "return computeLighting(", "g_opticsScalar = scalar;\n  return computeLighting(" },
  { "g_srcColor = computeLighting(", "g_opticsScalar = scalar;\n      g_srcColor = computeLighting(" },
};

// Where VTK classifies a sample by its scalar alone; after the calls above.
const Statement ClassificationCalls[] = {
  { "g_srcColor.a = computeOpacity(scalar);",
    "g_srcColor.a = opticsClassifiedOpacity(scalar, computeOpacity(scalar));" },
  { "float opacity = computeOpacity(scalar);",
    "float opacity = opticsClassifiedOpacity(scalar, computeOpacity(scalar));" },
  { "return clamp(computeLighting(", "return clamp(opticsLightClassified(" },
  { "return opticsUnclamped(computeLighting(", "return opticsUnclamped(opticsLightClassified(" },
};

// VTK's headlight takes the power of a negative cosine where lighting has one side, which is no number.
const Statement Highlights[] = {
  { "pow(nDotH, in_shininess[component])", "pow(max(nDotH, 0.0), in_shininess[component])" },
};

template <std::size_t Count>
bool ReplaceAny(std::string& fragment, const Statement (&statements)[Count])
{
  bool found = false;
  for (const Statement& statement : statements)
  {
    found |= vtkShaderProgram::Substitute(fragment, statement.Text, statement.Replacement, true);
  }
  return found;
}

// GLSL arrays are sized by constants, and have at least one element.
std::string NumbersText(const OpticsFeatures& features)
{
  const int slots = std::max(features.NumberOfLights, 1);
  const std::string text = "#define OPTICS_NUMBER_OF_LIGHTS " + std::to_string(features.NumberOfLights) +
    "\n#define OPTICS_LIGHT_SLOTS " + std::to_string(slots) + "\n";
  return features.NumberOfShadowViews == 0
    ? text
    : text + "#define OPTICS_SHADOW_VIEWS " + std::to_string(features.NumberOfShadowViews) + "\n";
}

// Our own places are in our text; those that no term fills leave nothing behind.
void FillOwnPlaces(std::string& fragment, const OpticsFeatures& features)
{
  for (const Place* place :
    { &GradientPlace, &SurfacePlace, &LightPlace, &TransmissionPlace, &EndPlace, &LinesPlace })
  {
    vtkShaderProgram::Substitute(fragment, place->Tag, OpticsText(*place, features), false);
  }
}

bool Insert(std::string& fragment, const Place& place, const std::string& text)
{
  if (text.empty())
  {
    return true;
  }
  const std::string kept = place.KeepsVTKText ? std::string(place.Tag) + "\n" : std::string();
  return vtkShaderProgram::Substitute(
    fragment, place.Tag, place.IsBeforeVTK ? text + kept : kept + text, false);
}

// Our own lighting stands in the place of VTK's; without it what is needed there is added.
bool InsertLighting(std::string& fragment, const OpticsFeatures& features)
{
  Place place = ComputeLightingDec;
  std::string text = OpticsText(ComputeLightingDec, features);
  const bool replaces = features.Has(OpticsFeature::Reflectance) || features.Has(OpticsFeature::AmbientAlone);
  place.KeepsVTKText = !replaces;
  if (features.Has(OpticsFeature::OcclusionGathered))
  {
    text.insert(0, "#define OPTICS_GATHER_SAMPLES " + std::to_string(features.NumberOfGatherSamples) + "\n");
  }
  if (replaces || features.Has(OpticsFeature::Shadows))
  {
    text.insert(0, NumbersText(features));
  }
  return Insert(fragment, place, text);
}
}

//------------------------------------------------------------------------------
std::string InsertOpticsBeforeVTK(std::string& fragment, const OpticsFeatures& features)
{
  std::string text = fragment;
  if (!InsertLighting(text, features))
  {
    return ComputeLightingDec.Tag;
  }
  for (const Place* place : { &BaseDec, &BaseInit, &TerminateInit, &ComputeRayDirectionDec, &ClippingImpl,
         &ShadingInit, &BaseImpl, &ShadingImpl, &DepthPassImpl, &TerminateImpl, &AfterTerminateImpl })
  {
    if (!Insert(text, *place, OpticsText(*place, features)))
    {
      return place->Tag;
    }
  }
  FillOwnPlaces(text, features);
  fragment = text;
  return std::string();
}

//------------------------------------------------------------------------------
std::string ReplaceOpticsInVTK(std::string& fragment, const OpticsFeatures& features)
{
  if (features.Has(OpticsFeature::Reflectance) && !ReplaceAny(fragment, LightingCalls))
  {
    return LightingCalls[1].Text;
  }
  if (features.Has(OpticsFeature::MultiSample) && !ReplaceAny(fragment, ClassificationCalls))
  {
    return ClassificationCalls[0].Text;
  }
  if (features.Has(OpticsFeature::Integral) || features.Has(OpticsFeature::MultiSample))
  {
    ReplaceAny(fragment, Highlights); // of VTK's computeLighting(), where it is there
  }
  return std::string();
}
