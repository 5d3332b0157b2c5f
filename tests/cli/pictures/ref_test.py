#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `rakelight render --ref`: pictures held against references, exit code 5 past the threshold.

  ref_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

SIZE = ("--resolution", "96,64")


class References(program.Case):
    def render(self, *words, model="builtin:teapot", output="a.png"):
        return self.run_program("render", model, "-o", output, *SIZE, *words)

    def reference(self, name="ref.png", *options, model="builtin:teapot"):
        self.assertEqual(self.render(*options, model=model, output=name).code, 0)
        return name

    def row(self, result):
        return json.loads(result.out)["rows"][0]

    def test_an_equal_picture_passes_by_every_measure(self):
        self.reference()
        for measure, value in (("flip", 0), ("rmse", 0), ("psnr", None), ("ssim", 1)):
            result = self.render("--ref", "ref.png", "--ref-measure", measure, "--json")
            self.assertEqual(result.code, 0, result.err)
            reference = self.row(result)["reference"]
            self.assertEqual((reference["file"], reference["measure"], reference["passed"]), ("ref.png", measure, True))
            self.assertEqual(reference["value"], value)
        self.assertEqual(self.render("--ref", "ref.png").err, "")
        self.assertIn("as the reference ref.png: FLIP 0, at most 0.01", self.render("--ref", "ref.png", "--verbose").err)

    def test_another_picture_fails_by_every_measure_with_figure_and_threshold(self):
        self.reference("ref.png", "--light", "ambient:0.1,0.1,0.1")
        for measure, text in (("flip", r"FLIP 0\.\d+, more than 0\.01"), ("rmse", r"RMSE 0\.\d+, more than 0\.01"),
                              ("psnr", r"PSNR \d+\.\d+ dB, less than 40"), ("ssim", r"SSIM 0\.\d+, less than 0\.99")):
            result = self.render("--ref", "ref.png", "--ref-measure", measure)
            self.check_refused(result, 5, "a.png: differs from the reference 'ref.png': ")
            self.assertRegex(result.err, text)
        result = self.render("--ref", "ref.png", "--json")
        reference = self.row(result)["reference"]
        self.assertEqual((result.code, reference["passed"], reference["threshold"]), (5, False, 0.01))
        self.assertGreater(reference["value"], 0.01)
        self.assertEqual(self.row(result)["output"], "a.png")

    def test_the_figure_is_that_of_compare(self):
        self.reference("ref.png", "--shading", "flat")
        figure = self.row(self.render("--ref", "ref.png", "--json"))["reference"]["value"]
        compared = json.loads(self.run_program("compare", "a.png", "ref.png", "--json").out)["rows"][0]
        self.assertEqual(figure, compared["flip"])
        self.assertEqual(self.render("--ref", "ref.png", "--ref-threshold", str(figure * 1.01)).code, 0)
        self.assertEqual(self.render("--ref", "ref.png", "--ref-threshold", str(figure * 0.99)).code, 5)

    def test_the_difference_is_a_picture_or_a_page(self):
        self.reference("ref.png", "--shading", "flat")
        self.assertEqual(self.row(self.render("--ref", "ref.png", "--ref-diff", "d.png", "--json"))["reference"]["difference"], "d.png")
        width, height, _, rows = program.png(self.folder / "d.png")
        self.assertEqual((width, height), (96, 64))
        self.assertGreater(len({tuple(row[3 * x:3 * x + 3]) for row in rows for x in range(width)}), 10)
        self.run_program("compare", "a.png", "ref.png", "-o", "c.png")
        self.assertEqual((self.folder / "c.png").read_bytes(), (self.folder / "d.png").read_bytes())
        self.render("--ref", "ref.png", "--ref-diff", "d.html")
        self.assertEqual((self.folder / "d.html").read_text().count("<img "), 4)

        self.assertEqual(self.render("--ref", "ref.png", "--ref-diff", "made/d.png", "--ref-threshold", "1").code, 0)
        self.assertEqual(program.png(self.folder / "made/d.png")[:2], (96, 64))

    def test_a_folder_of_models_is_held_against_a_folder_of_references(self):
        for name in ("models", "models/more"):
            (self.folder / name).mkdir()
        self.write("models/left.obj"), self.write("models/more/left.obj", program.TWO_PARTS)
        words = ("render", "models", "--recursive", *SIZE)
        self.assertEqual(self.run_program(*words, "-o", "refs/").code, 0)
        result = self.run_program(*words, "-o", "out/", "--ref", "refs/", "--json")
        self.assertEqual(result.code, 0, result.err)
        self.assertEqual([row["reference"]["file"] for row in json.loads(result.out)["rows"]], ["refs/left.png", "refs/more/left.png"])
        self.check_refused(self.render("--ref", "refs/left.png", output="-"), 2, "-o - and --ref exclude each other")

    def test_a_missing_reference_says_how_to_make_it(self):
        result = self.render("--ref", "none.png")
        self.check_refused(result, 3, "none.png: there is no such reference; look at 'a.png', and if it is right, copy it to 'none.png'")
        self.assertIn("a.png", self.files())

    def test_sizes_that_differ_are_said(self):
        self.reference()
        result = self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", "48,32", "--ref", "ref.png")
        self.check_refused(result, 5, "a.png: the picture has 48 x 32 pixels, its reference 'ref.png' has 96 x 64; draw it with --resolution 96,64")

    def test_several_models_have_a_reference_each(self):
        for name, text in (("left", program.SQUARE.format(name="l")), ("right", program.TWO_PARTS)):
            self.write(name + ".obj", text)
        (self.folder / "refs").mkdir()
        both = ("left.obj", "right.obj", "-o", "{model}.png", *SIZE)
        self.assertEqual(self.run_program("render", "left.obj", "right.obj", "-o", "refs/{model}.png", *SIZE).code, 0)
        for words in (("--ref", "refs/{model}.png"), ("--ref", "refs"), ("--ref", "refs/"), ("--ref", "refs/left.png", "--ref", "refs/right.png")):
            result = self.run_program("render", *both, *words, "--json")
            self.assertEqual(result.code, 0, result.err)
            rows = json.loads(result.out)["rows"]
            self.assertEqual([row["reference"]["file"] for row in rows], ["refs/left.png", "refs/right.png"])
        swapped = self.run_program("render", *both, "--ref", "refs/right.png", "--ref", "refs/left.png", "--ref-diff", "all.html")
        self.assertEqual((swapped.code, len(swapped.lines)), (5, 2), swapped.err)
        self.assertEqual(len(re.findall("<section>", (self.folder / "all.html").read_text())), 2)

    def test_the_words_of_f3d_are_known(self):
        self.reference("ref.png", "--shading", "flat")
        self.assertEqual(self.render("--reference", "ref.png", "--reference-threshold", "0.9").code, 0)
        self.assertEqual(self.render("--reference", "ref.png", "--reference-threshold", "0.000001").code, 5)

    def test_what_makes_no_sense_is_refused_before_anything_is_drawn(self):
        self.write("a.obj"), self.write("b.obj")
        self.reference()
        for code, words, text in ((2, ("--ref", "a.png"), "written over its reference"), (2, ("--ref-threshold", "1"), "add --ref PICTURE"),
                                  (2, ("--ref", "ref.png", "--ref-measure", "mse"), "rmse"), (2, ("--ref", "ref.png", "--ref-threshold", "-1"), "0 or more"),
                                  (2, ("--ref", "ref.png", "--ref-diff", "ref.png"), "over the picture or its reference"),
                                  (2, ("--ref", "ref.png", "--ref", "b.png"), "2 references for 1 picture"),
                                  (2, ("--ref", "ref.png", "--ref-diff", "d.txt"), "d.txt")):
            self.check_refused(self.render(*words), code, text)
        several = self.run_program("render", "a.obj", "b.obj", "-o", "{model}.png", "--ref", "ref.png")
        self.check_refused(several, 2, "--ref 'references/{model}.png'")
        self.assertEqual(self.files(), ["a.obj", "b.obj", "ref.png"])


if __name__ == "__main__":
    program.main()
