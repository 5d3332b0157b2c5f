#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tools/check/golden.py must notice what it is there for.  golden_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "tools/check"), str(ROOT / "tools/pictures")]
from png8 import read_rgb, write_rgb  # noqa: E402

PROGRAM = ""
TEAPOT = {"name": "teapot", "size": [48, 36], "tolerance": 0, "arguments": ["builtin:teapot", "--shading", "unlit"]}


class Golden(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)
        self.reference = self.folder / "golden/pictures/teapot.png"

    def golden(self, *arguments, **changes):
        """(exit code, standard error) over one scene with these changes."""
        (self.folder / "golden").mkdir(exist_ok=True)
        (self.folder / "golden/scenes.json").write_text(json.dumps({"schema": "rakelight.golden/1", "rows": [{**TEAPOT, **changes}]}))
        done = subprocess.run([sys.executable, ROOT / "tools/check/golden.py", "--program", PROGRAM, "--golden", self.folder / "golden",
                               "--out", self.folder / "out", *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL)
        return done.returncode, done.stderr

    def change_one_pixel(self, by):
        width, height, pixels = read_rgb(self.reference)
        changed = bytearray(pixels)
        changed[3 * 100 + 1] = (changed[3 * 100 + 1] + by) % 256
        write_rgb(self.reference, width, height, bytes(changed))

    def test_agrees_with_the_picture_that_was_taken_over(self):
        self.assertEqual(self.golden("--update")[0], 0)
        self.assertEqual(self.golden(), (0, ""))
        self.assertFalse((self.folder / "out").exists())

    def test_a_data_channel_takes_the_place_of_the_color(self):
        self.assertEqual(self.golden("--update")[0], 0)
        color = self.reference.read_bytes()
        self.assertEqual(self.golden("--update", channel="object")[0], 0)
        self.assertNotEqual(self.reference.read_bytes(), color)
        self.assertEqual(self.golden(channel="object"), (0, ""))
        self.assertEqual(self.golden()[0], 1)

    def test_a_picture_that_is_not_there_is_a_fault(self):
        code, errors = self.golden()
        self.assertEqual(code, 1)
        self.assertIn("--update", errors)

    def test_one_pixel_off_by_one_is_a_fault_and_is_shown(self):
        self.golden("--update")
        self.change_one_pixel(1)
        code, errors = self.golden()
        self.assertEqual(code, 1)
        self.assertIn("1 pixels differ, by up to 1 of 255", errors)
        width, height, pixels = read_rgb(self.folder / "out/teapot.png")
        self.assertEqual((width, height), (3 * 48 + 8, 36))
        self.assertEqual(sum(pixels[(y * width + 104) * 3 + i] != 0 for y in range(36) for i in range(48 * 3)), 1)

    def test_tolerance_lets_small_differences_through_but_not_larger_ones(self):
        self.golden("--update")
        self.change_one_pixel(2)
        self.assertEqual(self.golden(tolerance=2, reason="for this test")[0], 0)
        self.assertEqual(self.golden(tolerance=1, reason="for this test")[0], 1)
        code, errors = self.golden(tolerance=2)
        self.assertEqual(code, 1)
        self.assertIn("needs a reason", errors)

    def test_other_size_or_channels_are_a_fault(self):
        self.golden("--update")
        self.assertIn("is 64x36", self.golden(size=[64, 36])[1])
        self.assertIn("4 channels", self.golden(arguments=TEAPOT["arguments"] + ["--background", "transparent"])[1])

    def test_a_scene_that_does_not_render_is_a_fault_even_when_updating(self):
        self.assertEqual(self.golden("--update", arguments=["no_such_file.obj"])[0], 1)
        self.assertEqual(self.golden("--update", arguments=["builtin:teapot", "--no-such-option"])[0], 1)
        self.assertFalse(self.reference.exists())

    def test_pictures_without_scene_and_unknown_scenes_are_faults(self):
        self.golden("--update")
        self.reference.rename(self.reference.with_name("forgotten.png"))
        self.assertIn("forgotten.png", self.golden("--update")[1])
        self.assertIn("there are: teapot", self.golden("kettle")[1])


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
