# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""Draws and filters on this run's ranks, into files RANKS-name, for CompareRanks.py."""

import os
import sys

from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import Checks
from Checks import check, check_equal, finish, load_plugin, take_picture

ranks = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
check(ranks == int(sys.argv[1]), f"{ranks} ranks in place of {sys.argv[1]}")


def name(what):
    return f"ranks-{ranks}-{what}"


load_plugin()
view = Checks.make_view()
view.ViewSize = [100, 100]
# Smoothed edges are the view's: on several ranks it smooths each rank's picture, whatever is drawn.
view.UseFXAA = 0
source = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[40, 24, 24])
source.UpdatePipeline()

# Filters: the ghost layers are theirs to ask for.
FILTERS = {
    "sobel": simple.SobelNormals(Input=source, Smoothing=0.7),
    "covariance": simple.AmbientCovariance(Input=source, Radius=4.0, FilterStandardDeviation=0.5),
    "curvature": simple.PrincipalCurvatureAnisotropy(Input=source),
    "half": simple.SobelNormals(Input=source, ResolutionFactor=0.5),
    "histogram": simple.GradientAlignedHistogram(Input=source, NumberOfBins=16, ScalarRange=[1.0, 0.0]),
}
# With expat 2.5.0-1+deb12u2 no file is read whose arrays are appended behind the XML, as ParaView writes otherwise.
for key, result in FILTERS.items():
    simple.SaveData(os.path.join(Checks.OUTPUT, name(key) + ".pvti"), proxy=result, DataMode="Binary")


LIGHT = dict(Ambient=0.05, Diffuse=0.3, Specular=0.1)
BOUNDARY = dict(
    UseLightingTransferFunction=1,
    LightingBoundaries=[0.0, 0.3, 0.6, 1.0, 0.1, 0.2, 0.7, 0.4],
    GradientStepLength=2.0,
)
IN_DATA = dict(ReflectanceModel="Blinn-Phong", IntegrationSpace="Scalar")
METHODS = {
    "off-shade": dict(),
    "vtk": dict(OpticsAmbientColor=[1.0, 0.9, 0.8]),
    "none": dict(ReflectanceModel="None", PhaseAnisotropy=0.5),
    "blinn-phong": dict(ReflectanceModel="Blinn-Phong"),
    "ward": dict(ReflectanceModel="Ward", Specular=0.001),
    "ward-curvature": dict(ReflectanceModel="Ward", FrameSource="Principal curvature", Specular=0.001),
    "lafortune": dict(ReflectanceModel="Lafortune", Specular=0.01),
    "data-space": IN_DATA,
    "silhouettes": dict(Silhouette="Exact", **IN_DATA),
    "transmitted": dict(TransmittedLight="Diffuse", **IN_DATA),
    "isosurfaces": dict(OpticsIsosurfaces=[0.4, 0.3, 0.7, 0.9], **IN_DATA),
    "pre-integrated": dict(ReflectanceModel="Blinn-Phong", Classification="Pre-integrated"),
    "lighting": BOUNDARY,
    "hybrid": dict(HybridNormals=1, ReflectanceModel="Ward", Specular=0.001, **BOUNDARY),
    "rules": dict(MultiSampleFile=os.path.join(Checks.DATA, "rules.json")),
    # Brighter than opaque, as light on volumes may be.
    "bright": dict(ReflectanceModel="Ward", Ambient=0.2, Diffuse=0.6, Specular=0.02),
}


def draw_with(display, settings):
    """The representation's picture with these settings, which do not last."""
    before = {setting: Checks.value_of(display.GetProperty(setting)) for setting in settings}
    for setting, value in settings.items():
        setattr(display, setting, value)
    yield
    for setting, value in before.items():
        setattr(display, setting, value)


def draw_both(display, what):
    for representation, kind in (("Volume", "stock-" + what), ("Volume Optics", what)):
        display.SetRepresentationType(representation)
        take_picture(view, name(kind))


def draw_methods():
    display = Checks.show_volume(source, view)
    take_picture(view, name("stock"))
    display.SetRepresentationType("Volume Optics")
    take_picture(view, name("off"))
    display.Shade = display.OpticsShade = 1
    display.CovarianceRadius = 4.0
    for setting, value in LIGHT.items():
        setattr(display, setting, value)
    for what, settings in METHODS.items():
        for _ in draw_with(display, settings):
            take_picture(view, name(what))
    display.SetRepresentationType("Volume")
    take_picture(view, name("stock-shade"))
    # Opaque geometry that begins and ends in either piece, and cameras inside and at no place.
    display.ReflectanceModel = "Blinn-Phong"
    cone = simple.Show(simple.Cone(Height=1.2, Radius=0.3, Center=[0.1, 0.0, 0.0]), view)
    draw_both(display, "geometry")
    cone.Visibility = 0
    view.CameraPosition = [0.2, -0.3, 0.4]
    draw_both(display, "inside")
    Checks.look_at(view)
    view.CameraParallelProjection = 1
    draw_both(display, "parallel")
    view.CameraParallelProjection = 0
    simple.Hide(source, view)
    draw_other_data()


def light(display):
    display.Shade = display.OpticsShade = 1
    display.ReflectanceModel = "Blinn-Phong"
    for setting, value in LIGHT.items():
        setattr(display, setting, value)


def draw_other_data():
    cells = simple.PointDatatoCellData(Input=source)
    left = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[20, 24, 24], Bounds=[-1.0, 0.0, -1.0, 1.0, -1.0, 1.0])
    right = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[20, 24, 24], Bounds=[0.0, 1.0, -1.0, 1.0, -1.0, 1.0])
    blocks = simple.GroupDatasets(Input=[left, right])
    display = Checks.show_volume(cells, view, "Scalars", "CELLS")
    light(display)
    draw_both(display, "cells")
    simple.Hide(cells, view)
    display = Checks.show_volume(blocks, view)
    draw_both(display, "blocks")
    light(display)
    draw_both(display, "blocks-shade")
    simple.Hide(blocks, view)


if ranks < 3:
    draw_methods()

# Fewer slices than ranks: two cells.
thin = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[3, 24, 24])
display = Checks.show_volume(thin, view)
light(display)
draw_both(display, "thin")
simple.Hide(thin, view)

# A single cell: all ranks but one have nothing.
cell = simple.AnalyticVolume(Field="Sphere", Dimensions=[2, 2, 2])
cell.UpdatePipeline()
shown = Checks.show_volume(cell, view)
stock = take_picture(view, name("cell-stock"))
shown.SetRepresentationType("Volume Optics")
check_equal(stock, take_picture(view, name("cell")), "a single cell")
shown.OpticsShade = 1
shown.ReflectanceModel = "Ward"
take_picture(view, name("cell-ward"))

finish()
