// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Data at random: images of points or cells, with one or several components, holes and hidden points; rectilinear grids;
// voxels of lines; and masks of them.

#ifndef RandomData_h
#define RandomData_h

#include "Dice.h"
#include "LineTesting.h"
#include "TestScene.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnsignedCharArray.h"

namespace
{
class RandomData
{
public:
  RandomData(Dice& dice, TestScene& scene)
    : Random(dice)
    , Scene(scene)
    , Scale(dice.PowerOfTen(-6.0, 6.0))
  {
    if (dice.Is(0.06))
    {
      this->Components = 1;
      scene.Mapper->SetInputData(this->MakeLines());
      return;
    }
    this->MakeImage();
    if (dice.Is(0.04))
    {
      this->UseRectilinearGrid();
    }
    else
    {
      scene.Mapper->SetInputData(this->Image);
    }
    if (dice.Is(0.15))
    {
      this->UseMask();
    }
  }

  double GetScale() const { return this->Scale; } // of lengths
  double GetWidth() const { return this->Width; } // of scalars
  int GetNumberOfComponents() const { return this->Components; }
  const int* GetDimensions() const { return this->Size; } // of points

  // In the range of the data, or near it.
  double Scalar() { return this->Low + this->Width * this->Random.Between(-0.2, 1.2); }

  // Voxels of a few lines.
  vtkSmartPointer<vtkImageData> MakeLines()
  {
    vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
    voxelizer->SetInputData(
      lines::MakeLines(lines::RandomLines(this->Random.Number(30), 1 + this->Random.Number(1000))));
    voxelizer->SetSampleDimensions(
      1 + this->Random.Number(9), 1 + this->Random.Number(9), 1 + this->Random.Number(9));
    voxelizer->SetModelBounds(0.0, 1.0, this->Random.Between(-1.0, 0.0), 1.0, 0.0, 1.0);
    voxelizer->SetRadius(this->Random.PowerOfTen(-3.0, -0.7));
    voxelizer->SetMaximumOrder(this->Random.Number(5));
    voxelizer->SetExactProduct(this->Random.Is(0.3));
    voxelizer->Update();
    auto voxels = vtkSmartPointer<vtkImageData>::New();
    voxels->DeepCopy(voxelizer->GetOutput());
    this->Scale = 1.0;
    return voxels;
  }

private:
  // Mostly few points, as no scene is to take long.
  void ChooseSize()
  {
    for (int& points : this->Size)
    {
      points = 1 + this->Random.Number(this->Random.Is(0.1) ? 3 : 12);
    }
    if (this->Random.Is(0.2))
    {
      this->Size[this->Random.Number(3)] = 1 + this->Random.Number(65);
    }
  }

  void MakeImage()
  {
    this->ChooseSize();
    this->Image->SetDimensions(this->Size);
    this->Image->SetSpacing(this->Length(), this->Length(), this->Length());
    this->Image->SetOrigin(
      this->Scale * this->Random.Between(-9.0, 9.0), 0.0, this->Scale * this->Random.Between(-9.0, 9.0));
    if (this->Random.Is(0.2))
    {
      const double turned[9] = { 0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0 };
      const double mirrored[9] = { 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0 };
      this->Image->SetDirectionMatrix(this->Random.Is(0.7) ? turned : mirrored);
    }
    this->Components = this->Random.Is(0.75) ? 1 : 1 + this->Random.Number(4);
    this->Scene.Property->SetIndependentComponents(
      this->Components % 2 == 1 || this->Random.Is(0.2)); // as VTK demands
    const bool hasCells =
      this->Random.Is(0.15) && this->Size[0] > 1 && this->Size[1] > 1 && this->Size[2] > 1;
    this->AddScalars(hasCells);
    if (this->Random.Is(0.1))
    {
      this->Hide(hasCells);
    }
  }

  double Length() { return this->Scale * this->Random.PowerOfTen(-1.0, 1.0); }

  void AddScalars(bool areOfCells)
  {
    const int types[] = { VTK_FLOAT, VTK_DOUBLE, VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR, VTK_CHAR, VTK_SHORT,
      VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG };
    const int type = this->Random.Of(types);
    const auto scalars = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    scalars->SetNumberOfComponents(this->Components);
    scalars->SetNumberOfTuples(
      areOfCells ? this->Image->GetNumberOfCells() : this->Image->GetNumberOfPoints());
    this->ChooseRange(type == VTK_FLOAT || type == VTK_DOUBLE);
    this->Fill(scalars);
    scalars->SetName("scalars");
    vtkDataSetAttributes* attributes = areOfCells
      ? static_cast<vtkDataSetAttributes*>(this->Image->GetCellData())
      : this->Image->GetPointData();
    const bool areNamed = this->Random.Is(0.1); // instead of being the active ones
    areNamed ? attributes->AddArray(scalars) : attributes->SetScalars(scalars);
    if (areNamed)
    {
      areOfCells ? this->Scene.Mapper->SetScalarModeToUseCellFieldData()
                 : this->Scene.Mapper->SetScalarModeToUsePointFieldData();
      this->Scene.Mapper->SelectScalarArray("scalars");
    }
  }

