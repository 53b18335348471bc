# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Seconds of a frame on this run's processes, in ParaView: its own Volume, and models of Volume Optics.

    VOLUMEOPTICS_PLUGIN=<...>/VolumeOptics.so mpirun -n 2 pvbatch distributed_frames.py [size [folder [x,y,z]]]

The median of five frames from cameras around the volume, with everything that is found once left out; the time
goes on until the first process has the whole picture. LP_NUM_THREADS=1 gives Mesa's rasteriser one core
a process. With a folder the last pictures are kept there, and those of several processes compared with those
that one process has left: largest and mean absolute difference, of 255, peak signal-to-noise ratio, and by how much
the picture is brighter in the mean. The view's smoothing of edges is off.

With a place of the camera (x,y,z, the volume lies in [-1, 1]) it stays there: along the axis that the volume is parted
across, one piece lies behind the other.

In the end the memory of each process, resident, in MiB. With PARAVIEW_LOG_RENDERING_VERBOSITY=INFO each process says
by ICET_BYTES_SENT what it has sent for a frame.
"""

import os
import statistics
import sys
import time

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

FRAMES = 5
# Ward last: the ghost layers that it asks for stay, and would serve the others.
MODELS = {
    "Volume, shaded": None,
    "Volume Optics, off": dict(ReflectanceModel="VTK"),
    "Blinn-Phong": dict(ReflectanceModel="Blinn-Phong"),
    "occlusion": dict(Occlusion=1),
    "shadows": dict(Occlusion=0, Shadows=1),
    "data space": dict(Shadows=0, IntegrationSpace="Scalar"),
    "pre-integrated": dict(IntegrationSpace="Length", Classification="Pre-integrated"),
    "lighting": dict(
        Classification="At samples",
        ReflectanceModel="VTK",
        UseLightingTransferFunction=1,
        LightingBoundaries=[0.0, 0.3, 0.6, 1.0, 0.1, 0.2, 0.7, 0.4],
        GradientStepLength=2.0,
    ),
    "Ward": dict(UseLightingTransferFunction=0, ReflectanceModel="Ward"),
}

size = int(sys.argv[1]) if len(sys.argv) > 1 else 96
folder = sys.argv[2] if len(sys.argv) > 2 else ""
place = [float(number) for number in sys.argv[3].split(",")] if len(sys.argv) > 3 else None
simple.LoadPlugin(os.environ["VOLUMEOPTICS_PLUGIN"], remote=False, ns=vars(simple))
processes = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()

source = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[size, size, size])
view = simple.CreateView("RenderView")
view.ViewSize = [200, 200]
view.OrientationAxesVisibility = 0
view.UseFXAA = 0
display = simple.Show(source, view)
display.SetRepresentationType("Volume")
simple.ColorBy(display, ("POINTS", "Scalars"))
opacities = simple.GetOpacityTransferFunction("Scalars")
opacities.Points = [0.0, 0.0, 0.5, 0.0, 0.4, 0.0, 0.5, 0.0, 0.6, 0.6, 0.5, 0.0, 1.0, 0.8, 0.5, 0.0]
display.Shade = display.OpticsShade = 1
display.Ambient, display.Diffuse, display.Specular = 0.2, 0.6, 0.2
display.ScalarOpacityUnitDistance = display.OpticsOpacityUnitDistance = 0.05
view.CameraPosition = place or [2.5, -4.0, 2.0]
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
    ours, theirs = pixels_of(file), pixels_of(alone)
    difference = ours - theirs
    square = (difference**2).mean()
    decibels = 10.0 * numpy.log10(255.0**2 / square) if square > 0.0 else numpy.inf
    return (
        f"largest {numpy.abs(difference).max():.0f}, mean {numpy.abs(difference).mean():.2f}, {decibels:.1f} dB, "
        f"brighter by {difference.mean():+.2f} of {theirs.mean():.0f}"
    )


print(f"{processes} processes, {size}^3 voxels, {view.ViewSize[0]} x {view.ViewSize[1]} pixels", flush=True)
for name, settings in MODELS.items():
    display.SetRepresentationType("Volume" if settings is None else "Volume Optics")
    for key, value in (settings or {}).items():
        setattr(display, key, value)
    frame()
    seconds = []
    for _ in range(FRAMES):
        simple.GetActiveCamera().Azimuth(0.0 if place else 360.0 / FRAMES)
        seconds.append(frame())
    difference = keep_and_compare(name) if folder else ""
    print(f"{name:20} {statistics.median(seconds):8.3f} s  {difference}", flush=True)

memory = servermanager.vtkPVMemoryUseInformation()
session = servermanager.ActiveConnection.Session
session.GatherInformation(session.SERVERS, memory, 0)
resident = [memory.GetProcMemoryUse(process) / 1024.0 for process in range(memory.GetSize())]
print("memory, MiB:", ", ".join(f"{one:.0f}" for one in resident), flush=True)
