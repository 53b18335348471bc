// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Tetrahedral grids and a window that draws one in data space, white on black, so that a pixel is its
// opacity. Parallel projection along z unless told otherwise.

#ifndef TetrahedraScene_h
#define TetrahedraScene_h

#include "Check.h"
#include "FloatTarget.h"
#include "WindowPixels.h"
#include "vtkDataSpaceProjectedTetrahedraMapper.h"
#include "vtkDataSpaceRayCastFunction.h"
#include "vtkDataSpaceRayIntegrator.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"
#include "vtkVolume.h"

#include <functional>
#include <string>
#include <vector>

namespace
{
using Function = std::function<double(double x, double y, double z)>;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

inline void SetScalars(vtkUnstructuredGrid* grid, const Function& field, double scale = 1.0)
{
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("field");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* p = grid->GetPoint(i);
    scalars->InsertNextValue(static_cast<float>(field(p[0] / scale, p[1] / scale, p[2] / scale)));
  }
  grid->GetPointData()->SetScalars(scalars);
}

// [-1, 1]^3 times scale in cells^3 cubes of five tetrahedra each; the field of the unscaled point.
inline Grid MakeBox(int cells, const Function& field, double scale = 1.0)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetOrigin(-scale, -scale, -scale);
  image->SetSpacing(2.0 * scale / cells, 2.0 * scale / cells, 2.0 * scale / cells);
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(image);
  cut->Update();
  Grid grid = cut->GetOutput();
  SetScalars(grid, field, scale);
  return grid;
}

// A single cell.
inline Grid MakeCell(const double (&points)[4][3], const Function& field)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  for (const double* point : points)
  {
    corners->InsertNextPoint(point);
  }
  grid->SetPoints(corners);
  const vtkIdType ids[4] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, ids);
  SetScalars(grid, field);
  return grid;
}

struct TetrahedraScene
{
  enum Kind
  {
    Projected,
    RayCast
  };

  // VTK's ray caster loses rays that run along an edge of the grid.
  static constexpr double OffTheEdges[2] = { 0.00137, 0.00219 };

  explicit TetrahedraScene(Kind kind, vtkUnstructuredGrid* grid, int size = 64)
  {
    this->Ray->SetRayIntegrator(this->Integrator);
    this->Ray->SetRayCastFunction(this->RayFunction);
    this->Ray->SetAutoAdjustSampleDistances(0);
    this->Mapper = this->Ray;
    if (kind == Projected)
    {
      this->Mapper = this->Tetrahedra;
    }
    this->Mapper->SetInputData(grid);
    this->Color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    this->Opacity->AddPoint(0.0, 0.0);
    this->Property->SetColor(this->Color);
    this->Property->SetScalarOpacity(this->Opacity);
    this->Volume->SetMapper(this->Mapper);
    this->Volume->SetProperty(this->Property);
    this->Renderer->AddVolume(this->Volume);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(size, size);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->See(1.0);
  }

  // [-1, 1]^2 times scale fills the window
  void See(double scale)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 5.0 * scale);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetParallelScale(scale);
    if (this->Mapper == this->Ray)
    {
      this->Volume->SetPosition(OffTheEdges[0] * scale, OffTheEdges[1] * scale, 0.0);
    }
    this->Renderer->ResetCameraClippingRange();
  }

  // The same opacity everywhere, that of crossing 1 of data.
  void SetConstantOpacity(double opacity)
  {
    this->Opacity->RemoveAllPoints();
    this->Opacity->AddPoint(0.0, opacity);
    this->Opacity->AddPoint(1.0, opacity);
    this->Property->SetScalarOpacityUnitInterval(1.0);
  }

  std::vector<unsigned char> Render() { return RenderPixels(this->Window); }

  // The opacity of a pixel, given from its lower left.
  double RenderOpacity(int x, int y)
  {
    return this->Render()[3 * (y * this->Window->GetSize()[0] + x)] / 255.0;
  }

  vtkNew<vtkDataSpaceProjectedTetrahedraMapper> Tetrahedra;
  vtkNew<vtkUnstructuredGridVolumeRayCastMapper> Ray;
  vtkNew<vtkDataSpaceRayIntegrator> Integrator;
  vtkNew<vtkDataSpaceRayCastFunction> RayFunction;
  vtkUnstructuredGridVolumeMapper* Mapper = nullptr;
  vtkNew<vtkOpticsVolumeProperty> Property;
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window = vtkSmartPointer<vtkRenderWindow>::New();
};
}

#endif
