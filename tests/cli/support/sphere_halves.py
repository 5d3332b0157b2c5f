# SPDX-License-Identifier: Apache-2.0
"""A sphere about the origin that is cut at its equator into two files, with normals of each half by itself. Standard library only."""
import json
import math
import struct

AROUND, DOWN = 24, 6


def half(side):
    """Positions and triangles of the half above (1) or below (-1) z = 0; the equator is its first row."""
    rings = [[(math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), side * math.sin(b)) for a in (2 * math.pi * i / AROUND for i in range(AROUND))]
             for b in (math.pi / 2 * j / DOWN for j in range(DOWN))]
    points, faces = [p for ring in rings for p in ring] + [(0.0, 0.0, float(side))], []
    for j in range(DOWN - 1):
        for i in range(AROUND):
            a, b, c, d = j * AROUND + i, j * AROUND + (i + 1) % AROUND, (j + 1) * AROUND + (i + 1) % AROUND, (j + 1) * AROUND + i
            faces += [(a, b, c), (a, c, d)] if side > 0 else [(a, c, b), (a, d, c)]
    for i in range(AROUND):
        a, b = (DOWN - 1) * AROUND + i, (DOWN - 1) * AROUND + (i + 1) % AROUND
        faces.append((a, b, len(points) - 1) if side > 0 else (b, a, len(points) - 1))
    return points, faces


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def own_normals(points, side):
    """Those of the sphere, but at the cut tilted by 10 degrees away from the other half, as a half that is smoothed by itself has them."""
    tilt = side * math.tan(math.radians(10))
    return [unit((x, y, tilt)) if z == 0 else unit((x, y, z)) for x, y, z in points]


def write_glb(path, side, node=None, local=lambda p: p, normals=True):
    """@param node  the placement; local: from the world into the node's space (a rigid motion)"""
    points, faces = half(side)
    placed = [local(p) for p in points]
    directions = [local(n) for n in own_normals(points, side)]
    binary = b"".join(struct.pack("<3f", *p) for p in placed) + b"".join(struct.pack("<3f", *n) for n in directions)
    first = len(binary)
    binary += b"".join(struct.pack("<3H", *f) for f in faces)
    attributes = {"POSITION": 0, "NORMAL": 1} if normals else {"POSITION": 0}
    low, high = ([f(struct.unpack("<f", struct.pack("<f", p[k]))[0] for p in placed) for k in range(3)] for f in (min, max))
    tree = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, **(node or {})}],
            "meshes": [{"primitives": [{"attributes": attributes, "indices": 2}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3", "min": low, "max": high},
                          {"bufferView": 1, "componentType": 5126, "count": len(points), "type": "VEC3"},
                          {"bufferView": 2, "componentType": 5123, "count": 3 * len(faces), "type": "SCALAR"}],
            "bufferViews": [{"buffer": 0, "byteLength": 12 * len(points)}, {"buffer": 0, "byteOffset": 12 * len(points), "byteLength": 12 * len(points)},
                            {"buffer": 0, "byteOffset": first, "byteLength": 6 * len(faces)}],
            "buffers": [{"byteLength": len(binary)}]}
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    head = struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(binary)) + struct.pack("<II", len(text), 0x4E4F534A)
    path.write_bytes(head + text + struct.pack("<II", len(binary), 0x004E4942) + binary)


def write_obj(path, side):
    points, faces = half(side)
    lines = ["# one half"] + [f"v {x!r} {y!r} {z!r}" for x, y, z in points] + [f"vn {x!r} {y!r} {z!r}" for x, y, z in own_normals(points, side)]
    path.write_text("\n".join(lines + ["f " + " ".join(f"{c + 1}//{c + 1}" for c in f) for f in faces]) + "\n")


def read_glb(path):
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length]), data[28 + length:]


def attribute(tree, binary, name):
    accessor = tree["accessors"][tree["meshes"][0]["primitives"][0]["attributes"][name]]
    view = tree["bufferViews"][accessor["bufferView"]]
    at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    return [struct.unpack_from("<3f", binary, at + view.get("byteStride", 12) * i) for i in range(accessor["count"])]


def obj_corners(path):
    """(position, normal) of each corner."""
    v, vn, corners = [], [], []
    for line in path.read_text().splitlines():
        key, *words = line.split()
        if key in ("v", "vn"):
            (v if key == "v" else vn).append(tuple(map(float, words[:3])))
        if key == "f":
            for word in words:
                numbers = word.split("/")
                corners.append((v[int(numbers[0]) - 1], vn[int(numbers[2]) - 1] if len(numbers) > 2 else None))
    return corners
