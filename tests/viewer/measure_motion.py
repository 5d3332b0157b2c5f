#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How long after a motion its first picture by paths is on the screen: docs/performance.md.

  measure_motion.py VIEWER WORLD_OR_MODEL [options of rakelight view]

Orbits 20 times by mouse, with passes coming between, and prints what --stats says. Runs itself under xvfb-run; needs xdotool."""
import os
import pathlib
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


if __name__ == "__main__":
    if os.environ.get("RAKELIGHT_VIEWER_TEST_DISPLAY") != "1":
        sys.exit(support.under_xvfb())
    support.VIEWER, support.SIZE = os.path.abspath(sys.argv[1]), (1280, 720)
    measure(os.path.abspath(sys.argv[2]), *sys.argv[3:])
