// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkOpticsMultiBlockVolumeMapper
 * @brief Draws an image, or each image of a composite data set, by a vtkOpticsVolumeMapper of its own.
 *
 * A vtkMultiBlockVolumeMapper, because ParaView's volume representation and its actor look for that
 * class; it draws what that one draws, and the optical models in addition. Blocks are drawn back to
 * front; boxes that do not overlap and no three of which surround each other have such an order.
 *
 * @sa vtkOpticsVolumeRepresentation vtkOpticsVolumeMapper
 */

#ifndef vtkOpticsMultiBlockVolumeMapper_h
#define vtkOpticsMultiBlockVolumeMapper_h

#include "vtkMultiBlockVolumeMapper.h"
#include "vtkNew.h"                        // for the optics
#include "vtkSmartPointer.h"               // for the blocks
#include "vtkVolumeOpticsParaViewModule.h" // for export macro

#include <functional> // for the knobs
#include <map>        // for the knobs
#include <string>     // for the knobs
#include <vector>     // for the blocks

class vtkDataArray;
class vtkDataSet;
class vtkOpticsVolumeMapper;
class vtkOpticsVolumeProperty;
class vtkVolumeProperty;

class VTKVOLUMEOPTICSPARAVIEW_EXPORT vtkOpticsMultiBlockVolumeMapper : public vtkMultiBlockVolumeMapper
{
public:
  static vtkOpticsMultiBlockVolumeMapper* New();
  vtkTypeMacro(vtkOpticsMultiBlockVolumeMapper, vtkMultiBlockVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The optical models that all blocks are drawn with. Change it, it is not to be replaced.
   */
  vtkOpticsVolumeProperty* GetOptics() { return this->Optics; }

  /**
   * The array of the second axis of a 2D transfer function.
   */
  void SetTransfer2DYAxisArray(const char* name);

  /**
   * The extent of the whole volume, of which several processes draw a piece each: their samples lie where
   * those of one process lie. Default empty (0, -1, ...): each block's own.
   */
  void SetWholeExtent(const int extent[6]);

  /**
   * Ghost layers that a piece should have, by the optics, the knobs and a volume's property.
   */
  int GetGhostLayers(vtkVolumeProperty* property);

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

#ifndef __VTK_WRAP__
  /**
   * A setting of every block's mapper, now and whenever it is made, under a name of its own. Those of a
   * quality preset are not applied while there is one.
   */
  using Knob = std::function<void(vtkOpticsVolumeMapper*)>;
  void SetKnob(const std::string& name, const Knob& knob);
  void SetPresetKnob(const std::string& name, const Knob& knob);
#endif

  /**
   * The mappers' quality, vtkOpticsVolumeMapper::QualityType. Default Custom: the knobs count.
   */
  void SetQuality(int quality);

protected:
  vtkOpticsMultiBlockVolumeMapper();
  ~vtkOpticsMultiBlockVolumeMapper() override;

private:
  vtkOpticsMultiBlockVolumeMapper(const vtkOpticsMultiBlockVolumeMapper&) = delete;
  void operator=(const vtkOpticsMultiBlockVolumeMapper&) = delete;

  using Mapper = vtkSmartPointer<vtkOpticsVolumeMapper>;

  std::string DescribeInput(vtkVolume* volume);
  void LoadBlocks(vtkVolume* volume);
  void AddBlock(vtkDataSet* data, vtkVolume* volume);
  void SelectScalars(vtkOpticsVolumeMapper* block);
  void SelectMagnitude(vtkOpticsVolumeMapper* block, vtkDataSet* data, vtkDataArray* vectors, bool ofCells);
  void SelectComponent(vtkOpticsVolumeMapper* block, vtkVolume* volume, int components);
  void SetKnobs(vtkOpticsVolumeMapper* block);
  void PassSettings(vtkOpticsVolumeMapper* block);
  void SortBlocks(vtkRenderer* renderer, vtkVolume* volume);

  vtkNew<vtkOpticsVolumeProperty> Optics;
  std::vector<Mapper> Blocks;
  std::string Loaded; // what the blocks were made of
  std::map<std::string, Knob> Knobs;
  std::map<std::string, Knob> PresetKnobs;
  std::string Transfer2DYAxisName;
  int WholeExtent[6] = { 0, -1, 0, -1, 0, -1 };
  int Quality = 0;
};

#endif
