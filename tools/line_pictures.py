#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Edges, wireframe, vertices and lines of a model side by side, for docs/lines.md.

  line_pictures.py [--program build/release/rakelight] OUT.png

Only the standard library is needed."""
import argparse
import pathlib
import subprocess
import tempfile

from png8 import read_rgb, write_rgb

ROOT = pathlib.Path(__file__).resolve().parent.parent
TEAPOT = ("builtin:teapot", "--camera-position", "1.6,1.5,2.4", "--camera-focal-point", "0.05,0.42,0", "--camera-view-angle", "35")
SPOT = ("data/spot/spot_slab5.glb", "--camera-position", "1.5,0.8,-1.9", "--camera-focal-point", "0,0.1,0.1", "--camera-view-angle", "52")
PICTURES = ((*TEAPOT, "--edges"), (*TEAPOT, "--wireframe"), (*SPOT, "--points", "disc", "--point-size", "3", "--line-color", "0.8,0.1,0.1"),
            (*SPOT, "--point-sprites", "--point-size", "2"))
WIDTH, HEIGHT = 280, 240


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/rakelight")
    options = parser.parse_args()
    parts = []
    with tempfile.TemporaryDirectory() as folder:
        for arguments in PICTURES:
            picture = pathlib.Path(folder) / "part.png"
            subprocess.run([options.program.resolve(), "render", *arguments, "-o", picture, "--resolution", f"{WIDTH},{HEIGHT}", "--quiet"],
                           check=True, cwd=ROOT)
            parts.append(read_rgb(picture)[2])
    stride = 3 * WIDTH
    rows = b"".join(part[y * stride:(y + 1) * stride] for y in range(HEIGHT) for part in parts)
    write_rgb(options.picture, WIDTH * len(parts), HEIGHT, rows)


if __name__ == "__main__":
    main()
