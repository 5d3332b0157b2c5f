#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Takes the pictures of docs/viewer.md anew: docs/images/viewer-*.png.

  take_pictures.py VIEWER FLIGHTHELMET.gltf [NAME ...]

Runs itself under xvfb-run; needs xdotool and ImageMagick. Look at them before they are committed."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import support

OUT = support.ROOT / "docs" / "images"
HELMET, TEAPOT = "helmet", "builtin:teapot"
KNIGHT = str(support.SHARED / "assets" / "gltf" / "kaykit" / "Knight.glb")
# name: (model, options, what is done: keys, or words of xdotool)
PICTURES = {
    "panels": (HELMET, [], ["F3", "F5", "d", ["mousemove", 130, 455, "click", 1], "n"]),
    "seams": (TEAPOT, ["--normals", "object"], ["v", "F4", "n"]),
    "split": (HELMET, [], ["backslash", ["mousemove", 850, 300, "click", 1], "c", "c"]),
    "pixel": (HELMET, [], ["p", ["mousemove", 500, 200, "click", 1]]),
    "materials": (HELMET, ["--lighting", "pbr"], ["F10", "F6", ["mousemove", 700, 300, "keydown", "alt", "click", 1, "keyup", "alt"], "n"]),
    "views": (HELMET, ["--lighting", "pbr"], ["n", "shift+backslash", ["mousemove", 720, 600, "click", 1], "1", "w"]),
    "marks": (HELMET, ["--lighting", "pbr"], ["n", "g", "x", "shift+n"]),
    "environment": (HELMET, ["--lighting", "pbr"], ["n", "i", "j"]),
    "statistics": (HELMET, ["--lighting", "pbr"], ["F2", "F8", "n", "z"]),
    "motion": (KNIGHT, ["--animation-index", "0", "--animation-time", "0.3"],
               ["n", "shift+m", "Insert", *["shift+Right"] * 8, ["mousemove", 700, 300, "mousedown", 1, "mousemove_relative", 40, 0, "mouseup", 1], "Insert"]),
    "keys": (HELMET, [], ["n", "h"]),
}


def take(name, helmet):
    model, options, steps = PICTURES[name]
    with tempfile.TemporaryDirectory(prefix="rakelight_pictures_") as folder:
        folder = pathlib.Path(folder)
        if model == HELMET:
            shutil.copytree(helmet.parent, folder, dirs_exist_ok=True)
        window = support.Window(folder, helmet.name if model == HELMET else model, *options)
        for step in steps:
            window.key(step) if isinstance(step, str) else window.tool(*step)
            window.settled_picture()
        window.tool("mousemove", support.SIZE[0] - 5, 5)
        window.settled_picture()
        shot = ["import", "-silent", "-window", "root", "-crop", "%dx%d+0+0" % support.SIZE, "+repage"]
        subprocess.run([*shot, "-resize", "75%", "+dither", "-colors", "128", f"png8:{OUT / f'viewer-{name}.png'}"], check=True)
        window.end()


def main():
    if os.environ.get("RAKELIGHT_VIEWER_TEST_DISPLAY") != "1":
        return support.under_xvfb()
    support.VIEWER, support.SIZE = os.path.abspath(sys.argv[1]), (960, 640)
    for name in sys.argv[3:] or PICTURES:
        take(name, pathlib.Path(sys.argv[2]).absolute())
    return 0


if __name__ == "__main__":
    sys.exit(main())
