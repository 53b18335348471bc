# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""Each filter and source of the plugin, by closed cases."""

import numpy
from paraview import simple

from Checks import array_of, check, fetch, finish, load_plugin

load_plugin()


def points_of(image):
    return numpy.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])


# The gradient of a ramp along x is its direction, and one half per world length.
ramp = simple.AnalyticVolume(Field="Linear ramp", Axis=[1.0, 0.0, 0.0], Dimensions=[8, 9, 10])
normals = fetch(simple.SobelNormals(Input=ramp))
check(numpy.allclose(array_of(normals, "Normals"), [-1.0, 0.0, 0.0], atol=1e-6), "normals of a ramp")
check(numpy.allclose(array_of(normals, "GradientMagnitude"), 0.5, rtol=1e-5), "gradient of a ramp")
check(array_of(normals, "Scalars") is not None, "the input's arrays are not passed")
alone = fetch(simple.SobelNormals(Input=ramp, PassInputArrays=0))
check(array_of(alone, "Scalars") is None, "the input's arrays are passed though switched off")

# A thin cylinder along z: structures extend along z.
cylinder = simple.AnalyticVolume(Field="Cylinder", Radius=0.2, Dimensions=[24, 24, 24])
cylinder.UpdatePipeline()
for make in (
    lambda: simple.AmbientCovariance(Input=cylinder, Radius=6.0, ScalarTolerance=0.2, SamplingPattern="Exhaustive", Storage="World"),
    lambda: simple.PrincipalCurvatureAnisotropy(Input=cylinder, Storage="World"),
):
    image = fetch(make())
    tensor = array_of(image, "AmbientCovariance")
    place = points_of(image)
    radius = numpy.hypot(place[:, 0], place[:, 1])
    ring = (abs(radius - 0.2) < 0.06) & (abs(place[:, 2]) < 0.5)
    zz = -(tensor[ring, 0] + tensor[ring, 1])  # of a traceless tensor
    check(
        (zz > 0.0).all() and numpy.median(zz) > 0.1,
        f"anisotropy of a cylinder is not along its axis: {zz.min():.3f}, median {numpy.median(zz):.3f}",
    )
range_of_data = cylinder.PointData["Scalars"].GetRange()
covariance = simple.AmbientCovariance(Input=cylinder)
check(
    numpy.allclose(covariance.ScalarRange, range_of_data), f"ScalarRange is {covariance.ScalarRange} by default"
)

# Every voxel counts once; the second output too.
histogram = simple.GradientAlignedHistogram(Input=cylinder, NumberOfBins=32)
for port in (0, 1):
    counts = array_of(fetch(histogram, port), "Counts")
    check(counts.sum() == 24**3, f"histogram {port} counts {counts.sum()} of {24 ** 3} voxels")

# Lines: what is seen of them does not depend on the side, for ambient light alone.
lines = simple.VortexSpirals(NumberOfSegments=2000, SegmentsPerLine=100)
voxels = simple.AnisotropicLineVoxels(
    Input=lines, SampleDimensions=[16, 16, 16], Ambient=1.0, Diffuse=0.0, Color=[1.0, 0.5, 0.0]
)
check(fetch(voxels).GetCellData().HasArray("BrickIndex"), "no voxels of lines")
seen = []
for side in (-5.0, 5.0):
    view = simple.LineVoxelsAsSeen(Input=voxels, CameraPosition=[0.0, side, 0.0], ParallelProjection=1)
    seen.append(array_of(fetch(view), "RGBA").astype(int))
check(abs(seen[0] - seen[1]).max() <= 1, "lines in ambient light differ from behind")
drawn = seen[0][seen[0][:, 3] > 8]
check(len(drawn) > 100, f"{len(drawn)} voxels have lines")
check((abs(2 * drawn[:, 1] - drawn[:, 0]) <= 8).all() and (drawn[:, 2] <= 4).all(), "lines are not orange")
types = simple.AnisotropicLineVoxels(
    Input=lines, SampleDimensions=[8, 8, 8], LineTypeArray="LineType", ColorArray="Progress"
)
check(fetch(types).GetFieldData().GetArray("LineTypes").GetNumberOfTuples() == 2, "types of lines are not read")

# Pictures: the same one has no dissimilarity.
first = simple.AnalyticVolume(Field="Sphere", Dimensions=[32, 32, 1])
second = simple.AnalyticVolume(Field="Torus", Dimensions=[32, 32, 1])
same = array_of(fetch(simple.StructuralDissimilarity(Reference=first, Picture=first)), "StructuralDissimilarity")
other = array_of(fetch(simple.StructuralDissimilarity(Reference=first, Picture=second)), "StructuralDissimilarity")
check(abs(same).max() == 0.0, "a picture differs from itself")
check(other.mean() > 0.01, "different pictures have no dissimilarity")

finish()
