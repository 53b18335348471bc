// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkOpticsVolumeRepresentation
 * @brief ParaView's volume representation of image data, with the optical models of this module.
 *
 * With the defaults the picture is that of the representation Volume. The setters are those of
 * vtkOpticsVolumeProperty and vtkOpticsVolumeMapper, for the server manager (VolumeRepresentation.xml): see
 * there for meaning, range and default. A new one takes a line here, a line in the source, and a property in
 * the XML.
 */

#ifndef vtkOpticsVolumeRepresentation_h
#define vtkOpticsVolumeRepresentation_h

#include "vtkImageVolumeRepresentation.h"
#include "vtkVolumeOpticsParaViewModule.h" // for export macro

#include <memory> // for the lighting

class vtkOpticsMultiBlockVolumeMapper;
class vtkOpticsVolumeProperty;

class VTKVOLUMEOPTICSPARAVIEW_EXPORT vtkOpticsVolumeRepresentation : public vtkImageVolumeRepresentation
{
public:
  static vtkOpticsVolumeRepresentation* New();
  vtkTypeMacro(vtkOpticsVolumeRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Surface highlights: vtkOpticsVolumeProperty, sizes and scales each for the model of their name.
   */
  void SetReflectanceModel(int model);
  void SetBlinnPhongExponent(double exponent);
  void SetWardRoughness(double roughness);
  void SetLafortuneExponent(double exponent);
  void SetWardAnisotropyScale(double scale);
  void SetLafortuneAnisotropyScale(double scale);
  void SetSpecularFromExtinction(bool on);
  void SetFrameSource(int source);
  void SetPhaseAnisotropy(double anisotropy);
  ///@}

  ///@{
  /**
   * Integration: vtkOpticsVolumeProperty. The colour of an isosurface is that of the colour function.
   */
  void SetIntegrationSpace(int space);
  void SetClassification(int classification);
  void SetScalarOpacityUnitInterval(double interval);
  void SetSilhouette(int silhouette);
  void SetTransmittedLight(int light);
  void RemoveAllOpticsIsosurfaces();
  void AddOpticsIsosurface(double value, double opacity);
  ///@}

  ///@{
  /**
   * Lighting transfer function: the boundaries of the table, and those of a file (JSON of
   * vtkLightingTransferFunction); none of both is none. A file of rules is of vtkMultiSampleClassification.
   */
  void SetUseLightingTransferFunction(bool use);
  void RemoveAllLightingBoundaries();
  void AddLightingBoundary(double lowA, double highA, double lowB, double highB, double softness,
    double ambient, double diffuse, double specular);
  void SetLightingFile(const char* name);
  void SetMultiSampleFile(const char* name);
  void SetGradientStepLength(double length);
  void SetLightScale(double scale);
  void SetHybridNormals(bool on);
  ///@}

  ///@{
  /**
   * Occlusion and shadows: vtkOpticsVolumeProperty.
   */
  void SetOcclusion(bool on);
  void SetOcclusionAngle(double degrees);
  void SetAmbientColor(double red, double green, double blue);
  void SetShadows(bool on);
  void SetShadowAngle(double degrees);
  ///@}

  ///@{
  /**
   * Voxels of lines: vtkOpticsVolumeMapper, the scales for lines of all types.
   */
  void SetLineRadiusScale(double scale);
  void SetLineOpacityScale(double scale);
  ///@}

  ///@{
  /**
   * Quality: vtkOpticsVolumeMapper and its vtkAmbientCovarianceFilter. What a preset holds counts while
   * Quality is Custom.
   */
  void SetQuality(int quality);
  void SetFrameResolutionFactor(double factor);
  void SetFramePrecision(int bits);
  void SetCovarianceSamples(int samples);
  void SetCovarianceSmoothing(double standardDeviation);
  void SetCovarianceRadius(double radius);
  void SetCovarianceTolerance(double tolerance);
  void SetExtinctionGradient(int gradient);
  void SetScalarGradient(int gradient);
  void SetLightingSamples(int samples);
  void SetLightingTableSize(int size);
  void SetPreIntegrationTableSize(int size);
  void SetTablePrecision(int bits);
  void SetVisibilityGridSize(int froxels);
  void SetVisibilitySamples(int directions);
  void SetVisibilityGatherSamples(int samples);
  void SetVisibilityPrecision(int bits);
  void SetVisibilityAlgorithm(int algorithm);
  void SetVisibilityDiskSize(int size);
  void SetVisibilityTrueDistances(bool on);
  void SetVisibilitySliceDistance(double froxels);
  void SetSkipEmptySpace(bool on);
  void SetMacrocellSize(int voxels);
  void SetLinePrecision(int bits);
  ///@}

protected:
  vtkOpticsVolumeRepresentation();
  ~vtkOpticsVolumeRepresentation() override;

  bool AddToView(vtkView* view) override;
  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void UpdateMapperParameters() override;

private:
  vtkOpticsVolumeRepresentation(const vtkOpticsVolumeRepresentation&) = delete;
  void operator=(const vtkOpticsVolumeRepresentation&) = delete;

  vtkOpticsMultiBlockVolumeMapper* GetBlocks();
  vtkOpticsVolumeProperty* GetOptics();
  void UpdateLightingTransferFunction();
  void UpdateMultiSampleClassification();

  struct Lighting;
  std::unique_ptr<Lighting> Light;
  int GhostLayers = 1; // that a piece is asked for
};

#endif
