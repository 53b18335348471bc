// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkOpticsVolumeProperty
 * @brief Optical model of a volume, beyond what vtkVolumeProperty offers.
 *
 * A vtkVolumeProperty that vtkOpticsVolumeMapper reads more from. Every setting's default leaves
 * VTK's own picture unchanged; other mappers ignore the settings of this class. Lights are
 * evaluated only while Shade is on, as in VTK.
 *
 * With a reflectance model other than VTK, a sample of colour c reflects
 *   c (Ambient + Diffuse sum_l I_l HG(ScatteringAnisotropy)) + Specular sum_l I_l K S_l,
 * where S_l is the model's reflectance times the cosine of the light's angle and K the specular
 * coefficient (see SetSpecularFromExtinction()). SpecularPower belongs to the VTK model alone.
 *
 * A number outside its range is set to the nearest one of the range, with a warning; a choice that
 * does not exist, or a number that is NaN, leaves the setting as it is, with a warning.
 *
 * Sources: [Ament2015], [Kraus2005], [Lum2004], [Schott2009], see Module/References.md.
 *
 * @sa vtkOpticsVolumeMapper
 */

#ifndef vtkOpticsVolumeProperty_h
#define vtkOpticsVolumeProperty_h

#include "vtkSmartPointer.h"       // for the lighting transfer function
#include "vtkVolumeOpticsModule.h" // for export macro
#include "vtkVolumeProperty.h"

#include <vector> // for the isosurfaces

class vtkLightingTransferFunction;
class vtkMultiSampleClassification;

class VTKVOLUMEOPTICS_EXPORT vtkOpticsVolumeProperty : public vtkVolumeProperty
{
public:
  static vtkOpticsVolumeProperty* New();
  vtkTypeMacro(vtkOpticsVolumeProperty, vtkVolumeProperty);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Copies the settings of vtkVolumeProperty and, if the source has them, of this class. Transfer
   * functions are copied deeply, but curves and table image of a lighting transfer function, and a
   * classification by several samples, are shared.
   */
  void DeepCopy(vtkVolumeProperty* source);

  ///@{
  /**
   * How a sample reflects light: VTK's Phong model; None, the phase function alone; Blinn-Phong
   * (isotropic); Ward or Lafortune, whose highlights are drawn out along the shape of the data.
   * Default VTK.
   */
  enum ReflectanceModelType
  {
    VTK = 0,
    None,
    BlinnPhong,
    Ward,
    Lafortune,
    NumberOfReflectanceModels
  };
  vtkGetMacro(ReflectanceModel, int);
  void SetReflectanceModel(int model);
  void SetReflectanceModelToVTK() { this->SetReflectanceModel(VTK); }
  void SetReflectanceModelToNone() { this->SetReflectanceModel(None); }
  void SetReflectanceModelToBlinnPhong() { this->SetReflectanceModel(BlinnPhong); }
  void SetReflectanceModelToWard() { this->SetReflectanceModel(Ward); }
  void SetReflectanceModelToLafortune() { this->SetReflectanceModel(Lafortune); }
  const char* GetReflectanceModelAsString();
  ///@}

  ///@{
  /**
   * Size of the highlight, kept per model. Blinn-Phong, Lafortune: the exponent, in [0.01, 1e5],
   * larger is smaller and sharper; default 30. Ward: the roughness kappa, in [1e-4, 1], smaller is
   * sharper; default 0.2. Without a model named, that of the current one. VTK and None have none:
   * setting theirs warns, theirs is 0.
   * [Ament2015] kappa of section 4.2.
   */
  void SetGlossiness(int model, double glossiness);
  void SetGlossiness(double glossiness) { this->SetGlossiness(this->ReflectanceModel, glossiness); }
  double GetGlossiness(int model);
  double GetGlossiness() { return this->GetGlossiness(this->ReflectanceModel); }
  ///@}

  ///@{
  /**
   * How much the shape of the data draws the highlight out: the exponent gamma of the ratio of the
   * eigenvalues, in [0, 1e4], kept per model. 0: isotropic. Default 10. Ward and Lafortune alone
   * have one. Above 10 use 16 bits of frame precision (vtkOpticsVolumeMapper::SetFramePrecision()).
   * [Ament2015] eqs 32, 34.
   */
  void SetAnisotropyScale(int model, double scale);
  void SetAnisotropyScale(double scale) { this->SetAnisotropyScale(this->ReflectanceModel, scale); }
  double GetAnisotropyScale(int model);
  double GetAnisotropyScale() { return this->GetAnisotropyScale(this->ReflectanceModel); }
  ///@}

