#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures of path tracing for docs/path-tracing.md: the Cornell box; by depth; noise and denoising; glass and mirrors; what the soft
engine's shadows, environment and ambient light leave out; models by both.

  path_pictures.py [--program build/release/rakelight] cornell|depths|noise|glass|approximations OUT.png
  path_pictures.py [--program build/release/rakelight] models OUT.png MODEL...

Only the standard library is needed."""
import argparse
import pathlib

from sheet import PROGRAM, write_sheet

CORNELL = "data/paths/cornell.scene.toml"
PATHS = ("--engine", "trace", "--method", "path")
DEPTHS = (0, 1, 2, 8)
AROUND = ("--hdri-ambient", "--background", "0.5,0.5,0.52")


GLASS = "data/rays/glass.scene.toml"
KNIGHT = "data/knight/Knight_noNormals.glb"
ROOM = "data/paths/cornell.scene.toml"
SUN = ("--light", "directional:-0.5,-1,-0.6:color=2.4,2.3,2.1")


def soft_and_paths(*words, soft=(), paths=(), times=2):
    """The soft engine's picture, that by paths, and their difference."""
    pair = ((*words, "--engine", "soft", "--samples", "8", *soft), (*words, *PATHS, "--samples", "512", *paths))
    return [*pair, (*pair, times)]


def model_rows(models):
    return [soft_and_paths(model, *AROUND) for model in models]


def approximation_rows():
    """One approximation each: the rest is alike."""
    lamp = ("--light", "point:0.278,0.5,0.28:color=0.5,0.5,0.5:attenuation=1,0,8")
    return [soft_and_paths(KNIGHT, *SUN, "--shadows", paths=("--max-depth", "0"), times=4),
            soft_and_paths("builtin:sphere", "--hdri-ambient", "--material", "metallic=1", "--material", "roughness=0.4", times=4),
            soft_and_paths(KNIGHT, *AROUND),
            soft_and_paths(ROOM, *lamp, "--shadows", "--material", "emission=0,0,0", soft=("--light", "ambient:0.12,0.12,0.12"))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("which", choices=("cornell", "depths", "noise", "glass", "approximations", "models"))
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("models", nargs="*")
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    if options.which == "cornell":
        write_sheet(options.picture, [[(CORNELL, *PATHS)]], 480, 480, options.program, samples=1024)
    elif options.which == "depths":
        write_sheet(options.picture, [[(CORNELL, *PATHS, "--max-depth", str(depth)) for depth in DEPTHS]], 240, 240, options.program, samples=256,
                    columns=[f"--max-depth {depth}" for depth in DEPTHS])
    elif options.which == "noise":
        write_sheet(options.picture, [[(CORNELL, *PATHS), (CORNELL, *PATHS, "--denoise"), (CORNELL, *PATHS, "--light-sampling", "materials")]],
                    300, 300, options.program, samples=16, columns=("16 samples", "--denoise", "--light-sampling materials"))
    elif options.which == "glass":
        write_sheet(options.picture, [[(GLASS, "--method", "whitted", "--samples", "8"), (GLASS, *PATHS),
                                       (GLASS, *PATHS, "--clamp", "4", "--denoise")]],
                    400, 267, options.program, samples=512, columns=("--method whitted", "--method path", "--clamp 4 --denoise"))
    elif options.which == "approximations":
        write_sheet(options.picture, approximation_rows(), 300, 300, options.program, columns=("soft", "paths", "difference"),
                    lines=("shadow maps (x 4)", "prefiltered sky (x 4)", "no occlusion (x 2)", "ambient light (x 2)"))
    else:
        write_sheet(options.picture, model_rows(options.models), 320, 320, options.program, columns=("soft", "paths", "difference x 2"))


if __name__ == "__main__":
    main()
