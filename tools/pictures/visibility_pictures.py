#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The methods of `rakelight render --visibility` side by side on scenes where some of them fail.

  visibility_pictures.py [--program build/release/rakelight] OUT.png

A column a method, in the order of METHODS; a row a scene, in the order of SCENES. Only the standard library is needed."""
import argparse
import pathlib
import subprocess
import tempfile

from png8 import read_rgb, write_rgb

ROOT = pathlib.Path(__file__).resolve().parents[2]
METHODS = ("none", "back-face", "painter", "z16", "z24", "z32", "z-float", "z-reversed")
FRONT = ("--shading", "unlit", "--camera-position", "0,0,5", "--camera-focal-point", "0,0,0")
SCENES = (
    ("data/visibility/cyclic.obj", *FRONT, "--camera-view-angle", "46"),
    ("data/visibility/crossing.obj", *FRONT, "--camera-view-angle", "36"),
    ("data/visibility/near_planes.gltf",),
    ("builtin:teapot", "--camera-position", "1.6,1.5,2.4", "--camera-focal-point", "0.05,0.45,0", "--camera-view-angle", "41"),
)
SIDE = 120


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/rakelight")
    options = parser.parse_args()
    rows = b""
    with tempfile.TemporaryDirectory() as folder:
        for scene in SCENES:
            parts = []
            for method in METHODS:
                picture = pathlib.Path(folder) / "part.png"
                subprocess.run([options.program.resolve(), "render", *scene, "-o", picture, "--resolution", f"{SIDE},{SIDE}",
                                "--visibility", method], check=True, cwd=ROOT)
                parts.append(read_rgb(picture)[2])
            stride = 3 * SIDE
            rows += b"".join(part[y * stride:(y + 1) * stride] for y in range(SIDE) for part in parts)
    write_rgb(options.picture, SIDE * len(METHODS), SIDE * len(SCENES), rows)


if __name__ == "__main__":
    main()
