#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Kinds of light, models of reflection, normal maps and projected textures side by side, for docs/lighting.md.

  lighting_pictures.py [--program build/release/rakelight] OUT.png

Four columns, a row a subject: see ROWS. Only the standard library is needed."""
import argparse
import pathlib

from sheet import PROGRAM, write_sheet

TEAPOT = ("builtin:teapot", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "29")
SOLIDS = ("tests/golden/models/solids.obj", "--view", "default", "--camera-view-angle", "40")  # without texture coordinates
AMBIENT = ("--light", "ambient:0.1,0.1,0.1")
BEHIND = ("--light", "directional:-0.6,-0.25,0.9:color=0.5,0.5,0.5:specular=6,6,6", *AMBIENT)
BRICKS, CHECKER = "data/bricks/normal.png", "tests/golden/models/checker.png"
ROWS = (
    (TEAPOT, ("--light", "ambient:0.4,0.4,0.4"), ("--light", "directional:1,-1,-0.5:color=0.9,0.9,0.9", *AMBIENT),
     ("--light", "point:-0.2,1.2,0.9:attenuation=0.5,0,1.5", *AMBIENT), ("--light", "spot:0.2,1.6,1.6:direction=-0.05,-0.65,-1:cutoff=16:exponent=9", *AMBIENT)),
    (TEAPOT, ("--lighting", "lambert"), ("--lighting", "phong"), ("--lighting", "blinn-phong"), ("--lighting", "blinn-phong", "--specular", "normalized")),
    (TEAPOT, BEHIND, (*BEHIND, "--specular-horizon", "off"), ("--texture-normal", BRICKS), ("--texture-normal", BRICKS, "--normal-scale", "3")),
    (SOLIDS, *(("--uv", how, "--texture-base-color", CHECKER) for how in ("none", "box", "sphere", "cylinder"))),
)
WIDTH, HEIGHT = 240, 160


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    write_sheet(options.picture, [[(*scene, *arguments) for arguments in row] for scene, *row in ROWS], WIDTH, HEIGHT, options.program)


if __name__ == "__main__":
    main()
