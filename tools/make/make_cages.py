#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Control nets of quads for subdivision: data/cages/cube.obj, and data/cages/jack.obj, whose six arms are objects of their own.

  make_cages.py [FOLDER]        default: data/cages; writes the materials beside"""
import itertools
import pathlib
import sys

COLORS = {"red": (0.75, 0.25, 0.2), "yellow": (0.8, 0.65, 0.2), "green": (0.3, 0.6, 0.3),
          "blue": (0.25, 0.4, 0.75), "violet": (0.55, 0.35, 0.65), "gray": (0.7, 0.7, 0.7)}
LOOP = ((-1, -1), (1, -1), (1, 1), (-1, 1))  # counter-clockwise about the third axis


def ring(axis, sign, distance, width):
    """A square's corners, counter-clockwise as seen from outside."""
    corners = []
    for a, b in LOOP if sign > 0 else LOOP[::-1]:
        p = [0.0, 0.0, 0.0]
        p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = sign * distance, a * width, b * width
        corners.append(p)
    return corners


def write(path, objects):
    """objects: (name, material, quads of points). Corners at one place are one vertex of an object."""
    lines, count = ["mtllib cages.mtl"], 0
    for name, material, quads in objects:
        numbers = {}
        lines += [f"o {name}"]
        for point in itertools.chain(*quads):
            if tuple(point) not in numbers:
                numbers[tuple(point)] = count = count + 1
                lines.append("v " + " ".join(f"{x:g}" for x in point))
        lines.append(f"usemtl {material}")
        lines += ["f " + " ".join(str(numbers[tuple(p)]) for p in quad) for quad in quads]
    path.write_text("\n".join(lines) + "\n")


def arm(axis, sign):
    """Two tubes of four quads, the outer one thicker, and a cap; the cube that the arms stand on has no sides left."""
    rings = [ring(axis, sign, 0.5, 0.5), ring(axis, sign, 1.2, 0.3), ring(axis, sign, 1.9, 0.55)]
    quads = [[low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i]]
             for low, high in zip(rings, rings[1:]) for i in range(4)]
    return quads + [rings[-1]]


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2] / "data/cages")
    folder.mkdir(parents=True, exist_ok=True)
    sides = list(itertools.product(range(3), (-1, 1)))
    write(folder / "cube.obj", [("cube", "gray", [ring(axis, sign, 1, 1) for axis, sign in sides])])
    write(folder / "jack.obj", [(f"arm{i + 1}", list(COLORS)[i], arm(*side)) for i, side in enumerate(sides)])
    (folder / "cages.mtl").write_text("".join(
        f"newmtl {name}\nKd {r} {g} {b}\nKs 0.15 0.15 0.15\nNs 40\n" for name, (r, g, b) in COLORS.items()))


if __name__ == "__main__":
    main()
