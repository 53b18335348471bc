// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkStructuralDissimilarity
 * @brief How much structure a picture shows that a reference picture does not.
 *
 * Multi-scale, homogeneity-weighted structural dissimilarity, after [Tao2012] as [Ament2015] uses it
 * to score shading against the phase function alone. The measure's exact definition was not at hand;
 * this one is built from the structure term of [Wang2004] and the scales of [Wang2003]:
 *
 * On luminance (Rec. 709) in [0, 1], with means under a Gaussian window (standard deviation 1.5
 * pixels, 11 x 11, renormalised at the border), r the reference, p the picture, c = 0.03^2/2:
 *
 *   structure  s = (cov(r, p) + c)/(sigma_r sigma_p + c)
 *   presence   t = (2 cov(r, p) + c)/(sigma_r^2 + sigma_p^2 + c)
 *   homogeneity of the reference  h = c/(sigma_r^2 + c), times HomogeneityWeight
 *   dissimilarity  d = (1 - (1 - h) s - h t)/2
 *
 * s alone is blind where the reference is homogeneous (it is 1 for sigma_r = 0 whatever the picture
 * shows); there t, in which the strength of new structure counts, takes its place. d is 0 for the same
 * structure, 1/2 for unrelated, 1 for the inverse one. It is computed on dyadic scales j (each the
 * former smoothed by the binomial 1 4 6 4 1 and halved) and combined per pixel as
 * (sum_j w_j sqrt(d_j))^2 with the weights w = .0448, .2856, .3001, .2363, .1333 of [Wang2003]. Noise
 * cancels within few scales, structure such as a highlight along a ridge goes on through them; the
 * roots favour what persists: structure scores higher than noise of equal energy.
 *
 * The output is the map of d at full size; the score is its mean over all pixels, in [0, 1], and
 * exactly 0 for identical pictures. The measure is not symmetric: homogeneity is the reference's.
 *
 * Inputs, of equal size and one slice: port 0 the reference, port 1 the picture. One component is
 * luminance, two luminance and alpha, three and four RGB and RGBA; alpha is ignored. Integers are
 * divided by their type's largest value, floating point is taken as it is; values that are not finite
 * count as 0. Pictures of different size, of several slices or without point scalars are an error, and
 * the score is -1.
 */

#ifndef vtkStructuralDissimilarity_h
#define vtkStructuralDissimilarity_h

#include "vtkImageAlgorithm.h"
#include "vtkVolumeOpticsModule.h" // for export macro

class VTKVOLUMEOPTICS_EXPORT vtkStructuralDissimilarity : public vtkImageAlgorithm
{
public:
  static vtkStructuralDissimilarity* New();
  vtkTypeMacro(vtkStructuralDissimilarity, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The two pictures.
   */
  void SetReferenceData(vtkImageData* image);
  void SetReferenceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(0, output); }
  void SetPictureData(vtkImageData* image);
  void SetPictureConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  ///@}

  ///@{
  /**
   * Number of dyadic scales, in [1, 5], clamped to it. Default 5. A small picture has fewer: none is computed beyond
   * the one of a single pixel, and the weights are renormalised. With one scale noise is not told from
   * structure.
   */
  vtkGetMacro(NumberOfScales, int);
  vtkSetClampMacro(NumberOfScales, int, 1, 5);
  ///@}

  ///@{
  /**
   * How much the homogeneity of the reference counts, in [0, 1], clamped to it. 0: the structure term alone. Default
   * 1.
   */
  vtkGetMacro(HomogeneityWeight, double);
  vtkSetClampMacro(HomogeneityWeight, double, 0.0, 1.0);
  ///@}

  /**
   * The score of the last Update(), in [0, 1]; -1 if there is none.
   */
  vtkGetMacro(Score, double);

protected:
  vtkStructuralDissimilarity();
  ~vtkStructuralDissimilarity() override = default;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkStructuralDissimilarity(const vtkStructuralDissimilarity&) = delete;
  void operator=(const vtkStructuralDissimilarity&) = delete;

  bool AreComparable(vtkImageData* reference, vtkImageData* picture);
  void ComputeMap(vtkImageData* reference, vtkImageData* picture, double* values);

  int NumberOfScales = 5;
  double HomogeneityWeight = 1.0;
  double Score = -1.0;
};

#endif
