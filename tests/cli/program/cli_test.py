#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the real program: pictures, options, JSON, help. Standard library only.

  cli_test.py PROGRAM [unittest arguments]"""
import base64
import json
import os
import pathlib
import re
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import TWO_PARTS, png


class Cli(program.Case):
    # --- pictures ---

    def test_a_picture_appears_and_shows_the_model(self):
        self.write("a.obj")
        result = self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "64,48")
        self.assertEqual((result.code, result.out, result.err), (0, "", ""))
        width, height, channels, rows = png(self.folder / "a.png")
        self.assertEqual((width, height, channels), (64, 48, 3))
        self.assertNotEqual(rows[24][96:99], rows[0][0:3])
        self.assertEqual(self.files(), ["a.obj", "a.png"])

    def test_the_picture_does_not_depend_on_threads_or_instruction_set(self):
        self.write("a.obj", TWO_PARTS)
        pictures = set()
        for threads, isa in ((1, "scalar"), (3, "scalar"), (2, "sse2"), (4, "")):
            result = self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "200,150", "--threads", threads, RAKELIGHT_ISA=isa)
            self.assertEqual(result.code, 0, result.err)
            pictures.add((self.folder / "a.png").read_bytes())
        self.assertEqual(len(pictures), 1)

    def test_a_window_is_cut_out_of_the_whole_picture(self):
        self.write("a.obj", TWO_PARTS)
        self.assertEqual(self.run_program("render", "a.obj", "-o", "all.png", "--resolution", "150x100").code, 0)
        self.assertEqual(self.run_program("render", "a.obj", "-o", "part.png", "--resolution", "150,100", "--window", "41,23,70,51").code, 0)
        _, _, _, all_rows = png(self.folder / "all.png")
        width, height, _, rows = png(self.folder / "part.png")
        self.assertEqual((width, height), (70, 51))
        self.assertEqual(rows, [row[41 * 3:111 * 3] for row in all_rows[23:74]])

    def test_the_background_is_the_display_color_that_was_asked_for(self):
        self.write("a.obj")
        for text, expected in (("#ff8000", (255, 128, 0)), ("0,0.5,1", (0, 128, 255)), ("#fff", (255, 255, 255))):
            result = self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "40,30", "--background", text)
            self.assertEqual(result.code, 0, result.err)
            self.assertEqual(tuple(png(self.folder / "a.png")[3][0][:3]), expected)

    def test_a_transparent_background_gives_alpha(self):
        self.write("a.obj")
        self.assertEqual(self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "40,30", "--background", "transparent").code, 0)
        _, _, channels, rows = png(self.folder / "a.png")
        self.assertEqual(channels, 4)
        self.assertEqual(rows[0][3], 0)
        self.assertEqual(rows[15][20 * 4 + 3], 255)
        self.check_refused(self.run_program("render", "a.obj", "-o", "a.jpg", "--background", "transparent"), 2, "alpha")

    def test_channels_go_to_files_of_their_own(self):
        self.write("a.obj")
        result = self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "40,30", "--channels", "depth,object", "--json")
        self.assertEqual(result.code, 0, result.err)
        self.assertEqual(self.files(), ["a.depth.exr", "a.obj", "a.object.exr", "a.png"])
        self.assertEqual(json.loads(result.out)["rows"][0]["channel_files"], ["a.depth.exr", "a.object.exr"])

    def test_every_picture_format_is_written(self):
        self.write("a.obj")
        marks = {"png": b"\x89PNG", "jpg": b"\xff\xd8", "webp": b"RIFF", "exr": b"\x76\x2f\x31\x01", "hdr": b"#?"}
        for ending, mark in marks.items():
            result = self.run_program("render", "a.obj", "-o", f"a.{ending}", "--resolution", "40,30")
            self.assertEqual(result.code, 0, result.err)
            self.assertTrue((self.folder / f"a.{ending}").read_bytes().startswith(mark), ending)

    def test_lights_and_views_change_the_picture(self):
        self.write("a.obj", TWO_PARTS)
        pictures = {}
        for arguments in ((), ("--light", "ambient:0.2,0.2,0.2"), ("--light", "point:0,0,3:color=1,0,0:attenuation=1,0,0.1"),
                          ("--light", "directional:0,0,-1", "--light", "spot:0,0,5:cutoff=10"), ("--view", "isometric"),
                          ("--camera-position", "-3,.5,4"), ("--camera-view-angle", "80"), ("--view", "front", "--camera-orthographic"),
                          ("--shading", "unlit"), ("--normals", "flat", "--lighting", "lambert")):
            result = self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "80,60", *arguments)
            self.assertEqual((result.code, result.err), (0, ""), arguments)
            pictures[(self.folder / "a.png").read_bytes()] = arguments
        self.assertEqual(len(pictures), 10)

    def test_tangents_are_made_perpendicular_where_it_is_asked_for_and_the_loss_is_said(self):
        common = ("--resolution", "160,120", "--normals", "model", "--tangents", "published")
        self.assertEqual(self.run_program("render", "builtin:teapot", "-o", "map.png", "--light", "ambient:.6,.7,1", *common).code, 0)
        pictures = set()
        for where in ("attribute", "shader", "off"):
            result = self.run_program("render", "builtin:teapot", "-o", "a.png", "--texture-normal", "map.png", *common, "--orthogonalize",
                                      where, "--verbose", "--json")
            self.assertEqual(result.code, 0, result.err)
            loss = [float(x) for x in re.findall(r"at most ([0-9.]+) degrees \(mean [0-9.]+\) from perpendicular", result.err)]
            self.assertGreater(len(loss), 0, result.err)
            self.assertGreater(max(loss), 0.1)
            self.assertIn("from perpendicular to the normals", result.out)
            pictures.add((self.folder / "a.png").read_bytes())
        self.assertEqual(len(pictures), 3)
        self.assertNotIn("perpendicular", self.run_program("render", "builtin:teapot", "-o", "a.png", "--texture-normal", "map.png",
                                                           *common, "--verbose").err)

    def test_instances_are_copied_or_kept_as_asked_and_that_is_said(self):
        data = struct.pack("<12f6H", 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 2, 0, 2, 3)
        self.write("a.gltf", json.dumps({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
            "nodes": [{"mesh": 0}, {"mesh": 0, "translation": [1, 0, 0], "rotation": [0, 0.1305262, 0, 0.9914449]}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                          {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
            "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
            "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}))
        common = ("render", "a.gltf", "-o", "a.png", "--resolution", "64,48", "--normals", "model", "--crease-angle", "60", "--verbose")
        copied, kept = self.run_program(*common), self.run_program(*common, "--keep-instances")
        self.assertEqual((copied.code, kept.code), (0, 0), copied.err + kept.err)
        self.assertIn("1 instances got a mesh of their own", copied.err)
        self.assertIn("warning: a.gltf: 1 instances that touch other things keep the normals of the first", kept.err)

    def test_a_named_camera_that_is_not_there_is_wrong_usage(self):
        self.write("a.obj")
        self.check_refused(self.run_program("render", "a.obj", "-o", "a.png", "--camera-index", "front door"), 2, "a.obj", "front door", "has none")

    # --- bench ---

    def test_a_measurement_that_the_machine_has_no_memory_for_is_refused(self):
        self.check_refused(self.run_program("bench", "smooth", "--triangles", "20M", "--max-memory", "1G"), 4, "bytes, more than the limit")
        if os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") < 100e9:  # what the model of the next line takes
            self.check_refused(self.run_program("bench", "smooth", "--triangles", "1000M"), 4, "bytes, more than the limit")

    # --- several inputs ---

    def test_each_of_several_models_gets_its_own_picture(self):
        names = [f"model.{i}.obj" for i in range(10)]
        for name in names:
            self.write(name)
        (self.folder / "out").mkdir()
        result = self.run_program("render", *names, "-o", "out/{model}.png", "--resolution", "16,12", "--json")
        self.assertEqual(result.code, 0, result.err)
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()), [f"model.{i}.png" for i in range(10)])
        self.assertEqual([row["file"] for row in json.loads(result.out)["rows"]], names)

    def test_several_models_need_a_template_without_clashes(self):
        self.write("a.obj")
        self.write("b.obj")
        (self.folder / "sub").mkdir()
        self.write("sub/a.obj")
        self.check_refused(self.run_program("render", "a.obj", "b.obj", "-o", "x.png"), 2, "{model}")
        self.check_refused(self.run_program("render", "b.obj", "a.obj", "sub/a.obj", "-o", "{model}.png"), 2, "sub/a.obj")
        self.check_refused(self.run_program("render", "a.obj", "a.obj", "-o", "./{model}.png"), 2)
        self.assertEqual(self.files(), ["a.obj", "b.obj", "sub"])

    # --- errors ---

    def test_wrong_usage_is_exit_2_with_one_line(self):
        self.write("a.obj")
        wrong = (("--view", "front", "--camera-position", "0,0,5"), ("--camera-index", "0", "--camera-position", "0,0,5"),
                 ("--light", "default", "--light", "ambient:1,1,1"), ("--light", "spot:0,0,1:exponent=-1"), ("--normal-scale", "101"),
                 ("--camera-position", "1e30,0,0"), ("--max-memory", "1.5X"), ("--resolution", "12"), ("--resolution", "0,5"), ("--resolution", "99999999999,5"), ("--resolution", "1e3,5"),
                 ("--window", "0,0,9999,1"), ("--window", "0,0,0,0"), ("--window", "-1,0,5,5"), ("--engine", "hard"),
                 ("--shading", "x"), ("--lighting", "ggx"), ("--bump", "deep"),
                 ("--normals", "none"), ("--crease-angle", "181"), ("--crease-angle", "nan"), ("--crease-angle", "60deg"),
                 ("--camera-position", "1,2"), ("--camera-position", "1,2,inf"), ("--camera-view-angle", "180"), ("--view", "behind"),
                 ("--view", "front", "--camera-index", "0"), ("--light", "sun"), ("--light", "point"), ("--light", "point:0,0"),
                 ("--light", "directional:0,0,0"), ("--light", "ambient:1,1,1:cutoff=3"), ("--light", "spot:0,0,1:cutoff=100"), ("--light", "spot:0,0,1:cutoff=0.0001"), ("--light", "point:0,0,1:range=1e-7"),
                 ("--light", "point:0,0,0:attenuation=0,0,0"), ("--light", "ambient:-1,0,0"), ("--background", "purpel"), ("--light", "ambient:1e39,0,0"), ("--light", "point:0,0,0:attenuation=0,1e39,0"),
                 ("--background", "2,0,0"), ("--channels", "depth,smell"), ("--threads", "0"), ("--threads", "two"),
                 ("--threads", "1025"), ("--max-memory", "lots"), ("--max-memory", "99999999999T"), ("--quiet", "--verbose"),
                 ("--no-such-option",), ("-o",), ("-o", "b.png"))
        for arguments in wrong:
            with self.subTest(arguments=arguments):
                self.check_refused(self.run_program("render", "a.obj", "-o", "a.png", *arguments), 2)
        self.check_refused(self.run_program("rendr", "a.obj"), 2, "unknown command 'rendr'")
        self.check_refused(self.run_program("render", "a.obj", "-o", "a.png", "--light", "sun"), 2, "photometric-spot, default")
        self.check_refused(self.run_program("render", "a.obj", "-o", "a.png", "--light", "default:1,1,1"), 2, "without numbers")
        self.check_refused(self.run_program("bench", "render", "--triangles", "1k", "--objects", "100"), 2, "1000 triangles are too few for 100 objects", "--objects")
        self.check_refused(self.run_program("render", "-lead.glb", "-o", "a.png"), 2, "./-lead.glb")
        self.check_refused(self.run_program("render", "a.obj", "-o", "{name}.png"), 2, "{model}")
        for arguments in ((), ("paint",), ("render",), ("render", "a.obj"), ("render", "-o", "a.png"), ("inspect",), ("--what",)):
            with self.subTest(arguments=arguments):
                self.check_refused(self.run_program(*arguments), 2, "--help")
        self.check_refused(self.run_program("render", "a.obj", "-o", "a.tiff"), 2, "a.tiff")
        self.assertEqual(self.files(), ["a.obj"])

    def test_a_misspelt_option_is_said_with_the_nearest_that_there_is(self):
        self.write("a.obj")
        render = ("render", "a.obj", "-o", "a.png")
        for given, meant in (("--resolutoin", "--resolution"), ("--resolutoin=1.5,4", "--resolution"), ("--thread", "--threads"),
                             ("--camera-view", "--camera-view-up"), ("--backgruond", "--background")):
            with self.subTest(given=given):
                self.check_refused(self.run_program(*render, given, "4,4"), 2, "unknown option '" + given.split("=")[0] + "'",
                                   "did you mean " + meant + "?", "see rakelight render --help")
        self.check_refused(self.run_program("explain", "a.obj", "--pixle", "3,4"), 2, "'--pixle'", "did you mean --pixel?")
        result = self.run_program(*render, "--elephant")
        self.check_refused(result, 2, "unknown option '--elephant'; see rakelight render --help")
        self.check_refused(self.run_program(*render, "-x"), 2, "unknown option '-x'")
        self.assertEqual(self.files(), ["a.obj"])

    def test_an_option_given_twice_and_a_flag_with_a_value_are_wrong_usage(self):
        self.write("a.obj")
        render = ("render", "a.obj", "-o", "a.png")
        self.check_refused(self.run_program(*render, "--resolution", "8,8", "--resolution=9,9"), 2, "--resolution is given more than once")
        self.check_refused(self.run_program(*render, "-o", "b.png"), 2, "--output is given more than once")
        for flag in ("--json=x", "--quiet=maybe"):
            with self.subTest(flag=flag):
                name, value = flag.split("=")
                self.check_refused(self.run_program(*render, flag), 2, f"{name}: must be on or off, not '{value}'")
        for switch in ("--edges=5", "--wireframe=2", "--camera-orthographic=yes"):
            self.check_refused(self.run_program(*render, switch), 2, switch.split("=")[0] + ": must be on or off")
        self.assertEqual(self.files(), ["a.obj"])

    def test_a_small_measurement_has_as_many_objects_as_its_triangles_allow(self):
        small = ("bench", "render", "--triangles", "100", "--resolution", "16,16", "--frames", "1", "--json")
        self.assertEqual(json.loads(self.run_program(*small).out)["objects"], 5)
        self.assertEqual(json.loads(self.run_program(*small, "--shading", "auto").out)["objects"], 5)
        self.check_refused(self.run_program(*small, "--objects", "6"), 2, "too few for 6 objects")
        self.assertEqual(self.run_program("bench", "smooth", "--triangles", "100", "--repetitions", "1").code, 0)

    def test_an_empty_value_is_wrong_usage_for_every_option(self):
        self.write("a.obj")
        options = set(re.findall(r"(--[a-z-]+) [A-Z{a-z]", self.run_program("render", "--help").out.split("Lights:")[0]))
        self.assertGreater(len(options), 25)
        for option in sorted(options):
            with self.subTest(option=option):
                for arguments in ((option, ""), (option + "=",)):
                    self.check_refused(self.run_program("render", "a.obj", "-o", "a.png", *arguments), 2, option, "empty")
        self.check_refused(self.run_program("render", "", "-o", "a.png"), 2)
        self.assertEqual(self.files(), ["a.obj"])

    def test_a_picture_for_the_materials_must_be_one(self):
        self.write("a.obj")
        self.write("text.png", "no picture")
        (self.folder / "folder.png").mkdir()
        for name, code, words in (("text.png", 4, "picture"), ("folder.png", 3, "is a folder"), ("none.png", 3, "")):
            for option in ("--texture-base-color", "--texture-normal"):
                result = self.run_program("render", "a.obj", "-o", "a.png", option, name)
                self.check_refused(result, code, name, words)
                self.assertEqual(result.err.count(name), 1, result.err)

    def test_default_light_and_view_and_memory_in_fractions_are_understood(self):
        self.write("a.obj")
        plain = ("render", "a.obj", "-o", "a.png", "--resolution", "40,30")
        self.assertEqual(self.run_program(*plain).code, 0)
        before = (self.folder / "a.png").read_bytes()
        result = self.run_program(*plain, "--light", "default", "--view", "default", "--max-memory", "1.5G")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual((self.folder / "a.png").read_bytes(), before)

    def test_a_camera_that_sees_nothing_is_warned_about(self):
        self.write("a.obj")
        result = self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "16,12", "--camera-position", "0,0,5",
                                  "--camera-focal-point", "0,0,9")
        self.assertEqual(result.code, 0)
        self.assertTrue(all(line.startswith("rakelight: warning: a.obj: ") for line in result.lines), result.err)
        self.assertTrue(result.lines)

    # --- JSON, inspect, help ---

    def test_render_json_has_the_promised_fields(self):
        self.write("a.obj", TWO_PARTS)
        result = self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "32,24", "--json", "--threads", "2")
        whole = json.loads(result.out)
        self.assertEqual(whole["schema"], "rakelight.render/1")
        row = whole["rows"][0]
        expected = {"file": "a.obj", "output": "a.png", "width": 32, "height": 24, "triangles": 4, "objects": 2, "engine": "soft", "threads": 2}
        self.assertEqual({key: row[key] for key in expected}, expected)
        self.assertIn(row["isa"], ("scalar", "sse2", "avx2", "avx512"))
        for key in ("load_ms", "prepare_ms", "render_ms", "write_ms"):
            self.assertGreaterEqual(row[key], 0)
        self.assertIsInstance(row["remarks"], list)
        self.assertGreater(row["stats"]["pixels_covered"], 0)

    def test_stats_count_where_lighting_is_evaluated(self):
        self.write("a.obj", TWO_PARTS)
        where = {}
        for shading in ("unlit", "flat", "gouraud", "phong"):
            arguments = ("render", "a.obj", "-o", "a.png", "--resolution", "32,24", "--shading", shading)
            stats = json.loads(self.run_program(*arguments, "--stats", "--json").out)["rows"][0]["stats"]
            where[shading] = stats["lighting_evaluations"]
            text = self.run_program(*arguments, "--stats")
            self.assertEqual(text.code, 0, text.err)
            self.assertRegex(text.out, rf"a\.png: lighting evaluations +{where[shading]}\b")
            self.assertRegex(text.out, rf"a\.png: pixels covered +{stats['pixels_covered']}\b")
            self.assertRegex(text.out, rf"a\.png: objects outside +{stats['objects_outside']}\b")
            self.assertEqual(self.run_program(*arguments).out, "")
            self.assertGreaterEqual(stats["overdraw"], 1)
        self.assertEqual(where, {"unlit": 0, "flat": 4, "gouraud": 8, "phong": stats["pixels_covered"]})

    def test_shading_is_set_by_object_and_material(self):
        self.write("parts.obj", program.TWO_PARTS)
        def evaluations(*options):
            run = self.run_program("render", "parts.obj", "-o", "out.png", "--resolution", "80,60", "--json", *options)
            self.assertEqual((run.code, run.err), (0, ""))
            return json.loads(run.out)["rows"][0]["stats"]["lighting_evaluations"]
        self.assertEqual(evaluations("--shading", "flat"), 4)
        self.assertEqual(evaluations("--shading", "flat", "--shading", "object:left=unlit"), 2)
        self.assertEqual(evaluations("--shading", "object:left=unlit", "--shading", "object:right=flat"), 2)
        self.assertEqual(evaluations("--shading", "auto"), evaluations("--shading", "phong"))

    def test_words_of_shading_are_checked(self):
        for words in (("flat", "phong"), ("object:left",), ("object:=flat",), ("material:a=round",), ("automatic",)):
            options = [w for word in words for w in ("--shading", word)]
            self.check_refused(self.run_program("render", "builtin:teapot", "-o", "out.png", *options), 2, "--shading")
        run = self.run_program("render", "builtin:teapot", "-o", "out.png", "--resolution", "8,8", "--shading", "material:gold=flat")
        self.assertEqual(run.code, 0)
        self.assertEqual(len(run.lines), 1)
        self.assertIn("no material is named 'gold'", run.err)

    def test_inspect_says_what_is_in_a_model(self):
        self.write("a.obj", TWO_PARTS)
        text = self.run_program("inspect", "a.obj")
        self.assertEqual(text.code, 0, text.err)
        for word in ("2 objects", "4 triangles", "left", "right", "2 positions shared"):
            self.assertIn(word, text.out)
        result = self.run_program("inspect", "a.obj", "--json", "--normals", "object")
        whole = json.loads(result.out)
        self.assertEqual(whole["schema"], "rakelight.inspect/1")
        row = whole["rows"][0]
        self.assertEqual([o["name"] for o in row["objects"]], ["left", "right"])
        self.assertEqual(row["bounds"], {"low": [-1, 0, 0], "high": [1, 1, 0.5]})
        self.assertFalse(row["posed"])
        self.assertEqual(row["shared_positions"], 2)
        self.assertGreater(row["borders"][0]["largest_deg"], 10)
        over_model = json.loads(self.run_program("inspect", "a.obj", "--json", "--normals", "model", "--crease-angle", "180").out)
        self.assertLess(over_model["rows"][0]["borders"][0]["largest_deg"], 0.01)

    def test_help_and_version_go_to_standard_output(self):
        for arguments in (("--help",), ("render", "--help"), ("inspect", "-h"), ("help",), ("help", "render")):
            result = self.run_program(*arguments)
            self.assertEqual((result.code, result.err), (0, ""))
            self.assertIn("Examples:", result.out)
            self.assertLessEqual(max(map(len, result.out.splitlines())), 100)
        version = self.run_program("--version")
        self.assertEqual((version.code, version.err), (0, ""))
        for word in ("rakelight ", "engines:", "soft", "model formats:", "glTF", "OBJ", "instruction set:", "scalar", "threads:"):
            self.assertIn(word, version.out)


if __name__ == "__main__":
    program.main()
