# SPDX-License-Identifier: Apache-2.0
"""Triangles with a normal a corner, to a GLB file and back.

A vertex of the file is a corner (a loop) of the mesh, in Blender's order and in object space, as float: nothing is rounded, and the
normals that come back belong to the corners of the same numbers. `rakelight smooth` joins corners by position, so it needs no shared
vertices. It may split a vertex (the corner of an n-gon with a crease across it), so corners are read back through the triangles."""
import json
import struct
from dataclasses import dataclass

import numpy as np

from .program import Failure

MAGIC, JSON_CHUNK, BIN_CHUNK = 0x46546C67, 0x4E4F534A, 0x004E4942
FLOAT, UINT32 = 5126, 5125
TYPES = {5121: np.dtype("<u1"), 5123: np.dtype("<u2"), UINT32: np.dtype("<u4"), FLOAT: np.dtype("<f4")}
WIDTHS = {"SCALAR": 1, "VEC3": 3}


@dataclass
class Part:
    """One mesh and the objects that show it."""

    name: str
    positions: np.ndarray  # [corners, 3] float32, object space
    normals: np.ndarray  # [corners, 3] float32, unit, object space
    triangles: np.ndarray  # [triangles, 3] int32, corners
    matrices: list  # object -> world: rows of 4 x 4 numbers each


def write(path, parts):
    """Meshes in the order of `parts`, and a node for each of their matrices."""
    views, accessors, meshes, nodes, blocks = [], [], [], [], []
    size = 0

    def add(array, kind, component, **more):
        nonlocal size
        data = np.ascontiguousarray(array, TYPES[component])
        views.append({"buffer": 0, "byteOffset": size, "byteLength": data.nbytes})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "type": kind,
                          "count": data.size // WIDTHS[kind], **more})
        blocks.append(data)
        size += data.nbytes
        return len(accessors) - 1

    for part in parts:
        bounds = {"min": part.positions.min(axis=0).tolist(), "max": part.positions.max(axis=0).tolist()}
        primitive = {
            "attributes": {"POSITION": add(part.positions, "VEC3", FLOAT, **bounds), "NORMAL": add(part.normals, "VEC3", FLOAT)},
            "indices": add(part.triangles, "SCALAR", UINT32),
        }
        meshes.append({"name": part.name, "primitives": [primitive]})
        for matrix in part.matrices:
            columns = [float(matrix[row][column]) for column in range(4) for row in range(4)]
            nodes.append({"name": part.name, "mesh": len(meshes) - 1, "matrix": columns})
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": meshes,
        "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": size}],
    }, allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    total = 12 + 8 + len(text) + 8 + size
    if total >= 2**32:
        raise Failure(f"The selected objects need {total / 2**30:.1f} GiB, and a GLB file holds 4")
    with open(path, "wb") as file:
        file.write(struct.pack("<3I2I", MAGIC, 2, total, len(text), JSON_CHUNK) + text + struct.pack("<2I", size, BIN_CHUNK))
        for block in blocks:
            file.write(block)


def read_normals(path, parts):
    """A list of [corners, 3] float32 arrays, in the order of `parts`, object space, unit. Throws Failure where the file is not that of
    `parts`: nothing is guessed."""
    try:
        document, binary = read_chunks(path)
        meshes = document["meshes"]
        if len(meshes) < len(parts):
            raise ValueError("meshes are missing")
        return [corner_normals(document, binary, mesh, part) for mesh, part in zip(meshes, parts)]
    except (OSError, ValueError, KeyError, IndexError, TypeError, struct.error) as error:
        raise Failure(f"What rakelight wrote cannot be read back: {error}") from None


def read_chunks(path):
    with open(path, "rb") as file:
        data = file.read()
    magic, version, _, length, kind = struct.unpack_from("<5I", data)
    if (magic, version, kind) != (MAGIC, 2, JSON_CHUNK):
        raise ValueError("not a GLB file")
    _, kind = struct.unpack_from("<2I", data, 20 + length)
    if kind != BIN_CHUNK:
        raise ValueError("no binary chunk")
    return json.loads(data[20 : 20 + length]), memoryview(data)[28 + length :]


def read_accessor(document, binary, number):
    accessor = document["accessors"][number]
    view = document["bufferViews"][accessor["bufferView"]]
    kind, width = TYPES[accessor["componentType"]], WIDTHS[accessor["type"]]
    stride = view.get("byteStride", kind.itemsize * width)
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    # numpy checks that the array lies within the buffer, and throws TypeError where it does not.
    return np.ndarray((accessor["count"], width), kind, binary, start, (stride, kind.itemsize))


def corner_normals(document, binary, mesh, part):
    primitive = mesh["primitives"][0]
    attributes = primitive["attributes"]
    vertices = read_accessor(document, binary, primitive["indices"])[:, 0].astype(np.int64)
    corners = part.triangles.reshape(-1)
    if len(vertices) != len(corners):
        raise ValueError(f"{part.name}: {len(vertices) // 3} triangles in place of {len(corners) // 3}")
    if not np.array_equal(read_accessor(document, binary, attributes["POSITION"])[vertices], part.positions[corners]):
        raise ValueError(f"{part.name}: vertices have moved")
    normals = part.normals.copy()
    # Backwards: of several triangles at a corner of an n-gon the first one counts, as for OBJ files.
    normals[corners[::-1]] = read_accessor(document, binary, attributes["NORMAL"])[vertices[::-1]]
    if not np.isfinite(normals).all():
        raise ValueError(f"{part.name}: a normal is not finite")
    return normals