  ///@{
  /**
   * Whether highlights show only where the classified extinction changes, K = |grad(tau)| times
   * ScalarOpacityUnitDistance (bounded at 16), or on every sample, K = 1. Default on. Not used by
   * the VTK and None models. [Ament2015] eq. 6.
   */
  vtkGetMacro(SpecularFromExtinction, bool);
  vtkSetMacro(SpecularFromExtinction, bool);
  vtkBooleanMacro(SpecularFromExtinction, bool);
  ///@}

  ///@{
  /**
   * Where the tangent frame of the anisotropic models comes from: the covariance of the ambient
   * region (vtkAmbientCovarianceFilter), or the principal curvatures of the isosurface
   * (vtkPrincipalCurvatureFilter). Default Covariance.
   */
  enum FrameSourceType
  {
    Covariance = 0,
    Curvature
  };
  vtkGetMacro(FrameSource, int);
  void SetFrameSource(int source);
  void SetFrameSourceToCovariance() { this->SetFrameSource(Covariance); }
  void SetFrameSourceToCurvature() { this->SetFrameSource(Curvature); }
  const char* GetFrameSourceAsString();
  ///@}

  ///@{
  /**
   * Mean cosine g of the Henyey-Greenstein phase function of the diffuse term, in [-1, 1]: above 0
   * scatters forward, below 0 back to the light; drawn as .999 and -.999 beyond these. Default 0,
   * isotropic. [HenyeyGreenstein1941]; [Ament2015] eq. 4. Not used by the VTK model
   * (VTK 9.2 and later use it there for their own scattering).
   */
  void SetScatteringAnisotropy(float anisotropy);
  float GetScatteringAnisotropy() const;
  ///@}

  ///@{
  /**
   * The space in which opacity adds up along a ray. Physical, VTK's own: opacity belongs to a length
   * (ScalarOpacityUnitDistance). Data: it belongs to an interval of the scalar
   * (ScalarOpacityUnitInterval); pictures then do not depend on spacing, the world's scale, the step
   * or the local gradient, and constant regions are invisible. Default Physical. [Kraus2005] section 3.
   */
  enum IntegrationSpaceType
  {
    Physical = 0,
    Data
  };
  vtkGetMacro(IntegrationSpace, int);
  void SetIntegrationSpace(int space);
  void SetIntegrationSpaceToPhysical() { this->SetIntegrationSpace(Physical); }
  void SetIntegrationSpaceToData() { this->SetIntegrationSpace(Data); }
  const char* GetIntegrationSpaceAsString();
  ///@}

  ///@{
  /**
   * How a segment between two samples is classified: by the value at its end (Post, VTK's own), or by
   * the integral of the transfer functions over all values in between, from a table (PreIntegrated).
   * In either space. Default Post. [Kraus2005] section 3.2.
   */
  enum ClassificationType
  {
    Post = 0,
    PreIntegrated
  };
  vtkGetMacro(Classification, int);
  void SetClassification(int classification);
  void SetClassificationToPost() { this->SetClassification(Post); }
  void SetClassificationToPreIntegrated() { this->SetClassification(PreIntegrated); }
  const char* GetClassificationAsString();
  ///@}

  ///@{
  /**
   * Data space: the interval of the scalar, in its own unit, that an opacity of the opacity function
   * belongs to: a ray that crosses so much of a constant function is that opaque. At least 0; 0 is one
   * hundredth of the opacity function's own range. Default 0.
   */
  vtkGetMacro(ScalarOpacityUnitInterval, double);
  void SetScalarOpacityUnitInterval(double interval);
  /** The interval in use: never 0 unless the function's range is. */
  double GetEffectiveScalarOpacityUnitInterval();
  ///@}

