// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPreIntegratedTable
 * @brief The volume rendering integral between any two scalars, as a table.
 *
 * Row and column are the scalars at the back and at the front of a ray's segment, on which the scalar is
 * taken as linear; the integral is [Kraus2005] eqs 6 and 7, without a dependence on the step of the ray.
 * An entry holds *means*, which interpolate where opacities would not: the colour of the segment, not
 * multiplied by its opacity, and its mean attenuation. The segment's opacity is
 *
 * - in data space `1 - exp(-mean |sb - sf|)`, sb and sf normalised to 0 at the range's first and 1 at its last
 *   scalar (GetNormalizedScalar());
 * - in physical space `1 - exp(-mean d/D)`, d its length and D the ScalarOpacityUnitDistance;
 *
 * and its associated colour is that opacity times the entry's colour. An entry on the diagonal is the mean
 * over one cell of the table around it, so that a path's attenuation is right in sum however small its
 * steps are.
 *
 * The functions are integrated from node to node: lines exactly (also towards opacity 1), VTK's sharp
 * curves and colour spaces other than RGB in 16 parts between two nodes, steps and coincident nodes as they
 * are. So a peak narrower than a cell of the table has its whole opacity. Opacity 1 counts as an optical
 * depth of 1e6. Opacities outside [0, 1] count as the nearest one inside, and NaN, also of a colour, as 0. Outside of the
 * functions' nodes their Clamping counts; scalars outside the table's range are those at its ends.
 *
 * Update() does the work, and only after a change. Independent of OpenGL.
 */

#ifndef vtkPreIntegratedTable_h
#define vtkPreIntegratedTable_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"       // for members
#include "vtkVolumeOpticsModule.h" // for export macro

#include <vector> // for members

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

class VTKVOLUMEOPTICS_EXPORT vtkPreIntegratedTable : public vtkObject
{
public:
  static vtkPreIntegratedTable* New();
  vtkTypeMacro(vtkPreIntegratedTable, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The transfer functions; both are needed, with at least one node each. Default none.
   */
  void SetColorFunction(vtkColorTransferFunction* function);
  vtkColorTransferFunction* GetColorFunction();
  void SetOpacityFunction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetOpacityFunction();
  ///@}

  ///@{
  /**
   * Scalars of the first and the last entry: finite, the first less than the last. Default 0 and 1.
   */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  ///@{
  /**
   * Entries per axis, in [2, 4096]. Default 256.
   */
  void SetSize(int size);
  vtkGetMacro(Size, int);
  ///@}

  ///@{
  /**
   * In data space, an opacity of the function is that of crossing this much of data. 0, the default:
   * a hundredth of the opacity function's own range (of the table's, if the function has none).
   */
  void SetUnitInterval(double interval);
  vtkGetMacro(UnitInterval, double);
  ///@}

  ///@{
  /**
   * 0, the default: data space. Above: physical space; segments of this length, in units of
   * ScalarOpacityUnitDistance, are what the colours attenuate themselves over (up to 1/500 of the colour's
   * range; the mean attenuation does not depend on it). In [0, 1e30].
   */
  void SetSegmentLength(double length);
  vtkGetMacro(SegmentLength, double);
  ///@}

  /**
   * Builds what has changed. False, with one error until the next change, if a function is missing or has no
   * node, or the range is not valid; the table is empty then.
   */
  bool Update();

  /**
   * Size x Size entries of four floats, after Update(): mean colour and mean attenuation, the scalar at
   * the front running fastest. Null if the table is empty.
   */
  const float* GetEntries() VTK_SIZEHINT(4 * GetSize() * GetSize());

  /**
   * Size numbers: the attenuation from the range's first scalar to that of each entry. The difference of
   * two is a segment's optical depth in data space, exact but for a float's digits. Null if the table is
   * empty.
   */
  const float* GetCumulative() VTK_SIZEHINT(GetSize());

  /**
   * Size pairs: the optical depth in data space from an entry's scalar to the end of its peak, towards
   * larger and towards smaller scalars. A peak ends where the opacity is 0, or the range. Between peaks both
   * are 0; at the end of one, the depth into it is that of the whole peak. What TransmittedShare() of
   * DataSpace.glsl needs. Null if the table is empty.
   */
  const float* GetDepthsBehind() VTK_SIZEHINT(2 * GetSize());

  /**
   * Mean attenuation between two scalars, interpolated between the entries. 0 if the table is empty.
   */
  double GetMean(double front, double back);

  /**
   * Mean colour and mean attenuation between two scalars, interpolated between the entries. 0 if the table
   * is empty.
   */
  void GetEntry(double front, double back, double rgba[4]);

  /**
   * 0 at the range's first and 1 at its last scalar, and these outside.
   */
  double GetNormalizedScalar(double scalar);

  /**
   * The largest mean attenuation in the table, to scale by what is stored in few bits. At most 1e30.
   */
  vtkGetMacro(LargestMean, double);

  /**
   * Bytes that the tables take.
   */
  std::size_t GetMemorySize();

  /**
   * Also when a function changed.
   */
  vtkMTimeType GetMTime() override;

  /**
   * When the table was built last.
   */
  vtkMTimeType GetBuildTime() { return this->BuildTime.GetMTime(); }

protected:
  vtkPreIntegratedTable();
  ~vtkPreIntegratedTable() override;

private:
  vtkPreIntegratedTable(const vtkPreIntegratedTable&) = delete;
  void operator=(const vtkPreIntegratedTable&) = delete;

  bool IsUsable();
  double EffectiveUnitInterval();
  void Build();

  vtkSmartPointer<vtkColorTransferFunction> ColorFunction;
  vtkSmartPointer<vtkPiecewiseFunction> OpacityFunction;
  double Range[2] = { 0.0, 1.0 };
  int Size = 256;
  double UnitInterval = 0.0;
  double SegmentLength = 0.0;

  std::vector<float> Entries;
  std::vector<float> Cumulative;
  std::vector<float> DepthsBehind;
  double LargestMean = 0.0;
  vtkTimeStamp BuildTime;
};

#endif
