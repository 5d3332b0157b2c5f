#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How a run ends: exit codes, one-line messages, files left behind, full disks, interruptions, terminals.

  process_test.py PROGRAM [unittest arguments]"""
import json
import os
import pathlib
import pty
import resource
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import SQUARE


class Process(program.Case):
    def test_a_failing_model_does_not_stop_the_others(self):
        self.write("bad.obj", "v 0 0 0\nf 1 2 99\n")
        self.write("good.obj")
        result = self.run_program("render", "missing.obj", "bad.obj", "good.obj", "-o", "{model}.png", "--resolution", "16,12", "--json")
        self.assertEqual(result.code, 4, result.err)
        self.assertEqual(len([line for line in result.lines if line.startswith("rakelight: error: ")]), 2)
        rows = json.loads(result.out)["rows"]
        self.assertEqual([row.get("error", {}).get("exit_code", 0) for row in rows], [3, 4, 0])
        self.assertEqual(self.files(), ["bad.obj", "good.obj", "good.png"])

    def test_a_full_disk_is_named(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        self.write("a.obj")
        for ending in ("png", "exr", "hdr"):
            os.symlink("/dev/full", self.folder / f"full.{ending}")
            result = self.run_program("render", "a.obj", "-o", f"full.{ending}", "--background", "1,0,0")
            self.check_refused(result, 1, "No space left on device")

    def test_a_file_that_grows_too_large_is_an_error_not_a_signal(self):
        self.write("a.obj")
        done = subprocess.run([program.PROGRAM, "render", "a.obj", "-o", "a.exr"], cwd=self.folder, stderr=subprocess.PIPE, text=True, timeout=60,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("cannot be written", done.stderr)
        self.assertEqual(self.files(), ["a.obj"])

    def test_a_small_stack_is_enough(self):
        """With a hard limit: the program cannot raise it. The environment has to fit into it too."""
        self.write("a.obj", program.TWO_PARTS)
        self.write("b.obj")
        small = ("--resolution", "64,48")
        runs = [("render", "a.obj", "-o", "a.png", *small, "--engine", engine) for engine in ("soft", "trace")]
        runs += [("inspect", "a.obj"), ("inspect", "a.obj", "--heatmap", "heat.png"), ("smooth", "a.obj", "-o", "s.glb"), ("convert", "a.obj", "-o", "c.glb"),
                 ("explain", "a.obj", "--pixel", "32,24"), ("stages", "a.obj", "-o", "stages", *small), ("check", "a.obj"),
                 ("compare", "a.obj", "--engines", "soft,trace", "-o", "d.png", *small), ("thumbnail", "a.obj", "-o", "t.png"),
                 ("bake", "a.obj", "b.obj", "-o", "bake.png", "--size", "16"), ("bench", "smooth", "--triangles", "1000"), ("--help",), ("--man",),
                 ("radiosity", "builtin:cornell", "-o", "r.glb", "--patches", "10"), ("render", "a.obj", "-o", "f.apng", "--turntable", "3", *small)]
        for words in runs:
            with self.subTest(words=words):
                plain = subprocess.run([program.PROGRAM, *words], cwd=self.folder, capture_output=True, text=True, timeout=120)
                done = subprocess.run([program.PROGRAM, *words], cwd=self.folder, capture_output=True, text=True, timeout=120, env={"PATH": os.environ["PATH"]},
                                      preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_STACK, (65536, 65536)))
                self.assertEqual(done.returncode, plain.returncode, done.stderr)

    def test_an_output_that_nobody_reads_is_not_waited_for(self):
        self.write("a.obj")
        for name in ("a.png", "a.exr", "a.glb"):
            os.mkfifo(self.folder / name)
            self.check_refused(self.run_program("convert" if name == "a.glb" else "render", "a.obj", "-o", name, "--quiet"), 1, name, "nobody reads from it")
        with subprocess.Popen(["cat", "a.png"], cwd=self.folder, stdout=subprocess.PIPE) as reader:
            while True:  # it has opened it
                run = self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "16,12")
                if "nobody reads" not in run.err:
                    break
            self.assertEqual(run.code, 0, run.err)
            self.assertEqual(reader.stdout.read()[:4], b"\x89PNG")

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
        self.check_refused(self.run_program("render", "a.obj", "-o", "a.obj/such/a.png"), 1, "a.obj/such", "is not a folder")
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
            done = subprocess.run([program.PROGRAM, "--help"], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn("standard output", done.stderr)

    def test_hostile_names_are_shown_in_one_printable_line(self):
        for name in ("line\nfeed.obj", "esc\033[31m.obj", "x" * 200 + ".obj", "bytes\udcff.obj", "--"):
            with self.subTest(name=name):
                done = subprocess.run([program.PROGRAM, "render", "-o", "a.png", "--", os.fsencode(name)], cwd=self.folder, capture_output=True,
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

    def test_remarks_are_one_warning_line_each_and_capped(self):
        materials = "".join(f"usemtl m{i}\nf 1 2 3 4\n" for i in range(60))
        self.write("many.obj", SQUARE.format(name="a") + "mtllib missing.mtl\n" + materials)
        result = self.run_program("render", "many.obj", "-o", "a.png", "--resolution", "16,12")
        self.assertEqual(result.code, 0, result.err)
        self.assertEqual(len(result.lines), 21)
        self.assertIn("more, see --verbose or --json", result.lines[-1])
        for line in result.lines:
            self.assertTrue(line.startswith("rakelight: warning: many.obj: "), line)
        self.assertEqual(self.run_program("render", "many.obj", "-o", "a.png", "--resolution", "16,12", "--quiet").err, "")
        rows = json.loads(self.run_program("render", "many.obj", "-o", "a.png", "--resolution", "16,12", "--quiet", "--json").out)["rows"]
        self.assertTrue(any(r["remark"] != "note" for r in rows[0]["remarks"]))

    def run_on_terminal(self, *arguments, **environment):
        """What the program writes to standard error when that is a terminal."""
        master, terminal = pty.openpty()
        process = subprocess.Popen([program.PROGRAM, *arguments], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=terminal,
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
            process = subprocess.Popen([program.PROGRAM, "render", "grid.obj", "-o", "a.png", "--resolution", "8000,6000"], cwd=self.folder,
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
        process = subprocess.Popen([program.PROGRAM, "render", *names, "-o", "{model}.png", "--resolution", "2400,1800", "--json"],
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

    def test_inspect_goes_on_after_a_failing_file(self):
        self.write("a.obj")
        result = self.run_program("inspect", "missing.obj", "a.obj", "--json")
        self.assertEqual(result.code, 3)
        rows = json.loads(result.out)["rows"]
        self.assertEqual(rows[0]["error"]["code"], "not_found")
        self.assertEqual(rows[1]["triangles"], 2)


if __name__ == "__main__":
    program.main()
