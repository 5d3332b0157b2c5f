#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `rakelight stages`: everything is written or nothing, pages and tables agree with the program's other words.

  stages_test.py PROGRAM [unittest arguments]"""
import html.parser
import json
import pathlib

import program

SIZE = "96,64"
STAGES = ["model", "world", "camera", "clip-space", "clipped", "device", "screen", "culled", "coverage", "depth", "depth-precision", "visibility", "normal",
          "lighting", "picture"]


class Links(html.parser.HTMLParser):
    """What a page refers to, and whether its elements close."""

    def __init__(self, text):
        super().__init__()
        self.found, self.open, self.tags = [], [], set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.add(tag)
        self.found += [value for name, value in attrs if name in ("href", "src")]
        if tag not in ("meta", "img", "br", "link"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag


class Stages(program.Case):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out"

    def stages(self, *options, model="builtin:teapot"):
        run = self.run_program("stages", model, "-o", self.out, "--resolution", SIZE, *options)
        self.assertEqual(run.code, 0, run.err)
        return run

    def table(self, stage):
        return json.loads((self.out / f"{stage}.json").read_text())

    def test_the_page_shows_all_stages_in_order_and_every_link_is_there(self):
        self.stages()
        text = (self.out / "index.html").read_text()
        places = [text.index(f'<section id="{stage}">') for stage in STAGES]
        self.assertEqual(places, sorted(places))
        links = Links(text)
        self.assertEqual(links.open, [])
        self.assertNotIn("script", links.tags)
        for link in links.found:
            target = text.count(f'id="{link[1:]}"') if link.startswith("#") else (self.out / link).is_file()
            self.assertTrue(target, link)
        listed = json.loads((self.out / "stages.json").read_text())["files"]
        self.assertEqual(set(listed) | {"stages.json"}, {p.name for p in self.out.iterdir()})

    def test_the_page_names_the_model_without_its_folder(self):
        (self.folder / "sub").mkdir()
        self.stages(model=self.write("sub/a & b.obj"))
        text = (self.out / "index.html").read_text()
        self.assertIn("<title>a &amp; b.obj: stages</title>", text)
        self.assertIn("<h1>a &amp; b.obj: from", text)
        self.assertNotIn(str(self.folder), text)

    def test_counts_are_those_of_render(self):
        self.stages()
        run = self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE, "--json")
        stats = json.loads(run.out)["rows"][0]
        numbers = self.table("culled")["numbers"]
        self.assertEqual(numbers["triangles in"], numbers["outside, or no pixel center in their box"] + numbers["without area"] +
                         numbers["facing the wrong way"] + numbers["drawn, pieces counted"])
        self.assertEqual(numbers["triangles in"], stats["triangles"])
        coverage = self.table("coverage")
        self.assertEqual(sum(row[1] for row in coverage["rows"]), 96 * 64)
        self.assertEqual(sum(n * pixels for n, pixels in coverage["rows"]), coverage["numbers"]["times covered, all pixels"])

    def test_the_picture_is_the_rendered_one(self):
        self.stages()
        self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE)
        self.assertEqual((self.out / "picture.png").read_bytes(), (self.folder / "a.png").read_bytes())

    def test_vertices_agree_from_space_to_space(self):
        self.stages()
        clip, device, screen = (self.table(s)["rows"] for s in ("clip-space", "device", "screen"))
        self.assertGreater(len(clip), 10)
        for c, d, s in zip(clip, device, screen):
            self.assertEqual(c[:2], d[:2])
            self.assertAlmostEqual(c[2] / c[4], d[2], places=9)
            self.assertAlmostEqual((d[2] * 0.5 + 0.5) * 96, s[2], places=6)
            self.assertAlmostEqual((0.5 - d[3] * 0.5) * 64, s[3], places=6)
            self.assertLessEqual(abs(s[2] * 256 - s[4]), 0.5)

    def test_a_triangle_through_the_eye_plane_is_clipped_and_listed(self):
        (self.folder / "a.obj").write_text("v -1 -1 -5\nv 1 -1 -5\nv 0 0 5\nf 1 2 3\n")
        self.stages("--camera-position", "0,1,0", "--camera-focal-point", "0,0,-3", model="a.obj")
        table = self.table("clipped")
        self.assertEqual(table["numbers"]["triangles clipped"], 1)
        self.assertEqual(table["numbers"]["passing, not wholly outside: near"], 1)
        self.assertEqual(table["rows"][0][2], 4)
        self.assertTrue(all(corner[2] > 0 for corner in table["rows"][0][3]))

    def test_only_own_and_empty_folders_are_replaced(self):
        self.out.mkdir()
        self.stages()
        self.stages()
        (self.out / "mine.txt").write_text("keep")
        before = {p.name: p.stat().st_mtime_ns for p in self.out.iterdir()}
        run = self.run_program("stages", "builtin:teapot", "-o", self.out, "--resolution", SIZE)
        self.assertEqual(run.code, 1)
        self.assertIn("mine.txt", run.err)
        self.assertEqual({p.name: p.stat().st_mtime_ns for p in self.out.iterdir()}, before)
        (self.folder / "file").write_text("keep")
        self.assertEqual(self.run_program("stages", "builtin:teapot", "-o", "file", "--resolution", SIZE).code, 1)
        (self.folder / "other").mkdir()
        (self.folder / "other" / "stages.json").write_text('{"schema": "rakelight.stages/1", "files": 3}')
        self.assertEqual(self.run_program("stages", "builtin:teapot", "-o", "other", "--resolution", SIZE).code, 1)

    def test_nothing_is_left_of_what_fails(self):
        for arguments in (("none.obj", "-o", "out"), ("builtin:teapot", "-o", "no/such/out"), ("builtin:teapot", "-o", "out", "--camera-index", "9"),
                          ("builtin:teapot", "-o", "out", "--resolution", "65536,65536")):
            run = self.run_program("stages", *arguments)
            self.assertNotEqual(run.code, 0)
            self.assertEqual(len(run.err.splitlines()), 1, run.err)
            self.assertEqual(list(self.folder.iterdir()), [], arguments)

    def test_the_depth_is_as_fine_as_the_formula_says(self):
        model = pathlib.Path(__file__).resolve().parents[2] / "data/visibility/near_planes.gltf"
        self.stages("--camera-index", "1", model=model)  # near 1 m, far 1000 m
        table = self.table("depth-precision")
        self.assertAlmostEqual(table["numbers"]["share of the depths in the first 2 % of the range"], 0.9533, 4)
        self.assertAlmostEqual(table["numbers"]["part of the range that 98 % of the depths reach"], 0.0467, 4)
        for distance, depth, *steps in table["rows"]:
            self.assertAlmostEqual(depth, 1000 * (distance - 1) / (distance * 999), 12)
            slope = 1000 / (999 * distance ** 2)
            for step, bits in zip((steps[0], steps[1], steps[3]), (16, 24, 32)):
                self.assertAlmostEqual(step * slope * (2 ** bits - 1), 1, 9)

    def test_json_lists_the_files(self):
        row = json.loads(self.stages("--json").out)["rows"][0]
        self.assertEqual(row["files"][0], "index.html")
        self.assertTrue(all((self.out / name).is_file() for name in row["files"]))


if __name__ == "__main__":
    program.main()
