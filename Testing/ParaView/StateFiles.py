# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""State files and traces bring back the same picture; an older state file loads."""

import os

from paraview import simple, smstate, smtrace

import Checks
from Checks import check, check_differs, check_equal, finish, load_plugin, take_picture

SETTINGS = dict(
    OpticsShade=1,
    Specular=0.4,
    ReflectanceModel="Ward",
    WardRoughness=0.3,
    WardAnisotropyScale=4.0,
    CovarianceRadius=3.0,
    IntegrationSpace="Scalar",
    OpticsIsosurfaces=[0.4, 0.3, 0.7, 0.9],
    Silhouette="Clamped",
    UseLightingTransferFunction=1,
    LightingBoundaries=[0.0, 0.3, 0.6, 1.0, 0.1, 0.2, 0.7, 0.4],
    GradientStepLength=2.0,
    FramePrecision="16 bits",
)


class Traced:
    """What ParaView's panels do: trace the properties that are changed."""

    def __init__(self, proxy):
        self.item = smtrace.PropertiesModified(proxy) if smtrace.Trace.Output else None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.item:
            self.item.finalize()


def make_scene():
    view = simple.CreateView("RenderView")
    source = simple.AnalyticVolume(Field="Torus", Dimensions=[24, 24, 24])
    normals = simple.SobelNormals(Input=source, Scalars=["POINTS", "Scalars"])
    normals.UpdatePipeline()
    display = simple.Show(normals, view)
    with Traced(view), Traced(display):
        Checks.set_up(view)
        Checks.dress(display, view)
        display.SetRepresentationType("Volume Optics")
        for name, value in SETTINGS.items():
            setattr(display, name, value)
    return view


def start_anew():
    simple.ResetSession()


def shown(name):
    """The picture of the view that a state brought, and its representation."""
    view = simple.GetRenderViews()[0]
    source = [s for key, s in simple.GetSources().items() if "SobelNormals" in key[0]][0]
    display = simple.GetRepresentation(source, view)
    check(display.Representation == "Volume Optics", f"{name}: the representation is {display.Representation}")
    return take_picture(view, "state-" + name), display


load_plugin()
view = make_scene()
wanted = take_picture(view, "state-before")
xml = os.path.join(Checks.OUTPUT, "state.pvsm")
simple.SaveState(xml)
script = smstate.get_state()

start_anew()
simple.LoadState(xml)
pixels, display = shown("xml")
check_equal(wanted, pixels, "state file")
check(list(display.OpticsIsosurfaces) == SETTINGS["OpticsIsosurfaces"], "isosurfaces of the state file")

start_anew()
exec(compile(script, "state", "exec"), {})
check_equal(wanted, shown("python")[0], "state as Python")

start_anew()
smtrace.start_trace()
make_scene()
trace = smtrace.stop_trace()
start_anew()
exec(compile(trace, "trace", "exec"), {})
check_equal(wanted, shown("trace")[0], "trace")
for name in ("ReflectanceModel = 'Ward'", "LightingBoundaries = [", "SobelNormals("):
    check(name in trace, f"the trace has no {name}")

# A state of another set of properties: those that are unknown are left out, those that it lacks have their
# defaults.
start_anew()
simple.LoadState(os.path.join(Checks.DATA, "older.pvsm"))
pixels, display = shown("older")
check(display.ReflectanceModel == "Ward" and display.WardRoughness == 0.3, "settings of an older state file")
check(display.FramePrecision == "8 bits", "what an older state file lacks is not the default")
display.SetRepresentationType("Volume")
check_differs(pixels, take_picture(simple.GetRenderViews()[0], "state-older-stock"), "older state file")

finish()
