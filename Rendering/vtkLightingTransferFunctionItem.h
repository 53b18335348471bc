// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLightingTransferFunctionItem
 * @brief Shows and edits a lighting transfer function on the line histogram of a volume.
 *
 * [Lum2004] section 4.1: two parallel axes of scalars, below for S1 (uphill), above for S2 (downhill);
 * each pair of the histogram is a line between them, and many lines are bright. Bundles of lines straight
 * across the axes are homogeneous regions, slanted lines are boundaries between the two materials
 * at their ends. Each boundary of the function has a box on both axes, in one colour, with a band between them.
 * Add the item to the scene of any vtkContextView or vtkContextActor; it fills the scene, or Rectangle.
 *
 * Mouse (left button):
 * - drag a box: moves it; drag its end: resizes it; drag the band of the selected boundary: moves both boxes;
 * - drag from one axis to the other, along lines: a new boundary between the scalars at the ends;
 * - double click between the axes: a new boundary of the region with that scalar with itself;
 * - click: selects, on nothing: unselects; wheel: softness of the selected boundary.
 *
 * Keys: Tab next boundary; Space other box; Left, Right move the box, [ ] narrow and widen it (with Shift
 * by larger steps); + - softness; c next coefficient (ambient, diffuse, specular), Up, Down change it; a
 * adds a boundary; i guesses boundaries from the histogram; Delete or BackSpace removes; z or Ctrl+z undo; y or
 * Ctrl+y or Ctrl+Shift+z redo; g logarithm on or off; h histograms beside on or off; Escape ends a drag
 * without its change.
 *
 * The function's ModifiedEvent tells each change, at once. The item itself invokes StartInteractionEvent,
 * InteractionEvent and EndInteractionEvent for drags, so that a volume can be drafted meanwhile.
 *
 * A number outside its range is set to the nearest one of the range, with a warning.
 *
 * @sa vtkGradientAlignedHistogram vtkLightingTransferFunction
 */

#ifndef vtkLightingTransferFunctionItem_h
#define vtkLightingTransferFunctionItem_h

#include "vtkContextItem.h"
#include "vtkVolumeOpticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkImageData;
class vtkLightingTransferFunction;
class vtkPiecewiseFunction;

class VTKVOLUMEOPTICS_EXPORT vtkLightingTransferFunctionItem : public vtkContextItem
{
public:
  static vtkLightingTransferFunctionItem* New();
  vtkTypeMacro(vtkLightingTransferFunctionItem, vtkContextItem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The function to edit. Another one forgets the edits that could be undone. Default none.
   */
  void SetLightingTransferFunction(vtkLightingTransferFunction* function);
  vtkLightingTransferFunction* GetLightingTransferFunction();
  ///@}

  ///@{
  /**
   * The histogram of pairs, output 0 of an updated vtkGradientAlignedHistogram; its bins are the axes'
   * range. Without one the range is [0, 1], and no lines are drawn. Default none.
   */
  void SetHistogram(vtkImageData* histogram);
  vtkImageData* GetHistogram();
  ///@}

  ///@{
  /**
   * The histogram of scalars and gradient magnitudes, output 1 of the same filter, shown above the one
   * of pairs (S1 to the right, S2 upwards) beside the lines, where ShowHistograms is on. Default none.
   */
  void SetGradientHistogram(vtkImageData* histogram);
  vtkImageData* GetGradientHistogram();
  ///@}

  ///@{
  /**
   * Lines that link scalars whose opacities differ by at most OpacityTolerance ([0, 1], default 0.02) are
   * orange: light there shows boundaries that opacity does not. Those that are nearly straight across,
   * within 3 % of the range, are left as they are. Default none.
   */
  void SetOpacityFunction(vtkPiecewiseFunction* opacity);
  vtkPiecewiseFunction* GetOpacityFunction();
  void SetOpacityTolerance(double tolerance);
  vtkGetMacro(OpacityTolerance, double);
  ///@}

  ///@{
  /**
   * Intensity by the logarithm of the density, or in proportion to it. Default on.
   */
  vtkGetMacro(LogScale, bool);
  void SetLogScale(bool log);
  vtkBooleanMacro(LogScale, bool);
  ///@}

  ///@{
  /**
   * Axes upright, S2 at the left and S1 at the right, instead of lying above each other. Default off.
   */
  vtkGetMacro(VerticalAxes, bool);
  void SetVerticalAxes(bool vertical);
  vtkBooleanMacro(VerticalAxes, bool);
  ///@}

  ///@{
  /**
   * The 2D histograms of [Lum2004] figure 2 (a), (b) beside the lines. Default off.
   */
  vtkGetMacro(ShowHistograms, bool);
  void SetShowHistograms(bool show);
  vtkBooleanMacro(ShowHistograms, bool);
  ///@}

  ///@{
  /**
   * Where the item is in the scene: x, y, width, height in pixels. A width or height of 0 is the
   * whole scene. Default 0, 0, 0, 0.
   */
  void SetRectangle(double x, double y, double width, double height);
  vtkGetVector4Macro(Rectangle, double);
  ///@}

  ///@{
  /**
   * The selected boundary, -1 for none.
   */
  void SetSelectedBoundary(int boundary);
  int GetSelectedBoundary();
  ///@}

  ///@{
  /**
   * The edits made with this item, the last 200 of them. False if there is nothing to undo or redo.
   */
  bool Undo();
  bool Redo();
  ///@}

  /**
   * Replaces the boundaries by the strongest ones of the histogram, undoably. Returns their number.
   */
  int InitializeFromHistogram(int number);

  /**
   * Where a scalar is on the axis of S1 (0) or S2 (1), in the scene. Valid after the first frame.
   */
  void GetAxisPoint(int axis, double scalar, double point[2]);

  /**
   * Colour of a boundary's boxes.
   */
  static void GetBoundaryColor(int boundary, double color[3]);

  ///@{
  /**
   * Painting and events, called by the scene.
   */
  bool Paint(vtkContext2D* painter) override;
  bool Hit(const vtkContextMouseEvent& mouse) override;
  bool MouseButtonPressEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseMoveEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseButtonReleaseEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseDoubleClickEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseWheelEvent(const vtkContextMouseEvent& mouse, int delta) override;
  bool KeyPressEvent(const vtkContextKeyEvent& key) override;
  ///@}

protected:
  vtkLightingTransferFunctionItem();
  ~vtkLightingTransferFunctionItem() override;

private:
  vtkLightingTransferFunctionItem(const vtkLightingTransferFunctionItem&) = delete;
  void operator=(const vtkLightingTransferFunctionItem&) = delete;

  void Redraw();
  void RedrawPictures();
  void UpdateLayout();
  bool ViewKey(const std::string& symbol);

  double OpacityTolerance = 0.02;
  bool LogScale = true;
  bool VerticalAxes = false;
  bool ShowHistograms = false;
  double Rectangle[4] = { 0.0, 0.0, 0.0, 0.0 };

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
