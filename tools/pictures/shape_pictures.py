#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""All built-in shapes, coarse and fine, with the edges of their triangles, for docs/world-files.md.

  shape_pictures.py [--program build/release/rakelight] OUT.png

Only the standard library is needed."""
import argparse
import pathlib

from sheet import PROGRAM, write_sheet

SHAPES = ("teapot", "sphere", "cylinder", "cone", "torus", "plane")
ROWS = ("tolerance=0.1", "tolerance=0.02")
PLANE = ("divisions=1", "divisions=8")
LOOK = ("--edges", "--line-color", "0.1,0.1,0.1", "--color", "#c8a878", "--view", "isometric", "--background", "0.8,0.8,0.82")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    words = [[PLANE[row] if shape == "plane" else ROWS[row] for shape in SHAPES] for row in range(2)]
    rows = [[(f"builtin:{shape}:{said}", *LOOK) for shape, said in zip(SHAPES, line)] for line in words]
    write_sheet(options.picture, rows, 160, 140, options.program, columns=[f"builtin:{shape}" for shape in SHAPES], below=words, colors=64)


if __name__ == "__main__":
    main()
