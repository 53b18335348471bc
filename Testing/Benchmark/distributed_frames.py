# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Seconds of a frame on this run's processes, in ParaView: its own Volume, and models of Volume Optics.

    VOLUMEOPTICS_PLUGIN=<...>/VolumeOptics.so mpirun -n 2 pvbatch distributed_frames.py [size] [folder]

The median of seven frames from cameras around the volume, with everything that is found once left out; the time
goes on until the first process has the whole picture. LP_NUM_THREADS=1 gives Mesa's rasteriser one core
a process. With a folder the last pictures are kept there, and those of several processes compared with those
that one process has left: largest and root mean square difference, of 255.
"""

import os
import statistics
import sys
import time

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

FRAMES = 7
MODELS = {
    "Volume, shaded": None,
    "Volume Optics, off": dict(ReflectanceModel="VTK"),
    "Blinn-Phong": dict(ReflectanceModel="Blinn-Phong"),
    "Ward": dict(ReflectanceModel="Ward"),
    "data space": dict(ReflectanceModel="VTK", IntegrationSpace="Scalar"),
    "pre-integrated": dict(IntegrationSpace="Length", Classification="Pre-integrated"),
    "occlusion": dict(Classification="Post", Occlusion=1),
    "shadows": dict(Occlusion=0, Shadows=1),
}

size = int(sys.argv[1]) if len(sys.argv) > 1 else 96
folder = sys.argv[2] if len(sys.argv) > 2 else ""
simple.LoadPlugin(os.environ["VOLUMEOPTICS_PLUGIN"], remote=False, ns=vars(simple))
processes = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()

source = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[size, size, size])
view = simple.CreateView("RenderView")
view.ViewSize = [300, 300]
view.OrientationAxesVisibility = 0
display = simple.Show(source, view)
display.SetRepresentationType("Volume")
simple.ColorBy(display, ("POINTS", "Scalars"))
opacities = simple.GetOpacityTransferFunction("Scalars")
opacities.Points = [0.0, 0.0, 0.5, 0.0, 0.4, 0.0, 0.5, 0.0, 0.6, 0.6, 0.5, 0.0, 1.0, 0.8, 0.5, 0.0]
display.Shade = display.OpticsShade = 1
display.Ambient, display.Diffuse, display.Specular = 0.2, 0.6, 0.2
display.ScalarOpacityUnitDistance = display.OpticsOpacityUnitDistance = 0.05
view.CameraPosition = [2.5, -4.0, 2.0]
view.CameraFocalPoint = [0.0, 0.0, 0.0]
view.CameraViewUp = [0.0, 0.0, 1.0]
view.CameraParallelProjection = 0


def frame():
    start = time.perf_counter()
    simple.Render(view)
    return time.perf_counter() - start


def pixels_of(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)


def keep_and_compare(name):
    file, alone = [os.path.join(folder, f"{n}-{name}.png") for n in (processes, 1)]
    simple.SaveScreenshot(file, view)
    if processes == 1 or not os.path.exists(alone):
        return ""
    difference = numpy.abs(pixels_of(file) - pixels_of(alone))
    return f"largest {difference.max():.0f}, root mean square {numpy.sqrt((difference ** 2).mean()):.2f}"


print(f"{processes} processes, {size}^3 voxels, {view.ViewSize[0]} x {view.ViewSize[1]} pixels", flush=True)
for name, settings in MODELS.items():
    display.SetRepresentationType("Volume" if settings is None else "Volume Optics")
    for key, value in (settings or {}).items():
        setattr(display, key, value)
    frame()
    seconds = []
    for _ in range(FRAMES):
        simple.GetActiveCamera().Azimuth(360.0 / FRAMES)
        seconds.append(frame())
    difference = keep_and_compare(name) if folder else ""
    print(f"{name:20} {statistics.median(seconds):8.3f} s  {difference}", flush=True)
