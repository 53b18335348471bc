// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpticsMultiBlockVolumeMapper.h"

#include "BlockOrder.h"
#include "PieceOfVolume.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkOpticsMultiBlockVolumeMapper);

namespace
{
// As vtkSmartVolumeMapper: frames at this rate and above are those of an interaction.
const double InteractiveUpdateRate = 1.0;

const char* const MagnitudeName = "Magnitude";

// Of the vectors' own type, as vtkImageMagnitude.
vtkSmartPointer<vtkDataArray> MakeMagnitude(vtkDataArray* vectors)
{
  auto magnitude = vtk::TakeSmartPointer(vectors->NewInstance());
  magnitude->SetName(MagnitudeName);
  magnitude->SetNumberOfTuples(vectors->GetNumberOfTuples());
  std::vector<double> vector(vectors->GetNumberOfComponents());
  for (vtkIdType tuple = 0; tuple < vectors->GetNumberOfTuples(); ++tuple)
  {
    vectors->GetTuple(tuple, vector.data());
    double square = 0.0;
    for (const double component : vector)
    {
      square += component * component;
    }
    magnitude->SetTuple1(tuple, std::sqrt(square));
  }
  return magnitude;
}

// The eye in the volume's own coordinates, homogeneous.
void FindEye(vtkRenderer* renderer, vtkVolume* volume, double eye[4])
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->GetPosition(eye);
  eye[3] = 1.0;
  if (camera->GetParallelProjection())
  {
    double focus[3];
    camera->GetFocalPoint(focus);
    for (int axis = 0; axis < 3; ++axis)
    {
      eye[axis] -= focus[axis];
    }
    eye[3] = 0.0;
  }
  vtkNew<vtkMatrix4x4> toVolume;
  volume->GetModelToWorldMatrix(toVolume);
  toVolume->Invert();
  toVolume->MultiplyPoint(eye, eye);
}
}

//------------------------------------------------------------------------------
vtkOpticsMultiBlockVolumeMapper::vtkOpticsMultiBlockVolumeMapper() = default;

