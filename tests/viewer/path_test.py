#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Paths of light in a real window: passes, motion while they come, the key R.

  path_test.py PROGRAM VIEWER [unittest arguments]

Skipped as viewer_test.py is."""
import sys

import support
from support import Case, wait_for

WORLD = """[[primitive]]
type = "plane"
size = [8, 8]
position = [0, -1, 0]
material = "white"
[[primitive]]
type = "sphere"
material = "white"
[[material]]
name = "white"
color = [0.7, 0.6, 0.5]
metallic = 0
roughness = 0.6
[environment]
light = true
[[camera]]
position = [1, 1, 5]
target = [0, 0, 0]
vertical_fov_deg = 40
[render]
engine = "trace"
method = "path"
samples = 16
"""


def middle(rows):
    """Without the texts at the borders."""
    return [row[3 * 100:3 * 540] for row in rows[60:380]]


def differing(a, b):
    return sum(x[i:i + 3] != y[i:i + 3] for x, y in zip(a, b) for i in range(0, len(x), 3))


class Paths(Case):
    def setUp(self):
        super().setUp()
        (self.folder / "w.scene.toml").write_text(WORLD)

    def ends_in_the_picture_of_render(self, window):
        """Passes come for longer than a picture stands still: only the last one is what it must be."""
        path, render = window.save()
        self.assertEqual(render["render"]["method"], "path")
        rendered = middle(self.render(path.name, "--resolution", "640,480")[3])
        wait_for(lambda: middle(window.picture()) == rendered, "the passes did not end in the picture of render")
        return rendered

    def test_passes_end_in_the_picture_of_render(self):
        self.ends_in_the_picture_of_render(self.open("w.scene.toml"))

    def test_motion_begins_the_passes_anew(self):
        window = self.open("w.scene.toml")
        before = self.ends_in_the_picture_of_render(window)
        window.drag(1, 100, 20)
        early = middle(window.picture())
        late = self.ends_in_the_picture_of_render(window)
        self.assertGreater(differing(before, early), 5000, "the picture did not move")
        self.assertGreater(differing(early, late), 5000, "no passes came behind the first")

    def test_r_comes_to_paths_and_back(self):
        window = self.open()
        seen = []
        for _ in range(4):
            window.key("r")
            window.settled_picture()
            render = window.save()[1].get("render", {})
            seen.append((render.get("engine", "soft"), render.get("method", "")))
        self.assertIn(("trace", "path"), seen)
        self.assertGreaterEqual(len(set(seen)), 3, seen)
        self.assertEqual(window.close()[0], 0)


if __name__ == "__main__":
    sys.exit(support.main())
