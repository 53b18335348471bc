// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkOpticsVolumeMapper
 * @brief VTK's GPU ray caster with the optical models of vtkOpticsVolumeProperty.
 *
 * Use it as vtkGPUVolumeRayCastMapper. The optical models come from the volume's property if that is
 * a vtkOpticsVolumeProperty, else from SetOptics(). Only what the property asks for is added to the
 * shader, bound as a texture or computed; where it asks for nothing the picture is VTK's own, byte
 * for byte. What a model does not support (see docs/support.md) it says once, and leaves VTK's own
 * picture.
 *
 * Models that need normals and tangent frames take them from the connected inputs, else from point
 * arrays "Normals", "GradientMagnitude" and "AmbientCovariance" of the volume, else the mapper
 * computes them with vtkSobelNormalFilter and vtkAmbientCovarianceFilter (or
 * vtkPrincipalCurvatureFilter), once for a data set, and invokes
 * vtkCommand::VolumeMapperComputeGradientsStartEvent, ProgressEvent (call data: double in [0, 1]) and
 * EndEvent around it. While the user interacts, it is content with a coarse estimate; aborting the
 * render aborts it.
 *
 * A number outside its range is set to the nearest one of the range.
 *
 * Source: [Ament2015], see Module/References.md.
 *
 * @sa vtkOpticsVolumeProperty
 */

#ifndef vtkOpticsVolumeMapper_h
#define vtkOpticsVolumeMapper_h

#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkSmartPointer.h"       // for the lines' opacity function
#include "vtkVolumeOpticsModule.h" // for export macro

#include <functional> // for what is drawn
#include <map>        // for the lines' scales
#include <memory>     // for the implementation
#include <string>     // for the active terms

class vtkAlgorithmOutput;
class vtkAmbientCovarianceFilter;
class vtkImageData;
class vtkOpticsVolumeProperty;
class vtkPiecewiseFunction;
class vtkPrincipalCurvatureFilter;
class vtkSobelNormalFilter;
class vtkTextureObject;
class vtkVisibilitySweep;
class vtkVolumeProperty;

