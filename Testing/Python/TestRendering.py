# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The headless window through VTK's own class names: size, vtkTesting, the same picture twice."""

import sys

import volumeoptics
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderWindowInteractor
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkTestingRendering import vtkTesting

volumeoptics.vtkHeadlessRenderWindow.SetGlobalOverride(True)
window = vtkRenderWindow()
assert window.GetClassName() == "vtkHeadlessRenderWindow"

cone = vtkConeSource()
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(cone.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddActor(actor)
window.AddRenderer(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.Initialize()
window.SetSize(200, 150)
window.Render()

testing = vtkTesting()
for argument in sys.argv[1:]:
    testing.AddArgument(argument)
testing.SetRenderWindow(window)
baseline = testing.GetTempDirectory() + "/TestRenderingPython.png"
grab = vtkWindowToImageFilter()
grab.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(grab.GetOutputPort())
writer.SetFileName(baseline)
writer.Write()
testing.AddArgument("-V")
testing.AddArgument(baseline)
window.Finalize()
window.Render()
assert testing.RegressionTest(0.0) == vtkTesting.PASSED
