#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight render --samples` 1, 4 and 8 side by side, enlarged.

  sample_pictures.py [--program build/release/rakelight] OUT.png

A column a number of samples; a row a scene: the teapot's lid, thin triangles, panes. Only the standard library is needed."""
import argparse
import math
import pathlib
import subprocess
import tempfile

from png8 import read_rgb, write_rgb

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = ("1", "4", "8")
SIDE, SCALE = 40, 6
FRONT = ("--shading", "unlit", "--camera-orthographic", "--camera-position", "0,0,5", "--camera-focal-point", "0,0,0",
         "--background", "0,0,0")


def fan(path, alpha):
    """Thin triangles from one corner, white, of an opacity."""
    path.with_suffix(".mtl").write_text(f"newmtl thin\nKd 1 1 1\nd {alpha}\n")
    corners, faces = [(-1.1, -1.1)], []
    for k in range(12):
        for a in (k * 8 + 1, k * 8 + (1.5 if alpha == 1 else 6)):
            corners.append((-1.1 + 3.2 * math.cos(math.radians(a)), -1.1 + 3.2 * math.sin(math.radians(a))))
        faces.append((1, len(corners) - 1, len(corners)))
    path.write_text(f"mtllib {path.stem}.mtl\nusemtl thin\n" + "".join(f"v {x:.6f} {y:.6f} 0\n" for x, y in corners) +
                    "".join(f"f {a} {b} {c}\n" for a, b, c in faces))
    return path


def enlarged(rgb):
    rows = []
    for y in range(SIDE):
        row = b"".join(rgb[3 * (y * SIDE + x):3 * (y * SIDE + x) + 3] * SCALE for x in range(SIDE))
        rows += [row] * SCALE
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/rakelight")
    options = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        scenes = (("builtin:teapot", "--camera-position", "0.6,1.5,2.6", "--camera-focal-point", "0.0,0.85,0", "--camera-view-angle", "15"),
                  (str(fan(folder / "fan.obj", 1)), *FRONT), (str(fan(folder / "panes.obj", 0.5)), *FRONT))
        for scene in scenes:
            parts = []
            for samples in SAMPLES:
                picture = folder / "part.png"
                subprocess.run([options.program.resolve(), "render", *scene, "-o", picture, "--resolution", f"{SIDE},{SIDE}",
                                "--samples", samples], check=True, cwd=ROOT)
                parts.append(enlarged(read_rgb(picture)[2]))
            rows += [b"".join(part) for part in zip(*parts)]
    write_rgb(options.picture, SIDE * SCALE * len(SAMPLES), len(rows), b"".join(rows))


if __name__ == "__main__":
    main()
