#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight thumbnail`: addresses of files, sizes, what the picture is, and the limits past which it gives up.

  thumbnail_test.py PROGRAM [unittest arguments]"""
import os
import pathlib
import struct
import subprocess
import sys
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

MODELS = {".glb", ".gltf", ".obj", ".ply", ".xyz", ".pts", ".fbx", ".dae", ".3ds", ".ase", ".blend", ".stl", ".off", ".x"}


class Thumbnail(program.Case):
    def fine(self, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual((result.code, result.err), (0, ""))

    def test_is_a_square_png_with_a_clear_background(self):
        self.write("square.obj", program.SQUARE.format(name="a"))
        self.fine("thumbnail", "square.obj", "small", "64")
        width, height, channels, rows = program.png(self.folder / "small")
        self.assertEqual((width, height, channels), (64, 64, 4))
        self.assertEqual(rows[0][3], 0)
        self.assertEqual(rows[32][32 * 4 + 3], 255)

    def test_is_the_picture_that_render_draws(self):
        self.write("two.obj", program.TWO_PARTS)
        self.fine("thumbnail", "two.obj", "a.png", "48")
        self.fine("render", "two.obj", "-o", "b.png", "--resolution", "48,48", "--background", "transparent", "--look", "default")
        self.assertEqual(program.png(self.folder / "a.png"), program.png(self.folder / "b.png"))

    def test_addresses_of_files(self):
        self.write("a b%ü.obj", program.SQUARE.format(name="a"))
        for start in ("file://", "file://localhost", "file:", "FILE:"):
            address = f"{start}{self.folder}/a%20b%25%c3%BC.obj"
            self.fine("thumbnail", address, "small.png", "32")
            self.assertEqual(program.png(self.folder / "small.png")[0], 32)
            (self.folder / "small.png").unlink()

    def test_addresses_that_are_none(self):
        for address, reason in (("smb://host/a.obj", "is no file of this machine"), ("file://elsewhere/a.obj", "is no file of this machine"),
                                ("file:///a%2", "two hexadecimal digits"), ("file:///a%", "two hexadecimal digits"),
                                ("file:///a%zz.obj", "two hexadecimal digits"), ("file:/a%zz.obj", "two hexadecimal digits"),
                                ("file:///a%00.obj", "zero byte"), ("file://a", "has no path"), ("file://host/", "is no file of this machine")):
            result = self.run_program("thumbnail", address, "small.png", "32")
            self.assertEqual((result.code, len(result.lines)), (2, 1), address)
            self.assertIn(reason, result.err)

    def test_a_path_with_a_colon_is_no_address(self):
        (self.folder / "a:").mkdir()
        self.write("a:/square.obj", program.SQUARE.format(name="a"))
        self.fine("thumbnail", "a:/square.obj", "small.png", "32")

    def test_a_world_is_seen_as_it_says(self):
        """Its camera and materials count; its size, background, engine and channels do not."""
        self.write("two.obj", program.TWO_PARTS)
        model, render = '[[model]]\nfile = "two.obj"\n', "[render]\nview = \"isometric\"\nlook = \"default\"\n"
        self.write("own.scene.toml", model + render + 'resolution = [64, 32]\nbackground = "red"\nengine = "trace"\nchannels = "depth"\n')
        self.write("plain.scene.toml", model)
        self.fine("thumbnail", "own.scene.toml", "a.png", "48")
        self.fine("render", "two.obj", "-o", "b.png", "--resolution", "48,48", "--background", "transparent", "--look", "default", "--view", "isometric")
        self.fine("thumbnail", "plain.scene.toml", "c.png", "48")
        self.assertEqual(program.png(self.folder / "a.png"), program.png(self.folder / "b.png"))
        self.assertNotEqual(program.png(self.folder / "a.png"), program.png(self.folder / "c.png"))

    def test_textures_are_reduced_to_what_is_seen(self):
        """A texture of stripes, one texel wide, is gray in the mean. 16 bytes a texel are more than the memory that is given."""
        side, row = 4096, b"\0" + bytes((255, 255, 255, 0, 0, 0)) * 2048
        chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        (self.folder / "stripes.png").write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)) +
                                                  chunk(b"IDAT", zlib.compress(row * side, 1)) + chunk(b"IEND", b""))
        self.write("a.mtl", "newmtl m\nKd 1 1 1\nmap_Kd stripes.png\n")
        self.write("a.obj", "mtllib a.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
        result = self.run_program("thumbnail", "a.obj", "a.png", "64", "--max-memory", "100M", "--cpu-seconds", "60", "--verbose")
        self.assertEqual(result.code, 0, result.err)
        self.assertNotIn("texture left out", result.err)
        _, _, _, rows = program.png(self.folder / "a.png")
        inner = [rows[y][x * 4] for y in range(24, 40) for x in range(24, 40)]
        self.assertLess(max(inner) - min(inner), 24)
        self.assertTrue(60 < inner[0] < 220, inner[0])

    def test_sizes(self):
        self.write("square.obj", program.SQUARE.format(name="a"))
        for size in ("15", "2049", "big", "64.5"):
            result = self.run_program("thumbnail", "square.obj", "small.png", size)
            self.assertEqual((result.code, len(result.lines)), (2, 1), size)
            self.assertIn("SIZE", result.err)

    def test_writes_onto_a_file_that_is_there(self):
        """File managers make the file, and in a sandbox it can be written but not replaced."""
        self.write("square.obj", program.SQUARE.format(name="a"))
        place = self.folder / "small.png"
        place.write_bytes(b"x" * 100_000)
        before = os.stat(place).st_ino
        self.fine("thumbnail", "square.obj", "small.png", "32")
        self.assertEqual(os.stat(place).st_ino, before)
        self.assertEqual(program.png(place)[0], 32)

    def test_the_model_itself_is_not_overwritten(self):
        self.write("square.obj", program.SQUARE.format(name="a"))
        before = (self.folder / "square.obj").read_bytes()
        os.symlink("square.obj", self.folder / "link.png")
        for place in ("square.obj", "./square.obj", "link.png"):
            result = self.run_program("thumbnail", "square.obj", place, "32")
            self.assertEqual((result.code, len(result.lines)), (2, 1), result.err)
            self.assertIn("is the model itself", result.err)
        self.assertEqual((self.folder / "square.obj").read_bytes(), before)

    def test_a_thumbnail_that_does_not_fit_leaves_no_part(self):
        """Where there is no file none appears; one that a file manager made stays where it is, empty."""
        self.write("square.obj", program.SQUARE.format(name="a"))
        place = self.folder / "small.png"
        for is_there in (False, True):
            with self.subTest(is_there=is_there):
                if is_there:
                    place.write_bytes(b"x" * 100)
                    before = os.stat(place).st_ino
                shell = f"ulimit -f 1; exec '{program.PROGRAM}' thumbnail square.obj small.png 1024"
                done = subprocess.run(["bash", "-c", shell], cwd=self.folder, capture_output=True, text=True)
                self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
                self.assertEqual(place.exists(), is_there)
                if is_there:
                    self.assertEqual((os.stat(place).st_ino, place.read_bytes()), (before, b""))

    def test_a_fifo_that_nobody_reads_is_not_waited_for(self):
        self.write("square.obj", program.SQUARE.format(name="a"))
        os.mkfifo(self.folder / "lone")
        result = self.run_program("thumbnail", "square.obj", "lone", "64")
        self.assertEqual((result.code, len(result.lines)), (1, 1), result.err)
        self.assertIn("lone: nobody reads from it", result.err)

    def test_a_pipe_gets_all(self):
        """More than a pipe holds, so that the write has to wait."""
        points = "".join(f"{i * 37 % 199} {i * 53 % 211} {i * 71 % 223} {i * 7 % 256} {i * 11 % 256} {i * 13 % 256}\n" for i in range(20000))
        self.write("noise.xyz", points)
        words = "thumbnail noise.xyz {} 1024 --cpu-seconds 60"
        self.fine(*words.format("small.png").split())
        expected = (self.folder / "small.png").read_bytes()
        self.assertGreater(len(expected), 1 << 16)
        shell = f"set -o pipefail; '{program.PROGRAM}' {words.format('/dev/stdout')} | (sleep 0.3; cat)"
        done = subprocess.run(["bash", "-c", shell], cwd=self.folder, capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.assertEqual(done.stdout, expected)

    def test_a_file_that_is_no_model_leaves_no_thumbnail(self):
        self.write("broken.glb", "glTF")
        result = self.run_program("thumbnail", "broken.glb", "small.png", "32")
        self.assertEqual((result.code, len(result.lines)), (4, 1))
        self.assertFalse((self.folder / "small.png").exists())

    def test_a_pipe_is_no_model(self):
        os.mkfifo(self.folder / "pipe.obj")
        result = self.run_program("thumbnail", "pipe.obj", "small.png", "32")
        self.assertEqual((result.code, len(result.lines)), (3, 1))

    def many_objects(self):
        """A second's work, for an engine with a list of what is drawn."""
        faces = [f"o part{i}\nv {i % 200} {i // 200} 0\nv {i % 200 + 1} {i // 200} 0\nv {i % 200} {i // 200 + 1} 1\nf -3 -2 -1\n" for i in range(60000)]
        self.write("many.obj", "".join(faces))

    def test_gives_up_past_its_processor_time(self):
        self.many_objects()
        result = self.run_program("thumbnail", "many.obj", "small.png", "64", "--cpu-seconds", "0.1")
        self.assertEqual((result.code, len(result.lines)), (1, 1), result.err)
        self.assertIn("100 ms of processor time", result.err)
        self.assertEqual(os.listdir(self.folder), ["many.obj"])

    def test_a_limit_below_what_the_program_takes(self):
        self.write("square.obj", program.SQUARE.format(name="a"))
        for limit in ("1", "1M", "31M"):
            result = self.run_program("thumbnail", "square.obj", "small.png", "32", "--max-memory", limit)
            self.assertEqual((result.code, len(result.lines)), (2, 1), result.err)
            self.assertIn("must be 32M or more", result.err)

    @unittest.skipIf(program.SANITIZED, "sanitizers have memory of their own")
    def test_gives_up_past_its_memory(self):
        self.many_objects()
        result = self.run_program("thumbnail", "many.obj", "small.png", "64", "--max-memory", "32M", "--cpu-seconds", "60")
        self.assertNotEqual(result.code, 0)
        self.assertEqual(len(result.lines), 1, result.err)
        self.assertEqual(os.listdir(self.folder), ["many.obj"])

    @unittest.skipIf(program.SANITIZED, "sanitizers have memory of their own")
    def test_broken_files_take_no_more_than_they_may(self):
        """Each ends with a known exit code, a thumbnail or one line, and never takes more than 300 MB."""
        folder = pathlib.Path(os.environ.get("RAKELIGHT_SHARED", pathlib.Path(__file__).parents[4] / "shared")) / "hostile"
        if not folder.is_dir():
            self.skipTest(f"{folder} is not there")
        models = [path for path in sorted(folder.rglob("*")) if path.suffix.lower() in MODELS]
        self.assertGreater(len(models), 300)
        for model in models:
            picture, said = self.folder / "small.png", self.folder / "said"
            picture.unlink(missing_ok=True)
            actions = [(os.POSIX_SPAWN_OPEN, 2, str(said), os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)]
            child = os.posix_spawn(program.PROGRAM, [program.PROGRAM, "thumbnail", str(model), str(picture), "128"], os.environ, file_actions=actions)
            _, status, used = os.wait4(child, 0)
            with self.subTest(model=model.relative_to(folder)):
                code = os.waitstatus_to_exitcode(status)
                self.assertIn(code, (0, 1, 3, 4))
                self.assertEqual(picture.exists(), code == 0)
                self.assertEqual(len(said.read_text(errors="replace").splitlines()), int(code != 0))
                self.assertLess(used.ru_maxrss * 1024, 300e6)


if __name__ == "__main__":
    program.main()
