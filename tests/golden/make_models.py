#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes tests/golden/models: what the models of data/ do not have. Run again only to change them.

  solids.obj   a ball and a cube without texture coordinates, material with a texture (for --uv)
  floor.obj    a floor of 400 m that passes below and behind the eye, texture repeated 200 times, and two panes of glass
  checker.png  red grows with u, green with v downwards, every other field darker: shows which way up a texture lies"""
import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT.parent.parent / "tools/pictures"))
from png8 import write_rgb  # noqa: E402

HEAD = "# Made by tests/golden/make_models.py. Apache-2.0, as the project.\n"
MATERIALS = HEAD + """newmtl checker
Kd 1 1 1
Ks 0.2 0.2 0.2
Ns 30
map_Kd checker.png
newmtl red_glass
Kd 0.9 0.1 0.1
d 0.5
newmtl blue_glass
Kd 0.1 0.1 0.9
d 0.5
"""


def ball(columns, rows, center, radius):
    """(vertices, faces counted from 0) of a sphere of latitude and longitude, poles on the y axis."""
    points = []
    for r in range(1, rows):
        b = math.pi * r / rows
        points += [(math.sin(b) * math.sin(a), math.cos(b), math.sin(b) * math.cos(a))
                   for a in (2 * math.pi * c / columns for c in range(columns))]
    top, bottom = len(points), len(points) + 1
    points += [(0, 1, 0), (0, -1, 0)]
    faces = []
    for c in range(columns):
        d = (c + 1) % columns
        faces.append((top, c, d))
        for r in range(rows - 2):
            faces.append((r * columns + c, (r + 1) * columns + c, (r + 1) * columns + d, r * columns + d))
        faces.append((bottom, (rows - 2) * columns + d, (rows - 2) * columns + c))
    return [tuple(round(x * radius + o, 5) for x, o in zip(p, center)) for p in points], faces


def cube(center, half):
    points = [tuple(o + half * s for o, s in zip(center, (x, y, z))) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    return points, [(4, 5, 7, 6), (1, 0, 2, 3), (5, 1, 3, 7), (0, 4, 6, 2), (6, 7, 3, 2), (0, 1, 5, 4)]


def solids():
    text, first = HEAD + "mtllib golden.mtl\n", 1
    for name, (points, faces) in (("ball", ball(24, 12, (-1.1, 0, 0), 1)), ("cube", cube((1.1, -0.2, 0), 0.8))):
        text += f"o {name}\nusemtl checker\n" + "".join("v %g %g %g\n" % p for p in points)
        text += "".join("f " + " ".join(str(i + first) for i in face) + "\n" for face in faces)
        first += len(points)
    return text


def floor():
    text, first = HEAD + "mtllib golden.mtl\n", 1
    panes = (("floor", "checker", [(-200, 0, 200), (200, 0, 200), (200, 0, -200), (-200, 0, -200)], 200),
             ("near pane", "red_glass", [(-1.5, 0.2, 0), (0.4, 0.2, 0), (0.4, 1.8, 0), (-1.5, 1.8, 0)], 1),
             ("far pane", "blue_glass", [(-0.4, 0.5, -1), (1.6, 0.5, -1), (1.6, 2.1, -1), (-0.4, 2.1, -1)], 1))
    for name, material, points, repeat in panes:
        text += f"o {name}\nusemtl {material}\n" + "".join("v %g %g %g\n" % p for p in points)
        text += f"vt 0 0\nvt {repeat} 0\nvt {repeat} {repeat}\nvt 0 {repeat}\n"
        text += "f " + " ".join(f"{first + i}/{first + i}" for i in range(4)) + "\n"
        first += 4
    return text


def main():
    models = ROOT / "models"
    models.mkdir(exist_ok=True)
    (models / "golden.mtl").write_text(MATERIALS)
    (models / "solids.obj").write_text(solids())
    (models / "floor.obj").write_text(floor())
    size = 64
    write_rgb(models / "checker.png", size, size, bytes(
        int(c * (1 if (x // 8 + y // 8) % 2 else 0.55)) for y in range(size) for x in range(size)
        for c in (60 + 3 * x, 60 + 3 * y, 110)))


if __name__ == "__main__":
    main()
