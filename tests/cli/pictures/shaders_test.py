#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""GLSL files that worlds name, and texts that would take a driver's compiler too much memory or time. Standard library only.

  shaders_test.py PROGRAM [unittest arguments]"""
import os
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

LIGHTING = ("RL_FN LightTerms user_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light)\n{\n"
            "    LightTerms terms = no_terms();\n    terms.diffuse = vec3(0.0f, 1.0f, 0.0f);\n    return terms;\n}\n")
VERTEX = "void user_vertex(RL_INOUT(Vertex) v)\n{\n}\n"
WORLD = "[[primitive]]\ntype = 'sphere'\n[render]\nengine = 'gl'\nresolution = [64, 48]\n{key} = '{file}'\n"
MOST_BYTES = 3 << 29


class Shaders(program.Case):
    def setUp(self):
        super().setUp()
        self.write("own.glsl", LIGHTING)
        self.write("move.glsl", VERTEX)
        self.write("w.scene.toml", WORLD.format(key="lighting", file="own.glsl"))
        self.write("v.scene.toml", WORLD.format(key="vertex-shader", file="move.glsl"))

    def run_program(self, *arguments, **environment):
        return super().run_program(*arguments, **{"RAKELIGHT_GL_CACHE": "off", **environment})

    def require_opengl(self):
        result = self.run_program("render", "builtin:sphere", "-o", "o.png", "--resolution", "8,8", "--engine", "gl")
        if result.code == 1:
            self.skipTest(result.err.strip())
        (self.folder / "o.png").unlink()

    def peak_of(self, *arguments):
        """(result, the largest memory of the program and of each program that it runs [bytes])"""
        done = subprocess.Popen([program.PROGRAM, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, env={**os.environ, "RAKELIGHT_GL_CACHE": "off"})
        out, err = done.stdout.read(), done.stderr.read()
        _, status, usage = os.wait4(done.pid, 0)  # of it and of those that it waited for
        done.returncode = os.waitstatus_to_exitcode(status)
        done.stdout.close(), done.stderr.close()
        return program.Result(subprocess.CompletedProcess([], done.returncode, out.decode(), err.decode())), usage.ru_maxrss * 1024


class Worlds(Shaders):
    def test_a_world_names_glsl_only_where_that_is_allowed(self):
        before = self.files()
        for command in (("render", "-o", "a.png"), ("explain", "--pixel", "3,3"), ("stages", "-o", "pages"), ("bench", "render"),
                        ("render", "--turntable", "3", "-o", "{frame}.png"), ("compare", "--engines", "gl,soft"), ("render", "--as-one", "-o", "a.png"),
                        ("thumbnail",)):
            for world, key in (("w", "lighting"), ("v", "vertex-shader")):
                last = ("t.png", "32") if command[0] == "thumbnail" else ()
                words = (command[:2] if command[0] == "bench" else command[:1]) + (f"{world}.scene.toml", *last) + command[2 if command[0] == "bench" else 1:]
                self.check_refused(self.run_program(*words), 4, f"{world}.scene.toml", "line 6, column 1", key, "--allow-shaders")
        self.assertEqual(self.files(), before, "nothing is written")

    def test_it_draws_where_it_is(self):
        self.require_opengl()
        result = self.run_program("render", "w.scene.toml", "-o", "a.png", "--allow-shaders")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(tuple(program.png(self.folder / "a.png")[3][24][96:99]), (0, 255, 0))
        self.assertEqual(self.run_program("render", "v.scene.toml", "-o", "b.png", "--allow-shaders").code, 0)

    def test_what_the_command_line_names_needs_no_leave(self):
        self.require_opengl()
        for arguments in (("builtin:sphere", "--engine", "gl", "--lighting", "own.glsl"), ("w.scene.toml", "--lighting", "own.glsl"),
                          ("w.scene.toml", "--lighting", "phong")):
            result = self.run_program("render", *arguments, "-o", "a.png", "--resolution", "8,8")
            self.assertEqual((result.code, result.err), (0, ""), arguments)

    def test_a_fifo_is_named_as_what_it_is(self):
        os.mkfifo(self.folder / "fifo.glsl")
        draw = ("render", "builtin:sphere", "--engine", "gl", "-o", "a.png", "--lighting")
        self.check_refused(self.run_program(*draw, "fifo.glsl"), 3, "'fifo.glsl' is not a regular file")
        self.check_refused(self.run_program(*draw, "none.glsl"), 3, "'none.glsl': there is no such file")

    def test_settings_of_the_users_own_may_name_glsl_but_those_of_worlds_not(self):
        self.require_opengl()
        render = "[render]\nengine = 'gl'\nlighting = 'own.glsl'\n"
        self.write("mine.toml", render)
        self.write("c.scene.toml", render)
        draw = ("render", "builtin:sphere", "-o", "a.png", "--resolution", "8,8", "--config")
        self.assertEqual(self.run_program(*draw, "mine.toml").code, 0)
        self.check_refused(self.run_program(*draw, "c.scene.toml"), 4, "line 3, column 1", "--allow-shaders")
        self.assertEqual(self.run_program(*draw, "c.scene.toml", "--allow-shaders").code, 0)

    def test_a_file_cannot_allow_it_to_itself(self):
        self.write("s.scene.toml", "[render]\nallow-shaders = true\nlighting = 'own.glsl'\n[[primitive]]\ntype = 'sphere'\n")
        self.check_refused(self.run_program("render", "s.scene.toml", "-o", "a.png"), 4, "line 2", "option of the command line only")

    def test_verbs_that_draw_nothing_read_the_world(self):
        for command in (("check", "w.scene.toml"), ("inspect", "w.scene.toml"), ("smooth", "w.scene.toml", "-o", "s.glb"), ("convert", "w.scene.toml", "-o", "c.glb")):
            result = self.run_program(*command)
            self.assertEqual(result.code, 0, result.err)

    def test_a_watched_world_says_it_too(self):
        running = subprocess.Popen([program.PROGRAM, "render", "w.scene.toml", "-o", "a.png", "--watch"], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        try:
            lines = [running.stderr.readline() for _ in range(2)]
        finally:
            running.terminate()
            running.communicate(timeout=60)
        self.assertTrue(any("--allow-shaders" in line for line in lines), lines)


class Bombs(Shaders):
    """Texts that took the driver's compiler 12 GB and minutes, or 4.7 GB."""

    def check_bomb(self, name, text, *words):
        self.write(name, text)
        self.write("b.scene.toml", WORLD.format(key="lighting", file=name))
        result, peak = self.peak_of("render", "b.scene.toml", "-o", "a.png")
        self.check_refused(result, 4, "b.scene.toml", "line 6", "--allow-shaders")
        self.assertLess(peak, 200 << 20)
        for arguments in (("b.scene.toml", "--allow-shaders"), ("builtin:sphere", "--engine", "gl", "--lighting", name)):
            result, peak = self.peak_of("render", *arguments, "-o", "a.png", "--resolution", "64,48")
            self.check_refused(result, 4, name, *words)
            self.assertLess(peak, MOST_BYTES)
        self.assertNotIn("a.png", self.files())

    def test_nested_macros(self):
        self.check_bomb("macro.glsl", "#define A(x) x x x x x x x x x x\n#define B(x) A(A(A(A(A(A(A(x)))))))\nfloat q=0.0;\nvoid g(){B(q+=1.0;)}\n" + LIGHTING,
                        "macro.glsl: line 4", "200000 tokens")

    def test_macros_that_double(self):
        doubling = "#define A0 x += 1.0;\n" + "".join(f"#define A{i + 1} A{i} A{i}\n" for i in range(30))
        self.check_bomb("double.glsl", doubling + LIGHTING.replace("    return", "    float x = 0.0; A30\n    return"), "double.glsl: line 36", "200000 tokens")

    def test_large_local_arrays(self):
        for declaration in ("float a[200000000];", "const int N = 1 << 28; float a[N];", "struct S { float a[1000][1000]; }; S a[3];"):
            self.check_bomb("arr.glsl", LIGHTING.replace("    return", f"    {declaration}\n    return"), "arr.glsl: line 5", "65536 numbers")

    def test_functions_that_double_pass_the_counts_and_end_in_the_check(self):
        self.require_opengl()
        calls = "float f0(float x) { return sin(x) * x; }\n" + "".join(f"float f{i + 1}(float x) {{ return f{i}(x) + f{i}(x * 1.1); }}\n" for i in range(30))
        self.write("calls.glsl", calls + LIGHTING.replace("    return", "    terms.diffuse *= f30(s.roughness);\n    return"))
        result, peak = self.peak_of("render", "builtin:sphere", "--engine", "gl", "--lighting", "calls.glsl", "-o", "a.png", "--resolution", "64,48")
        self.check_refused(result, 4, "calls.glsl", "needs more than 1024 MiB")
        self.assertLess(peak, MOST_BYTES)
        self.assertNotIn("a.png", self.files())


