#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures of path tracing for docs/path-tracing.md: the Cornell box; by depth; noise and denoising; models beside the soft engine.

  path_pictures.py [--program build/release/rakelight] cornell|depths|noise OUT.png
  path_pictures.py [--program build/release/rakelight] models OUT.png MODEL...

Only the standard library is needed."""
import argparse
import pathlib

from sheet import PROGRAM, write_sheet

CORNELL = "data/paths/cornell.scene.toml"
PATHS = ("--engine", "trace", "--method", "path")
DEPTHS = (0, 1, 2, 8)
AROUND = ("--hdri-ambient", "--background", "0.5,0.5,0.52")


def model_rows(models):
    """Each by the soft engine, by paths, and the difference."""
    both = [((model, *AROUND), (model, *AROUND, *PATHS)) for model in models]
    return [[soft, paths, (soft, paths, 2)] for soft, paths in both]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("which", choices=("cornell", "depths", "noise", "models"))
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
    else:
        write_sheet(options.picture, model_rows(options.models), 320, 320, options.program, samples=8, columns=("soft", "paths", "difference x 2"))


if __name__ == "__main__":
    main()
