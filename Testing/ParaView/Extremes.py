# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""Data that a representation may meet: missing arrays, cells, slices, blocks that differ, time, lines."""

import os

import numpy
from paraview import simple

import Checks
from Checks import check, check_differs, check_equal, finish, load_plugin, take_picture


def draw_by_ward(display):
    display.SetRepresentationType("Volume Optics")
    display.OpticsShade = 1
    display.Ambient, display.Diffuse, display.Specular = 0.2, 0.6, 0.3
    display.ReflectanceModel = "Ward"
    display.CovarianceRadius = 3.0


def resident_memory():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


load_plugin()
view = Checks.make_view()
empty = take_picture(view, "extreme-empty")
source = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[24, 24, 24])
source.UpdatePipeline()
display = Checks.show_volume(source, view)
draw_by_ward(display)
points = take_picture(view, "extreme-points")

display.ColorArrayName = ["POINTS", "nothing"]
check_equal(empty, take_picture(view, "extreme-no-array"), "an array that is not there")
display.ColorArrayName = ["POINTS", ""]
check_equal(empty, take_picture(view, "extreme-unnamed"), "no array")
display.ColorArrayName = ["POINTS", "Scalars"]
check_equal(points, take_picture(view, "extreme-array-again"), "the array again")
simple.Hide(source, view)

cells = simple.PointDatatoCellData(Input=source)
display = Checks.show_volume(cells, view, "Scalars", "CELLS")
draw_by_ward(display)
check_differs(empty, take_picture(view, "extreme-cells"), "cell data")
simple.Hide(cells, view)

# A slice is no volume: the picture is the stock one, whatever that is.
flat = simple.AnalyticVolume(Field="Vortex tubes", Dimensions=[24, 24, 1])
flat.UpdatePipeline()
display = Checks.show_volume(flat, view)
stock = take_picture(view, "extreme-slice-stock")
display.SetRepresentationType("Volume Optics")
check_equal(stock, take_picture(view, "extreme-slice"), "a slice")
draw_by_ward(display)
take_picture(view, "extreme-slice-ward")
simple.Hide(flat, view)

# A block without the array is left out.
other = simple.RenameArrays(Input=source, PointArrays=["Scalars", "Others"])
blocks = simple.GroupDatasets(Input=[source, other])
display = Checks.show_volume(blocks, view)
draw_by_ward(display)
check_equal(points, take_picture(view, "extreme-blocks"), "a block without the array")
simple.Hide(blocks, view)

# Time: what is kept for a frame goes with the data that it belongs to.
simple.Show(source, view)
source.Dimensions = [64, 64, 64]
memory = []
for step in range(12):
    source.Seed = step + 2
    simple.Render(view)
    memory.append(resident_memory())
growth = memory[-1] - memory[3]
bytes_of_frames = 64**3 * 4 * 7 / 2**20  # normals, magnitudes, anisotropy
check(growth < 2.0 * bytes_of_frames, f"memory grows by {growth:.0f} MiB in 8 steps: {memory}")
simple.Hide(source, view)

# Lines as voxels are drawn as lines.
lines = simple.VortexSpirals(NumberOfSegments=20000)
voxels = simple.AnisotropicLineVoxels(Input=lines, SampleDimensions=[32, 32, 32], Radius=0.005, Color=[1.0, 0.5, 0.0])
voxels.UpdatePipeline()
display = simple.Show(voxels, view)
display.SetRepresentationType("Volume Optics")
display.ColorArrayName = ["CELLS", "BrickIndex"]
drawn = take_picture(view, "extreme-lines")
check_differs(empty, drawn, "lines")
lit = drawn[drawn[:, :, 0] > 150]
check(len(lit) > 50 and (abs(lit[:, 1] - lit[:, 0] / 2) < 40).all(), "lines are not orange")
display.LineRadiusScale = 0.0
check_equal(empty, take_picture(view, "extreme-lines-hidden"), "lines of no radius")

finish()
