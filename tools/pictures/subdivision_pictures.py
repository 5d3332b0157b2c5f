#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Subdivision surfaces side by side, for docs/subdivision.md.

  subdivision_pictures.py [--program build/release/rakelight] levels|creases|parts OUT.png"""
import argparse
import pathlib

from sheet import PROGRAM, write_sheet

CUBE = ("data/cages/cube.obj", "--camera-position", "2.1,1.7,4.2", "--camera-focal-point", "0,0,0", "--camera-view-angle", "41")
JACK = ("data/cages/jack.obj", "--camera-position", "3.4,2.6,5.2", "--camera-focal-point", "0,0,0", "--camera-view-angle", "36")
NET = ("--edges", "--line-width", "1.5")
SHEETS = {
    "levels": (([(*CUBE, *NET), (*CUBE, "--subdivide", "1"), (*CUBE, "--subdivide", "2"), (*CUBE, "--subdivide", "4"),
                 (*CUBE, "--subdivide", "4", "--subdivide-scheme", "loop")],),
               ("control net", "1 level", "2 levels", "4 levels", "4, loop"), 160, 150),
    "creases": (([(*CUBE, "--subdivide", "5", "--subdivide-crease", "60", "--subdivide-sharpness", s) for s in ("0", "1", "2", "3", "10")],),
                ("sharpness 0", "1", "2", "3", "10: for ever"), 160, 150),
    "parts": (([(*JACK, *NET), (*JACK, "--subdivide", "4"),
                (*JACK, "--subdivide", "4", "--uv", "box", "--bump", "displacement", "--height-map", "data/maps/leather_height.png",
                 "--bump-depth", "0.01")],),
              ("six objects", "subdivided", "and displaced"), 210, 200),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default=PROGRAM, type=pathlib.Path)
    parser.add_argument("which", choices=SHEETS)
    parser.add_argument("out")
    options = parser.parse_args()
    rows, columns, width, height = SHEETS[options.which]
    write_sheet(options.out, rows, width, height, program=options.program, columns=columns)


if __name__ == "__main__":
    main()
