#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the real program: exit codes, one-line messages, files left behind, JSON. Standard library only.

  cli_test.py PROGRAM [unittest arguments]"""
import base64
import json
import os
import pathlib
import pty
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

PROGRAM = ""

SQUARE = "o {name}\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"
TWO_PARTS = "o left\nv -1 0 0\nv 0 0 0\nv 0 1 0.5\nv -1 1 0\nf 1 2 3 4\no right\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nf 5 6 7 8\n"


class Result:
    def __init__(self, done):
        self.code, self.out, self.err = done.returncode, done.stdout, done.stderr
        self.lines = self.err.splitlines()


def png(path):
    """(width, height, channels, rows of bytes) of an 8-bit, non-interlaced PNG."""
    data, at, packed = pathlib.Path(path).read_bytes(), 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        chunk = data[at + 8:at + 8 + size]
        at += 12 + size
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", chunk)
        if kind == b"IDAT":
            packed += chunk
    assert (depth, interlace) == (8, 0)
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[color]
    raw, stride, rows, above = zlib.decompress(packed), width * channels, [], bytearray(width * channels)
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            a = row[x - channels] if x >= channels else 0
            b, c = above[x], above[x - channels] if x >= channels else 0
            p = a + b - c
            nearest = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            row[x] = (row[x] + (0, a, b, (a + b) // 2, nearest)[kind]) & 255
        rows.append(row)
        above = row
    return width, height, channels, rows


class Cli(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="rakelight_cli_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def run_program(self, *arguments, **environment):
        return Result(subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, timeout=120,
                                     stdin=subprocess.DEVNULL, env={**os.environ, **environment}))

    def write(self, name, text=None):
        path = self.folder / name
        path.write_text(SQUARE.format(name="square") if text is None else text)
        return path

    def files(self):
        return sorted(p.name for p in self.folder.iterdir())

    def check_refused(self, result, code, *words):
        """One line on standard error, nothing on standard output, the expected code."""
        self.assertEqual(result.code, code, result.err)
        self.assertEqual(len(result.lines), 1, result.err)
        self.assertTrue(result.err.startswith("rakelight: error: "), result.err)
        self.assertEqual(result.out, "")
        for word in words:
            self.assertIn(word, result.err)

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
        common = ("render", "a.gltf", "-o", "a.png", "--resolution", "64,48", "--normals", "model", "--verbose")
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

    def test_a_failing_model_does_not_stop_the_others(self):
        self.write("bad.obj", "v 0 0 0\nf 1 2 99\n")
        self.write("good.obj")
        result = self.run_program("render", "missing.obj", "bad.obj", "good.obj", "-o", "{model}.png", "--resolution", "16,12", "--json")
        self.assertEqual(result.code, 4, result.err)
        self.assertEqual(len([line for line in result.lines if line.startswith("rakelight: error: ")]), 2)
        rows = json.loads(result.out)["rows"]
        self.assertEqual([row.get("error", {}).get("exit_code", 0) for row in rows], [3, 4, 0])
        self.assertEqual(self.files(), ["bad.obj", "good.obj", "good.png"])

    # --- errors ---

    def test_wrong_usage_is_exit_2_with_one_line(self):
        self.write("a.obj")
        wrong = (("--view", "front", "--camera-position", "0,0,5"), ("--camera-index", "0", "--camera-position", "0,0,5"),
                 ("--light", "default", "--light", "ambient:1,1,1"), ("--light", "spot:0,0,1:exponent=-1"), ("--normal-scale", "101"),
                 ("--camera-position", "1e30,0,0"), ("--max-memory", "1.5X"), ("--resolution", "12"), ("--resolution", "0,5"), ("--resolution", "99999999999,5"), ("--resolution", "1e3,5"),
                 ("--window", "0,0,9999,1"), ("--window", "0,0,0,0"), ("--window", "-1,0,5,5"), ("--engine", "hard"), ("--engine", "gl"),
                 ("--shading", "x"), ("--lighting", "pbr"), ("--bump", "steep"),
                 ("--normals", "none"), ("--crease-angle", "181"), ("--crease-angle", "nan"), ("--crease-angle", "60deg"),
                 ("--camera-position", "1,2"), ("--camera-position", "1,2,inf"), ("--camera-view-angle", "180"), ("--view", "behind"),
                 ("--view", "front", "--camera-index", "0"), ("--light", "sun"), ("--light", "point"), ("--light", "point:0,0"),
                 ("--light", "directional:0,0,0"), ("--light", "ambient:1,1,1:cutoff=3"), ("--light", "spot:0,0,1:cutoff=100"),
                 ("--light", "point:0,0,0:attenuation=0,0,0"), ("--light", "ambient:-1,0,0"), ("--background", "purple"),
                 ("--background", "2,0,0"), ("--channels", "depth,smell"), ("--threads", "0"), ("--threads", "two"),
                 ("--threads", "1025"), ("--max-memory", "lots"), ("--max-memory", "99999999999T"), ("--quiet", "--verbose"),
                 ("--no-such-option",), ("-o",), ("-o", "b.png"))
        for arguments in wrong:
            with self.subTest(arguments=arguments):
                self.check_refused(self.run_program("render", "a.obj", "-o", "a.png", *arguments), 2)
        self.check_refused(self.run_program("rendr", "a.obj"), 2, "unknown command 'rendr'")
        self.check_refused(self.run_program("render", "-lead.glb", "-o", "a.png"), 2, "./-lead.glb")
        self.check_refused(self.run_program("render", "a.obj", "-o", "{name}.png"), 2, "{model}")
        for arguments in ((), ("paint",), ("render",), ("render", "a.obj"), ("render", "-o", "a.png"), ("inspect",), ("--what",)):
            with self.subTest(arguments=arguments):
                self.check_refused(self.run_program(*arguments), 2, "--help")
        self.check_refused(self.run_program("render", "a.obj", "-o", "a.gif"), 2, "a.gif")
        self.assertEqual(self.files(), ["a.obj"])

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

    def test_a_full_disk_is_named(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        self.write("a.obj")
        for ending in ("png", "exr", "hdr"):
            os.symlink("/dev/full", self.folder / f"full.{ending}")
            result = self.run_program("render", "a.obj", "-o", f"full.{ending}", "--background", "1,0,0")
            self.check_refused(result, 1, "No space left on device")

    def test_default_light_and_view_and_memory_in_fractions_are_understood(self):
        self.write("a.obj")
        plain = ("render", "a.obj", "-o", "a.png", "--resolution", "40,30")
        self.assertEqual(self.run_program(*plain).code, 0)
        before = (self.folder / "a.png").read_bytes()
        result = self.run_program(*plain, "--light", "default", "--view", "default", "--max-memory", "1.5G")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual((self.folder / "a.png").read_bytes(), before)

    def test_a_file_that_grows_too_large_is_an_error_not_a_signal(self):
        self.write("a.obj")
        done = subprocess.run([PROGRAM, "render", "a.obj", "-o", "a.exr"], cwd=self.folder, stderr=subprocess.PIPE, text=True, timeout=60,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("cannot be written", done.stderr)
        self.assertEqual(self.files(), ["a.obj"])

    def test_an_instruction_set_that_cannot_be_had_is_exit_2(self):
        self.write("a.obj")
        self.check_refused(self.run_program("render", "a.obj", "-o", "a.png", RAKELIGHT_ISA="mmx"), 2, "mmx")
        self.check_refused(self.run_program("--version", RAKELIGHT_ISA="mmx"), 2, "mmx")

    def test_missing_input_is_exit_3(self):
        (self.folder / "folder.obj").mkdir()
        for name in ("missing.obj", "folder.obj", "builtin:bunny"):
            with self.subTest(name=name):
                self.check_refused(self.run_program("render", name, "-o", "a.png"), 3, name)
                self.check_refused(self.run_program("inspect", name), 3, name)
        self.assertEqual(self.files(), ["folder.obj"])

    def test_broken_and_unsupported_files_are_exit_4_and_leave_nothing(self):
        self.write("broken.glb", "no glTF at all")
        self.write("empty.obj", "")
        self.write("only_points.obj", "v 0 0 0\n")
        self.write("a.max", "x")
        for name in ("broken.glb", "empty.obj", "only_points.obj", "a.max"):
            with self.subTest(name=name):
                self.check_refused(self.run_program("render", name, "-o", "a.png", "--channels", "depth"), 4, name)
        self.assertEqual(self.files(), ["a.max", "broken.glb", "empty.obj", "only_points.obj"])

    def test_an_output_that_cannot_be_written_is_exit_1(self):
        self.write("a.obj")
        (self.folder / "taken.png").mkdir()
        self.check_refused(self.run_program("render", "a.obj", "-o", "no/such/a.png"), 1, "no/such")
        self.check_refused(self.run_program("render", "a.obj", "-o", "taken.png"), 1, "taken.png")
        self.assertEqual(self.files(), ["a.obj", "taken.png"])

    def test_an_old_picture_stays_when_the_new_one_fails(self):
        self.write("a.png", "old")
        self.write("bad.obj", "v 0 0 0\nf 1 2 99\n")
        self.assertEqual(self.run_program("render", "bad.obj", "-o", "a.png").code, 4)
        self.assertEqual((self.folder / "a.png").read_text(), "old")

    def test_standard_output_that_is_full_is_exit_1(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        with open("/dev/full", "w") as full:
            done = subprocess.run([PROGRAM, "--help"], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn("standard output", done.stderr)

    def test_hostile_names_are_shown_in_one_printable_line(self):
        for name in ("line\nfeed.obj", "esc\033[31m.obj", "x" * 200 + ".obj", "bytes\udcff.obj", "--", "-"):
            with self.subTest(name=name):
                done = subprocess.run([PROGRAM, "render", "-o", "a.png", "--", os.fsencode(name)], cwd=self.folder, capture_output=True,
                                      timeout=60)
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertEqual(done.stderr.count(b"\n"), 1)
                self.assertTrue(all(c >= 32 or c == 10 for c in done.stderr), done.stderr)
                done.stderr.decode()  # valid UTF-8
        odd = self.folder / "odd\n\033name.obj"
        odd.write_text("v 0 0 0\nf 1 2 99\n")
        result = self.run_program("render", odd.name, "-o", "a.png", "--json")
        self.assertEqual(result.code, 4, result.err)
        self.assertTrue(all(line.startswith("rakelight: ") and "odd??name.obj: " in line for line in result.lines), result.err)
        self.assertEqual(json.loads(result.out)["rows"][0]["file"], odd.name)

    # --- warnings ---

    def test_remarks_are_one_warning_line_each_and_capped(self):
        materials = "".join(f"usemtl m{i}\nf 1 2 3 4\n" for i in range(60))
        self.write("many.obj", SQUARE.format(name="a") + "mtllib missing.mtl\n" + materials)
        result = self.run_program("render", "many.obj", "-o", "a.png", "--resolution", "16,12")
        self.assertEqual(result.code, 0, result.err)
        self.assertEqual(len(result.lines), 21)
        self.assertIn("more, see --json", result.lines[-1])
        for line in result.lines:
            self.assertTrue(line.startswith("rakelight: warning: many.obj: "), line)
        self.assertEqual(self.run_program("render", "many.obj", "-o", "a.png", "--resolution", "16,12", "--quiet").err, "")
        rows = json.loads(self.run_program("render", "many.obj", "-o", "a.png", "--resolution", "16,12", "--quiet", "--json").out)["rows"]
        self.assertTrue(any(r["remark"] != "note" for r in rows[0]["remarks"]))

    def test_a_camera_that_sees_nothing_is_warned_about(self):
        self.write("a.obj")
        result = self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "16,12", "--camera-position", "0,0,5",
                                  "--camera-focal-point", "0,0,9")
        self.assertEqual(result.code, 0)
        self.assertTrue(all(line.startswith("rakelight: warning: a.obj: ") for line in result.lines), result.err)
        self.assertTrue(result.lines)

    def run_on_terminal(self, *arguments, **environment):
        """What the program writes to standard error when that is a terminal."""
        master, terminal = pty.openpty()
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=terminal,
                                   env={**os.environ, "TERM": "xterm", **environment})
        os.close(terminal)
        text = b""
        while True:
            try:
                part = os.read(master, 4096)
            except OSError:
                break
            if not part:
                break
            text += part
        os.close(master)
        process.wait(60)
        return text

    def test_colors_are_for_terminals_and_no_color_is_heeded(self):
        self.assertIn(b"\033[", self.run_on_terminal("render", "missing.obj", "-o", "a.png", NO_COLOR=""))
        self.assertNotIn(b"\033", self.run_on_terminal("render", "missing.obj", "-o", "a.png", NO_COLOR="1"))
        self.assertNotIn(b"\033", self.run_on_terminal("render", "missing.obj", "-o", "a.png", TERM="dumb"))

    def test_an_interrupted_run_leaves_nothing_behind(self):
        size = 400  # a grid big enough to be interrupted in most runs; the claim holds whenever the signal comes
        rows = [f"v {x} {y} {(x * y) % 7}" for y in range(size) for x in range(size)]
        rows += [f"f {y * size + x + 1} {y * size + x + 2} {(y + 1) * size + x + 2} {(y + 1) * size + x + 1}"
                 for y in range(size - 1) for x in range(size - 1)]
        self.write("grid.obj", "\n".join(rows) + "\n")
        for delay in (0.02, 0.3, 0.6):
            process = subprocess.Popen([PROGRAM, "render", "grid.obj", "-o", "a.png", "--resolution", "8000,6000"], cwd=self.folder,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            time.sleep(delay)
            process.send_signal(signal.SIGTERM)
            error = process.communicate(timeout=120)[1]
            self.assertIn(process.returncode, (0, -signal.SIGTERM), error)
            self.assertIn(self.files(), (["grid.obj"], ["a.png", "grid.obj"]))
            self.assertEqual(process.returncode == 0, "a.png" in self.files())
            (self.folder / "a.png").unlink(missing_ok=True)

    def test_an_interruption_ends_the_whole_run_not_only_one_file(self):
        names = [f"{i}.obj" for i in range(60)]
        for name in names:
            self.write(name)
        process = subprocess.Popen([PROGRAM, "render", *names, "-o", "{model}.png", "--resolution", "2400,1800", "--json"],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        while not (self.folder / "0.png").exists() and process.poll() is None:
            time.sleep(0.005)
        process.send_signal(signal.SIGINT)
        out = process.communicate(timeout=120)[0]
        self.assertEqual(process.returncode, -signal.SIGINT)
        rows = json.loads(out)["rows"]
        self.assertEqual([row["file"] for row in rows], names)
        self.assertEqual(rows[-1]["error"]["message"], "cancelled")
        left = [name for name in self.files() if not name.endswith(".obj")]
        self.assertLess(len(left), 60)
        self.assertTrue(all(name.endswith(".png") for name in left), left)  # no temporary file

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
            self.assertEqual(self.run_program(*arguments).out, "")
            self.assertGreaterEqual(stats["overdraw"], 1)
        self.assertEqual(where, {"unlit": 0, "flat": 4, "gouraud": 8, "phong": stats["pixels_covered"]})

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
        self.assertEqual(row["shared_positions"], 2)
        self.assertGreater(row["borders"][0]["largest_deg"], 10)
        over_model = json.loads(self.run_program("inspect", "a.obj", "--json", "--normals", "model", "--crease-angle", "180").out)
        self.assertLess(over_model["rows"][0]["borders"][0]["largest_deg"], 0.01)

    def test_inspect_goes_on_after_a_failing_file(self):
        self.write("a.obj")
        result = self.run_program("inspect", "missing.obj", "a.obj", "--json")
        self.assertEqual(result.code, 3)
        rows = json.loads(result.out)["rows"]
        self.assertEqual(rows[0]["error"]["code"], "not_found")
        self.assertEqual(rows[1]["triangles"], 2)

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
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
