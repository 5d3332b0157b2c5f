#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The fixed-function preset beside the programmable pipeline, a pair of pictures for each row of the table in docs/shading.md.

  fixed_function_pictures.py [--program build/release/rakelight] FOLDER

Writes FOLDER/fixed-function-ROW.png and prints the commands. Only the standard library is needed."""
import argparse
import pathlib

from sheet import PROGRAM, write_sheet

WIDTH, HEIGHT = 240, 160
PRESET = ("--preset", "fixed-function")
SPOT = ("builtin:plane", "--view", "top", "--light", "spot:0.1,0.6,0.05:direction=0,-1,0:cutoff=14:exponent=8", "--light", "ambient:0.15,0.15,0.18")
SOLIDS = ("data/lighting/blinn-phong.scene.toml",)
WALL = ("data/maps/wall.obj", "--texture-normal", "data/maps/brick_normal.png", "--light", "directional:-1,-0.6,-0.5", "--light", "ambient:0.1,0.1,0.1")
# row: what both have, what the programmable one has beside
ROWS = {
    "model": (("data/materials/layers.gltf", "--light", "directional:0.4,-0.7,-0.8", "--light", "ambient:0.25,0.25,0.25"), ()),
    "lights": (("data/lighting/twelve-lights.scene.toml",), ()),
    "vertices": (SPOT, ()),
    "shadows": (("data/world/room.scene.toml", "--tone-mapping", "none"), ()),
    "detail": (WALL, ()),
    "control": (("builtin:teapot", "--engine", "gl", "--samples", "4"), ("--lighting", "data/lighting/steps.glsl")),
}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", default=PROGRAM)
    parser.add_argument("folder")
    args = parser.parse_args()
    for row, (both, programmable) in ROWS.items():
        out = pathlib.Path(args.folder) / f"fixed-function-{row}.png"
        write_sheet(out, [[(*both, *PRESET), (*both, *programmable)]], WIDTH, HEIGHT, args.program)
        print(f"rakelight render {' '.join(both)} {' '.join(PRESET)} -o {row}.png")


if __name__ == "__main__":
    main()
