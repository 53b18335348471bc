// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkAnisotropicVoxelEvaluator
 * @brief The colours and opacities of anisotropic voxels as a camera sees them: RGBA for any volume mapper.
 *
 * Input: the voxels of vtkAnisotropicLineVoxelizer. Output: a vtkImageData with a point in the middle of each
 * voxel and the point scalars RGBA, of four components. Colour is not multiplied by opacity; it is
 * spread into empty voxels beside occupied ones, so that a mapper's interpolation makes no dark rim.
 *
 * With the output, a mapper needs a property with dependent components and, for component 3, the opacity's, a
 * ScalarOpacityUnitDistance of OpacityLength times 4 V/S, V and S the volume and surface of a voxel: then a ray is
 * stopped in a voxel by the share of its mean cross section that lines cover. VTK's GPU mapper builds
 * its table of opacities over the range that occurs in the data and looks into it with values that
 * are a share of the type's range: opacities are wrong unless the two are the same. Either the mapper's
 * ScalarOpacityRangeType is NATIVE, or MarkOpacityRange makes them the same. SetUpVolume() sets all this.
 *
 * An aligned bundle has no visible area end-on, but a truncated series leaves some. The optical depth
 * is therefore kept within the bounds that degrees 0 and 2 imply; colour is kept within the range of the
 * material under its lights.
 *
 * Runs on all threads, reports progress and looks for AbortExecute; an aborted filter has an empty output. The
 * filter is out of date whenever the camera has moved.
 */

#ifndef vtkAnisotropicVoxelEvaluator_h
#define vtkAnisotropicVoxelEvaluator_h

#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h"       // for camera and function
#include "vtkVolumeOpticsModule.h" // for export macro

#include <map>    // for the scales
#include <memory> // for the cropping

class vtkCamera;
class vtkLightCollection;
class vtkPiecewiseFunction;
class vtkVolume;
class vtkVolumeMapper;

namespace volumeoptics
{
class BlockCropping;
}

class VTKVOLUMEOPTICS_EXPORT vtkAnisotropicVoxelEvaluator : public vtkImageAlgorithm
{
public:
  static vtkAnisotropicVoxelEvaluator* New();
  vtkTypeMacro(vtkAnisotropicVoxelEvaluator, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The camera, in the coordinates of the voxels; required. Its position counts in perspective, its
   * direction in parallel projection.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera() const;
  ///@}

  ///@{
  /**
   * View directions in perspective. PerVoxel: each voxel's own. PerBlock: one for each brick of 8 x 8 x 8
   * voxels, as [Schussman2004] section 6. Default PerVoxel.
   */
  enum ViewDirectionsType
  {
    PerVoxel = 0,
    PerBlock
  };
  void SetViewDirections(int directions);
  vtkGetMacro(ViewDirections, int);
  void SetViewDirectionsToPerVoxel() { this->SetViewDirections(PerVoxel); }
  void SetViewDirectionsToPerBlock() { this->SetViewDirections(PerBlock); }
  const char* GetViewDirectionsAsString() const;
  ///@}

  ///@{
  /**
   * Factor of the radius of a line type, in [0, 1e6]; exact, since the area is proportional to it.
   * 0 hides the type. Default 1.
   */
  void SetRadiusScale(int type, double scale);
  double GetRadiusScale(int type) const;
  ///@}

  ///@{
  /**
   * Factor of the opacity of a line type, in [0, 1]. Default 1.
   */
  void SetOpacityScale(int type, double scale);
  double GetOpacityScale(int type) const;
  ///@}

  ///@{
  /**
   * Maps the evaluated opacity, in [0, 1], to the one that is drawn. Default none: as it is.
   */
  void SetOpacityFunction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetOpacityFunction() const;
  ///@}

  ///@{
  /**
   * VTK_UNSIGNED_CHAR or VTK_UNSIGNED_SHORT (the default): 0 to the type's largest value stand for [0, 1];
   * or VTK_FLOAT. Bytes are what vtkFixedPointVolumeRayCastMapper can draw; they lose opacities below 1/510.
   */
  void SetOutputScalarType(int type);
  vtkGetMacro(OutputScalarType, int);
  ///@}

  ///@{
  /**
   * The length whose opacity the output's fourth component is, as a share of the mean chord 4 V/S of a voxel, in
   * [1/256, 1]. A mapper interpolates opacities; those of a short length are proportional to extinction,
   * of which nothing is lost then between a voxel and an empty one. Bytes are too coarse for it: they always hold the
   * opacity of the whole chord. Default 1/4.
   */
  void SetOpacityLength(double share);
  vtkGetMacro(OpacityLength, double);
  ///@}

  /**
   * 4 V/S of the voxels of an image, in world units; 0 if it holds none. Times OpacityLength (bytes: 1) it is the
   * ScalarOpacityUnitDistance of the output.
   */
  static double GetScalarOpacityUnitDistance(vtkImageData* voxels);

  ///@{
  /**
   * Makes the most opaque voxel opaque, so that the range of opacities in the data is the type's, for
   * mappers whose ScalarOpacityRangeType cannot be set, as vtkSmartVolumeMapper. Default on.
   */
  vtkSetMacro(MarkOpacityRange, bool);
  vtkGetMacro(MarkOpacityRange, bool);
  vtkBooleanMacro(MarkOpacityRange, bool);
  ///@}

  /**
   * Sets what a volume needs to draw the output. Its property: dependent components, linear
   * interpolation, no shading, opacity as it is, and the ScalarOpacityUnitDistance of the input, which is
   * brought up to date. Its mapper, set before: the native range where it is a GPU mapper, and then
   * MarkOpacityRange off, as where it draws on the CPU, which takes bytes; otherwise on. Call again for other voxels, and when
   * OpacityLength or OutputScalarType have changed.
   */
  void SetUpVolume(vtkVolume* volume);

  /**
   * Lets a block of other voxels, finer ones of the same lines for example, take the place of a part of these
   * [Schussman2004] fig. 7. The block has an evaluator, a mapper and a volume of its own. The output of this
   * evaluator is drawn by two mappers, which are cropped here, one to what lies behind the block and one to what
   * lies in front of it; a renderer draws volumes in the order in which they are added: first behind, then the
   * block, then inFront. Cropping follows the camera. block: the voxels, along the same axes. Null, for any of the
   * three, undoes it.
   */
  void CropAroundBlock(vtkImageData* block, vtkVolumeMapper* behind, vtkVolumeMapper* inFront);

  /**
   * Whether lights, for example a renderer's, are those that are baked into the voxels, as far as these are up to
   * date; if not, warns, once until they are again.
   */
  bool CheckLights(vtkLightCollection* lights);

  vtkMTimeType GetMTime() override;

protected:
  vtkAnisotropicVoxelEvaluator();
  ~vtkAnisotropicVoxelEvaluator() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkAnisotropicVoxelEvaluator(const vtkAnisotropicVoxelEvaluator&) = delete;
  void operator=(const vtkAnisotropicVoxelEvaluator&) = delete;

  double GetOutputOpacityLength() const;
  void SetScale(std::map<int, double>& scales, const char* name, int type, double scale, double largest);

  vtkSmartPointer<vtkCamera> Camera;
  int ViewDirections = PerVoxel;
  std::map<int, double> RadiusScales, OpacityScales;
  vtkSmartPointer<vtkPiecewiseFunction> OpacityFunction;
  std::unique_ptr<volumeoptics::BlockCropping> Cropping;
  bool MarkOpacityRange = true;
  bool HasWarnedOfLights = false;
  int OutputScalarType = VTK_UNSIGNED_SHORT;
  double OpacityLength = 0.25;
};

#endif
