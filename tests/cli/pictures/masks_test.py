#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Masked leaves cover the same part of the picture at every size: every engine, thumbnails, other cutoffs, factors and vertex alpha, shared textures.
The texture has a disc in each cell, whose alpha falls linearly at its rim, so the part is known in closed form.

  masks_test.py PROGRAM [unittest arguments]"""
import json
import math
import os
import pathlib
import random
import struct
import sys
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import png

CELL, RADIUS, RIM = 16, 4.0, 3.0  # [texels]


def part(cutoff):
    """Of a cell that is seen."""
    return math.pi * (RADIUS + RIM * (0.5 - cutoff)) ** 2 / CELL ** 2


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write_leaves(path, width, height, gray=False):
    """RGBA, white, or the alpha alone as gray."""
    draw, rows = random.Random(7), bytearray()
    places = {(i, j): ((i + draw.uniform(0.38, 0.62)) * CELL, (j + draw.uniform(0.38, 0.62)) * CELL) for i in range(width // CELL) for j in range(height // CELL)}
    for y in range(height):
        rows.append(0)
        for x in range(width):
            px, py = places[x // CELL, y // CELL]
            alpha = round(255 * min(1, max(0, 0.5 - (math.hypot(x + 0.5 - px, y + 0.5 - py) - RADIUS) / RIM)))
            rows += bytes((alpha,) if gray else (255, 255, 255, alpha))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0 if gray else 6, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(bytes(rows), 1)) + chunk(b"IEND", b""))


def material(mode, cutoff=0.5, factor=1.0):
    m = {"extensions": {"KHR_materials_unlit": {}}, "alphaMode": mode, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "baseColorFactor": [1, 1, 1, factor]}}
    return {**m, "alphaCutoff": cutoff} if mode == "MASK" else m


def write_squares(path, materials, repeats=1, alpha=None):
    """Squares in a row, one for each material."""
    n, corners = len(materials), ((0, 0), (1, 0), (1, 1), (0, 1))
    positions = b"".join(struct.pack("<3f", i + x, y, 0) for i in range(n) for x, y in corners)
    texcoords = b"".join(struct.pack("<2f", repeats * x, repeats * (1 - y)) for x, y in corners)
    colors = b"".join(struct.pack("<4f", 1, 1, 1, 1 if alpha is None else alpha) for _ in corners)
    indices = struct.pack("<6I", 0, 1, 2, 0, 2, 3)
    views, blob = [], b""
    for data in (positions, texcoords, colors, indices):
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(data)})
        blob += data
    accessors = [{"bufferView": 0, "byteOffset": 48 * i, "componentType": 5126, "count": 4, "type": "VEC3", "min": [i, 0, 0], "max": [i + 1, 1, 0]} for i in range(n)]
    accessors += [{"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"}, {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC4"},
                  {"bufferView": 3, "componentType": 5125, "count": 6, "type": "SCALAR"}]
    more = {} if alpha is None else {"COLOR_0": n + 1}
    primitives = [{"attributes": {"POSITION": i, "TEXCOORD_0": n, **more}, "indices": n + 2, "material": i} for i in range(n)]
    path.with_suffix(".bin").write_bytes(blob)
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(n))}], "nodes": [{"mesh": i} for i in range(n)],
        "meshes": [{"primitives": [p]} for p in primitives], "accessors": accessors, "bufferViews": views, "materials": materials,
        "buffers": [{"byteLength": len(blob), "uri": path.with_suffix(".bin").name}], "extensionsUsed": ["KHR_materials_unlit"],
        "images": [{"uri": "leaves.png"}], "textures": [{"source": 0, "sampler": 0}], "samplers": [{"minFilter": 9987}]}))


class Masks(program.Case):
    def light(self, model, size, engine, *more):
        """The sum of the picture's green light, over black."""
        result = self.run_program("render", model, "-o", "a.png", "--resolution", f"{size},{size}", "--engine", engine, "--background", "black", "--view", "front", *more)
        if engine == "gl" and result.code == 1:
            self.skipTest(result.err.strip())
        self.assertEqual(result.code, 0, result.err)
        _, _, channels, rows = png(self.folder / "a.png")
        table = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in (i / 255 for i in range(256))]
        return sum(table[c] for row in rows for c in row[1::channels])

    def check_part(self, expected, engine, sizes, delta, materials=None, mode=None, **squares):
        write_squares(self.folder / "mask.gltf", materials or [mode], **squares)
        write_squares(self.folder / "whole.gltf", [material("OPAQUE")] * len(materials or [mode]), **squares)
        for size in sizes:
            seen = self.light("mask.gltf", size, engine) / self.light("whole.gltf", size, engine)
            self.assertLess(abs(seen / expected - 1), delta, f"{engine}, {size} px, {squares}: {seen:.4f}, not {expected:.4f}")

    def check_engine(self, engine):
        write_leaves(self.folder / "leaves.png", 512, 512)
        for cutoff in (0.1, 0.5, 0.9):
            self.check_part(part(cutoff), engine, (256, 64), 0.1, mode=material("MASK", cutoff))
            self.check_part(part(cutoff), engine, (256, 64), 0.25, mode=material("MASK", cutoff), repeats=2)
            # Of 180 pixels that the square has there a tenth is seen. Between two levels peaks that are cut at 0.9 lose a quarter.
            self.check_part(part(cutoff), engine, (16,), 0.4, mode=material("MASK", cutoff), repeats=2)
        self.check_part(part(0.6), engine, (64,), 0.1, mode=material("MASK", 0.3, 0.5))
        self.check_part(part(0.75), engine, (64,), 0.1, mode=material("MASK", 0.3, 0.5), alpha=0.8)

    def test_soft(self):
        self.check_engine("soft")

    def test_gl(self):
        self.check_engine("gl")

    def test_trace(self):
        self.check_engine("trace")

    def test_textures_that_are_not_square(self):
        write_leaves(self.folder / "leaves.png", 512, 64)
        self.check_part(part(0.5), "soft", (256, 128, 64), 0.1, mode=material("MASK"))

    def test_one_texture_of_materials_with_other_cutoffs_and_modes(self):
        write_leaves(self.folder / "leaves.png", 256, 256)
        cutoffs = (0.2, 0.8)
        self.check_part((part(0.2) + part(0.8)) / 2, "soft", (128, 64), 0.12, materials=[material("MASK", c) for c in cutoffs])
        for row, of in (("first", [material("MASK", 0.2), material("BLEND")]), ("second", [material("BLEND"), material("MASK", 0.2)])):
            write_squares(self.folder / "mask.gltf", of)
            write_squares(self.folder / "blend.gltf", [material("BLEND")] * 2)
            write_squares(self.folder / "only.gltf", [material("MASK", 0.2)] * 2)
            both, blend, only = (self.light(f"{name}.gltf", 64, "soft") for name in ("mask", "blend", "only"))
            self.assertAlmostEqual(both / ((blend + only) / 2), 1, delta=0.02, msg=row)

    def test_opacity_maps_of_obj_files(self):
        write_leaves(self.folder / "leaves.png", 512, 512, gray=True)
        self.write("a.mtl", "newmtl m\nKd 1 1 1\nmap_d leaves.png\n")
        self.write("a.obj", "mtllib a.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
        for engine in ("soft", "trace"):
            seen, whole = (self.light("a.obj", 64, engine, "--material", "unlit=true", "--material", f"alpha={mode}") for mode in ("mask", "opaque"))
            seen /= whole
            self.assertLess(abs(seen / part(0.5) - 1), 0.1, f"{engine}: {seen}, not {part(0.5)}")

    def test_thumbnails(self):
        """The texture is larger than what a thumbnail decodes of others."""
        write_leaves(self.folder / "leaves.png", 1024, 1024)
        for name, of in (("mask", material("MASK", 0.7)), ("whole", material("OPAQUE"))):
            write_squares(self.folder / f"{name}.gltf", [of])
            result = self.run_program("thumbnail", f"{name}.gltf", f"{name}.png", "48", "--cpu-seconds", "60")
            self.assertEqual(result.code, 0, result.err)
        seen, whole = (sum(row[3::4][i] for row in png(self.folder / f"{name}.png")[3] for i in range(48)) for name in ("mask", "whole"))
        self.assertLess(abs(seen / whole / part(0.7) - 1), 0.15, f"{seen / whole}, not {part(0.7)}")

    def test_the_reported_file(self):
        folder = pathlib.Path(os.environ.get("RAKELIGHT_SHARED", pathlib.Path(__file__).parents[4] / "shared")) / "repro/field"
        if not folder.is_dir():
            self.skipTest(f"{folder} is not there")
        first = self.light(folder / "mask_leaves.glb", 1024, "soft") / 1024 ** 2
        for size, delta in ((256, 0.05), (64, 0.1), (16, 0.3)):
            seen = self.light(folder / "mask_leaves.glb", size, "soft") / size ** 2
            self.assertLess(abs(seen / first - 1), delta, f"{size} px: {seen}, not {first}")


if __name__ == "__main__":
    program.main()
