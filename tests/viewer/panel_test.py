#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Widgets of the panels, clicked in a real window, and keys of other keyboards.

  panel_test.py PROGRAM VIEWER [unittest arguments]

Skipped as viewer_test.py is."""
import shutil
import subprocess
import sys
import unittest

import support
from support import SIZE, Case

LEFT = 382  # [px] of the panels, at the font of a display of 96 dots an inch
CAMERA = """[[model]]
file = "parts.obj"
[[camera]]
position = [0, 0, 5]
target = [0, 0, 0]
vertical_fov_deg = 40
horizontal_fov_deg = 90
"""


def row(number):
    """[px] the middle of a panel's row, its title above it."""
    return 45 + 26 * number


def seen(rows):
    """The picture beside the panels, without texts below."""
    return [line[3 * LEFT:] for line in rows[:380]]


class Panels(Case):
    def click(self, window, x, y, *held):
        window.tool(*[word for key in held for word in ("keydown", key)], "mousemove", x, y, "sleep", "0.1", "click", 1,
                    *[word for key in held for word in ("keyup", key)], "sleep", "0.1", "mousemove", LEFT + 100, 430)

    def click_changes(self, window, x, y, what):
        before = window.settled_picture()
        self.click(window, x, y)
        window.differs_from(before, 400, f"by {what}")
        self.assertNotEqual(seen(window.settled_picture()), seen(before), what)

    def test_marks_are_ticked(self):
        window = self.open("builtin:teapot", "--normals", "object")
        window.key("F4")
        plain = window.settled_picture()
        for x, y, what in ((20, row(6), "normals"), (20, row(7), "seams")):
            self.click_changes(window, x, y, what)
            self.click(window, x, y)
            support.wait_for(lambda: seen(window.picture()) == seen(plain), f"{what} stay where they were unticked")

    def test_the_slider_of_the_crease_angle_regroups_while_it_is_held(self):
        window = self.open("builtin:teapot", "--crease-angle", "60")
        window.key("F4")
        window.tool("mousemove", LEFT + 100, 240)
        pictures = [seen(window.settled_picture())]
        with window.stopped():  # pressed where the pointer has not been, as by a finger: it is for the panel, not the camera
            window.tool("mousemove", 80, row(3), "mousedown", 1)
        for x in (60, 40, 24):
            window.tool("mousemove", x, row(3))
            support.wait_for(lambda: seen(window.settled_picture()) != pictures[-1], f"no new picture at {x}")
            pictures.append(seen(window.settled_picture()))
        window.tool("mouseup", 1)
        self.assertNotIn("camera-position", window.save()[1].get("render", {}))

    def test_panels_that_are_opened_change_nothing(self):
        (self.folder / "wide.scene.toml").write_text(CAMERA)
        window = self.open("wide.scene.toml")
        window.key("n")
        before = window.settled_picture()
        for key in ("F2", "F3", "F4", "F5", "F6", "F8"):
            window.key(key)
        window.settled_picture()
        window.key("Tab")
        support.wait_for(lambda: window.picture() == before, "the picture is another one")
        self.assertNotIn("camera-position", window.save()[1].get("render", {}))

    def test_a_position_that_no_camera_can_have_is_not_taken(self):
        window = self.open()
        window.key("F2", "F5")
        before = window.settled_picture()
        self.click(window, 40, row(4), "ctrl")
        window.tool("key", "ctrl+a", "type", "--delay", 90, "1e300")
        window.tool("sleep", "0.2", "key", "Return")
        self.assertLess(abs(self.position(window)[0]), 1e30)  # numbers are taken as they are typed
        window.key("Home")
        support.wait_for(lambda: seen(window.settled_picture()) == seen(before), "the picture is another one")
        self.assertEqual(window.close()[0], 0)

    def test_lights_are_switched_off_and_added(self):
        window = self.open()
        window.key("F5")
        self.click_changes(window, 20, row(1), "the key light off")
        self.click_changes(window, 20, row(3), "a light more")
        self.assertIn("point", str(window.save()[1]["light"]))

    def test_the_line_between_two_pictures_is_dragged(self):
        window = self.open()
        window.key("backslash")
        window.settled_picture()
        window.tool("mousemove", 20, 200, "click", 1)
        window.key("c")
        half = window.settled_picture()
        window.drag(1, 150, 0)
        window.differs_from(half, 2000)
        columns = {x for a, b in zip(half[40:300], window.settled_picture()[40:]) for x in range(SIZE[0]) if a[3 * x:3 * x + 3] != b[3 * x:3 * x + 3]}
        self.assertTrue(SIZE[0] // 2 - 2 <= min(columns) and max(columns) <= SIZE[0] // 2 + 152, (min(columns), max(columns)))

    @unittest.skipUnless(shutil.which("setxkbmap"), "no setxkbmap")
    def test_letters_are_those_of_the_keyboard(self):
        window = self.open()
        self.addCleanup(subprocess.run, ["setxkbmap", "us"])
        subprocess.run(["setxkbmap", "de"], check=True)
        before = window.settled_picture()
        window.key("y")  # where Z is on others
        window.differs_from(before, 100)
        self.assertEqual(window.save()[1]["render"]["lighting"], "lambert")

    def test_keys_of_the_window_go_past_a_text_field(self):
        window = self.open()
        window.key("F2")
        window.settled_picture()
        self.click(window, 40, row(4), "ctrl")
        window.save()
        self.assertEqual(window.close()[0], 0)


if __name__ == "__main__":
    sys.exit(support.main())