  void ChooseRange(bool isReal)
  {
    this->IsReal = isReal;
    this->Width = isReal ? this->Random.PowerOfTen(-30.0, 30.0) : 100.0;
    this->Low = isReal && this->Random.Is(0.3) ? this->Width * this->Random.Between(-3.0, 3.0) : 0.0;
  }

  void Fill(vtkDataArray* scalars)
  {
    const bool isConstant = this->Random.Is(0.05);
    const bool hasHoles = this->IsReal && this->Random.Is(0.2);
    for (vtkIdType i = 0; i < scalars->GetNumberOfValues(); ++i)
    {
      double value = this->Low + this->Width * (isConstant ? 0.5 : this->Random.Between(0.0, 1.0));
      if (hasHoles && this->Random.Is(0.1))
      {
        value = this->Random.Is(0.5) ? std::numeric_limits<double>::quiet_NaN()
                                     : std::numeric_limits<double>::infinity();
      }
      scalars->SetComponent(i / this->Components, static_cast<int>(i % this->Components), value);
    }
  }

  void Hide(bool cells)
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(cells ? this->Image->GetNumberOfCells() : this->Image->GetNumberOfPoints());
    const unsigned char hidden = cells ? static_cast<unsigned char>(vtkDataSetAttributes::HIDDENCELL)
                                       : static_cast<unsigned char>(vtkDataSetAttributes::HIDDENPOINT);
    const double share = this->Random.Between(0.0, 1.0);
    for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
    {
      ghosts->SetValue(i, this->Random.Is(share) ? hidden : 0);
    }
    cells ? this->Image->GetCellData()->AddArray(ghosts) : this->Image->GetPointData()->AddArray(ghosts);
  }

  // The image's points, moved along the axes.
  void UseRectilinearGrid()
  {
    vtkNew<vtkRectilinearGrid> grid;
    grid->SetDimensions(this->Size);
    const auto coordinates = [&](int axis) {
      vtkNew<vtkDoubleArray> values;
      double place = this->Image->GetOrigin()[axis];
      for (int i = 0; i < this->Size[axis]; ++i, place += this->Length())
      {
        values->InsertNextValue(place);
      }
      return vtkSmartPointer<vtkDataArray>(values);
    };
    grid->SetXCoordinates(coordinates(0));
    grid->SetYCoordinates(coordinates(1));
    grid->SetZCoordinates(coordinates(2));
    grid->GetPointData()->ShallowCopy(this->Image->GetPointData());
    grid->GetCellData()->ShallowCopy(this->Image->GetCellData());
    this->Scene.Mapper->SetInputData(grid);
  }

  // Of cells where the image has them.
  void UseMask()
  {
    const bool isBinary = this->Random.Is(0.5);
    vtkNew<vtkImageData> mask;
    mask->CopyStructure(this->Image);
    const bool hasCells = this->Image->GetPointData()->GetNumberOfArrays() == 0;
    vtkNew<vtkUnsignedCharArray> values;
    values->SetName("scalars"); // VTK takes the mask's array as it takes the volume's
    values->SetNumberOfTuples(hasCells ? this->Image->GetNumberOfCells() : this->Image->GetNumberOfPoints());
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      values->SetValue(
        i, static_cast<unsigned char>(isBinary ? 255 * this->Random.Number(2) : this->Random.Number(4)));
    }
    hasCells ? mask->GetCellData()->SetScalars(values) : mask->GetPointData()->SetScalars(values);
    isBinary ? this->Scene.Mapper->SetMaskTypeToBinary() : this->Scene.Mapper->SetMaskTypeToLabelMap();
    this->Scene.Mapper->SetMaskInput(mask);
    this->Scene.Mapper->SetMaskBlendFactor(static_cast<float>(this->Random.Between(0.0, 1.0)));
  }

  Dice& Random;
  TestScene& Scene;
  vtkNew<vtkImageData> Image;
  int Size[3] = { 1, 1, 1 };
  int Components = 1;
  bool IsReal = true;
  double Scale;
  double Low = 0.0;
  double Width = 1.0;
};
}

#endif
