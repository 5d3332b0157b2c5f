#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Clips, keys and the turntable, played in a real window.

  motion_test.py PROGRAM VIEWER [unittest arguments]

Skipped as viewer_test.py is."""
import sys

import support
from support import ROOT, SIZE, Case, png, wait_for
from gl_test import far_apart, gl_pictures

DOOR = ROOT / "data" / "motion" / "door.gltf"  # swing: 0 to 1 s; slide: 0.5 to 2.5 s; fly: the camera


class Motion(Case):
    def door(self, *arguments):
        """Scenes are saved beside the model: that is a copy."""
        (self.folder / "door.gltf").write_bytes(DOOR.read_bytes())
        window = self.open("door.gltf", *arguments)
        window.key("n")  # the file's name goes away
        window.settled_picture()
        return window

    def test_the_moment_of_the_command_line_is_shown_as_it_is_rendered(self):
        arguments = ("--animation-index", 1, "--animation-time", 1.5)
        window = self.door(*arguments)
        expected = self.render(DOOR, "--resolution", "%d,%d" % SIZE, *arguments)[3]
        wait_for(lambda: window.picture() == expected, "the display does not hold the picture of render")

    def play_and_pause(self, window):
        """[pictures at rest, while it plays, paused]"""
        before = window.settled_picture()
        window.key("space")
        window.differs_from(before, 2000, "though it plays")
        during = window.picture()
        window.differs_from(during, 500, "while it plays")
        window.key("space")
        return before, during, window.settled_picture()

    def test_paused_it_shows_what_render_draws_of_that_moment(self):
        window = self.door()
        before, _, paused = self.play_and_pause(window)
        self.assertNotEqual(before, paused)
        path, scene = window.save()
        self.assertEqual(int(scene["render"]["animation-index"]), 0)
        self.assertGreater(float(scene["render"]["animation-time"]), 0)
        rendered = self.render(path)[3]
        self.assertTrue(rendered == paused)
        self.assertTrue(png(window.screenshot())[3] == rendered)
        window.key("BackSpace", "Home", "Escape", "Escape")  # the messages go, too
        wait_for(lambda: window.picture() == before, "the door does not stand at rest again")
        self.assertEqual(window.close()[0], 0)

    def test_gl_plays_too(self):
        window = self.door("--engine", "gl")
        _, _, paused = self.play_and_pause(window)
        path, _ = window.save()
        self.assertLess(far_apart(paused, self.render(path)[3]), 0.001)
        self.assertGreater(gl_pictures(window.close()[1]), 3)

    def test_autoplay_begins_by_itself(self):
        window = support.Window(self.folder, DOOR, "--animation-autoplay", waits=False)  # it never stands still
        self.addCleanup(window.end)
        first = window.picture()
        window.differs_from(first, 2000, "though it plays by itself")
        second = window.picture()
        window.differs_from(second, 500, "though it plays by itself")
        window.key("space")
        window.settled_picture()
        self.assertEqual(window.close()[0], 0)

    def test_clips_are_stepped_through_and_the_moment_in_pictures(self):
        window = self.door()
        window.key("shift+w", "shift+w", "shift+Right", "shift+Right", "shift+Right", "shift+Left")
        render = window.save()[1]["render"]
        self.assertEqual(int(render["animation-index"]), 1)
        self.assertAlmostEqual(float(render["animation-time"]), 0.5 + 2 / 30, 6)

    def test_the_turntable_goes_around(self):
        window = self.door()
        start = window.settled_picture()
        window.key("shift+space")
        window.differs_from(start, 2000, "though it turns")
        window.key("shift+space")
        stopped = window.settled_picture()
        self.assertTrue(self.render(window.save()[0])[3] == stopped)

    def test_keys_of_the_camera_are_recorded_and_played(self):
        window = self.open("parts.obj")
        window.key("1", "5", "5", "Insert")
        first = self.position(window)
        window.key(*["shift+Right"] * 6)
        window.drag(1, 120, 0)
        window.key("Insert")
        second = self.position(window)
        self.assertGreater(abs(second[0] - first[0]), 0.5)
        window.key(*["shift+Left"] * 3)
        middle = self.position(window)
        for a, b, m in zip(first, second, middle):
            self.assertAlmostEqual(m, (a + b) / 2, 4)
        window.key(*["shift+Left"] * 3)
        for a, b in zip(self.position(window), first):
            self.assertAlmostEqual(a, b, 4)
        paused = window.settled_picture()
        window.key("space")
        window.differs_from(paused, 2000, "though its keys are played")
        window.key("space", "Delete")
        self.assertEqual(window.close()[0], 0)

    def test_the_panel_lists_the_clips(self):
        window = self.door()
        plain = window.settled_picture()
        window.key("shift+m")
        window.differs_from(plain, 5000)
        with_panel = window.settled_picture()
        window.tool("mousemove", 100, 77, "sleep", "0.1", "click", 1, "sleep", "0.1", "mousemove", 500, 430)  # the second row: swing
        window.differs_from(with_panel, 100, "by a click on a clip")
        window.key("space")
        window.differs_from(window.picture(), 500, "though it plays")
        window.key("space")
        self.assertEqual(window.close()[0], 0)


if __name__ == "__main__":
    sys.exit(support.main())
