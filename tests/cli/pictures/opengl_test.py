#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Engine gl and auto of the real program: the picture, and what happens where OpenGL is missing. Standard library only.

  opengl_test.py PROGRAM [unittest arguments]"""
import json
import os
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import TWO_PARTS, png

LIGHTING = ("RL_FN LightTerms user_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light)\n{\n"
            "    LightTerms terms = no_terms();\n    terms.diffuse = vec3(0.0f, 1.0f, 0.0f);\n    return terms;\n}\n")


class OpenGl(program.Case):
    def draw(self, *arguments, engine="gl", **environment):
        return self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "64,48", "--engine", engine, *arguments,
                                RAKELIGHT_GL_CACHE="off", **environment)

    def require_opengl(self):
        self.write("a.obj", TWO_PARTS)
        result = self.draw()
        if result.code == 1:
            self.skipTest(result.err.strip())
        self.assertEqual((result.code, result.out, result.err), (0, "", ""))

    def test_the_picture_is_the_soft_engines_but_for_rounding(self):
        self.require_opengl()
        rows = png(self.folder / "a.png")[3]
        self.assertEqual(self.draw(engine="soft").code, 0)
        soft = png(self.folder / "a.png")[3]
        self.assertLessEqual(max(abs(a - b) for r, s in zip(rows, soft) for a, b in zip(r, s)), 3)

    def test_no_thread_has_a_lower_priority_than_the_program(self):
        """A process is gone only when each of its threads has run once more: on a busy machine one of a low priority keeps it for seconds."""
        self.require_opengl()
        process = subprocess.Popen([program.PROGRAM, "render", "a.obj", "-o", "b.png", "--resolution", "4000,3000", "--engine", "gl"], cwd=self.folder)
        priorities = {}  # [thread] the lowest that was seen
        while process.poll() is None:
            for stat in pathlib.Path(f"/proc/{process.pid}/task").glob("*/stat"):
                try:
                    name, _, fields = stat.read_text().rpartition(")")
                except OSError:
                    continue
                nice = int(fields.split()[16])
                priorities[stat.parent.name] = max(nice, priorities.get(stat.parent.name, nice))
        self.assertEqual(process.returncode, 0)
        self.assertGreater(len(priorities), 2)
        self.assertEqual(set(priorities.values()), {os.nice(0)})

    def test_times_of_passes_are_in_the_json(self):
        self.require_opengl()
        row = json.loads(self.draw("--json").out)["rows"][0]
        self.assertEqual(row["engine"], "gl")
        self.assertIn("surfaces", [p["name"] for p in row["stats"]["gpu_passes"]])

    def test_a_lighting_of_the_users_own(self):
        self.require_opengl()
        self.write("green.glsl", LIGHTING)
        self.assertEqual(self.draw("--lighting", "green.glsl").code, 0)
        self.assertEqual(tuple(png(self.folder / "a.png")[3][24][96:99]), (0, 255, 0))
        self.write("broken.glsl", LIGHTING.replace("no_terms();", "no_terms()"))
        self.check_refused(self.draw("--lighting", "broken.glsl"), 4, "--lighting", "broken.glsl:4")
        self.check_refused(self.draw("--lighting", "green.glsl", engine="soft"), 2, "engine soft cannot", "green.glsl")
        self.check_refused(self.draw("--lighting", "missing.glsl"), 3, "missing.glsl")

    def test_a_watched_lighting_is_read_again(self):
        self.require_opengl()
        self.write("own.glsl", LIGHTING)
        command = [program.PROGRAM, "render", "a.obj", "-o", "{frame}.png", "--resolution", "64,48", "--engine", "gl", "--lighting", "own.glsl", "--look", "plain", "--watch"]
        running = subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE, text=True)
        try:
            self.assertIn("watching 2 files", running.stderr.readline())
            self.write("own.glsl", LIGHTING.replace("vec3(0.0f, 1.0f", "vec3(1.0f, 0.0f"))
            self.assertEqual(running.stderr.readline(), "rakelight: own.glsl has changed: drawing again\n")
            self.wait_for("2.png")
        finally:
            running.terminate()
            running.communicate(timeout=60)
        seen = [tuple(png(self.folder / f"{frame}.png")[3][24][96:99]) for frame in (1, 2)]
        self.assertEqual(seen, [(0, 255, 0), (255, 0, 0)])

    def test_a_fault_is_named_by_the_users_file_and_line(self):
        self.require_opengl()
        self.write("bad.glsl", LIGHTING.replace("vec3(0.0f, 1.0f, 0.0f)", "foo(3)"))
        self.check_refused(self.draw("--lighting", "bad.glsl"), 4, "--lighting", "bad.glsl:4")
        self.write("open.glsl", LIGHTING.replace("}", ""))
        self.check_refused(self.draw("--lighting", "open.glsl"), 4, "open.glsl", "line 2", "'{' is not closed")
        self.write("move.glsl", "void user_vertex(inout Vertex v)\n{\n    v.position = foo(3);\n}\n")
        self.check_refused(self.draw("--vertex-shader", "move.glsl"), 4, "--vertex-shader", "move.glsl:3")

    def test_uniforms_have_the_values_that_are_given(self):
        self.require_opengl()
        self.write("tint.glsl", "uniform vec3 tint = vec3(0.0, 1.0, 0.0);\n" + LIGHTING.replace("vec3(0.0f, 1.0f, 0.0f)", "tint"))
        for uniforms, color in (((), (0, 255, 0)), (("--uniform", "tint=1,0,1"), (255, 0, 255))):
            self.assertEqual(self.draw("--lighting", "tint.glsl", *uniforms).code, 0)
            self.assertEqual(tuple(png(self.folder / "a.png")[3][24][96:99]), color)
        for word, reason in (("tnit=1,0,0", "did you mean 'tint'?"), ("tint=1", "needs 3 numbers"), ("tint=1,0,inf", "not 3 numbers"),
                             ("tint", "needs a name and '='"), ("tint=1,0,1e39", "too large")):
            self.check_refused(self.draw("--lighting", "tint.glsl", "--uniform", word), 2, "--uniform", reason)
        self.check_refused(self.draw("--uniform", "tint=1,0,0"), 2, "--uniform", "no GLSL text", "vertex-shader")
        self.check_refused(self.draw("--vertex-shader", "tint.glsl", engine="soft"), 4, "does not define user_vertex()")

    def test_the_time_of_a_sequence_animates_a_lighting(self):
        self.require_opengl()
        self.write("time.glsl", LIGHTING.replace("vec3(0.0f, 1.0f, 0.0f)", "vec3(rl_time)"))
        result = self.run_program("a.obj", "-o", "f{frame}.png", "--turntable", "6", "--fps", "4", "--frames", "0:2", "--resolution", "64,48",
                                  "--look", "plain", "--engine", "gl", "--light", "directional:0,0,-1", "--lighting", "time.glsl", RAKELIGHT_GL_CACHE="off")
        self.assertEqual(result.code, 0, result.err)
        lit = [max(row[i] for row in png(self.folder / f"f{k}.png")[3] for i in range(0, len(row), 3)) for k in range(3)]
        background = lit[0]  # black but for that
        self.assertEqual(lit[1:], [max(background, 137), max(background, 188)], "0.25 and 0.5 as sRGB codes")

    def test_explain_prints_the_terms_that_a_lighting_declares(self):
        self.require_opengl()
        self.write("terms.glsl", "out vec2 mine;\n" + LIGHTING.replace("    return", "    mine += vec2(light.attenuation, 7.5f);\n    return"))
        arguments = ("explain", "a.obj", "--pixel", "32,24", "--resolution", "64,48", "--lighting", "terms.glsl",
                     "--light", "directional:0,0,-1", "--light", "ambient:1,1,1")
        text = self.run_program(*arguments, RAKELIGHT_GL_CACHE="off")
        self.assertEqual(text.code, 0, text.err)
        for words in ("Lighting by terms.glsl", "light 0 mine", "7.5"):
            self.assertIn(words, text.out)
        row = json.loads(self.run_program(*arguments, "--json", RAKELIGHT_GL_CACHE="off").out)["rows"][0]
        self.assertEqual(row["shaders"]["diffuse"], [0, 2, 0])
        self.assertEqual([(t["light"], t["name"], t["value"]) for t in row["shaders"]["terms"]], [(0, "mine", [1, 7.5]), (1, "mine", [1, 7.5])])

    def test_what_the_engine_cannot_do_is_refused_before_anything_is_drawn(self):
        self.require_opengl()
        (self.folder / "a.png").unlink()
        self.check_refused(self.draw("--visibility", "painter"), 2, "engine gl cannot use another method of hidden-surface removal")
        self.assertEqual(self.files(), ["a.obj"])

    def with_library(self, text):
        """A folder with a libEGL.so.1 that is made of this C text; None: a file that is no library."""
        folder = self.folder / "lib"
        folder.mkdir(exist_ok=True)
        library = folder / "libEGL.so.1"
        if text is None:
            library.write_bytes(b"no library")
            return str(folder)
        compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
        if not compiler:
            self.skipTest("there is no C compiler")
        (self.folder / "egl.c").write_text(text)
        subprocess.run([compiler, "-shared", "-fPIC", "-o", library, self.folder / "egl.c", "-Wl,-soname,libEGL.so.1"], check=True)
        return str(folder)

    def test_without_a_usable_libegl_one_line_says_so(self):
        self.write("a.obj")
        for text in (None, "int nothing;\n"):
            folder = self.with_library(text)
            self.check_refused(self.draw(LD_LIBRARY_PATH=folder), 1, "libEGL")
            self.assertFalse((self.folder / "a.png").exists())
        self.check_refused(self.draw(LD_LIBRARY_PATH=self.with_library(None)), 1, "libegl1", "libgl1", "libgl1-mesa-dri", "--engine soft")

    def test_without_the_libraries_of_a_context_one_line_says_so(self):
        """libEGL alone is not enough: libepoxy would end the process."""
        self.require_opengl()
        folder = self.folder / "lib"
        folder.mkdir()
        for name in ("libGL.so.1", "libOpenGL.so.0", "libGLESv2.so.2"):
            (folder / name).write_bytes(b"no library")
        self.check_refused(self.draw(LD_LIBRARY_PATH=str(folder)), 1, "libGL is missing", "libgl1")
        self.check_refused(self.draw(LD_LIBRARY_PATH=str(folder), RAKELIGHT_GL="es"), 1, "libGLESv2 is missing", "libgles2")
        result = self.draw("--verbose", engine="auto", LD_LIBRARY_PATH=str(folder))
        self.assertEqual(result.code, 0, result.err)
        self.assertIn("engine auto: it uses engine soft: libGL is missing", result.err)

    def test_auto_draws_without_opengl_and_everything_else_works(self):
        self.write("a.obj")
        folder = self.with_library(None)
        result = self.draw("--verbose", engine="auto", LD_LIBRARY_PATH=folder)
        self.assertEqual(result.code, 0, result.err)
        self.assertIn("engine auto: it uses engine soft: libEGL is missing", result.err)
        self.assertEqual(self.draw(engine="soft", LD_LIBRARY_PATH=folder).code, 0)


if __name__ == "__main__":
    program.main()
