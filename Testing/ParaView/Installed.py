# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""The installed plugin, found by ParaView through PV_PLUGIN_PATH: nothing is loaded here."""

from paraview import servermanager, simple

simple._DisableFirstRenderCameraReset()
source = simple.AnalyticVolume(Field="Sphere", Dimensions=[8, 8, 8])
normals = simple.SobelNormals(Input=source)
normals.UpdatePipeline()
view = simple.CreateView("RenderView")
view.ViewSize = [64, 64]
display = simple.Show(source, view)
display.SetRepresentationType("Volume Optics")
display.ReflectanceModel = "Ward"
simple.Render(view)
if servermanager.Fetch(normals).GetPointData().GetArray("Normals") is not None:
    print("all checks passed", flush=True)