//------------------------------------------------------------------------------
vtkOpticsMultiBlockVolumeMapper::~vtkOpticsMultiBlockVolumeMapper() = default;

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::SetKnob(const std::string& name, const Knob& knob)
{
  this->Knobs[name] = knob;
  for (const Mapper& block : this->Blocks)
  {
    knob(block);
  }
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::SetPresetKnob(const std::string& name, const Knob& knob)
{
  this->PresetKnobs[name] = knob;
  if (this->Quality == vtkOpticsVolumeMapper::Custom)
  {
    for (const Mapper& block : this->Blocks)
    {
      knob(block);
    }
  }
}

//------------------------------------------------------------------------------
// Leaving a preset does not undo it: the blocks' mappers are made anew.
void vtkOpticsMultiBlockVolumeMapper::SetQuality(int quality)
{
  if (this->Quality != quality)
  {
    this->Quality = quality;
    this->Loaded.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::SetTransfer2DYAxisArray(const char* name)
{
  this->Transfer2DYAxisName = name ? name : "";
  this->Superclass::SetTransfer2DYAxisArray(name);
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::SetWholeExtent(const int extent[6])
{
  if (!std::equal(extent, extent + 6, this->WholeExtent))
  {
    std::copy(extent, extent + 6, this->WholeExtent);
    this->Loaded.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::SetKnobs(vtkOpticsVolumeMapper* block)
{
  for (const auto& knob : this->Knobs)
  {
    knob.second(block);
  }
  if (this->Quality != vtkOpticsVolumeMapper::Custom)
  {
    block->SetQuality(this->Quality);
    return;
  }
  for (const auto& knob : this->PresetKnobs)
  {
    knob.second(block);
  }
}

//------------------------------------------------------------------------------
int vtkOpticsMultiBlockVolumeMapper::GetGhostLayers(vtkVolumeProperty* property)
{
  vtkNew<vtkOpticsVolumeMapper> block;
  block->SetOptics(this->Optics);
  this->SetKnobs(block);
  return block->GetGhostLayers(property);
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::SelectScalars(vtkOpticsVolumeMapper* block)
{
  block->SetScalarMode(this->ScalarMode);
  if (this->ArrayAccessMode == VTK_GET_ARRAY_BY_NAME)
  {
    block->SelectScalarArray(this->ArrayName);
  }
  else
  {
    block->SelectScalarArray(this->ArrayId);
  }
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::SelectMagnitude(
  vtkOpticsVolumeMapper* block, vtkDataSet* data, vtkDataArray* vectors, bool ofCells)
{
  vtkFieldData* arrays = ofCells ? static_cast<vtkFieldData*>(data->GetCellData())
                                 : static_cast<vtkFieldData*>(data->GetPointData());
  arrays->AddArray(MakeMagnitude(vectors));
  block->SetScalarMode(this->ScalarMode);
  block->SelectScalarArray(MagnitudeName);
}

//------------------------------------------------------------------------------
// As vtkSmartVolumeMapper: ParaView sets the functions of the first component, and they are meant for the one
// that is shown.
void vtkOpticsMultiBlockVolumeMapper::SelectComponent(
  vtkOpticsVolumeMapper* block, vtkVolume* volume, int components)
{
  this->SelectScalars(block);
  vtkVolumeProperty* property = volume->GetProperty();
  const int shown = this->GetVectorComponent();
  property->SetColor(shown, property->GetRGBTransferFunction(0));
  property->SetScalarOpacity(shown, property->GetScalarOpacity(0));
  for (int component = 0; component < components; ++component)
  {
    property->SetComponentWeight(component, component == shown ? 1.0 : 0.0);
  }
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::AddBlock(vtkDataSet* data, vtkVolume* volume)
{
  if (!data || !(data->IsA("vtkImageData") || data->IsA("vtkRectilinearGrid")))
  {
    return;
  }
  int cellFlag = 0;
  vtkDataArray* scalars =
    GetScalars(data, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    return; // a rank, or a block, without this array
  }
  auto input = vtk::TakeSmartPointer(data->NewInstance());
  input->ShallowCopy(data);
  Mapper block = Mapper::New();
  block->SetLockSampleDistanceToInputSpacing(this->Quality == vtkOpticsVolumeMapper::Custom);
  block->UseJitteringOn();
  block->SetOptics(this->Optics);
  const int components = scalars->GetNumberOfComponents();
  const bool isVector = components > 1 && volume->GetProperty()->GetIndependentComponents();
  if (isVector && this->GetVectorMode() == vtkScalarsToColors::MAGNITUDE)
  {
    this->SelectMagnitude(block, input, scalars, cellFlag == 1);
  }
  else if (this->GetVectorMode() == vtkScalarsToColors::COMPONENT)
  {
    this->SelectComponent(block, volume, components);
  }
  else
  {
    this->SelectScalars(block);
  }
  block->SetInputDataObject(input);
  this->SetKnobs(block);
  if (auto* piece = vtkImageData::SafeDownCast(input); piece && DrawsPieces())
  {
    DrawAsPiece(piece, this->WholeExtent, block);
  }
  this->Blocks.push_back(block);
}

//------------------------------------------------------------------------------
std::string vtkOpticsMultiBlockVolumeMapper::DescribeInput(vtkVolume* volume)
{
  vtkDataObject* data = this->GetDataObjectInput();
  std::ostringstream text;
  text << data << ' ' << data->GetMTime() << ' ' << this->ScalarMode << ' ' << this->ArrayAccessMode << ' '
       << this->ArrayId << ' ' << (this->ArrayName ? this->ArrayName : "") << ' ' << this->GetVectorMode()
       << ' ' << this->GetVectorComponent() << ' ' << volume->GetProperty()->GetIndependentComponents();
  return text.str();
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::LoadBlocks(vtkVolume* volume)
{
  this->Blocks.clear();
  vtkDataObject* data = this->GetDataObjectInput();
  auto* tree = vtkCompositeDataSet::SafeDownCast(data);
  if (!tree)
  {
    this->AddBlock(vtkDataSet::SafeDownCast(data), volume);
    return;
  }
  auto iterator = vtk::TakeSmartPointer(tree->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    this->AddBlock(vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()), volume);
  }
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::SortBlocks(vtkRenderer* renderer, vtkVolume* volume)
{
  std::vector<BlockBounds> bounds(this->Blocks.size());
  for (std::size_t block = 0; block < bounds.size(); ++block)
  {
    this->Blocks[block]->GetBounds(bounds[block].data());
  }
  double eye[4];
  FindEye(renderer, volume, eye);
  std::vector<Mapper> sorted;
  for (const std::size_t block : SortBackToFront(bounds, eye))
  {
    sorted.push_back(this->Blocks[block]);
  }
  this->Blocks.swap(sorted);
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::PassSettings(vtkOpticsVolumeMapper* block)
{
  block->SetBlendMode(this->GetBlendMode());
  block->SetCropping(this->GetCropping());
  block->SetCroppingRegionFlags(this->GetCroppingRegionFlags());
  block->SetCroppingRegionPlanes(this->GetCroppingRegionPlanes());
  block->SetClippingPlanes(this->GetClippingPlanes());
  block->SetTransfer2DYAxisArray(
    this->Transfer2DYAxisName.empty() ? nullptr : this->Transfer2DYAxisName.c_str());
  block->SetComputeNormalFromOpacity(this->GetComputeNormalFromOpacity());
  block->SetGlobalIlluminationReach(this->GetGlobalIlluminationReach());
  block->SetVolumetricScatteringBlending(this->GetVolumetricScatteringBlending());
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (!this->GetDataObjectInput())
  {
    return; // a process that has no part of the data
  }
  const std::string input = this->DescribeInput(volume);
  if (input != this->Loaded)
  {
    this->ReleaseGraphicsResources(renderer->GetRenderWindow());
    this->LoadBlocks(volume);
    this->Loaded = input;
  }
  this->SortBlocks(renderer, volume);
  const bool isInteractive = renderer->GetRenderWindow()->GetDesiredUpdateRate() >= InteractiveUpdateRate;
  for (const Mapper& block : this->Blocks)
  {
    this->PassSettings(block);
    block->SetAutoAdjustSampleDistances(isInteractive);
    block->Render(renderer, volume);
  }
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const Mapper& block : this->Blocks)
  {
    block->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkOpticsMultiBlockVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "Transfer2DYAxisName: " << this->Transfer2DYAxisName << "\n";
  os << indent << "WholeExtent:";
  for (const int index : this->WholeExtent)
  {
    os << " " << index;
  }
  os << "\n";
  os << indent << "Number of blocks: " << this->Blocks.size() << "\n";
  os << indent << "Optics:\n";
  this->Optics->PrintSelf(os, indent.GetNextIndent());
}
