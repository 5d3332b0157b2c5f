#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes data/materials: what materials and meshes of glTF files can ask for, a model a subject, each with a camera of its own.

  colors.gltf   four squares: vertex colors; a texture by the first, by the second set of coordinates; texture times vertex colors
  alpha.gltf    four squares with one texture, opaque, masked at 0.5 and at 0.1, blended; three panes, the nearest first in the file
  sides.gltf    two open tubes, of a single-sided and of a double-sided material
  spheres.gltf  one sphere of 528 triangles, placed twice: large and small
  layers.gltf   six spheres of one shape: plastic, with a clearcoat, cloth; metal, brushed up and around
  checker.png   red grows with u, green with v downwards, every other field darker
  disc.png      alpha falls evenly from 1 in the middle to 0 at the rim of a disc
and data/lighting/fields.png: fields of black and white"""
import sys
import base64
import json
import math
import pathlib
import struct

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "pictures"))
from png8 import write_pixels, write_rgb  # noqa: E402


FOLDER = pathlib.Path(__file__).resolve().parents[2] / "data/materials"
UNLIT = {"extensions": {"KHR_materials_unlit": {}}}
WHITE, CORNERS = (1, 1, 1), ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1))
WHOLE = ((0, 1), (1, 1), (1, 0), (0, 0))
TURNED = ((0, 0), (0, 2), (2, 2), (2, 0))  # a quarter turn, twice each way
TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3"}


class Model:
    """A glTF file in the making; arrays go into one buffer."""

    def __init__(self, camera, place):
        self.blob = b""
        self.json = {
            "asset": {"version": "2.0", "copyright": "Rakelight, Apache-2.0"}, "extensionsUsed": ["KHR_materials_unlit"], "scene": 0,
            "scenes": [{"nodes": [0]}], "nodes": [{"name": "camera", "camera": 0, **place}], "cameras": [camera], "meshes": [], "materials": [],
            "accessors": [], "bufferViews": []}

    def array(self, rows, is_index=False):
        """The accessor's number."""
        width = 1 if is_index else len(rows[0])
        data = b"".join(struct.pack("<H", r) if is_index else struct.pack(f"<{width}f", *r) for r in rows)
        accessor = {"bufferView": len(self.json["bufferViews"]), "componentType": 5123 if is_index else 5126, "count": len(rows), "type": TYPES[width]}
        if width == 3:
            packed = [struct.unpack("<3f", struct.pack("<3f", *r)) for r in rows]
            accessor.update(min=[min(c) for c in zip(*packed)], max=[max(c) for c in zip(*packed)])
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data)})
        self.json["accessors"].append(accessor)
        self.blob += data + bytes(-len(data) % 4)
        return len(self.json["accessors"]) - 1

    def add(self, name, material, indices, **attributes):
        primitive = {"attributes": {key: self.array(rows) for key, rows in attributes.items()}, "indices": self.array(indices, True),
                     "material": len(self.json["materials"])}
        self.json["materials"].append({"name": name, **material})
        self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]))
        self.json["nodes"].append({"name": name, "mesh": len(self.json["meshes"])})
        self.json["meshes"].append({"name": name, "primitives": [primitive]})

    def square(self, name, material, x, y, z=0.0, half=0.45, **attributes):
        corners = [(x + half * a, y + half * b, z) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        self.add(name, material, [0, 1, 2, 0, 2, 3], POSITION=corners, **attributes)

    def use(self, picture):
        self.json.update(images=[{"uri": picture}], samplers=[{"wrapS": 10497, "wrapT": 10497}], textures=[{"source": 0, "sampler": 0}])

    def write(self, path):
        self.json["buffers"] = [{"byteLength": len(self.blob), "uri": "data:application/octet-stream;base64," + base64.b64encode(self.blob).decode()}]
        path.write_text(json.dumps(self.json, indent=1) + "\n")


def flat_camera(half_width, half_height):
    return {"type": "orthographic", "orthographic": {"xmag": half_width, "ymag": half_height, "znear": 0.1, "zfar": 10}}, {"translation": [0, 0, 5]}


def textured(set_number=0, **more):
    return {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": set_number}}, **UNLIT, **more}


def colors():
    model = Model(*flat_camera(2, 0.5))
    model.use("checker.png")
    model.square("vertex colors", dict(UNLIT), -1.5, 0, COLOR_0=CORNERS)
    model.square("first set", textured(), -0.5, 0, TEXCOORD_0=WHOLE, TEXCOORD_1=TURNED)
    model.square("second set", textured(1), 0.5, 0, TEXCOORD_0=WHOLE, TEXCOORD_1=TURNED)
    model.square("texture times vertex colors", textured(), 1.5, 0, TEXCOORD_0=WHOLE, COLOR_0=CORNERS)
    return model


def alpha():
    model = Model(*flat_camera(2.5, 0.5))
    model.use("disc.png")
    stripes = [(x / 8 - 2.5, y) for x in range(40) for y in (-0.5, 0.5)]
    for shade in (0, 1):
        left = [4 * k + 2 * shade for k in range(20)]
        places = [(stripes[k][0] + dx, y, -1) for k in left for dx, y in ((0, -0.5), (0.125, -0.5), (0.125, 0.5), (0, 0.5))]
        model.add(f"stripes {shade}", {"pbrMetallicRoughness": {"baseColorFactor": [0.6, 0.6, 0.6, 1] if shade else [0.2, 0.2, 0.2, 1]}, **UNLIT},
                  [4 * k + i for k in range(20) for i in (0, 1, 2, 0, 2, 3)], POSITION=places)
    for k, (name, mode) in enumerate((("opaque", {}), ("mask 0.5", {"alphaMode": "MASK"}), ("mask 0.1", {"alphaMode": "MASK", "alphaCutoff": 0.1}),
                                      ("blend", {"alphaMode": "BLEND"}))):
        model.square(name, textured(**mode), k - 2, 0, TEXCOORD_0=WHOLE)
    for name, color, x, y, z in (("near pane", (1, 0, 0), -0.12, -0.1, 0.2), ("middle pane", (0, 1, 0), 0.12, -0.1, 0.1), ("far pane", (0, 0, 1), 0, 0.1, 0)):
        glass = {"pbrMetallicRoughness": {"baseColorFactor": [*color, 0.5]}, "alphaMode": "BLEND", **UNLIT}
        model.square(name, glass, 2 + x, y, z, half=0.3)
    return model


def sides():
    down = math.radians(-38)
    place = {"translation": [0, 4.6 * math.sin(-down), 4.6 * math.cos(down)], "rotation": [math.sin(down / 2), 0, 0, math.cos(down / 2)]}
    model = Model({"type": "perspective", "perspective": {"yfov": math.radians(27), "znear": 0.1}}, place)
    around = 48
    for name, x, more in (("single-sided", -1, {}), ("double-sided", 1, {"doubleSided": True})):
        angles = [2 * math.pi * k / around for k in range(around + 1)]
        normals = [(math.sin(a), 0, math.cos(a)) for a in angles for _ in (0, 1)]
        places = [(x + 0.8 * n[0], 0.5 if k % 2 else -0.5, 0.8 * n[2]) for k, n in enumerate(normals)]
        indices = [2 * k + i for k in range(around) for i in (0, 2, 3, 0, 3, 1)]
        surface = {"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.45, 0.15, 1], "metallicFactor": 0, "roughnessFactor": 0.5}, **more}
        model.add(name, surface, indices, POSITION=places, NORMAL=normals)
    del model.json["extensionsUsed"]
    return model


def spheres():
    model = Model(*flat_camera(1.575, 1.2))
    around, down = 24, 12
    rings = [(math.sin(math.pi * j / down), math.cos(math.pi * j / down)) for j in range(down + 1)]
    points = [(r * math.sin(2 * math.pi * i / around), y, r * math.cos(2 * math.pi * i / around)) for r, y in rings for i in range(around + 1)]
    indices = []
    for j in range(down):
        for i in range(around):
            a = j * (around + 1) + i
            b = a + around + 1
            indices += ([a, b, b + 1] if j + 1 < down else []) + ([a, b + 1, a + 1] if j else [])
    surface = {"pbrMetallicRoughness": {"baseColorFactor": [0.7, 0.25, 0.15, 1], "metallicFactor": 0, "roughnessFactor": 0.35}}
    model.add("large", surface, indices, POSITION=points, NORMAL=points)
    model.json["scenes"][0]["nodes"].append(2)
    model.json["nodes"].append({"name": "small", "mesh": 0, "translation": [1.25, 0, 0], "scale": [0.19] * 3})
    model.json["nodes"][1]["translation"] = [-0.45, 0, 0]
    del model.json["extensionsUsed"]
    return model


def sphere(around, down):
    """Points (normals, too), texture coordinates with the seam behind, indices."""
    turns = [(i / around, j / down) for j in range(down + 1) for i in range(around + 1)]
    points = [(-math.sin(math.pi * v) * math.sin(2 * math.pi * u), math.cos(math.pi * v), -math.sin(math.pi * v) * math.cos(2 * math.pi * u)) for u, v in turns]
    indices = []
    for j in range(down):
        for a in range(j * (around + 1), j * (around + 1) + around):
            b = a + around + 1
            indices += ([a, b, b + 1] if j + 1 < down else []) + ([a, b + 1, a + 1] if j else [])
    return points, turns, indices


def layers():
    model = Model(*flat_camera(6.3, 1.05))
    red, steel = {"baseColorFactor": [0.5, 0.06, 0.05, 1], "metallicFactor": 0, "roughnessFactor": 0.6}, {"baseColorFactor": [0.75, 0.72, 0.68, 1], "roughnessFactor": 0.35}
    coat = {"KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0.1}}
    sheen = {"KHR_materials_sheen": {"sheenColorFactor": [0.8, 0.7, 0.7], "sheenRoughnessFactor": 0.4}}
    brushed = [{"KHR_materials_anisotropy": {"anisotropyStrength": 0.8, "anisotropyRotation": angle}} for angle in (0, math.pi / 2)]
    points, turns, indices = sphere(40, 20)
    for k, (name, pbr, more) in enumerate((("plastic", red, {}), ("clearcoat", red, coat), ("cloth", red, sheen), ("metal", steel, {}),
                                           ("brushed up", steel, brushed[0]), ("brushed around", steel, brushed[1]))):
        material = {"pbrMetallicRoughness": pbr, **({"extensions": more} if more else {})}
        if k == 0:
            model.add(name, material, indices, POSITION=points, NORMAL=points, TEXCOORD_0=turns)
        else:
            model.json["scenes"][0]["nodes"].append(k + 1)
            model.json["nodes"].append({"name": name, "mesh": k})
            model.json["meshes"].append({"name": name, "primitives": [{**model.json["meshes"][0]["primitives"][0], "material": k}]})
            model.json["materials"].append({"name": name, **material})
        model.json["nodes"][k + 1]["translation"] = [2.1 * (k - 2.5), 0, 0]
    model.json["extensionsUsed"] = ["KHR_materials_clearcoat", "KHR_materials_sheen", "KHR_materials_anisotropy"]
    return model


def main():
    FOLDER.mkdir(exist_ok=True)
    size = 64
    write_rgb(FOLDER / "checker.png", size, size, bytes(
        int(c * (1 if (x // 8 + y // 8) % 2 else 0.55)) for y in range(size) for x in range(size) for c in (60 + 3 * x, 60 + 3 * y, 110)))
    write_rgb(FOLDER.parent / "lighting/fields.png", size, size, bytes(
        255 if (x // 8 + y // 8) % 2 else 0 for y in range(size) for x in range(size) for _ in range(3)))
    radius = [[math.hypot(x - 31.5, y - 31.5) / 32 for x in range(size)] for y in range(size)]
    write_pixels(FOLDER / "disc.png", size, size, 4, b"".join(bytes((240, 150, 30, round(255 * max(0, 1 - r)))) for row in radius for r in row))
    for name, model in (("colors", colors()), ("alpha", alpha()), ("sides", sides()), ("spheres", spheres()), ("layers", layers())):
        model.write(FOLDER / f"{name}.gltf")


if __name__ == "__main__":
    main()
