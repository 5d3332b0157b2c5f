#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How long after a motion its first picture by paths is on the screen, and how many pictures a second a turntable shows:
docs/performance.md.

  measure_motion.py VIEWER WORLD_OR_MODEL [options of rakelight view]
  measure_motion.py --turntable VIEWER WORLD_OR_MODEL [options of rakelight view]

Orbits 20 times by mouse, with passes coming between, or plays the turntable, and prints what --stats says. Runs itself under xvfb-run; needs
xdotool."""
import os
import pathlib
import re
import sys
import tempfile
import time

import support


def measure(model, *options):
    with tempfile.TemporaryDirectory(prefix="rakelight_motion_") as folder:
        window = support.Window(pathlib.Path(folder), model, "--engine", "trace", "--method", "path", "--samples", "4096", *options, waits=False)
        time.sleep(5)
        for i in range(20):
            window.drag(1, 100 if i % 2 else -100, 20)
            time.sleep(1)
        print(window.close()[1].strip().splitlines()[-1])


def measure_turntable(model, *options):
    """Pictures in 10 s: the next one begins when the last is on the screen."""
    with tempfile.TemporaryDirectory(prefix="rakelight_motion_") as folder:
        window = support.Window(pathlib.Path(folder), model, *options, waits=False)
        time.sleep(3)
        begin = time.monotonic()
        window.key("shift+space")
        time.sleep(10)
        window.key("shift+space")
        took = time.monotonic() - begin
        said = window.close()[1].strip().splitlines()[-1]
        print(f"{int(re.search('([0-9]+) moments', said)[1]) / took:.1f} pictures a second; {said}")


if __name__ == "__main__":
    if os.environ.get("RAKELIGHT_VIEWER_TEST_DISPLAY") != "1":
        sys.exit(support.under_xvfb())
    turns = "--turntable" in sys.argv[1:2]
    viewer, model, *options = sys.argv[1 + turns:]
    support.VIEWER, support.SIZE = os.path.abspath(viewer), (1280, 720)
    (measure_turntable if turns else measure)(os.path.abspath(model), *options)
