#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Lighting models (rows) by roughness (columns) on a sphere, for docs/lighting-models.md.

  model_pictures.py [--program build/release/rakelight] OUT.png

Only the standard library is needed."""
import argparse
import pathlib

from sheet import PROGRAM, write_sheet

SCENE = ("data/materials/spheres.gltf", "--camera-position", "-0.45,0,5", "--camera-focal-point", "-0.45,0,0", "--camera-view-angle", "24", "--light",
         "directional:0.6,-0.6,-0.8", "--light", "directional:-0.8,-0.2,-0.4:color=0.25,0.25,0.3", "--light", "ambient:0.12,0.12,0.12")
PLASTIC, METAL = ("--color", "0.75,0.3,0.2", "--metallic", "0"), ("--color", "0.9,0.75,0.45", "--metallic", "1")
ROWS = ((*PLASTIC, "--lighting", "oren-nayar"), (*PLASTIC, "--lighting", "ward"), (*PLASTIC, "--lighting", "pbr"), (*METAL, "--lighting", "pbr"),
        (*PLASTIC, "--lighting", "blinn-phong"), (*METAL, "--lighting", "blinn-phong"))
COLUMNS = ("0.1", "0.3", "0.5", "0.7", "1")
WIDTH, HEIGHT = 80, 80


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    rows = [[(*SCENE, *row, "--roughness", roughness) for roughness in COLUMNS] for row in ROWS]
    write_sheet(options.picture, rows, WIDTH, HEIGHT, options.program, samples=4)


if __name__ == "__main__":
    main()
