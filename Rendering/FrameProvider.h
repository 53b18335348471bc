// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where the normals and frames of a volume come from: what the user connected, else arrays of the
// input, else the filters, which it runs when the data has changed. For normals that come without
// frames, the covariance is computed from these normals.

#ifndef FrameProvider_h
#define FrameProvider_h

#include "FrameTextures.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkWeakPointer.h"

class vtkAlgorithmOutput;
class vtkAmbientCovarianceFilter;
class vtkPrincipalCurvatureFilter;
class vtkSobelNormalFilter;
struct OpticsScene;

class FrameProvider
{
public:
  FrameProvider();
  ~FrameProvider();

  /** What is asked of the frames of a scene. */
  struct Request
  {
    bool Anisotropy; // else normals alone
    bool Curvature;  // source of the anisotropy, if any, else the covariance
    double ResolutionFactor;
    int Bits;    // per number on the GPU, for the memory limit
    bool Coarse; // enough while the user interacts
  };

  /**
   * The frames, with arrays of float on one grid. Normals is null where there are none; why has then
   * been said through the scene's mapper.
   */
  FrameGrid Update(const OpticsScene& scene, const Request& request);

  /** An output of a pipeline; unlike vtkAlgorithmOutput it keeps the producer. */
  struct Connection
  {
    Connection() = default;
    explicit Connection(vtkAlgorithmOutput* output);
    explicit Connection(vtkImageData* image);

    vtkSmartPointer<vtkAlgorithm> Producer; // null: none
    int Port = 0;
  };
  Connection NormalsInput;
  Connection AnisotropyInput;

  vtkNew<vtkSobelNormalFilter> Sobel;
  vtkNew<vtkAmbientCovarianceFilter> Covariance;
  vtkNew<vtkPrincipalCurvatureFilter> Curvature;

private:
  // The curvature of smoothed data goes with the normals of the same data.
  vtkNew<vtkSobelNormalFilter> CurvatureSobel;

  vtkSobelNormalFilter* GetNormals(const Request& request);
  int GetStorage(const Request& request);
  void UpdateInput(const OpticsScene& scene);
  // Normals that came without anisotropy, on the grid of the covariance; null: the filter's own.
  void SetGivenNormals(vtkImageData* normals);
  FrameGrid RunFilters(const OpticsScene& scene, const Request& request, double factor);
  double GetResolutionFactor(const OpticsScene& scene, const Request& request);
  vtkMTimeType GetTime() const;

  void SetUpFilters(const OpticsScene& scene, double factor);
  void Store(const Request& request, double factor);
  bool IsCurrent(const Request& request) const;             // what is stored belongs to the data
  bool IsFine(const Request& request, double factor) const; // and has the resolution
  FrameGrid GetStored(bool withAnisotropy) const;

  vtkSmartPointer<vtkImageData> Input; // the scalars that opacity depends on, as point data
  vtkWeakPointer<vtkImageData> Source;
  vtkMTimeType SourceTime = 0;

  vtkSmartPointer<vtkImageData> Given;
  vtkWeakPointer<vtkImageData> GivenSource;
  vtkMTimeType GivenTime = 0;

  // What the filters made last, so that a coarse frame does not undo a fine one.
  struct
  {
    vtkSmartPointer<vtkImageData> Geometry;
    vtkSmartPointer<vtkFloatArray> Normals;
    vtkSmartPointer<vtkFloatArray> Magnitude;
    vtkSmartPointer<vtkFloatArray> Anisotropy;
  } Stored;
  bool StoredCurvature = false;
  double StoredFactor = 0.0;
  vtkMTimeType StoredTime = 0;
};

#endif
