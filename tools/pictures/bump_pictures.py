#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The sheets of docs/bump.md, docs/displacement.md and docs/attributes.md: docs/images/bump-*.png, displacement.png, tangents-mirrored.png, bitangents.png.

  bump_pictures.py [--program build/release/rakelight] [--only NAME] OUT_FOLDER

A sheet is a list of rows of parts, see sheet.py, and words beside them. Only the standard library is needed."""
import argparse
import math
import pathlib

from sheet import PROGRAM, write_sheet

MAPS = "data/maps/"


def maps(name):
    return ("--texture-normal", f"{MAPS}{name}_normal.png", "--height-map", f"{MAPS}{name}_height.png")


LAMP = ("--light", "directional:1,-0.6,-0.9:color=0.9,0.9,0.9", "--light", "ambient:0.12,0.12,0.12")
WALL = (MAPS + "wall.obj", *maps("brick"), *LAMP, "--camera-view-angle", "36")
VIEWS = ((0, 0.3, 15), (48, 0.36, 11), (73, 0.2, 5.6))  # [degrees] off the wall's normal, [m] place that is looked at, [degrees] view angle
FEW = ("--bump-steps", "4,12")  # few enough to be seen
TECHNIQUES = {"none": ("none",), "height": ("height",), "normal": ("normal",), "parallax-limited": ("parallax-limited",), "parallax": ("parallax",),
              "steep": ("steep", *FEW), "occlusion": ("occlusion", *FEW), "self-shadow": ("occlusion", "--bump-self-shadow"),
              "displacement": ("displacement",)}
TEAPOT = ("builtin:teapot", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "30")
KEY = ("--light", "directional:0.7,-0.9,-0.8:color=0.85,0.85,0.85", "--light", "ambient:0.13,0.13,0.13")
DIM = ("--light", "directional:0.7,-0.9,-0.8:color=0.4,0.4,0.4")
SHINY = ("--color", "#a4653a", "--roughness", "0.32", "--metallic", "0")
METAL = ("--color", "#96928c", "--roughness", "0.24", "--metallic", "1", "--lighting", "pbr", "--hdri-ambient")
MODEL = ("--lighting", "blinn-phong")
FRAMES = ("-1.5,1,1.5", "-0.5,1.6,1.8", "0.7,1.6,1.8", "1.7,1,1.5")


def wall_at(angle, place, view_angle):
    """The wall, seen from 3.4 m."""
    eye = (place + 3.4 * math.sin(math.radians(angle)), 0.3, 3.4 * math.cos(math.radians(angle)))
    return (MAPS + "wall.obj", *maps("brick"), *LAMP, "--camera-position", "{:.3f},{:.3f},{:.3f}".format(*eye),
            "--camera-focal-point", f"{place},0,0", "--camera-view-angle", str(view_angle))


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
         "--camera-position", "0.7,0.5,3.4", "--camera-focal-point", "0,0,0", "--camera-view-angle", "32")
MIRRORED = (MAPS + "mirrored.obj", "--texture-normal", MAPS + "dents_normal.png", "--bump", "normal", "--normals", "model", *LAMP,
            "--camera-position", "0,0,5", "--camera-focal-point", "0,0,0", "--camera-view-angle", "24")
SHEARED = (MAPS + "sheared.obj", "--texture-normal", MAPS + "dents_normal.png", "--bump", "normal", "--normals", "model", "--tangents", "published", *LAMP,
           "--camera-position", "0,0,5", "--camera-focal-point", "0,0,0", "--camera-view-angle", "24")
OWN = (*SHEARED, "--bitangents", "attribute")
MODES = ("averaged", "published", "published-no-handedness")
FRAMES_OF = {"vertex": ("--tangent-space", "vertex"), "transposed": ("--tangent-space", "transposed"), "world, frames not unit": ("--normalize-frames", "off")}
ASLANT = wall_at(*VIEWS[1])
SETTINGS = (("occlusion", "--bump-bias", "0"), ("occlusion", "--bump-bias", "0.5"), ("occlusion", "--bump-bias", "1"), ("occlusion", "--bump-polarity", "depth"),
            ("steep", *FEW), ("steep", "--bump-steps", "48,96"), *(("occlusion", "--bump-steps", "2,4", "--bump-refinement", n) for n in "05"),
            ("occlusion", "--bump-depth", "0.02"), ("occlusion", "--bump-depth", "0.12"), ("occlusion", "--bump-depth", "0.12", "--bump-silhouette"),
            ("normal", "--normal-scale", "2.5"))
WORDS = ("bias 0", "bias 0.5", "bias 1", "polarity depth", "steep, steps 4,12", "steep, steps 48,96", "steps 2,4, refinement 0", "steps 2,4, refinement 5",
         "depth 0.02", "depth 0.12", "depth 0.12, silhouette", "normal map, scale 2.5")
RAKING = ("--camera-position", "0,0,3.3", "--camera-focal-point", "0,0,0", "--light", "directional:-0.3,-1,-0.16", "--light", "ambient:0.12,0.12,0.12", "--bump", "normal")
GREEN = (MAPS + "wall.obj", *maps("brick"), *RAKING, "--camera-view-angle", "24")
ZERO = (MAPS + "wall.obj", *maps("dents"), *RAKING, "--camera-view-angle", "34")
FLOOR = ("data/visibility/floor.obj", "--height-map", MAPS + "brick_height.png", "--bump", "height", "--bump-depth", "0.03", "--light", "directional:-1,-0.5,-0.3",
         "--camera-position", "0,0.3,3.3", "--camera-focal-point", "0,0,0", "--camera-view-angle", "16")
SPHERE = ("builtin:sphere", *maps("brick"), "--camera-position", "2.2,1.6,3.4", "--camera-focal-point", "0,0,0", "--camera-view-angle", "29")
SHEETS = {
    "bump-techniques": (240, 104, [[(*wall_at(*view), "--bump", *how) for view in VIEWS] for how in TECHNIQUES.values()],
                        {"lines": list(TECHNIQUES), "columns": [f"{view[0]} degrees" for view in VIEWS], "colors": 64}),
    "bump-grazing": (384, 176, [[FLOOR, (*FLOOR, "--anisotropy", "16")]], {"below": [["anisotropy 1", "anisotropy 16"]], "colors": 128}),
    "bump-settings": (240, 104, [[(*ASLANT, "--bump", *how) for how in SETTINGS[i:i + 4]] for i in (0, 4, 8)],
                      {"below": [WORDS[i:i + 4] for i in (0, 4, 8)], "colors": 64}),
    "bump-codes": (192, 192, [[GREEN, (*GREEN, "--normal-map-green", "down"), ZERO, (*ZERO, "--normal-map-zero", "128"),
                               (ZERO, (*ZERO, "--normal-map-zero", "128"), 16)]],
                   {"below": [["green up", "green down", "zero 127.5", "zero 128", "difference, times 16"]], "colors": 128}),
    "displacement": (192, 192, [[(*SPHERE, "--bump", "none"), (*SPHERE, "--bump", "normal"),
                                 (*SPHERE, "--bump", "occlusion", "--bump-depth", "0.02"), (*SPHERE, "--bump", "displacement", "--bump-depth", "0.02")]],
                     {"below": [["none", "normal", "occlusion", "displacement"]], "colors": 128}),
    "bump-teapots": (208, 144, [[(*TEAPOT, *KEY, *SHINY, *MODEL, *maps("brick"), "--bump", "none"),
                                 (*TEAPOT, *KEY, *SHINY, *MODEL, *maps("brick"), "--bump", "normal"),
                                 (*TEAPOT, *KEY, *SHINY, *MODEL, *maps("leather"), "--bump", "normal"),
                                 (*TEAPOT, *DIM, *METAL, *maps("scratches"), "--bump", "normal", "--normal-scale", "0.5")],
                                [(*TEAPOT, *KEY, *SHINY, *MODEL, *maps("brick"), "--bump", "normal", "--normal-scale", "0.35"),
                                 *((*TEAPOT, *how, *maps(m), "--bump", "occlusion", "--bump-self-shadow", "--bump-depth", d) for m, d, how in
                                   (("brick", "0.05", (*KEY, *SHINY, *MODEL)), ("leather", "0.03", (*KEY, *SHINY, *MODEL)),
                                    ("scratches", "0.01", (*DIM, *METAL, "--normal-scale", "0.5"))))]],
                     {"below": [["smooth", "brick", "leather", "scratched metal"], ["brick, mild", "brick, occlusion", "leather, occlusion", "scratches, occlusion"]],
                      "colors": 256}),
    "bump-wall": (180, 180, [beside("1.2,0.4,3.1")]),
    "bump-dents": (256, 256, [[MAPS + "dents_height.png", MAPS + "dents_normal.png",
                          (*DENTS, *LAMP, "--bump", "normal"), (*DENTS, "--light", "directional:-1,0.6,-0.9", "--bump", "normal")]]),
    "bump-terms": (208, 144, [[(*LEATHER, *MODEL, "--bump-terms", "diffuse"), (*LEATHER, "--bump-terms", "diffuse", "--lighting", "lambert"),
                          (*LEATHER, *MODEL, "--bump-terms", "specular"), (*LEATHER, *MODEL)]]),
    "bump-faces": (420, 200, [[FACES]]),
    "bump-moving": (176, 120, [[(*TEAPOT, *lamp_at(place), *SHINY, *MODEL, *maps("leather"), "--bump", how) for place in FRAMES]
                          for how in ("none", "normal")], {"colors": 128}),
    "tangents-mirrored": (300, 154, [[(*MIRRORED, "--tangents", mode) for mode in MODES]], {"below": [list(MODES)], "colors": 128}),
    "bitangents": (208, 208, [[SHEARED, OWN, (OWN, SHEARED, 4)]], {"below": [["cross", "attribute", "difference, times 4"]], "colors": 128}),
    "bump-tangents": (208, 162, [[(*SHEET, *how) for how in ((), *FRAMES_OF.values())],
                                 [(*SHEET, "--tangent-space", "pixel"), *((SHEET, (*SHEET, *how), 4) for how in FRAMES_OF.values())]],
                      {"below": [["world", *FRAMES_OF], ["pixel", *["its difference, times 4"] * 3]], "colors": 256}),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--only", choices=SHEETS)
    options = parser.parse_args()
    for name, (width, height, rows, *words) in SHEETS.items():
        if options.only in (None, name):
            write_sheet(options.folder / f"{name}.png", rows, width, height, options.program, **dict(*words))


if __name__ == "__main__":
    main()
