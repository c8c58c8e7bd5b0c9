"""Reads the parts of fields.pvd and its .vtu files that the report needs: Float32 in zlib blocks, appended as they
are, or in base64 within the XML, as upbead 0.1.0 wrote them until fields were appended.

Format: VTK User's Guide, "XML file formats"; patches of (n + 1)^2 points and n^2 cells each.
"""

import base64
import struct
import zlib
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from ..errors import UserError

TYPES = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "Int64": "<i8", "UInt8": "u1", "UInt32": "<u4"}


def times(pvd):
    """[(time, path)] of a .pvd; raises UserError if it is no .pvd."""
    try:
        root = ElementTree.parse(pvd).getroot()
        return [(float(item.get("timestep")), Path(pvd).parent / item.get("file")) for item in root.iter("DataSet")]
    except (ElementTree.ParseError, TypeError, ValueError) as error:
        raise UserError(f"'{pvd}' is no collection of fields: {error}") from error


def arrays(path, wanted):
    """{name: array} of the wanted arrays of a .vtu; 'points' are the coordinates."""
    try:
        text, appended = parts(Path(path).read_bytes())
        found = {}
        for item in ElementTree.fromstring(text).iter("DataArray"):
            name = item.get("Name") or "points"
            if name in wanted:
                values = decoded(item, appended)
                components = int(item.get("NumberOfComponents") or 1)
                found[name] = values.reshape(-1, components) if components > 1 else values
        return found
    except (OSError, ElementTree.ParseError, KeyError, ValueError, struct.error, zlib.error) as error:
        raise UserError(f"cannot read the fields in '{path}': {error}") from error


def regions(path):
    """(names, number of each small cell): the regions of a .vtu; ([], None) in files of before they had them."""
    numbers = arrays(path, ("region",)).get("region")
    root = ElementTree.fromstring(parts(Path(path).read_bytes())[0])
    texts = next((item.text or "" for item in root.iter("DataArray") if item.get("Name") == "region_names"), "")
    names = bytes(map(int, texts.split())).decode(errors="replace").split("\0")[:-1]
    return names, numbers


def parts(content):
    """The XML of a file, and the bytes appended to it."""
    head, mark, rest = content.partition(b"<AppendedData")
    if not mark:
        return content, b""
    return head + b"</VTKFile>", rest[rest.index(b"_") + 1 :]


def decoded(item, appended):
    """Numbers of a DataArray: count, sizes of blocks (UInt32), then the blocks, each compressed."""
    if item.get("format") == "appended":
        place = int(item.get("offset"))
        (count,) = struct.unpack_from("<I", appended, place)
        lengths = struct.unpack_from(f"<{3 + count}I", appended, place)[3:]
        raw, place = appended, place + 4 * (3 + count)
    else:
        text = "".join(item.text.split())
        (count,) = struct.unpack("<I", base64.b64decode(text[:8])[:4])
        size = 4 * (3 + count)
        coded = (size + 2) // 3 * 4
        lengths = struct.unpack(f"<{3 + count}I", base64.b64decode(text[:coded])[:size])[3:]
        raw, place = base64.b64decode(text[coded:]), 0
    blocks = []
    for length in lengths:
        blocks.append(zlib.decompress(raw[place : place + length]))
        place += length
    return np.frombuffer(b"".join(blocks), TYPES[item.get("type")])


def corners(points, cells):
    """For each patch, the indices of its four corners in order, from the numbers of points and cells."""
    share = (cells / points) ** 0.5
    n = round(share / (1.0 - share))
    size = (n + 1) ** 2
    if points % size or cells != points // size * n * n:
        raise UserError("the fields are not made of patches of one size")
    first = size * np.arange(points // size)[:, None]
    return first + np.array([0, n, size - 1, size - 1 - n])
