#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Names that files chose, on the way to people: no verb writes control characters, line feeds of a name or what turns the direction
of writing to a terminal or a page; lists of names are cut; what the standard library throws is said in the program's words.

  foreign_text_test.py PROGRAM [unittest arguments]"""
import base64
import json
import pathlib
import struct
import sys
import unicodedata
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

ODD = "odd\n\033[31m\x9b\u202e\u2028\x7f<b>&"  # escape sequences of 7 and 8 bits, right-to-left override, line separator, markup
SMALL = ("--resolution", "32,24")


def model(name):
    """A glTF text in which everything has the name."""
    triangle = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    dot = base64.b64encode(bytes.fromhex("89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de0000000c4944415408d763f8ffff3f0005fe02"
                                         "fedccc59e70000000049454e44ae426082")).decode()
    return json.dumps({
        "asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "name": name, "intensity": 100}]}},
        "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + base64.b64encode(triangle).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
        "images": [{"uri": "data:image/png;base64," + dot, "name": name}], "textures": [{"source": 0, "name": name}],
        "materials": [{"name": name, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "meshes": [{"name": name, "primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        "cameras": [{"type": "perspective", "name": name, "perspective": {"yfov": 1, "znear": 0.1, "zfar": 10}}],
        "nodes": [{"name": name, "mesh": 0}, {"name": name, "camera": 0, "translation": [0.3, 0.3, 2]},
                  {"name": name + " light", "translation": [0.3, 0.3, 2], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
        "scenes": [{"nodes": [0, 1, 2]}], "scene": 0})


class ForeignText(program.Case):
    def setUp(self):
        super().setUp()
        self.file = ODD + ".gltf"
        self.write(self.file, model(ODD))

    def check_text(self, text, lines=None):
        odd = {f"U+{ord(c):04X}" for c in set(text) - {"\n"} if unicodedata.category(c) in ("Cc", "Cf", "Zl", "Zp", "Cs")}
        self.assertEqual(odd, set(), text)
        if lines is not None:
            self.assertEqual(len(text.splitlines()), lines, text)

    def check_run(self, *arguments, code=0, out_lines=None):
        result = self.run_program(*arguments)
        self.assertEqual(result.code, code, result.err)
        self.check_text(result.out, out_lines)
        self.check_text(result.err)
        for line in result.lines:
            self.assertTrue(line.startswith("rakelight: "), result.err)
        return result

    def test_check_says_names_of_files_cameras_and_lights_in_printable_lines(self):
        self.check_run("check", self.file, out_lines=3)
        self.check_run("check", "missing" + ODD, code=3, out_lines=0)

    def test_a_world_of_odd_names_is_checked_and_rendered_in_printable_lines(self):
        name = json.dumps(ODD)  # a TOML text, too
        world = ODD + ".scene.toml"
        (self.folder / world).write_text(f"[[model]]\nfile = {json.dumps(self.file)}\nname = {name}\n[[primitive]]\ntype = \"sphere\"\nname = {name}\n"
                                         f"[[material]]\nname = {name}\nmodel = {name}\nroughness = 1\n")
        self.check_run("check", world)
        self.check_run("render", world, "-o", "a.png", *SMALL, "--verbose", "--stats")

    def test_inspect_says_names_in_printable_lines(self):
        text = self.check_run("inspect", self.file).out
        self.assertIn("odd??[31m", text)
        self.check_run("inspect", self.file, "--check", "--closed", code=5)
        self.check_run("inspect", self.file, "--check")

    def test_json_holds_names_in_ascii_and_gives_them_back(self):
        for arguments in (("inspect", self.file), ("check", self.file), ("explain", self.file, *SMALL, "--pixel", "16,12"),
                          ("render", self.file, "-o", "a.png", *SMALL), ("bench", "render", self.file, "--frames", "1", *SMALL)):
            result = self.run_program(*arguments, "--json")
            self.assertEqual(result.code, 0, result.err)
            self.assertEqual([c for c in result.out if c != "\n" and not " " <= c <= "~"], [], arguments[0])
            self.assertIn(json.dumps(ODD)[1:-1], json.dumps(json.loads(result.out)), arguments[0])

    def test_explain_render_smooth_and_bench_say_names_in_printable_lines(self):
        self.assertIn("odd??[31m", self.check_run("explain", self.file, *SMALL, "--pixel", "16,12", "--camera-index", "0").out)
        self.check_run("render", self.file, "-o", ODD + ".png", *SMALL, "--verbose", "--stats")
        self.check_run("smooth", self.file, "-o", ODD + ".glb", "--verbose")
        self.check_run("bench", "render", self.file, "--frames", "1", *SMALL)

    def test_a_page_of_stages_holds_names_without_markup_and_control_characters(self):
        self.check_run("stages", self.file, "-o", "out", *SMALL, "--camera-index", "0", "--verbose")
        page = (self.folder / "out/index.html").read_text()
        self.check_text(page)
        self.assertIn("odd??[31m", page)
        self.assertIn("&lt;b&gt;&amp;", page)
        self.assertNotIn("<b>", page)

    def test_lists_of_names_are_cut_and_have_no_doubles(self):
        parts = "".join(f'[[primitive]]\ntype = "sphere"\nname = "part_{i // 3}"\n' for i in range(120))
        self.write("many.scene.toml", parts + '[[material]]\nname = "m"\nmodel = "nothing like that"\nroughness = 1\n')
        self.check_refused(self.run_program("check", "many.scene.toml"), 4, "there is part_0, part_1, part_2, part_3, part_4 and 35 more")

    def test_notes_that_are_left_out_are_not_called_warnings(self):
        many = json.loads(model("x"))
        many["meshes"][0]["primitives"][0]["attributes"].update({f"A{i}": 0 for i in range(1100)})  # a note each
        self.write("notes.gltf", json.dumps(many))
        self.assertEqual(self.check_run("check", "notes.gltf").err, "")
        lines = self.check_run("check", "notes.gltf", "--verbose").lines
        self.assertTrue(lines[-1].startswith("rakelight: note: notes.gltf: ... "), lines[-1])
        self.assertFalse([line for line in lines if "warning" in line])

    def test_files_that_ask_for_too_much_memory_are_refused_in_our_words(self):
        cube = "".join(f"\t\t\t*MESH_VERTEX {i} {i & 1} {i >> 1 & 1} {i >> 2}\n" for i in range(8))
        self.write("count.ase", "*3DSMAX_ASCIIEXPORT 200\n*GEOMOBJECT {\n\t*MESH {\n\t\t*MESH_NUMVERTEX 2147483648\n\t\t*MESH_NUMFACES 0\n"
                                f"\t\t*MESH_VERTEX_LIST {{\n{cube}\t\t}}\n\t}}\n}}\n")
        self.check_refused(self.run_program("check", "count.ase"), 4, "count.ase: line 4: *MESH_NUMVERTEX promises 2147483648 entries")
        self.write("list.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                               "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n2147483648 0 1 2\n")
        self.check_refused(self.run_program("check", "list.ply"), 4, "list.ply: line 13: a list of element 'face' promises 2147483648 numbers")

    @unittest.skipIf(program.SANITIZED, "a sanitized helper runs without a limit of the address space")
    def test_a_lack_of_memory_that_only_the_helper_sees_is_said_with_the_limit(self):
        self.write("array.dae", '<?xml version="1.0"?>\n<COLLADA version="1.4.1"><library_geometries><geometry id="g"><mesh><source id="s">'
                                '<float_array id="a" count="4000000000">0 0 0</float_array></source></mesh></geometry></library_geometries></COLLADA>\n')
        self.check_refused(self.run_program("check", "array.dae", "--max-memory", "1G"), 4, "array.dae: reading it takes more memory than the limit of 768 MiB")


if __name__ == "__main__":
    program.main()