class Check(Shaders):
    """The process in which texts go through the driver first."""

    def setUp(self):
        super().setUp()
        self.require_opengl()

    def wrapper(self, body):
        path = self.write("check.sh", f"#!/bin/sh\n{body}\n")
        path.chmod(0o755)
        return str(path)

    def draw(self, *arguments, **environment):
        return self.run_program("render", "builtin:sphere", "--engine", "gl", "--resolution", "32,32", "-o", "a.png", *arguments, **environment)

    def test_a_text_is_checked_once_for_all_pictures(self):
        real = pathlib.Path(program.PROGRAM).parent / "rakelight-shader-check"
        counting = self.wrapper(f'echo x >> "{self.folder}/log"; exec "{real}" "$@"')
        result = self.run_program("render", "builtin:sphere", "--engine", "gl", "--lighting", "own.glsl", "--resolution", "32,32", "-o", "f{frame}.png",
                                  "--turntable", "5", RAKELIGHT_SHADER_CHECK=counting)
        self.assertEqual(result.code, 0, result.err)
        self.assertEqual((self.folder / "log").read_text(), "x\n")
        self.assertEqual(self.draw(RAKELIGHT_SHADER_CHECK=counting).code, 0)
        self.assertEqual((self.folder / "log").read_text(), "x\n", "without a text of the user's there is nothing to check")

    def test_one_that_is_not_there_or_misbehaves_is_one_line(self):
        lighting = ("--lighting", "own.glsl")
        self.check_refused(self.draw(*lighting, RAKELIGHT_SHADER_CHECK="/no/such"), 1, "RAKELIGHT_SHADER_CHECK names '/no/such'")
        self.check_refused(self.draw(*lighting, RAKELIGHT_SHADER_CHECK=self.wrapper("kill -SEGV $$")), 4, "own.glsl", "crashes on it")
        self.check_refused(self.draw(*lighting, RAKELIGHT_SHADER_CHECK=self.wrapper("kill -XCPU $$")), 4, "own.glsl", "more than 10 s")
        self.check_refused(self.draw(*lighting, RAKELIGHT_SHADER_CHECK=self.wrapper("echo maybe")), 1, "answers something else")
        away = shutil.copy(program.PROGRAM, self.folder / "rakelight")
        result = program.Result(subprocess.run([away, "render", "builtin:sphere", "--engine", "gl", "--lighting", "own.glsl", "-o", "a.png"],
                                               cwd=self.folder, capture_output=True, text=True, env={**os.environ, "RAKELIGHT_GL_CACHE": "off"}))
        if result.code != 0:  # else one is installed
            self.check_refused(result, 1, "rakelight-shader-check, which is not there", "RAKELIGHT_SHADER_CHECK")

    def test_the_check_writes_no_file_and_takes_only_what_it_is_given(self):
        real = pathlib.Path(program.PROGRAM).parent / "rakelight-shader-check"
        for words in ((), ("--memory", "0", "--seconds", "1"), ("--memory", "1000000000", "--seconds", "x")):
            done = subprocess.run([real, *words], capture_output=True, text=True, stdin=subprocess.DEVNULL)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("is started by rakelight", done.stderr)
        for text in (b"", b"12", b"99999\nvoid", b"-1\nvoid"):
            done = subprocess.run([real, "--memory", "1000000000", "--seconds", "10"], capture_output=True, input=text)
            self.assertEqual((done.returncode, done.stdout), (2, b""), text)


if __name__ == "__main__":
    program.main()
