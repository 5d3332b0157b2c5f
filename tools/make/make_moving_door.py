#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A door that moves: data/motion/door.gltf. Clips: 'swing' turns it on its hinge, 'slide' pushes it aside and lifts its upper edge
(a morph target) from 0.5 to 2.5 s, 'fly' moves the camera.

  make_moving_door.py [FILE]        default: data/motion/door.gltf"""
import base64
import json
import pathlib
import struct
import sys

BYTES, VIEWS, ACCESSORS = bytearray(), [], []
FLOAT, USHORT = 5126, 5123


def accessor(rows, kind, component=FLOAT, target=None):
    """An array behind those before. @return its number"""
    rows = [row if isinstance(row, (list, tuple)) else [row] for row in rows]
    flat = [number for row in rows for number in row]
    data = struct.pack(f"<{len(flat)}{'f' if component == FLOAT else 'H'}", *flat)
    VIEWS.append({"buffer": 0, "byteOffset": len(BYTES), "byteLength": len(data)} | ({"target": target} if target else {}))
    BYTES.extend(data + bytes(-len(data) % 4))
    ACCESSORS.append({"bufferView": len(VIEWS) - 1, "componentType": component, "count": len(rows), "type": kind,
                      "min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]})
    return len(ACCESSORS) - 1


def slab(low, high):
    """Positions, normals and triangles of a box whose faces have corners of their own."""
    positions, normals, indices = [], [], []
    for axis in range(3):
        for side in (0, 1):
            base = len(positions)
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                p, n = [0, 0, 0], [0, 0, 0]
                p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = (low, high)[side][axis], (low, high)[a][(axis + 1) % 3], (low, high)[b][(axis + 2) % 3]
                n[axis] = 2 * side - 1
                positions.append(p)
                normals.append(n)
            indices += [base + k for k in ((0, 1, 2, 0, 2, 3) if side else (0, 2, 1, 0, 3, 2))]
    return positions, normals, indices


def clip(name, *channels):
    """channels: (node, path, times, accessor of values)"""
    return {"name": name, "channels": [{"sampler": i, "target": {"node": node, "path": path}} for i, (node, path, _, _) in enumerate(channels)],
            "samplers": [{"input": times, "output": values} for _, _, times, values in channels]}


def door():
    positions, normals, indices = slab((0, 0, -0.1), (1, 1.5, 0.1))
    arrays = {"POSITION": accessor(positions, "VEC3", target=34962), "NORMAL": accessor(normals, "VEC3", target=34962)}
    lift = accessor([[0, 0.6 if p[1] > 1 else 0, 0] for p in positions], "VEC3", target=34962)
    triangles = accessor(indices, "SCALAR", USHORT, 34963)
    second, later, h = accessor([0, 1], "SCALAR"), accessor([0.5, 2.5], "SCALAR"), 0.5 ** 0.5
    animations = [clip("swing", (0, "rotation", second, accessor([[0, 0, 0, 1], [0, -h, 0, h]], "VEC4"))),
                  clip("slide", (0, "translation", later, accessor([[0, 0, 0], [0.8, 0, 0]], "VEC3")), (0, "weights", later, accessor([0, 1], "SCALAR"))),
                  clip("fly", (2, "translation", later, accessor([[0, 1, 6], [3, 1, 5]], "VEC3")))]
    part = {"attributes": arrays, "indices": triangles}
    return {"asset": {"version": "2.0", "generator": "tools/make/make_moving_door.py of Rakelight"},
            "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
            "nodes": [{"name": "door", "mesh": 0}, {"name": "post", "mesh": 1, "translation": [-0.4, 0, 0], "scale": [0.3, 1.2, 1]},
                      {"name": "rig", "translation": [0, 1, 6], "camera": 0}],
            "cameras": [{"name": "fixed", "type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1, "zfar": 50}}],
            "materials": [{"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.1, 0.1, 1], "metallicFactor": 0, "roughnessFactor": 0.5}}],
            "meshes": [{"primitives": [part | {"material": 0, "targets": [{"POSITION": lift}]}]}, {"primitives": [part]}],
            "animations": animations, "bufferViews": VIEWS, "accessors": ACCESSORS,
            "buffers": [{"byteLength": len(BYTES), "uri": "data:application/octet-stream;base64," + base64.b64encode(BYTES).decode()}]}


def main():
    path = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2] / "data" / "motion" / "door.gltf")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(door(), separators=(",", ":")) + "\n")


if __name__ == "__main__":
    main()
