#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The sheets of docs/bump.md, docs/images/bump-*.png: pictures side by side.

  bump_pictures.py [--program build/release/rakelight] [--only NAME] OUT_FOLDER

A sheet is a list of rows, a row a list of pictures: the arguments of `rakelight render`, or a PNG file of the
repository that is shown as it is. Only the standard library is needed."""
import argparse
import pathlib

from sheet import PROGRAM, write_sheet

MAPS = "data/maps/"


def maps(name):
    return ("--texture-normal", f"{MAPS}{name}_normal.png", "--height-map", f"{MAPS}{name}_height.png")


LAMP = ("--light", "directional:1,-0.6,-0.9:color=0.9,0.9,0.9", "--light", "ambient:0.12,0.12,0.12")
WALL = (MAPS + "wall.obj", *maps("brick"), *LAMP, "--camera-view-angle", "41")
EYES = ("0,0,3.4", "2.5,0.5,2.3", "3.15,0.3,0.95")  # 0, 48 and 73 degrees off the wall's normal
TECHNIQUES = (("none",), ("height",), ("normal",), ("parallax-limited",), ("parallax",), ("steep",), ("occlusion",),
              ("occlusion", "--bump-self-shadow", "--bump-silhouette"))
TEAPOT = ("builtin:teapot", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "29")
KEY = ("--light", "directional:0.7,-0.9,-0.8:color=0.85,0.85,0.85", "--light", "ambient:0.13,0.13,0.13")
SHINY = ("--color", "#a4653a", "--roughness", "0.32", "--metallic", "0")
MODEL = ("--lighting", "blinn-phong")
FRAMES = ("-1.5,1,1.5", "-0.5,1.6,1.8", "0.7,1.6,1.8", "1.7,1,1.5")


def lamp_at(place):
    return ("--light", f"point:{place}:attenuation=0.4,0.2,0.1", "--light", "ambient:0.1,0.1,0.1")


def beside(angle):
    """The flat wall without and with its map, and the map."""
    eye = ("--camera-position", angle, "--camera-focal-point", "0,0,0")
    return [(*WALL, *eye, "--bump", "none"), (*WALL, *eye, "--bump", "normal"), MAPS + "brick_normal.png"]


LEATHER = (*TEAPOT, *KEY, *maps("leather"), *SHINY, "--bump", "normal")
DENTS = (MAPS + "wall.obj", *maps("dents"), "--camera-position", "0,0,3.3", "--camera-focal-point", "0,0,0", "--camera-view-angle", "34")
FACES = (MAPS + "two_faces.obj", "--camera-position", "0,2,3", "--camera-focal-point", "0,0.2,0", "--camera-view-angle", "50",
         "--light", "directional:1,-0.7,-0.5", "--cull", "none")
SHEET = (MAPS + "sheet.obj", *maps("brick"), "--bump", "normal", "--normals", "model", "--crease-angle", "180", "--tangents", "published",
         "--orthogonalize", "off", "--light", "point:0.5,0.6,1.1:attenuation=0.6,0.2,0.2", "--light", "ambient:0.1,0.1,0.1",
         "--camera-position", "0.7,0.5,3.4", "--camera-focal-point", "0,0,0", "--camera-view-angle", "36")
SHEETS = {
    "techniques": (128, 104, [[(*WALL, "--camera-position", eye, "--camera-focal-point", "0,0,0", "--bump", *how) for how in TECHNIQUES]
                              for eye in EYES]),
    "teapots": (208, 144, [[(*TEAPOT, *KEY, *SHINY, *MODEL, *maps(m), "--bump", how) for m, how in
                            (("brick", "none"), ("brick", "normal"), ("leather", "normal"), ("scratches", "normal"))],
                           [(*TEAPOT, *KEY, *SHINY, *MODEL, *maps("brick"), "--bump", "normal", "--normal-scale", "0.35"),
                            *((*TEAPOT, *KEY, *SHINY, *MODEL, *maps(m), "--bump", "occlusion", "--bump-self-shadow", "--bump-depth", d)
                              for m, d in (("brick", "0.05"), ("leather", "0.03"), ("scratches", "0.02")))]]),
    "wall": (180, 180, [beside("1.2,0.4,3.1")]),
    "dents": (256, 256, [[MAPS + "dents_height.png", MAPS + "dents_normal.png",
                          (*DENTS, *LAMP, "--bump", "normal"), (*DENTS, "--light", "directional:-1,0.6,-0.9", "--bump", "normal")]]),
    "terms": (208, 144, [[(*LEATHER, *MODEL, "--bump-terms", "diffuse"), (*LEATHER, "--bump-terms", "diffuse", "--lighting", "lambert"),
                          (*LEATHER, *MODEL, "--bump-terms", "specular"), (*LEATHER, *MODEL)]]),
    "faces": (420, 200, [[FACES]]),
    "moving": (176, 120, [[(*TEAPOT, *lamp_at(place), *SHINY, *MODEL, *maps("leather"), "--bump", how) for place in FRAMES]
                          for how in ("none", "normal")]),
    "tangents": (256, 176, [[(*SHEET, "--tangent-space", space) for space in ("world", "vertex", "transposed")]]),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--only", choices=SHEETS)
    options = parser.parse_args()
    for name, (width, height, rows) in SHEETS.items():
        if options.only in (None, name):
            write_sheet(options.folder / f"bump-{name}.png", rows, width, height, options.program)


if __name__ == "__main__":
    main()
