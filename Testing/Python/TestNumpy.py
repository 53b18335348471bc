# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A volume goes from numpy to a picture and back to numpy; a brighter volume is a brighter picture."""

import numpy as np

import volumeoptics
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkVolume
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter


def make_image(voxels):
    image = vtkImageData()
    image.SetDimensions(voxels.shape[::-1])
    image.GetPointData().SetScalars(numpy_to_vtk(voxels.ravel(), deep=True))
    return image


def render(voxels):
    mapper = volumeoptics.vtkOpticsVolumeMapper()
    mapper.SetInputData(make_image(voxels))
    colour = vtkColorTransferFunction()
    colour.AddRGBPoint(0.0, 1.0, 1.0, 1.0)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0.0, 0.0)
    opacity.AddPoint(1.0, 0.1)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(volumeoptics.vtkOpticsVolumeProperty())
    volume.GetProperty().SetColor(colour)
    volume.GetProperty().SetScalarOpacity(opacity)
    renderer = vtkRenderer()
    renderer.AddVolume(volume)
    window = volumeoptics.vtkHeadlessRenderWindow()
    window.SetSize(120, 100)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    picture = grab.GetOutput()
    width, height, _ = picture.GetDimensions()
    return vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(height, width, 3)


z, y, x = np.mgrid[-1:1:20j, -1:1:24j, -1:1:28j]
ball = np.clip(1.0 - np.sqrt(x * x + y * y + z * z), 0.0, 1.0).astype(np.float32)
assert np.array_equal(vtk_to_numpy(make_image(ball).GetPointData().GetScalars()), ball.ravel())
bright = render(ball)
faint = render(0.25 * ball)
assert bright.shape == (100, 120, 3)
assert bright[50, 60, 0] > faint[50, 60, 0] + 20 > 20
assert bright[0, 0, 0] == 0
