// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkVisibilitySweep
 * @brief How much of a cone of directions a volume leaves open, everywhere in it.
 *
 * Fractional visibility is the mean, over the solid angle of a cone about the direction to an eye or to a
 * light, of the transmittance from a point out of the volume. The sweep finds it on a grid of cells
 * (froxels), slice by slice from the viewer on, on the GPU: what is hidden behind a slice depends on what was
 * hidden behind the one before. vtkOpticsVolumeMapper sweeps once a frame from the eye for
 * vtkOpticsVolumeProperty::Occlusion, and from each light for Shadows, by its own parameters of the same
 * names; this class need not be used to have either.
 *
 * The cone's axis is the normal of the slices, of a camera its direction of projection; or, in perspective,
 * the line to the viewer (SetViewerDistance()).
 *
 * Source: [Schott2009] sections 3.2 to 3.4; the sweep along fixed directions is this module's own.
 *
 * @sa vtkOpticsVolumeMapper, vtkOpticsVolumeProperty
 */

#ifndef vtkVisibilitySweep_h
#define vtkVisibilitySweep_h

#include "vtkObject.h"
#include "vtkVolumeOpticsModule.h" // for export macro

#include <memory> // for the implementation
#include <string> // for the fragment shader
#ifndef __VTK_WRAP__
#include <utility> // for what has a time
#include <vector>  // for what has a time
#endif

