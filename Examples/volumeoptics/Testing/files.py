# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

"""Small valid files of the formats that volumeoptics reads, as bytes, made of nothing else."""

import base64
import gzip
import io
import json
import math
import struct
import tarfile
import zlib

EDGE = 6


def voxels(edge=EDGE):
    """A ball, from 0 to 250."""
    middle = (edge - 1) / 2.0
    distances = [math.dist((x, y, z), 3 * (middle,))
                 for z in range(edge) for y in range(edge) for x in range(edge)]
    return bytes(max(0, int(250 - 200 * distance / edge)) for distance in distances)


def vti(data_array, extent=None, spacing="1 1 1", origin="0 0 0", appended="", attributes="", compressor=""):
    extent = extent or f"0 {EDGE - 1} 0 {EDGE - 1} 0 {EDGE - 1}"
    return f"""<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64"{compressor}>
<ImageData WholeExtent="{extent}" Origin="{origin}" Spacing="{spacing}"{attributes}>
<Piece Extent="{extent}"><PointData Scalars="a">{data_array}</PointData><CellData/></Piece>
</ImageData>{appended}
</VTKFile>
""".encode()


def array(body="", kind="UInt8", form="ascii", more=""):
    return f'<DataArray type="{kind}" Name="a" format="{form}"{more}>{body}</DataArray>'


def ascii_vti(**settings):
    return vti(array(" ".join(map(str, voxels()))), **settings)


def base64_vti(size=None):
    data = voxels()
    text = base64.b64encode(struct.pack("<Q", len(data) if size is None else size) + data).decode()
    return vti(array(text, form="binary"))


def compressed_vti(blocks=1, size=None, last=0, packed_size=None):
    data = voxels()
    packed = zlib.compress(data)
    header = struct.pack("<4Q", blocks, len(data) if size is None else size, last,
                         len(packed) if packed_size is None else packed_size)
    text = base64.b64encode(header).decode() + base64.b64encode(packed).decode()
    return vti(array(text, form="binary"), compressor=' compressor="vtkZLibDataCompressor"')


def appended_vti(offset=0, size=None):
    data = voxels()
    head, tail = vti(array(form="appended", more=f' offset="{offset}"'),
                     appended='\n<AppendedData encoding="raw">_@</AppendedData>').split(b"@")
    return head + struct.pack("<Q", len(data) if size is None else size) + data + tail


def nrrd(sizes=f"{EDGE} {EDGE} {EDGE}", dimension="3", kind="uint8", encoding="raw", spacings="1 1 1", body=None,
         more=""):
    data = voxels() if body is None else body
    data = gzip.compress(data, mtime=0) if encoding == "gzip" else data
    return f"""NRRD0004
type: {kind}
dimension: {dimension}
sizes: {sizes}
spacings: {spacings}
endian: little
encoding: {encoding}
{more and more + chr(10)}
""".encode() + data


def nifti(dimensions=(3, EDGE, EDGE, EDGE, 1, 1, 1, 1), kind=2, bits=8, spacing=(1.0, 1.0, 1.0, 1.0), offset=352.0,
          size=348, magic=b"n+1\0", sform=0, rows=12 * (0.0,), body=None):
    header = bytearray(352)
    struct.pack_into("<i", header, 0, size)
    struct.pack_into("<8h", header, 40, *dimensions)
    struct.pack_into("<2h", header, 70, kind, bits)
    struct.pack_into("<4f", header, 76, *spacing)
    struct.pack_into("<3f", header, 108, offset, 1.0, 0.0)
    struct.pack_into("<2h", header, 252, 0, sform)
    struct.pack_into("<12f", header, 280, *rows)
    header[344:348] = magic
    return bytes(header) + (voxels() if body is None else body)


def plist(shape=(EDGE, EDGE, EDGE), spacing=(1.0, 1.0, 1.0), head=""):
    def numbers(kind, values):
        return "".join(f"<{kind}>{value}</{kind}>" for value in values)
    return f"""<?xml version="1.0" encoding="UTF-8"?>{head}
<plist version="1.0"><dict>
<key>matrix</key><dict><key>shape</key><array>{numbers("integer", shape)}</array></dict>
<key>spacing</key><array>{numbers("real", spacing)}</array>
</dict></plist>
""".encode()


def entry(name, data=b"", kind=tarfile.REGTYPE, target=""):
    info = tarfile.TarInfo(name)
    info.size = len(data)
    info.type = kind
    info.linkname = target
    return info, data


def tar(entries, size_of=None):
    """size_of: entry name -> size that its header lies of, octal or of 64 bits."""
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w", format=tarfile.GNU_FORMAT) as archive:
        for info, data in entries:
            archive.addfile(info, io.BytesIO(data))
    content = stream.getvalue()
    for name, size in (size_of or {}).items():
        at = content.index(name.encode() + b"\0")
        block = bytearray(content[at:at + 512])
        block[124:136] = b"\x80" + struct.pack(">3xQ", size) if size >= 8**11 else b"%011o\0" % size
        block[148:156] = 8 * b" "
        block[148:156] = b"%06o\0 " % sum(block)
        content = content[:at] + bytes(block) + content[at + 512:]
    return gzip.compress(content, mtime=0)


def matrix(edge=EDGE):
    return b"".join(struct.pack("<h", 4 * value) for value in voxels(edge))


def project(shape=(EDGE, EDGE, EDGE), spacing=(1.0, 1.0, 1.0), head="", data=None, more=(), size_of=None,
            folder="project/"):
    return tar([entry(folder + "main.plist", plist(shape, spacing, head)),
                entry(folder + "matrix.dat", matrix() if data is None else data), *more], size_of)


def vtp(points="0 0 0 1 0 0 1 1 0 0 1 1", connectivity="0 1 2 3", offsets="2 4", number_of_points="4",
        number_of_lines="2", point_data="", cell_data="", kind="Int64"):
    return f"""<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData><Piece NumberOfPoints="{number_of_points}" NumberOfLines="{number_of_lines}">
<PointData>{point_data}</PointData><CellData>{cell_data}</CellData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">{points}</DataArray></Points>
<Lines><DataArray type="{kind}" Name="connectivity" format="ascii">{connectivity}</DataArray>
<DataArray type="{kind}" Name="offsets" format="ascii">{offsets}</DataArray></Lines>
</Piece></PolyData></VTKFile>
""".encode()


def transfer(**replaced):
    return json.dumps({"opacity": [[0, 0.0], [100, 0.5]], "color": [[0, 1, 1, 1]], "unitDistance": 1.0,
                       "shade": True, **replaced}).encode()


def lighting(**replaced):
    boundary = {"RangeA": [0, 50], "RangeB": [100, 255], "Softness": 5, "Ambient": 0.1, "Diffuse": 0.7,
                "Specular": 0.3, **replaced}
    return json.dumps({"Boundaries": [boundary]}).encode()


def good_files():
    """Ending, or role and ending -> contents."""
    return {
        "ascii.vti": ascii_vti(), "base64.vti": base64_vti(), "zlib.vti": compressed_vti(),
        "appended.vti": appended_vti(), "raw.nrrd": nrrd(), "gzip.nrrd": nrrd(encoding="gzip"),
        "plain.nii": nifti(), "placed.nii": nifti(sform=1, rows=(1, 0, 0, 5, 0, 1, 0, 5, 0, 0, 1, 5)),
        "gzip.nii.gz": gzip.compress(nifti(), mtime=0), "project.inv3": project(), "lines.vtp": vtp(),
        "transfer.json": transfer(), "lighting.json": lighting(),
    }