  ///@{
  /**
   * Data space: a surface of exactly this opacity in [0, 1] wherever a ray crosses the value, whatever
   * the opacity function is there. Its colour is given (each of r, g, b in [0, 1]), or that of the
   * colour function, which for two dependent components reads the first one. Returns the surface's
   * index; a value that is not finite is refused with a warning, and -1. [Kraus2005] section 3.3.
   */
  int AddIsosurface(double value, double r, double g, double b, double opacity);
  int AddIsosurface(double value, double opacity);
  int GetNumberOfIsosurfaces() { return static_cast<int>(this->Isosurfaces.size()); }
  double GetIsosurfaceValue(int index);
  double GetIsosurfaceOpacity(int index);
  void GetIsosurfaceColor(int index, double rgb[3]);
  bool GetIsosurfaceHasColor(int index);
  void RemoveIsosurface(int index);
  void RemoveAllIsosurfaces();
  ///@}

  ///@{
  /**
   * Data space: how opacity grows where the ray grazes a surface. Off; Exact, as a thin layer does,
   * 1 - (1 - a)^(1/|cos|), [Kraus2005] eq. 15; Clamped, min(1, a/|cos|), eq. 16; Gradient, the
   * gradient's magnitude in place of its projection in post-classification, eq. 18. Default Off.
   */
  enum SilhouetteType
  {
    SilhouetteOff = 0,
    Exact,
    Clamped,
    Gradient
  };
  vtkGetMacro(Silhouette, int);
  void SetSilhouette(int silhouette);
  void SetSilhouetteToOff() { this->SetSilhouette(SilhouetteOff); }
  void SetSilhouetteToExact() { this->SetSilhouette(Exact); }
  void SetSilhouetteToClamped() { this->SetSilhouette(Clamped); }
  void SetSilhouetteToGradient() { this->SetSilhouette(Gradient); }
  const char* GetSilhouetteAsString();
  ///@}

  ///@{
  /**
   * Data space, with Shade on: light that falls on a surface from behind shines through it: not at all
   * (Off), by its diffuse part, or with a highlight around the light as well. Independent of the step;
   * an opaque surface transmits nothing. Default Off. [Kraus2005] eq. 19.
   */
  enum TransmittedLightType
  {
    TransmittedLightOff = 0,
    Diffuse,
    DiffuseAndSpecular
  };
  vtkGetMacro(TransmittedLight, int);
  void SetTransmittedLight(int light);
  void SetTransmittedLightToOff() { this->SetTransmittedLight(TransmittedLightOff); }
  void SetTransmittedLightToDiffuse() { this->SetTransmittedLight(Diffuse); }
  void SetTransmittedLightToDiffuseAndSpecular() { this->SetTransmittedLight(DiffuseAndSpecular); }
  const char* GetTransmittedLightAsString();
  ///@}

  ///@{
  /**
   * With Shade on: coefficients of light by the scalars on both sides of a sample along the gradient.
   * They replace Ambient, Diffuse and Specular with every reflectance model, and are multiplied by
   * LightScale. nullptr, the default, is none. [Lum2004]
   */
  void SetLightingTransferFunction(vtkLightingTransferFunction* function);
  vtkLightingTransferFunction* GetLightingTransferFunction();
  ///@}

  ///@{
  /**
   * Colour and opacity by the scalar of a sample and those on both sides of it, in place of those of the
   * transfer functions where a rule holds. nullptr, the default, is none. Not with IntegrationSpace Data,
   * Classification PreIntegrated, 2D transfer functions or the reflectance models Blinn-Phong, Ward and
   * Lafortune, which the mapper says. [Lum2004] section 7.
   */
  void SetMultiSampleClassification(vtkMultiSampleClassification* classification);
  vtkMultiSampleClassification* GetMultiSampleClassification();
  ///@}

  ///@{
  /**
   * Distance from a sample to those on both sides of it, in units of the image's smallest spacing; in
   * [0, 1e4], default 1. At 0 both are the sample itself. Outside of the volume the scalar is that of
   * its nearest border point. [Lum2004] h of eq. 2.
   */
  vtkGetMacro(GradientStepLength, double);
  void SetGradientStepLength(double length);
  ///@}

  ///@{
  /**
   * Factor of the coefficients of the lighting transfer function; in [0, 1e6], default 1. Above 1 a
   * sample's colour may exceed its opacity, so that nearly transparent boundaries remain visible; it
   * is not clamped before the whole ray is composited. [Lum2004] section 3.4.
   */
  vtkGetMacro(LightScale, double);
  void SetLightScale(double scale);
  ///@}

