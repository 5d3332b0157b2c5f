#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures of engine trace for docs/ray-tracing.md: glass and mirrors; built-in shapes by their formulas, as triangles, and the
difference; depths of reflection; models with shadows; and for docs/ray-tracing-vs-rasterization.md scenes by every way.

  ray_pictures.py [--program build/release/rakelight] glass|shapes|depths|ways OUT.png
  ray_pictures.py [--program build/release/rakelight] models OUT.png MODEL...

Only the standard library is needed."""
import argparse
import pathlib

from sheet import PROGRAM, write_sheet

GLASS = "data/rays/glass.scene.toml"
SHAPES = ("sphere", "cylinder", "cone", "torus")
LAMP = ("--light", "point:3,4,5:color=0.9,0.9,0.9", "--light", "ambient:0.15,0.15,0.16")
ROUND = ("--engine", "trace", "--color", "#c8a878", *LAMP, "--background", "0.8,0.8,0.82")
DEPTHS = (0, 1, 2, 8)
MODEL = ("--engine", "trace", "--hdri-ambient", "--light", "directional:-1,-1,-0.6:color=1.4,1.4,1.3")


def shape_rows():
    exact = [(f"builtin:{shape}:tolerance=0.05", *ROUND) for shape in SHAPES]
    coarse = [(*arguments, "--tessellate") for arguments in exact]
    return [exact, coarse, [(a, b, 4) for a, b in zip(exact, coarse)]]


def way_rows():
    """The same scene by each way, a row a scene: mirrors and glass; light that walls give one another; many parts."""
    plain = ("--look", "plain")
    lamp = ("--light", "point:0.278,0.5,0.28:color=1,0.53,0.13:attenuation=1,0,8")
    cornell, table = "data/paths/cornell.scene.toml", "data/world/room.scene.toml"
    soft, gl = ("--engine", "soft", "--shadows", "--samples", "4", *plain), ("--engine", "gl", "--shadows", "--samples", "4", *plain)
    cast, whitted = ("--engine", "trace", "--method", "cast", *plain), ("--engine", "trace", "--method", "whitted", *plain)
    path = ("--engine", "trace", "--method", "path", "--samples", "256", *plain)
    ways = (soft, gl, cast, whitted)
    return [[*((scene, *way, *light) for way in ways), (scene, *path)] for scene, light in ((GLASS, ()), (cornell, lamp), (table, ()))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("which", choices=("glass", "shapes", "depths", "ways", "models"))
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("models", nargs="*")
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    if options.which == "glass":
        write_sheet(options.picture, [[(GLASS,)]], 960, 640, options.program)
    elif options.which == "shapes":
        write_sheet(options.picture, shape_rows(), 200, 180, options.program, columns=SHAPES,
                    lines=("by formula", "triangles", "difference x 4"))
    elif options.which == "ways":
        write_sheet(options.picture, way_rows(), 240, 180, options.program,
                    columns=("soft, shadow maps", "gl, shadow maps", "casting", "ray tracing", "paths"))
    elif options.which == "depths":
        write_sheet(options.picture, [[(GLASS, "--max-depth", str(depth)) for depth in DEPTHS]], 300, 200, options.program,
                    columns=[f"--max-depth {depth}" for depth in DEPTHS])
    else:
        write_sheet(options.picture, [[(model, *MODEL) for model in options.models]], 360, 360, options.program)


if __name__ == "__main__":
    main()
