#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Kinds of light, models of reflection, normal maps and projected textures side by side, for docs/lighting.md.

  lighting_pictures.py [--program build/release/rakelight] OUT.png

Four columns, a row a subject: see ROWS. Only the standard library is needed."""
import argparse
import pathlib
import subprocess
import tempfile

from png8 import read_rgb, write_rgb

ROOT = pathlib.Path(__file__).resolve().parent.parent
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
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/rakelight")
    options = parser.parse_args()
    program, stride, rows = options.program.resolve(), 3 * WIDTH, b""
    with tempfile.TemporaryDirectory() as folder:
        for scene, *row in ROWS:
            parts = []
            for arguments in row:
                picture = pathlib.Path(folder) / "part.png"
                subprocess.run([program, "render", *scene, *arguments, "-o", picture, "--resolution", f"{WIDTH},{HEIGHT}", "--samples", "8", "--quiet"],
                               check=True, cwd=ROOT)
                parts.append(read_rgb(picture)[2])
            rows += b"".join(part[y * stride:(y + 1) * stride] for y in range(HEIGHT) for part in parts)
    write_rgb(options.picture, WIDTH * 4, HEIGHT * len(ROWS), rows)


if __name__ == "__main__":
    main()
