// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a volume's property says about the integral in data space: the table of its transfer
// functions, its isosurfaces and its silhouettes, for scalars of one range. A plain
// vtkVolumeProperty has neither isosurfaces nor silhouettes.

#ifndef DataSpaceClassification_h
#define DataSpaceClassification_h

#include "vtkNew.h"
#include "vtkType.h"

#include <glm/glm.hpp>

#include <vector>

class vtkPreIntegratedTable;
class vtkVolumeProperty;

class DataSpaceClassification
{
public:
  struct Isosurface
  {
    double Value; // in units of the range, ascending
    glm::dvec4 Color;
  };

  DataSpaceClassification();
  ~DataSpaceClassification();

  // Returns whether anything changed. range: of the scalars, not empty.
  bool Update(vtkVolumeProperty* property, const double range[2], int tableSize);

  // False where the transfer functions are of no use; the table has said why.
  bool IsValid() const;

  vtkPreIntegratedTable* GetTable() const { return this->Table; }
  const std::vector<Isosurface>& GetIsosurfaces() const { return this->Isosurfaces; }
  int GetSilhouette() const { return this->Silhouette; }
  bool HasSilhouettes() const;
  double Normalize(double scalar) const;
  double Denormalize(double scalar) const;

  // Associated colour and opacity of a segment on which the scalar is linear. Scalars in units of the
  // range; gradientStep: |grad s| times the segment's length, in the same unit. For any thread.
  glm::dvec4 GetSegmentColor(double front, double back, double gradientStep) const;

private:
  void UpdateTable(vtkVolumeProperty* property);
  void UpdateIsosurfaces(vtkVolumeProperty* property);

  vtkNew<vtkPreIntegratedTable> Table;
  std::vector<Isosurface> Isosurfaces;
  int Silhouette = 0;
  double Range[2] = { 0.0, 1.0 };
  int TableSize = 0;
  vtkVolumeProperty* Property = nullptr;
  vtkMTimeType PropertyTime = 0;
};

#endif
