# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A script of VTK alone, run with the plugin and a preset in the environment."""

from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkVolume
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
from vtkmodules import vtkRenderingVolumeOpenGL2  # the usual import for its factory

mapper = vtkGPUVolumeRayCastMapper()
assert mapper.GetClassName() == "vtkOpticsVolumeMapper", mapper.GetClassName()
source = vtkRTAnalyticSource()
mapper.SetInputConnection(source.GetOutputPort())
volume = vtkVolume()
volume.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.AddRenderer(renderer)
window.Render()

# Only the check that the preset was read looks into the module.
import volumeoptics

optics = volumeoptics.vtkOpticsVolumeMapper.GetDefaultOptics()
assert optics.GetReflectanceModelAsString() == "Ward"
assert optics.GetGlossiness() == 0.1
assert optics.GetAnisotropyScale() == 20.0
