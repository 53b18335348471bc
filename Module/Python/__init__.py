# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Optical models for VTK's volume rendering.

All classes of the module are attributes of this package, which is used beside vtkmodules:

    import volumeoptics
    mapper = volumeoptics.vtkOpticsVolumeMapper()

With VOLUMEOPTICS_HEADLESS in the environment, vtkRenderWindow() needs no display from then on.
"""

from .vtkVolumeOptics import *

vtkHeadlessRenderWindow.SetGlobalOverrideFromEnvironment()
