# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""Compares what Ranks.py left on several ranks with what it left on one."""

import os
import sys

import numpy
from vtkmodules.vtkIOXML import vtkXMLPImageDataReader

import Checks
from Checks import array_of, check, finish, picture_of


def file_of(ranks, what, kind):
    return os.path.join(Checks.OUTPUT, f"ranks-{ranks}-{what}.{kind}")


def image_of(ranks, what):
    reader = vtkXMLPImageDataReader()
    reader.SetFileName(file_of(ranks, what, "pvti"))
    reader.Update()
    return reader.GetOutput()


def difference(ranks, what):
    one, several = [picture_of(file_of(n, what, "png")) for n in (1, ranks)]
    pixels = numpy.abs(one - several).max(axis=2)
    return pixels.max(), pixels.mean(), numpy.percentile(pixels, [90, 99, 99.9])


ARRAYS = {
    "sobel": ("Normals", "GradientMagnitude", "Scalars"),
    "covariance": ("AmbientCovariance", "Scalars"),
    "curvature": ("AmbientCovariance",),
    "half": ("Normals",),
    "histogram": ("Counts",),
}
# Of these a piece's picture is that of the whole, as the stock one is: it differs by what the stock one does, and
# one code. The others look around a sample, where a piece ends, or add light beyond opacity, which bytes cannot
# composite; docs/paraview.md has the figures.
LIKE_STOCK = {"off": "stock", "pre-integrated": "stock-shade"}
LARGEST_MEAN = 8.0
WRAPPED = 128  # sums beyond 255 that begin at 0 again

for ranks in map(int, sys.argv[1:]):
    for what, names in ARRAYS.items():
        one, several = image_of(1, what), image_of(ranks, what)
        check(one.GetExtent() == several.GetExtent(), f"{ranks} ranks: {what} is of {several.GetExtent()}")
        for name in names:
            same = numpy.array_equal(array_of(one, name), array_of(several, name))
            check(same, f"{ranks} ranks: {what} has another array {name}")
    if ranks > 2:
        continue
    for what, stock in LIKE_STOCK.items():
        ours, theirs = difference(ranks, what), difference(ranks, stock)
        print(f"{ranks} ranks: {what} differs by {ours}, Volume by {theirs}", flush=True)
        check(ours[0] <= theirs[0] + 1, f"{ranks} ranks: {what} differs by {ours}, Volume by {theirs}")
    for what in ("ward", "lighting", "data-space"):
        ours = difference(ranks, what)
        print(f"{ranks} ranks: {what} differs by {ours}", flush=True)
        check(ours[0] < WRAPPED and ours[1] < LARGEST_MEAN, f"{ranks} ranks: {what} differs by {ours}")

finish()
