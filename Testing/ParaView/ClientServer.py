# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""A client of pvserver. Arguments: the port, and whether the plugin is on both sides, there in another version on the
server, or on the client's alone."""

import os
import sys

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

import Checks
from Checks import check, check_differs, check_equal, finish, take_picture

simple.Connect("127.0.0.1", int(sys.argv[1]))
simple._DisableFirstRenderCameraReset()
if sys.argv[2] == "both":
    simple.LoadPlugin(Checks.PLUGIN, remote=True, ns=vars(simple))
elif sys.argv[2] == "other":
    simple.LoadPlugin(os.environ["VOLUMEOPTICS_OTHER_PLUGIN"], remote=True, ns=vars(simple))
simple.LoadPlugin(Checks.PLUGIN, remote=False, ns=vars(simple))

if sys.argv[2] == "both":
    view = Checks.make_view()
    view.RemoteRenderThreshold = 0.0
    # One cell, which one of the server's ranks has: with pieces on both, Volume's samples lie elsewhere.
    cell = simple.AnalyticVolume(Field="Sphere", Dimensions=[2, 2, 2])
    cell.UpdatePipeline()
    display = Checks.show_volume(cell, view)
    stock = take_picture(view, "server-stock")
    display.SetRepresentationType("Volume Optics")
    check_equal(stock, take_picture(view, "server-optics"), "everything off, on the server")
    simple.Hide(cell, view)
    source = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[24, 24, 24])
    source.UpdatePipeline()
    display = Checks.show_volume(source, view)
    stock = take_picture(view, "server-stock")
    display.SetRepresentationType("Volume Optics")
    display.OpticsShade = 1
    display.Ambient, display.Diffuse, display.Specular = 0.2, 0.6, 0.3
    display.ReflectanceModel = "Ward"
    display.CovarianceRadius = 3.0
    check_differs(stock, take_picture(view, "server-ward"), "Ward on the server")
    normals = simple.SobelNormals(Input=source)
    normals.UpdatePipeline()
    check(normals.PointData["Normals"].GetNumberOfComponents() == 3, "normals on the server")
elif sys.argv[2] == "other":
    messages = vtkStringOutputWindow()
    usual = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(messages)
    view = Checks.make_view()
    simple.Show(simple.Wavelet(), view)
    simple.Show(simple.Sphere(), view)
    simple.Show(simple.AnalyticVolume(), view)
    vtkOutputWindow.SetInstance(usual)
    text = messages.GetOutput()
    check(text.count("load the same version on both") == 1, f"another version on the server is not said once: {text}")
    ours, theirs = os.environ["VOLUMEOPTICS_VERSION"], os.environ["VOLUMEOPTICS_OTHER_VERSION"]
    check(f"{ours} on the client and {theirs} on the server" in text, f"the versions are not named: {text}")
else:
    # ParaView asks for the plugin on the server, the panel in a dialogue; the filters are not offered.
    manager = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
    session = servermanager.ActiveConnection.Session
    check(not manager.FulfillPluginRequirements(session, True), "a server without the plugin is enough")
    check(not hasattr(simple, "SobelNormals"), "filters are offered that the server does not have")
    display = simple.Show(simple.Wavelet(), Checks.make_view())
    check("Volume Optics" not in display.GetProperty("Representation").Available, "so is the representation")
finish()
