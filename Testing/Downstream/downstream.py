# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Renders one frame with the installed Python package, without a display."""

import sys

import volumeoptics
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume

assert volumeoptics.__file__.startswith(sys.argv[1]), volumeoptics.__file__
source = vtkRTAnalyticSource()
mapper = volumeoptics.vtkOpticsVolumeMapper()
mapper.SetInputConnection(source.GetOutputPort())
volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(volumeoptics.vtkOpticsVolumeProperty())
renderer = vtkRenderer()
renderer.AddVolume(volume)
window = volumeoptics.vtkHeadlessRenderWindow()
window.SetSize(100, 100)
window.AddRenderer(renderer)
window.Render()
pixel = vtkUnsignedCharArray()
window.GetPixelData(50, 50, 50, 50, 0, pixel, 0)
assert pixel.GetValue(0) > 20  # the background is black
