#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `rakelight smooth` on models with authored normals: seams closed, all else kept; previews, old and new names of options, files that
are written anew with what moves in them.

  smooth_seams_test.py PROGRAM [unittest arguments]"""
import json
import math
import os
import pathlib
import re
import struct
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

HERE = pathlib.Path(__file__).resolve().parents[1]
ASSETS = pathlib.Path(os.environ.get("RAKELIGHT_SHARED", HERE.parent.parent.parent / "shared")) / "assets"


def glb(tree, binary):
    text = json.dumps(tree, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def read_glb(path):
    data = path.read_bytes()
    size = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + size]), data[28 + size:]


def lean(degrees):
    return math.sin(math.radians(degrees)), math.cos(math.radians(degrees)), 0.0


def two_squares(left_deg, right_deg):
    """Squares of the plane y = 0 that meet at x = 1, each with one normal; the right one moves with a clip."""
    def square(x):
        return [(x, 0, 0), (x, 0, 1), (x + 1, 0, 1), (x + 1, 0, 0)]
    arrays, views, accessors = b"", [], []

    def add(data, kind, component, count, **more):
        nonlocal arrays
        views.append({"buffer": 0, "byteOffset": len(arrays), "byteLength": len(data)})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": count, "type": kind, **more})
        arrays += data
        return len(accessors) - 1

    def floats(rows):
        return struct.pack(f"<{sum(map(len, rows))}f", *(x for row in rows for x in row))
    primitives = []
    for x, degrees in ((0, left_deg), (1, right_deg)):
        points = square(x)
        low, high = [[f(p[i] for p in points) for i in range(3)] for f in (min, max)]
        primitives.append({"attributes": {"POSITION": add(floats(points), "VEC3", 5126, 4, min=low, max=high),
                                          "NORMAL": add(floats([lean(degrees)] * 4), "VEC3", 5126, 4)},
                           "indices": add(struct.pack("<6H", 0, 1, 2, 0, 2, 3), "SCALAR", 5123, 6), "extras": {"part": x}})
    times = add(struct.pack("<2f", 0, 1), "SCALAR", 5126, 2, min=[0], max=[1])
    moved = add(floats([(0, 0, 0), (0, 1, 0)]), "VEC3", 5126, 2)
    tree = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
            "nodes": [{"mesh": 0, "name": "left"}, {"mesh": 1, "name": "right"}],
            "meshes": [{"primitives": [p]} for p in primitives], "accessors": accessors, "bufferViews": views,
            "buffers": [{"byteLength": len(arrays)}],
            "animations": [{"name": "lift", "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}],
                            "samplers": [{"input": times, "output": moved}]}]}
    return tree, arrays


def normals_of(path, mesh):
    tree, binary = read_glb(path)
    accessor = tree["accessors"][tree["meshes"][mesh]["primitives"][0]["attributes"]["NORMAL"]]
    at = tree["bufferViews"][accessor["bufferView"]].get("byteOffset", 0)
    return [struct.unpack_from("<3f", binary, at + 12 * i) for i in range(accessor["count"])]


# A rod of two joints that bends: Collada keeps the skin in a controller, the clip in a library of its own.
RIGGED_DAE = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1" name="meter"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 1 2 0 0 2 0</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="n"><float_array id="na" count="3">0 0 1</float_array><technique_common>
<accessor source="#na" count="1" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="2"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="NORMAL" source="#n" offset="1"/><p>0 0 1 0 2 0 0 0 2 0 3 0</p></triangles>
</mesh></geometry></library_geometries>
<library_controllers><controller id="c"><skin source="#g"><bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>
<source id="j"><Name_array id="ja" count="2">low high</Name_array><technique_common><accessor source="#ja" count="2" stride="1"><param name="JOINT" type="Name"/></accessor></technique_common></source>
<source id="b"><float_array id="ba" count="32">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 0 1 0 -1 0 0 1 0 0 0 0 1</float_array><technique_common><accessor source="#ba" count="2" stride="16"><param name="T" type="float4x4"/></accessor></technique_common></source>
<source id="w"><float_array id="wa" count="1">1</float_array><technique_common><accessor source="#wa" count="1" stride="1"><param name="W" type="float"/></accessor></technique_common></source>
<joints><input semantic="JOINT" source="#j"/><input semantic="INV_BIND_MATRIX" source="#b"/></joints>
<vertex_weights count="4"><input semantic="JOINT" source="#j" offset="0"/><input semantic="WEIGHT" source="#w" offset="1"/><vcount>1 1 1 1</vcount><v>0 0 0 0 1 0 1 0</v></vertex_weights>
</skin></controller></library_controllers>
<library_animations><animation id="a">
<source id="t"><float_array id="ta" count="2">0 1</float_array><technique_common><accessor source="#ta" count="2" stride="1"><param name="TIME" type="float"/></accessor></technique_common></source>
<source id="o"><float_array id="oa" count="2">0 90</float_array><technique_common><accessor source="#oa" count="2" stride="1"><param name="ANGLE" type="float"/></accessor></technique_common></source>
<source id="i"><Name_array id="ia" count="2">LINEAR LINEAR</Name_array><technique_common><accessor source="#ia" count="2" stride="1"><param name="I" type="name"/></accessor></technique_common></source>
<sampler id="s"><input semantic="INPUT" source="#t"/><input semantic="OUTPUT" source="#o"/><input semantic="INTERPOLATION" source="#i"/></sampler>
<channel source="#s" target="high/bend.ANGLE"/></animation></library_animations>
<library_visual_scenes><visual_scene id="w0">
<node id="low" sid="low" name="low" type="JOINT"><node id="high" sid="high" name="high" type="JOINT"><translate>0 1 0</translate><rotate sid="bend">0 0 1 0</rotate></node></node>
<node id="rod" name="rod"><instance_controller url="#c"><skeleton>#low</skeleton></instance_controller></node>
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w0"/></scene>
</COLLADA>
"""


