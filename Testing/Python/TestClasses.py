# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package: its classes beside vtkmodules, and their settings."""

import os
import tempfile

import volumeoptics
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume, vtkVolumeProperty
from vtkmodules.vtkRenderingVolume import (
    vtkGPUVolumeRayCastMapper,
    vtkProjectedTetrahedraMapper,
    vtkUnstructuredGridVolumeRayCastMapper,
)
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper


def check_property():
    optics = volumeoptics.vtkOpticsVolumeProperty()
    assert isinstance(optics, vtkVolumeProperty)
    optics.SetReflectanceModelToLafortune()
    assert optics.GetReflectanceModelAsString() == "Lafortune"
    optics.SetGlossiness(50.0)
    optics.SetGlossiness(optics.Ward, 0.1)
    optics.SetAnisotropyScale(20.0)
    assert optics.GetGlossiness() == 50.0
    assert optics.GetGlossiness(optics.Ward) == 0.1
    assert optics.GetAnisotropyScale() == 20.0
    optics.SpecularFromExtinctionOff()
    assert not optics.GetSpecularFromExtinction()
    optics.SetScatteringAnisotropy(0.25)
    assert optics.GetScatteringAnisotropy() == 0.25
    optics.OcclusionOn()
    optics.SetOcclusionAngle(45.0)
    optics.SetAmbientColor(0.5, 0.75, 1.0)
    optics.ShadowsOn()
    optics.SetShadowAngle(5.0)
    assert optics.GetOcclusion() and optics.GetShadows()
    assert optics.GetOcclusionAngle() == 45.0 and optics.GetShadowAngle() == 5.0
    assert optics.GetAmbientColor() == (0.5, 0.75, 1.0)
    volume = vtkVolume()
    volume.SetProperty(optics)
    assert volume.GetProperty() is optics
    copied = volumeoptics.vtkOpticsVolumeProperty()
    copied.DeepCopy(optics)
    assert copied.GetGlossiness() == 50.0


def check_override():
    mapper_class = volumeoptics.vtkOpticsVolumeMapper
    assert issubclass(mapper_class, vtkOpenGLGPUVolumeRayCastMapper)
    assert vtkGPUVolumeRayCastMapper().GetClassName() == "vtkOpenGLGPUVolumeRayCastMapper"
    mapper_class.SetGlobalOverride(True)
    assert vtkGPUVolumeRayCastMapper().GetClassName() == "vtkOpticsVolumeMapper"
    mapper_class.SetGlobalOverride(False)
    assert vtkGPUVolumeRayCastMapper().GetClassName() == "vtkOpenGLGPUVolumeRayCastMapper"


def check_preset():
    optics = volumeoptics.vtkOpticsVolumeProperty()
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "ward.json")
        with open(name, "w", encoding="ascii") as file:
            file.write('{"ReflectanceModel": "Ward", "Glossiness": 0.1}')
        assert volumeoptics.vtkOpticsPreset.Read(name, optics)
        assert optics.GetReflectanceModelAsString() == "Ward" and optics.GetGlossiness() == 0.1
    volumeoptics.vtkOpticsVolumeMapper.SetDefaultOptics(optics)
    assert volumeoptics.vtkOpticsVolumeMapper.GetDefaultOptics() is optics
    volumeoptics.vtkOpticsVolumeMapper.SetDefaultOptics(None)


def check_table():
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0.0, 0.5)
    color = vtkColorTransferFunction()
    color.AddRGBPoint(0.0, 0.25, 0.5, 1.0)
    table = volumeoptics.vtkPreIntegratedTable()
    table.SetOpacityFunction(opacity)
    table.SetColorFunction(color)
    table.SetSize(4)
    assert table.Update()
    assert len(table.GetEntries()) == 64 and table.GetEntries()[:3] == (0.25, 0.5, 1.0)
    assert len(table.GetCumulative()) == 4 and len(table.GetDepthsBehind()) == 8
    rgba = [0.0] * 4
    table.GetEntry(0.0, 1.0, rgba)
    assert rgba[:3] == [0.25, 0.5, 1.0] and abs(rgba[3] - 69.3147) < 1e-3


check_table()
def check_unstructured():
    mapper = vtkUnstructuredGridVolumeRayCastMapper()
    mapper.SetRayIntegrator(volumeoptics.vtkDataSpaceRayIntegrator())
    mapper.SetRayCastFunction(volumeoptics.vtkDataSpaceRayCastFunction())
    assert mapper.GetRayIntegrator().GetTableSize() == 256
    assert not mapper.GetRayCastFunction().GetMultipliesByGradient()
    projected = volumeoptics.vtkDataSpaceProjectedTetrahedraMapper()
    assert isinstance(projected, vtkProjectedTetrahedraMapper)
    projected.SetTableSize(64)
    assert projected.GetTableSize() == 64


check_property()
check_override()
check_preset()
check_unstructured()
for name in dir(volumeoptics):
    wrapped = getattr(volumeoptics, name)
    if isinstance(wrapped, type) and name.startswith("vtk"):
        try:
            assert wrapped.__name__ in str(wrapped()), name
        except TypeError as error:
            assert "abstract" in str(error), error
