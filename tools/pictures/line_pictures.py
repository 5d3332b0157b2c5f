#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Edges, wireframe, vertices and lines of a model side by side, for docs/lines.md.

  line_pictures.py [--program build/release/rakelight] OUT.png

Only the standard library is needed."""
import argparse
import pathlib

from sheet import PROGRAM, write_sheet

TEAPOT = ("builtin:teapot", "--camera-position", "1.6,1.5,2.4", "--camera-focal-point", "0.05,0.42,0", "--camera-view-angle", "35")
SPOT = ("data/spot/spot_slab5.glb", "--camera-position", "1.5,0.8,-1.9", "--camera-focal-point", "0,0.1,0.1", "--camera-view-angle", "52")
PICTURES = ((*TEAPOT, "--edges"), (*TEAPOT, "--wireframe"), (*SPOT, "--points", "disc", "--point-size", "3", "--line-color", "0.8,0.1,0.1"),
            (*SPOT, "--point-sprites", "--point-size", "2"))
WIDTH, HEIGHT = 280, 240


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    write_sheet(options.picture, [PICTURES], WIDTH, HEIGHT, options.program, samples=1)


if __name__ == "__main__":
    main()