class SmoothSeams(program.Case):
    def setUp(self):
        super().setUp()
        self.dir = self.folder
        self.tree, self.arrays = two_squares(-6, 6)
        (self.dir / "parts.glb").write_bytes(glb(self.tree, self.arrays))

    def smooth(self, *arguments):
        done = subprocess.run([program.PROGRAM, "smooth", *map(str, arguments)], cwd=self.dir, capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def row(self, *arguments):
        return json.loads(self.smooth(*arguments, "--json").stdout)["rows"][0]

    def test_only_the_border_turns_and_the_report_says_by_how_much(self):
        row = self.row("parts.glb", "-o", "out.glb")
        seams = row["seams"]
        self.assertEqual((seams["normals"], seams["turned"], seams["flat_pairs"], row["vertices_split"]), (8, 4, 0, 0))
        self.assertAlmostEqual(seams["max_deg"], 6, places=3)
        self.assertAlmostEqual(seams["mean_deg"], 6, places=3)
        self.assertEqual([m["normals"] for m in row["meshes"]], ["turned", "turned"])
        before, after = (self.dir / "parts.glb").read_bytes(), (self.dir / "out.glb").read_bytes()
        self.assertEqual(len(before), len(after))
        tree, _ = read_glb(self.dir / "out.glb")
        self.assertEqual(tree, self.tree)
        for mesh, border in ((0, (2, 3)), (1, (0, 1))):
            old, new = normals_of(self.dir / "parts.glb", mesh), normals_of(self.dir / "out.glb", mesh)
            for v in range(4):
                if v in border:
                    self.assertLess(math.dist(new[v], (0, 1, 0)), 1e-6)
                else:
                    self.assertEqual(old[v], new[v])
        text = self.smooth("parts.glb", "-o", "out.glb", "--verbose").stderr
        self.assertIn("4 of 8 authored normals turn (at most 6 degrees, 6 on average)", text)
        again = self.row("out.glb", "-o", "again.glb")
        self.assertFalse(again["changed"])
        self.assertEqual((self.dir / "again.glb").read_bytes(), (self.dir / "out.glb").read_bytes())

    def test_normals_and_its_old_name_make_all_anew(self):
        for way in ("model", "object", "face"):
            self.assertNotIn("seams", self.row("parts.glb", "-o", f"new-{way}.glb", "--normals", way))
            self.smooth("parts.glb", "-o", f"old-{way}.glb", "--scope", way)
            self.assertEqual((self.dir / f"new-{way}.glb").read_bytes(), (self.dir / f"old-{way}.glb").read_bytes())
        for n in normals_of(self.dir / "new-model.glb", 0):
            self.assertLess(math.dist(n, (0, 1, 0)), 1e-6)
        done = subprocess.run([program.PROGRAM, "smooth", "parts.glb", "-o", "x.glb", "--scope", "model", "--normals", "seams"], cwd=self.dir,
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 2)

    def test_render_and_inspect_have_the_same_rule(self):
        self.smooth("parts.glb", "-o", "out.glb")

        def seam(*arguments):
            done = subprocess.run([program.PROGRAM, "inspect", *arguments, "--json"], cwd=self.dir, capture_output=True, text=True, timeout=60)
            return json.loads(done.stdout)["rows"][0]["borders"][0]["largest_deg"]
        self.assertAlmostEqual(seam("parts.glb"), 12, places=3)
        self.assertLess(seam("out.glb"), 0.01)
        self.assertLess(seam("parts.glb", "--normals", "seams"), 0.01)
        for name, more in (("parts", ["--normals", "seams"]), ("out", [])):
            done = subprocess.run([program.PROGRAM, "render", f"{name}.glb", "-o", f"{name}.png", "--resolution", "64,48", "--view", "top", *more],
                                  cwd=self.dir, capture_output=True, timeout=60)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(program.png(self.dir / "parts.png"), program.png(self.dir / "out.png"))

    def test_a_preview_writes_pages_and_pictures_and_no_model(self):
        done = self.smooth("parts.glb", "--preview", "look/at", "--verbose")
        self.assertIn("4 of 8 authored normals turn", done.stderr)
        self.assertEqual(sorted(p.name for p in (self.dir / "look/at").iterdir()), ["parts-after.png", "parts-before.png", "parts.html"])
        page = (self.dir / "look/at/parts.html").read_text()
        self.assertEqual(page.count("data:image/png;base64,"), 2)
        self.assertIn("<td>12</td><td>0</td>", page, "the border's seam before and after")
        before, after = (program.png(self.dir / f"look/at/parts-{when}.png") for when in ("before", "after"))
        colors = [len({tuple(r[i:i + 3]) for r in p[3] for i in range(0, len(r), p[2])}) for p in (before, after)]
        self.assertGreater(colors[0], colors[1], "the seam in its colors")
        self.smooth("parts.glb", "--preview", "one.html")
        self.assertEqual(sorted(p.name for p in self.dir.iterdir()), ["look", "one.html", "parts.glb"])
        for wrong in (["--preview", "x.html", "-o", "x.glb"], []):
            done = subprocess.run([program.PROGRAM, "smooth", "parts.glb", *wrong], cwd=self.dir, capture_output=True, text=True, timeout=60)
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)

    def test_dead_bytes_go_from_a_new_file_unless_they_are_to_stay(self):
        # A crease splits vertices, so that arrays are written anew and the old ones are dead.
        self.smooth("parts.glb", "-o", "lean.glb", "--normals", "face")
        self.smooth("parts.glb", "-o", "kept.glb", "--normals", "face", "--keep-unused")
        lean_tree, lean_binary = read_glb(self.dir / "lean.glb")
        self.assertEqual(len(lean_tree["accessors"]), len(read_glb(self.dir / "kept.glb")[0]["accessors"]))
        self.assertLessEqual(len(lean_binary), len(read_glb(self.dir / "kept.glb")[1]))
        tree, arrays = two_squares(-6, 6)
        tree["meshes"][1]["primitives"][0]["attributes"]["NORMAL"] = tree["meshes"][0]["primitives"][0]["attributes"]["NORMAL"]
        tree["meshes"][0]["primitives"][0]["attributes"]["_KEPT"] = 0  # two uses: not to be overwritten
        for name, extension in (("shared", None), ("vendor", "VENDOR_unknown")):
            if extension:
                tree["extensionsUsed"] = [extension]
            (self.dir / f"{name}.glb").write_bytes(glb(tree, arrays))
            self.smooth(f"{name}.glb", "-o", f"{name}-new.glb", "--normals", "model")
            self.smooth(f"{name}.glb", "-o", f"{name}-kept.glb", "--normals", "model", "--keep-unused")
        sizes = {n: len(read_glb(self.dir / f"{n}.glb")[1]) for n in ("shared-new", "shared-kept", "vendor-new", "vendor-kept")}
        self.assertLess(sizes["shared-new"], sizes["shared-kept"])
        self.assertEqual(sizes["vendor-new"], sizes["vendor-kept"])
        new, old = read_glb(self.dir / "shared-new.glb")[0], tree
        self.assertEqual([a["type"] for a in new["accessors"][:len(old["accessors"])]], [a["type"] for a in old["accessors"]])
        self.assertEqual(new["animations"], old["animations"])
        done = subprocess.run([program.PROGRAM, "check", "shared-new.glb"], cwd=self.dir, capture_output=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_character_keeps_its_clips_and_all_other_bytes(self):
        model = ASSETS / "gltf/kaykit/Knight.glb"
        if not model.exists():
            self.skipTest("the shared models are not there")
        row = self.row(model, "-o", "knight.glb")
        self.assertGreater(row["seams"]["turned"], 100)
        self.assertLess(row["seams"]["turned"], row["seams"]["normals"] / 20)
        self.assertLess(row["seams"]["max_deg"], 30)
        old, new = read_glb(model), read_glb(self.dir / "knight.glb")
        self.assertEqual(old[0]["animations"], new[0]["animations"])
        self.assertEqual(old[0]["skins"], new[0]["skins"])
        self.assertEqual(len(old[1]), len(new[1]))
        normals = set()
        for mesh in old[0]["meshes"]:
            for p in mesh["primitives"]:
                a = old[0]["accessors"][p["attributes"]["NORMAL"]]
                at = old[0]["bufferViews"][a["bufferView"]]["byteOffset"] + a.get("byteOffset", 0)
                normals.update(range(at, at + 12 * a["count"]))
        changed = [i for i, (a, b) in enumerate(zip(old[1], new[1])) if a != b]
        self.assertTrue(changed)
        self.assertTrue(normals.issuperset(changed))
        self.assertLessEqual(len({i // 12 for i in changed}), 3 * row["seams"]["turned"])

    def test_a_model_without_seams_is_copied_byte_by_byte(self):
        model = ASSETS / "gltf/FlightHelmet/FlightHelmet.gltf"
        if not model.exists():
            self.skipTest("the shared models are not there")
        row = self.row(model, "-o", "out/helmet.gltf") if (self.dir / "out").mkdir() is None else None
        self.assertFalse(row["changed"])
        self.assertEqual((self.dir / "out/helmet.gltf").read_bytes(), model.read_bytes())

    def test_an_imported_character_keeps_its_skin_and_its_clip(self):
        if not (pathlib.Path(program.PROGRAM).parent / "rakelight-import").exists():
            self.skipTest("built without the import helper")
        (self.dir / "rod.dae").write_text(RIGGED_DAE)
        for out in ("rod.glb", "rod.gltf"):
            self.smooth("rod.dae", "-o", out)
            tree = read_glb(self.dir / out)[0] if out.endswith(".glb") else json.loads((self.dir / out).read_text())
            joints = [tree["nodes"][j]["name"] for j in tree["skins"][0]["joints"]]
            self.assertEqual(sorted(joints), ["high", "low"])
            self.assertEqual(len(tree["animations"]), 1)
            target = tree["animations"][0]["channels"][0]["target"]
            self.assertEqual(tree["nodes"][target["node"]]["name"], "high")
            self.assertIn("JOINTS_0", tree["meshes"][0]["primitives"][0]["attributes"])
            done = subprocess.run([program.PROGRAM, "check", out], cwd=self.dir, capture_output=True, timeout=60)
            self.assertEqual(done.returncode, 0, done.stderr)
        for out in ("rod.obj", "rod.ply"):
            self.assertIn("bind pose", self.smooth("rod.dae", "-o", out, "--verbose").stderr)

    def test_every_way_out_of_other_formats(self):
        (self.dir / "world.scene.toml").write_text("[[model]]\nfile = 'parts.glb'\n[[model]]\nfile = 'parts.glb'\nposition = [0, 0, 5]\n")
        for model in ("world.scene.toml", "parts.glb", "builtin:sphere"):
            for ending in ("glb", "gltf", "obj", "ply"):
                out = f"{re.sub('[^a-z]', '-', model)}.{ending}"
                self.smooth(model, "-o", out)
                done = subprocess.run([program.PROGRAM, "inspect", out, "--json"], cwd=self.dir, capture_output=True, text=True, timeout=60)
                rows = json.loads(done.stdout)["rows"][0]
                self.assertEqual(rows["seams"]["seam_deg"], 0, out)
                self.assertGreater(rows["triangles"], 3, out)


if __name__ == "__main__":
    program.main()
