#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""World files through the program: data/world from each camera, [render] and the command line, broken files, `rakelight check`.

  world_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import SQUARE, png

ROOM = pathlib.Path(__file__).resolve().parents[3] / "data/world/room.scene.toml"
WALL = "[[model]]\nfile = 'a.obj'\n"

# Text, line, column, a word of the reason. Each is a whole file.
BROKEN = [
    ("", 1, 1, "the world is empty"),
    ("[[model]\nfile = 'a.obj'\n", 1, 9, ""),
    ("[[model]]\nfile = a.obj\n", 2, 8, ""),
    ("[[model]]\nfile = 'a.obj'\nfile = 'a.obj'\n", 3, 8, "redefine"),
    ("[[model]]\nfile = 'a.obj'\npos = [0, 0, 0]\n", 3, 1, "unknown key 'pos' in [[model]]"),
    ("[[model]]\n", 1, 1, "lacks the key 'file'"),
    ("[[model]]\nfile = 'a.obj'\nposition = [0, '1', 0]\n", 3, 16, "not a text"),
    ("[[model]]\nfile = 'a.obj'\nposition = [0, inf, 0]\n", 3, 16, "finite"),
    ("[[model]]\nfile = 'a.obj'\nscale = [1, 0, 1]\n", 3, 9, "must not be 0"),
    ("[[model]]\nfile = '../a.obj'\n", 2, 8, "a.obj"),
    ("[[model]]\nfile = '/etc/passwd'\n", 2, 8, "absolute"),
    ("[[primitive]]\ntype = 'teapot'\ndivisions = 4\ntolerance = 0.1\n", 4, 13, "either 'divisions' or 'tolerance'"),
    ("[[model]]\nfile = 'builtin:sphere:tolernce=0.1'\n", 2, 8, "did you mean 'tolerance'?"),
    (WALL + "[[modell]]\nfile = 'a.obj'\n", 3, 3, "unknown section 'modell'"),
    (WALL + "[[light]]\ntype = 'lamp'\n", 4, 8, "unknown word 'lamp'"),
    (WALL + "[[light]]\ntype = 'ambient'\nposition = [0, 0, 0]\n", 5, 12, "has no 'position'"),
    (WALL + "[[light]]\ntype = 'spot'\nposition = [0, 0, 0]\ndirection = [0, 0, 0]\n", 6, 13, "must not be zero"),
    (WALL + "[[light]]\ntype = 'photometric-point'\nposition = [0, 0, 0]\nintensity_cd = -1\n", 6, 16, "at least 0"),
    (WALL + "[[camera]]\nposition = [0, 0, 1]\nvertical_fov_deg = 0\n", 5, 20, "more than 0"),
    (WALL + "[[camera]]\nposition = [0, 0, 0]\n", 4, 12, "must not be the same"),
    (WALL + "[[material]]\nname = 'x'\nroughness = 1.5\n", 5, 13, "at most 1"),
    (WALL + "[[material]]\nname = 'default'\nnormal_texture = 'none.png'\n", 5, 18, "none.png"),
    (WALL + "[fog]\nkind = 'linear'\nstart = 3\nend = 2\n", 6, 7, "more than 'start'"),
    (WALL + "[render]\nresolutoin = [8, 8]\n", 4, 1, "unknown key 'resolutoin' in [render]"),
    (WALL + "[render]\nresolution = 8\n", 4, 1, "line 4, column 1: resolution: "),
    (WALL + "[render]\nlighting = 'shiny'\n", 4, 1, "line 4, column 1: lighting: "),
    (WALL + "[render]\nedges = 'maybe'\n", 4, 1, "true or false"),
    (WALL + "[render]\noutput = 'b.png'\n", 4, 1, "an option of the command line only"),
    (WALL + "[render]\nheight-map = '../secret.png'\n", 4, 1, "secret.png"),
    (WALL + "[render]\nbump = 'paralax'\n", 4, 1, "did you mean 'parallax'?"),
    (WALL + "[render]\ncamera-index = 'frnt'\n[[camera]]\nname = 'front'\nposition = [0, 0, 9]\n", 4, 1, "did you mean 'front'?"),
    (WALL + "[render]\nheight-map = 'none.png'\n", 4, 1, "'none.png': "),
    (WALL + "[[material]]\nname = 'unused'\nnormal_texture = 'none.png'\n", 5, 18, "none.png"),
    (WALL + "shading = 'smooth'\n", 3, 11, "unknown word 'smooth'"),
    ("[[primitive]]\ntype = 'plane'\nobjects = 99\n", 3, 11, "the objects of a plane must be"),
    (WALL + "[render]\nmaterial = 'clearcoat=1'\n", 4, 1, "[[material]] changes materials"),
    (WALL + "[render]\nresolution = [0, 1]\n", 4, 1, ": resolution: must be 1 to 65536"),
    (WALL + "[render]\nsamples = 4\nwindow = [0, 0, 9999, 1]\n", 5, 1, ": window: does not lie inside the picture of 1280 x 720"),
    (WALL + "[render]\nengine = 'hard'\n", 4, 1, ": engine: 'hard' is not built in; this build has: soft"),
    (WALL + "[[light]]\ntype = 'point'\nposition = [0, 0, 3]\n[render]\nshadows = true\nshadow-size = 8192\n", 8, 1, "6 shadow maps of 8192 x 8192"),
]


