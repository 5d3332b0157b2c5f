# SPDX-License-Identifier: Apache-2.0
"""When the program fails, one line says so and everything stays as it was."""
import os
import stat
import tempfile
import unittest

import bpy
import program
import scenes
from fix_seams_test import halves

SMOOTH = f'"{program.PATH}" "$@" > /dev/null\n'


class Failures(unittest.TestCase):
    def setUp(self):
        scenes.clear()
        self.objects = halves()
        self.objects[1].modifiers.new("finer", "SUBSURF")
        scenes.select(self.objects)
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def script(self, text):
        path = os.path.join(self.folder.name, "program")
        with open(path, "w") as file:
            file.write("#!/bin/sh\n" + text)
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
        return path

    def assert_fails(self, path, words, **options):
        scenes.set_program(path)
        before = [scenes.state(item) for item in self.objects]
        with self.assertRaises(RuntimeError) as caught:
            bpy.ops.rakelight.fix_seams(**options)
        lines = str(caught.exception).strip().splitlines()
        self.assertEqual(len(lines), 1, lines)
        self.assertIn(words, lines[0])
        self.assertEqual([scenes.state(item) for item in self.objects], before)
        self.assertEqual(len(bpy.data.meshes), 2)

    def test_no_program(self):
        self.assert_fails("/nowhere/rakelight", "/nowhere/rakelight: not a program")
        path, os.environ["PATH"] = os.environ["PATH"], self.folder.name
        try:
            self.assert_fails("", "not on the PATH")
        finally:
            os.environ["PATH"] = path

    def test_something_that_cannot_be_run(self):
        path = self.script("")
        with open(path, "w") as file:
            file.write("no program at all")
        self.assert_fails(path, "cannot be run")

    def test_exit_codes_and_signals(self):
        self.assert_fails(self.script("echo 'a reason' >&2; exit 1"), "a reason")
        self.assert_fails(self.script("exit 4"), "exit code 4")
        self.assert_fails(self.script("kill -9 $$"), "signal 9")

    def test_an_error_of_the_program_is_one_line_with_its_place(self):
        row = '{"rows": [{"error": {"message": "is bent", "place": "meshes[1]"}}]}'
        self.assert_fails(self.script(f"echo '{row}'; exit 4"), "rakelight: meshes[1]: is bent")

    def test_no_file_and_files_that_are_not_the_answer(self):
        self.assert_fails(self.script("exit 0"), "wrote no file")
        self.assert_fails(self.script('echo junk > "$4"'), "cannot be read back")
        self.assert_fails(self.script(SMOOTH + 'head -c 3000 "$4" > "$4.cut"; mv "$4.cut" "$4"'), "cannot be read back")
        self.assert_fails(self.script(f'"{program.PATH}" smooth builtin:cone -o "$4" > /dev/null'), "cannot be read back")

    def test_an_answer_to_another_question(self):
        kept = os.path.join(self.folder.name, "kept.glb")
        scenes.set_program(self.script(f'"{program.PATH}" "$@" > /dev/null; cp "$4" "{kept}"\n'))
        bpy.ops.rakelight.fix_seams()
        for vertex in self.objects[0].data.vertices:
            vertex.co *= 1.001
        self.assert_fails(self.script(f'cp "{kept}" "$4"'), "lower: vertices have moved")

    def test_with_modifiers_that_were_to_be_applied(self):
        self.assert_fails(self.script("exit 1"), "exit code 1", apply_modifiers=True)

    def test_a_position_that_is_not_finite(self):
        self.objects[0].data.vertices[7].co.x = float("nan")
        self.assert_fails(program.PATH, "lower: vertex 7")

    def test_nothing_that_could_be_fixed(self):
        scenes.select([scenes.add("empty", self.objects[0].data.copy())])
        bpy.context.selected_objects[0].data.clear_geometry()
        bpy.data.meshes[-1].name = "none"
        scenes.set_program(program.PATH)
        with self.assertRaisesRegex(RuntimeError, "empty has no faces"):
            bpy.ops.rakelight.fix_seams()

    def test_without_a_selection_it_says_what_to_select(self):
        scenes.set_program(program.PATH)
        scenes.select([])
        with self.assertRaisesRegex(RuntimeError, "Select mesh objects"):
            bpy.ops.rakelight.fix_seams()
        with self.assertRaisesRegex(RuntimeError, "Select objects"):
            bpy.ops.rakelight.export_glb(filepath=os.path.join(self.folder.name, "a.glb"))
        scenes.select(self.objects)
        bpy.ops.object.mode_set(mode="EDIT")
        with self.assertRaisesRegex(RuntimeError, "Switch to Object Mode"):
            bpy.ops.rakelight.fix_seams()

    def test_an_answer_without_counts_of_seams(self):
        for seams in ("null", "3", '{"flat_pairs": null}', "{}"):
            row = '{"rows": [{"seams": %s}]}' % seams
            scenes.set_program(self.script(f"{SMOOTH}echo '{row}'"))
            self.assertEqual(bpy.ops.rakelight.fix_seams(), {"FINISHED"})
