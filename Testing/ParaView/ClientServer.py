# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""A client of pvserver. Arguments: the port, and whether the plugin is on both sides or on the client's alone."""

import sys

from paraview import simple

import Checks
from Checks import check, check_differs, check_equal, finish, take_picture

simple.Connect("localhost", int(sys.argv[1]))
simple._DisableFirstRenderCameraReset()
if sys.argv[2] == "both":
    simple.LoadPlugin(Checks.PLUGIN, remote=True, ns=vars(simple))
simple.LoadPlugin(Checks.PLUGIN, remote=False, ns=vars(simple))

if sys.argv[2] == "both":
    view = Checks.make_view()
    source = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[24, 24, 24])
    source.UpdatePipeline()
    display = Checks.show_volume(source, view)
    view.RemoteRenderThreshold = 0.0
    stock = take_picture(view, "server-stock")
    display.SetRepresentationType("Volume Optics")
    check_equal(stock, take_picture(view, "server-optics"), "everything off, on the server")
    display.OpticsShade = 1
    display.Ambient, display.Diffuse, display.Specular = 0.2, 0.6, 0.3
    display.ReflectanceModel = "Ward"
    display.CovarianceRadius = 3.0
    check_differs(stock, take_picture(view, "server-ward"), "Ward on the server")
    normals = simple.SobelNormals(Input=source)
    normals.UpdatePipeline()
    check(normals.PointData["Normals"].GetNumberOfComponents() == 3, "normals on the server")
else:
    filters = simple.SobelNormals(Input=simple.Wavelet())
    filters.UpdatePipeline()
    check(filters.PointData["Normals"] is None, "a filter that the server does not have has a result")
finish()
