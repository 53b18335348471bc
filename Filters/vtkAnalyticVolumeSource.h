// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkAnalyticVolumeSource
 * @brief Scalar fields in closed form, sampled on an image.
 *
 * The fields that tests, benchmarks and examples share. The image samples the field at its own points
 * in world space: Bounds is the window, it neither moves nor scales the field. The fields live in
 * [-1, 1]^3. In float and double scalars are in [0, 1] (LinearRamp on beyond, where Bounds are wider);
 * integers take this range to [0, m], m the type's largest value or 65535, rounded and clamped.
 *
 * A number outside its range is set to the nearest one of the range; a field that does not exist leaves
 * the former one, with a warning.
 *
 * Streams by extent (any two pieces agree where they overlap), threaded by vtkSMPTools. The exact
 * gradients are in AnalyticFields.h.
 */

#ifndef vtkAnalyticVolumeSource_h
#define vtkAnalyticVolumeSource_h

#include "vtkImageAlgorithm.h"
#include "vtkVolumeOpticsModule.h" // for export macro

class VTKVOLUMEOPTICS_EXPORT vtkAnalyticVolumeSource : public vtkImageAlgorithm
{
public:
  static vtkAnalyticVolumeSource* New();
  vtkTypeMacro(vtkAnalyticVolumeSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The field. MarschnerLobb: the test signal [Marschner1994], frequency 6, alpha 1/4. Sphere,
   * Ellipsoid, Cylinder (infinite), Torus: 1 in the middle, one half on the surface.
   * PackedEllipsoids: as [Ament2015] figure 5, see SetBoundsToPackedEllipsoids(). VortexTubes:
   * curved, intertwined tubes, 1 in their middle and 0 between them. LinearRamp: (1 + position along
   * Axis)/2. NoisyHomogeneous: one half plus noise. CoulombPotential: of a charge in the middle, Strength
   * over the distance from it, rounded off to 1 within Strength. CoulombPotentials: half the sum of three,
   * with Strength, a half and a quarter of it, as [Kraus2005] figure 1. HydrogenOrbital: density of 3d_z2,
   * figure 8, its lobes largest at Radius. Buckyball: bumps at the atoms of C60, at Radius from the middle.
   * Plant: branches of 1, leaves of one half, with soft edges, as [Lum2004] figure 11.
   * Default MarschnerLobb.
   */
  enum FieldType
  {
    MarschnerLobb = 0,
    Sphere,
    Ellipsoid,
    Cylinder,
    Torus,
    PackedEllipsoids,
    VortexTubes,
    LinearRamp,
    NoisyHomogeneous,
    CoulombPotential,
    CoulombPotentials,
    HydrogenOrbital,
    Buckyball,
    Plant,
    NumberOfFields
  };
  vtkGetMacro(Field, int);
  void SetField(int field);
  void SetFieldToMarschnerLobb() { this->SetField(MarschnerLobb); }
  void SetFieldToSphere() { this->SetField(Sphere); }
  void SetFieldToEllipsoid() { this->SetField(Ellipsoid); }
  void SetFieldToCylinder() { this->SetField(Cylinder); }
  void SetFieldToTorus() { this->SetField(Torus); }
  void SetFieldToPackedEllipsoids() { this->SetField(PackedEllipsoids); }
  void SetFieldToVortexTubes() { this->SetField(VortexTubes); }
  void SetFieldToLinearRamp() { this->SetField(LinearRamp); }
  void SetFieldToNoisyHomogeneous() { this->SetField(NoisyHomogeneous); }
  void SetFieldToCoulombPotential() { this->SetField(CoulombPotential); }
  void SetFieldToCoulombPotentials() { this->SetField(CoulombPotentials); }
  void SetFieldToHydrogenOrbital() { this->SetField(HydrogenOrbital); }
  void SetFieldToBuckyball() { this->SetField(Buckyball); }
  void SetFieldToPlant() { this->SetField(Plant); }
  const char* GetFieldAsString();
  ///@}

  ///@{
  /**
   * Number of points along each axis, at least 1. Default 64, 64, 64.
   */
  vtkGetVector3Macro(Dimensions, int);
  void SetDimensions(int x, int y, int z);
  void SetDimensions(const int dimensions[3])
  {
    this->SetDimensions(dimensions[0], dimensions[1], dimensions[2]);
  }
  ///@}

  ///@{
  /**
   * Where the first and the last point of each axis lie. Along an axis with one point, that point lies
   * in the middle, in world units. Default [-1, 1]^3. SetBoundsToPackedEllipsoids() takes the window of
   * [Ament2015] figure 5, 500 x 184 x 1024 units of its length with the longest side from -1 to 1.
   */
  vtkGetVector6Macro(Bounds, double);
  vtkSetVector6Macro(Bounds, double);
  void SetBoundsToPackedEllipsoids();
  ///@}

  ///@{
  /**
   * VTK_FLOAT (the default), VTK_DOUBLE or any integer type.
   */
  vtkGetMacro(OutputScalarType, int);
  vtkSetMacro(OutputScalarType, int);
  ///@}

  ///@{
  /**
   * Shapes, in world units above 0: radius of Sphere, Cylinder, of Torus' ring, HydrogenOrbital and
   * Buckyball (0.5), strength of the charges (0.2), radius of Torus' tube (0.2), semi-axes of Ellipsoid (0.4, 0.4, 0.8), axis of Cylinder, Torus and LinearRamp
   * (0, 0, 1; of any length above 0).
   */
  vtkGetMacro(Radius, double);
  vtkSetClampMacro(Radius, double, 1.0e-30, 1.0e30);
  vtkGetMacro(Strength, double);
  vtkSetClampMacro(Strength, double, 1.0e-30, 1.0e30);
  vtkGetMacro(MinorRadius, double);
  vtkSetClampMacro(MinorRadius, double, 1.0e-30, 1.0e30);
  vtkGetVector3Macro(SemiAxes, double);
  void SetSemiAxes(double x, double y, double z);
  vtkGetVector3Macro(Axis, double);
  vtkSetVector3Macro(Axis, double);
  ///@}

  ///@{
  /**
   * Noise of NoisyHomogeneous: its largest deviation from one half, in [0, 0.5], default 0.05, and the
   * distance between its random values in world units, above 0, default 1/32.
   */
  vtkGetMacro(NoiseAmplitude, double);
  vtkSetClampMacro(NoiseAmplitude, double, 0.0, 0.5);
  vtkGetMacro(NoiseCellSize, double);
  vtkSetClampMacro(NoiseCellSize, double, 1.0e-12, 1.0e30);
  ///@}

  ///@{
  /**
   * Chooses the random numbers of NoisyHomogeneous and VortexTubes. The same seed gives the same
   * field on every machine. Default 1.
   */
  vtkGetMacro(Seed, int);
  vtkSetMacro(Seed, int);
  ///@}

protected:
  vtkAnalyticVolumeSource();
  ~vtkAnalyticVolumeSource() override = default;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkAnalyticVolumeSource(const vtkAnalyticVolumeSource&) = delete;
  void operator=(const vtkAnalyticVolumeSource&) = delete;

  int Field = MarschnerLobb;
  int Dimensions[3] = { 64, 64, 64 };
  double Bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  int OutputScalarType = VTK_FLOAT;
  double Radius = 0.5;
  double Strength = 0.2;
  double MinorRadius = 0.2;
  double SemiAxes[3] = { 0.4, 0.4, 0.8 };
  double Axis[3] = { 0.0, 0.0, 1.0 };
  double NoiseAmplitude = 0.05;
  double NoiseCellSize = 1.0 / 32.0;
  int Seed = 1;
};

#endif
