#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drops files on rakelight-view as file managers do, drags lights by their handles, and reads what it copies.

  drop_test.py PROGRAM VIEWER [unittest arguments]

Runs itself under xvfb-run, or is skipped, as viewer_test.py."""
import shlex
import shutil
import subprocess
import sys

import support
from support import ROOT, SHARED, SIZE, Case, png, wait_for

# Two squares beside each other, seen from the front: the left half of the picture shows "left", of the material "red".
MAPPED = ("mtllib m.mtl\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
          "o left\nv -2 -1 0\nv 0 -1 0\nv 0 1 0\nv -2 1 0\nusemtl red\nf 1/1 2/2 3/3 4/4\n"
          "o right\nv 0 -1 0\nv 2 -1 0\nv 2 1 0\nv 0 1 0\nusemtl gray\nf 5/1 6/2 7/3 8/4\n")
LEFT = {"x": SIZE[0] // 2 - 60, "y": SIZE[1] // 2}


def copied_picture(case, window):
    """What the copied command line draws."""
    window.key("ctrl+c")
    line = wait_for(lambda: (window.clipboard() or "").startswith("rakelight render") and window.clipboard(), "nothing was copied")
    words = shlex.split(line)
    done = subprocess.run([support.PROGRAM, *words[1:]], cwd=case.folder, capture_output=True, text=True)
    case.assertEqual(done.returncode, 0, f"{line}\n{done.stderr}")
    return png(case.folder / words[words.index("-o") + 1])


class Drops(Case):
    def setUp(self):
        super().setUp()
        (self.folder / "mapped.obj").write_text(MAPPED)
        shutil.copy(ROOT / "data" / "bricks" / "normal.png", self.folder / "bricks.png")
        shutil.copy(ROOT / "data" / "environment" / "ramp.hdr", self.folder)

    def model_file(self, window):
        return window.save()[1]["model"][0]["file"]

    def check_saved(self, window, path):
        """The saved scene is drawn as the window shows it."""
        self.assertTrue(self.render(path) == png(window.screenshot()))

    def test_a_dropped_model_is_opened_in_place_of_the_list(self):
        window = self.open("parts.obj", "builtin:teapot")
        before = window.settled_picture()
        window.drop("mapped.obj")
        window.differs_from(before)
        after = window.settled_picture()
        self.assertEqual(self.model_file(window), "mapped.obj")
        window.differs_from(after, 50)  # the message, which goes when a file is loaded
        window.key("Right")  # it is alone
        wait_for(lambda: window.picture() == after, "another model is shown")
        self.assertEqual(self.model_file(window), "mapped.obj")

    def test_pictures_from_elsewhere_are_saved_with_the_scene(self):
        window = self.open("mapped.obj")
        before = window.settled_picture()
        window.drop(ROOT / "data" / "bricks" / "normal.png", **LEFT)
        window.differs_from(before, 2000)
        window.settled_picture()
        path, scene = window.save()
        self.assertTrue((self.folder / "mapped-files" / "normal.png").exists())
        self.check_saved(window, path)  # without allow-outside

    def test_a_model_dropped_with_control_is_added(self):
        window = self.open("parts.obj")
        before = window.settled_picture()
        window.drop("mapped.obj", held=["Control_L"])
        window.differs_from(before)
        self.assertEqual(self.model_file(window), "mapped.obj")
        window.settled_picture()
        window.key("Left")
        wait_for(lambda: self.model_file(window) == "parts.obj", "the first model did not come back")

    def test_a_dropped_folder_is_the_list_of_its_models(self):
        for name in ("a.obj", "b.obj"):
            (self.folder / "both").mkdir(exist_ok=True)
            (self.folder / "both" / name).write_text(MAPPED.replace("v 2 1 0", "v 2 1 1" if name == "b.obj" else "v 2 1 0"))
        window = self.open("parts.obj")
        before = window.settled_picture()
        window.drop("both")
        window.differs_from(before)
        before = window.settled_picture()
        window.key("Right")
        window.differs_from(before)

    def test_a_picture_textures_the_object_it_is_dropped_on(self):
        window = self.open("mapped.obj", "--view", "front")
        before = window.settled_picture()
        window.drop("bricks.png", **LEFT)
        window.differs_from(before, 5000)
        after, middle = window.settled_picture(), 3 * (SIZE[0] // 2)
        self.assertTrue([row[middle + 30:] for row in before[:400]] == [row[middle + 30:] for row in after[:400]], "the other object changed")
        path, scene = window.save()
        self.assertEqual([(m["name"], m["color_texture"]) for m in scene["material"]], [("red", "bricks.png")])
        self.check_saved(window, path)

    def test_a_picture_dropped_beside_the_model_is_not_taken(self):
        window = self.open("mapped.obj", "--view", "front")
        before = window.settled_picture()
        window.drop("bricks.png", x=SIZE[0] // 2, y=4)
        window.differs_from(before, 100)  # the message
        self.assertNotIn("material", window.save()[1])

    def test_a_radiance_map_becomes_the_environment(self):
        window = self.open("mapped.obj", "--view", "front")
        before = window.settled_picture()
        window.drop("ramp.hdr")
        window.differs_from(before, SIZE[0] * SIZE[1] // 4)  # the background
        window.settled_picture()
        path, scene = window.save()
        self.assertEqual(scene["render"]["hdri-file"], "ramp.hdr")
        self.check_saved(window, path)

    def test_a_picture_dropped_with_shift_becomes_the_environment(self):
        window = self.open("mapped.obj", "--view", "front")
        before = window.settled_picture()
        window.drop("bricks.png", held=["Shift_L"])
        window.differs_from(before, SIZE[0] * SIZE[1] // 4)
        self.assertEqual(window.save()[1]["render"]["hdri-file"], "bricks.png")

    def hostile_files(self):
        """One of each kind; without the set, some of our own."""
        names = ("garbage/random.glb", "glb/chunk_4g.glb", "truncated/cube_binary_50.ply", "truncated/Spider_binary_3.stl", "empty/empty.obj")
        found = [SHARED / "hostile" / name for name in names]
        for name, content in (("own.glb", b"glTF nonsense"), ("own.stl", b""), ("own.txt", b"no model at all"), ("own.hdr", b"#?RADIANCE\n")):
            (self.folder / name).write_bytes(content)
        return [path for path in found if path.exists()] + [self.folder / name for name in ("own.glb", "own.stl", "own.txt")]

    def test_hostile_files_give_one_line_and_leave_the_model(self):
        window = self.open("mapped.obj", "--view", "front")
        clean = window.settled_picture()
        files = self.hostile_files()
        for file in files:
            window.drop(file)
            window.differs_from(clean, 100, f"after {file.name}")  # the message
            shown = window.settled_picture()
            self.assertTrue([row for row in shown[100:380]] == [row for row in clean[100:380]], f"the model went away after {file.name}")
            window.key("Escape")  # the message goes away
            wait_for(lambda: window.picture() == clean, f"the message of {file.name} stays")
        self.assertEqual(self.model_file(window), "mapped.obj")
        code, err = window.close()
        self.assertEqual(code, 0)
        lines = err.splitlines()[:-1]  # the last one is of --stats
        self.assertEqual(len(lines), len(files), err)
        for file, line in zip(files, lines):
            self.assertRegex(line, f"^rakelight: error: .*{file.name}")

    def test_a_broken_radiance_map_is_told_of_and_taken_back(self):
        self.hostile_files()
        window = self.open("mapped.obj", "--view", "front")
        clean = window.settled_picture()
        window.drop("own.hdr")
        window.differs_from(clean, 100)
        window.settled_picture()
        window.key("Escape")
        wait_for(lambda: window.picture() == clean, "the picture before did not come back")
        self.assertNotIn("hdri-file", window.save()[1]["render"])


class Handles(Case):
    CAMERA = "[[camera]]\nposition = [0, 0.5, 6]\ntarget = [0, 0.5, 0]\n"

    def open_with_light(self, light):
        """With the light's handles shown; and which pixels they changed."""
        (self.folder / "light.scene.toml").write_text("[[model]]\nfile = 'parts.obj'\n[[light]]\n" + light + self.CAMERA)
        window = self.open("light.scene.toml")
        before = window.settled_picture()
        window.key("d")
        window.differs_from(before, 20)
        after = window.settled_picture()
        changed = [(x, y) for y in range(SIZE[1]) if before[y] != after[y] for x in range(SIZE[0]) if before[y][3 * x:3 * x + 3] != after[y][3 * x:3 * x + 3]]
        return window, after, changed

    def drag(self, window, x, y, dx, dy):
        moves = [word for _ in range(5) for word in ("mousemove_relative", "--", str(dx // 5), str(dy // 5))]
        window.tool("mousemove", x, y, "mousedown", 1, *moves, "mouseup", 1)

    def light(self, window):
        return window.save()[1]["light"][0]

    def test_an_axis_moves_a_lamp_along_itself(self):
        window, before, _ = self.open_with_light("type = 'point'\nposition = [0, 0.5, 1]\n")
        self.drag(window, SIZE[0] // 2 + 60, SIZE[1] // 2, 100, 50)
        window.differs_from(before, 200)
        position = self.light(window)["position"]
        self.assertGreater(position[0], 0.3)
        self.assertEqual(position[1:], [0.5, 1])

    def test_the_square_moves_a_lamp_across_the_view(self):
        window, before, _ = self.open_with_light("type = 'point'\nposition = [0, 0.5, 1]\n")
        self.drag(window, SIZE[0] // 2, SIZE[1] // 2, 100, 50)
        window.differs_from(before, 200)
        position = self.light(window)["position"]
        self.assertGreater(position[0], 0.3)
        self.assertLess(position[1], 0.4)
        self.assertAlmostEqual(position[2], 1, 9)

    def test_the_arrow_turns_a_directional_light(self):
        window, before, arrow = self.open_with_light("type = 'directional'\ndirection = [-0.6, -0.6, -0.5]\n")
        x, y = sorted(arrow)[len(arrow) // 2]
        self.drag(window, x, y, 60, 40)
        window.differs_from(before, 200)
        direction = self.light(window)["direction"]
        self.assertAlmostEqual(sum(d * d for d in direction), 1, 6)
        self.assertGreater(max(abs(d - s) for d, s in zip(direction, (-0.609, -0.609, -0.508))), 0.1)

    def test_a_light_follows_the_camera(self):
        window, before, _ = self.open_with_light("type = 'point'\nposition = [1, 0.5, 1]\n")
        window.key("shift+d")
        window.differs_from(before, 20)
        window.drag(1, 150, 0)
        followed = self.light(window)["position"]
        self.assertGreater(abs(followed[0] - 1), 0.3)
        window.key("shift+d")
        window.drag(1, -100, 0)
        self.assertEqual(self.light(window)["position"], followed)


class Copies(Case):
    def test_the_copied_command_line_draws_what_is_seen(self):
        window = self.open()
        window.drag(1, 90, 40)
        window.key("s", "y", "Shift+l", "q", "a", "t", "j", "e")
        window.settled_picture()
        path, _ = window.save()
        shot = png(window.screenshot())
        self.assertTrue(copied_picture(self, window) == shot)
        self.assertTrue(self.render(path) == shot)

    def test_the_copied_command_line_has_changed_lights_and_the_dropped_environment(self):
        shutil.copy(ROOT / "data" / "environment" / "ramp.hdr", self.folder)
        window = self.open()
        before = window.settled_picture()
        window.key("shift+d")  # lights are the window's own from now on, and the first one follows
        window.drop("ramp.hdr")
        window.differs_from(before, 5000)
        before = window.settled_picture()
        window.drag(1, 120, 30)
        window.differs_from(before, 5000)
        window.settled_picture()
        shot = png(window.screenshot())
        self.assertTrue(copied_picture(self, window) == shot)
        self.assertEqual(len(window.save()[1]["light"]), 3)  # those of the default rig

    def test_a_saved_world_keeps_materials_of_single_objects(self):
        (self.folder / "m.mtl").write_text("newmtl red\nKd 0.8 0.1 0.1\nnewmtl gray\nKd 0.5 0.5 0.5\n")
        (self.folder / "one.scene.toml").write_text("[[model]]\nfile = 'parts.obj'\n[[material]]\nname = '*'\nobject = 'left'\ncolor = [0.1, 0.2, 0.8]\n")
        window = self.open("one.scene.toml")
        path, scene = window.save()
        self.assertEqual([m.get("object") for m in scene["material"]], ["left"])
        self.assertTrue(self.render(path) == png(window.screenshot()))


if __name__ == "__main__":
    sys.exit(support.main())
