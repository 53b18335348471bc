// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Skips what cannot be seen: a ray advances, by the very steps that it takes otherwise, to the next sample that may
// have an opacity. The picture does not change. Active where enough of the volume is empty.

#ifndef EmptySpaceTerm_h
#define EmptySpaceTerm_h

#include "OpticsTerm.h"
#include "TermTexture.h"
#include "VisibleScalars.h"

#include "vtkMacrocellGrid.h"
#include "vtkNew.h"

#include <tuple>
#include <vector>

class EmptySpaceTerm : public OpticsTerm
{
public:
  const char* GetName() const override { return "EmptySpace"; }
  bool IsActive(const OpticsScene& scene) override;
  bool Prepare(const OpticsScene& scene) override;
  void AddFeatures(const OpticsScene& scene, OpticsFeatures& features) override;
  void SetUniforms(const OpticsScene& scene, vtkShaderProgram* program) override;
  void UnbindTextures() override { this->Texture.Unbind(); }
  void ReleaseGraphicsResources(vtkWindow* window) override { this->Texture.Release(window); }
  std::size_t GetMemorySize() const override;

  // Least and largest texture coordinates, on each axis, of what can be seen. False: of this frame that is not known.
  bool FindVisibleBox(double box[6]) const;

private:
  void Classify(const OpticsScene& scene);
  bool IsWorthwhile(const OpticsScene& scene);
  void UpdateTexture(const OpticsScene& scene);
  void Upload(const OpticsScene& scene, const int size[3], std::vector<unsigned char> distances);

  vtkNew<vtkMacrocellGrid> Grid;
  VisibleScalars Visible;
  VisibleScalars VisibleWhereConstant;
  bool IsKnown = false;        // what is visible in this frame
  vtkMTimeType RangesTime = 0; // of the grid that was classified
  using EstimateOf =
    std::tuple<vtkMTimeType, bool, double>; // classification, gradients, voxels per unit distance
  EstimateOf LastEstimateOf;
  double LastEstimate = 1.0;
  TermTexture Texture;
  vtkMTimeType UploadedTime = 0;
};

#endif
