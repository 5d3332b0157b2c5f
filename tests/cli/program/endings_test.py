#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Endings of names mean the same in capitals, in every subcommand: equal bytes, or equal text.

  endings_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

CLIP = pathlib.Path(__file__).resolve().parents[3] / "data/knight/Knight_noNormals.glb"
SIZE = ("--resolution", "48,32")


class Endings(program.Case):
    def setUp(self):
        super().setUp()
        self.write("parts.obj", program.TWO_PARTS)
        for folder in ("small", "LARGE"):
            (self.folder / folder).mkdir()

    def both(self, *words):
        """Runs the words with NAME in small letters and in capitals; the two files. Skips what this build has not."""
        names = []
        for folder, change in (("small", str.lower), ("LARGE", str.upper)):
            made = [folder + "/" + pathlib.Path(w[1:]).stem + change(pathlib.Path(w[1:]).suffix) if w.startswith("@") else w for w in words]
            result = self.run_program(*made)
            if folder == "small" and result.code == 4 and "was built without" in result.err:
                return None
            self.assertEqual(result.code, 0, f"{made}: {result.err}")
            names += [self.folder / m for m, w in zip(made, words) if w.startswith("@")]
        return names

    def same(self, *words):
        with self.subTest(words=words):
            names = self.both(*words)
            if names is None:
                return
            half = len(names) // 2
            for small, large in zip(names[:half], names[half:]):
                self.assertNotEqual(small.suffix, large.suffix)
                self.assertEqual(small.read_bytes(), large.read_bytes(), f"{small} {large}")

    def test_models(self):
        for kind in ("glb", "gltf", "obj", "ply"):
            self.same("smooth", "parts.obj", "-o", "@out." + kind)
        self.assertTrue((self.folder / "LARGE/out.GLTF").read_text().startswith("{"))
        self.assertEqual((self.folder / "LARGE/out.GLB").read_bytes()[:4], b"glTF")
        self.same("smooth", "small/out.glb", "-o", "@again.gltf")
        self.same("radiosity", "builtin:plane", "--light", "point:0,1,0", "-o", "@lit.glb", "--radiosity-elements", "100")
        self.same("bench", "render", "builtin:plane", "--engine", "soft", *SIZE, "--frames", "1", "--export", "@scene.glb")

    def test_models_are_read(self):
        for kind in ("glb", "gltf", "obj", "ply"):
            self.both("smooth", "parts.obj", "-o", "@out." + kind)
            rows = [json.loads(self.run_program("inspect", f"{folder}/out.{change(kind)}", "--json").out)["rows"][0]
                    for folder, change in (("small", str.lower), ("LARGE", str.upper))]
            self.assertEqual(rows[0]["triangles"], rows[1]["triangles"])

    def test_pictures(self):
        for kind in ("png", "jpg", "jpeg", "webp", "ppm", "exr", "hdr"):
            self.same("render", "builtin:plane", *SIZE, "-o", "@p." + kind)
        self.same("render", "builtin:plane", *SIZE, "--turntable", "2", "--fps", "2", "-o", "@t.apng")
        self.same("bake", "builtin:sphere:tolerance=0.02", "builtin:sphere:tolerance=0.1", "--size", "16", "-o", "@n.png", "--model", "@m.glb")
        self.same("bake", "builtin:sphere:tolerance=0.02", "builtin:sphere:tolerance=0.1", "--size", "16", "-o", "@n.exr")
        for kind in ("png", "exr"):
            self.run_program("render", "builtin:plane", *SIZE, "-o", "a." + kind)
            self.run_program("render", "builtin:teapot", *SIZE, "-o", "b." + kind)
            self.same("compare", "a." + kind, "b." + kind, "--difference", "absolute", "-o", "@d." + kind)

    def test_reports(self):
        self.same("explain", "parts.obj", *SIZE, "--pixel", "24,16", "-o", "@e.json")
        json.loads((self.folder / "LARGE/e.JSON").read_text())
        self.both("inspect", "parts.obj", "--report", "@r.xml", "--report", "@r.html", "--max-seam", "180", *SIZE)
        self.both("smooth", "parts.obj", "--preview", "@s.html")
        self.both("stages", "parts.obj", *SIZE, "--single-file", "-o", "@stages.html")
        self.run_program("render", "builtin:plane", *SIZE, "-o", "a.png")
        self.both("compare", "a.png", "a.png", "-o", "@page.html")

    def test_windows_are_joined(self):
        for x, name in ((0, "L.PNG"), (24, "R.PNG")):
            self.run_program("render", "builtin:teapot", *SIZE, "--window", f"{x},0,24,32", "-o", name)
        self.run_program("render", "builtin:teapot", *SIZE, "-o", "whole.png")
        result = self.run_program("join-windows", "L.PNG", "R.PNG", "-o", "J.PNG")
        self.assertEqual(result.code, 0, result.err)
        self.assertEqual((self.folder / "J.PNG").read_bytes(), (self.folder / "whole.png").read_bytes())

    def test_a_sequence_goes_on_by_the_pictures_that_are_there(self):
        for _ in range(2):
            result = self.run_program("render", CLIP, *SIZE, "--turntable", "2", "--skip-existing", "-o", "F{frame}.PNG", "--json")
            self.assertEqual(result.code, 0, result.err)
        (self.folder / "F1.PNG").write_bytes(b"cut off")
        self.run_program("render", CLIP, *SIZE, "--turntable", "2", "--skip-existing", "-o", "F{frame}.PNG")
        self.assertEqual(program.png(self.folder / "F1.PNG")[:2], (48, 32))


if __name__ == "__main__":
    program.main()
