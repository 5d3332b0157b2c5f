#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The shaders of examples/shaders side by side, for docs/user-shaders.md.

  shader_pictures.py [--program build/release/rakelight] OUT.png

Toon shading; a wave that moves a plane; normal mapping in tangent space. Only the standard library is needed."""
import argparse
import pathlib

from sheet import PROGRAM, write_sheet

SHADERS = "examples/shaders/"
TEAPOT = ("builtin:teapot", "--look", "plain", "--engine", "gl", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.1,0.42,0", "--camera-view-angle", "33")
LAMP = ("--light", "directional:-0.5,-0.8,-0.7", "--light", "ambient:0.15,0.15,0.15")
PLANE = ("builtin:plane:divisions=100", "--look", "plain", "--engine", "gl", "--camera-position", "0.9,1.5,2.7", "--camera-focal-point", "0,-0.05,0", "--camera-view-angle", "38")
PICTURES = (
    ((*TEAPOT, "--material", "color=0.75,0.35,0.2", "--lighting", SHADERS + "toon.glsl", "--uniform", "steps=4", *LAMP), "toon"),
    ((*PLANE, "--vertex-shader", SHADERS + "waves.vertex.glsl", "--uniform", "height=0.1", *LAMP), "waves"),
    ((*TEAPOT, "--texture-normal", "data/maps/leather_normal.png", "--lighting", SHADERS + "tangent_space.glsl",
      "--vertex-shader", SHADERS + "tangent_space.vertex.glsl", *LAMP), "tangent space"),
)
WIDTH, HEIGHT = 280, 200


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    pictures, names = zip(*PICTURES)
    write_sheet(options.picture, [pictures], WIDTH, HEIGHT, options.program, samples=4, below=[names])


if __name__ == "__main__":
    main()
