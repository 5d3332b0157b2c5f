#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Parts that a build may leave out (docs/library.md): each works, or ends with one line that names the part and the option that builds
it, as --version says. Runs over builds of any options.

  left_out_test.py PROGRAM [unittest arguments]"""
import base64
import json
import pathlib
import struct
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

SMALL = ("--resolution", "32,24")
X = "xof 0303txt 0032\nMesh m {\n 3;\n 0.0;0.0;0.0;,\n 1.0;0.0;0.0;,\n 0.0;1.0;0.0;;\n 1;\n 3;0,1,2;;\n}\n"


def packed_model(extension):
    """A glTF whose compressed data are no data of that kind: who can read it says so, who cannot says that."""
    data = "data:application/octet-stream;base64," + base64.b64encode(struct.pack("<9f", *range(9))).decode()
    view = {"buffer": 0, "byteLength": 36}
    primitive = {"attributes": {"POSITION": 0}, "indices": 1}
    accessors = [{"componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                 {"componentType": 5125, "count": 3, "type": "SCALAR"}]
    if extension == "KHR_draco_mesh_compression":
        primitive["extensions"] = {extension: {"bufferView": 0, "attributes": {"POSITION": 0}}}
    else:
        view["extensions"] = {extension: {"buffer": 0, "byteLength": 36, "byteStride": 12, "mode": "ATTRIBUTES", "count": 3}}
        accessors[0]["bufferView"] = 0
        del primitive["indices"]
    return json.dumps({
        "asset": {"version": "2.0"}, "extensionsUsed": [extension], "extensionsRequired": [extension],
        "buffers": [{"byteLength": 36, "uri": data}], "bufferViews": [view], "accessors": accessors,
        "meshes": [{"primitives": [primitive]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0})


class LeftOut(program.Case):
    def is_left_out(self, part):
        lines = [line for line in self.run_program("--version").out.splitlines() if line.startswith("left out:")]
        return bool(lines) and part in lines[0].split(":")[1].replace(",", " ").split()

    def check(self, part, option, arguments, other_error=None):
        """Left out: a line that names the option. Else the run works, or says `other_error`."""
        result = self.run_program(*arguments)
        if self.is_left_out(part):
            self.assertNotEqual(result.code, 0, result.err)
            self.assertIn(option, result.err)
        elif other_error:
            self.assertIn(other_error, result.err)
            self.assertNotIn("leaves", result.err)
        else:
            self.assertEqual(result.code, 0, result.err)

    def test_draco(self):
        self.write("packed.gltf", packed_model("KHR_draco_mesh_compression"))
        self.check("draco", "-DRAKELIGHT_DRACO=ON", ["packed.gltf", "-o", "a.png", *SMALL], "is not a Draco mesh")

    def test_meshopt(self):
        self.write("packed.gltf", packed_model("EXT_meshopt_compression"))
        self.check("meshopt", "-DRAKELIGHT_MESHOPT=ON", ["packed.gltf", "-o", "a.png", *SMALL], "its meshopt data is broken")

    def test_subdivision(self):
        self.check("subdivision", "-DRAKELIGHT_SUBDIVISION=ON",
                   ["render", "builtin:teapot", "--subdivide", "1", "-o", "a.png", *SMALL])

    def test_pictures(self):
        self.check("webp", "-DRAKELIGHT_WEBP=ON", ["render", "builtin:teapot", "-o", "a.webp", *SMALL])
        self.check("exr", "-DRAKELIGHT_OPENEXR=ON", ["render", "builtin:teapot", "-o", "a.exr", *SMALL])
        self.check("exr", "-DRAKELIGHT_OPENEXR=ON", ["render", "builtin:teapot", "-o", "a.png", "--channels", "depth", *SMALL])

    def test_import(self):
        self.write("a.x", X)
        self.check("import", "-DRAKELIGHT_IMPORT=ON", ["a.x", "-o", "a.png", *SMALL])

    def test_engines(self):
        result = self.run_program("render", "builtin:teapot", "-o", "a.png", "--engine", "trace", *SMALL)
        if self.is_left_out("trace"):
            self.assertIn("'trace' is not built in", result.err)
        else:
            self.assertTrue(result.code == 0 or "Embree" in result.err, result.err)
        result = self.run_program("render", "builtin:teapot", "-o", "a.png", "--engine", "gl", *SMALL)
        if self.is_left_out("gl"):
            self.assertIn("'gl' is not built in", result.err)
        else:
            self.assertNotIn("not built in", result.err)

    def test_formats_of_version(self):
        text = self.run_program("--version").out
        written = [line for line in text.splitlines() if line.startswith("pictures written:")][0]
        self.assertEqual("WebP" in written, not self.is_left_out("webp"))
        self.assertEqual("EXR" in written, not self.is_left_out("exr"))
        self.assertEqual("FBX" in text, not self.is_left_out("import"))


if __name__ == "__main__":
    program.main()
