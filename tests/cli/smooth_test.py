#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `rakelight smooth`: exit codes, several models, JSON, and the Khronos validator where it is installed.

  smooth_test.py PROGRAM [unittest arguments]"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
HERE = pathlib.Path(__file__).resolve().parent
SHARED = pathlib.Path(os.environ.get("RAKELIGHT_SHARED", HERE.parent.parent.parent / "shared"))
TWO_PARTS = "o left\nv -1 0 0\nv 0 0 0\nv 0 1 0.5\nv -1 1 0\nf 1 2 3 4\no right\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nf 5 6 7 8\n"


class Smooth(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.dir)
        (self.dir / "parts.obj").write_text(TWO_PARTS)

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.dir, capture_output=True, text=True, timeout=300)

    def test_seams_are_there_before_and_gone_after(self):
        def seam(name):
            rows = json.loads(self.run_program("inspect", name, "--normals", "file", "--json").stdout)["rows"]
            return max(b["largest_deg"] for b in rows[0]["borders"])
        self.assertEqual(self.run_program("smooth", "parts.obj", "-o", "object.obj", "--scope", "object", "--crease-angle", "180").returncode, 0)
        self.assertEqual(self.run_program("smooth", "object.obj", "-o", "model.obj", "--crease-angle", "180").returncode, 0)
        self.assertGreater(seam("object.obj"), 5)
        self.assertEqual(seam("model.obj"), 0)

    def test_several_models_and_json(self):
        (self.dir / "more.obj").write_text(TWO_PARTS)
        (self.dir / "out").mkdir()
        done = self.run_program("smooth", "parts.obj", "more.obj", "none.obj", "-o", "out/{model}.glb", "--json")
        self.assertEqual(done.returncode, 3)
        document = json.loads(done.stdout)
        self.assertEqual(document["schema"], "rakelight.smooth/1")
        self.assertEqual([r["file"] for r in document["rows"]], ["parts.obj", "more.obj", "none.obj"])
        self.assertEqual(document["rows"][2]["error"]["exit_code"], 3)
        self.assertEqual([m["name"] for m in document["rows"][0]["meshes"]], ["left", "right"])
        self.assertEqual(sorted(os.listdir(self.dir / "out")), ["more.glb", "parts.glb"])

    def test_wrong_usage_is_one_line_and_exit_code_2(self):
        for more in (["-o", "x.stl"], ["-o", "x.obj", "--scope", "all"], ["-o", "x.obj", "--crease-angle", "181"],
                     ["-o", "x.obj", "--weld-distance", "-1"], ["-o", "x.obj", "--tangents", "some"], []):
            done = self.run_program("smooth", "parts.obj", *more)
            self.assertEqual(done.returncode, 2, more)
            self.assertEqual(len(done.stderr.splitlines()), 1, more)
        self.assertEqual(os.listdir(self.dir), ["parts.obj"])

    def test_an_output_that_cannot_be_written_leaves_nothing(self):
        done = self.run_program("smooth", "parts.obj", "-o", "no/such/folder.obj")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(os.listdir(self.dir), ["parts.obj"])

    def validate(self, pairs):
        node = shutil.which("node")
        if not node:
            self.skipTest("node is not installed")
        (self.dir / "pairs.json").write_text(json.dumps([[a and str(a), str(b)] for a, b in pairs]))
        done = subprocess.run([node, HERE / "gltf_validate.mjs", self.dir / "pairs.json"], cwd=os.environ.get("RAKELIGHT_NODE_DIR"),
                              capture_output=True, text=True, timeout=600)
        if done.returncode == 77:
            self.skipTest(done.stdout.strip())
        return done

    def test_the_khronos_validator_finds_no_new_error(self):
        models = [p for f in ("gltf", "generator", "derived", "crossformat") for p in sorted((SHARED / "assets" / f).rglob("*"))
                  if p.suffix in (".glb", ".gltf")]
        pairs = []
        for i, model in enumerate(models):
            folder = self.dir / str(i)
            folder.mkdir()
            out = folder / ("out" + model.suffix)
            self.assertEqual(self.run_program("smooth", model, "-o", out, "--tangents", "always").returncode, 0, model)
            pairs.append((model, out))
        self.assertEqual(self.run_program("smooth", "parts.obj", "-o", "parts.glb").returncode, 0)
        self.assertEqual(self.run_program("smooth", "builtin:teapot", "-o", "teapot.glb").returncode, 0)
        pairs += [(None, self.dir / "parts.glb"), (None, self.dir / "teapot.glb")]
        done = self.validate(pairs)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_validator_script_finds_an_error_that_is_there(self):
        broken = {"asset": {"version": "2.0"}, "nodes": [{"mesh": 7}]}
        (self.dir / "broken.gltf").write_text(json.dumps(broken))
        done = self.validate([(None, self.dir / "broken.gltf")])
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
