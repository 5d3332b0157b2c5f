#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `rakelight stages`: everything is written or nothing, pages and tables agree with the program's other words.

  stages_test.py PROGRAM [unittest arguments]"""
import base64
import html.parser
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from stages import METAL, SIZE, STAGES, Case


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


class Stages(Case):
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

    def test_a_single_file_holds_all_that_the_folder_does(self):
        self.stages()
        run = self.run_program("stages", "builtin:teapot", "-o", "all.html", "--single-file", "--resolution", SIZE, "--json")
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(json.loads(run.out)["rows"][0]["page"], "all.html")
        text = (self.folder / "all.html").read_text()
        links = Links(text)
        self.assertEqual((links.open, "script" in links.tags), ([], False))
        data = [link for link in links.found if not link.startswith("#")]
        self.assertTrue(all(link.startswith("data:") for link in data))
        pictures = {base64.b64decode(link.split(",")[1]) for link in data if link.startswith("data:image/png")}
        self.assertEqual(pictures, {p.read_bytes() for p in self.out.glob("*.png")})
        tables = [base64.b64decode(link.split(",")[1]).decode() for link in data if link.startswith("data:application/json")]
        self.assertEqual(tables, [(self.out / f"{stage}.json").read_text() for stage in STAGES])
        self.check_refused(self.run_program("stages", "builtin:teapot", "-o", "dir", "--single-file"), 2, ".html")
        self.check_refused(self.run_program("stages", "builtin:teapot", "-o", "page.html"), 2, "add --single-file")

    def test_the_default_look_is_that_of_render(self):
        for model in (METAL, "builtin:teapot"):
            self.run_program("render", model, "-o", "a.png", "--resolution", SIZE, "--look", "default")
            self.stages("--look", "default", model=model)
            self.assertEqual((self.out / "picture.png").read_bytes(), (self.folder / "a.png").read_bytes())

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

    def test_objects_have_the_names_that_a_world_gives(self):
        world = self.write("w.scene.toml", "[[primitive]]\ntype = 'torus'\nname = 'tyre_fl'\n"
                           "[[primitive]]\ntype = 'teapot'\nname = 'pot'\nposition = [0, 0, -3]\n")
        self.stages(model=world)
        names = {row[0] for row in self.table("visibility")["rows"]}
        self.assertIn("tyre_fl", names)
        self.assertIn("pot/body", names)
        self.assertEqual(self.table("model")["rows"][0][0], "tyre_fl")
        run = self.run_program("explain", world, "--pixel", "48,32", "--resolution", SIZE)
        self.assertRegex(run.out, "tyre_fl|pot/")

    def test_every_stage_has_a_picture_a_table_and_words(self):
        self.stages()
        for stage in STAGES:
            table = self.table(stage)
            self.assertTrue(table["pictures"], stage)
            self.assertTrue(table["numbers"] or table["rows"], stage)
            self.assertGreater(len(table["text"]), 100, stage)

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

    def test_refusals_speak_of_folders(self):
        self.write("file", "")
        self.check_refused(self.run_program("stages", "builtin:teapot", "-o", "file/such/out"), 1, "file/such/out: the folder", "cannot be made")
        self.check_refused(self.run_program("stages", "a.obj", "b.obj", "-o", "out"), 2, "a name for each folder", "-o 'out/{model}'\n")
        self.assertEqual(self.files(), ["file"])

    def test_the_help_leaves_out_what_would_be_refused_or_changes_nothing(self):
        for verb in ("stages", "explain"):
            text = self.run_program(verb, "--help").out
            for option in ("--channels", "--channel-files", "--exr-colors", "--edges", "--wireframe", "--points", "--point-sprites", "--line-color"):
                self.assertNotIn(option, text, verb)
            self.assertEqual("--point-size" in text, verb == "stages")

    def test_a_model_of_points_alone_has_no_ranges_and_a_warning(self):
        self.write("a.obj", "v 0 0 0\nv 1 1 0\np 1 2\n")
        run = self.run_program("stages", "a.obj", "-o", self.out, "--resolution", SIZE)
        self.assertEqual((run.code, len(run.lines)), (0, 1), run.err)
        self.assertIn("no triangles", run.err)
        for stage in STAGES[:7]:
            table = self.table(stage)
            self.assertEqual([name for name in table["numbers"] if name.startswith("range of ") and "nf" in str(table["numbers"][name])], [], stage)
        self.assertEqual(self.table("model")["numbers"], {"vertices": 0})
        self.assertEqual(self.table("model")["rows_note"], "There are no vertices.")

    def test_nothing_is_left_of_what_fails(self):
        for arguments in (("none.obj", "-o", "out"), ("builtin:teapot", "-o", "no/such/out", "--camera-index", "9"),
                          ("builtin:teapot", "-o", "out", "--resolution", "65536,65536")):
            run = self.run_program("stages", *arguments)
            self.assertNotEqual(run.code, 0)
            self.assertEqual(len(run.err.splitlines()), 1, run.err)
            self.assertEqual(list(self.folder.iterdir()), [], arguments)

    def test_json_lists_the_files(self):
        row = json.loads(self.stages("--json").out)["rows"][0]
        self.assertEqual(row["files"][0], "index.html")
        self.assertTrue(all((self.out / name).is_file() for name in row["files"]))


if __name__ == "__main__":
    program.main()
