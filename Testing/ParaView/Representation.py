# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""The representation Volume Optics: the picture of Volume with everything off, and each method."""

import os

import numpy
from paraview import simple

import Checks
from Checks import check, check_baseline, check_differs, check_equal, finish, load_plugin, take_picture

load_plugin()
view = Checks.make_view()
source = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[32, 32, 32])
source.UpdatePipeline()
display = Checks.show_volume(source, view)


def compare_with_stock(name, shown):
    """Everything off: whatever the data and the settings of Volume, not a byte differs."""
    for other in (display, shown):
        other.Visibility = 0
    shown.Visibility = 1
    shown.SetRepresentationType("Volume")
    stock = take_picture(view, "stock-" + name)
    shown.SetRepresentationType("Volume Optics")
    ours = take_picture(view, "optics-" + name)
    check(numpy.ptp(stock) > 50, f"{name}: the stock picture shows nothing")
    check_equal(stock, ours, name)
    return stock


def show_like(source, array, association="POINTS", **settings):
    shown = Checks.show_volume(source, view, array, association)
    for name, value in settings.items():
        setattr(shown, name, value)
    return shown


def component(mode, index=0):
    table = simple.GetColorTransferFunction("Vectors")
    table.VectorMode = mode
    table.VectorComponent = index


off = compare_with_stock("points", display)
display.Shade = display.OpticsShade = 1
display.Specular = 0.4
lit = compare_with_stock("shade", display)
check_differs(off, lit, "shade")
display.UseCropping = display.OpticsCropping = 1
display.CroppingScale = [0.6, 1.0, 1.0]
check_differs(lit, compare_with_stock("cropping", display), "cropping")
display.UseCropping = display.OpticsCropping = 0
display.BlendMode = display.OpticsBlendMode = "Isosurface"
display.IsosurfaceValues = [0.5]
check_differs(lit, compare_with_stock("isosurface", display), "isosurface blending")
display.BlendMode = display.OpticsBlendMode = "Composite"
display.Shade = display.OpticsShade = 0
view.CameraParallelProjection = 1
compare_with_stock("parallel", display)
view.CameraParallelProjection = 0

cells = simple.PointDatatoCellData(Input=source)
compare_with_stock("cells", show_like(cells, "Scalars", "CELLS"))
simple.Hide(cells, view)

vectors = simple.Calculator(
    Input=source, ResultArrayName="Vectors", Function="Scalars*(0.3*iHat+0.8*jHat+coordsX*kHat)"
)
component("Magnitude")
compare_with_stock("magnitude", show_like(vectors, "Vectors"))
component("Component", 1)
compare_with_stock("component", show_like(vectors, "Vectors"))
simple.Hide(vectors, view)

half = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[17, 32, 32], Bounds=[-1.0, 0.0, -1.0, 1.0, -1.0, 1.0])
rest = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[17, 32, 32], Bounds=[0.0, 1.0, -1.0, 1.0, -1.0, 1.0])
blocks = simple.GroupDatasets(Input=[half, rest])
compare_with_stock("blocks", show_like(blocks, "Scalars"))
view.CameraPosition = [-2.5, -4.0, 2.0]
compare_with_stock("blocks-from-behind", show_like(blocks, "Scalars"))
Checks.look_at(view)
simple.Hide(blocks, view)

