// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkAnisotropicLineVoxelizer
 * @brief Turns lines into voxels whose colour and opacity depend on the direction of view.
 *
 * Each segment of a vtkPolyData's lines is a lit cylinder, thinner than a voxel. Its visible area, and
 * its mean radiance times this area, are functions of the view direction; in each voxel their sums over
 * the segments are kept as spherical harmonics [Schussman2004]. The size of the result depends on the
 * grid, not on the number of lines. Segments are clipped to the voxels: a voxel counts the length
 * that lies in it. vtkAnisotropicVoxelEvaluator makes an RGBA volume of the result for a camera.
 *
 * The output is a vtkImageData. A cell of it is a brick of voxels (8 x 8 x 8, or fewer where the grid is
 * smaller); the cell scalars BrickIndex number the occupied bricks, -1 is an empty one. The field data
 * hold SampleDimensions, BrickDimensions, MaximumOrder, LineTypes, LineLights and, of each line type n,
 * LineTypen_BrickStarts (of each occupied brick the first voxel), _Places (of each voxel in its brick),
 * _VoxelStarts (the first coefficient), _Harmonics (l (l + 1) + m), _Coefficients (three of colour times
 * optical depth, and the optical depth: visible area over a quarter of the voxel's surface) and
 * _ColorRange. Empty voxels and dropped coefficients take no memory. vtkXMLImageDataWriter saves all.
 *
 * Segments with a point, radius or type that is no finite number, or a radius of 0 and below, are
 * left out; radii above the smallest edge of a voxel count as this edge. Both are said in one
 * warning, with their numbers. Parts outside of ModelBounds are left out.
 *
 * Runs on all threads (vtkSMPTools), reports progress and looks for AbortExecute about every 30 ms; an
 * aborted filter has an empty output. The number of threads does not change a bit. Order and
 * pieces of the lines change coefficients by the rounding of float: 1e-6 of the voxel's largest for up
 * to a hundred portions of a million segments.
 *
 * Input by pieces: NumberOfPieces requests of the source are made in turn and added up, so that memory
 * holds one piece, a million clipped segments and the sums. Each piece is read once where ModelBounds
 * are set or the source names its bounds (vtkDataObject::BOUNDING_BOX()); otherwise a first pass
 * finds the bounds.
 *
 * Processes that share the lines (SetController()) each voxelize their own piece in one common box; the sums
 * of all are added up, and every process has the voxels of the whole, to the rounding of float those of one
 * process. A process may have no lines.
 *
 * Limits: the order of segments within a voxel is lost; lights are directional and do not reach other
 * lines' shadows; they are baked in.
 */

#ifndef vtkAnisotropicLineVoxelizer_h
#define vtkAnisotropicLineVoxelizer_h

#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h"       // for lights and materials
#include "vtkVolumeOpticsModule.h" // for export macro

#include <map>    // for materials
#include <memory> // for the sums
#include <set>    // for line types
#include <string> // for names of arrays

class vtkLightCollection;
class vtkMultiProcessController;
class vtkPolyData;
class vtkProperty;
class vtkScalarsToColors;

class VTKVOLUMEOPTICS_EXPORT vtkAnisotropicLineVoxelizer : public vtkImageAlgorithm
{
public:
  static vtkAnisotropicLineVoxelizer* New();
  vtkTypeMacro(vtkAnisotropicLineVoxelizer, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of voxels along each axis, in [1, 4096]. Default 128, 128, 128.
   */
  void SetSampleDimensions(int x, int y, int z);
  void SetSampleDimensions(const int dimensions[3])
  {
    this->SetSampleDimensions(dimensions[0], dimensions[1], dimensions[2]);
  }
  vtkGetVector3Macro(SampleDimensions, int);
  ///@}

  ///@{
  /**
   * The box of the voxels, from face to face, in world units: x least, x largest, y ... . Where a
   * least exceeds its largest, the default, the box of the lines' points. An axis along which that
   * has no extent gets one voxel's worth of the longest axis.
   */
  vtkSetVector6Macro(ModelBounds, double);
  vtkGetVector6Macro(ModelBounds, double);
  ///@}

  ///@{
  /**
   * Radius of the lines in world units, at least 0, where no array gives it. Below 0, the default -1:
   * a tenth of a voxel's smallest edge.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Names of arrays of the points or of the cells; none is the default. RadiusArray: world units.
   * LineTypeArray: integers in [0, 255], a segment of points takes its first one's.
   * ColorArray: bytes, or numbers in [0, 1], of three or four components; one component goes
   * through LookupTable.
   */
  void SetRadiusArray(const char* name) { this->SetName(this->RadiusArray, name); }
  const char* GetRadiusArray() const { return this->RadiusArray.c_str(); }
  void SetLineTypeArray(const char* name) { this->SetName(this->LineTypeArray, name); }
  const char* GetLineTypeArray() const { return this->LineTypeArray.c_str(); }
  void SetColorArray(const char* name) { this->SetName(this->ColorArray, name); }
  const char* GetColorArray() const { return this->ColorArray.c_str(); }
  ///@}

  ///@{
  /**
   * Maps a ColorArray of one component. Default none: a rainbow over the array's range (over each
   * piece's own, where there are pieces: give a table then).
   */
  void SetLookupTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetLookupTable() const;
  ///@}

  ///@{
  /**
   * Material of a line type: ambient, diffuse and specular coefficient and colour, specular power (of the
   * half vector's cosine, at least 1). With a ColorArray the lines' own colours replace ambient and
   * diffuse colour. Default: white, diffuse alone. Opacity is not used.
   */
  void SetMaterial(int type, vtkProperty* material);
  vtkProperty* GetMaterial(int type) const;
  ///@}

  ///@{
  /**
   * Exponent of a line type's highlight in [1, 1000], beyond vtkProperty's 128. Below 1, the
   * default 0: the material's.
   */
  void SetSpecularPower(int type, double power);
  double GetSpecularPower(int type) const;
  ///@}

  ///@{
  /**
   * Degree of the spherical harmonics, in [0, 12]. Default 4; 8 for bundles of aligned lines or
   * exponents from 32 on.
   */
  void SetMaximumOrder(int order);
  vtkGetMacro(MaximumOrder, int);
  ///@}

  ///@{
  /**
   * Lights: headlights, camera lights (fixed to the eye) and scene lights (fixed in the world), each
   * with its diffuse and specular colour and intensity. All count as directional: from the focal
   * point to the position. Default none: one white headlight. An empty collection: ambient light only.
   */
  void SetLights(vtkLightCollection* lights);
  vtkLightCollection* GetLights() const;
  ///@}

  ///@{
  /**
   * Ambient light, multiplied by the material's ambient colour and coefficient. Default white.
   */
  vtkSetVector3Macro(AmbientLight, double);
  vtkGetVector3Macro(AmbientLight, double);
  ///@}

  ///@{
  /**
   * What is up for camera lights off the view's axis: they are baked in for an eye whose view up is
   * this, of any length above 0. Default (0, 0, 1).
   */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * A voxel's smallest coefficients are dropped as long as colour and area each lose at most this
   * share of their energy (the sum of squares); its root is the relative error. In [0, 1]; default
   * 1e-5. At 0 only coefficients that are 0 are dropped.
   */
  void SetCoefficientTolerance(double tolerance);
  vtkGetMacro(CoefficientTolerance, double);
  ///@}

  ///@{
  /**
   * How coefficients are found. Analytic: in closed form for headlights and ambient light, from a table over
   * the line's direction for others. Sampled: from NumberOfDirections samples of each segment, as
   * [Schussman2004] section 5; for comparison, some hundred times as slow. Default Analytic.
   */
  enum ProjectionType
  {
    Analytic = 0,
    Sampled
  };
  void SetProjection(int projection);
  vtkGetMacro(Projection, int);
  void SetProjectionToAnalytic() { this->SetProjection(Analytic); }
  void SetProjectionToSampled() { this->SetProjection(Sampled); }
  const char* GetProjectionAsString() const;
  ///@}

  ///@{
  /**
   * Directions of the sampled projection: 128 or 512, the octahedron's faces parted twice or three
   * times. Default 512.
   */
  void SetNumberOfDirections(int directions);
  vtkGetMacro(NumberOfDirections, int);
  ///@}

  ///@{
  /**
   * On, the default, the opacity of a voxel is that of [Schussman2004] eq. 7, 1 - prod(1 - q): a segment
   * counts -ln(1 - q) where q is the share of the voxel's mean cross section that it covers, at most 1.
   * The ratio of the two is taken in the mean over all directions (at q = 0.25 it is 2 % more from
   * the side, and less towards the ends). Off, a segment counts q: 1 - exp(-sum q), the limit for thin
   * lines, too transparent by the factor q/2, but what RadiusScale then scales exactly.
   */
  vtkSetMacro(ExactProduct, bool);
  vtkGetMacro(ExactProduct, bool);
  vtkBooleanMacro(ExactProduct, bool);
  ///@}

  ///@{
  /**
   * Pieces that the source is asked for, one after the other; at least 1, the default. Each of the
   * processes that share the lines asks for so many.
   */
  void SetNumberOfPieces(int pieces);
  vtkGetMacro(NumberOfPieces, int);
  ///@}

  ///@{
  /**
   * The processes that share the lines, each with the piece of its own number of as many pieces. All of
   * them must update the filter then, as with any parallel filter of VTK. Blocks of composite data stand alone.
   * Default: the global controller at the filter's construction, none in programs of one process.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  ///@{
  /**
   * Whether every process that shares the lines has the result, or the first one alone, the others an empty
   * output: for programs that put together what all processes have, such as ParaView. Default on.
   */
  vtkSetMacro(ResultOnAllProcesses, bool);
  vtkGetMacro(ResultOnAllProcesses, bool);
  vtkBooleanMacro(ResultOnAllProcesses, bool);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkAnisotropicLineVoxelizer();
  ~vtkAnisotropicLineVoxelizer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkAnisotropicLineVoxelizer(const vtkAnisotropicLineVoxelizer&) = delete;
  void operator=(const vtkAnisotropicLineVoxelizer&) = delete;

  struct Run;
  void SetName(std::string& array, const char* name);
  void StartRun(vtkInformation* input, vtkInformation* output);
  bool AgreeOnBounds(bool isRight);
  bool AllAreRight(bool isRight);
  bool ShareTypes();
  bool AddPiece(vtkInformationVector** inputs);
  bool AddBounds(vtkPolyData* lines);
  double ProgressAfterPiece(double afterAll) const;
  bool AddTypes(const std::set<int>& types);
  void StartSums();
  bool Write(bool isRight, vtkImageData* output);
  void Warn();

  int SampleDimensions[3] = { 128, 128, 128 };
  double ModelBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Radius = -1.0;
  std::string RadiusArray, LineTypeArray, ColorArray;
  vtkSmartPointer<vtkScalarsToColors> LookupTable;
  std::map<int, vtkSmartPointer<vtkProperty>> Materials;
  std::map<int, double> SpecularPowers;
  int MaximumOrder = 4;
  vtkSmartPointer<vtkLightCollection> Lights;
  double AmbientLight[3] = { 1.0, 1.0, 1.0 };
  double ViewUp[3] = { 0.0, 0.0, 1.0 };
  double CoefficientTolerance = 1.0e-5;
  int Projection = Analytic;
  int NumberOfDirections = 512;
  bool ExactProduct = true;
  int NumberOfPieces = 1;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  bool ResultOnAllProcesses = true;
  std::unique_ptr<Run> Current; // between the pieces
};

#endif
