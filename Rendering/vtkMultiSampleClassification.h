// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiSampleClassification
 * @brief Colour and opacity by a scalar and the two beside it along the gradient.
 *
 * [Lum2004] section 7 and figure 11: where the blur around branches has the scalars of leaves, the
 * scalars on both sides tell them apart. S is the sample's scalar, S1 = s(x + h g) the one uphill, S2 =
 * s(x - h g) the one downhill, as for vtkLightingTransferFunction.
 *
 * What the volume property's transfer functions give is the start; then the rules replace it one after
 * the other, to the degree to which (S, S1, S2) is in a rule's three ranges with their soft edges
 * (Module/Optics/MultiSampleRule.glsl). A later rule wins over an earlier one.
 *
 * A number outside its range is set to the nearest one of the range, with a warning; a reversed range is
 * turned. JSON, all keys optional (without S, S1 or S2 any scalar will do):
 * @code{.json}
 * { "Rules": [ { "S": [20, 180], "S1": [150, 255], "Softness": [0, 10, 0], "Color": [0.5, 0.3, 0.1],
 *                "Opacity": 0.8 } ] }
 * @endcode
 *
 * @sa vtkLightingTransferFunction
 */

#ifndef vtkMultiSampleClassification_h
#define vtkMultiSampleClassification_h

#include "vtkObject.h"
#include "vtkVolumeOpticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for std::vector

class VTKVOLUMEOPTICS_EXPORT vtkMultiSampleClassification : public vtkObject
{
public:
  static vtkMultiSampleClassification* New();
  vtkTypeMacro(vtkMultiSampleClassification, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Number of rules that there is room for, and numbers of a rule in GetRules().
   */
  enum
  {
    LargestNumberOfRules = 32,
    NumbersOfRule = 16
  };

  /**
   * Which of the three scalars.
   */
  enum
  {
    Center = 0,
    Uphill,
    Downhill
  };

  /**
   * Adds a rule: ranges of S, S1 and S2 (infinite ends are allowed), a colour and an opacity in [0, 1],
   * the opacity per ScalarOpacityUnitDistance as VTK's. Its softness is 0. Returns its index, the last one;
   * -1 after an error (NaN, or no room).
   */
  int AddRule(const double s[2], const double s1[2], const double s2[2], double red, double green,
    double blue, double opacity);

  ///@{
  /**
   * Rules are numbered from 0; removing one moves the later ones up.
   */
  int GetNumberOfRules();
  void RemoveRule(int rule);
  void RemoveAllRules();
  ///@}

  ///@{
  /**
   * The range of one of the scalars (Center, Uphill, Downhill); without limit it is
   * [-VTK_DOUBLE_MAX, VTK_DOUBLE_MAX].
   */
  void SetRange(int rule, int scalar, double low, double high);
  void GetRange(int rule, int scalar, double range[2]);
  ///@}

  ///@{
  /**
   * Width in scalars over which a rule fades out outside of a range. In [0, 1e30]; default 0.
   */
  void SetSoftness(int rule, int scalar, double softness);
  double GetSoftness(int rule, int scalar);
  ///@}

  ///@{
  /**
   * Colour and opacity, in [0, 1].
   */
  void SetColor(int rule, double red, double green, double blue);
  void GetColor(int rule, double color[3]);
  void SetOpacity(int rule, double opacity);
  double GetOpacity(int rule);
  ///@}

  /**
   * Colour (not multiplied by opacity) and opacity at (S, S1, S2), `former` being what the transfer
   * functions give.
   */
  void Evaluate(double s, double s1, double s2, const double former[4], double rgba[4]);

  /**
   * The rules for a shader, NumbersOfRule floats each, four vec4: low ends of S, S1, S2 and the
   * opacity; high ends, 0; softness, 0; colour, 0. Ends are within what a float holds.
   */
  void GetRules(std::vector<float>& numbers);

  ///@{
  /**
   * Save and read, as a file or a string. Reading replaces all rules, or, after an error that names file,
   * key and value, nothing. False after an error.
   */
  bool WriteJson(const char* fileName);
  bool ReadJson(const char* fileName);
  std::string WriteJsonString();
  bool ReadJsonString(const std::string& text);
  ///@}

protected:
  vtkMultiSampleClassification();
  ~vtkMultiSampleClassification() override;

private:
  vtkMultiSampleClassification(const vtkMultiSampleClassification&) = delete;
  void operator=(const vtkMultiSampleClassification&) = delete;

  bool HasRule(int rule, int scalar, const char* method);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
