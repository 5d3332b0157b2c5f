#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `rakelight stages`: everything is written or nothing, pages and tables agree with the program's other words.

  stages_test.py PROGRAM [unittest arguments]"""
import base64
import html.parser
import json
import math
import pathlib

import program
from program import png

SIZE = "96,64"
METAL = pathlib.Path(__file__).resolve().parents[2] / "data/materials/layers.gltf"
BRICKS = pathlib.Path(__file__).resolve().parents[2] / "data/maps/brick_height.png"
STAGES = ["model", "world", "camera", "normalized-frustum", "central-projection", "depth-mapping", "clip-space", "clipped", "clip-planes",
          "wrap-round", "device", "screen", "culled", "coverage", "depth", "depth-precision", "visibility", "normal", "shading-frequency",
          "lighting", "blended", "tone", "picture"]


def linear(code):
    v = code / 255
    return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4


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

    def test_the_picture_is_the_rendered_one_and_the_means_of_the_terms_add_up_to_its_mean(self):
        for shading in ("phong", "gouraud", "flat", "unlit"):
            self.stages("--shading", shading)
            run = self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE, "--shading", shading, "--background", "0,0,0", "--json")
            covered = json.loads(run.out)["rows"][0]["stats"]["pixels_covered"]
            self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE, "--shading", shading)
            self.assertEqual((self.out / "picture.png").read_bytes(), (self.folder / "a.png").read_bytes())
            if shading == "unlit":
                continue
            terms = self.table("lighting")["rows"]
            self.assertEqual(len(terms), 10)  # emission, and three of each of the three lights
            pixels = self.table("visibility")["numbers"]["pixels that show a surface"]
            self.assertEqual(pixels, covered)
            red = sum(row[1] for row in terms)
            rows = png(self.out / "picture.png")[3]
            ground = rows[0][:3]
            shown = [linear(row[3 * x]) for row in rows for x in range(96) if row[3 * x:3 * x + 3] != ground]
            self.assertAlmostEqual(red, sum(shown) / len(shown), delta=0.01)

    def sum_of_terms_is_the_mean_of_the_picture(self, *options):
        self.stages("--background", "0,0,0", *options)
        rows = png(self.out / "picture.png")[3]
        pixels = self.table("visibility")["numbers"]["pixels that show a surface"]
        mean = sum(linear(row[3 * x]) for row in rows for x in range(96)) / pixels
        terms = self.table("lighting")["rows"]
        self.assertAlmostEqual(sum(row[1] for row in terms), mean, delta=0.002)
        return {row[0]: row[1] for row in terms}

    def test_displacement_shows_the_base_beside_what_it_is_made_into(self):
        options = ["--bump", "displacement", "--height-map", BRICKS, "--bump-depth", "0.02"]
        self.stages(*options, model="builtin:sphere")
        self.assertIn('<section id="displacement">', (self.out / "index.html").read_text())
        numbers = self.table("displacement")["numbers"]
        self.assertEqual(numbers["triangles after"], self.table("culled")["numbers"]["triangles in"])
        self.assertGreater(numbers["triangles after"], 4 * numbers["triangles before, of what is displaced"])
        self.assertEqual(numbers["highest, from the base [m]"], 0)
        base = self.folder / "base.png"
        run = self.run_program("render", "builtin:sphere", "-o", base, "--resolution", SIZE, "--bump", "none")
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(png(base)[3], png(self.out / "displacement-base.png")[3])
        self.assertEqual(png(self.out / "picture.png")[3], png(self.out / "displacement.png")[3])
        self.assertNotEqual(png(self.out / "displacement-enlarged.png")[3], png(self.out / "displacement-base-enlarged.png")[3])

    def test_heights_of_displacement_are_widths_of_the_texture_times_the_depth(self):
        (self.folder / "h.png").write_bytes((BRICKS).read_bytes())
        world = self.write("w.scene.toml", "[[primitive]]\ntype = 'plane'\nname = 'road'\nsize = [4, 4]\nmaterial = 'bricks'\n"
                           "[[primitive]]\ntype = 'sphere'\nradius = 0.5\nposition = [0, 0.5, 0]\n"
                           "[[material]]\nname = 'bricks'\nbump = 'displacement'\nheight_texture = 'h.png'\nbump_depth = 0.05\n")
        self.stages(model=world)
        table = self.table("displacement")
        self.assertEqual(len(table["rows"]), 1)
        name, before, after, low, high = table["rows"][0]
        self.assertEqual((name, before), ("road", 2))
        self.assertGreater(after, 10000)
        self.assertAlmostEqual(low, -0.2, delta=0.002)  # 4 m are one width; black texels are the lowest
        self.assertAlmostEqual(high, 0, delta=0.002)
        self.stages("--bump", "none", model=self.write("plain.scene.toml", "[[primitive]]\ntype = 'plane'\n"))
        self.assertFalse((self.out / "displacement.json").exists())

    def test_coverage_of_once_is_not_the_color_of_the_most(self):
        one = "[[primitive]]\ntype = 'plane'\nrotation_deg = [90, 0, 0]\n"
        for count, caption in ((1, "blue 1. No pixel is covered twice."), (2, "blue 1, white 2."), (3, "blue 1, over green and yellow to white 3."),
                               (14, "to white 12 and more.")):
            planes = "".join(f"{one}position = [0, 0, {-0.01 * i}]\nmaterial = 'm'\n" for i in range(count))
            world = self.write("w.scene.toml", planes + "[[material]]\nname = 'm'\ndouble_sided = true\n"
                               "[[camera]]\nposition = [0, 0, 8]\ntarget = [0, 0, 0]\n")
            self.stages(model=world)
            table = self.table("coverage")
            self.assertEqual(table["numbers"]["largest overdraw"], count)
            self.assertTrue(table["pictures"][0]["caption"].endswith(caption), table["pictures"][0]["caption"])
            rows = png(self.out / "coverage.png")[3]
            red, green, blue = rows[32][3 * 48:3 * 48 + 3]
            if count == 1:
                self.assertTrue(red < 60 < green < blue, "blue")
            else:
                self.assertEqual((red, green, blue), (255, 255, 255))

    def test_lines_of_large_models_are_no_solid_color(self):
        world = self.write("w.scene.toml", "[[primitive]]\ntype = 'teapot'\ndivisions = 40\n")
        run = self.run_program("stages", world, "-o", self.out, "--resolution", "320,240")
        self.assertEqual(run.code, 0, run.err)
        self.assertGreater(self.table("model")["numbers"]["vertices"], 50000)
        for stage in ("model", "screen", "device", "clipped"):
            self.assertIn("the more, the brighter", self.table(stage)["pictures"][0]["caption"])
            rows = png(self.out / f"{stage}.png")[3]
            drawn = [row[i] for row in rows for i in range(0, len(row), 3) if row[i] != 16]
            self.assertGreater(len(drawn), 500)
            self.assertLess(sum(v == 150 for v in drawn), 0.15 * len(drawn), stage)
            self.assertGreater(len(set(drawn)), 15, stage)

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

    def test_surroundings_and_fog_have_their_terms_and_the_sum_is_the_picture(self):
        terms = self.sum_of_terms_is_the_mean_of_the_picture("--hdri-ambient")
        self.assertEqual(list(terms), ["Emission", "Surroundings: diffuse", "Surroundings: specular"])
        self.assertGreater(terms["Surroundings: diffuse"], 0.1)
        self.assertGreater(terms["Surroundings: specular"], 0.01)
        for picture in ("surroundings-diffuse", "surroundings-specular"):
            self.assertTrue((self.out / f"{picture}.png").is_file())
        clear = self.sum_of_terms_is_the_mean_of_the_picture()
        foggy = self.sum_of_terms_is_the_mean_of_the_picture("--fog", "exp:0.3:color=#ffffff")
        share = self.table("lighting")["numbers"]["share that is seen through the fog, mean of opaque pixels"]
        self.assertAlmostEqual(foggy["Fog"], 1 - share, 5)
        lit = [name for name in clear if clear[name] > 0]
        self.assertEqual(len(lit), 5)  # an ambient term, and two of each of two lights
        for name in lit:
            self.assertAlmostEqual(foggy[name] / clear[name], share, delta=0.02)
        both = self.sum_of_terms_is_the_mean_of_the_picture("--hdri-ambient", "--fog", "exp2:0.3", "--shading", "gouraud", "--light", "directional:0,-1,0", "--light-intensity", "0.3")
        self.assertEqual(len(both), 7)

    def test_exposure_and_tone_curve_are_in_the_picture_and_shown_before_and_after(self):
        options = ("--tone-mapping", "agx", "--exposure", "2", "--samples", "4")
        self.stages(*options)
        self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE, *options)
        for picture in ("picture", "shading-phong"):
            self.assertEqual((self.out / f"{picture}.png").read_bytes(), (self.folder / "a.png").read_bytes(), picture)
        self.stages()
        plain = (self.out / "picture.png").read_bytes()
        self.stages("--exposure", "2", "--tone-mapping", "agx")
        self.assertEqual((self.out / "tone-light.png").read_bytes(), plain)
        tone = self.table("tone")
        self.assertEqual((tone["numbers"]["tone curve"], tone["numbers"]["exposure [EV]"]), ("agx", 2))
        self.assertGreater(tone["numbers"]["pixels brighter than 1 with the exposure"], 100)
        self.assertEqual(self.table("picture")["numbers"]["pixels brighter than 1, clamped"], 0)  # the curve has no such light
        for ev, light, exposed, after, code in tone["rows"]:
            self.assertAlmostEqual(light / 0.18 / 2 ** ev, 1, 5)
            self.assertAlmostEqual(exposed / light, 4, 5)
            self.assertAlmostEqual(linear(code), after, delta=0.006)
        self.assertLess([row[3] for row in tone["rows"] if row[0] == 2][0], 1)
        self.stages("--exposure", "2")
        self.assertGreater(self.table("picture")["numbers"]["pixels brighter than 1, clamped"], 100)

    def test_shadows_are_shown_light_by_light_with_the_maps(self):
        self.write("a.obj", "o floor\nv -2 0 -2\nv 2 0 -2\nv 2 0 2\nv -2 0 2\nf 4 3 2 1\no lid\nv -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\nf 8 7 6 5\n")
        above = ("--camera-position", "0,0.9,0", "--camera-focal-point", "0,0,0", "--camera-view-up", "0,0,-1", "--camera-view-angle", "60")
        lights = ("--light", "directional:0,-1,0", "--light", "ambient:0.1,0.1,0.1", "--light", "point:0,0.5,0", "--shadow-size", "64")
        self.stages("--shadows", *above, *lights, model="a.obj")
        shadows = self.table("shadows")
        self.assertEqual([p["file"] for p in shadows["pictures"]],
                         ["shadow-0.png", "shadow-map-0.png", "shadow-2.png", "shadow-map-2.png"])
        self.assertEqual(png(self.out / "shadow-map-0.png")[:2], (64, 64))
        self.assertEqual(png(self.out / "shadow-map-2.png")[:2], (3 * 64 + 2 * 4, 2 * 64 + 4))
        sun, _, lamp = shadows["rows"]
        pixels = 96 * 64  # the floor under the lid, seen from under it, fills the picture
        self.assertEqual((sun[1], sun[3], sun[4], sun[5]), (1, pixels, 0, pixels))  # all of it in shadow
        self.assertEqual((lamp[1], lamp[3], lamp[7]), (6, pixels, pixels))  # none of it
        self.assertEqual({c for row in png(self.out / "shadow-0.png")[3] for c in row}, {0})
        self.assertEqual({c for row in png(self.out / "shadow-2.png")[3] for c in row}, {255})
        self.assertEqual(self.table("lighting")["rows"][2][1], 0)  # its diffuse term
        text = (self.out / "index.html").read_text()
        self.assertLess(text.index('<section id="shadows">'), text.index('<section id="lighting">'))
        self.stages(*above, *lights, model="a.obj")
        self.assertFalse((self.out / "shadows.json").exists())

    def test_lights_beyond_the_eighth_share_a_term(self):
        lights = [word for i in range(11) for word in ("--light", f"directional:0,0,-1:color=0.0{i % 3 + 1},0,0")]
        terms = self.sum_of_terms_is_the_mean_of_the_picture(*lights)
        self.assertIn("Lights 8 to 10, all terms", terms)
        self.assertGreater(terms["Lights 8 to 10, all terms"], 0)

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

    def test_every_stage_has_a_picture_a_table_and_words(self):
        self.stages()
        for stage in STAGES:
            table = self.table(stage)
            self.assertTrue(table["pictures"], stage)
            self.assertTrue(table["numbers"] or table["rows"], stage)
            self.assertGreater(len(table["text"]), 100, stage)

    def test_the_projection_is_its_three_matrices_one_after_the_other(self):
        self.stages("--camera-view-angle", "50")
        camera, frustum, central, depth, clip = (self.table(s)["rows"] for s in STAGES[2:7])
        step_1, step_2 = (self.table(s)["numbers"]["matrix"] for s in STAGES[3:5])
        numbers = self.table("depth-mapping")["numbers"]

        def times(matrix, v):
            return [sum(a * b for a, b in zip(row, v)) for row in matrix]

        self.assertAlmostEqual(step_1[1][1], 1 / math.tan(math.radians(25)), 12)
        for i, row in enumerate(camera):
            p = times(step_1, [*row[2:], 1])
            self.assertEqual(p[:3], frustum[i][2:])
            q = times(step_2, p)
            for found, expected in zip(central[i][2:], (q[3], q[0] / q[3], q[1] / q[3])):
                self.assertAlmostEqual(found, expected, 12)
            self.assertAlmostEqual(q[2] / q[3], -1, 12)  # all lie in the plane
            self.assertAlmostEqual(clip[i][2], q[0], 6)  # the engine's own, in single precision
            self.assertAlmostEqual(clip[i][4], q[3], 6)
            for k, name in ((3, "from 0 to 1"), (4, "from -1 to 1")):
                r = times(numbers["matrix of steps 2 and 3, depth " + name], p)
                self.assertAlmostEqual(depth[i][k], r[2] / r[3], 12)
                self.assertEqual(r[:2] + r[3:], q[:2] + q[3:])
        for name, low in (("from 0 to 1", 0), ("from -1 to 1", -1)):
            for distance, expected in ((numbers["near"], low), (numbers["far"], 1)):
                r = times(numbers["matrix of steps 2 and 3, depth " + name], [0, 0, -distance, 1])
                self.assertAlmostEqual(r[2] / r[3], expected, 12)

    def test_a_parallel_projection_divides_by_nothing_and_maps_depth_evenly(self):
        self.stages("--camera-orthographic", "--view", "front")
        for row in self.table("central-projection")["rows"]:
            self.assertEqual(row[2], 1)
        near, far = (self.table("depth-mapping")["numbers"][name] for name in ("near", "far"))
        for _, _, distance, zero_one, minus_one, key in self.table("depth-mapping")["rows"]:
            self.assertAlmostEqual(zero_one, (distance - near) / (far - near), 12)
            self.assertAlmostEqual(minus_one, 2 * zero_one - 1, 12)
            self.assertAlmostEqual(key, 1 - zero_one, 12)
        self.assertIn("nothing can wrap round", self.table("wrap-round")["text"])

    def test_each_plane_cuts_what_passes_it(self):
        # Seen from (0, 0, 0) along -z with 90 degrees: behind the eye, through the left, through the right and top plane, inside.
        (self.folder / "a.obj").write_text("v -1 -1 -5\nv 1 -1 -5\nv 0 0 5\nf 1 2 3\nv -9 0 -5\nv 0 0 -5\nv 0 1 -5\nf 4 5 6\n"
                                         "v 0 0 -4\nv 9 0 -4\nv 0 9 -4\nf 7 8 9\nv 0 0 -3\nv 1 0 -3\nv 0 1 -3\nf 10 11 12\n")
        self.stages("--camera-position", "0,0,0", "--camera-focal-point", "0,0,-3", "--camera-view-angle", "90", model="a.obj")
        rows = {row[0]: row[1:] for row in self.table("clip-planes")["rows"]}
        self.assertEqual(rows["near"], [4, 1, 0, 12, 13])
        # What is left of the first one reaches beyond the sides and the bottom of the picture too.
        self.assertEqual([rows[plane][1] for plane in ("far", "left", "right", "bottom", "top")], [0, 2, 2, 1, 1])
        ordered = [row[1:] for row in self.table("clip-planes")["rows"]]
        for before, after in zip(ordered, ordered[1:]):
            self.assertEqual(before[4], after[3])
        self.assertEqual({p["file"] for p in self.table("clip-planes")["pictures"]},
                         {f"clip-{plane}.png" for plane in ("near", "left", "right", "bottom", "top")})

    def test_what_lies_behind_the_eye_wraps_round_only_without_clipping(self):
        (self.folder / "a.obj").write_text("v -1 -1 -5\nv 1 -1 -5\nv 0 -1 5\nf 1 2 3\n")
        self.stages("--camera-position", "0,0,0", "--camera-focal-point", "0,0,-3", model="a.obj")
        table = self.table("wrap-round")
        self.assertEqual(table["numbers"], {"triangles": 1, "through the eye's plane": 1, "wholly behind the eye": 0})
        wrong, right = (png(self.out / name)[3] for name in ("wrap-round.png", "wrap-round-clipped.png"))
        ground = wrong[0][:3]

        def shows(row):
            return any(row[3 * x:3 * x + 3] != ground for x in range(96))

        self.assertTrue(any(map(shows, wrong[:32])))  # the floor's end behind the eye stands in the sky
        self.assertFalse(any(map(shows, right[:32])))
        self.assertTrue(shows(right[63]))
        self.assertFalse(shows(wrong[63]))  # and the part under the eye is missing
        self.stages()
        table = self.table("wrap-round")
        self.assertEqual(table["numbers"]["through the eye's plane"], 0)
        self.assertIn("built-in example", table["text"])
        self.assertEqual([p["file"] for p in table["pictures"]], ["wrap-round-example.png", "wrap-round-example-clipped.png"])

    def test_blended_layers_lie_over_one_another_far_to_near(self):
        square = "v -1 -1 {z}\nv 1 -1 {z}\nv 1 1 {z}\nv -1 1 {z}\n"
        self.write("a.mtl", "newmtl wall\nKd 0 0 1\nnewmtl red\nKd 1 0 0\nd 0.25\nnewmtl green\nKd 0 1 0\nd 0.5\n")
        self.write("a.obj", "mtllib a.mtl\n" + "".join(square.format(z=z) for z in (2, 0, 1)) + "usemtl green\nf 1 2 3 4\nusemtl wall\nf 5 6 7 8\nusemtl red\nf 9 10 11 12\n")
        self.stages("--view", "front", "--shading", "unlit", model="a.obj")
        table = self.table("blended")
        self.assertEqual([row[0] for row in table["rows"]], [1, 2])
        middle = [[linear(c) for c in png(self.out / f"blended-{n}.png")[3][32][3 * 48:3 * 48 + 3]] for n in (0, 1, 2)]
        alphas = [png(self.out / f"blended-{n}-alpha.png")[3][32][3 * 48] for n in (1, 2)]
        self.assertEqual(alphas, [64, 128])
        for found, expected in zip(middle, ([0, 0, 1], [0.25, 0, 0.75], [0.125, 0.5, 0.375])):
            for a, b in zip(found, expected):
                self.assertAlmostEqual(a, b, delta=0.005)
        self.assertEqual((self.out / "blended-2.png").read_bytes(), (self.out / "picture.png").read_bytes())
        self.stages()
        self.assertEqual(self.table("blended")["numbers"], {"pixels that something is laid over": 0, "layers shown": 0})

    def test_terms_of_layers_are_in_the_pictures_of_the_light(self):
        square = "v -1 -1 {z}\nv 1 -1 {z}\nv 1 1 {z}\nv -1 1 {z}\n"
        self.write("a.mtl", "newmtl wall\nKd 0 0 1\nnewmtl red\nKd 1 0 0\nd 0.25\n")
        self.write("a.obj", "mtllib a.mtl\n" + "".join(square.format(z=z) for z in (0, 1)) + "usemtl wall\nf 1 2 3 4\nusemtl red\nf 5 6 7 8\n")
        self.stages("--view", "front", "--light", "directional:0,0,-1", model="a.obj")
        found = [linear(c) for c in png(self.out / "light-0-diffuse.png")[3][32][3 * 48:3 * 48 + 3]]
        for a, b in zip(found, (0.25, 0, 0.75)):
            self.assertAlmostEqual(a, b, delta=0.005)
        self.assertEqual(png(self.out / "light-0-diffuse.png")[3][32][3 * 48:3 * 48 + 3], png(self.out / "picture.png")[3][32][3 * 48:3 * 48 + 3])

    def test_several_samples_have_a_stage_of_their_own_and_the_picture_is_their_mean(self):
        for options in (("--samples", "4"), ("--samples", "8", "--anisotropy", "4")):
            self.stages(*options)
            run = self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE, *options, "--json")
            stats = json.loads(run.out)["rows"][0]["stats"]
            self.assertEqual((self.out / "picture.png").read_bytes(), (self.folder / "a.png").read_bytes())
            self.assertEqual((self.out / "shading-phong.png").read_bytes(), (self.folder / "a.png").read_bytes())
            table = self.table("samples")
            self.assertEqual(table["numbers"]["samples covered"], stats["samples_covered"])
            self.assertEqual(table["numbers"]["pixels covered"], stats["pixels_covered"])
            self.assertEqual(table["numbers"]["opaque triangles shaded, over all pixels"], stats["pixels_shaded"])
            self.assertEqual(sum(n * pixels for n, pixels, _ in table["rows"]), stats["samples_covered"])
            self.assertEqual(sum(n * pixels for n, _, pixels in table["rows"]), stats["pixels_shaded"])
            text = (self.out / "index.html").read_text()
            self.assertLess(text.index('<section id="samples">'), text.index('<section id="picture">'))
            for picture in table["pictures"]:
                self.assertTrue((self.out / picture["file"]).is_file())

    def test_shading_frequencies_are_those_of_render(self):
        self.stages()
        for shading, _, evaluations, difference in self.table("shading-frequency")["rows"]:
            run = self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE, "--shading", shading, "--json")
            self.assertEqual(json.loads(run.out)["rows"][0]["stats"]["lighting_evaluations"], evaluations, shading)
            self.assertEqual((self.folder / "a.png").read_bytes(), (self.out / f"shading-{shading}.png").read_bytes())
            self.assertEqual(difference == 0, shading == "phong")

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

    def test_in_the_world_the_camera_is_seen_from_one_side_wherever_it_stands(self):
        self.write("a.obj", "v 1 0 0\nv 0 0 1\nv -1 0 0\nv 0 0 -1\nv 0 1 0\nv 0 -1 0\n" +
                   "".join(f"f {i} {i % 4 + 1} {top}\n" for i in range(1, 5) for top in (5, 6)))
        pictures = []
        for view in ("front", "right", "back", "left"):
            self.stages("--view", view, model="a.obj")
            pictures.append(png(self.out / "world.png"))
        for picture in pictures[1:]:
            self.assertEqual(picture, pictures[0])

    def test_nothing_is_left_of_what_fails(self):
        for arguments in (("none.obj", "-o", "out"), ("builtin:teapot", "-o", "no/such/out", "--camera-index", "9"),
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
