# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""What the tests in ParaView share: the plugin, scenes, pictures, and checks that end a test."""

import os

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

PLUGIN = os.environ["VOLUMEOPTICS_PLUGIN"]
BASELINES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "Baseline")
DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "Data")
OUTPUT = os.environ["VOLUMEOPTICS_OUTPUT"]

failures = []


def check(condition, message):
    if not condition:
        failures.append(message)
        print("failed:", message, flush=True)


def finish():
    """CTest looks for the words: pvbatch crashes at a sys.exit() of its own."""
    if failures:
        print(len(failures), "checks failed", flush=True)
    else:
        print("all checks passed", flush=True)


def load_plugin(remote=False):
    simple._DisableFirstRenderCameraReset()
    simple.LoadPlugin(PLUGIN, remote=remote, ns=vars(simple))
    check(hasattr(simple, "SobelNormals"), "the plugin has no filters in paraview.simple")


def make_view():
    view = simple.CreateView("RenderView")
    set_up(view)
    return view


def set_up(view, size=160):
    view.ViewSize = [size, size]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.1, 0.1, 0.15]


def show_volume(source, view, array="Scalars", association="POINTS"):
    display = simple.Show(source, view)
    dress(display, view, array, association)
    return display


def dress(display, view, array="Scalars", association="POINTS"):
    """The representation Volume with functions of the test fields, which lie in [0, 1]."""
    display.SetRepresentationType("Volume")
    simple.ColorBy(display, (association, array))
    colors = simple.GetColorTransferFunction(array)
    colors.RGBPoints = [0.0, 0.2, 0.3, 0.8, 0.5, 0.9, 0.8, 0.6, 1.0, 0.9, 0.3, 0.2]
    opacities = simple.GetOpacityTransferFunction(array)
    opacities.Points = [0.0, 0.0, 0.5, 0.0, 0.3, 0.0, 0.5, 0.0, 0.6, 0.5, 0.5, 0.0, 1.0, 0.6, 0.5, 0.0]
    display.ScalarOpacityFunction = opacities
    display.ScalarOpacityUnitDistance = display.OpticsOpacityUnitDistance = 0.1
    look_at(view)


def value_of(prop):
    data = prop.GetData()
    return list(data) if isinstance(data, servermanager.VectorProperty) else data


def look_at(view):
    view.CameraPosition = [2.5, -4.0, 2.0]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraViewAngle = 30.0


def picture_of(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels[:, :3].astype(int).reshape(image.GetDimensions()[1], image.GetDimensions()[0], 3)


def take_picture(view, name):
    file = os.path.join(OUTPUT, name + ".png")
    simple.SaveScreenshot(file, view, ImageResolution=list(view.ViewSize))
    return picture_of(file)


def largest_difference(a, b):
    return int(numpy.abs(a - b).max())


def check_equal(a, b, name, bound=0):
    difference = largest_difference(a, b)
    check(difference <= bound, f"{name}: pictures differ by {difference} of 255, more than {bound}")


def check_differs(a, b, name, least=8):
    difference = largest_difference(a, b)
    check(difference >= least, f"{name}: pictures differ by {difference} of 255 at most, less than {least}")


def check_baseline(pixels, name):
    """One code of 255: the rounding of another build of the rasteriser."""
    file = os.path.join(BASELINES, name + ".png")
    if not os.path.exists(file):
        check(False, f"{name}: no baseline; the picture is in {OUTPUT}")
        return
    baseline = picture_of(file)
    difference = numpy.abs(pixels - baseline)
    check(
        difference.mean() < 0.05 and (difference > 8).mean() < 0.001,
        f"{name}: differs from the baseline by {difference.mean():.3f} on average, {difference.max()} at most",
    )


def fetch(source, port=0):
    source.UpdatePipeline()
    return servermanager.Fetch(servermanager.OutputPort(source, port))


def array_of(data, name):
    array = data.GetPointData().GetArray(name)
    return None if array is None else vtk_to_numpy(array)
