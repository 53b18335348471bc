# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""An ellipsoid whose highlights run along it, drawn without a display.

    python3 render_ellipsoid.py [ellipsoid.png]
"""

import sys

import volumeoptics
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkVolume
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

source = volumeoptics.vtkAnalyticVolumeSource()  # any vtkImageData in its place
source.SetFieldToEllipsoid()
mapper = volumeoptics.vtkOpticsVolumeMapper()
mapper.SetInputConnection(source.GetOutputPort())
mapper.SetQualityToBalanced()

opacity = vtkPiecewiseFunction()
opacity.AddPoint(0.45, 0.0)
opacity.AddPoint(0.55, 0.9)
color = vtkColorTransferFunction()
color.AddRGBPoint(0.5, 0.45, 0.6, 0.72)

optics = volumeoptics.vtkOpticsVolumeProperty()
optics.SetScalarOpacity(opacity)
optics.SetScalarOpacityUnitDistance(0.05)
optics.SetColor(color)
optics.SetInterpolationTypeToLinear()
optics.ShadeOn()
optics.SetReflectanceModelToWard()
optics.SetFrameSourceToCurvature()  # Covariance, the default, is for structures
optics.SetAnisotropyScale(1.0)
optics.SetGlossiness(0.2)
optics.SetSpecular(0.6)

volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(optics)
renderer = vtkRenderer()
renderer.AddVolume(volume)
renderer.GetActiveCamera().SetPosition(1.0, -3.0, 0.8)
renderer.GetActiveCamera().SetFocalPoint(0.0, 0.0, 0.0)
renderer.GetActiveCamera().SetViewUp(0.0, 0.0, 1.0)
renderer.ResetCameraClippingRange()
window = volumeoptics.vtkHeadlessRenderWindow()
window.AddRenderer(renderer)
window.SetSize(400, 400)

picture = vtkWindowToImageFilter()
picture.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "ellipsoid.png")
writer.Write()
