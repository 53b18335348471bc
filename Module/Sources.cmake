# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# What the module consists of.

set(filter_classes
  vtkAmbientCovarianceFilter
  vtkAnalyticLineSource
  vtkAnalyticVolumeSource
  vtkAnisotropicLineVoxelizer
  vtkAnisotropicVoxelEvaluator
  vtkAnisotropyFilter
  vtkGradientAlignedHistogram
  vtkOpticsImageFilter
  vtkPrincipalCurvatureFilter
  vtkSobelNormalFilter
  vtkStructuralDissimilarity)
set(rendering_classes
  vtkDataSpaceProjectedTetrahedraMapper
  vtkDataSpaceRayCastFunction
  vtkDataSpaceRayIntegrator
  vtkHeadlessRenderWindow
  vtkLightingTransferFunction
  vtkLightingTransferFunctionItem
  vtkMacrocellGrid
  vtkMultiSampleClassification
  vtkOpticsPreset
  vtkOpticsVolumeMapper
  vtkOpticsVolumeProperty
  vtkPreIntegratedTable
  vtkVisibilitySweep)

# C++ files that are not part of the public interface.
set(filter_sources
  AnisotropyCode
  Batches
  BlockCropping
  CovarianceField
  CovarianceKernel
  CovarianceSampler
  CylinderProjection
  GaussianFilter
  GradientAlignedSampler
  HarmonicBasis
  ImageGrid
  LineAccumulator
  LineExchange
  LineInput
  LineKernel
  LineLighting
  LineVoxelizerRun
  LineVoxels
  LiteralSampling
  OpticsImageScalars
  OwnedExtent
  PrincipalCurvature
  ProcessGroup
  RangeSearch
  SamplePattern
  ScalarSource
  SobelStencil
  SphereDirections
  TangentTable
  VoxelEvaluation)
set(rendering_sources
  AttenuatedStretch
  BoundarySearch
  DataSpaceClassification
  DefaultOptics
  EmptySpaceTerm
  FrameAbort
  FrameGeometry
  FrameProvider
  FrameTerm
  FrameTextures
  HeadlessContext
  HeadlessContextEGL
  HeadlessContextOSMesa
  HistogramPicture
  IntegrationTerm
  IsosurfaceTexture
  JsonDocument
  LightUniforms
  LightViews
  LightingBoundary
  LightingEditor
  LightingEditorKeys
  LightingEditorPainter
  LightingEditorPanels
  LightingEditorPictures
  LightingJson
  LightingTable
  LightingTableTexture
  LightingTransferFunctionTerm
  MacrocellDistances
  MacrocellGradients
  LineAtlas
  LineEvaluation
  LineTextures
  LineVolume
  LineVoxelTerm
  MaterialSearch
  MultiSampleRules
  MultiSampleTerm
  OcclusionGathering
  OcclusionTerm
  OpaqueDepth
  OpticsFactory
  OpticsIsosurfaces
  OpticsMapperInputs
  OpticsMapperKnobs
  OpticsScene
  OpticsShaderInsertion
  OpticsShaderTable
  OpticsTerms
  OpticsVisibility
  PairCounts
  PieceTerm
  PreIntegratedTexture
  PreIntegration
  ProjectedTetrahedraPainter
  ProjectedTetrahedraTarget
  RayUniforms
  ReflectanceTerm
  ScalarCoordinates
  ScalarPair
  SceneNeeds
  ShadowAtlas
  ShadowTerm
  SkippingCost
  StandaloneShaders
  SweepGrid
  SweepProgram
  SweepRegions
  SweepSources
  SweepTarget
  SweepUniforms
  SweepViews
  TermTexture
  TetrahedraVertices
  TetrahedralGrid
  TransferFunctionStretches
  TransferFunctionTerm
  TransferFunctionTexture
  VisibleGradients
  VisibleIn2D
  VisibleInScene
  VisibleScalars
  vtkLightingTransferFunctionItemEvents
  vtkOpticsShaderPass)

list(TRANSFORM filter_classes PREPEND Filters/)
list(TRANSFORM filter_sources PREPEND Filters/)
list(TRANSFORM rendering_classes PREPEND Rendering/)
list(TRANSFORM rendering_sources PREPEND Rendering/)
list(TRANSFORM filter_sources APPEND .cxx)
list(TRANSFORM rendering_sources APPEND .cxx)

# Each GLSL file becomes a string of the same name; Module/Optics holds the
# formulas, Rendering/glsl the text around them.
file(GLOB shaders CONFIGURE_DEPENDS
  "${CMAKE_CURRENT_SOURCE_DIR}/Module/Optics/*.glsl"
  "${CMAKE_CURRENT_SOURCE_DIR}/Rendering/glsl/*.glsl")
set(sources)
set(private_headers)
foreach (shader IN LISTS shaders)
  get_filename_component(name "${shader}" NAME_WE)
  vtk_encode_string(
    INPUT         "${shader}"
    NAME          "${name}"
    HEADER_OUTPUT header
    SOURCE_OUTPUT source)
  list(APPEND sources "${source}")
  list(APPEND private_headers "${header}")
endforeach ()

vtk_module_add_module(VolumeOptics::VolumeOptics
  CLASSES         ${filter_classes} ${rendering_classes}
  SOURCES         ${filter_sources} ${rendering_sources} ${sources}
  PRIVATE_HEADERS ${private_headers})
vtk_module_find_package(PRIVATE PACKAGE hwy)
vtk_module_link(VolumeOptics::VolumeOptics PRIVATE hwy::hwy)
vtk_module_include(VolumeOptics::VolumeOptics
  PUBLIC
    "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/Filters>"
    "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/Rendering>"
  PRIVATE
    "${CMAKE_CURRENT_SOURCE_DIR}/Module/Optics")
vtk_module_compile_options(VolumeOptics::VolumeOptics PRIVATE -Wall -Wextra)
vtk_module_link(VolumeOptics::VolumeOptics PRIVATE "$<BUILD_INTERFACE:${CMAKE_DL_LIBS}>")
