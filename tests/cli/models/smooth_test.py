#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `rakelight smooth`: exit codes, several models, JSON, and the Khronos validator where it is installed.

  smooth_test.py PROGRAM [unittest arguments]"""
import base64
import json
import os
import pathlib
import resource
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

HERE = pathlib.Path(__file__).resolve().parents[1]
SHARED = pathlib.Path(os.environ.get("RAKELIGHT_SHARED", HERE.parent.parent.parent / "shared"))
TWO_PARTS = "o left\nv -1 0 0\nv 0 0 0\nv 0 1 0.5\nv -1 1 0\nf 1 2 3 4\no right\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nf 5 6 7 8\n"
OTHER_FORMATS = {".obj", ".fbx", ".stl", ".ply", ".dae", ".3ds", ".ase", ".blend", ".off", ".x"}


def quantized_corner(component, code, stride):
    """Three faces of a cube's corner over four vertices, normals as normalized integers of `stride` / 4 bytes."""
    largest = 127 if code == "b" else 32767
    positions = struct.pack("<12f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1)
    normals = struct.pack("<" + 4 * f"4{code}", *(4 * [0, 0, largest, 0]))
    indices = struct.pack("<9H", 0, 2, 1, 0, 1, 3, 0, 3, 2)
    data = positions + normals + indices
    view = lambda at, length, **more: {"buffer": 0, "byteOffset": at, "byteLength": length, **more}  # noqa: E731
    return {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "extensionsUsed": ["KHR_mesh_quantization"], "extensionsRequired": ["KHR_mesh_quantization"],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
                          {"bufferView": 1, "componentType": component, "normalized": True, "count": 4, "type": "VEC3"},
                          {"bufferView": 2, "componentType": 5123, "count": 9, "type": "SCALAR"}],
            "bufferViews": [view(0, 48), view(48, len(normals), byteStride=stride), view(48 + len(normals), 18)],
            "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}


class Smooth(program.Case):
    def setUp(self):
        super().setUp()
        self.dir = self.folder
        (self.dir / "parts.obj").write_text(TWO_PARTS)

    def run_program(self, *arguments):
        return subprocess.run([program.PROGRAM, *map(str, arguments)], cwd=self.dir, capture_output=True, text=True, timeout=300)

    def test_seams_are_there_before_and_gone_after(self):
        def seam(name):
            rows = json.loads(self.run_program("inspect", name, "--normals", "file", "--json").stdout)["rows"]
            return max(b["largest_deg"] for b in rows[0]["borders"])
        self.assertEqual(self.run_program("smooth", "parts.obj", "-o", "object.obj", "--scope", "object", "--crease-angle", "180").returncode, 0)
        self.assertEqual(self.run_program("smooth", "object.obj", "-o", "model.obj", "--normals", "model", "--crease-angle", "180").returncode, 0)
        self.assertGreater(seam("object.obj"), 5)
        self.assertEqual(seam("model.obj"), 0)

    def test_the_files_of_a_model_stay_together_behind_a_link(self):
        (self.dir / "in.gltf").write_text(json.dumps(quantized_corner(5120, "b", 4)))
        (self.dir / "real").mkdir()
        (self.dir / "out.gltf").symlink_to("real/model.gltf")
        done = self.run_program("smooth", "in.gltf", "-o", "out.gltf", "--normals", "model", "--crease-angle", "180", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue((self.dir / "out.gltf").is_symlink())
        self.assertEqual(sorted(p.name for p in (self.dir / "real").iterdir()), ["model.bin", "model.gltf"])
        self.assertEqual(self.run_program("check", "real/model.gltf").returncode, 0)

    def test_a_full_disk_leaves_the_older_model_and_its_data(self):
        model = quantized_corner(5120, "b", 4)
        model["extras"] = "x" * 500000  # the model file fails, its data would still fit
        (self.dir / "in.gltf").write_text(json.dumps(model))
        self.assertEqual(self.run_program("smooth", "in.gltf", "-o", "out.gltf", "--normals", "model", "--crease-angle", "180").returncode, 0)
        older = {p.name: p.read_bytes() for p in self.dir.iterdir()}
        self.assertIn("out.bin", older)
        arguments = (program.PROGRAM, "smooth", "in.gltf", "-o", "out.gltf", "--normals", "model", "--crease-angle", "1")
        done = subprocess.run(arguments, cwd=self.dir, capture_output=True, text=True, timeout=300,
                              restore_signals=False,  # the signal of the limit stays ignored: writing fails, as on a full disk
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100000, 100000)))
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        self.assertEqual({p.name: p.read_bytes() for p in self.dir.iterdir()}, older)
        self.assertEqual(subprocess.run(arguments, cwd=self.dir, timeout=300).returncode, 0)
        self.assertNotEqual((self.dir / "out.bin").read_bytes(), older["out.bin"])

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
        for more in (["-o", "x.stl"], ["-o", "x.obj", "--scope", "all"], ["-o", "x.obj", "--normals", "file"], ["--preview", "x.html", "-o", "x.obj"], ["-o", "x.obj", "--crease-angle", "181"],
                     ["-o", "x.obj", "--weld-distance", "-1"], ["-o", "x.obj", "--tangents", "some"], []):
            done = self.run_program("smooth", "parts.obj", *more)
            self.assertEqual(done.returncode, 2, more)
            self.assertEqual(len(done.stderr.splitlines()), 1, more)
        self.assertIn("STL cannot store vertex normals", self.run_program("smooth", "parts.obj", "-o", "x.stl").stderr)
        self.assertEqual(os.listdir(self.dir), ["parts.obj"])

    def test_an_output_that_cannot_be_written_leaves_nothing(self):
        done = self.run_program("smooth", "parts.obj", "-o", "parts.obj/such/folder.obj")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(os.listdir(self.dir), ["parts.obj"])

    def validate(self, pairs):
        node = shutil.which("node")
        if not node:
            self.skipTest("node is not installed")
        (self.dir / "pairs.json").write_text(json.dumps([[a and str(a), str(b)] for a, b in pairs]))
        done = subprocess.run([node, HERE / "support" / "gltf_validate.mjs", self.dir / "pairs.json"], cwd=os.environ.get("RAKELIGHT_NODE_DIR"),
                              capture_output=True, text=True, timeout=600)
        if done.returncode == 77:
            self.skipTest(done.stdout.strip())
        return done

    def smoothed(self, model, ending, *more):
        """The model smoothed into a folder of its own."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.dir))
        out = folder / ("out" + ending)
        done = self.run_program("smooth", model, "-o", out, *more)
        self.assertEqual(done.returncode, 0, f"{model}: {done.stderr}")
        return out

    def models(self, endings):
        refused = json.loads((HERE.parent / "acceptance" / "refused_models.json").read_text())
        assets = SHARED / "assets"
        return [p for p in sorted(assets.rglob("*")) if p.suffix.lower() in endings and str(p.relative_to(assets)) not in refused]

    def test_the_khronos_validator_finds_no_new_error(self):
        self.validate([])  # skips the test where the validator is not there
        pairs = [(model, self.smoothed(model, model.suffix, "--normals", normals, "--tangents", tangents, "--crease-angle", crease))
                 for model in self.models({".glb", ".gltf"})
                 for normals, tangents, crease in (("seams", "auto", "60"), ("model", "auto", "60"), ("model", "always", "0"))]
        pairs += [(None, self.smoothed(model, ".glb")) for model in self.models(OTHER_FORMATS)]
        pairs += [(model, self.smoothed(model, ".glb")) for model in self.models({".gltf"})]
        pairs += [(None, self.smoothed("builtin:teapot", ".glb")), (None, self.smoothed("parts.obj", ".glb"))]
        done = self.validate(pairs)
        print(done.stdout.strip().splitlines()[-1])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_khronos_validator_finds_no_error_in_quantized_normals(self):
        self.validate([])
        pairs = []
        for component, code, width in ((5120, "b", 4), (5122, "h", 8)):
            model = self.dir / f"quantized{width}.gltf"
            model.write_text(json.dumps(quantized_corner(component, code, width)))
            for ending in (".gltf", ".glb"):
                out = self.smoothed(model, ending, "--normals", "model", "--crease-angle", "180")
                self.assertNotEqual(out.stat().st_size, 0)
                pairs.append((model, out))
        done = self.validate(pairs)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_validator_script_finds_an_error_that_is_there(self):
        broken = {"asset": {"version": "2.0"}, "nodes": [{"mesh": 7}]}
        (self.dir / "broken.gltf").write_text(json.dumps(broken))
        done = self.validate([(None, self.dir / "broken.gltf")])
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)


if __name__ == "__main__":
    program.main()
