#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight smooth A B`: the seam between two files is closed, each is written to its own output, both or none.

  smooth_together_test.py PROGRAM [unittest arguments]"""
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
import sphere_halves as sphere


def degrees(a, b):
    cross = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    return math.degrees(math.atan2(math.sqrt(sum(x * x for x in cross)), sum(x * y for x, y in zip(a, b))))


class SmoothTogether(program.Case):
    def setUp(self):
        super().setUp()
        sphere.write_glb(self.folder / "head.glb", 1)
        sphere.write_glb(self.folder / "body.glb", -1)

    def fine(self, *words):
        result = self.run_program(*words)
        self.assertEqual(result.code, 0, result.err)
        return result

    def largest_error(self, path, to_world=lambda v: v):
        """[degrees] Of the normals at the cut: a sphere's are its positions, and both halves are alike."""
        tree, binary = sphere.read_glb(path)
        worst, count = 0.0, 0
        for p, n in zip(sphere.attribute(tree, binary, "POSITION"), sphere.attribute(tree, binary, "NORMAL")):
            world = to_world(p)
            if abs(world[2]) < 1e-6:
                worst, count = max(worst, degrees(to_world(n), world)), count + 1
        self.assertEqual(count, sphere.AROUND)
        return worst

    def test_normals_at_the_cut_are_those_of_the_sphere(self):
        self.assertGreater(self.largest_error(self.folder / "head.glb"), 5)
        self.fine("smooth", "head.glb", "body.glb", "--apart", "-o", "alone/")
        self.assertGreater(self.largest_error(self.folder / "alone/head.glb"), 5)
        self.fine("smooth", "head.glb", "body.glb", "-o", "out/")
        for name in ("head.glb", "body.glb"):
            self.assertLess(self.largest_error(self.folder / "out" / name), 1e-4)
            before, after = (sphere.read_glb(self.folder / folder / name) for folder in (".", "out"))
            self.assertEqual(sphere.attribute(*before, "POSITION"), sphere.attribute(*after, "POSITION"))
            away = [[n for p, n in zip(sphere.attribute(*m, "POSITION"), sphere.attribute(*m, "NORMAL")) if abs(p[2]) > 1e-6] for m in (before, after)]
            self.assertEqual(away[0], away[1])  # what authors made stays where nothing meets

    def test_a_second_run_changes_nothing(self):
        self.fine("smooth", "head.glb", "body.glb", "-o", "out/")
        rows = json.loads(self.fine("smooth", "out/head.glb", "out/body.glb", "-o", "again/", "--json").out)["rows"]
        self.assertEqual([row["changed"] for row in rows], [False, False])
        for name in ("head.glb", "body.glb"):
            self.assertEqual((self.folder / "out" / name).read_bytes(), (self.folder / "again" / name).read_bytes())
        borders = json.loads(self.fine("inspect", "out/head.glb", "out/body.glb", "--as-one", "--json").out)["rows"][0]["borders"]
        self.assertEqual(len(borders), 1)
        self.assertLess(borders[0]["largest_deg"], 1e-3)

    def test_each_file_has_its_own_placement(self):
        turned = {"rotation": [math.sin(0.4), 0, 0, math.cos(0.4)], "translation": [0, 0, 3]}

        def local(p):  # inverse of the rotation by 0.8 about x, after taking the offset away; the file's sphere stands at z = 3
            c, s = math.cos(0.8), math.sin(0.8)
            return p[0], c * p[1] + s * p[2], -s * p[1] + c * p[2]

        sphere.write_glb(self.folder / "body.glb", -1, turned, local)
        sphere.write_glb(self.folder / "head.glb", 1, {"translation": [0, 0, 3]})
        self.fine("smooth", "head.glb", "body.glb", "-o", "out/")
        self.assertLess(self.largest_error(self.folder / "out/head.glb"), 1e-3)
        c, s = math.cos(0.8), math.sin(0.8)
        self.assertLess(self.largest_error(self.folder / "out/body.glb", lambda v: (v[0], c * v[1] - s * v[2], s * v[1] + c * v[2])), 1e-3)

    def test_new_normals_and_other_formats(self):
        sphere.write_glb(self.folder / "head.glb", 1, normals=False)
        sphere.write_obj(self.folder / "body.obj", -1)
        for options in (("--normals", "model"), ()):
            with self.subTest(options=options):
                self.fine("smooth", "head.glb", "body.obj", "-o", "out/", *options)
                self.assertTrue((self.folder / "out/body.obj").read_text().startswith("# one half"))
                cut = [(p, n) for p, n in sphere.obj_corners(self.folder / "out/body.obj") if abs(p[2]) < 1e-6]
                tree, binary = sphere.read_glb(self.folder / "out/head.glb")
                by_place = {tuple(round(x, 4) for x in p): n
                            for p, n in zip(sphere.attribute(tree, binary, "POSITION"), sphere.attribute(tree, binary, "NORMAL"))}
                self.assertGreater(len(cut), 50)
                for p, n in cut:
                    self.assertLess(degrees(n, by_place[tuple(round(x, 4) for x in p)]), 1e-3)
                    if options:
                        self.assertLess(degrees(n, p), 1e-3)

    def test_in_place(self):
        self.fine("smooth", "head.glb", "body.glb", "-o", "{model}.{ext}")
        self.assertLess(self.largest_error(self.folder / "head.glb"), 1e-4)
        self.assertEqual(self.files(), ["body.glb", "head.glb"])

    def test_outputs_that_collide_are_refused(self):
        (self.folder / "b").mkdir()
        sphere.write_glb(self.folder / "b/head.glb", -1)
        self.check_refused(self.run_program("smooth", "head.glb", "body.glb", "--as-one", "-o", "one.glb"), 2, "models need a name for each output")
        self.check_refused(self.run_program("smooth", "head.glb", "b/head.glb", "--as-one", "-o", "out/"), 2, "would both be written to 'out/head.glb'")
        (self.folder / "link.glb").symlink_to("x1.glb")
        (self.folder / "x1.glb").write_bytes((self.folder / "head.glb").read_bytes())
        (self.folder / "y").symlink_to(".")
        self.check_refused(self.run_program("smooth", "head.glb", "y/body.glb", "--as-one", "-o", "{dir}/{model}.{n}.glb".replace("{model}.{n}", "same")), 2,
                           "would both be written to")
        self.assertFalse((self.folder / "out").exists() or (self.folder / "one.glb").exists() or (self.folder / "same.glb").exists())

    def test_both_or_none(self):
        (self.folder / "out/body.glb").mkdir(parents=True)
        failed = self.run_program("smooth", "head.glb", "body.glb", "--as-one", "-o", "out/", "--json")
        self.assertEqual(failed.code, 2, failed.err)
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()), ["body.glb"])
        (self.folder / "broken.glb").write_bytes(b"glTF\2\0\0\0")
        failed = self.run_program("smooth", "head.glb", "broken.glb", "--as-one", "-o", "two/", "--json")
        self.assertEqual(failed.code, 4, failed.err)
        self.assertIn("broken.glb", failed.err)
        self.assertEqual(["error" in row for row in json.loads(failed.out)["rows"]], [True, True])
        self.assertFalse((self.folder / "two").exists())

    def test_a_line_says_what_belongs_together_and_counts_over_all(self):
        note = "head.glb + body.glb: open borders fit together, smoothed as one model (--apart: each by itself), 48 of "
        done = self.fine("smooth", "head.glb", "body.glb", "-o", "out/", "--json")
        self.assertIn(note, done.err)
        self.assertEqual(done.err.count("authored normals turn"), 1)
        rows = json.loads(done.out)["rows"]
        self.assertEqual([row["together"] for row in rows], [["body.glb"], ["head.glb"]])
        sphere.write_glb(self.folder / "far.glb", -1, {"translation": [5, 0, 0]})
        done = self.fine("smooth", "head.glb", "body.glb", "far.glb", "--as-one", "-o", "out/")
        self.assertIn("far.glb: nothing to change\n", done.err)
        self.assertNotIn("fit together", done.err)
        self.assertNotIn("fit together", self.fine("smooth", "head.glb", "-o", "out/").err)
        self.assertEqual("", self.fine("smooth", "head.glb", "body.glb", "-o", "out/", "--quiet").err)
        self.check_refused(self.run_program("smooth", "head.glb", "body.glb", "--as-one", "--apart", "-o", "out/"), 2, "--as-one and --apart exclude each other")

    def test_what_cannot_be_smoothed_as_one_is_smoothed_alone(self):
        sphere.write_obj(self.folder / "body.obj", -1)  # OBJ stores no bitangents
        done = self.run_program("smooth", "head.glb", "body.obj", "--bitangents", "-o", "out/", "--json")
        self.assertEqual(done.code, 2, done.err)
        self.assertIn("head.glb + body.obj: not smoothed as one model, but each by itself: ", done.err)
        self.assertEqual(["error" in row for row in json.loads(done.out)["rows"]], [False, True])
        self.assertEqual([p.name for p in (self.folder / "out").iterdir()], ["head.glb"])

    def test_inspect_names_what_fits_together(self):
        note = "head.glb + body.glb: open borders fit together; --as-one inspects them as one model"
        self.assertIn(note, self.fine("inspect", "head.glb", "body.glb", "--check").err)
        self.assertNotIn("fit together", self.run_program("inspect", "head.glb", "body.glb", "--as-one", "--check").err)

    def test_others_are_smoothed_by_themselves(self):
        sphere.write_glb(self.folder / "far.glb", -1, {"translation": [5, 0, 0]})
        (self.folder / "broken.glb").write_bytes(b"glTF\2\0\0\0")
        done = self.run_program("smooth", "broken.glb", "far.glb", "head.glb", "body.glb", "-o", "out/", "--json")
        self.assertEqual(done.code, 4, done.err)
        rows = json.loads(done.out)["rows"]
        self.assertEqual([row["file"] for row in rows], ["broken.glb", "far.glb", "head.glb", "body.glb"])
        self.assertEqual(["error" in row for row in rows], [True, False, False, False])
        self.assertEqual((self.folder / "out/far.glb").read_bytes(), (self.folder / "far.glb").read_bytes())
        for name in ("head.glb", "body.glb"):
            self.assertLess(self.largest_error(self.folder / "out" / name), 1e-4)

    def test_of_variants_none_is_chosen(self):
        (self.folder / "variant.glb").write_bytes((self.folder / "head.glb").read_bytes())
        self.fine("smooth", "head.glb", "variant.glb", "body.glb", "-o", "out/")
        for name in ("head.glb", "variant.glb", "body.glb"):
            self.assertEqual((self.folder / "out" / name).read_bytes(), (self.folder / name.replace("variant", "head")).read_bytes())
        self.assertIn("head.glb, variant.glb, body.glb: open borders fit together in several ways, so they are not joined",
                      self.fine("smooth", "head.glb", "variant.glb", "body.glb", "-o", "out/").err)

    def test_a_preview_shows_both(self):
        for options in (["--as-one"], []):
            done = self.fine("smooth", "head.glb", "body.glb", *options, "--preview", "pages/")
            self.assertIn("48 of ", done.err)
            self.assertEqual(sorted(p.name for p in (self.folder / "pages").iterdir()), ["head-after.png", "head-before.png", "head.html"])
        self.fine("smooth", "head.glb", "body.glb", "--apart", "--preview", "each/")
        self.assertTrue((self.folder / "each/body.html").exists())

    def test_a_named_page_shows_one_model(self):
        self.assertIn("48 of ", self.fine("smooth", "head.glb", "body.glb", "--preview", "page.html").err)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["body.glb", "head.glb", "page.html"])
        for apart in (["head.glb", "body.glb", "--apart"], ["head.glb", "body.glb", "builtin:torus"]):
            result = self.run_program("smooth", *apart, "--preview", "apart.html")
            self.assertEqual(result.code, 2)
            self.assertIn("several models need a name for each output", result.err)
            self.assertFalse((self.folder / "apart.html").exists())


if __name__ == "__main__":
    program.main()
