// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLightingTransferFunction
 * @brief Ambient, diffuse and specular coefficients by the scalars on both sides of a sample.
 *
 * [Lum2004]: light is put on boundaries between materials, wherever opacity is. With g the direction
 * of the gradient, a sample at x is looked up by S1 = s(x + h g) and S2 = s(x - h g). Each boundary
 * links two materials, A and B, each a range of scalars with soft edges or any curve; it adds
 * (ka, kd, ks) times
 *
 *   max(A(S1) B(S2), A(S2) B(S1)),
 *
 * so that the pair has no order, and a boundary of a material with itself counts once. The boundaries
 * and the table from an image are summed, and each coefficient's sum is at most 1, however
 * many overlap: the property's LightScale is what makes light brighter than that.
 *
 * Coefficients are in [0, 1], softness in [0, 1e30] scalars. A number outside its range is set to the
 * nearest one of the range, with a warning; a reversed range is turned; one that is not finite is an
 * error, and changes nothing. A range of zero width has its soft edges alone.
 *
 * JSON, all keys optional but the ranges or curves ("CurveA": [[scalar, weight], ...]):
 * @code{.json}
 * { "Boundaries": [ { "RangeA": [0, 90], "RangeB": [180, 255], "Softness": 10,
 *                     "Ambient": 0.2, "Diffuse": 0.7, "Specular": 0.4 } ],
 *   "Table": { "Origin": [0, 0], "Spacing": [1, 1], "Dimensions": [2, 2], "Components": 3,
 *              "Values": [0, 0, 0, 0.1, 0.5, 0, 0.1, 0.5, 0, 0, 0, 0] } }
 * @endcode
 *
 * @sa vtkGradientAlignedHistogram vtkLightingTransferFunctionItem
 */

#ifndef vtkLightingTransferFunction_h
#define vtkLightingTransferFunction_h

#include "vtkObject.h"
#include "vtkVolumeOpticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for std::vector

class vtkImageData;
class vtkPiecewiseFunction;

class VTKVOLUMEOPTICS_EXPORT vtkLightingTransferFunction : public vtkObject
{
public:
  static vtkLightingTransferFunction* New();
  vtkTypeMacro(vtkLightingTransferFunction, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Adds a boundary between two ranges of scalars, with a softness of 0. Returns its index, the last
   * one; -1 after an error.
   */
  int AddBoundary(const double rangeA[2], const double rangeB[2], double ka, double kd, double ks);

  /**
   * Adds a boundary between two materials given as any curves over the scalars; what they return is
   * clamped to [0, 1]. The functions are kept by reference: editing them edits the boundary. Softness
   * does not apply. Returns its index; -1 after an error.
   */
  int AddBoundary(
    vtkPiecewiseFunction* curveA, vtkPiecewiseFunction* curveB, double ka, double kd, double ks);

  ///@{
  /**
   * The boundaries are numbered from 0. Removing one moves the later ones up.
   */
  int GetNumberOfBoundaries();
  void RemoveBoundary(int boundary);
  void RemoveAllBoundaries();
  ///@}

  ///@{
  /**
   * The range of scalars of one side of a boundary; side 0 is A, 1 is B. That of a curve is the
   * function's own, and cannot be set here (error).
   */
  void SetRange(int boundary, int side, double low, double high);
  void GetRange(int boundary, int side, double range[2]);
  ///@}

  ///@{
  /**
   * Width in scalars over which the weight falls from 1 at the end of a range to 0 outside of it.
   */
  void SetSoftness(int boundary, double softness);
  double GetSoftness(int boundary);
  ///@}

  ///@{
  /**
   * ka, kd and ks of a boundary.
   */
  void SetCoefficients(int boundary, double ka, double kd, double ks);
  void GetCoefficients(int boundary, double coefficients[3]);
  ///@}

  /**
   * The curve of one side of a boundary; nullptr for a range.
   */
  vtkPiecewiseFunction* GetCurve(int boundary, int side);

  ///@{
  /**
   * Any table, added to the boundaries: a 2D image whose points lie at (S1, S2), in scalars, by its
   * origin, spacing and extent; linear between the points, and the border's value outside. 3
   * components are ka, kd, ks; of 2 components ks is 0; 1 stands for all three. Integers are taken
   * relative to the largest value of their type; values are clamped to [0, 1], NaN is 0. Nothing makes
   * it symmetric. The image is kept by reference. nullptr, the default, is none.
   */
  void SetTableFromImage(vtkImageData* image);
  vtkImageData* GetTableImage();
  ///@}

  /**
   * Takes the boundaries and the table of another function; curves and image are shared with it.
   */
  void ShallowCopy(vtkLightingTransferFunction* source);

  /**
   * A first guess: replaces the boundaries by the strongest ones of a histogram of pairs along the
   * gradient (vtkGradientAlignedHistogram), at most `number` of them, the strongest first. Materials are
   * the modes of its diagonal; a pair of them is a boundary where pairs are counted in the
   * middle of its transition. All scalars beyond the outermost material are one more material, such as
   * thin bone, if it has pairs with them and they have no homogeneous region. Each range holds its material's scalar and none of another's; ambient,
   * diffuse and specular are 0.2, 0.7 and 0.4. Returns how many were found: 0 for a volume without two
   * materials. An empty histogram, or one that is not square, is an error, and changes nothing.
   */
  int InitializeFromHistogram(vtkImageData* histogram, int number);

  /**
   * ka, kd, ks at a pair of scalars, exact.
   */
  void Evaluate(double s1, double s2, double coefficients[3]);

  ///@{
  /**
   * The function as a table of size x size RGBA: ka, kd, ks, and in the fourth channel the difference
   * of classified densities rho(S1) - rho(S2), in [-1, 1], for hybrid normals; 0 without `density`,
   * which usually is the scalar opacity of the volume's property. Element 4 (row size + column):
   * column is S1, row is S2. Texel i stands for the interval [range[0] + i w, range[0] + (i + 1) w],
   * w = (range[1] - range[0])/size, so that a texture coordinate is (s - range[0])/(range[1] - range[0]).
   * It holds the mean of each side's weight over the interval: a range narrower than a texel gets dim,
   * not lost. size: 1 to LargestTableSize. An error (bad size, range that is not finite) leaves an empty table.
   *
   * The contents change only with GetMTime() of this object and of `density`.
   */
  enum
  {
    LargestTableSize = 4096
  };
  void GetTable(
    const double range[2], int size, std::vector<float>& rgba, vtkPiecewiseFunction* density = nullptr);
  void GetTable(
    const double range[2], int size, vtkImageData* table, vtkPiecewiseFunction* density = nullptr);
  ///@}

  ///@{
  /**
   * Save and read, as a file or a string. Reading replaces everything, or, after an error that names
   * file, key and value, nothing. False after an error.
   */
  bool WriteJson(const char* fileName);
  bool ReadJson(const char* fileName);
  std::string WriteJsonString();
  bool ReadJsonString(const std::string& text);
  ///@}

  /**
   * The latest change of this object, its curves and its image.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkLightingTransferFunction();
  ~vtkLightingTransferFunction() override;

private:
  vtkLightingTransferFunction(const vtkLightingTransferFunction&) = delete;
  void operator=(const vtkLightingTransferFunction&) = delete;

  bool HasBoundary(int boundary, const char* method);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
