# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A volume on any number of processes: its structures found by a filter, lit along them.

    PV_PLUGIN_PATH=<prefix>/lib/paraview-5.11/plugins mpirun -n 4 pvbatch distributed_volume.py [volume.png]

Each process computes and draws its piece of the volume; ParaView puts the pictures together.
VOLUMEOPTICS_PLUGIN may name the plugin's file instead.
"""

import os
import sys

from paraview.simple import *

if "AmbientCovariance" not in globals():
    LoadPlugin(os.environ["VOLUMEOPTICS_PLUGIN"], remote=False, ns=globals())

volume = AnalyticVolume(Field="Vortex tubes", Dimensions=[64, 64, 64])  # any image in its place
normals = SobelNormals(Input=volume)
normals.UpdatePipeline()
covariance = AmbientCovariance(Input=normals, Scalars=["POINTS", "Scalars"])
covariance.UpdatePipeline()

view = CreateView("RenderView")
view.ViewSize = [400, 400]
view.OrientationAxesVisibility = 0
view.CameraPosition = [2.5, -4.0, 2.0]
view.CameraViewUp = [0.0, 0.0, 1.0]

display = Show(covariance, view)
ColorBy(display, ("POINTS", "Scalars"))
colors = GetColorTransferFunction("Scalars")
colors.RGBPoints = [0.0, 0.3, 0.35, 0.6, 1.0, 0.75, 0.6, 0.5]
opacities = GetOpacityTransferFunction("Scalars")
opacities.Points = [0.0, 0.0, 0.5, 0.0, 0.4, 0.0, 0.5, 0.0, 0.6, 0.8, 0.5, 0.0, 1.0, 0.9, 0.5, 0.0]
display.SetRepresentationType("Volume Optics")
display.OpticsOpacityUnitDistance = 0.05
display.OpticsShade = 1
display.Ambient, display.Diffuse, display.Specular = 0.2, 0.6, 0.5
display.ReflectanceModel = "Ward"

SaveScreenshot(sys.argv[1] if len(sys.argv) > 1 else "volume.png", view)