class VTKVOLUMEOPTICS_EXPORT vtkOpticsVolumeMapper : public vtkOpenGLGPUVolumeRayCastMapper
{
public:
  static vtkOpticsVolumeMapper* New();
  vtkTypeMacro(vtkOpticsVolumeMapper, vtkOpenGLGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Optical models for volumes whose property is a plain vtkVolumeProperty (that of a host program,
   * say): of this one only what vtkOpticsVolumeProperty adds is read, the transfer functions, Shade
   * and coefficients remain the volume's. Default none.
   */
  void SetOptics(vtkOpticsVolumeProperty* optics);
  vtkOpticsVolumeProperty* GetOptics();
  ///@}

  ///@{
  /**
   * Whether vtkGPUVolumeRayCastMapper::New(), also inside vtkSmartVolumeMapper, gives this mapper.
   * Default off.
   */
  static void SetGlobalOverride(bool enabled);
  static bool GetGlobalOverride();
  ///@}

  ///@{
  /**
   * The optics of volumes whose property is a plain vtkVolumeProperty and whose mapper was given
   * none. Default null: VTK's own model.
   */
  static void SetDefaultOptics(vtkOpticsVolumeProperty* property);
  static vtkOpticsVolumeProperty* GetDefaultOptics();
  ///@}

  ///@{
  /**
   * Normals computed elsewhere: an image with float point arrays "Normals" (3 components, unit, world
   * axes) and "GradientMagnitude" (per world length). Default none. Without an anisotropy input the
   * covariance is computed from these normals; they lie on the volume's grid then, or on that of a
   * lower ResolutionFactor of the filters. The frame source Curvature has normals of its own.
   */
  void SetNormalsInputConnection(vtkAlgorithmOutput* output);
  void SetNormalsInputData(vtkImageData* normals);
  ///@}

  ///@{
  /**
   * Tangent frames computed elsewhere: an image with a float point array "AmbientCovariance" on the
   * grid of the normals. Default none. Where connected normals or frames are not as said here, the
   * mapper warns once and computes both itself.
   */
  void SetAnisotropyInputConnection(vtkAlgorithmOutput* output);
  void SetAnisotropyInputData(vtkImageData* anisotropy);
  ///@}

  ///@{
  /**
   * The filters that the mapper runs itself; set their parameters (radius, samples, ...) here. Their
   * inputs, components and resolution factors are the mapper's.
   */
  vtkSobelNormalFilter* GetSobelNormalFilter();
  vtkAmbientCovarianceFilter* GetAmbientCovarianceFilter();
  vtkPrincipalCurvatureFilter* GetPrincipalCurvatureFilter();
  ///@}

  ///@{
  /**
   * Voxels of the grid of normals and frames per voxel of the volume on each axis, in [0.0625, 1].
   * Default 1. Less takes less time and memory (to the third power). Lowered, with one message, where
   * normals and frames would exceed MaxMemoryInBytes * MaxMemoryFraction.
   */
  vtkGetMacro(FrameResolutionFactor, double);
  void SetFrameResolutionFactor(double factor);
  ///@}

  ///@{
  /**
   * Bits of each number of the normals and frames on the GPU: 8, 16 or 32 (float). Default 8. Other
   * numbers are refused with a warning.
   */
  vtkGetMacro(FramePrecision, int);
  void SetFramePrecision(int bits);
  ///@}

  ///@{
  /**
   * How the gradient of the classified extinction is found: along the stored normal, by two look-ups
   * in the opacity table; or by central differences of the classified opacity, six fetches of the
   * volume more. Opacities that depend on more than the scalar (gradient opacity, 2D transfer
   * functions) take central differences in any case. Default Stored.
   */
  enum GradientType
  {
    Stored = 0,
    CentralDifferences,
    Automatic // of ScalarGradient alone
  };
  vtkGetMacro(ExtinctionGradient, int);
  vtkSetClampMacro(ExtinctionGradient, int, Stored, CentralDifferences);
  void SetExtinctionGradientToStored() { this->SetExtinctionGradient(Stored); }
  void SetExtinctionGradientToCentralDifferences() { this->SetExtinctionGradient(CentralDifferences); }
  const char* GetExtinctionGradientAsString();
  ///@}

  ///@{
  /**
   * How the gradient of the scalar itself is found, where a scene needs it (lighting transfer functions,
   * classification by several samples, silhouettes, transmitted light): by central differences, six
   * fetches of the volume for each sample, VTK's own gradient; or as the stored normal, one fetch after
   * vtkSobelNormalFilter has run. Automatic, the default: Stored where a lighting transfer function or a
   * classification by several samples looks along the gradient, which then is the one that
   * vtkGradientAlignedHistogram counts with, so that what is chosen in a histogram is what is lit; else
   * CentralDifferences.
   */
  vtkGetMacro(ScalarGradient, int);
  vtkSetClampMacro(ScalarGradient, int, Stored, Automatic);
  void SetScalarGradientToStored() { this->SetScalarGradient(Stored); }
  void SetScalarGradientToCentralDifferences() { this->SetScalarGradient(CentralDifferences); }
  void SetScalarGradientToAutomatic() { this->SetScalarGradient(Automatic); }
  const char* GetScalarGradientAsString();
  ///@}

  ///@{
  /**
   * Points on each axis of the table of a lighting transfer function, over the range of the scalars;
   * in [1, 4096]. Default 256. The GPU holds the square of it, four numbers each.
   */
  vtkGetMacro(LightingTableSize, int);
  vtkSetClampMacro(LightingTableSize, int, 1, 4096);
  ///@}

  ///@{
  /**
   * Entries per axis of the table of Classification PreIntegrated, in [2, 4096]. Default 256. The table is
   * rebuilt when a transfer function or the range of the data changes.
   */
  vtkGetMacro(PreIntegrationTableSize, int);
  void SetPreIntegrationTableSize(int size);
  ///@}

  ///@{
  /**
   * Bits of each number of transfer functions' tables on the GPU: 16 or 32 (float). Default 32. Other
   * numbers are refused with a warning.
   */
  vtkGetMacro(TablePrecision, int);
  void SetTablePrecision(int bits);
  ///@}

  ///@{
  /**
   * Where a lighting transfer function and a classification by several samples take the scalars on both
   * sides of a sample from: two fetches of
   * the volume along the gradient (Fetched); or as if the scalar were linear there, from the gradient's
   * magnitude, by no fetch of its own (Extrapolated). Default Fetched.
   */
  enum LightingSamplesType
  {
    Fetched = 0,
    Extrapolated
  };
  vtkGetMacro(LightingSamples, int);
  vtkSetClampMacro(LightingSamples, int, Fetched, Extrapolated);
  void SetLightingSamplesToFetched() { this->SetLightingSamples(Fetched); }
  void SetLightingSamplesToExtrapolated() { this->SetLightingSamples(Extrapolated); }
  const char* GetLightingSamplesAsString();
  ///@}

  ///@{
  /**
   * Cells (froxels) on the longer side of the grid on which occlusion and shadows are found, in [1, 2048].
   * Default 128. The grid has the shape of what the camera (or a light) sees of the volume.
   */
  vtkGetMacro(VisibilityGridSize, int);
  void SetVisibilityGridSize(int froxels);
  ///@}

  ///@{
  /**
   * Distance of the grid's slices, in sides of a froxel half-way through the volume; in [0.1, 10]. Default 1.
   */
  vtkGetMacro(VisibilitySliceDistance, double);
  void SetVisibilitySliceDistance(double froxels);
  ///@}

  ///@{
  /**
   * vtkVisibilitySweep::NumberOfDirections of occlusion and of soft shadows: 4, 8 or 16. Default 8. Other
   * numbers are refused with a warning.
   */
  vtkGetMacro(VisibilitySamples, int);
  void SetVisibilitySamples(int directions);
  ///@}

  ///@{
  /**
   * vtkVisibilitySweep::Algorithm of occlusion and of soft shadows. Default DirectionSweep.
   */
  enum VisibilityAlgorithmType
  {
    DirectionSweep = 0,
    Disk,
    DiskSolidAngle
  };
  vtkGetMacro(VisibilityAlgorithm, int);
  vtkSetClampMacro(VisibilityAlgorithm, int, DirectionSweep, DiskSolidAngle);
  void SetVisibilityAlgorithmToDirectionSweep() { this->SetVisibilityAlgorithm(DirectionSweep); }
  void SetVisibilityAlgorithmToDisk() { this->SetVisibilityAlgorithm(Disk); }
  void SetVisibilityAlgorithmToDiskSolidAngle() { this->SetVisibilityAlgorithm(DiskSolidAngle); }
  const char* GetVisibilityAlgorithmAsString();
  ///@}

  ///@{
  /**
   * vtkVisibilitySweep::DiskSize and TrueDistances of the two disks; in [1, 32] and default 5, default on.
   */
  vtkGetMacro(VisibilityDiskSize, int);
  void SetVisibilityDiskSize(int size);
  vtkGetMacro(VisibilityTrueDistances, bool);
  vtkSetMacro(VisibilityTrueDistances, bool);
  vtkBooleanMacro(VisibilityTrueDistances, bool);
  ///@}

  ///@{
  /**
   * Occlusion by DirectionSweep: samples of each direction of the cone near the point that is shaded, in [0, 16],
   * before the direction is looked up in the grid (final gathering). Default 4. They lie on a way of 3.5 froxels,
   * closer to each other towards the point, and see what is thinner than a froxel. 0: what is nearer than a slice
   * is taken from the eye's ray alone, which takes an eighth of the memory (of 8 directions), less time in frames
   * without other light, and leaves half as much error again. They are left out where opacity is not a function
   * of the scalar alone, and with cropping, masks, blanked points, partitions, integration in data space,
   * pre-integration, or several samples to a classification.
   */
  vtkGetMacro(VisibilityGatherSamples, int);
  void SetVisibilityGatherSamples(int samples);
  ///@}

  ///@{
  /**
   * Bits of each number of the grid on the GPU: 8, 16 or 32 (float). Default 16. Other numbers are refused
   * with a warning.
   */
  vtkGetMacro(VisibilityPrecision, int);
  void SetVisibilityPrecision(int bits);
  ///@}

  ///@{
  /**
   * Lines as anisotropic voxels: where the input is an image of vtkAnisotropicLineVoxelizer, it is drawn as
   * lines, with any property. Factors of the radius, in [0, 1e6], and of the opacity, in [0, 1], of a line type.
   * Default 1. Neither links nor uploads anything.
   */
  void SetLineRadiusScale(int type, double scale);
  double GetLineRadiusScale(int type) const;
  void SetLineOpacityScale(int type, double scale);
  double GetLineOpacityScale(int type) const;
  ///@}

  ///@{
  /**
   * Maps the evaluated opacity of voxels of lines, in [0, 1], to the one that is drawn. Default none: as it is.
   */
  void SetLineOpacityFunction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetLineOpacityFunction() const;
  ///@}

  ///@{
  /**
   * Voxels of other lines, or finer ones of the same, that replace those of the input in their box, which lies within
   * that of the input. Default none. Source: [Schussman2004] fig. 7.
   */
  void SetLineBlockInputConnection(vtkAlgorithmOutput* output);
  void SetLineBlockInputData(vtkImageData* voxels);
  vtkImageData* GetLineBlock();
  ///@}

  ///@{
  /**
   * Bits of each number of voxels of lines on the GPU: 8, 16 or 32 (float). Of 8 bits a coefficient is good to a 254th of
   * the largest one of its voxel from degree 1 on; degree 0 and what is evaluated keep 16. Default 16. Other
   * numbers are refused with a warning.
   */
  vtkGetMacro(LinePrecision, int);
  void SetLinePrecision(int bits);
  ///@}

  ///@{
  /**
   * Whether rays and sweeps skip what has no opacity. The picture does not change. Served by a grid of the scalars' ranges
   * (vtkMacrocellGrid), found once for the scalars, and used only where enough of the volume is empty; scenes
   * that it does not support (docs/support.md) are drawn without. Default on.
   */
  vtkSetMacro(SkipEmptySpace, bool);
  vtkGetMacro(SkipEmptySpace, bool);
  vtkBooleanMacro(SkipEmptySpace, bool);
  ///@}

  ///@{
  /**
   * Voxels of a cell of that grid on each axis, in [2, 64], or 0: automatic, of which
   * vtkMacrocellGrid::FindCellSize() tells. Default 0.
   */
  void SetMacrocellSize(int voxels);
  vtkGetMacro(MacrocellSize, int);
  ///@}

  ///@{
  /**
   * A piece of a larger volume, whose other pieces other mappers draw: the extent of it that is drawn, so that
   * ghost layers of the input beyond it serve gradients and whatever else looks around a sample; and the extent of the
   * whole, so that the samples are those of a ray through the whole. Default both empty (0, -1, ...): all of the input,
   * and nothing more. For vtkImageData; partitions of VTK's mapper are drawn whole.
   */
  vtkSetVector6Macro(DrawnExtent, int);
  vtkGetVector6Macro(DrawnExtent, int);
  vtkSetVector6Macro(WholeExtent, int);
  vtkGetVector6Macro(WholeExtent, int);
  ///@}

  /**
   * Layers of voxels around a piece that the optics of this mapper look at with a volume's property: as many ghost
   * layers of the input make the piece's picture that of the whole. Occlusion and shadows reach farther.
   */
  int GetGhostLayers(vtkVolumeProperty* property);

  ///@{
  /**
   * Presets of the knobs above, of the filters' and of the sample distance: points on the measured
   * curves of time against error (docs/accuracy.md). Custom, the default, leaves them as they are,
   * VTK's sample distance included; setting a knob after a preset keeps the others. The presets' steps
   * are 1, 1/2 and 1/4 of the image's smallest spacing; a scale by the volume's matrix does not count.
   * While the user interacts (the window's DesiredUpdateRate is above the interactor's still rate, or at least
   * 1 without an interactor), steps and the cells of VisibilityGridSize are one, two or four times as
   * long: the finest that the last frame's time lets fit into the volume's AllocatedRenderTime. No
   * shader program is linked for it.
   */
  enum QualityType
  {
    Custom = 0,
    Draft,
    Balanced,
    Reference
  };
  vtkGetMacro(Quality, int);
  void SetQuality(int quality);
  void SetQualityToCustom() { this->SetQuality(Custom); }
  void SetQualityToDraft() { this->SetQuality(Draft); }
  void SetQualityToBalanced() { this->SetQuality(Balanced); }
  void SetQualityToReference() { this->SetQuality(Reference); }
  const char* GetQualityAsString();
  ///@}

  /**
   * VTK's sample distance. With a preset of Quality set before, it replaces the preset's own.
   */
  void SetSampleDistance(float distance) override;

  /**
   * The sweep from the eye that Occlusion is found by: for what it counts and says of the last frame. Its
   * parameters are the mapper's and the property's.
   */
  vtkVisibilitySweep* GetOcclusionSweep();

  /**
   * Sweeps from the lights that cast Shadows now: one for each view of a light (six of one in the volume), and
   * again when something has changed that the shadow depends on. For inspection and tests.
   */
  int GetShadowSweepCount();

  /** Names of the terms in the last frame, separated by commas; empty: VTK's own picture. */
  std::string GetActiveTerms();

  /** Textures that the terms hold, in KiB. */
  unsigned long GetTermMemorySize();

  /** Shader programs that frames with active terms were drawn with, each linked once. */
  int GetProgramLinkCount();

  /** Fragment shader composed last with active terms; empty before. For inspection and tests. */
  std::string GetFragmentShader();

  /**
   * Draws the volume; where it has no scalars, one error tells what to do. Where somebody observes
   * AbortCheckEvent of the window, he is asked between parts of the frame: slices of a sweep, blocks of a
   * volume in several blocks, else sixteen tiles of the picture. After SetAbortRender() of the window the
   * rest of the frame is left as it is, and the next frame is whole. In one part are picking, RenderToImage, depth
   * passes and image sample distances other than 1, and the parts of frames of several volumes with
   * adjusted sample distances.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  using Superclass::GetAverageIPScalarRange;
  /** As VTK's. VTK asks for it last of all before it draws a block of the volume: so the terms learn of it. */
  void GetAverageIPScalarRange(double range[2]) override;

#ifndef __VTK_WRAP__
  // For the terms.
  void Say(const std::string& message); // as a warning, once
  bool IsInteractive(vtkRenderer* renderer);
  int GetCoarseness() const
  {
    return this->Coarseness;
  } // 1, 2 or 4 times as coarse as the preset
  void GetLoadedScalarRange(int component, double range[2]);
  bool HasPartitions();                             // of the loaded volume
  double GetFrameSampleDistance(vtkVolume* volume); // whatever VTK adjusts it to
  int GetNumberOfBlocks();
  vtkTextureObject* GetVolumeTexture();                  // of the block that is drawn next
  void GetTextureToData(double matrix[16]);              // of its coordinates, row by row
  bool FindVisibleBox(double box[6]);                    // in those coordinates, where it is known
  void GetTextureBox(float least[3], float greatest[3]); // of the input's first and last point
#endif

protected:
  vtkOpticsVolumeMapper();
  ~vtkOpticsVolumeMapper() override;

  void GPURender(vtkRenderer* renderer, vtkVolume* volume) override;

private:
  vtkOpticsVolumeMapper(const vtkOpticsVolumeMapper&) = delete;
  void operator=(const vtkOpticsVolumeMapper&) = delete;

  void UpdateCoarseness(vtkRenderer* renderer, vtkVolume* volume);
  void UpdateSampleDistance();
  void Draw(vtkRenderer* renderer, vtkVolume* volume, bool hasLines);
  void DrawBySteps(
    vtkRenderer* renderer, vtkVolume* volume, bool hasLines, const std::function<void()>& draw);
  void DrawInParts(vtkRenderer* renderer, vtkVolume* volume);
  void GetVoxelSpacing(double spacing[3]);
  std::string FindMissing();

  double FrameResolutionFactor = 1.0;
  double StepInVoxels = 0.0; // of a preset; 0: the user's or VTK's
  int FramePrecision = 8;
  int ExtinctionGradient = Stored;
  int ScalarGradient = Automatic;
  int LightingTableSize = 256;
  int LightingSamples = Fetched;
  int PreIntegrationTableSize = 256;
  int VisibilityGridSize = 128;
  double VisibilitySliceDistance = 1.0;
  int VisibilitySamples = 8;
  int VisibilityAlgorithm = DirectionSweep;
  int VisibilityDiskSize = 5;
  bool VisibilityTrueDistances = true;
  int VisibilityGatherSamples = 4;
  int VisibilityPrecision = 16;
  int TablePrecision = 32;
  int LinePrecision = 16;
  std::map<int, double> LineRadiusScales, LineOpacityScales;
  vtkSmartPointer<vtkPiecewiseFunction> LineOpacityFunction;
  int Quality = Custom;
  int Coarseness = 1;
  int LastCoarseness = 2; // while the user interacts
  bool SkipEmptySpace = true;
  int MacrocellSize = 0;
  int DrawnExtent[6] = { 0, -1, 0, -1, 0, -1 };
  int WholeExtent[6] = { 0, -1, 0, -1, 0, -1 };

  class Implementation;
  std::unique_ptr<Implementation> Terms;
};

#endif
