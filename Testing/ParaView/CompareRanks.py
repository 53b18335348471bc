# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""Compares what Ranks.py left on several ranks with what it left on one."""

import os
import sys

import numpy
from vtkmodules.vtkIOXML import vtkXMLPImageDataReader

import Checks
from Checks import array_of, check, finish, largest_difference, picture_of


def file_of(ranks, what, kind):
    return os.path.join(Checks.OUTPUT, f"ranks-{ranks}-{what}.{kind}")


def image_of(ranks, what):
    reader = vtkXMLPImageDataReader()
    reader.SetFileName(file_of(ranks, what, "pvti"))
    reader.Update()
    return reader.GetOutput()


def difference(ranks, what):
    return largest_difference(*[picture_of(file_of(n, what, "png")) for n in (1, ranks)])


ARRAYS = {
    "sobel": ("Normals", "GradientMagnitude", "Scalars"),
    "covariance": ("AmbientCovariance", "Scalars"),
    "curvature": ("AmbientCovariance",),
    "half": ("Normals",),
    "histogram": ("Counts",),
}
# What the representation Volume shows in the same scene, and one code.
STOCK = {"off": "stock"}

for ranks in map(int, sys.argv[1:]):
    for what, names in ARRAYS.items():
        one, several = image_of(1, what), image_of(ranks, what)
        check(one.GetExtent() == several.GetExtent(), f"{ranks} ranks: {what} is of {several.GetExtent()}")
        for name in names:
            same = numpy.array_equal(array_of(one, name), array_of(several, name))
            check(same, f"{ranks} ranks: {what} has another array {name}")
    for what in ("off", "ward", "lighting", "data-space", "pre-integrated") if ranks < 3 else ():
        stock = difference(ranks, STOCK.get(what, "stock-shade"))
        ours = difference(ranks, what)
        print(f"{ranks} ranks: {what} differs by {ours}, Volume by {stock}", flush=True)
        check(ours <= stock + 1, f"{ranks} ranks: {what} differs by {ours}, Volume by {stock}")

finish()
