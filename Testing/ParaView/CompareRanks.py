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
# What Volume differs by, and one code of 255, is what these may differ by.
LIKE_STOCK = {
    "off": "stock",
    "off-shade": "stock-shade",
    "vtk": "stock-shade",
    "none": "stock-shade",
    "blinn-phong": "stock-shade",
    "ward": "stock-shade",
    "ward-curvature": "stock-shade",
    "lafortune": "stock-shade",
    "data-space": "stock-shade",
    "silhouettes": "stock-shade",
    "transmitted": "stock-shade",
    "isosurfaces": "stock-shade",
    "pre-integrated": "stock-shade",
    "lighting": "stock-shade",
    "hybrid": "stock-shade",
    "rules": "stock-shade",
    "bright": "stock-shade",
    "geometry": "stock-geometry",
    "inside": "stock-inside",
    "parallel": "stock-parallel",
    "cells": "stock-cells",
    "blocks": "stock-blocks",
    "blocks-shade": "stock-blocks-shade",
    "thin": "stock-thin",
}
OF_MANY_RANKS = ("thin",)

for ranks in map(int, sys.argv[1:]):
    for what, names in ARRAYS.items():
        one, several = image_of(1, what), image_of(ranks, what)
        check(one.GetExtent() == several.GetExtent(), f"{ranks} ranks: {what} is of {several.GetExtent()}")
        for name in names:
            same = numpy.array_equal(array_of(one, name), array_of(several, name))
            check(same, f"{ranks} ranks: {what} has another array {name}")
    for what, stock in LIKE_STOCK.items():
        if ranks > 2 and what not in OF_MANY_RANKS:
            continue
        ours, theirs = difference(ranks, what), difference(ranks, stock)
        print(f"{ranks} ranks: {what} differs by {ours}, Volume by {theirs}", flush=True)
        check(ours[0] <= theirs[0] + 1, f"{ranks} ranks: {what} differs by {ours}, Volume by {theirs}")
        check(ours[1] <= theirs[1], f"{ranks} ranks: {what} differs by {ours} in the mean, Volume by {theirs}")

finish()