class Worlds(program.Case):
    def setUp(self):
        super().setUp()
        self.write("a.obj")

    def render(self, text, *arguments):
        self.write("w.scene.toml", text)
        result = self.run_program("render", "w.scene.toml", "-o", "a.png", *arguments)
        self.assertEqual((result.code, result.err), (0, ""))
        return png(self.folder / "a.png")

    def test_shapes_of_the_command_line_are_those_of_a_world(self):
        self.write("w.scene.toml", "[[primitive]]\ntype = 'torus'\nradius = 2\ntube_radius = 0.5\ntolerance = 0.02\n")
        for model in ("w.scene.toml", "builtin:torus:radius=2:tube_radius=0.5:tolerance=0.02"):
            result = self.run_program("render", model, "-o", "{model}.png", "--resolution", "32,24", "--view", "front")
            self.assertEqual(result.code, 0, result.err)
        words = "torus-radius-2-tube_radius-0.5-tolerance-0.02.png"
        self.assertEqual((self.folder / "w.png").read_bytes(), (self.folder / words).read_bytes())
        self.check_refused(self.run_program("render", "builtin:cone:tube_radius=1", "-o", "a.png"), 2, "a cone has no 'tube_radius'")

    def test_three_models_four_lights_and_three_cameras_render_from_each_camera(self):
        summary = json.loads(self.run_program("check", ROOM, "--json").out)["rows"][0]
        self.assertEqual(summary["parts"], ["table", "books", "bowl", "teapot", "orange", "floor"])
        self.assertEqual(summary["cameras"], ["room", "close", "plan"])
        self.assertEqual(summary["lights"], ["ambient", "directional", "point", "photometric spot 'lamp'"])
        pictures = set()
        for camera in ("0", "1", "2", "close"):
            result = self.run_program("render", ROOM, "-o", "r.png", "--camera-index", camera, "--resolution", "96,60", "--json")
            self.assertEqual((result.code, result.err), (0, ""))
            row = json.loads(result.out)["rows"][0]
            self.assertGreater(row["stats"]["pixels_covered"], 96 * 60 // 2)
            pictures.add((self.folder / "r.png").read_bytes())
        self.assertEqual(len(pictures), 3)

    def test_the_first_camera_is_the_default_and_the_world_says_the_size(self):
        self.assertEqual(self.run_program("render", ROOM, "-o", "a.png").code, 0)
        self.assertEqual(png(self.folder / "a.png")[:2], (640, 400))
        self.assertEqual(self.run_program("render", ROOM, "-o", "b.png", "--camera-index", "room").code, 0)
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_the_command_line_goes_before_the_world(self):
        text = WALL + "[render]\nresolution = [20, 10]\nbackground = '#ff0000'\nview = 'front'\nwireframe = true\nshadows = true\n"
        self.assertEqual(self.render(text)[:2], (20, 10))
        width, height, _, rows = self.render(text, "--resolution", "12,8", "--shadows", "off")
        self.assertEqual((width, height), (12, 8))
        self.assertEqual(tuple(rows[0][:3]), (255, 0, 0))
        self.render(text, "--camera-position", "0,0,5")  # excludes the world's view

    def test_options_that_may_be_repeated_come_as_an_array(self):
        lights = "[render]\nlight = ['ambient:0.2,0.2,0.2', 'ambient:0.2,0.2,0.2']\nresolution = [16, 12]\nview = 'front'\ncolor = '#ffffff'\n"
        self.assertEqual(self.render(WALL + lights)[3][6][24], 170)  # 0.4 of light as sRGB

    def test_shading_of_a_part_goes_to_that_part(self):
        # Two of one name: what says it is meant, not what is called so.
        text = WALL + "[[model]]\nfile = 'a.obj'\nshading = 'unlit'\nposition = [3, 0, 0]\n[render]\nresolution = [40, 20]\nview = 'front'\n"
        self.write("w.scene.toml", text)

        def lit(*options):  # pixels that lighting was evaluated at, of those that are covered
            run = self.run_program("render", "w.scene.toml", "-o", "a.png", "--json", *options)
            stats = json.loads(run.out)["rows"][0]["stats"]
            return stats["lighting_evaluations"] / stats["pixels_covered"]

        self.assertEqual(lit(), 0.5)
        self.assertEqual(lit("--shading", "phong"), 1)  # of the command line: for the whole
        self.assertEqual(lit("--shading", "object:nobody=flat"), 0.5)
        self.write("w.scene.toml", text + "shading = 'phong'\n")  # of the world: for parts that say nothing
        self.assertEqual(lit(), 0.5)

    def test_what_render_names_need_not_be_there_where_the_command_line_takes_its_place(self):
        self.write("b.scene.toml", "[[model]]\nfile = 'a.obj'\n[render]\nresolution = [16, 12]\ncamera-index = 'none'\n[[camera]]\nname = 'front'\nposition = [0, 0, 9]\n")
        self.check_refused(self.run_program("render", "b.scene.toml", "-o", "b.png"), 4, "there is no camera 'none'")
        for options in (("--camera-index", "front"), ("--view", "front"), ("--camera-position", "0,0,9")):
            result = self.run_program("render", "b.scene.toml", "-o", "b.png", *options)
            self.assertEqual((result.code, result.err), (0, ""), options)
        self.write("c.scene.toml", WALL + "[render]\nresolution = [16, 12]\nhdri-file = 'none.exr'\nhdri-ambient = true\n")
        self.check_refused(self.run_program("render", "c.scene.toml", "-o", "c.png"), 3, "none.exr")
        self.run_program("render", "b.scene.toml", "-o", "sky.hdr", "--view", "front", "--resolution", "16,8")
        result = self.run_program("render", "c.scene.toml", "-o", "c.png", "--hdri-file", "sky.hdr")
        self.assertEqual((result.code, result.err), (0, ""))

    def test_an_environment_of_a_world_can_be_switched_off(self):
        world = WALL + "[environment]\n[render]\nresolution = [16, 12]\nview = 'front'\ncolor = '#ffffff'\n"
        plain = self.render(world.replace("[environment]\n", ""))
        self.assertNotEqual(self.render(world), plain)
        self.assertEqual(self.render(world, "--hdri-ambient", "off", "--hdri-skybox", "off"), plain)
        background = self.render(world)[3][0][:3]
        unlit = self.render(world, "--hdri-ambient", "off")
        self.assertEqual(unlit[3][0][:3], background)
        self.assertEqual(unlit[3][6][24:27], plain[3][6][24:27])
        self.assertEqual(self.render(world + "hdri-ambient = false\nhdri-skybox = false\n"), plain)

    def test_bench_draws_the_picture_that_the_world_asks_for(self):
        text = WALL + "[[camera]]\nposition = [0, 0, 9]\n[[camera]]\nname = 'side'\nposition = [4, 0, 9]\n[render]\n"
        text += "resolution = [24, 12]\ncamera-index = 'side'\nlight = ['ambient:0.3,0.2,0.1']\nexposure = 1\nbackground = '#102030'\nchannels = 'depth'\n"
        expected = self.render(text)
        result = self.run_program("bench", "render", "w.scene.toml", "--frames", "1", "-o", "b.png", "--json")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(png(self.folder / "b.png"), expected)
        self.run_program("bench", "render", "w.scene.toml", "--frames", "1", "-o", "b.png", "--resolution", "12,6", "--shading", "unlit")
        self.assertEqual(png(self.folder / "b.png"), self.render(text, "--resolution", "12,6", "--shading", "unlit"))
        self.write("v.scene.toml", WALL)
        sizes = json.loads(self.run_program("bench", "render", "v.scene.toml", "--frames", "1", "--json").out)
        self.assertEqual((sizes["width"], sizes["height"]), (1920, 1080))

    def test_every_verb_that_takes_a_scene_takes_a_world(self):
        self.write("w.scene.toml", WALL + "[render]\nresolution = [16, 12]\nchannels = 'depth'\n")
        for arguments in (("inspect", "w.scene.toml"), ("explain", "w.scene.toml", "--pixel", "8,6"), ("stages", "w.scene.toml", "-o", "s"),
                          ("bench", "render", "w.scene.toml", "--frames", "1", "--resolution", "16,12"), ("check", "w.scene.toml")):
            result = self.run_program(*arguments)
            self.assertEqual((result.code, result.err), (0, ""), arguments)
        self.assertEqual(self.run_program("smooth", "w.scene.toml", "-o", "b.glb").code, 0)
        self.assertEqual(self.run_program("check", "b.glb").code, 0)

    def test_smooth_takes_the_crease_angles_of_parts(self):
        roof = "v -1 0 0\nv 1 0 0\nv -1 1 1\nv 1 1 1\nv -1 2 0\nv 1 2 0\nf 1 2 4\nf 1 4 3\nf 3 4 6\nf 3 6 5\n"  # bends by 90 degrees
        self.write("roof.obj", roof)

        def vertices(keys):
            self.write("w.scene.toml", "[[model]]\nfile = 'roof.obj'\n" + keys)
            result = self.run_program("smooth", "w.scene.toml", "-o", "b.obj", "--crease-angle", "60")
            self.assertEqual(result.code, 0, result.err)
            return (self.folder / "b.obj").read_text().count("\nvn "), result.err

        self.assertGreater(vertices("")[0], vertices("crease_angle_deg = 100\n")[0])
        self.assertNotIn("warning", vertices("crease_angle_deg = 100\n")[1])
        self.assertIn("warning: w.scene.toml: what parts say of their normals has no effect: all are smoothed alike", vertices("normals = 'flat'\n")[1])

    def test_settings_for_normals_without_effect_are_named(self):
        places = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        self.write("given.obj", places + "vn 0 0 1\nf 1//1 2//1 3//1\n")
        self.write("made.obj", places + "f 1 2 3\n")
        for command in (("render", "-o", "a.png", "--resolution", "8,8"), ("smooth", "-o", "b.obj")):
            def said(model, *options):
                result = self.run_program(command[0], model, *command[1:], *options)
                self.assertEqual(result.code, 0, result.err)
                return result.err
            self.assertIn("warning: given.obj: --weight: no effect, because no normals are computed", said("given.obj", "--weight", "max"))
            for quiet in (("made.obj", "--weight", "max"), ("given.obj",), ("given.obj", "--weight", "max", "--normals", "model")):
                self.assertNotIn("no effect", said(*quiet), quiet)

    def test_broken_worlds_get_one_line_with_line_and_column(self):
        self.assertGreater(len(BROKEN), 20)
        for text, line, column, words in BROKEN:
            with self.subTest(text):
                self.write("w.scene.toml", text)
                place = f"w.scene.toml: line {line}, column {column}: "
                for arguments in (("render", "w.scene.toml", "-o", "a.png"), ("check", "w.scene.toml")):
                    result = self.run_program(*arguments)
                    self.check_refused(result, 3 if "none.png" in text else 4, place, words)
        self.assertEqual(self.files(), ["a.obj", "w.scene.toml"])

    def test_a_world_that_is_not_there_is_not_found_and_others_are_drawn(self):
        self.write("bad.scene.toml", "[[model]]\nfile = 'a.obj'\nx = 1\n")
        result = self.run_program("render", "none.scene.toml", "bad.scene.toml", "a.obj", "-o", "{model}.png", "--resolution", "16,12")
        self.assertEqual((result.code, len(result.lines)), (4, 2), result.err)
        self.assertEqual(self.files(), ["a.obj", "a.png", "bad.scene.toml"])

    def test_a_missing_model_is_not_found_by_its_name(self):
        self.write("w.scene.toml", "[[model]]\nfile = 'none.obj'\n")
        for arguments in (("check", "w.scene.toml"), ("render", "w.scene.toml", "-o", "a.png")):
            self.check_refused(self.run_program(*arguments), 3, "w.scene.toml: line 2, column 8: 'none.obj'")

    def test_an_option_of_the_command_line_against_one_of_the_world_names_both(self):
        self.write("w.scene.toml", WALL + "[render]\nsamples = 4\n")
        result = self.run_program("render", "w.scene.toml", "-o", "a.png", "--visibility", "painter")
        self.check_refused(result, 2, "--samples: 4 samples need --visibility z-reversed", "--samples is of w.scene.toml, line 4, column 1",
                           "--visibility is given")
        self.write("w.scene.toml", WALL + "[render]\nsamples = 4\nvisibility = 'painter'\n")
        self.check_refused(self.run_program("render", "w.scene.toml", "-o", "a.png"), 4, "w.scene.toml: line 4, column 1")

    def test_a_fault_of_the_command_line_is_not_said_at_the_worlds_option(self):
        self.write("w.scene.toml", WALL + "[[light]]\ntype = 'point'\nposition = [0, 0, 3]\n[render]\nshadows = true\nshadow-size = 64\nwindow = [0, 0, 99, 9]\n")
        result = self.run_program("render", "w.scene.toml", "-o", "a.png", "--shadow-size", "8192")
        self.check_refused(result, 2, "w.scene.toml: --shadow-size: 6 shadow maps")
        result = self.run_program("render", "w.scene.toml", "-o", "a.png", "--resolution", "50,50")
        self.check_refused(result, 2, "does not lie inside the picture of 50 x 50 pixels", "--window is of w.scene.toml, line 9, column 1",
                           "--resolution is given")

    def test_keys_of_materials_on_the_command_line_are_those_of_world_files(self):
        for words, text in ((("color=#4080c0", "specular=0.5,0.5,0.5", "shininess=9"), "color = '#4080c0'\nspecular = [0.5, 0.5, 0.5]\nshininess = 9\n"),
                            (("metallic=1", "roughness=0.3", "anisotropy=0.8", "anisotropy_rotation_deg=40"),
                             "metallic = 1\nroughness = 0.3\nanisotropy = 0.8\nanisotropy_rotation_deg = 40\n"),
                            (("lighting=ward", "ward_alpha=0.1,0.4"), "lighting = 'ward'\nward_alpha = [0.1, 0.4]\n"),
                            (("lighting=oren-nayar", "sigma_deg=40", "double_sided=on"), "lighting = 'oren-nayar'\nsigma_deg = 40\ndouble_sided = true\n"),
                            (("clearcoat=1", "sheen_color=#ff8000", "sheen_roughness=0.4", "emission=0.1,0,0", "ior=1.8"),
                             "clearcoat = 1\nsheen_color = '#ff8000'\nsheen_roughness = 0.4\nemission = [0.1, 0, 0]\nior = 1.8\n")):
            ball = "[[primitive]]\ntype = 'sphere'\n[render]\nresolution = [40, 30]\n"
            plain = self.render(ball)
            keys = [part for word in words for part in ("--material", word)]
            by_words = self.render(ball, *keys)
            self.assertEqual(by_words, self.render(ball + "[[material]]\nname = '*'\n" + text), words)
            self.assertNotEqual(by_words, plain, words)

    def test_a_picture_of_opacity_alone_is_blended(self):
        shutil.copy(ROOM.parents[1] / "maps/dents_height.png", self.folder / "holes.png")
        flat = WALL + "[[material]]\nname = 'default'\nunlit = true\ncolor = [1, 1, 1]\n"
        ends = "[render]\nresolution = [40, 30]\nview = 'front'\nuv = 'box'\nbackground = '#ff0000'\n"
        self.assertEqual({tuple(self.render(flat + ends)[3][15][57:60])}, {(255, 255, 255)})
        row = self.render(flat + "opacity_texture = 'holes.png'\n" + ends)[3][15]
        self.assertTrue(any(row[3 * x] == 255 and 0 < row[3 * x + 1] < 255 for x in range(40)), row)

    def test_surroundings_are_turned_and_multiplied_by_the_command_line(self):
        lit = ("--hdri-ambient", "--resolution", "40,30", "--json")
        def sum_of(*options):
            result = self.run_program("render", "builtin:sphere", "-o", "a.png", *lit, *options)
            self.assertEqual((result.code, result.err), (0, ""))
            return [sum(row) for row in png(self.folder / "a.png")[3]], (self.folder / "a.png").read_bytes()
        plain, half, turned = sum_of(), sum_of("--hdri-intensity", "0.5"), sum_of("--hdri-rotation", "90")
        self.assertLess(sum(half[0]), sum(plain[0]))
        self.assertNotEqual(turned[1], plain[1])
        self.assertEqual(sum_of("--hdri-rotation", "360")[0], plain[0])
        result = self.run_program("render", "a.obj", "-o", "a.png", "--resolution", "8,8", "--hdri-intensity", "2")
        self.assertIn("no effect", result.err)

    def test_a_square_picture_of_the_surroundings_is_warned_of_at_its_place(self):
        shutil.copy(ROOM.parents[1] / "maps/dents_height.png", self.folder / "square.png")
        self.write("w.scene.toml", WALL + "[environment]\nfile = 'square.png'\n")
        result = self.run_program("check", "w.scene.toml")
        self.assertEqual(result.code, 0)
        self.assertIn("w.scene.toml: line 4, column 8: the environment is", result.err)

    def test_a_world_that_cannot_be_drawn_does_not_keep_others_from_it(self):
        self.write("w.scene.toml", WALL + "[render]\nresolution = [0, 1]\n")
        result = self.run_program("render", "w.scene.toml", "a.obj", "-o", "{model}.png")
        self.assertEqual((result.code, len(result.lines)), (4, 1), result.err)
        self.assertIn("a.png", self.files())

    def test_a_world_without_scene_in_its_ending_is_told_so(self):
        self.write("mine.toml", WALL)
        self.check_refused(self.run_program("check", "mine.toml"), 4, "world files end in .scene.toml")

    def test_a_word_behind_a_switch_that_is_no_model_is_refused(self):
        result = self.run_program("render", "a.obj", "--bump-self-shadow", "maybe", "-o", "b.png")
        self.check_refused(result, 2, "--bump-self-shadow: unknown word 'maybe'; use one of: on, off")
        self.write("plain")  # a model, if one of no known kind
        self.assertNotEqual(self.run_program("render", "--shadows", "plain", "-o", "b.png").code, 2)
        self.check_refused(self.run_program("render", "--shadows", "none.obj", "-o", "b.png"), 3, "none.obj")

    def test_the_order_of_a_lights_properties_does_not_matter(self):
        pictures = set()
        for light in ("specular=0,0,0:color=1,1,1", "color=1,1,1:specular=0,0,0", "color=1,1,1"):
            result = self.run_program("render", "builtin:sphere", "-o", "b.png", "--resolution", "40,40", "--lighting", "phong",
                                      "--light", "directional:0,-1,-1:" + light)
            self.assertEqual((result.code, result.err), (0, ""))
            pictures.add((self.folder / "b.png").read_bytes())
        self.assertEqual(len(pictures), 2)  # the last has a highlight

    def test_models_that_say_model_are_one_surface_in_the_picture_and_for_inspect(self):
        slope = "v 0 0 0\nv 1 -1 0\nv 1 -1 1\nv 0 0 1\nf 1 4 3 2\n"
        self.write("slope.obj", slope)
        parts = "".join(f"[[model]]\nfile = 'slope.obj'\nscale = {scale}\nKEYS" for scale in ("[1, 0.5, 2]", "[-1, 2, 2]"))
        keys = {"silent": "", "model": "normals = 'model'\ncrease_angle_deg = 180\n", "object": "normals = 'object'\ncrease_angle_deg = 180\n"}
        for name, key in keys.items():
            self.write(name + ".scene.toml", parts.replace("KEYS", key))
        look = ("--resolution", "96,64", "--camera-position", "0,3,5", "--camera-focal-point", "0,-0.5,0.5", "--light", "directional:1,-1,-1")

        def picture(name, *options):
            done = self.run_program("render", name + ".scene.toml", "-o", name + ".png", *look, *options)
            self.assertEqual(done.code, 0, done.err)
            return (self.folder / (name + ".png")).read_bytes()

        def seam(name, *options):
            return json.loads(self.run_program("inspect", name + ".scene.toml", "--json", *options).out)["rows"][0]["seams"]["seam_deg"]

        for scope in ("model", "object"):
            as_requested = picture("silent", "--normals", scope, "--crease-angle", "180")
            self.assertEqual(picture(scope), as_requested, scope)
        self.assertNotEqual(picture("model"), picture("object"))
        self.assertLess(seam("model"), 1e-6)
        self.assertGreater(seam("object"), 60)
        self.assertAlmostEqual(seam("object"), seam("silent", "--normals", "object", "--crease-angle", "180"), places=3)
        mixed = parts.replace("KEYS", keys["model"], 1).replace("KEYS", "")
        self.write("mixed.scene.toml", mixed)
        self.assertEqual(picture("mixed", "--crease-angle", "180"), picture("model"), "a silent part by the picture's options")
        self.assertLess(seam("mixed", "--crease-angle", "180"), 1e-6)
        for scope in ("model", "object"):
            self.write("asked.scene.toml", f"[render]\nnormals = '{scope}'\ncrease-angle = 180\n" + parts.replace("KEYS", keys["model"], 1).replace("KEYS", ""))
            self.assertEqual(picture("asked"), picture(scope))
            self.assertAlmostEqual(seam("asked"), seam(scope), places=3)
        self.assertIn("at 60 to 180 degrees", self.run_program("inspect", "mixed.scene.toml", "--crease-angle", "60").out)
        self.write("auto.scene.toml", "[render]\nnormals = 'model'\n" + parts.replace("KEYS", ""))
        self.assertEqual(picture("auto"), picture("silent", "--normals", "model", "--crease", "auto"))
        self.write("angle.scene.toml", "[render]\nnormals = 'model'\ncrease = 'angle'\n" + parts.replace("KEYS", ""))
        self.assertEqual(picture("angle"), picture("silent", "--normals", "model", "--crease-angle", "60"))
        self.assertEqual(picture("auto", "--crease-angle", "180"), picture("silent", "--normals", "model", "--crease-angle", "180"), "a given angle overrides the file")
        self.assertIn("hard edges: ", self.run_program("inspect", "auto.scene.toml").out)
        self.assertEqual(picture("model", "--weight", "area"), picture("silent", "--normals", "model", "--crease-angle", "180", "--weight", "area"))

    def test_files_outside_of_the_folder_need_to_be_allowed(self):
        (self.folder / "deep").mkdir()
        (self.folder / "deep/w.scene.toml").write_text("[[model]]\nfile = '../a.obj'\n")
        self.check_refused(self.run_program("check", "deep/w.scene.toml"), 4, "line 2, column 8")
        self.assertEqual(self.run_program("check", "deep/w.scene.toml", "--allow-outside").code, 0)

    def test_two_models_side_by_side_are_where_the_world_puts_them(self):
        text = "[[model]]\nfile = 'a.obj'\nposition = [-1.5, 0, 0]\nmaterial = 'red'\n[[model]]\nfile = 'a.obj'\nposition = [1.5, 0, 0]\n" \
               "material = 'blue'\n[[material]]\nname = 'red'\ncolor = '#ff0000'\nunlit = true\n[[material]]\nname = 'blue'\ncolor = '#0000ff'\n" \
               "unlit = true\n[[camera]]\nposition = [0, 0, 9]\northographic_height = 4\n[render]\nresolution = [80, 40]\n"
        rows = self.render(text)[3]
        at = lambda x: tuple(rows[20][3 * x:3 * x + 3])
        self.assertEqual((at(25), at(55)), ((255, 0, 0), (0, 0, 255)))
        self.assertNotIn(at(40), ((255, 0, 0), (0, 0, 255)))

    def test_a_model_alone_is_checked_too(self):
        self.write("b.obj", SQUARE.format(name="b"))
        result = self.run_program("check", "a.obj", "b.obj")
        self.assertEqual((result.code, result.err), (0, ""))
        self.assertEqual(result.out.splitlines()[0], "a.obj: model, 1 object, 2 triangles, 1 material, 0 textures")
        self.check_refused(self.run_program("check"), 2, "needs a scene")
        self.assertEqual(json.loads(self.run_program("check", "--schema").out)["additionalProperties"], False)


if __name__ == "__main__":
    program.main()