class SweepGrid;
struct SweepRectangle;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class VTKVOLUMEOPTICS_EXPORT vtkVisibilitySweep : public vtkObject
{
public:
  static vtkVisibilitySweep* New();
  vtkTypeMacro(vtkVisibilitySweep, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Half of the cone's opening angle, in degrees; in [0, 80]. Default 60. 0: the axis alone.
   */
  vtkGetMacro(ConeAngle, double);
  void SetConeAngle(double degrees);
  ///@}

  ///@{
  /**
   * DirectionSweep, the default, follows NumberOfDirections fixed directions of equal solid angle. Disk is
   * the recursion of the paper, which takes the mean over a disk of the slice before and over each disk
   * counts its points evenly; DiskSolidAngle counts them by their solid angle. Neither disk converges to
   * the mean over the cone: they are here to compare with.
   */
  enum AlgorithmType
  {
    DirectionSweep = 0,
    Disk,
    DiskSolidAngle
  };
  vtkGetMacro(Algorithm, int);
  void SetAlgorithm(int algorithm);
  void SetAlgorithmToDirectionSweep() { this->SetAlgorithm(DirectionSweep); }
  void SetAlgorithmToDisk() { this->SetAlgorithm(Disk); }
  void SetAlgorithmToDiskSolidAngle() { this->SetAlgorithm(DiskSolidAngle); }
  const char* GetAlgorithmAsString();
  ///@}

  ///@{
  /**
   * Directions of the cone: 1, 4, 8 or 16. Default 8. Other numbers are refused with a warning.
   */
  vtkGetMacro(NumberOfDirections, int);
  void SetNumberOfDirections(int directions);
  ///@}

  ///@{
  /**
   * Points along each side of the square around the disk, in [1, 32]. Default 5. [Schott2009] section 3.4.
   */
  vtkGetMacro(DiskSize, int);
  void SetDiskSize(int size);
  ///@}

  ///@{
  /**
   * Whether the disk's points have their own distance to the slice behind (Algorithm 2 of the paper), or all
   * that of the axis (Algorithm 3, which lets more light through). Default on.
   */
  vtkGetMacro(TrueDistances, bool);
  vtkSetMacro(TrueDistances, bool);
  vtkBooleanMacro(TrueDistances, bool);
  ///@}

  ///@{
  /**
   * Bits of each number on the GPU: 8, 16 or 32 (float). Default 16. Other numbers are refused with a
   * warning.
   */
  vtkGetMacro(Precision, int);
  void SetPrecision(int bits);
  ///@}

  ///@{
  /**
   * DirectionSweep in perspective: above 0, in world length, rays end on a disk at the viewer that appears
   * under the cone's angle from this distance, as those to a lamp do. 0, the default: the cone's axis is the
   * normal of the slices.
   */
  vtkGetMacro(ViewerDistance, double);
  void SetViewerDistance(double distance);
  ///@}

  ///@{
  /**
   * DirectionSweep: the texture holds what reaches the middle of each froxel by each direction, four directions to
   * a texel and each next four behind all slices, for rays that begin there (final gathering); and in perspective
   * the cone's axis is the direction to the viewer. Default off: the texture holds the mean over the cone of what
   * reaches the front of each slice.
   */
  vtkGetMacro(KeepDirections, bool);
  vtkSetMacro(KeepDirections, bool);
  vtkBooleanMacro(KeepDirections, bool);
  ///@}

  /** Sweeps done. A sweep of what was swept last is not done again. */
  vtkGetMacro(SweepCount, int);

  /** Shader programs linked, and the fragment shader of the last one; for inspection and tests. */
  int GetProgramLinkCount();
  std::string GetFragmentShader();

  /** Part of the froxels that the last sweep had to draw, in [0, 1]. */
  vtkGetMacro(DrawnFraction, double);

  /** Froxels on the x and y axis, and slices, of the last grid. */
  vtkGetVector3Macro(GridSize, int);

  void ReleaseGraphicsResources(vtkWindow* window);

#ifndef __VTK_WRAP__
  /** What is swept. */
  struct Volume
  {
    vtkOpenGLRenderWindow* Window;
    vtkShaderProgram* Ray;     // that is about to draw the volume, its uniforms set, its textures bound
    double TextureToWorld[16]; // of VTK's texture coordinates, row by row
    double DataToWorld[16];    // of the coordinates in which VTK measures steps
    double StepLength;         // of the ray, in those
    bool IsInBlocks;           // of which one is loaded at a time: each is filled, then all are swept
    bool FillsBlock;
    int Block;                  // how many were filled before it in this frame
    bool SkipsEmptySpace;       // what is outside of a box is not swept where that changes nothing
    double Box[24];             // its corners in world coordinates: what hides, and who looks at the sweep
    double LookAlong;           // from there; along the slices' normal, in view coordinates
    double LookAside;           // and across, in places
    vtkTextureObject* Geometry; // depth of opaque geometry, over the window of the grid; null: none
    double GeometryRange[2];    // z in view coordinates of depths 0 and 1
    std::vector<std::pair<const void*, vtkMTimeType>> Times; // of what the textures are made of
  };

  /** False, with what is bound and drawn on unchanged: the grid is empty, or it can't be done here. */
  bool Sweep(const Volume& volume, const SweepGrid& grid);

  /** What reaches the front of each slice, or see KeepDirections (SweepGrid::GetWorldToTexture); null before the
   * first sweep. */
  vtkTextureObject* GetTexture();

  /** Of the textures, in bytes. */
  std::size_t GetMemorySize() const;
#endif

protected:
  vtkVisibilitySweep();
  ~vtkVisibilitySweep() override;

private:
  vtkVisibilitySweep(const vtkVisibilitySweep&) = delete;
  void operator=(const vtkVisibilitySweep&) = delete;

  int GetNumberOfChannels() const;
  bool IsByDirection() const;
  void Draw(const Volume& volume, const SweepGrid& grid, vtkShaderProgram* program);
  void SetUniforms(const Volume& volume, const SweepGrid& grid, vtkShaderProgram* program);
  void SetConeUniforms(const Volume& volume, const SweepGrid& grid, vtkShaderProgram* program);
  void SetDirections(const double viewToData[16], double axis, vtkShaderProgram* program);
  void SetGeometry(const Volume& volume, const SweepGrid& grid, vtkShaderProgram* program);
  void SetDisk(vtkShaderProgram* program);
  bool FillBlock(const Volume& volume, const SweepGrid& grid);
  std::vector<SweepRectangle> FindRegions(const Volume& volume, const SweepGrid& grid);

  double ConeAngle = 60.0;
  int Algorithm = DirectionSweep;
  int NumberOfDirections = 8;
  int DiskSize = 5;
  bool TrueDistances = true;
  int Precision = 16;
  double ViewerDistance = 0.0;
  bool KeepDirections = false;
  int SweepCount = 0;
  double DrawnFraction = 0.0;
  int GridSize[3] = { 0, 0, 0 };

  class Implementation;
  std::unique_ptr<Implementation> Internals;
};

#endif
