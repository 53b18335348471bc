// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDataSpaceProjectedTetrahedraMapper.h"

#include "DataSpaceClassification.h"
#include "ParameterRange.h"
#include "ProjectedTetrahedraPainter.h"
#include "TetrahedraVertices.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGridBase.h"
#include "vtkVisibilitySort.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

vtkStandardNewMacro(vtkDataSpaceProjectedTetrahedraMapper);

namespace
{
// The width of a texture that every OpenGL 3.2 has.
const std::size_t LargestNumberOfIsosurfaces = 1024;
}

//------------------------------------------------------------------------------
vtkDataSpaceProjectedTetrahedraMapper::vtkDataSpaceProjectedTetrahedraMapper()
  : Classification(std::make_unique<DataSpaceClassification>())
  , Vertices(std::make_unique<TetrahedraVertices>())
  , Painter(std::make_unique<ProjectedTetrahedraPainter>())
{
}

//------------------------------------------------------------------------------
vtkDataSpaceProjectedTetrahedraMapper::~vtkDataSpaceProjectedTetrahedraMapper() = default;

//------------------------------------------------------------------------------
void vtkDataSpaceProjectedTetrahedraMapper::SetTableSize(int size)
{
  volumeoptics::SetWithinRange(this, "TableSize", size, 2, 4096, this->TableSize);
}

//------------------------------------------------------------------------------
bool vtkDataSpaceProjectedTetrahedraMapper::IsSupported(vtkRenderWindow* window)
{
  return vtkOpenGLRenderWindow::SafeDownCast(window) != nullptr;
}

//------------------------------------------------------------------------------
void vtkDataSpaceProjectedTetrahedraMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (!this->IsUsable(renderer) || !this->Prepare(volume))
  {
    return;
  }
  this->Timer->StartTimer();
  if (this->Sort(renderer, volume))
  {
    this->Painter->Draw(renderer, volume, this->Order,
      [this](vtkShaderProgram* program) { this->InvokeEvent(vtkCommand::UpdateShaderEvent, program); });
  }
  this->Timer->StopTimer();
  this->TimeToDraw = this->Timer->GetElapsedTime();
}

//------------------------------------------------------------------------------
bool vtkDataSpaceProjectedTetrahedraMapper::IsUsable(vtkRenderer* renderer)
{
  if (!this->IsSupported(renderer->GetRenderWindow()))
  {
    this->FailOnce("The window is none of OpenGL; use a vtkOpenGLRenderWindow.");
    return false;
  }
  vtkUnstructuredGridBase* input = this->GetInput();
  return !renderer->GetSelector() && input && input->GetNumberOfCells() > 0;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkDataSpaceProjectedTetrahedraMapper::FindScalars(vtkVolume* volume)
{
  bool areOfCells = false;
  vtkDataArray* scalars = TetrahedralGrid::FindScalars(this, areOfCells);
  if (!scalars)
  {
    this->FailOnce("The input has no scalars to draw; name an array with SelectScalarArray(), or make one "
                   "the active scalars of the points.");
    return nullptr;
  }
  if (areOfCells)
  {
    this->WarnOnce("Scalars of the cells are constant in each cell, and so are not seen in data space; use "
                   "vtkCellDataToPointData.");
    return nullptr;
  }
  if (scalars->GetNumberOfComponents() > 1 || !volume->GetProperty()->GetIndependentComponents())
  {
    this->WarnOnce(
      "The scalars have several components, or dependent ones; the first is drawn, as independent.");
  }
  return scalars;
}

//------------------------------------------------------------------------------
bool vtkDataSpaceProjectedTetrahedraMapper::Prepare(vtkVolume* volume)
{
  vtkDataArray* scalars = this->FindScalars(volume);
  double range[2] = { 0.0, 0.0 };
  if (scalars)
  {
    scalars->GetFiniteRange(range, 0);
  }
  if (!(range[0] < range[1]) || !this->UpdateVertices(scalars, range))
  {
    return false;
  }
  if (this->Classification->Update(volume->GetProperty(), range, this->TableSize))
  {
    this->Painter->SetClassification(this->Classification.get());
  }
  const std::size_t surfaces = this->Classification->GetIsosurfaces().size();
  if (surfaces > LargestNumberOfIsosurfaces)
  {
    this->FailOnce(std::to_string(surfaces) + " isosurfaces are more than the " +
      std::to_string(LargestNumberOfIsosurfaces) +
      " that can be drawn; remove some by RemoveIsosurface(). Nothing is drawn.");
    return false;
  }
  return this->Classification->IsValid();
}

//------------------------------------------------------------------------------
bool vtkDataSpaceProjectedTetrahedraMapper::UpdateVertices(vtkDataArray* scalars, const double range[2])
{
  vtkUnstructuredGridBase* input = this->GetInput();
  const bool isCurrent = this->DrawnScalars == scalars && this->VerticesTime > input->GetMTime() &&
    this->VerticesTime > scalars->GetMTime() && this->VerticesTime > this->GetMTime();
  if (!isCurrent)
  {
    if (this->Vertices->Build(input, scalars, range))
    {
      this->FailOnce("The input has cells that are no tetrahedra (VTK_TETRA); vtkDataSetTriangleFilter cuts "
                     "other cells into tetrahedra. Nothing is drawn.");
    }
    this->DrawnScalars = scalars;
    this->VerticesTime.Modified();
    this->Painter->SetVertices(this->Vertices.get());
  }
  return !this->Vertices->IsEmpty();
}

//------------------------------------------------------------------------------
bool vtkDataSpaceProjectedTetrahedraMapper::Sort(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkVisibilitySort* sort = this->VisibilitySort;
  sort->SetInput(this->GetInput());
  sort->SetDirectionToBackToFront();
  sort->SetModelTransform(volume->GetMatrix());
  sort->SetCamera(renderer->GetActiveCamera());
  sort->SetMaxCellsReturned(1000);
  sort->InitTraversal();
  this->Order.clear();
  this->Order.reserve(3 * this->Vertices->GetNumberOfVertices());
  while (vtkIdTypeArray* cells = sort->GetNextCells())
  {
    this->Vertices->AddFaces(cells, this->Order);
    if (renderer->GetRenderWindow()->CheckAbortStatus())
    {
      return false;
    }
  }
  return !this->Order.empty();
}

//------------------------------------------------------------------------------
void vtkDataSpaceProjectedTetrahedraMapper::WarnOnce(const std::string& text)
{
  if (this->Warned != text)
  {
    vtkWarningMacro(<< text);
    this->Warned = text;
  }
}

//------------------------------------------------------------------------------
void vtkDataSpaceProjectedTetrahedraMapper::FailOnce(const std::string& text)
{
  if (this->Failed != text)
  {
    vtkErrorMacro(<< text);
    this->Failed = text;
  }
}

//------------------------------------------------------------------------------
void vtkDataSpaceProjectedTetrahedraMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Painter->Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkDataSpaceProjectedTetrahedraMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TableSize: " << this->TableSize << "\n";
}
