#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The words of a command line: models without a verb, folders, templates, pipes, synonyms, switches, colors, --config, --watch, the manual.

  command_line_test.py PROGRAM [unittest arguments]"""
import json
import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import png

SIZE = ("--resolution", "24,16", "--look", "plain")
ROOT = pathlib.Path(__file__).resolve().parents[3]
HEADLESS = {"DISPLAY": "", "WAYLAND_DISPLAY": ""}


def square(x):
    """A square of its own color of place: x to x + 1."""
    return f"o square\nv {x} 0 0\nv {x + 1} 0 0\nv {x + 1} 1 0\nv {x} 1 0\nf 1 2 3 4\n"


def small_glb():
    """A triangle in a GLB."""
    data = struct.pack("<9f3Hxx", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 2)
    text = json.dumps({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "scene": 0, "nodes": [{"mesh": 0}],
                       "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
                       "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                                     {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
                       "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
                       "buffers": [{"byteLength": 44}]}).encode()
    text += b" " * (-len(text) % 4)
    return struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(data)) + struct.pack("<II", len(text), 0x4E4F534A) + text + \
        struct.pack("<II", len(data), 0x004E4942) + data


class CommandLine(program.Case):
    def pictures(self):
        """All pictures below the folder, by their names from there."""
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*.png"))

    def fine(self, *arguments, **environment):
        result = self.run_program(*arguments, **environment)
        self.assertEqual(result.code, 0, (arguments, result.err))
        return result

    def piped(self, *arguments, given=b""):
        """(exit code, bytes on standard output, standard error) with bytes on standard input."""
        done = subprocess.run([program.PROGRAM, *map(str, arguments)], cwd=self.folder, input=given, capture_output=True, timeout=300)
        return done.returncode, done.stdout, done.stderr.decode()

    def corner(self, name="a.png"):
        return tuple(png(self.folder / name)[3][0][:3])

    # --- without a verb ---

    def test_a_model_and_an_output_are_a_picture(self):
        self.write("a.obj")
        self.fine("a.obj", "-o", "a.png", *SIZE, **HEADLESS)
        self.fine("--up", "+Z", "a.obj", *SIZE, "--output=b.png", **HEADLESS)
        self.fine("builtin:sphere", "-oc.png", *SIZE, **HEADLESS)
        self.assertEqual(self.pictures(), ["a.png", "b.png", "c.png"])
        before = (self.folder / "a.png").read_bytes()
        self.fine("render", "a.obj", "-o", "a.png", *SIZE)
        self.assertEqual((self.folder / "a.png").read_bytes(), before)

    def test_without_an_output_and_a_display_it_says_how_to_render(self):
        self.write("a.obj")
        self.write("plain")  # a word is a model when it exists
        for model in ("a.obj", "builtin:teapot", "gone.glb", "plain"):
            self.check_refused(self.run_program(model, **HEADLESS), 2, "no display", f"rakelight {model} -o ", ".png")
        self.check_refused(self.run_program("gone.glb", "-o", "a.png", **HEADLESS), 3, "gone.glb")
        self.check_refused(self.run_program("a.obj", "--sampels", "4", **HEADLESS), 2, "unknown option '--sampels'", "did you mean --samples?")
        self.check_refused(self.run_program("a.obj", "--fov", "4", **HEADLESS), 2, "--fov: unknown", "--camera-view-angle")

    def test_with_a_display_the_viewer_gets_the_words(self):
        self.write("a.obj")
        (self.folder / "models").mkdir()
        self.write("models/b.obj")
        viewer = self.write("rakelight-view", "#!/bin/sh\nprintf '%s\\n' \"$@\"\n")
        viewer.chmod(0o755)
        copy = self.folder / "rakelight"  # so that the viewer beside it is ours
        shutil.copyfile(program.PROGRAM, copy)
        copy.chmod(0o755)
        for words, expected in ((["a.obj", "--samples", "4"], ["a.obj", "--samples", "4"]), (["view", "models", "-q"], ["models/b.obj", "-q"]),
                                (["models"], ["models/b.obj"]), ([self.folder.as_uri() + "/a%2Eobj"], [str(self.folder / "a.obj")]),
                                (["view", self.folder.as_uri() + "/models"], [str(self.folder / "models/b.obj")])):
            done = subprocess.run([copy, *words], cwd=self.folder, capture_output=True, text=True, timeout=60, env={**os.environ, "DISPLAY": ":9"})
            self.assertEqual((done.returncode, done.stdout.split("\n")[:-1]), (0, expected), done.stderr)

    def test_any_other_word_is_a_misspelt_verb(self):
        self.check_refused(self.run_program("rendr", "a.obj"), 2, "'rendr'", "did you mean render?")
        self.check_refused(self.run_program("diff", "a.png", "b.png"), 2, "see rakelight compare --help")
        self.check_refused(self.run_program("elephant.txt"), 2, "unknown command 'elephant.txt', and there is no such file")
        self.check_refused(self.run_program("elephant"), 2, "unknown command 'elephant'; use render")

    # --- folders, templates ---

    def make_models(self):
        for name in ("models/b.obj", "models/a.obj", "models/sub/a.obj", "models/.hidden.obj", "models/notes.txt"):
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            self.write(name)

    def test_a_folder_stands_for_the_models_in_it(self):
        self.make_models()
        result = self.fine("render", "models", "-o", "deep/out/{model}.png", *SIZE, "--json")
        self.assertEqual([row["file"] for row in json.loads(result.out)["rows"]], ["models/a.obj", "models/b.obj"])
        self.assertEqual(self.pictures(), ["deep/out/a.png", "deep/out/b.png"])
        rows = lambda *words: [row["file"] for row in json.loads(self.fine(*words, "--json").out)["rows"]]
        self.assertEqual(rows("inspect", "models", "--recursive"), ["models/a.obj", "models/b.obj", "models/sub/a.obj"])
        self.assertEqual(rows("check", "models/"), ["models/a.obj", "models/b.obj"])
        self.assertEqual(rows("smooth", "models", "-o", "smooth/"), ["models/a.obj", "models/b.obj"])
        self.assertTrue((self.folder / "smooth/b.obj").exists())
        self.fine("stages", "models", "-o", "stages/{model}", *SIZE)
        self.assertTrue((self.folder / "stages/a/index.html").exists())

    def test_a_folder_as_output_gets_a_picture_of_each(self):
        self.make_models()
        self.fine("models", "-o", "out/", *SIZE)
        self.assertEqual(self.pictures(), ["out/a.png", "out/b.png"])
        self.fine("models", "--recursive", "-o", "out", *SIZE, "--format", "jpg")
        self.assertEqual(sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*.jpg")), ["out/a.jpg", "out/b.jpg", "out/sub/a.jpg"])

    def test_templates_are_filled_in(self):
        self.make_models()
        self.fine("models", "--recursive", "-o", "{dir}/{n:3}-{model}.{ext}-{camera}{{x}}.png", "--view", "front", *SIZE)
        self.assertEqual(self.pictures(), ["001-a.obj-front{x}.png", "002-b.obj-front{x}.png", "sub/003-a.obj-front{x}.png"])
        self.check_refused(self.run_program("models/sub/a.obj", "-o", "{frame:2}.png", *SIZE), 2, "{frame}", "--turntable")
        self.fine("models/sub/a.obj", "-o", "{dir}/named.png", *SIZE)
        self.assertIn("models/sub/named.png", self.pictures())

    def test_names_of_files_and_cameras_lead_to_no_other_folder(self):
        (self.folder / "in").mkdir()
        for name, made in (("...obj", "__"), ("..obj", "_"), ("....obj", "___"), ("a..obj", "a.")):
            with self.subTest(name=name):
                self.write(f"in/{name}")
                self.fine("render", f"in/{name}", "-o", "out/{model}/x.png", *SIZE)
                self.fine("render", f"in/{name}", "-o", "out/{model}.png", *SIZE)
                self.assertEqual(self.pictures(), sorted([f"out/{made}/x.png", f"out/{made}.png"]))
                shutil.rmtree(self.folder / "out")
                (self.folder / "in" / name).unlink()
        self.write("a.obj")
        for camera, made in (("..", "__"), (".", "_"), ("../../up", "..-..-up"), ("/x", "-x"), ("a/../b", "a-..-b")):
            with self.subTest(camera=camera):
                self.write("w.scene.toml", f'[[model]]\nfile = "a.obj"\n[[camera]]\nname = "{camera}"\nposition = [0, 0, 5]\ntarget = [0, 0, 0]\n'
                           f'[render]\ncamera-index = "{camera}"\n')
                self.fine("render", "w.scene.toml", "-o", "out/{camera}/x.png", *SIZE)
                self.assertEqual(self.pictures(), [f"out/{made}/x.png"])
                shutil.rmtree(self.folder / "out")

    def test_names_that_clash_and_empty_folders_are_refused_before_any_work(self):
        self.make_models()
        self.write("models/a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n")
        self.check_refused(self.run_program("models", "-o", "out/", *SIZE), 2, "'models/a.obj' and 'models/a.stl'", "out/a.png", "{ext}")
        self.check_refused(self.run_program("models", "-o", "a.png", *SIZE), 2, "several models", "-o out/")
        self.check_refused(self.run_program("models/a.obj", "models/a.stl", "-o", "out/", *SIZE), 2, "as in -o 'out/{model}-{ext}.png'")
        for models in (("models",), ("models/a.obj",)):
            self.check_refused(self.run_program(*models, "-o", "pics", *SIZE), 2, "'pics' has no ending", "-o pics.png", "for a folder -o pics/")
        self.check_refused(self.run_program("models", "-o", "{nam}.png", *SIZE), 2, "{nam}", "{model}")
        self.check_refused(self.run_program("models", "-o", "{model:3}.png", *SIZE), 2, "{model:3}")
        (self.folder / "empty/deeper").mkdir(parents=True)
        self.check_refused(self.run_program("empty", "-o", "out/", *SIZE), 3, "empty", "no model", "--recursive")
        self.assertFalse((self.folder / "out").exists())

    def test_folders_are_made_and_go_again_where_nothing_is_written(self):
        self.write("a.obj")
        self.write("broken.obj", "v 0 0 0\n")
        self.fine("a.obj", "-o", "new/deeper/a.png", *SIZE)
        self.assertEqual(self.pictures(), ["new/deeper/a.png"])
        self.assertEqual(self.run_program("broken.obj", "-o", "other/b.png", *SIZE).code, 4)
        self.assertEqual(self.run_program("gone.obj", "-o", "third/b.png", *SIZE).code, 3)
        self.check_refused(self.run_program("a.obj", "-o", "a.obj/b.png", *SIZE), 1, "is not a folder")
        self.assertEqual(self.files(), ["a.obj", "broken.obj", "new"])

    # --- pipes, one scene ---

    def test_pictures_go_to_a_pipe_whole_or_not_at_all(self):
        self.write("a.obj")
        self.fine("render", "a.obj", "-o", "a.png", *SIZE)
        code, out, err = self.piped("a.obj", "-o", "-", *SIZE)
        self.assertEqual((code, err), (0, ""))
        self.assertEqual(out, (self.folder / "a.png").read_bytes())
        code, out, err = self.piped("a.obj", "-o", "-", "--format", "PPM", *SIZE)
        self.assertEqual((code, err, out[:13], len(out)), (0, "", b"P6\n24 16\n255\n", 13 + 24 * 16 * 3))
        width, _, _, rows = png(self.folder / "a.png")
        self.assertEqual(out[13:], b"".join(bytes(row) for row in rows))
        self.fine("render", "a.obj", "-o", "a.ppm", *SIZE)
        self.assertEqual((self.folder / "a.ppm").read_bytes(), out)
        self.assertEqual(self.piped("a.obj", "-o", "ppm:-", *SIZE)[1], out)
        self.assertEqual(self.piped("gone.obj", "-o", "-", *SIZE)[:2], (3, b""))
        self.write("b.obj")
        for words in (("--json",), ("--channels", "depth"), ("b.obj",), ("--watch",), ("--format", "ppm,png"), ("--format", "gif"),
                      ("--format", "ppm", "--background", "transparent")):
            code, out, err = self.piped("a.obj", "-o", "-", *SIZE, *words)
            self.assertEqual((code, out, err.count("\n")), (2, b"", 1), (words, err))

    def test_a_model_comes_from_standard_input(self):
        glb = small_glb()
        (self.folder / "a.glb").write_bytes(glb)
        self.fine("render", "a.glb", "-o", "a.png", *SIZE)
        expected = (self.folder / "a.png").read_bytes()
        code, out, err = self.piped("-", "-o", "-", "--format", "glb,png", *SIZE, given=glb)
        self.assertEqual((code, out, err), (0, expected, ""))
        self.assertEqual(self.piped("-", "-o", "-", *SIZE, given=glb), (0, expected, ""))  # by its content
        obj = program.SQUARE.format(name="piped").encode()
        self.assertEqual(self.piped("render", "-", "-o", "{model}.png", "--format", "obj", *SIZE, given=obj)[0], 0)
        self.assertIn("stdin.png", self.pictures())
        for words in (("inspect", "-"), ("check", "-"), ("explain", "-", "--pixel", "12,8", *SIZE)):
            code, out, err = self.piped(*words, "--format", "obj", given=obj)
            self.assertEqual((code, err), (0, ""))
            self.assertTrue(out)
        code, out, err = self.piped("-", "-o", "-", "--format", "glb", *SIZE, given=b"no model")
        self.assertEqual((code, out), (4, b""))
        self.assertIn("standard input.glb: ", err)
        self.assertEqual(self.piped("-", "-o", "-", *SIZE, given=b"")[0], 4)

    def test_several_files_are_one_scene(self):
        self.write("left.obj", square(0))
        self.write("right.obj", square(1))
        self.write("both.obj", square(0) + "o right\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 5 6 7 8\n")
        result = self.fine("render", "left.obj", "right.obj", "--as-one", "-o", "a.png", *SIZE, "--json")
        rows = json.loads(result.out)["rows"]
        self.assertEqual([(row["objects"], row["triangles"]) for row in rows], [(2, 4)])
        self.fine("render", "both.obj", "-o", "b.png", *SIZE)
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())
        row = json.loads(self.fine("inspect", "left.obj", "right.obj", "--as-one", "--json").out)["rows"][0]
        self.assertEqual(row["file"], "left.obj + right.obj")
        many = self.fine("inspect", "left.obj", "right.obj", "left.obj", "right.obj", "--as-one").out
        self.assertTrue(many.startswith("left.obj + 3 more files\n"), many)
        (self.folder / "private").mkdir()
        self.write("private/left.obj", square(0))
        self.fine("inspect", "private/left.obj", "right.obj", "--as-one", "--report", "r.html", "--resolution", "64,48")
        page = (self.folder / "r.html").read_text()
        self.assertIn("<h2>left.obj + right.obj</h2>", page)
        self.assertNotIn("private", page)
        self.assertEqual((len(row["objects"]), row["shared_positions"]), (2, 2))
        self.check_refused(self.run_program("left.obj", "gone.obj", "--as-one", "-o", "c.png", *SIZE), 3, "gone.obj")

    # --- words ---

    def test_words_of_other_programs_are_answered_by_ours(self):
        self.write("a.obj")
        for theirs, ours in (("--fov", "--camera-view-angle"), ("--size", "--resolution"), ("--anti-aliasing", "--samples"),
                             ("--no-background", "--background"), ("--zoom=2", "--camera-zoom-factor")):
            result = self.run_program("render", "a.obj", "-o", "a.png", theirs, "30")
            self.check_refused(result, 2, f"{theirs.split('=')[0]}: unknown; see {ours}\n")
        for theirs in ("--threshold", "--metric"):
            self.check_refused(self.run_program("compare", "a.png", "b.png", theirs, "3"), 2, f"{theirs}: unknown; see --max-flip, --max-rmse, --min-psnr, --min-ssim\n")
        self.check_refused(self.run_program("a.obj", "-o", "a.png", "--threshold", "3"), 2, "--threshold: unknown; see --ref-threshold\n")
        self.assertEqual(self.files(), ["a.obj"])

    def test_names_of_f3d_are_synonyms_in_our_own_help(self):
        self.write("a.obj")
        self.fine("render", "a.obj", "-o", "a.png", *SIZE, "--background-color", "0,0.5,1")
        self.assertEqual(self.corner(), (0, 128, 255))
        text = self.fine("render", "--help").out
        for name in ("--background-color", "--up", "--camera-direction", "--camera-azimuth-angle", "--camera-elevation-angle",
                     "--camera-zoom-factor", "--hdri-file", "--watch", "--config", "--recursive", "--as-one", "--format"):
            self.assertIn(name, text)

    def test_switches_take_all_words_for_on_and_off(self):
        self.write("a.obj")
        def picture(*words):
            self.fine("render", "a.obj", "-o", "a.png", *SIZE, *words)
            return (self.folder / "a.png").read_bytes()
        off, on = picture(), picture("--edges")
        self.assertNotEqual(off, on)
        for word in ("on", "ON", "true", "1"):
            self.assertEqual(picture("--edges", word), on)
            self.assertEqual(picture("--edges=" + word), on)
        for word in ("off", "Off", "false", "0"):
            self.assertEqual(picture("--edges", word), off)
            self.assertEqual(picture("--shadows=" + word), off)
        self.assertEqual(json.loads(self.fine("check", "a.obj", "--json=on").out)["schema"], "rakelight.check/1")
        self.assertIn("1 object", self.fine("check", "--json", "off", "a.obj").out)
        self.check_refused(self.run_program("check", "a.obj", "--json=maybe"), 2, "--json: must be on or off, not 'maybe'")

    def test_colors_have_names_and_case_means_nothing(self):
        self.write("a.obj")
        for text, expected in (("white", (255, 255, 255)), ("RebeccaPurple", (0x66, 0x33, 0x99)), ("#F00", (255, 0, 0)), ("#00ff7F", (0, 255, 127)),
                               ("gray", (128, 128, 128)), ("f80", (255, 136, 0))):
            self.fine("render", "a.obj", "-o", "a.png", *SIZE, "--background", text)
            self.assertEqual(self.corner(), expected)
        self.check_refused(self.run_program("render", "a.obj", "-o", "a.png", "--background", "whit"), 2, "--background", "did you mean white?")
        def picture(*words):
            self.fine("render", "a.obj", "-o", "a.png", *SIZE, *words)
            return (self.folder / "a.png").read_bytes()
        self.assertEqual(picture("--light", "ambient:red"), picture("--light", "AMBIENT:1,0,0"))
        self.assertEqual(picture("--material", "color=red"), picture("--material", "color=#ff0000"))
        self.assertEqual(picture("--line-color", "red", "--edges"), picture("--line-color", "#f00", "--edges"))
        self.assertEqual(picture("--shading", "FLAT", "--view", "Front", "--up", "+z", "--normals", "Model", "--engine", "Soft"),
                         picture("--shading", "flat", "--view", "front", "--up", "+Z", "--normals", "model", "--engine", "soft"))

    # --- settings from a file ---

    def test_settings_come_from_a_configuration(self):
        self.write("a.obj")
        (self.folder / "looks").mkdir()
        self.write("looks/look.toml", "[render]\nbackground = '#ff0000'\nresolution = [10, 8]\nedges = true\n")
        self.fine("render", "a.obj", "-o", "a.png", "--look", "plain", "--config", "looks/look.toml")
        self.assertEqual((png(self.folder / "a.png")[:2], self.corner()), ((10, 8), (255, 0, 0)))
        self.fine("render", "a.obj", "-o", "a.png", "--look", "plain", "--config", "looks/look.toml", "--background", "blue", "--edges=off")
        self.assertEqual((png(self.folder / "a.png")[:2], self.corner()), ((10, 8), (0, 0, 255)))
        self.fine("inspect", "a.obj", "--config", "looks/look.toml")
        for text, place, word in (("[render]\nsamples = 3\n", "line 2, column 1", "samples"), ("[render]\nsample = 4\n", "line 2", "did you mean 'samples'?"),
                                  ("[render]\nthreads = 4\n", "line 2", "of the command line only"), ("[render\n", "line 1", ""),
                                  ("[[model]]\nfile = 'a.obj'\n", "", "only [render]")):
            self.write("bad.toml", text)
            self.check_refused(self.run_program("render", "a.obj", "-o", "b.png", "--config", "bad.toml"), 4, "bad.toml", place, word)
        self.check_refused(self.run_program("render", "a.obj", "-o", "b.png", "--config", "gone.toml"), 3, "gone.toml")

    def test_a_watched_model_is_drawn_again(self):
        self.write("a.obj", square(0))
        running = subprocess.Popen([program.PROGRAM, "a.obj", "-o", "out/{frame}.png", *SIZE, "--watch"], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        try:
            self.wait_for("out/1.png")
            self.assertEqual(running.stderr.readline(), "rakelight: watching 1 file: pictures are drawn again when one changes, until Ctrl+C\n")
            self.write("a.obj", "v nothing\n")  # an error does not end it
            os.utime(self.folder / "a.obj", (1, 1))
            self.assertEqual(running.stderr.readline(), "rakelight: a.obj has changed: drawing again\n")
            while not running.stderr.readline().startswith("rakelight: error: a.obj"):
                self.assertIsNone(running.poll())
            self.write("a.obj", square(0) + "v 3 3 3\nv 4 4 4\nv 3 4 4\nf 5 6 7\n")
            self.wait_for("out/3.png")
        finally:
            running.send_signal(signal.SIGTERM)
            running.communicate(timeout=60)
        self.assertEqual(running.returncode, -signal.SIGTERM)
        self.assertNotEqual((self.folder / "out/1.png").read_bytes(), (self.folder / "out/3.png").read_bytes())
        self.assertEqual(self.pictures(), ["out/1.png", "out/3.png"])

    def test_standard_input_cannot_be_watched(self):
        self.check_refused(self.run_program("-", "-o", "a.png", *SIZE, "--watch"), 2, "--watch: standard input (-) cannot be watched", "name a file")

    # --- one vocabulary ---

    def test_every_verb_has_the_same_letters_and_names(self):
        self.write("a.obj", program.TWO_PARTS)
        self.write("a.png", "")
        self.fine("render", "a.obj", "-o", "a.png", *SIZE)
        verbs = {"render": ("a.obj", "-o", "b.png", *SIZE), "inspect": ("a.obj",), "smooth": ("a.obj", "-o", "b.obj"), "convert": ("a.obj", "-o", "b.glb"), "check": ("a.obj",),
                 "explain": ("a.obj", "--pixel", "3,3", *SIZE), "stages": ("a.obj", "-o", "stages", *SIZE), "compare": ("a.png", "a.png"),
                 "join-windows": ("a.png", "-o", "c.png"), "bake": ("a.obj", "a.obj", "-o", "d.png", "--size", "32"),
                 "bench": ("smooth", "--triangles", "200", "--repetitions", "1")}
        for verb, words in verbs.items():
            for letters in (("-q", "-j", "1"), ("-v", "-j2")):
                self.fine(verb, *words, *letters)
        self.assertIn("-q", self.fine("view", "--help").out)
        for verb in ("render", "inspect", "smooth", "bench"):
            text = self.fine(verb, "--help").out
            self.assertIn("--weld-distance", text, verb)
            self.assertIn("--crease-angle", text, verb)

    def test_positions_within_the_weld_distance_are_one_in_pictures_too(self):
        gap = "o left\nv -1 0 0\nv 0 0 0\nv 0 1 0\nv -1 1 0\nf 1 2 3 4\no right\nv 0.001 0 0\nv 1 0 0.5\nv 1 1 0.5\nv 0.001 1 0\nf 5 6 7 8\n"
        self.write("a.obj", gap)
        def picture(*words):
            self.fine("render", "a.obj", "-o", "a.png", *SIZE, "--normals", "model", "--crease-angle", "60", *words)
            return (self.folder / "a.png").read_bytes()
        self.assertNotEqual(picture("--weld-distance", "0.01"), picture())
        self.assertEqual(picture("--weld-distance", "0.0001"), picture())
        seam = lambda *words: json.loads(self.fine("inspect", "a.obj", "--json", *words).out)["rows"][0]["shared_positions"]
        self.assertEqual((seam(), seam("--weld-distance", "0.01")), (0, 2))
        self.check_refused(self.run_program("render", "a.obj", "-o", "a.png", "--weld-distance", "-1"), 2, "--weld-distance", "0 or more")

    def test_bench_takes_all_of_renders_picture_options(self):
        self.write("a.obj")
        self.fine("bench", "render", "a.obj", "--frames", "1", "--resolution", "24,16", "--window", "2,2,8,8", "--channels", "depth", "--channel-files",
                  "png", "-o", "b.png")
        self.assertEqual(self.pictures(), ["b.depth.png", "b.png"])
        self.assertEqual(png(self.folder / "b.png")[:2], (8, 8))
        tables = self.fine("bench", "--help").out, self.fine("render", "--help").out
        self.assertTrue(tables[0].rstrip().endswith("broken or too large."), tables[0][-200:])
        self.assertNotIn("Lights:", tables[0])

    # --- messages ---

    def test_messages_name_paths_as_they_were_written_and_the_option_that_helps(self):
        (self.folder / "model").mkdir()
        (self.folder / "wood.png").write_bytes(b"")
        self.write("model/a.obj", "mtllib a.mtl\nusemtl a\n" + square(0))
        self.write("model/a.mtl", "newmtl a\nmap_Kd ../wood.png\n")
        result = self.fine("check", "./model/../model/a.obj")
        self.assertIn("texture '../wood.png' lies outside the model's folder; it is left out (--allow-outside permits it)", result.err)
        self.assertIn("./model/../model/a.", result.err)
        self.write("model/a.mtl", "newmtl a\nmap_Kd C:\\\\work\\\\wood.png\n")
        self.assertIn("wood.png' is not in the model's folder", self.fine("check", "model/a.obj").err)
        shutil.copyfile(ROOT / "data/maps/brick_height.png", self.folder / "model/wood.png")
        self.assertIn("1 texture", self.fine("check", "model/a.obj").out)
        triangle = {"asset": {"version": "2.0"}, "images": [{"uri": "C:\\work\\wood.png"}], "textures": [{"source": 0}], "scenes": [{"nodes": [0]}],
                    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
                    "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "../a.bin"}]}
        self.write("model/a.gltf", json.dumps(triangle))
        self.check_refused(self.run_program("check", "model/a.gltf"), 4, "model/a.gltf", "'../a.bin' leaves the model's folder", "--allow-outside")
        triangle["buffers"][0]["uri"] = "C:\\work\\a.bin"
        self.write("model/a.gltf", json.dumps(triangle))
        self.check_refused(self.run_program("check", "model/a.gltf"), 4, "'C:\\work\\a.bin' is a path on another machine", "put 'a.bin' beside the model")
        for words in (("check", "C:\\models\\a.glb"), ("C:\\models\\a.glb", "-o", "a.png"), ("render", "a/b.obj", "C:/models/a.glb", "-o", "{n}.png")):
            result = self.run_program(*words)
            self.assertEqual(result.code, 3)
            self.assertRegex(result.err, r"C:.models.a\.glb: is a path on another machine; give the path of 'a\.glb' on this one\n")

    # --- the manual ---

    def test_every_verb_takes_addresses_of_files(self):
        (self.folder / "a b").mkdir()
        self.write("a b/s%.obj", square(0))
        self.write("a b/s.scene.toml", '[[model]]\nfile = "s%.obj"\n')
        folder = (self.folder / "a b").as_uri()
        model, world = folder + "/s%25.obj", folder + "/s.scene.toml"
        self.assertIn("%20", folder)
        self.fine("render", model, "-o", "address.png", *SIZE)
        self.fine("render", "a b/s%.obj", "-o", "path.png", *SIZE)
        self.assertEqual((self.folder / "address.png").read_bytes(), (self.folder / "path.png").read_bytes())
        self.fine(model, "-o", "verbless.png", *SIZE)
        self.fine("render", model, "-o", "{model}.png", *SIZE)
        self.assertIn("s%.png", self.pictures())
        self.fine("render", folder, "-o", "pictures/", *SIZE)
        self.fine(folder, "-o", "more/", *SIZE)
        self.assertIn("more/s%.png", self.pictures())
        self.fine("render", model, "-o", self.folder.as_uri() + "/c%20d.png", *SIZE)
        self.assertIn("c d.png", self.pictures())
        self.assertEqual(json.loads(self.fine("inspect", model, "--json").out)["rows"][0]["file"], str(self.folder / "a b/s%.obj"))
        for words in (("smooth", model, "-o", "smooth.obj"), ("explain", model, "--pixel", "3,3"), ("check", model, world), ("stages", model, "-o", "pages"),
                      ("compare", self.folder.as_uri() + "/address.png", "path.png"), ("bench", "render", model, "--frames", "1", "--resolution", "8,8")):
            self.fine(*words)
        for words in (("render", "http://host/a.obj", "-o", "b.png"), ("inspect", "file://elsewhere/a.obj"), ("smooth", "smb://host/a.obj", "-o", "a.obj"),
                      ("render", model, "-o", "https://host/b.png")):
            self.check_refused(self.run_program(*words), 2, "is no file of this machine; give a path, or file:///PATH")
        self.assertFalse(any(name.startswith(("file:", "http")) for name in self.files()))

    def test_a_wrong_positional_is_named_without_dashes(self):
        self.write("a.obj")
        self.check_refused(self.run_program("thumbnail", "a.obj", "a.png", "0"), 2, "error: SIZE: '0' is not")
        self.check_refused(self.run_program("bench", "everything"), 2, "error: WHAT: unknown word 'everything'", "smooth, render, pose")

    def test_help_shows_ten_tasks(self):
        text = self.fine("--help").out
        for words in ("rakelight helmet.glb -o helmet.png", "models/ -o", "--as-one", "--up +Z", "-o -", "--background white", "cloud.ply", "smooth knight.glb",
                      "--check --max-seam", "rakelight compare", "rakelight explain"):
            self.assertIn(words, text.partition("Examples:")[2])
        for verb in ("render", "inspect", "smooth", "convert", "bench", "explain", "stages", "compare", "check", "join-windows", "bake", "radiosity", "view"):
            self.assertIn(f"  {verb} ", text)

    def test_the_documentation_is_what_the_program_says(self):
        text = self.fine("--markdown").out
        self.assertEqual((ROOT / "docs/command-line.md").read_text(), text, "write it anew: rakelight --markdown > docs/command-line.md")
        for verb in ("render", "bench"):
            self.assertIn(f"\n## {verb}\n", text)

    def test_there_is_a_man_page(self):
        page = self.fine("--man").out
        self.assertTrue(page.startswith(".TH RAKELIGHT 1"))
        self.assertIn("\\-\\-background", page)
        if shutil.which("groff"):
            done = subprocess.run(["groff", "-man", "-ww", "-Tutf8", "-K", "utf8"], input=page, capture_output=True, text=True, timeout=60)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            text = re.sub(".\b", "", done.stdout).replace("\N{HYPHEN}", "-").replace("\N{MINUS SIGN}", "-")
            self.assertTrue("--camera-azimuth-angle DEG" in text, text[:1000])


if __name__ == "__main__":
    program.main()