# Each method changes the picture of the volume, and its own baseline does not change.
simple.Show(source, view)
display.SetRepresentationType("Volume Optics")
display.OpticsShade = 1
display.Ambient, display.Diffuse, display.Specular = 0.2, 0.6, 0.3
plain = take_picture(view, "plain")
METHODS = {
    "none": dict(ReflectanceModel="None", PhaseAnisotropy=0.6),
    "blinn-phong": dict(ReflectanceModel="Blinn-Phong", BlinnPhongExponent=60.0),
    "ward": dict(ReflectanceModel="Ward", WardRoughness=0.15),
    "lafortune": dict(ReflectanceModel="Lafortune", FrameSource="Principal curvature"),
    "data-space": dict(IntegrationSpace="Scalar", Silhouette="Exact", TransmittedLight="Diffuse"),
    "isosurfaces": dict(IntegrationSpace="Scalar", OpticsIsosurfaces=[0.4, 0.3, 0.7, 0.9]),
    "pre-integrated": dict(Classification="Pre-integrated"),
    "lighting": dict(
        UseLightingTransferFunction=1,
        LightingBoundaries=[0.0, 0.3, 0.6, 1.0, 0.1, 0.2, 0.7, 0.4],
        GradientStepLength=3.0,
        LightScale=2.0,
        HybridNormals=1,
    ),
    "lighting-file": dict(UseLightingTransferFunction=1, LightingFile=os.path.join(Checks.DATA, "lighting.json")),
    "rules": dict(MultiSampleFile=os.path.join(Checks.DATA, "rules.json")),
    "occlusion": dict(Occlusion=1, Ambient=0.8, Diffuse=0.1),
    "shadows": dict(Shadows=1),
    "draft": dict(ReflectanceModel="Ward", OpticsQuality="Draft"),
}
WITH_BASELINE = ("ward", "data-space", "lighting")
for name, settings in METHODS.items():
    before = {key: Checks.value_of(display.GetProperty(key)) for key in settings}
    for key, value in settings.items():
        setattr(display, key, value)
    pixels = take_picture(view, "method-" + name)
    # what adds up differently alone changes little
    check_differs(plain, pixels, name, 2 if name == "pre-integrated" else 8)
    if name in WITH_BASELINE:
        check_baseline(pixels, "method-" + name)
    for key, value in before.items():
        setattr(display, key, value)
check_equal(plain, take_picture(view, "plain-again"), "after all methods")

# Arrays of the filters in place of the mapper's own: the same picture.
display.ReflectanceModel = "Ward"
own = take_picture(view, "frames-own")
normals = simple.SobelNormals(Input=source)
normals.UpdatePipeline()
covariance = simple.AmbientCovariance(Input=normals, Scalars=["POINTS", "Scalars"])
display.Visibility = 0
given = show_like(covariance, "Scalars")
given.SetRepresentationType("Volume Optics")
given.OpticsShade = 1
given.Ambient, given.Diffuse, given.Specular = 0.2, 0.6, 0.3
given.ReflectanceModel = "Ward"
check_equal(own, take_picture(view, "frames-given"), "frames of the filters", 1)

# Lines, as voxels: what the panel and the filter have for them.
given.SetRepresentationType("Volume")
simple.Hide(covariance, view)
lines = simple.VortexSpirals(NumberOfSegments=20000, SegmentsPerLine=200)
voxels = simple.AnisotropicLineVoxels(Input=lines, SampleDimensions=[32, 32, 32], Radius=0.01)
shown = simple.Show(voxels, view)
shown.SetRepresentationType("Volume Optics")
simple.ColorBy(shown, ("CELLS", "BrickIndex"))
view.CameraPosition = [0.0, -4.0, 0.0]
plain = take_picture(view, "lines")
check(plain.max() > 60, "lines are not seen")
for key, value in dict(LineRadiusScale=0.4, LineOpacityScale=0.3, Occlusion=1).items():
    before = Checks.value_of(shown.GetProperty(key))
    setattr(shown, key, value)
    check_differs(plain, take_picture(view, "lines-" + key), "lines, " + key)
    setattr(shown, key, before)
check_equal(plain, take_picture(view, "lines-again"), "lines, after all settings")
voxels.LightDirection = [0.0, 1.0, 0.0]
lit = take_picture(view, "lines-lit").mean()
view.CameraPosition = [0.0, 4.0, 0.0]
behind = take_picture(view, "lines-behind").mean()
check(lit > 1.2 * behind, f"lit lines are not brighter than from behind: {lit}, {behind}")

finish()
