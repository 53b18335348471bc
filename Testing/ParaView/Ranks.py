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


def draw_methods():
    display = Checks.show_volume(source, view)
    take_picture(view, name("stock"))
    display.SetRepresentationType("Volume Optics")
    take_picture(view, name("off"))
    display.Shade = display.OpticsShade = 1
    # Such that no pixel is brighter than it is opaque, which bytes cannot composite.
    display.Ambient, display.Diffuse, display.Specular = 0.05, 0.3, 0.1
    display.SetRepresentationType("Volume")
    take_picture(view, name("stock-shade"))
    display.SetRepresentationType("Volume Optics")
    display.CovarianceRadius = 4.0
    METHODS = {
        "ward": dict(ReflectanceModel="Ward", Specular=0.001),
        "lighting": dict(
            ReflectanceModel="VTK",
            Specular=0.1,
            UseLightingTransferFunction=1,
            LightingBoundaries=[0.0, 0.3, 0.6, 1.0, 0.1, 0.2, 0.7, 0.4],
            GradientStepLength=2.0,
        ),
        "data-space": dict(
            UseLightingTransferFunction=0, IntegrationSpace="Scalar", ReflectanceModel="Blinn-Phong", Specular=0.001
        ),
        "pre-integrated": dict(IntegrationSpace="Length", Classification="Pre-integrated"),
        "bright": dict(
            Classification="At samples", ReflectanceModel="Ward", Ambient=0.2, Diffuse=0.6, Specular=0.02
        ),
    }
    for key, settings in METHODS.items():
        for setting, value in settings.items():
            setattr(display, setting, value)
        take_picture(view, name(key))
    simple.Hide(source, view)


if ranks < 3:
    draw_methods()

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
