# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""inv3_to_vti.py PROJECT.inv3 VOLUME.vti: the voxels of an InVesalius project, for the benchmarks."""

import plistlib
import sys
import tarfile

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter


def read(path):
    """Property list and voxels, from the archive in memory."""
    with tarfile.open(path) as archive:
        files = {member.name.rsplit("/", 1)[-1]: member for member in archive.getmembers() if member.isfile()}
        settings = plistlib.load(archive.extractfile(files["main.plist"]))
        voxels = numpy.frombuffer(archive.extractfile(files["matrix.dat"]).read(), numpy.int16)
    return settings, voxels


def main():
    settings, voxels = read(sys.argv[1])
    image = vtkImageData()
    image.SetDimensions(*reversed(settings["matrix"]["shape"]))
    image.SetSpacing(*settings["spacing"])
    scalars = numpy_to_vtk(voxels, deep=True)
    scalars.SetName("Scalars")
    image.GetPointData().SetScalars(scalars)
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(sys.argv[2])
    writer.SetInputData(image)
    writer.Write()


if __name__ == "__main__":
    main()
