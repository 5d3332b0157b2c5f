#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `rakelight inspect`: tables, JSON, limits with exit code 5, heat maps.

  inspect_test.py PROGRAM [unittest arguments]"""
import base64
import json
import math
import pathlib
import struct
import sys
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import png

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "tests/support"))
import border_scenes  # noqa: E402

# A sheet bent along x = 0, cut there into two objects; no normals.
TWO_PARTS = "o left\nv -1 0 0\nv 0 0 0.3\nv 0 1 0.3\nv -1 1 0\nf 1 2 3 4\no right\nv 0 0 0.3\nv 1 0 0\nv 1 1 0\nv 0 1 0.3\nf 5 6 7 8\n"
CUBE = ("o cube\n" + "".join(f"v {i & 1} {i >> 1 & 1} {i >> 2 & 1}\n" for i in range(8)) +
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n")
LIMITS = ("--no-degenerate", "--no-t-junctions", "--no-non-manifold", "--consistent-winding", "--no-inside-out", "--closed", "--unit-normals")


def vase(columns, rows, low, high, first, name, normals=False):
    """A part of a body of revolution as OBJ, from height `low` to `high`, its own normals with it or none."""
    radius, slope = (lambda y: 1 + 0.4 * math.sin(2 * y)), (lambda y: 0.8 * math.cos(2 * y))
    lines = [f"o {name}"]
    for r in range(rows + 1):
        for c in range(columns):
            y, a = low + (high - low) * r / rows, 2 * math.pi * c / columns
            lines.append(f"v {radius(y) * math.cos(a):.9g} {y:.9g} {-radius(y) * math.sin(a):.9g}")
            if normals:
                size = math.hypot(1, slope(y))
                lines.append(f"vn {math.cos(a) / size:.9g} {-slope(y) / size:.9g} {-math.sin(a) / size:.9g}")
    corner = (lambda v: f"{v}//{v}") if normals else str
    for r in range(rows):
        for c in range(columns):
            below, above = first + r * columns, first + (r + 1) * columns
            quad = (below + c, below + (c + 1) % columns, above + (c + 1) % columns, above + c)
            lines.append("f " + " ".join(corner(v) for v in quad))
    return "\n".join(lines) + "\n"


def vase_in_two(gap, normals=False):
    """Halves with a gap between them [m]; the upper one has three times as many columns."""
    return vase(16, 4, 0, 1, 1, "lower", normals) + vase(48, 8, 1 + gap, 2, 1 + 16 * 5, "upper", normals)


BY_ANGLE = ("--weight", "angle")  # normals that do not agree across a border; fitted ones nearly do


class Inspect(program.Case):
    def setUp(self):
        super().setUp()
        self.write("parts.obj", TWO_PARTS)
        self.write("cube.obj", CUBE)

    def run_program(self, *arguments, **options):
        """By an angle, where nothing else is asked for: the folds of these models are hard by the rule of creases."""
        asks = {"--crease", "--crease-angle", "--help"}.isdisjoint(arguments)
        by_angle = ("--crease-angle", "60") if asks and arguments[:1] in (("inspect",), ("smooth",), ("render",)) else ()
        return super().run_program(*arguments, *by_angle, **options)

    def row(self, *arguments):
        return json.loads(self.run_program("inspect", *arguments, "--json").out)["rows"][0]

    def smooth(self, source, output, *options):
        done = self.run_program("smooth", source, "-o", output, *options)
        self.assertEqual(done.code, 0, done.err)

    def test_a_model_cut_in_two_fails_with_normals_per_object_and_passes_after_smooth(self):
        for ending in ("obj", "glb"):
            with self.subTest(ending=ending):
                before = self.run_program("inspect", "parts.obj", "--check")
                self.assertEqual(before.code, 5)
                lines = before.err.splitlines()
                self.assertEqual(len(lines), 1, before.err)
                for word in ("parts.obj", "max-seam", "'left'", "'right'", "33.4 degrees"):
                    self.assertIn(word, lines[0])
                self.smooth("parts.obj", "object." + ending, "--scope", "object")
                self.smooth("object." + ending, "kept." + ending)  # flat on both sides: an authored edge, of 33 degrees
                self.assertEqual((self.folder / ("object." + ending)).read_bytes(), (self.folder / ("kept." + ending)).read_bytes())
                self.assertEqual(self.run_program("inspect", "kept." + ending, "--check").code, 0, "what smooth keeps is no seam")
                self.smooth("object." + ending, "model." + ending, "--normals", "model")
                after = self.run_program("inspect", "model." + ending, "--check")
                self.assertEqual((after.code, after.err), (0, ""))

    def test_a_model_without_normals_is_checked_by_those_of_its_objects(self):
        self.assertEqual(self.run_program("inspect", "parts.obj", "--check").code, 5)
        self.assertEqual(self.run_program("inspect", "parts.obj", "--check", "--normals", "model").code, 0)

    def test_the_limit_and_the_crease_angle_decide_what_is_a_seam(self):
        check = ("inspect", "parts.obj", "--check")
        self.assertEqual(self.run_program(*check, "--max-seam", "33").code, 5)
        self.assertEqual(self.run_program(*check, "--max-seam", "34").code, 0)
        self.assertEqual(self.run_program(*check, "--crease-angle", "30").code, 0)  # an edge of 33.4 degrees is a crease then
        self.assertEqual(self.run_program("inspect", "parts.obj").code, 0)  # nothing is checked unless asked for

    def test_the_weld_distance_decides_what_is_one_position(self):
        self.write("apart.obj", TWO_PARTS.replace("o right\nv 0 0 0.3", "o right\nv 0.001 0 0.3"))
        self.assertEqual(self.row("apart.obj")["shared_positions"], 1)
        self.assertEqual(self.row("apart.obj", "--weld-distance", "0.01")["shared_positions"], 2)

    def test_a_check_says_pass_or_fail_and_shows_the_tables_only_when_asked_to(self):
        check = ("inspect", "cube.obj", "parts.obj", "--check", "--closed")
        done = self.run_program(*check)
        self.assertEqual((done.code, done.out), (5, "cube.obj: passed: max-seam 1, closed\n"))
        self.assertEqual([line.split(": ")[2:4] for line in done.lines], [["parts.obj", "max-seam"], ["parts.obj", "closed"]])
        self.assertEqual(self.run_program(*check, "--quiet").out, "")
        verbose = self.run_program(*check, "--verbose").out
        for word in ("cube.obj\n", "parts.obj\n", "surfaces", "borders"):
            self.assertIn(word, verbose)
        self.assertEqual(verbose, self.run_program("inspect", "cube.obj", "parts.obj").out)

    def test_every_limit_has_its_own_line(self):
        self.assertEqual(self.run_program("inspect", "cube.obj", "--check", *LIMITS).code, 0)
        faults = {
            "--closed": CUBE.replace("f 1 3 4 2\n", ""),
            "--consistent-winding": CUBE.replace("f 1 3 4 2\n", "f 2 4 3 1\n"),
            "--no-inside-out": "".join(" ".join(["f", *reversed(line.split()[1:])]) + "\n" if line[0] == "f" else line
                                       for line in CUBE.splitlines(True)),
            "--no-degenerate": CUBE + "f 1 1 2\n",
            "--no-non-manifold": CUBE + "v 0 -1 -1\nf 1 2 9\n",
            "--no-t-junctions": CUBE.replace("f 1 3 4 2\n", "v 0.5 0 0\nf 9 1 3 4\n"),
        }
        for limit, text in faults.items():
            with self.subTest(limit=limit):
                self.write("fault.obj", text)
                done = self.run_program("inspect", "fault.obj", "--check", limit, "--quiet")
                self.assertEqual(done.code, 5, done.err)
                self.assertEqual(len(done.err.splitlines()), 1, done.err)
                self.assertIn("fault.obj: " + limit[2:] + ": ", done.err)
                self.assertIn("cube", done.err)
        self.write("fault.obj", CUBE.replace("f 1 3 4 2\n", "f 1 1 2\n"))
        done = self.run_program("inspect", "fault.obj", "--check", *LIMITS, "--quiet", "--json")
        self.assertEqual(len(done.err.splitlines()), 2)
        check = json.loads(done.out)["rows"][0]["check"]
        self.assertFalse(check["passed"])
        self.assertEqual([f["limit"] for f in check["failures"]], ["no-degenerate", "closed"])

    def test_normals_that_are_not_of_unit_length_pass_their_limit(self):
        for length in (0, 1, 1.005, 2):
            with self.subTest(length=length):
                floats = struct.pack("<18f", 0, 0, 0, 1, 0, 0, 0, 1, 0, *3 * (0, 0, length))
                view = lambda at: {"buffer": 0, "byteOffset": at, "byteLength": 36}
                accessor = lambda number: {"bufferView": number, "componentType": 5126, "count": 3, "type": "VEC3"}
                self.write("normals.gltf", json.dumps({
                    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": "face"}],
                    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}}]}],
                    "accessors": [dict(accessor(0), min=[0, 0, 0], max=[1, 1, 0]), accessor(1)], "bufferViews": [view(0), view(36)],
                    "buffers": [{"byteLength": 72, "uri": "data:application/octet-stream;base64," + base64.b64encode(floats).decode()}]}))
                done = self.run_program("inspect", "normals.gltf", "--check", "--unit-normals", "--quiet")
                self.assertEqual(done.code, 5 if length in (0, 2) else 0, done.err)
                if done.code:
                    self.assertIn("unit-normals: 3 zero, non-finite or non-unit normals in 'face'", done.err)

    def test_of_several_models_the_worst_code_counts_and_all_are_looked_at(self):
        done = self.run_program("inspect", "cube.obj", "none.obj", "parts.obj", "--check", "--json")
        self.assertEqual(done.code, 5)
        rows = json.loads(done.out)["rows"]
        self.assertEqual([r.get("check", {}).get("passed") for r in rows], [True, None, False])
        self.assertEqual(rows[1]["error"]["exit_code"], 3)

    def test_the_report_says_before_and_after_and_the_state_of_each_object(self):
        row = self.row("parts.obj")
        border = row["borders"][0]
        self.assertEqual((border["positions"], border["continuous"], border["joined"]), (2, 0, 2))
        for key in ("max_deg", "mean_deg", "p95_deg"):
            self.assertAlmostEqual(border["before"][key], 33.398, 2)
            self.assertLess(border["after"][key], 0.01)
        self.assertEqual(row["seams"]["normals_before"], "smoothed per object")
        self.assertEqual(row["objects"][0]["surface"]["open_edges"], 4)
        cube = self.row("cube.obj")["objects"][0]["surface"]
        self.assertEqual((cube["closed"], cube["edges"]), (True, 18))
        text = self.run_program("inspect", "parts.obj").out
        for word in ("surfaces", "borders", "33.40", "smoothed per object"):
            self.assertIn(word, text)

    def test_t_junctions_are_listed_with_their_place(self):
        self.write("t.obj", "o coarse\nv 0 0 0\nv 2 0 0\nv 2 2 0\nf 1 2 3\no fine\nv 0 -1 0\nv 1 -1 0\nv 0 0 0\nv 1 0 0\nf 4 5 7 6\n")
        row = self.row("t.obj")
        self.assertEqual(row["t_junctions"]["count"], 1)
        self.assertEqual(row["t_junctions"]["places"], [{"position": [1, 0, 0], "object": 1, "edge_object": 0}])
        self.assertIn("1 0 0  fine       coarse", self.run_program("inspect", "t.obj").out)

    def test_many_objects_are_cut_for_people_and_whole_in_json(self):
        self.write("many.obj", "".join(f"o part{i}\nv {i} 0 0\nv {i} 1 0\nv {i + 1} 0 0\nf {3 * i + 1} {3 * i + 2} {3 * i + 3}\n" for i in range(100)))
        text = self.run_program("inspect", "many.obj").out
        self.assertEqual(text.count("... 60 more, all of them in the JSON"), 2)  # objects, surfaces
        self.assertIn("... 59 more, all of them in the JSON", text)  # borders
        self.assertEqual(len(self.row("many.obj")["borders"]), 99)

    def test_a_heat_map_shows_the_seam_and_nothing_where_there_is_none(self):
        self.smooth("parts.obj", "model.obj")
        for name, is_colored in (("parts", True), ("model", False)):
            with self.subTest(name=name):
                done = self.run_program("inspect", name + ".obj", "--heatmap", "{model}.png", "--view", "front", "--resolution", "120,80")
                self.assertEqual((done.code, done.err), (0, ""))
                width, height, _, rows = png(self.folder / (name + ".png"))
                self.assertEqual((width, height), (120, 80))
                r, g, b = rows[40][180:183]
                self.assertEqual(r > 200 and g > 100 and b < 100, is_colored, (r, g, b))  # 33 degrees: orange to yellow
                self.assertLess(max(rows[40][150:153]) - min(rows[40][150:153]), 3)  # beside it: gray
        self.assertEqual(self.row("parts.obj", "--heatmap", "x.png")["heat_map"], "x.png")

    def test_the_heat_map_is_the_same_for_any_number_of_threads(self):
        for threads in (1, 3):
            self.run_program("inspect", "parts.obj", "--heatmap", f"{threads}.png", "--threads", threads)
        self.assertEqual((self.folder / "1.png").read_bytes(), (self.folder / "3.png").read_bytes())

    def test_the_heat_map_has_a_legend_and_a_ring_unless_told_otherwise(self):
        view = ("--view", "front", "--resolution", "480,320")
        self.run_program("inspect", "parts.obj", "--heatmap", "with.png", *view)
        self.run_program("inspect", "parts.obj", "--heatmap", "without.png", "--heatmap-legend", "off", *view)
        rows, plain = (png(self.folder / name)[3] for name in ("with.png", "without.png"))
        changed = {(x, y) for y in range(320) for x in range(480) if rows[y][3 * x:3 * x + 3] != plain[y][3 * x:3 * x + 3]}
        legend = {p for p in changed if p[1] > 270 and p[0] < 226}
        self.assertGreater(len(legend), 1000)
        bar = [tuple(rows[y][3 * x:3 * x + 3]) for y in range(270, 320) for x in range(10, 170)]
        self.assertIn(True, [r > 220 and g > 220 and b < 90 for r, g, b in bar])  # 60 degrees: light yellow
        ring = changed - legend
        self.assertGreater(len(ring), 100)
        self.assertLess(abs(sum(x for x, _ in ring) / len(ring) - 240), 40)  # about the seam, in the middle; its angle is to the right

    def test_lengths_without_a_unit_are_called_units(self):
        self.assertEqual(self.row("parts.obj")["unit"], "units")
        self.assertRegex(self.run_program("inspect", "parts.obj").out, r"size 2 x 1 x \S+ units\n")
        self.assertEqual(self.row("builtin:teapot")["unit"], "m")
        self.assertRegex(self.run_program("inspect", "builtin:teapot").out, r"size .* m\n")
        (self.folder / "t.stl").write_text("solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 25 0 0\nvertex 0 25 0\nendloop\nendfacet\nendsolid t\n")
        row = self.row("t.stl")
        self.assertEqual((row["unit"], row["bounds"]["high"]), ("units", [25, 25, 0]))
        self.run_program("inspect", "t.stl", "--report", "t.html", "--resolution", "64,48")
        self.assertIn("size 25 x 25 x 0 units", (self.folder / "t.html").read_text())

    def test_borders_that_do_not_match_are_seen_measured_checked_and_joined(self):
        self.write("vase.obj", vase_in_two(0.01))
        proposal = self.row("vase.obj", *BY_ANGLE)["border_proposal"]
        distance = str(proposal["distance"])
        self.assertTrue(0.01 < float(distance) < 0.05, proposal)
        self.assertGreater(proposal["seam_deg"], 5)
        self.assertRegex(self.run_program("inspect", "vase.obj", *BY_ANGLE).out,
                         r"  open borders of different meshes run along each other \(\S+ of \S+ units, gaps up to \S+, seams to \S+ degrees\): --border-distance "
                         + distance + " measures and joins them\n")
        row = self.row("vase.obj", *BY_ANGLE, "--border-distance", distance)
        self.assertNotIn("border_proposal", row)
        matched = row["matched_borders"]
        self.assertEqual(sorted(matched), ["after", "before", "distance", "edges_not_searched", "gap_max", "gap_mean", "matched_length", "open_length", "pairs",
                                           "pairs_left_out", "seam_deg", "unmatched_length"])
        self.assertEqual((matched["distance"], matched["edges_not_searched"], matched["pairs_left_out"]), (float(distance), 0, 0))
        self.assertAlmostEqual(matched["matched_length"] + matched["unmatched_length"], matched["open_length"])
        around = 2 * math.pi * (1 + 0.4 * math.sin(2))
        self.assertAlmostEqual(matched["matched_length"], 2 * around, delta=0.02 * around)
        self.assertTrue(0.01 <= matched["gap_mean"] <= matched["gap_max"] <= float(distance), matched)
        before, after = matched["before"], matched["after"]
        self.assertTrue(after["max_deg"] < 0.2 * before["max_deg"] and before["mean_deg"] <= before["p95_deg"] <= before["max_deg"], matched)
        pair, = matched["pairs"]
        self.assertEqual([row["objects"][pair[key]]["name"] for key in ("object_a", "object_b")], ["lower", "upper"])
        self.assertAlmostEqual(pair["seam_position"][1], 1.005, delta=0.006)
        self.assertIn("borders that run along each other (degrees)", self.run_program("inspect", "vase.obj", *BY_ANGLE, "--border-distance", distance).out)

        check = ("--check", "--max-seam", "2")
        unasked = self.run_program("inspect", "vase.obj", *BY_ANGLE, *check)
        self.assertEqual(unasked.code, 0)  # nobody asked for such borders, and it is said
        self.assertIn("not checked: open borders of different meshes run along each other", unasked.err)
        failed = self.run_program("inspect", "vase.obj", *BY_ANGLE, *check, "--border-distance", distance, "--report", "vase.xml")
        self.assertEqual(failed.code, 5)
        self.assertRegex(failed.err, r"max-seam: seam of \S+ degrees between 'lower' and 'upper' at \S+ 1\S* \S+, along borders that share no vertex there, more than 2\n")
        self.assertIn("along borders that share no vertex there", xml.etree.ElementTree.parse(self.folder / "vase.xml").find(".//failure").get("message"))
        self.smooth("vase.obj", "joined.obj", *BY_ANGLE, "--border-distance", distance)
        self.assertNotIn("border_proposal", self.row("joined.obj"))
        self.assertEqual(self.row("joined.obj", "--border-distance", distance)["matched_borders"]["seam_deg"], 0)
        passed = self.run_program("inspect", "joined.obj", *check, "--border-distance", distance)
        self.assertEqual((passed.code, passed.err), (0, ""))

    def test_borders_whose_normals_agree_pass_and_are_not_proposed(self):
        self.write("agree.obj", vase_in_two(0.001, normals=True))
        self.assertEqual(self.run_program("inspect", "agree.obj", "--check", "--border-distance", "0.03", "--max-seam", "0.5").code, 0)
        self.assertLess(self.row("agree.obj", "--border-distance", "0.03")["matched_borders"]["before"]["max_deg"], 0.5)
        for name in ("agree.obj", "parts.obj", "cube.obj"):
            self.assertNotIn("border_proposal", self.row(name))
            self.assertNotIn("open borders", self.run_program("inspect", name).out)

    def test_parts_that_only_lie_near_each_other_are_neither_measured_nor_proposed(self):
        for path, scene in border_scenes.write(self.folder):
            with self.subTest(scene.name):
                matched = self.row(path, "--border-distance", str(scene.distance))["matched_borders"]
                self.assertEqual(matched["matched_length"] > 0, scene.joins, matched)
                self.assertEqual(bool(matched["pairs"]), scene.joins)
                self.assertEqual("border_proposal" in self.row(path), scene.joins)

    def test_the_heat_map_shows_borders_that_do_not_match(self):
        self.write("vase.obj", vase_in_two(0.01))
        view = ("--camera-position", "0,1,6", "--camera-focal-point", "0,1,0", "--camera-orthographic", "--resolution", "120,80")
        for name, options in (("off", ()), ("on", ("--border-distance", "0.03"))):
            with self.subTest(name=name):
                done = self.run_program("inspect", "vase.obj", *BY_ANGLE, "--heatmap", name + ".png", *view, *options)
                self.assertEqual((done.code, done.err), (0, ""))
                rows = png(self.folder / (name + ".png"))[3]
                colored = [y for y in range(80) for x in range(120) if max(rows[y][3 * x:3 * x + 3]) - min(rows[y][3 * x:3 * x + 3]) > 20]
                if name == "off":
                    self.assertEqual(colored, [])
                else:
                    self.assertGreater(len(colored), 50)
                    self.assertTrue(all(34 <= y <= 46 for y in colored), (min(colored), max(colored)))  # the cut is at half of the height

    def test_a_report_is_a_page_that_holds_everything(self):
        done = self.run_program("inspect", "parts.obj", "cube.obj", "none.obj", "--report", "r.html", "--check", "--max-seam", "2", "--resolution", "320,240")
        self.assertEqual(done.code, 5, done.err)
        text = (self.folder / "r.html").read_text()
        self.assertEqual(text.count("<section "), 3)
        self.assertEqual(text.count('src="data:image/png;base64,'), 4)  # of two models two each
        self.assertNotRegex(text, r'(src|href)="(?!data:|#)')
        self.assertNotIn("<script", text)
        for word in ("max-seam: seam of ", "The largest seam, ", "borders (degrees)", "surfaces", "cannot be read", "No limit is exceeded", "fails 1 limit"):
            self.assertIn(word, text)

    def test_junit_has_a_case_for_each_limit_and_model(self):
        done = self.run_program("inspect", "parts.obj", "cube.obj", "none.obj", "--report", "r.xml", "--max-seam", "2", "--closed")
        self.assertEqual(done.code, 5, done.err)
        root = xml.etree.ElementTree.parse(self.folder / "r.xml").getroot()
        self.assertEqual((root.tag, root.get("tests"), root.get("failures"), root.get("errors")), ("testsuites", "7", "2", "1"))
        suites = {suite.get("name"): suite for suite in root}
        self.assertEqual(sorted(suites), ["cube.obj", "none.obj", "parts.obj"])
        cases = {case.get("name"): case for case in suites["parts.obj"]}
        self.assertEqual(sorted(cases), ["closed", "load", "max-seam"])
        self.assertIn("degrees between", cases["max-seam"].find("failure").get("message"))
        self.assertEqual(cases["max-seam"].get("classname"), "parts.obj")
        self.assertEqual([case.find("failure") for case in suites["cube.obj"]], [None, None, None])
        self.assertEqual(suites["none.obj"][0].find("error").get("type"), "not_found")
        self.run_program("inspect", "cube.obj", "--junit", "other")
        self.assertEqual(xml.etree.ElementTree.parse(self.folder / "other").getroot().get("tests"), "2")
        self.write('a "<&>\x01.obj', CUBE)
        self.run_program("inspect", 'a "<&>\x01.obj', "--report", "r.xml", "--report", "r.html", "--resolution", "64,48")
        self.assertEqual(xml.etree.ElementTree.parse(self.folder / "r.xml").getroot()[0].get("name"), 'a "<&>?.obj')
        self.assertIn("<h2>a &quot;&lt;&amp;&gt;?.obj</h2>", (self.folder / "r.html").read_text())
        self.check_refused(self.run_program("inspect", "cube.obj", "--report", "r.txt"), 2, "neither .html nor .xml")

    def test_wrong_usage_is_one_line_and_exit_code_2(self):
        for options in (["--closed"], ["--max-seam", "2"], ["--check", "--max-seam", "-1"], ["--check", "--max-seam", "x"],
                        ["--check", "--max-seam", "181"], ["--weld-distance", "-1"], ["--weld-distance", "inf"], ["--border-distance", "-1"], ["--border-distance", "inf"], ["--border-distance", "x"],
                        ["--no-borders", "--border-distance", "1"], ["--check", "--no-borders", "--max-seam", "1"],
                        ["--check", "--no-surfaces", "--closed"], ["--view", "front"], ["--resolution", "10,10"],
                        ["--no-borders", "--heatmap", "a.png"], ["--heatmap", "a.txt"], ["--heatmap", "cube.obj/folder.png"],
                        ["cube.obj", "--heatmap", "a.png"], ["--heatmap", "a.png", "--view", "inside"],
                        ["--heatmap", "a.png", "--resolution", "60000,60000"]):
            with self.subTest(options=options):
                done = self.run_program("inspect", "parts.obj", *options)
                self.assertIn(done.code, (1, 2) if "cube.obj/folder.png" in options else (2,), done.err)
                self.assertEqual((len(done.err.splitlines()), done.out), (1, ""))
                if "cube.obj" in options:
                    self.assertIn("--heatmap 'out/{model}.png'", done.err)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["cube.obj", "parts.obj"])


if __name__ == "__main__":
    program.main()
