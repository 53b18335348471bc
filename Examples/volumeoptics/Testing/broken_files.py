# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""broken_files.py PROGRAM BLOB: truncated, empty, lying and hostile files, given to every subcommand that reads
such files, must end in one line of error, exit code 1 and no output file; good ones of the same making in 0.

--every    all subcommands for each file; otherwise all for the first file of a format, and one in turn after.
--format   files of one format.
"""

import argparse
import gzip
import os
import sys
import tarfile

import files
from files import array, ascii_vti, nifti, nrrd, project, transfer, vti, vtp
from run_files import Judge, commands_for

HUGE = 2**31 - 1
# What is wrong with these does no harm to the data: VTK's readers need not notice.
MAY_BE_READ = "may be read: "


def broken_vti():
    yield "no voxels", ascii_vti(extent="0 -1 0 5 0 5")
    yield "negative extent", ascii_vti(extent="5 0 5 0 5 0")
    yield "overflowing extent", ascii_vti(extent=f"{-HUGE} {HUGE} {-HUGE} {HUGE} 0 {HUGE}")
    yield "huge extent", ascii_vti(extent="0 99999 0 99999 0 99999")
    yield "extent of words", ascii_vti(extent="a b c d e f")
    yield "spacing NaN", ascii_vti(spacing="nan 1 1")
    yield "spacing zero", ascii_vti(spacing="0 1 1")
    yield "spacing negative", ascii_vti(spacing="-1 1 1")
    yield "origin infinite", ascii_vti(origin="inf 0 0")
    yield "direction NaN", ascii_vti(attributes=' Direction="nan 0 0 0 1 0 0 0 1"')
    yield "fewer values", vti(array("1 2 3"))
    yield "unknown type", vti(array("1 2 3", kind="Int7"))
    yield "type of text", vti(array("1 2 3", kind="String"))
    yield "huge components", vti(array("1", more=f' NumberOfComponents="{HUGE}"'))
    yield "negative components", vti(array("1", more=' NumberOfComponents="-3"'))
    yield "no components", vti(array("1", more=' NumberOfComponents="0"'))
    yield "no array", vti("")
    yield MAY_BE_READ + "size of more", files.base64_vti(size=10**6)
    yield MAY_BE_READ + "size of overflow", files.base64_vti(size=2**64 - 1)
    yield "blocks of overflow", files.compressed_vti(blocks=2**61)
    yield "block of overflow", files.compressed_vti(size=2**63)
    yield "block of more", files.compressed_vti(size=2**20)
    yield "packed of overflow", files.compressed_vti(packed_size=2**63)
    yield "offset beyond", files.appended_vti(offset=10**9)
    yield MAY_BE_READ + "offset negative", files.appended_vti(offset=-9)
    yield MAY_BE_READ + "appended size of more", files.appended_vti(size=2**40)
    yield "another object", files.vtp()
    yield "deep nesting", b"<?xml version='1.0'?>" + 200000 * b"<VTKFile>"
    entities = "".join(f'<!ENTITY e{i + 1} "{10 * f"&e{i};"}">' for i in range(12))
    head, body = ascii_vti().split(b"\n", 1)
    yield "entities of entities", (head + b'<!DOCTYPE a [<!ENTITY e0 "1 ">' + entities.encode() + b"]>" +
                                   body.replace(b"<CellData/>", b"<CellData>&e12;</CellData>"))


def broken_nrrd():
    yield "more than it holds", nrrd(sizes="7 7 7")
    yield "huge", nrrd(sizes="99999 99999 99999")
    yield "overflowing", nrrd(sizes=f"{HUGE} {HUGE} {HUGE}")
    yield "beyond integers", nrrd(sizes="99999999999999999999 1 1")
    yield "negative", nrrd(sizes="-6 6 6")
    yield "zero", nrrd(sizes="0 6 6")
    yield "dimension of 99", nrrd(dimension="99")
    yield "dimension negative", nrrd(dimension="-3")
    yield "spacing NaN", nrrd(spacings="nan 1 1")
    yield "spacing infinite", nrrd(spacings="1 inf 1")
    yield "spacing zero", nrrd(spacings="1 0 1")
    yield "unknown type", nrrd(kind="uint7")
    yield "block type", nrrd(kind="block")
    yield "unknown encoding", nrrd(encoding="rot13")
    yield "more than its gzip holds", nrrd(sizes="7 7 7", encoding="gzip")
    yield "pattern of a format", nrrd(more="data file: %s%n 1 2 1")
    yield "pattern without end", nrrd(more="data file: %d.raw 0 9 0")
    yield "broken gzip", nrrd(encoding="gzip")[:-40]
    yield MAY_BE_READ + "gzip of nothing", nrrd(encoding="raw").replace(b"encoding: raw", b"encoding: gzip")
    yield "data elsewhere", nrrd(more="data file: /etc/passwd")
    yield "data file missing", nrrd(more="data file: missing.raw")
    yield "header without end", nrrd(more="data file: a.raw").split(b"\n\n", 1)[0]
    yield "header with a zero byte", nrrd(more="comment: \0")
    yield "no header", nrrd().split(b"\n\n", 1)[1]


def broken_nifti():
    yield "more than it holds", nifti((3, 60, 60, 60, 1, 1, 1, 1))
    yield "huge", nifti((3, 32767, 32767, 32767, 1, 1, 1, 1))
    yield "huge in time", nifti((7, 32767, 32767, 32767, 32767, 32767, 32767, 32767))
    yield "negative", nifti((3, -6, 6, 6, 1, 1, 1, 1))
    yield "zero", nifti((3, 0, 6, 6, 1, 1, 1, 1))
    yield "dimensions of 99", nifti((99, 6, 6, 6, 1, 1, 1, 1))
    yield "dimensions negative", nifti((-3, 6, 6, 6, 1, 1, 1, 1))
    yield "unknown type", nifti(kind=7, bits=7)
    yield "spacing NaN", nifti(spacing=(1.0, float("nan"), 1.0, 1.0))
    yield "spacing infinite", nifti(spacing=(1.0, float("inf"), 1.0, 1.0))
    yield "offset NaN", nifti(offset=float("nan"))
    yield "offset negative", nifti(offset=-1e9)
    yield "offset beyond", nifti(offset=1e18)
    yield MAY_BE_READ + "another size", nifti(size=12345)
    yield MAY_BE_READ + "another magic", nifti(magic=b"abc\0")
    yield "sform of zeros", nifti(sform=1)
    yield "sform NaN", nifti(sform=1, rows=12 * (float("nan"),))


def broken_project():
    """Archives, too, that would write beside their folder, link out of it, or fill the memory."""
    link, hard = tarfile.SYMTYPE, tarfile.LNKTYPE
    plist, matrix = files.plist(), files.matrix()
    yield "no archive", b"plain text"
    yield "empty archive", files.tar([])
    yield "no matrix", files.tar([files.entry("main.plist", plist)])
    yield "shape of more", project(shape=(60, 60, 60))
    yield "shape overflowing", project(shape=(2**32, 2**32, 2**32))
    yield "shape negative", project(shape=(-6, -6, 6))
    yield "shape of fractions", project(shape=(1.5, 4, 36))
    yield "shape of words", project(shape=("a", "b", "c"))
    yield "shape empty", project(shape=())
    yield "spacing NaN", project(spacing=("nan", 1, 1))
    yield "spacing zero", project(spacing=(0, 1, 1))
    yield "no matrix data", project(data=b"")
    yield "folder above", project(folder="../../")
    yield "folder above inside", project(folder="project/../../../")
    yield "absolute", project(folder="/tmp/")
    yield "file above", project(more=[files.entry("../escaped.txt", b"escaped")])
    yield "absolute file", project(more=[files.entry("/tmp/volumeoptics-escaped.txt", b"escaped")])
    yield "symbolic link", project(more=[files.entry("project/link", kind=link, target="/etc/passwd")])
    yield "hard link", project(more=[files.entry("project/link", kind=hard, target="project/main.plist")])
    yield "matrix is a link", files.tar([files.entry("main.plist", plist),
                                         files.entry("matrix.dat", kind=link, target="/dev/zero")])
    yield "a device", project(more=[files.entry("project/zero", kind=tarfile.CHRTYPE)])
    yield "entry of 2^62 bytes", project(size_of={"project/matrix.dat": 2**62})
    yield "entry of 2^63 bytes", project(size_of={"project/matrix.dat": 2**63 + 5})
    yield "entry of 2^40 bytes beside", project(more=[files.entry("project/filler", b"a")],
                                                size_of={"project/filler": 2**40})
    yield "more matrix than there is", project(size_of={"project/matrix.dat": 10**8})
    entities = "".join(f'<!ENTITY e{i + 1} "{10 * f"&e{i};"}">' for i in range(12))
    yield "entities of entities", project(shape=("&e12;", 1, 1),
                                          head=f'<!DOCTYPE a [<!ENTITY e0 "1">{entities}]>')
    yield "entity of a file", project(shape=("&e;", 1, 1), head='<!DOCTYPE a [<!ENTITY e SYSTEM "/etc/passwd">]>')
    yield "no list", files.tar([files.entry("main.plist", b""), files.entry("matrix.dat", matrix)])
    yield "deep list", files.tar([files.entry("main.plist", 100000 * b"<dict>"),
                                  files.entry("matrix.dat", matrix)])
    yield "list of zeros", files.tar([files.entry("main.plist", bytes(4096)), files.entry("matrix.dat", matrix)])


def broken_lines():
    yield "points beyond", vtp(connectivity="0 1 2 9")
    yield "points negative", vtp(connectivity="0 1 -2 3")
    yield "points far beyond", vtp(connectivity=f"0 1 2 {2**62}")
    yield "offsets beyond", vtp(offsets="2 999")
    yield "offsets descending", vtp(offsets="4 2")
    yield "offsets negative", vtp(offsets="-2 4")
    yield "offsets overflowing", vtp(offsets=f"2 {2**63 - 1}")
    yield "points NaN", vtp(points="nan 0 0 1 0 0 1 1 0 0 1 1")
    yield "points infinite", vtp(points="inf 0 0 1 0 0 1 1 0 0 1 1")
    yield "points of overflow", vtp(points="3e38 -3e38 0 1 0 0 1 1 0 0 -3e38 3e38")
    yield "points fewer", vtp(points="0 0 0")
    yield "number of points negative", vtp(number_of_points="-4")
    yield "number of points huge", vtp(number_of_points=str(2**62))
    yield "number of lines negative", vtp(number_of_lines="-1")
    yield "number of lines huge", vtp(number_of_lines=str(2**60))
    yield "no lines", vtp(connectivity="", offsets="", number_of_lines="0")
    yield MAY_BE_READ + "cells of floats", vtp(kind="Float32")
    yield "cells of bytes", vtp(kind="UInt8", connectivity="0 1 255 254")
    yield "another object", ascii_vti()


def broken_voxels(voxels):
    """voxels: what lines --voxels wrote."""
    for name in (b"BrickIndex", b"SampleDimensions", b"BrickDimensions", b"MaximumOrder", b"LineType0_BrickStarts",
                 b"LineType0_VoxelStarts", b"LineType0_Places", b"LineType0_Harmonics", b"LineType0_Coefficients"):
        yield f"no {name.decode()}", voxels.replace(b'Name="' + name + b'"', b'Name="Other"')
    yield "type 1 missing", voxels.replace(b"LineType0_", b"LineType1_")


def broken_transfer():
    yield "an array", b"[1, 2]"
    yield "a number", b"5"
    yield "no points", transfer(opacity=[])
    yield "points of three", transfer(opacity=[[0, 0, 0, 0], []])
    yield "points of words", transfer(color=[["a", "b", "c", "d"]])
    yield "opacity of 5", transfer(opacity=[[0, 5.0]])
    yield "opacity negative", transfer(opacity=[[0, -0.5]])
    yield "colour of 300", transfer(color=[[0, 300, 0, 0]])
    yield "number beyond double", transfer().replace(b"100", b"1e999")
    yield "number beyond float", transfer(opacity=[[1e300, 0.5]])
    yield "not a number", transfer().replace(b"100", b"NaN")
    yield "unitDistance zero", transfer(unitDistance=0)
    yield "unitDistance of words", transfer(unitDistance="far")
    yield "ambient negative", transfer(ambient=-1)
    yield "diffuse huge", transfer(diffuse=1e300)
    yield "shade of numbers", transfer(shade=[3])
    yield "key of two lines", transfer(**{"two\nlines\x1b[2J": 1})
    yield "key of a mebibyte", transfer(**{"k" * 2**20: 1})
    yield "isosurface of NaN", transfer(integration="data", isosurfaces=[[None, 0.5]])
    yield "deep nesting", 300000 * b"["
    yield "no text", bytes(range(256))
    yield "half a letter", transfer(integration="x").replace(b'"x"', b'"\xff\xfe"')


def broken_lighting():
    yield "an array", b"[]"
    yield "boundaries of numbers", b'{"Boundaries": [1, 2]}'
    yield "boundaries an object", b'{"Boundaries": {"a": 1}}'
    yield "range of words", files.lighting(RangeA=["a", "b"])
    yield "range of three", files.lighting(RangeA=[1, 2, 3])
    yield "range beyond double", files.lighting().replace(b"100", b"1e999")
    yield "coefficient of 5", files.lighting(Diffuse=5)
    yield "softness negative", files.lighting(Softness=-1)
    yield "unknown key", files.lighting(**{"two\nlines": 1})
    yield "table huge", b'{"Table": {"Origin": [0, 0], "Spacing": [1, 1], "Dimensions": [4096, 4096], "Values": [1]}}'
    yield "table negative", b'{"Table": {"Origin": [0, 0], "Spacing": [1, 1], "Dimensions": [-4, 4], "Values": []}}'
    yield "deep nesting", 100000 * b'{"Boundaries":['


def cut(good, parts=4):
    yield "empty", b""
    yield "of zeros", bytes(len(good))
    for part in range(1, parts):
        yield f"cut at {part}/{parts}", good[:len(good) * part // parts]


def all_cases(voxels):
    good = files.good_files()
    yield "broken.vti", broken_vti()
    yield "broken.nrrd", broken_nrrd()
    yield "broken.nii", broken_nifti()
    yield "broken.nii.gz", ((title, gzip.compress(data, mtime=0)) for title, data in broken_nifti())
    yield "broken.inv3", broken_project()
    yield "broken.vtp", broken_lines()
    yield "voxels.vti", broken_voxels(voxels)
    yield "transfer.json", broken_transfer()
    yield "lighting.json", broken_lighting()
    for name, content in good.items():
        yield name, cut(content)
    yield "voxels.vti", cut(voxels)


def make_voxels(judge, blob):
    """Anisotropic voxels of the good lines."""
    path = os.path.join(judge.root.name, "voxels.vti")
    arguments = ["lines", "FILE", "--headless", "--size", "16x16", "--grid", "8", "-o", "OUT/a.png", "--voxels",
                 path]
    judge.expect(0, "good lines", "lines.vtp", vtp(), arguments)
    with open(path, "rb") as file:
        return file.read()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("blob")
    parser.add_argument("--every", action="store_true")
    parser.add_argument("--format", default="", help="only files whose names contain this text")
    options = parser.parse_args()
    options.blob = os.path.abspath(options.blob)
    judge = Judge(options.program)
    voxels = make_voxels(judge, options.blob)
    good = {**files.good_files(), "voxels.vti": voxels}
    for name, content in good.items():
        if options.format not in name:
            continue
        judge.expect(0, "good", name, content, commands_for(name, options.blob)[0])
    for name, cases in all_cases(voxels):
        if options.format not in name:
            continue
        commands = commands_for(name, options.blob)
        for number, (title, content) in enumerate(cases):
            chosen = commands if options.every or number == 0 else [commands[number % len(commands)]]
            for arguments in chosen:
                judge.expect(None if title.startswith(MAY_BE_READ) else 1, f"{name}, {title}", name, content, arguments)
    print(f"{judge.runs} runs, {judge.failures} failures")
    return 1 if judge.failures else 0


if __name__ == "__main__":
    sys.exit(main())
