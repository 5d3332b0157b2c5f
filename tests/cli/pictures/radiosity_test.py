#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The method radiosity and the verb of that name through the program: pictures by every engine, files for every viewer.

  radiosity_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import exr
import program
from path_test import WORLD

SIZE = ("--resolution", "60,40")
PLAIN = ("--look", "plain", "--method", "radiosity", "--radiosity-elements", "600")
MOVING = str(pathlib.Path(__file__).resolve().parents[2] / "one_way/moving.glb")
ROOM = WORLD.replace('method = "path"\nsamples = 8\n', "").replace('engine = "trace"\n', "").replace("roughness = 1\n", "roughness = 1\nspecular_factor = 0\n")


def glb_json(data):
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length])


class Radiosity(program.Case):
    def setUp(self):
        super().setUp()
        self.write("w.scene.toml", ROOM)
        run = self.run_program("render", "w.scene.toml", "-o", "try.png", *SIZE, "--engine", "trace", "--method", "cast")
        if run.code != 0 and ("Embree" in run.err or "engine trace" in run.err):
            self.skipTest("rays are not there")
        self.assertEqual(run.code, 0, run.err)

    def fine(self, *words):
        run = self.run_program(*words)
        self.assertEqual(run.code, 0, run.err)
        return run

    def test_the_report_says_what_came_of_it(self):
        run = self.fine("render", "w.scene.toml", "-o", "a.png", *SIZE, *PLAIN, "--json")
        remarks = [r["message"] for r in json.loads(run.out)["rows"][0]["remarks"]]
        self.assertTrue(any(m.startswith("radiosity: ") and "patches" in m and "left the scene" in m for m in remarks), remarks)

    def test_every_engine_shows_the_same_light(self):
        self.fine("render", "w.scene.toml", "-o", "soft.png", *SIZE, *PLAIN)
        self.fine("render", "w.scene.toml", "-o", "trace.png", *SIZE, *PLAIN, "--engine", "trace")
        self.fine("compare", "soft.png", "trace.png", "--max-flip", "0.02")

    def test_the_same_bits_for_any_number_of_threads(self):
        self.fine("render", "w.scene.toml", "-o", "a.png", *SIZE, *PLAIN, "--threads", "1")
        self.fine("render", "w.scene.toml", "-o", "b.png", *SIZE, *PLAIN, "--threads", "3")
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_it_is_near_the_picture_by_paths(self):
        """Of the floor below the lamp, which is not seen itself."""
        view = ("--look", "plain", "--camera-position", "0,1,0.001", "--camera-focal-point", "0,0,0", "--window", "20,10,20,20", *SIZE)
        self.fine("render", "w.scene.toml", "-o", "r.exr", "--method", "radiosity", *view)
        self.fine("render", "w.scene.toml", "-o", "p.exr", "--engine", "trace", "--method", "path", "--samples", "256", *view)
        means = []
        for name in ("r.exr", "p.exr"):
            rows = exr.read(self.folder / name)[2]["G"][1]
            means.append(sum(map(sum, rows)))
        self.assertGreater(means[1], 0)
        self.assertLess(abs(means[0] / means[1] - 1), 0.03, means)

    def test_the_file_shows_the_light_without_any_lamp(self):
        run = self.fine("radiosity", "w.scene.toml", "-o", "lit.glb", "--radiosity-elements", "600", "--json")
        row = json.loads(run.out)["rows"][0]
        self.assertLessEqual(row["elements"], 600)
        self.assertAlmostEqual(row["emitted_w"], row["absorbed_w"] + row["unshot_w"] + row["left_w"], places=6)
        gltf = glb_json((self.folder / "lit.glb").read_bytes())
        self.assertEqual(gltf["extensionsUsed"], ["KHR_materials_unlit"])
        for mesh in gltf["meshes"]:
            for primitive in mesh["primitives"]:
                colors = gltf["accessors"][primitive["attributes"]["COLOR_0"]]
                self.assertEqual((colors["componentType"], colors["type"]), (5126, "VEC4"))
        self.fine("render", "w.scene.toml", "-o", "a.png", *SIZE, *PLAIN, "--background", "black")
        self.fine("render", "lit.glb", "-o", "b.png", *SIZE, "--look", "plain", "--background", "black")
        self.fine("compare", "a.png", "b.png", "--max-error", "2/255")

    def outline(self, picture):
        return [tuple(row[3 * x:3 * x + 3]) != tuple(row[:3]) for row in program.png(self.folder / picture)[3] for x in range(60)]

    def test_a_character_is_lit_in_its_pose(self):
        words = (MOVING, "--radiosity-elements", "1000", "--animation-name", "everything", "--animation-time", "0.6", "--light", "directional:-1,-1,-1")
        view = (*SIZE, "--look", "plain", "--view", "front")
        self.fine("render", *words, "-o", "a.png", "--method", "radiosity", *view)
        self.fine("render", *words[:1], *words[3:], "-o", "b.png", *view)
        self.fine("render", *words[:1], *words[7:], "-o", "still.png", *view)
        lit, posed, still = map(self.outline, ("a.png", "b.png", "still.png"))
        self.assertLess(sum(a != b for a, b in zip(lit, posed)), 20, "another outline")
        self.assertGreater(sum(a != b for a, b in zip(still, posed)), 60, "it does not move")
        for name, more in (("lit.glb", ()), ("map.glb", ("--lightmap", "128"))):
            self.fine("radiosity", *words, "-o", name, *more)
            self.fine("check", name)
            gltf = glb_json((self.folder / name).read_bytes())
            self.assertFalse({"skins", "animations"} & set(gltf))

    def test_a_lightmap_shows_the_same_light_on_the_models_own_triangles(self):
        words = ("--radiosity-elements", "600", "--json")
        run = self.fine("radiosity", "w.scene.toml", "-o", "map.glb", "--lightmap", "256,200", *words)
        row = json.loads(run.out)["rows"][0]
        self.assertGreater(row["lightmap"]["charts"], 0)
        self.assertEqual(row["lightmap"]["overlapping_charts"], 0)
        gltf = glb_json((self.folder / "map.glb").read_bytes())
        material = gltf["materials"][gltf["meshes"][0]["primitives"][0]["material"]]
        self.assertEqual(material["emissiveTexture"]["texCoord"], 1)
        self.assertEqual(material["pbrMetallicRoughness"]["baseColorFactor"][:3], [0, 0, 0])
        self.assertLess(sum(gltf["accessors"][p["indices"]]["count"] for m in gltf["meshes"] for p in m["primitives"]), 300)
        self.fine("radiosity", "w.scene.toml", "-o", "lit.glb", *words)
        for name in ("lit", "map"):
            for engine in ("soft", "trace"):
                self.fine("render", f"{name}.glb", "-o", f"{name}-{engine}.png", *SIZE, "--look", "plain", "--background", "black", "--engine", engine)
        self.fine("compare", "lit-soft.png", "map-soft.png", "--max-flip", "0.03")
        self.fine("compare", "map-soft.png", "map-trace.png", "--max-flip", "0.02")
        self.check_refused(self.run_program("radiosity", "w.scene.toml", "-o", "x.glb", "--lightmap", "0"), 2, "lightmap")
        self.check_refused(self.run_program("radiosity", "w.scene.toml", "-o", "x.glb", "--lightmap", "1,2,3"), 2, "lightmap")

    def test_what_cannot_be_is_one_line(self):
        self.check_refused(self.run_program("radiosity", "w.scene.toml", "-o", "lit.obj"), 2, ".glb")
        self.check_refused(self.run_program("render", "w.scene.toml", "-o", "a.png", "--method", "radiosity", "--radiosity-elements", "200001"), 2, "200000")
        self.check_refused(self.run_program("render", "w.scene.toml", "-o", "a.png", "--method", "radiosity", "--radiosity-unshot", "0"), 2, "radiosity-unshot")
        self.check_refused(self.run_program("render", "w.scene.toml", "-o", "a.png", "--method", "radiosity", "--front-face", "cw"), 2, "method")

    def test_settings_without_the_method_are_said(self):
        run = self.fine("render", "w.scene.toml", "-o", "a.png", *SIZE, "--radiosity-elements", "600")
        self.assertIn("no effect without the method radiosity", run.err)


if __name__ == "__main__":
    program.main()
