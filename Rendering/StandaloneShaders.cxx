// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StandaloneShaders.h"

#include "CylinderLighting.h"
#include "DataSpace.h"
#include "DataSpaceInterior.h"
#include "DataSpaceSegment.h"
#include "LineEvaluationFragment.h"
#include "LineEvaluationVertex.h"
#include "LinePlacementFragment.h"
#include "LineVoxel.h"
#include "Opacity.h"
#include "ProjectedTetrahedraDec.h"
#include "ProjectedTetrahedraInterior.h"
#include "ProjectedTetrahedraIsosurfaces.h"
#include "ProjectedTetrahedraMain.h"
#include "ProjectedTetrahedraSegment.h"
#include "ProjectedTetrahedraVertex.h"
#include "SphericalHarmonics.h"

//------------------------------------------------------------------------------
std::string LineEvaluationVertexShader()
{
  return LineEvaluationVertex;
}

//------------------------------------------------------------------------------
std::string LineEvaluationFragmentShader(int order, int types, bool inBytes)
{
  const std::string constants = "#define OPTICS_LINE_ORDER " + std::to_string(order) +
    "\n#define OPTICS_LINE_TYPES " + std::to_string(types) + (inBytes ? "\n#define OPTICS_LINE_BYTES" : "") +
    "\n";
  return "//VTK::System::Dec\n//VTK::Output::Dec\n" + constants + Opacity + SphericalHarmonics +
    CylinderLighting + LineVoxel + LineEvaluationFragment;
}

//------------------------------------------------------------------------------
std::string LinePlacementFragmentShader()
{
  return LinePlacementFragment;
}

//------------------------------------------------------------------------------
std::string ProjectedTetrahedraVertexShader()
{
  return ProjectedTetrahedraVertex;
}

//------------------------------------------------------------------------------
std::string ProjectedTetrahedraFragmentShader(const std::string& color)
{
  return std::string(ProjectedTetrahedraDec) + Opacity + DataSpace + color + ProjectedTetrahedraMain;
}

//------------------------------------------------------------------------------
std::string ProjectedTetrahedraFragmentShader(int silhouette, bool hasIsosurfaces)
{
  // a constant, so that what the mode does not need is not compiled
  const std::string interior =
    "int SilhouetteMode() { return " + std::to_string(silhouette) + "; }\n" + DataSpaceInterior;
  return ProjectedTetrahedraFragmentShader(hasIsosurfaces
      ? interior + ProjectedTetrahedraIsosurfaces + DataSpaceSegment + ProjectedTetrahedraSegment
      : interior + ProjectedTetrahedraInterior);
}
