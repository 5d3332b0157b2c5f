#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Objects that are split by material: `inspect`, its limits and heat maps see the seams that `smooth` closes.

  parts_test.py PROGRAM [unittest arguments]"""
import itertools
import json
import math
import pathlib
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import png

COLUMNS, ROWS = 24, 12


def ball(lean_deg=7.5):
    """Two halves of a sphere, each (positions, normals, triangles), with its normals but at the equator: those lean to their half's side. The
    first column stands twice, as where texture coordinates wrap."""
    halves = []
    for rows, side in ((range(0, ROWS // 2 + 1), -1), (range(ROWS // 2, ROWS + 1), 1)):
        positions, normals = [], []
        for row, column in itertools.product(rows, range(COLUMNS + 1)):
            height, a = math.radians(180 * row / ROWS - 90), 2 * math.pi * (column % COLUMNS) / COLUMNS
            up = math.radians(side * lean_deg) if row == ROWS // 2 else height
            place, normal = ((math.cos(e) * math.cos(a), math.sin(e), -math.cos(e) * math.sin(a)) for e in (height, up))
            positions.append(tuple(round(v, 6) + 0.0 for v in place))
            normals.append(normal)
        triangles = []
        for row, column in itertools.product(range(len(rows) - 1), range(COLUMNS)):
            a = row * (COLUMNS + 1) + column
            b, d, e = a + 1, a + COLUMNS + 1, a + COLUMNS + 2
            triangles += [t for t in ((a, b, e), (a, e, d)) if len({positions[v] for v in t}) == 3]
        halves.append((positions, normals, triangles))
    return halves


def glb(halves, objects=1):
    """One mesh of two primitives, or two meshes."""
    views, accessors, data = [], [], b""

    def add(text, values, kind, **more):
        nonlocal data
        packed = struct.pack(f"<{len(values)}{text}", *values)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed)})
        data += packed
        width = 3 if kind == "VEC3" else 1
        accessors.append({"bufferView": len(views) - 1, "componentType": 5126 if text == "f" else 5125, "type": kind, "count": len(values) // width, **more})
        return len(accessors) - 1

    primitives = []
    for number, (positions, normals, triangles) in enumerate(halves):
        bounds = {"min": [min(p[k] for p in positions) for k in range(3)], "max": [max(p[k] for p in positions) for k in range(3)]}
        primitives.append({"attributes": {"POSITION": add("f", [v for p in positions for v in p], "VEC3", **bounds),
                                          "NORMAL": add("f", [v for n in normals for v in n], "VEC3")},
                           "indices": add("I", [v for t in triangles for v in t], "SCALAR"), "material": number})
    meshes = [{"primitives": primitives}] if objects == 1 else [{"primitives": [p]} for p in primitives]
    tree = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(objects))}],
            "nodes": [{"mesh": m, "name": "ball" if objects == 1 else f"half{m}"} for m in range(objects)], "meshes": meshes,
            "materials": [{"name": "lower"}, {"name": "upper"}], "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(data)}]}
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)) + struct.pack("<I4s", len(text), b"JSON") + text +
            struct.pack("<I4s", len(data), b"BIN\0") + data)


def obj(halves):
    lines, first = ["mtllib ball.mtl", "o ball"], 1
    for (positions, normals, triangles), name in zip(halves, ("lower", "upper")):
        lines += ["v " + " ".join(map(repr, p)) for p in positions] + ["vn " + " ".join(map(repr, n)) for n in normals] + [f"usemtl {name}"]
        lines += ["f " + " ".join(f"{v + first}//{v + first}" for v in t) for t in triangles]
        first += len(positions)
    return "\n".join(lines) + "\n"


def fbx(halves):
    """A geometry of two materials, with a normal a corner."""
    positions, normals, corners, materials, first = [], [], [], [], 0
    for number, (places, directions, triangles) in enumerate(halves):
        positions += [v for p in places for v in p]
        for a, b, c in triangles:
            corners += [a + first, b + first, -(c + first) - 1]
            normals += [v for t in (a, b, c) for v in directions[t]]
            materials.append(number)
        first += len(places)

    def numbers(name, values):
        return f"{name}: *{len(values)} {{\na: {','.join(map(repr, values))}\n}}\n"

    def layer(kind, mapping, reference, name, values):
        return (f'LayerElement{kind}: 0 {{\nVersion: 101\nName: ""\nMappingInformationType: "{mapping}"\nReferenceInformationType: "{reference}"\n' +
                numbers(name, values) + "}\n")

    axes = (("UpAxis", 1), ("UpAxisSign", 1), ("FrontAxis", 2), ("FrontAxisSign", 1), ("CoordAxis", 0), ("CoordAxisSign", 1))
    settings = "".join(f'P: "{name}", "int", "Integer", "",{value}\n' for name, value in axes)
    materials_text = "".join(f'Material: {3000 + m}, "Material::{name}", "" {{\nVersion: 102\nShadingModel: "phong"\n}}\n'
                             for m, name in enumerate(("lower", "upper")))
    return ('; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\nFBXVersion: 7400\n}\n'
            'GlobalSettings:  {\nVersion: 1000\nProperties70:  {\n' + settings + 'P: "UnitScaleFactor", "double", "Number", "",100\n}\n}\n'
            'Objects:  {\nGeometry: 1000, "Geometry::g", "Mesh" {\n' + numbers("Vertices", positions) + numbers("PolygonVertexIndex", corners) +
            "GeometryVersion: 124\n" + layer("Normal", "ByPolygonVertex", "Direct", "Normals", normals) +
            layer("Material", "ByPolygon", "IndexToDirect", "Materials", materials) +
            'Layer: 0 {\nVersion: 100\nLayerElement:  {\nType: "LayerElementNormal"\nTypedIndex: 0\n}\nLayerElement:  {\nType: "LayerElementMaterial"\n'
            'TypedIndex: 0\n}\n}\n}\nModel: 2000, "Model::ball", "Mesh" {\nVersion: 232\n}\n' + materials_text + "}\n"
            'Connections:  {\nC: "OO",2000,0\nC: "OO",1000,2000\nC: "OO",3000,2000\nC: "OO",3001,2000\n}\n')


def rim(bend_deg, segments=32):
    """A cylinder and a cone above it that bends inwards, each with its own exact normals: the rim between them is hard."""
    a, parts = math.radians(bend_deg), []
    rings = (((1, 0), (1, 1), (1, 0)), ((1, 1), (1 - 0.5 * math.sin(a), 1 + 0.5 * math.cos(a)), (math.cos(a), math.sin(a))))
    for low, high, (out, up) in rings:
        positions, normals, triangles = [], [], []
        for (radius, height), column in itertools.product((low, high), range(segments + 1)):
            b = 2 * math.pi * (column % segments) / segments
            positions.append(struct.unpack("<3f", struct.pack("<3f", radius * math.cos(b), height, -radius * math.sin(b))))
            normals.append((out * math.cos(b), up, -out * math.sin(b)))
        for i in range(segments):
            triangles += [(i, i + 1, i + segments + 2), (i, i + segments + 2, i + segments + 1)]
        parts.append((positions, normals, triangles))
    return parts


class Parts(program.Case):
    def setUp(self):
        super().setUp()
        self.write("ball.mtl", "newmtl lower\nKd 1 1 1\nnewmtl upper\nKd 1 0 0\n")
        self.write("ball.obj", obj(ball()))
        (self.folder / "ball.glb").write_bytes(glb(ball()))
        self.models = ["ball.glb", "ball.obj"]
        if (pathlib.Path(program.PROGRAM).parent / "rakelight-import").exists():
            self.write("ball.fbx", fbx(ball()))
            self.models.append("ball.fbx")

    def row(self, verb, *arguments):
        result = self.run_program(verb, *arguments, "--json")
        self.assertIn(result.code, (0, 5), result.err)
        return json.loads(result.out)["rows"][0]

    def test_a_split_by_material_is_a_split(self):
        for model in self.models:
            row = self.row("inspect", model)
            self.assertEqual((len(row["objects"]), row["shared_positions"], row["seams"]["joined"]), (1, COLUMNS, COLUMNS), model)
            border = row["borders"][0]
            self.assertEqual((border["object_a"], border["object_b"], border["positions"]), (0, 0, COLUMNS))
            self.assertEqual({row["materials"][border[m]]["name"] for m in ("material_a", "material_b")}, {"lower", "upper"})
            self.assertAlmostEqual(border["seam_deg"], 15, places=2)
            self.assertAlmostEqual(row["seams"]["seam_deg"], 15, places=2)
            self.assertEqual(row["seams"]["normals_after"], "joined where parts meet")
            text = self.run_program("inspect", model).out
            self.assertIn(f"{COLUMNS} positions shared by meshes, 0 continuous (normals: the file's), {COLUMNS} once joined where parts meet", text)
            self.assertIn("largest seam 15.00 degrees", text)

    def test_limits_and_heat_maps_see_what_smooth_closes(self):
        for model in self.models:
            failed = self.run_program("inspect", model, "--check", "--max-seam", "1")
            self.assertEqual(failed.code, 5, model)
            self.assertRegex(failed.err, r"seam of 15 degrees between '(lower|upper)' and '(lower|upper)' of 'ball' at ")
            self.assertEqual(self.run_program("inspect", model, "--check", "--max-seam", "15.1").code, 0, model)
            out = "smooth.obj" if model == "ball.obj" else "smooth.glb"
            seams = self.row("smooth", model, "-o", out)["seams"]
            self.assertGreaterEqual(seams["turned"], 2 * COLUMNS)
            self.assertAlmostEqual(seams["max_deg"], 7.5, places=2)
            colors = []
            for name in (model, out):
                self.assertEqual(self.run_program("inspect", name, "--heatmap", "map.png", "--heatmap-legend", "off", "--resolution", "120,90").code, 0)
                _, _, size, rows = png(self.folder / "map.png")
                colors.append(sum(max(r[i:i + 3]) - min(r[i:i + 3]) > 30 for r in rows for i in range(0, len(r), size)))
            self.assertGreater(colors[0], 50, "the equator in the color of 15 degrees")
            self.assertEqual(colors[1], 0, "all gray")
            self.assertEqual(self.run_program("inspect", out, "--check", "--max-seam", "0.02").code, 0, model)

    def test_one_object_or_two_have_the_same_seam(self):
        (self.folder / "two.glb").write_bytes(glb(ball(), 2))
        one, two = (self.row("inspect", model) for model in ("ball.glb", "two.glb"))
        self.assertEqual([len(row["objects"]) for row in (one, two)], [1, 2])
        for key in ("positions", "joined", "seam_deg", "before", "after"):
            self.assertEqual(one["borders"][0][key], two["borders"][0][key], key)
        self.assertIn("between 'half0' and 'half1'", self.run_program("inspect", "two.glb", "--check").err)

    def test_smooth_says_in_one_line_what_it_turned(self):
        said = self.run_program("smooth", "ball.glb", "-o", "out.glb")
        self.assertEqual((said.code, len(said.lines)), (0, 1))
        self.assertRegex(said.err, r"out\.glb: 50 of 348 authored normals turn \(at most 7\.5 degrees, 7\.5 on average\)")
        self.assertEqual(self.run_program("smooth", "ball.glb", "-o", "out.glb", "--quiet").err, "")
        again = self.run_program("smooth", "out.glb", "-o", "again.glb")
        self.assertIn("nothing to change, 0 of 348 authored normals turn", again.err)
        self.assertEqual((self.folder / "out.glb").read_bytes(), (self.folder / "again.glb").read_bytes())

    def test_a_rim_authored_hard_stays_and_is_no_seam(self):
        for bend in (20, 30, 45, 59):
            (self.folder / "rim.glb").write_bytes(glb(rim(bend)))
            for options, kept in (((), ""), (("--crease-angle", "60"), ", 32 pairs of faces at borders keep an authored crease")):
                said = self.run_program("smooth", "rim.glb", "-o", "out.glb", *options)
                self.assertIn("0 of 132 authored normals turn" + kept, said.err)
                self.assertEqual((self.folder / "rim.glb").read_bytes(), (self.folder / "out.glb").read_bytes())
                row = self.row("inspect", "rim.glb", "--check", *options)
                self.assertTrue(row["check"]["passed"])
                self.assertAlmostEqual(row["borders"][0]["largest_deg"], bend, places=3)
                self.assertEqual((row["seams"]["joined"], row["seams"]["seam_deg"]), (0, 0))
        seams = self.row("smooth", "rim.glb", "-o", "out.glb", "--normals", "model", "--crease-angle", "60")
        self.assertNotIn("seams", seams)
        self.assertNotEqual((self.folder / "rim.glb").read_bytes(), (self.folder / "out.glb").read_bytes(), "as asked")


if __name__ == "__main__":
    program.main()
