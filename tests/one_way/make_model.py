#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes moving.glb, in which everything moves that a clip can move: nodes, joints, morph weights, materials. Standard library only."""
import json
import math
import pathlib
import struct
import zlib

blob = bytearray()
document = {
    "asset": {"version": "2.0", "generator": "tests/one_way/make_model.py"},
    "extensionsUsed": ["KHR_animation_pointer", "KHR_materials_clearcoat"],
    "buffers": [], "bufferViews": [], "accessors": [], "images": [], "textures": [], "samplers": [{"wrapS": 10497, "wrapT": 10497}],
    "materials": [], "meshes": [], "nodes": [], "skins": [], "animations": [], "cameras": [], "scenes": [{"nodes": []}], "scene": 0,
}
KINDS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
CODES = {"f": 5126, "H": 5123}


def view(data):
    while len(blob) % 4:
        blob.append(0)
    document["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(data)})
    blob.extend(data)
    return len(document["bufferViews"]) - 1


def accessor(rows, kind, code="f"):
    rows = [row if isinstance(row, (tuple, list)) else (row,) for row in rows]
    flat = [value for row in rows for value in row]
    entry = {"bufferView": view(struct.pack(f"<{len(flat)}{code}", *flat)), "componentType": CODES[code], "count": len(rows), "type": kind}
    assert len(flat) == len(rows) * KINDS[kind]
    if code == "f":
        entry["min"] = [struct.unpack("f", struct.pack("f", min(column)))[0] for column in zip(*rows)]
        entry["max"] = [struct.unpack("f", struct.pack("f", max(column)))[0] for column in zip(*rows)]
    document["accessors"].append(entry)
    return len(document["accessors"]) - 1


def texture(size, color):
    """A PNG of size x size RGB texels."""
    rows = b"".join(b"\0" + bytes(c for x in range(size) for c in color(x, y)) for y in range(size))

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
    document["images"].append({"bufferView": view(png), "mimeType": "image/png"})
    document["textures"].append({"source": len(document["images"]) - 1, "sampler": 0})
    return len(document["textures"]) - 1


def grid(across, down, place):
    """Positions, texture coordinates and triangles of place(u, v), u and v from 0 to 1."""
    places, coordinates, triangles = [], [], []
    for j in range(down + 1):
        for i in range(across + 1):
            u, v = i / across, j / down
            places.append(place(u, v))
            coordinates.append((u, v))
    for j in range(down):
        for i in range(across):
            a, b = j * (across + 1) + i, (j + 1) * (across + 1) + i
            triangles += [a, b, a + 1, a + 1, b, b + 1]
    return places, coordinates, triangles


def mesh(name, shape, material, targets=(), **more):
    places, coordinates, triangles = shape
    attributes = {"POSITION": accessor(places, "VEC3")}
    if coordinates:
        attributes["TEXCOORD_0"] = accessor(coordinates, "VEC2")
    for key, (rows, kind, code) in more.items():
        attributes[key] = accessor(rows, kind, code)
    primitive = {"attributes": attributes, "indices": accessor(triangles, "SCALAR", "H"), "material": material}
    if targets:
        primitive["targets"] = [{"POSITION": accessor(rows, "VEC3")} for rows in targets]
    document["meshes"].append({"name": name, "primitives": [primitive]})
    return len(document["meshes"]) - 1


def node(parent=None, **values):
    document["nodes"].append(values)
    index = len(document["nodes"]) - 1
    (document["scenes"][0]["nodes"] if parent is None else document["nodes"][parent].setdefault("children", [])).append(index)
    return index


def clip(name, *channels):
    """A channel: node or pointer, path, kind of its values, values at the seconds 0, 0.5 and 1."""
    out = {"name": name, "samplers": [], "channels": []}
    for target, path, kind, values in channels:
        out["samplers"].append({"input": accessor([0, 0.5, 1], "SCALAR"), "output": accessor(values, kind)})
        to = {"node": target, "path": path} if path != "pointer" else {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": target}}}
        out["channels"].append({"sampler": len(out["samplers"]) - 1, "target": to})
    document["animations"].append(out)


def sphere(radius):
    return lambda u, v: (
        radius * math.sin(math.pi * v) * math.sin(2 * math.pi * u), radius * math.cos(math.pi * v), radius * math.sin(math.pi * v) * math.cos(2 * math.pi * u))


def turn(angle, axis):
    return (*(math.sin(angle / 2) * a for a in axis), math.cos(angle / 2))


def main():
    checks = texture(16, lambda x, y: (230, 120, 60) if (x // 4 + y // 4) % 2 else (60, 140, 220))
    bumps = texture(16, lambda x, y: (128 + int(60 * math.sin(x * math.pi / 4)), 128 + int(60 * math.sin(y * math.pi / 4 + 1)), 225))
    document["materials"] = [
        {"name": "checks", "pbrMetallicRoughness": {"baseColorTexture": {"index": checks}, "metallicFactor": 0.2, "roughnessFactor": 0.5},
         "normalTexture": {"index": bumps}},
        {"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.1, 0.1, 1], "metallicFactor": 0, "roughnessFactor": 0.7}, "doubleSided": True,
         "extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 0.3}}},
        {"name": "glass", "alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [0.2, 0.8, 0.4, 0.5], "metallicFactor": 0, "roughnessFactor": 0.4},
         "doubleSided": True},
    ]
    ball = grid(14, 8, sphere(0.6))
    heat = [(math.sin(4 * p[0]) + p[1],) for p in ball[0]]
    ball = mesh("ball", ball, 0, _HEAT=(heat, "SCALAR", "f"))
    pillow = grid(4, 4, lambda u, v: (0.8 * u - 0.4, 0.8 * v - 0.4, 0.0))
    raised = [(0.0, 0.0, 0.5 * math.sin(math.pi * u) * math.sin(math.pi * v)) for u, v in pillow[1]]
    pillow = mesh("pillow", pillow, 2, [raised])
    document["meshes"][pillow]["weights"] = [0.2]
    strip = grid(2, 8, lambda u, v: (0.5 * u - 0.25, 1.2 * v - 0.6, 0.0))
    joints = [(0, 1, 0, 0)] * len(strip[0])
    weights = [(1 - v, v, 0, 0) for _, v in strip[1]]
    strip = mesh("strip", strip, 1, JOINTS_0=(joints, "VEC4", "H"), WEIGHTS_0=(weights, "VEC4", "f"))
    # Two boards at an angle, a little apart, without texture coordinates: borders that nearly meet.
    for name, width, points in (("left", 1, [(-1.2, -0.9, 0.3), (-0.82, -0.9, 0.5)]), ("right", 2, [(-0.8, -0.9, 0.5), (-0.4, -0.9, 0.3)])):
        a, b = points
        places, _, triangles = grid(1, width, lambda u, v: (a[0] + u * (b[0] - a[0]), a[1] + 0.5 * (1 - v), a[2] + u * (b[2] - a[2])))
        board = mesh(name + " board", (places, None, triangles), 1)
        node(name=name + " board", mesh=board)
    at_ball = node(name="ball", mesh=ball, translation=[-0.5, 0.2, 0])
    at_pillow = node(name="pillow", mesh=pillow, translation=[0.2, -0.5, 0.7])
    lower = node(name="lower", translation=[0.9, -0.6, 0])
    upper = node(lower, name="upper", translation=[0, 1.2, 0])
    bind = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0.6, 0, 1], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.6, 0, 1]]
    document["skins"].append({"joints": [lower, upper], "inverseBindMatrices": accessor(bind, "MAT4")})
    node(name="strip", mesh=strip, skin=0)
    document["cameras"].append({"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.5, "zfar": 20}})
    eye = node(name="eye", camera=0, translation=[0.3, 0.4, 3.6])
    clip(
        "everything",
        (at_ball, "translation", "VEC3", [(-0.5, 0.2, 0), (-0.2, 0.5, 0.2), (-0.6, 0.1, 0.4)]),
        (at_ball, "rotation", "VEC4", [turn(0, (0, 1, 0)), turn(0.8, (0, 1, 0)), turn(1.6, (0, 1, 0))]),
        (upper, "rotation", "VEC4", [turn(0, (0, 0, 1)), turn(0.7, (0, 0, 1)), turn(-0.4, (0, 0, 1))]),
        (at_pillow, "weights", "SCALAR", [0.2, 1.0, -0.5]),
        (eye, "translation", "VEC3", [(0.3, 0.4, 3.6), (0.6, 0.4, 3.4), (0.9, 0.5, 3.2)]),
        ("/materials/0/pbrMetallicRoughness/baseColorFactor", "pointer", "VEC4", [(1, 1, 1, 1), (0.4, 1, 0.4, 1), (1, 0.5, 1, 1)]),
        ("/materials/1/pbrMetallicRoughness/roughnessFactor", "pointer", "SCALAR", [0.7, 0.2, 0.5]),
        ("/materials/2/pbrMetallicRoughness/baseColorFactor", "pointer", "VEC4", [(0.2, 0.8, 0.4, 0.5), (0.2, 0.3, 0.9, 0.8), (0.9, 0.8, 0.4, 0.3)]),
    )
    clip(
        "other",
        (at_ball, "rotation", "VEC4", [turn(0.3, (1, 0, 0)), turn(-0.8, (1, 0, 0)), turn(1.2, (1, 0, 0))]),
        (at_pillow, "weights", "SCALAR", [1.0, 0.0, 0.6]),
    )
    while len(blob) % 4:
        blob.append(0)
    document["buffers"] = [{"byteLength": len(blob)}]
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    whole = struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(blob))
    whole += struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(blob), 0x004E4942) + bytes(blob)
    pathlib.Path(__file__).with_name("moving.glb").write_bytes(whole)


if __name__ == "__main__":
    main()
