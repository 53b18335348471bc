// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkAmbientCovarianceFilter
 * @brief Anisotropy of the structures around each voxel, from the scalars of a ball.
 *
 * Of the points of a ball about the voxel, those with nearly its scalar are projected on the plane
 * across its normal; their weighted covariance tells in which direction the structure extends, and
 * how much more than across. [Ament2015] section 4.1, Algorithm 1.
 *
 * Input 0: an image. Input 1, optional: an image of the same grid as the output with the point array
 * `Normals`; without it, the normals are those of vtkSobelNormalFilter. Output: see
 * vtkAnisotropyFilter. A voxel without a normal or with less than 3 accepted points has no estimate.
 *
 * Decisions where the paper is silent or wrong: the ball is one in world space (along an axis of one
 * voxel a disk); the centroid is not weighted, the weight 1 - d^2 is, about it, and is 0 beyond one
 * radius; points outside the volume or without a value are rejected.
 */

#ifndef vtkAmbientCovarianceFilter_h
#define vtkAmbientCovarianceFilter_h

#include "vtkAnisotropyFilter.h"
#include "vtkVolumeOpticsModule.h" // for export macro

#include <memory> // for the search of the range

namespace volumeoptics
{
class RangeSearch;
}

class VTKVOLUMEOPTICS_EXPORT vtkAmbientCovarianceFilter : public vtkAnisotropyFilter
{
public:
  static vtkAmbientCovarianceFilter* New();
  vtkTypeMacro(vtkAmbientCovarianceFilter, vtkAnisotropyFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Normals to use instead of the filter's own.
   */
  void SetNormalsConnection(vtkAlgorithmOutput* normals) { this->SetInputConnection(1, normals); }
  void SetNormalsData(vtkImageData* normals);
  ///@}

  ///@{
  /**
   * Radius of the ball, in voxels of the input's finest spacing (whatever the ResolutionFactor). In
   * [0.5, 256]; default 10. [Ament2015] r.
   */
  void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Largest difference of an accepted point's scalar from the voxel's, as a fraction of the width
   * of ScalarRange. In [0, 1]; default 0.05. [Ament2015] epsilon.
   */
  void SetScalarTolerance(double tolerance);
  vtkGetMacro(ScalarTolerance, double);
  ///@}

  ///@{
  /**
   * Range that ScalarTolerance is a fraction of. Default: an empty one (1, 0), which stands for the
   * finite values of the input's whole extent, so that pieces agree. If the input holds the whole
   * extent they are found there; else the filter asks the input once for slabs of the whole extent,
   * none larger than what the piece itself needs, and remembers the range until the input changes.
   * Setting the range saves that pass. Processes that share the volume (SetController()) each look at
   * their own piece.
   */
  void SetScalarRange(double least, double largest);
  void SetScalarRange(const double range[2]) { this->SetScalarRange(range[0], range[1]); }
  void SetScalarRangeToWholeExtent() { this->SetScalarRange(1.0, 0.0); }
  vtkGetVector2Macro(ScalarRange, double);
  ///@}

  ///@{
  /**
   * Number of points per voxel. In [3, 65536]; default 100. Exhaustive sampling has as many as the
   * ball has voxels. [Ament2015] n.
   */
  void SetNumberOfSamples(int number);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Where the points lie. Shared: the same offsets for all voxels, the fastest. PerBlock: others in
   * each block of 16^3 voxels. PerVoxel: random for each voxel, Algorithm 1 of [Ament2015] to the
   * letter, about fifty times slower. Exhaustive: all voxels of the ball, the truth. Default Shared.
   */
  enum SamplingPatternType
  {
    Shared = 0,
    PerBlock,
    PerVoxel,
    Exhaustive
  };
  void SetSamplingPattern(int pattern);
  void SetSamplingPatternToShared() { this->SetSamplingPattern(Shared); }
  void SetSamplingPatternToPerBlock() { this->SetSamplingPattern(PerBlock); }
  void SetSamplingPatternToPerVoxel() { this->SetSamplingPattern(PerVoxel); }
  void SetSamplingPatternToExhaustive() { this->SetSamplingPattern(Exhaustive); }
  vtkGetMacro(SamplingPattern, int);
  const char* GetSamplingPatternAsString();
  ///@}

  ///@{
  /**
   * Scalar at a point: of the nearest voxel, where the point is moved to, or interpolated linearly
   * (the paper's; matters for radii of 1 to 3 voxels). Exhaustive points are voxels. Default Nearest.
   */
  enum SampleInterpolationType
  {
    Nearest = 0,
    Linear
  };
  void SetSampleInterpolation(int interpolation);
  void SetSampleInterpolationToNearest() { this->SetSampleInterpolation(Nearest); }
  void SetSampleInterpolationToLinear() { this->SetSampleInterpolation(Linear); }
  vtkGetMacro(SampleInterpolation, int);
  const char* GetSampleInterpolationAsString();
  ///@}

  ///@{
  /**
   * Standard deviation of a Gaussian that the covariance, in world axes, is filtered with, in voxels
   * of the input's finest spacing. In [0, 100]; 0 is none. Default 0.
   */
  void SetFilterStandardDeviation(double standardDeviation);
  vtkGetMacro(FilterStandardDeviation, double);
  ///@}

  ///@{
  /**
   * Takes off the strength that an isotropic disk of so few points has by chance, 1/sqrt(points) on
   * average. Default off: the points of Shared, PerBlock and Exhaustive are spread evenly and have
   * less of it than random ones.
   */
  void SetNoiseCorrection(bool correction);
  vtkGetMacro(NoiseCorrection, bool);
  vtkBooleanMacro(NoiseCorrection, bool);
  ///@}

  ///@{
  /**
   * Selects the points. Any number; default 1. The same seed gives the same result.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkAmbientCovarianceFilter();
  ~vtkAmbientCovarianceFilter() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void GetReach(const volumeoptics::ImageGrid& grid, int reach[3]) override;
  bool ComputeCodes(const volumeoptics::ImageGrid& grid, const volumeoptics::ImageRows& rows,
    vtkInformationVector** inputs, volumeoptics::Batches& batches,
    volumeoptics::VoxelBox<float>& codes) override;

private:
  bool HasScalarRange() const { return this->ScalarRange[0] <= this->ScalarRange[1]; }
  // False if the filter must be executed again, with another extent of the input.
  bool FindRange(vtkInformationVector** inputs, vtkDataArray* scalars);

  double Radius = 10.0;
  double ScalarTolerance = 0.05;
  double ScalarRange[2] = { 1.0, 0.0 };
  int NumberOfSamples = 100;
  int SamplingPattern = Shared;
  int SampleInterpolation = Nearest;
  double FilterStandardDeviation = 0.0;
  bool NoiseCorrection = false;
  int Seed = 1;

  std::unique_ptr<volumeoptics::RangeSearch> Search;
  double RangeOfProcesses[2] = { 1.0, 0.0 };
  bool IsShared = false; // in this update

  vtkAmbientCovarianceFilter(const vtkAmbientCovarianceFilter&) = delete;
  void operator=(const vtkAmbientCovarianceFilter&) = delete;
};

#endif