  ///@{
  /**
   * With a lighting transfer function: whether light falls on one side of a surface alone, on that of
   * the less opaque material, as the scalar opacity function has it for the scalars on both sides,
   * whatever the renderer's two-sided lighting; where both are of nearly the same opacity light fades
   * from one side to the other. Default off. [Lum2004] section 3.3.
   */
  vtkGetMacro(HybridNormals, bool);
  vtkSetMacro(HybridNormals, bool);
  vtkBooleanMacro(HybridNormals, bool);
  ///@}

  ///@{
  /**
   * Whether ambient light is what comes, past the volume in front of a sample, out of a cone about the
   * direction to the viewer: creases and what lies behind something grow dark. With Shade on it is the
   * ambient part that is darkened, and only as far as Ambient (or a lighting transfer function) weighs it;
   * with Shade off it is the whole colour. Default off. [Schott2009] section 3.
   */
  vtkGetMacro(Occlusion, bool);
  vtkSetMacro(Occlusion, bool);
  vtkBooleanMacro(Occlusion, bool);
  ///@}

  ///@{
  /**
   * Half of the cone's opening angle, in degrees; in [0, 80], default 60. 0: the line of sight alone.
   * [Schott2009] theta of eq. 6.
   */
  vtkGetMacro(OcclusionAngle, double);
  void SetOcclusionAngle(double degrees);
  ///@}

  ///@{
  /**
   * Colour of the ambient light, each of red, green and blue in [0, 1]; default white. It colours what
   * Occlusion darkens, with Occlusion off, too.
   */
  vtkGetVector3Macro(AmbientColor, double);
  void SetAmbientColor(double red, double green, double blue);
  void SetAmbientColor(const double rgb[3]) { this->SetAmbientColor(rgb[0], rgb[1], rgb[2]); }
  ///@}

  ///@{
  /**
   * With Shade on: whether the volume, and the opaque geometry in its renderer, cast shadows into the
   * volume, from each light as much as its shadow attenuation says (vtkLight::SetShadowAttenuation();
   * 1, its default, is a full shadow, 0 none). With any reflectance model; lines need no Shade. Default off.
   * [Ament2015] section 5.
   */
  vtkGetMacro(Shadows, bool);
  vtkSetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * Half of the angle under which lights appear from the volume, in degrees; in [0, 80]. Above 0 shadows
   * are soft. Default 0, hard shadows.
   */
  vtkGetMacro(ShadowAngle, double);
  void SetShadowAngle(double degrees);
  ///@}

  /** The latest change of this object and of the functions it refers to. */
  vtkMTimeType GetMTime() override;

protected:
  vtkOpticsVolumeProperty();
  ~vtkOpticsVolumeProperty() override;

private:
  vtkOpticsVolumeProperty(const vtkOpticsVolumeProperty&) = delete;
  void operator=(const vtkOpticsVolumeProperty&) = delete;

  struct Isosurface
  {
    double Value;
    double Color[3];
    double Opacity;
    bool HasColor;
  };
  bool AcceptsIsovalue(double value);
  int InsertIsosurface(const Isosurface& surface);
  bool HasIsosurface(int index);
  void CopyLightingTransferFunction(vtkOpticsVolumeProperty* source);
  void CopyVisibility(vtkOpticsVolumeProperty* source);
  void PrintVisibility(ostream& os, vtkIndent indent);

  int ReflectanceModel = VTK;
  double Glossiness[NumberOfReflectanceModels] = { 0.0, 0.0, 30.0, 0.2, 30.0 };
  double AnisotropyScale[NumberOfReflectanceModels] = { 0.0, 0.0, 0.0, 10.0, 10.0 };
  bool SpecularFromExtinction = true;
  int FrameSource = Covariance;
  float PhaseAnisotropy = 0.0F;
  int IntegrationSpace = Physical;
  int Classification = Post;
  double ScalarOpacityUnitInterval = 0.0;
  std::vector<Isosurface> Isosurfaces;
  int Silhouette = SilhouetteOff;
  int TransmittedLight = TransmittedLightOff;
  vtkSmartPointer<vtkLightingTransferFunction> LightingTransferFunction;
  vtkSmartPointer<vtkMultiSampleClassification> MultiSampleClassification;
  double GradientStepLength = 1.0;
  double LightScale = 1.0;
  bool HybridNormals = false;
  bool Occlusion = false;
  double OcclusionAngle = 60.0;
  double AmbientColor[3] = { 1.0, 1.0, 1.0 };
  bool Shadows = false;
  double ShadowAngle = 0.0;
};

#endif
