#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The models of data/materials as docs/materials.md and docs/shading.md show them: vertex colors, sets of texture coordinates, alpha, sides, automatic shading.

  materials_test.py PROGRAM [unittest arguments]"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import png

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "data/materials"
PAINT, STRIPES = (240, 150, 30), ((0.2,) * 3, (0.6,) * 3)
CORNERS = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
SIDE = 160  # pixels of a unit
HALF = 72   # pixels from the middle of a square to its edge


def to_linear(code):
    s = code / 255
    return s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4


def to_code(light):
    return 255 * (light * 12.92 if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055)


class Materials(program.Case):
    def render(self, name, resolution, *arguments):
        result = self.run_program("render", FOLDER / name, "-o", "a.png", "--resolution", resolution, "--quiet", *arguments)
        self.assertEqual(result.code, 0, result.err)
        return png(self.folder / "a.png")[3]

    def check(self, rows, x, y, expected, delta):
        for got, want in zip(rows[y][3 * x:3 * x + 3], expected):
            self.assertAlmostEqual(got, want, delta=delta, msg=f"{x}, {y}: {tuple(rows[y][3 * x:3 * x + 3])}, not {tuple(expected)}")

    def colors(self):
        return self.render("colors.gltf", f"{4 * SIDE},{SIDE}")

    def fields(self, square, repeats=1):
        """(x, y, share of the square's width, of its height from below) of the middles of a checker's 8 x 8 fields."""
        for j in range(0, 8 * repeats, 3):
            for i in range(0, 8 * repeats, 3):
                across, up = (i + 0.5) / (8 * repeats), (j + 0.5) / (8 * repeats)
                yield int((square + 0.5) * SIDE - HALF + across * 2 * HALF), int(SIDE / 2 + HALF - up * 2 * HALF), across, up

    def texel(self, u, v):
        _, _, _, rows = png(FOLDER / "checker.png")
        x, y = int(u % 1 * 64), int(v % 1 * 64)
        return rows[y][3 * x:3 * x + 3]

    def test_vertex_colors_are_interpolated_as_light(self):
        rows = self.colors()
        for x, y, expected in ((9, 150, CORNERS[0]), (150, 150, CORNERS[1]), (150, 9, CORNERS[2]), (9, 9, (1, 1, 1))):
            for c in range(3):
                self.assertAlmostEqual(to_linear(rows[y][3 * x + c]), expected[c], delta=0.04)
        self.check(rows, 80, 79, (188, 0, 188), 3)

    def test_a_texture_is_read_by_the_set_that_its_material_names(self):
        rows = self.colors()
        for x, y, across, up in self.fields(1):
            self.check(rows, x, y, self.texel(across, 1 - up), 8)
        for x, y, across, up in self.fields(2, repeats=2):
            self.check(rows, x, y, self.texel(2 * up, 2 * across), 12)

    def test_a_texture_is_multiplied_by_vertex_colors(self):
        rows = self.colors()
        for x, y, across, up in self.fields(3):
            if up >= across:
                continue  # the other triangle of the square
            tint = [a * (1 - across) + b * (across - up) + c * up for a, b, c in zip(*CORNERS)]
            self.check(rows, x, y, [to_code(to_linear(t) * f) for t, f in zip(self.texel(across, 1 - up), tint)], 8)

    def stripe(self, x):
        return STRIPES[x // (SIDE // 8) % 2]

    def test_opaque_materials_have_no_alpha_and_masks_cut_it_where_they_say(self):
        rows = self.render("alpha.gltf", f"{5 * SIDE},{SIDE}")
        for square, cut in ((0, 9), (1, 0.5), (2, 0.9)):
            for x in range(square * SIDE + 10, (square + 1) * SIDE - 10):
                radius = abs(x + 0.5 - (square + 0.5) * SIDE) / HALF
                if abs(radius - cut) > 0.04 and (x + 1) % (SIDE // 8) > 1:
                    self.check(rows, x, SIDE // 2, PAINT if radius < cut else [to_code(s) for s in self.stripe(x)], 1)

    def test_blended_materials_mix_with_what_is_behind_by_their_alpha(self):
        rows = self.render("alpha.gltf", f"{5 * SIDE},{SIDE}")
        for x in range(3 * SIDE + 10, 4 * SIDE - 10):
            radius = math.hypot((x + 0.5 - 3.5 * SIDE) / HALF, 0.5 / HALF)
            if 0.05 < radius < 0.95 and (x + 1) % (SIDE // 8) > 1:
                mixed = [to_linear(p) * (1 - radius) + s * radius for p, s in zip(PAINT, self.stripe(x))]
                self.check(rows, x, SIDE // 2, [to_code(m) for m in mixed], 4)

    def test_panes_are_laid_far_to_near_whatever_their_order_in_the_file(self):
        x, y = int(4.5 * SIDE), SIDE // 2
        rows = self.render("alpha.gltf", f"{5 * SIDE},{SIDE}")
        self.check(rows, x, y, [to_code(near + s / 8) for near, s in zip((1 / 2, 1 / 4, 1 / 8), self.stripe(x))], 1)

    def test_the_back_of_a_surface_shows_where_its_material_is_double_sided(self):
        lit_from_the_front = ("--light", "directional:0,0,-1", "--background", "0,0,1")
        inside_left, inside_right = (140, 48), (340, 48)
        as_materials_say = self.render("sides.gltf", "480,200", *lit_from_the_front)
        self.check(as_materials_say, *inside_left, (0, 0, 255), 0)
        self.assertGreater(as_materials_say[inside_right[1]][3 * inside_right[0]], 128, "lit on the side that is seen")
        for cull, shown in (("none", True), ("back", False)):
            rows = self.render("sides.gltf", "480,200", "--cull", cull, *lit_from_the_front)
            for x, y in (inside_left, inside_right):
                self.assertEqual(rows[y][3 * x] > 128, shown, cull)

    def test_automatic_shading_is_phong_for_the_large_sphere_and_gouraud_for_the_small_one(self):
        pictures = {how: self.render("spheres.gltf", "84,64", "--light", "directional:-1,-1,-1", "--light", "ambient:0.1,0.1,0.1", "--shading", how)
                    for how in ("phong", "auto", "gouraud")}
        large, small = ({how: [row[3 * begin:3 * end] for row in rows] for how, rows in pictures.items()} for begin, end in ((0, 62), (62, 84)))
        self.assertEqual(large["auto"], large["phong"])
        self.assertNotEqual(large["auto"], large["gouraud"])
        self.assertEqual(small["auto"], small["gouraud"])
        self.assertNotEqual(small["auto"], small["phong"])


if __name__ == "__main__":
    program.main()
