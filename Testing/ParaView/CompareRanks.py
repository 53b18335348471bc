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


def differences(ranks, what):
    one, several = [picture_of(file_of(n, what, "png")) for n in (1, ranks)]
    return numpy.abs(one - several).max(axis=2)


def difference(ranks, what):
    pixels = differences(ranks, what)
    return pixels.max(), pixels.mean(), numpy.percentile(pixels, [90, 99, 99.9])


def share_beyond(ranks, what, bound):
    return (differences(ranks, what) > bound).mean()


ARRAYS = {
    "sobel": ("Normals", "GradientMagnitude", "Scalars"),
    "covariance": ("AmbientCovariance", "Scalars"),
    "curvature": ("AmbientCovariance",),
    "half": ("Normals",),
    "histogram": ("Counts",),
}
# What Volume differs by, and one code, is what these may differ by.
LIKE_STOCK = {
    "off": "stock",
    "ward": "stock-shade",
    "data-space": "stock-shade",
    "pre-integrated": "stock-shade",
}
# These differ by more, from causes that docs/paraview.md names: what is tested is that it does not get worse than
# the share of pixels measured there, in percent.
FARTHER_THAN_STOCK = {"lighting": 2.0}
WRAPPED = 128

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
        # Volume's samples lie elsewhere on several ranks
        check(ours[1] < theirs[1], f"{ranks} ranks: {what} differs by {ours} in the mean, Volume by {theirs}")
    largest = difference(ranks, "stock-shade")[0]
    for what, bound in FARTHER_THAN_STOCK.items():
        ours, share = difference(ranks, what), 100.0 * share_beyond(ranks, what, largest + 1)
        print(f"{ranks} ranks: {what} differs by {ours}, {share:.2f} % by more than Volume", flush=True)
        check(share < bound, f"{ranks} ranks: {what} differs by more than Volume in {share:.2f} % of the pixels")
    ours = difference(ranks, "bright")
    print(f"{ranks} ranks: bright differs by {ours}", flush=True)
    check(ours[0] < WRAPPED, f"{ranks} ranks: light passes 255 and begins at 0 again: {ours}")

finish()
