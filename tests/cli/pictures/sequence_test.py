#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sequences: clips and turntables as numbered pictures and as movies (docs/sequences.md). What needs ffmpeg is skipped where that is not installed.

  sequence_test.py PROGRAM [unittest arguments]"""
import fcntl
import json
import os
import pathlib
import shutil
import signal
import socket
import struct
import subprocess
import sys
import time
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import models
import program

SIZE = ("--resolution", "64,48")
HAS_FFMPEG = bool(shutil.which("ffmpeg") and shutil.which("ffprobe"))


def write_clip(path, seconds=1.0):
    """A triangle that slides to the right and turns upside down on its way."""
    points = struct.pack("<9f", -0.4, -0.4, 0, 0.4, -0.4, 0, 0, 0.4, 0)
    times, places, turns = struct.pack("<2f", 0, seconds), struct.pack("<6f", 0, 0, 0, 1, 0, 0), struct.pack("<8f", 0, 0, 0, 1, 0, 0, 1, 0)
    binary, views = b"", []
    for part in (points, times, places, turns):
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(part)})
        binary += part
    accessors = [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-0.4, -0.4, 0], "max": [0.4, 0.4, 0]},
                 {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [seconds]},
                 {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}, {"bufferView": 3, "componentType": 5126, "count": 2, "type": "VEC4"}]
    animation = {"name": "slide", "samplers": [{"input": 1, "output": 2}, {"input": 1, "output": 3}],
                 "channels": [{"sampler": i, "target": {"node": 0, "path": p}} for i, p in enumerate(("translation", "rotation"))]}
    models.write_glb(path, {**models.triangle_gltf([{"mesh": 0}]), "accessors": accessors, "bufferViews": views, "animations": [animation]}, binary)


def write_shine(path):
    """A triangle, turned a little to the light, whose roughness and color change within a second."""
    points = struct.pack("<9f", -0.4, -0.4, 0, 0.4, -0.4, 0, 0, 0.4, 0.05)
    times, rough, colors = struct.pack("<2f", 0, 1), struct.pack("<2f", 0.9, 0.2), struct.pack("<8f", 0.2, 0.4, 0.8, 1, 0.8, 0.2, 0.1, 1)
    binary, views = b"", []
    for part in (points, times, rough, colors):
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(part)})
        binary += part
    accessors = [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-0.4, -0.4, 0], "max": [0.4, 0.4, 0.05]},
                 {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
                 {"bufferView": 2, "componentType": 5126, "count": 2, "type": "SCALAR"}, {"bufferView": 3, "componentType": 5126, "count": 2, "type": "VEC4"}]
    target = lambda name: {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": "/materials/0/pbrMetallicRoughness/" + name}}}  # noqa: E731
    animation = {"samplers": [{"input": 1, "output": 2}, {"input": 1, "output": 3}],
                 "channels": [{"sampler": 0, "target": target("roughnessFactor")}, {"sampler": 1, "target": target("baseColorFactor")}]}
    tree = models.triangle_gltf([{"mesh": 0}])
    tree["meshes"][0]["primitives"][0]["material"] = 0
    models.write_glb(path, {**tree, "accessors": accessors, "bufferViews": views, "animations": [animation], "extensionsUsed": ["KHR_animation_pointer"],
                            "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.2, 0.4, 0.8, 1], "metallicFactor": 0, "roughnessFactor": 0.9}}]}, binary)


def chunks(path):
    """[(kind, data)] of a PNG or APNG file, with checked sums."""
    data, at, found = pathlib.Path(path).read_bytes(), 8, []
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        assert struct.unpack(">I", data[at + 8 + size:at + 12 + size])[0] == zlib.crc32(kind + body)
        found.append((kind, body))
        at += 12 + size
    return found


class Case(program.Case):
    def setUp(self):
        super().setUp()
        write_clip(self.folder / "clip.glb")

    def render(self, *options, model="clip.glb", code=0, size="64,48"):
        run = self.run_program("render", model, "--resolution", size, *options)
        self.assertEqual(run.code, code, run.err)
        return run

    def pictures(self, folder="."):
        return {p.name: p.read_bytes() for p in sorted((self.folder / folder).glob("*.png"))}


class Sequences(Case):
    def test_ranges_together_are_the_whole(self):
        self.render("-o", "whole/{frame:4}.png", "--fps", "10")
        whole = self.pictures("whole")
        self.assertEqual(list(whole), ["%04d.png" % i for i in range(11)])
        self.assertEqual(len(set(whole.values())), 11)
        for part in ("7:10", "0:3", "4:6"):
            self.render("-o", "parts/{frame:4}.png", "--fps", "10", "--frames", part, "--threads", "1")
        self.assertEqual(self.pictures("parts"), whole)
        self.render("-o", "alone.png", "--fps", "10", "--frames", "5")
        self.assertEqual((self.folder / "alone.0005.png").read_bytes(), whole["0005.png"])

    def test_windows_of_frames_are_joined_as_those_of_pictures(self):
        for kind, looks in (("png", ((), ("--background", "transparent"))), ("exr", ((),))):
            for options in looks:
                with self.subTest(kind=kind, options=options):
                    common = ("--fps", "2", "--frames", "0:1", *options)
                    self.render("-o", f"whole{{frame}}.{kind}", *common)
                    for name, window in (("left", "0,0,40,48"), ("right", "40,0,24,48")):
                        self.render("-o", f"{name}{{frame}}.{kind}", "--window", window, *common)
                    for frame in ("0", "1"):
                        joined = self.run_program("join-windows", f"left{frame}.{kind}", f"right{frame}.{kind}", "-o", f"joined{frame}.{kind}")
                        self.assertEqual(joined.code, 0, joined.err)
                        self.assertEqual((self.folder / f"joined{frame}.{kind}").read_bytes(), (self.folder / f"whole{frame}.{kind}").read_bytes())

    def test_a_frame_of_animated_materials_is_the_picture_of_its_moment(self):
        """Whatever the request changes materials to: the change comes after the clip."""
        write_shine(self.folder / "shine.glb")
        for options in (("--preset", "fixed-function"), (), ("--lighting", "blinn-phong"), ("--preset", "fixed-function", "--engine", "trace")):
            with self.subTest(options=options):
                light = ("--camera-position", "0,0,2", "--camera-focal-point", "0,0,0", "--light", "directional:0,-0.05,-1", *options)
                self.render("-o", "f{frame}.png", "--fps", "2", "--frames", "0:2", *light, model="shine.glb")
                for frame, time_s in ((0, "0"), (1, "0.5"), (2, "1")):
                    self.render("-o", "s.png", "--animation-index", "0", "--animation-time", time_s, *light, model="shine.glb")
                    self.assertEqual((self.folder / f"f{frame}.png").read_bytes(), (self.folder / "s.png").read_bytes(), frame)
                self.assertEqual(len({(self.folder / f"f{frame}.png").read_bytes() for frame in range(3)}), 3)

    def test_the_default_look_is_one_for_all(self):
        for options in ((), ("--turntable", "8")):
            self.render("-o", "whole/{frame}.png", "--fps", "8", "--look", "default", *options)
            self.render("-o", "alone/{frame}.png", "--fps", "8", "--frames", "6:6", "--look", "default", *options)
            whole = self.pictures("whole")
            self.assertEqual(self.pictures("alone")["6.png"], whole["6.png"])
            corners = {bytes(program.png(self.folder / "whole" / name)[3][0][:3]) for name in whole}
            self.assertEqual(len(corners), 1)

    def test_the_grid_stands_still_while_the_model_moves(self):
        self.render("-o", "g{frame}.png", "--fps", "4", "--frames", "0:2:2", "--grid", "--color", "#000000", "--light", "none")
        rows = [program.png(self.folder / ("g%d.png" % i))[3] for i in (0, 2)]
        self.assertNotEqual(rows[0], rows[1])
        self.assertGreater(len({bytes(rows[0][-6][x:x + 3]) for x in range(0, len(rows[0][-6]), 3)}), 2)  # there are lines below the model
        self.assertEqual(rows[0][-6:], rows[1][-6:])

    def test_a_turntable_turns_the_model_to_the_right(self):
        self.write("two.obj", "o a\nv 0 0 3\nv 0.4 0 3\nv 0.2 0.8 3\nf 1 2 3\no b\nv -3 0 -3\nv -3.2 0 -3\nv -3 0.2 -3\nv 3 0 -3\nv 3.2 0 -3\nv 3 0.2 -3\nf 4 5 6\nf 7 8 9\n")
        self.render("-o", "{frame}.png", "--turntable", "24", "--frames", "0:1", "--view", "front", "--light", "none", "--color", "#000000",
                    "--background", "white", model="two.obj")
        middle = []
        for frame in (0, 1):  # the columns in which the small triangle in front is black
            _, _, _, rows = program.png(self.folder / ("%d.png" % frame))
            columns = [x for row in rows for x in range(24, 41) if row[3 * x] == 0]
            self.assertTrue(columns)
            middle.append(sum(columns) / len(columns))
        self.assertGreater(middle[1], middle[0] + 1)

    def test_plain_names_get_a_number_and_folders_are_filled(self):
        run = self.render("-o", "out.png", "--frames", "0:1", "--verbose")
        self.assertIn("out.0000.png", run.err)
        self.render("-o", "folder/", "--frames", "1:1")
        self.assertEqual(sorted(self.pictures()), ["out.0000.png", "out.0001.png"])
        self.assertEqual(list(self.pictures("folder")), ["clip.0001.png"])

    def test_a_clip_and_a_number_in_the_name_are_a_sequence(self):
        self.render("-o", "a{frame:2}.png", "--animation-name", "slide")
        self.assertEqual(list(self.pictures())[::30], ["a00.png", "a30.png"])
        self.check_refused(self.run_program("render", "clip.glb", "-o", "b{frame:2}.png", "--animation-name", "slide", "--animation-time", "0.5"), 2,
                           "{frame}", "--turntable")

    def test_json_has_a_row_a_picture(self):
        run = self.render("-o", "{frame}.png", "--frames", "0:4:2", "--fps", "4", "--movie", "m.apng", "--json")
        rows = json.loads(run.out)["rows"]
        self.assertEqual([(r["frame"], r["time_s"], r["skipped"], r["output"]) for r in rows[:3]],
                         [(0, 0, False, "0.png"), (2, 0.5, False, "2.png"), (4, 1, False, "4.png")])
        self.assertEqual((rows[3]["output"], rows[3]["movie_pictures"]), ("m.apng", 3))
        self.assertEqual(len(rows), 4)
        rows = json.loads(self.render("-o", "{frame}.png", "--frames", "0:4:2", "--fps", "4", "--skip-existing", "--json").out)["rows"]
        self.assertTrue(all(r["skipped"] for r in rows))

    def test_a_frame_without_its_channel_files_is_drawn_again(self):
        frames = ("--frames", "0:1", "--fps", "4", "-o", "f{frame}.png")
        self.render(*frames)
        channels = (*frames, "--channels", "depth", "--channel-files", "exr,png", "--skip-existing", "--json")
        skipped = lambda: [row["skipped"] for row in json.loads(self.render(*channels).out)["rows"]]
        self.assertEqual(skipped(), [False, False])
        self.assertEqual(skipped(), [True, True])
        (self.folder / "f1.depth.png").unlink()
        self.assertEqual(skipped(), [True, False])
        (self.folder / "f0.depth.exr").write_bytes((self.folder / "f0.depth.exr").read_bytes()[:-9])
        self.assertEqual(skipped(), [False, True])

    def test_several_models_need_names(self):
        shutil.copy(self.folder / "clip.glb", self.folder / "other.glb")
        self.check_refused(self.run_program("render", "clip.glb", "other.glb", "-o", "{frame}.png", "--frames", "0:1"), 2, "{model}")
        self.check_refused(self.run_program("render", "clip.glb", "other.glb", "-o", "{model}.png", "--movie", "a.apng"), 2, "{model}")
        run = self.run_program("render", "clip.glb", "other.glb", *SIZE, "-o", "{model}-{frame}.png", "--frames", "0:1", "--movie", "{model}.apng")
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(sorted(self.pictures()), ["clip-0.png", "clip-1.png", "other-0.png", "other-1.png"])
        self.assertTrue((self.folder / "other.apng").exists())

    def test_what_cannot_be_is_refused_before_work(self):
        self.write("still.obj")
        for options, words in ((("--frames", "5:2"), "5 comes after 2"), (("--frames", "a:b"), "frames"), (("--frames", "0:2:0"), "frames"),
                               (("--frames", "0:99999999999999"), "frames"), (("--frames", "1:2:3:4"), "frames"), (("--frames", "0:400"), "0 to 30"),
                               (("--turntable", "0"), "turntable"), (("--turntable", "100000000"), "turntable"), (("--fps", "0"), "fps"),
                               (("--frames", "0:1", "--animation-name", "jump"), "slide"), (("--frames", "0:1", "--watch"), "watch"),
                               (("--frames", "0:1", "--keep-partial"), "keep-partial"), (("--skip-existing",), "skip-existing"),
                               (("--animation-time", "0.5", "--frames", "0:1"), "animation-time"), (("--movie", "a.avi"), "a.avi"),
                               (("--movie", "a.mp4", "--background", "transparent"), "alpha"), (("--movie", "a.gif", "--movie", "./a.gif"), "twice")):
            self.check_refused(self.run_program("render", "clip.glb", "-o", "x.png", *options), 2, words)
        self.check_refused(self.run_program("render", "still.obj", "-o", "x.png", "--frames", "0:1"), 2, "no animations", "--turntable")
        self.check_refused(self.run_program("render", "clip.glb", "-o", "x.jpg", "--movie", "a.apng"), 2, "PNG")
        self.check_refused(self.run_program("render", "clip.glb", "-o", "-", "--frames", "0:1"), 2, "sequence")
        write_clip(self.folder / "long.glb", 1e9)
        self.check_refused(self.run_program("render", "long.glb", "-o", "x.mp4"), 2, "100000")
        self.assertEqual(self.files(), ["clip.glb", "long.glb", "still.obj"])

    def interrupted(self, *options):
        """Runs until some pictures are there and then interrupts."""
        process = subprocess.Popen([program.PROGRAM, "render", "clip.glb", *options], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        begin = time.monotonic()
        while len(list(self.folder.glob("**/*.png"))) < 3 and process.poll() is None and time.monotonic() - begin < 120:
            time.sleep(0.005)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        return process.returncode, err

    def test_an_interrupted_run_goes_on(self):
        options = ("--resolution", "640,480", "--samples", "8", "--fps", "120", "--look", "plain", "-o", "m.apng")
        code, err = self.interrupted(*options)
        self.assertEqual(code, -signal.SIGINT)
        self.assertIn("cancelled", err)
        kept = self.pictures("m.apng.frames")
        self.assertGreater(len(kept), 0)
        self.assertLess(len(kept), 121)
        self.assertEqual([p for p in self.files() if p.startswith(".")], [])
        for name in kept:
            program.png(self.folder / "m.apng.frames" / name)  # whole
        rows = json.loads(self.run_program("render", "clip.glb", *options, "--skip-existing", "--json").out)["rows"]
        self.assertEqual(sum(r.get("skipped", False) for r in rows), len(kept))
        self.assertEqual(self.files(), ["clip.glb", "m.apng"])  # the pictures are gone with the work
        first = (self.folder / "m.apng").read_bytes()
        self.assertEqual(self.run_program("render", "clip.glb", *options).code, 0)
        self.assertEqual((self.folder / "m.apng").read_bytes(), first)

    def damaged_pngs(self, whole):
        """(what, bytes) of a PNG file that is damaged between its first and its last bytes."""
        middle = len(whole) // 2
        yield "a changed byte", whole[:middle] + bytes([whole[middle] ^ 1]) + whole[middle + 1:]
        yield "zeros", whole[:middle] + bytes(len(whole) - middle - 12) + whole[-12:]
        at = whole.index(b"IDAT") - 4
        end = at + 12 + struct.unpack(">I", whole[at:at + 4])[0]
        data = whole[at + 8:end - 4]
        for what, kept in (("data that end too early", data[:len(data) // 2]), ("no data", None)):  # with the right checksums
            chunk = b"" if kept is None else struct.pack(">I", len(kept)) + b"IDAT" + kept + struct.pack(">I", zlib.crc32(b"IDAT" + kept))
            yield what, whole[:at] + chunk + whole[end:]

    def test_a_damaged_frame_is_drawn_again_with_a_remark(self):
        options = ("-o", "f{frame}.png", "--frames", "0:3", "--fps", "4", "--background", "#406080")
        self.render(*options)
        whole = self.pictures()
        for what, bytes_ in self.damaged_pngs(whole["f2.png"]):
            with self.subTest(what=what):
                (self.folder / "f2.png").write_bytes(bytes_)
                run = self.render(*options, "--skip-existing", "--json")
                self.assertEqual([r["skipped"] for r in json.loads(run.out)["rows"]], [True, True, False, True])
                self.assertEqual(len(run.lines), 1, run.err)
                self.assertTrue(run.err.startswith("rakelight: warning: f2.png: is damaged, so it is drawn again: "), run.err)
                self.assertEqual(self.pictures(), whole)

    def test_damaged_frames_of_other_formats_are_drawn_again(self):
        for ending in ("exr", "webp", "jpg", "hdr", "ppm"):
            with self.subTest(ending=ending):
                options = ("-o", "f{frame}." + ending, "--frames", "0:1", "--fps", "4")
                self.render(*options)
                path = self.folder / f"f1.{ending}"
                whole = path.read_bytes()
                path.write_bytes(whole[:2 * len(whole) // 3])
                run = self.render(*options, "--skip-existing")
                self.assertIn(f"f1.{ending}: is damaged", run.err)
                self.assertEqual(path.read_bytes(), whole)
                run = self.render(*options, "--skip-existing", "--json")
                self.assertEqual(([r["skipped"] for r in json.loads(run.out)["rows"]], run.err), ([True, True], ""))

    def test_memory_that_many_frames_would_need_together_is_no_damage(self):
        options = ("-o", "f{frame}.hdr", "--frames", "0:15", "--fps", "30", "--threads", "16")
        self.render(*options)
        for path in self.folder.glob("f*.hdr"):  # what follows a picture is not read, but it is in memory
            path.write_bytes(path.read_bytes() + bytes(3 << 20))
        run = self.render(*options, "--skip-existing", "--json", "--max-memory", "24M")
        self.assertEqual(([r["skipped"] for r in json.loads(run.out)["rows"]], run.err), ([True] * 16, ""))

    def test_what_is_no_file_but_has_the_name_of_a_frame_is_refused(self):
        os.mkfifo(self.folder / "pipe1.png")
        (self.folder / "folder1.png").mkdir()
        with socket.socket(socket.AF_UNIX) as there:
            there.bind(str(self.folder / "socket1.png"))
        os.symlink("/dev/full", self.folder / "device1.png")
        before = self.files()
        for name in ("pipe", "folder", "socket", "device"):
            for more in ((), ("--skip-existing",), ("--movie", "m.apng")):
                with self.subTest(name=name, more=more):
                    run = self.run_program("render", "clip.glb", *SIZE, "-o", name + "{frame}.png", "--frames", "0:2", *more)
                    self.check_refused(run, 1, f"{name}1.png: ", "the name of a picture")
                    self.assertEqual(self.files(), before)

    def test_two_processes_do_not_work_on_one_movie(self):
        folder = self.folder / "m.apng.frames"
        folder.mkdir()
        (folder / "0000.png").write_bytes(b"of the other one")
        other = os.open(folder, os.O_RDONLY)
        fcntl.flock(other, fcntl.LOCK_EX)  # as a process that draws it
        run = self.run_program("render", "clip.glb", *SIZE, "-o", "m.apng", "--frames", "0:2")
        self.check_refused(run, 1, "m.apng.frames: another process works in this folder", "another name")
        self.assertEqual(self.pictures("m.apng.frames"), {"0000.png": b"of the other one"})
        os.close(other)  # or it has ended
        self.render("-o", "m.apng", "--frames", "0:2")
        self.assertEqual(self.files(), ["clip.glb", "m.apng"])

    def test_a_run_of_a_movie_holds_the_lock(self):
        process = subprocess.Popen([program.PROGRAM, "render", "clip.glb", "-o", "m.apng", "--resolution", "640,480", "--samples", "8", "--fps", "200"],
                                   cwd=self.folder, stderr=subprocess.PIPE, text=True)
        self.wait_for("m.apng.frames/0001.png")
        os.kill(process.pid, signal.SIGSTOP)
        try:
            run = self.run_program("render", "clip.glb", *SIZE, "-o", "m.apng", "--frames", "0:2", "--skip-existing")
            self.check_refused(run, 1, "another process works in this folder")
        finally:
            process.kill()
            process.communicate()
        self.render("-o", "m.apng", "--frames", "0:2")  # what was killed holds it no more

    def test_braces_of_a_models_name_are_no_placeholders(self):
        for name in ("a{frame}", "{frame:3}b", "c{{frame}}"):
            with self.subTest(name=name):
                shutil.copy(self.folder / "clip.glb", self.folder / f"{name}.glb")
                self.render("-o", "out/{model}-{frame:2}.png", "--frames", "0:1", model=f"{name}.glb")
                self.assertEqual(list(self.pictures("out")), [f"{name}-00.png", f"{name}-01.png"])
                self.render("-o", "folder/", "--frames", "1:1", model=f"{name}.glb")
                self.assertEqual(list(self.pictures("folder")), [f"{name}.0001.png"])
                self.render("-o", "movies/{model}.apng", "--frames", "0:1", model=f"{name}.glb")
                self.assertTrue((self.folder / f"movies/{name}.apng").is_file())
                self.render("-o", "{frame}.png", "--movie", "more/{model}.apng", "--frames", "0:1", model=f"{name}.glb")
                self.assertTrue((self.folder / f"more/{name}.apng").is_file())
                shutil.rmtree(self.folder / "out")
                shutil.rmtree(self.folder / "folder")
        self.render("-o", "{{frame}}-{frame}.png", "--frames", "0:0")
        self.assertTrue((self.folder / "{frame}-0.png").is_file())
        self.check_refused(self.run_program("render", "clip.glb", *SIZE, "-o", "{frame}.png", "--movie", "m{frame}.apng"), 2, "--movie", "{frame}")

    def test_apng_has_the_pictures(self):
        self.render("-o", "a.apng", "--fps", "10", "--keep-frames")
        parts = chunks(self.folder / "a.apng")
        self.assertEqual([k for k, _ in parts if k in (b"IHDR", b"acTL", b"IEND")], [b"IHDR", b"acTL", b"IEND"])
        frames = []
        for kind, data in parts:
            if kind == b"fcTL":
                frames.append(b"")
            if kind in (b"IDAT", b"fdAT"):
                frames[-1] += data[4 if kind == b"fdAT" else 0:]
        names = sorted((self.folder / "a.apng.frames").iterdir())
        self.assertEqual(len(frames), len(names))
        for frame, name in zip(frames, names):
            self.assertEqual(zlib.decompress(frame), zlib.decompress(b"".join(d for k, d in chunks(name) if k == b"IDAT")))

    def test_webp_of_a_sequence_is_a_movie_and_alone_a_picture(self):
        self.render("-o", "a.webp", "--frames", "0:2")
        self.assertEqual((self.folder / "a.webp").read_bytes().count(b"ANMF"), 3)
        self.render("-o", "b.webp")
        self.assertEqual((self.folder / "b.webp").read_bytes().count(b"ANMF"), 0)
        self.render("-o", "c.{frame}.webp", "--frames", "0:1")
        self.assertEqual(self.files(), ["a.webp", "b.webp", "c.0.webp", "c.1.webp", "clip.glb"])

    def test_where_ffmpeg_is_missing_nothing_is_drawn(self):
        run = self.run_program("render", "clip.glb", *SIZE, "-o", "a.mp4", "--frames", "0:2", PATH="/nowhere")
        self.assertEqual(run.code, 1)
        self.assertEqual(len(run.lines), 1, run.err)
        self.assertIn("install the package ffmpeg", run.err)
        self.assertEqual(self.files(), ["clip.glb"])

    def test_names_of_clips_are_found_by_their_beginning_and_in_any_case(self):
        self.render("-o", "a.png", "--animation-name", "SLIDE", "--animation-time", "0.5")
        self.check_refused(self.run_program("render", "clip.glb", "-o", "b.png", "--animation-name", "sli"), 2, "animation-name", "'slide'")
        self.check_refused(self.run_program("render", "clip.glb", "-o", "b.png", "--animation-name", "slude"), 2, "did you mean 'slide'?")

    def test_a_place_that_cannot_be_written_is_said_before_work(self):
        (self.folder / "m.apng").mkdir()
        self.check_refused(self.run_program("render", "clip.glb", "-o", "{frame}.png", "--movie", "m.apng"), 1, "folder")
        self.assertEqual(self.files(), ["clip.glb", "m.apng"])


@unittest.skipUnless(HAS_FFMPEG, "ffmpeg is not installed")
class Movies(Case):
    def probe(self, name):
        done = subprocess.run(["ffprobe", "-v", "error", "-select_streams", "v:0", "-count_frames", "-show_entries",
                               "stream=codec_name,width,height,pix_fmt,nb_read_frames,r_frame_rate", "-of", "json", name],
                              cwd=self.folder, capture_output=True, text=True, check=True)
        return json.loads(done.stdout)["streams"][0]

    def decoded(self, name, count, size=(64, 48)):
        """[frame] RGB bytes, as ffmpeg decodes them."""
        raw = subprocess.run(["ffmpeg", "-v", "error", "-i", name, "-f", "rawvideo", "-pix_fmt", "rgb24", "-vsync", "passthrough", "-"], cwd=self.folder,
                             capture_output=True, check=True).stdout
        step = 3 * size[0] * size[1]
        self.assertEqual(len(raw), count * step)
        return [raw[i:i + step] for i in range(0, len(raw), step)]

    def test_each_kind_has_all_pictures(self):
        movies = ("a.mp4", "a.webm", "a.gif", "a.apng")
        options = [w for m in movies for w in ("--movie", m)]
        self.render("-o", "p{frame:2}.png", "--fps", "20", "--frames", "0:11", "--background", "#406080", *options)
        pictures = [b"".join(bytes(row) for row in program.png(self.folder / ("p%02d.png" % i))[3]) for i in range(12)]
        codecs = {"a.mp4": "h264", "a.webm": "vp9", "a.gif": "gif", "a.apng": "apng"}
        for movie in movies:
            stream = self.probe(movie)
            self.assertEqual((stream["codec_name"], stream["width"], stream["height"], stream["nb_read_frames"]), (codecs[movie], 64, 48, "12"))
            self.assertEqual(stream["r_frame_rate"], "20/1")
            for mine, theirs in zip(pictures, self.decoded(movie, 12)):
                error = sum(abs(a - b) for a, b in zip(mine, theirs)) / len(mine)
                self.assertLess(error, 0.01 if movie == "a.apng" else 4, movie)
        kept = {m: (self.folder / m).read_bytes() for m in movies}
        self.render("-o", "p{frame:2}.png", "--fps", "20", "--frames", "0:11", "--background", "#406080", "--skip-existing", *options)
        self.assertEqual({m: (self.folder / m).read_bytes() for m in movies}, kept)

    def test_odd_sizes_and_alpha(self):
        odd = ("--frames", "0:2")
        self.render("-o", "odd.mp4", *odd, size="63,47")
        self.assertEqual((self.probe("odd.mp4")["width"], self.probe("odd.mp4")["height"]), (64, 48))
        self.render("-o", "clear.webm", *odd, "--background", "transparent", size="63,47")
        self.assertEqual((self.probe("clear.webm")["width"], self.probe("clear.webm")["nb_read_frames"]), (63, "3"))
        self.assertIn(b"\x53\xc0\x81\x01", (self.folder / "clear.webm").read_bytes())  # AlphaMode 1
        self.render("-o", "clear.gif", *odd, "--background", "transparent", size="63,47")
        self.assertEqual(self.probe("clear.gif")["nb_read_frames"], "3")

    def test_steps_keep_the_pace(self):
        self.render("-o", "a.mp4", "--fps", "30", "--frames", "0:29:3")
        self.assertEqual((self.probe("a.mp4")["r_frame_rate"], self.probe("a.mp4")["nb_read_frames"]), ("10/1", "10"))
        self.assertEqual(self.files(), ["a.mp4", "clip.glb"])

    def test_what_ffmpeg_says_is_shown(self):
        fake = self.folder / "bin"
        fake.mkdir()
        (fake / "ffmpeg").write_text("#!/bin/sh\necho 'no such codec' >&2\nexit 3\n")
        os.chmod(fake / "ffmpeg", 0o755)
        run = self.run_program("render", "clip.glb", *SIZE, "-o", "a.mp4", "--frames", "0:2", PATH="%s:/bin:/usr/bin" % fake)
        self.assertEqual((run.code, len(run.lines)), (1, 1), run.err)
        self.assertIn("no such codec", run.err)
        self.assertFalse((self.folder / "a.mp4").exists())


if __name__ == "__main__":
    program.main()
