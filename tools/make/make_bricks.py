#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a tileable tangent-space normal map of a brick wall (green up):  make_bricks.py OUT.png [SIZE]

A height field of bricks with rounded borders, sunken joints and a fine grain of its own; the normal is its central
difference, wrapped round."""
import pathlib
import math
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "pictures"))
from png8 import write_rgb  # noqa: E402



def main():
    path, size = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 256
    rows, columns, joint, rounding = 8, 4, 0.09, 0.10
    noise = random.Random(1975)
    grain = [[noise.random() for _ in range(size)] for _ in range(size)]
    lift = [[noise.random() for _ in range(columns)] for _ in range(rows)]

    def height(x, y):
        v = y / size * rows
        row = int(v) % rows
        u = x / size * columns + 0.5 * (row % 2)
        column = int(u) % columns
        across, down = abs(u - math.floor(u) - 0.5) * 2, abs(v - math.floor(v) - 0.5) * 2
        edge = min((1 - across) * size / columns, (1 - down) * size / rows) / (size / rows)  # 0 at the brick's border
        t = min(max((edge - joint) / rounding, 0.0), 1.0)
        return t * t * (3 - 2 * t) * (0.85 + 0.15 * lift[row][column]) + 0.035 * grain[y][x]

    field = [[height(x, y) for x in range(size)] for y in range(size)]
    strength, pixels = 0.02 * size, bytearray()
    for y in range(size):
        for x in range(size):
            dx = (field[y][(x + 1) % size] - field[y][x - 1]) * 0.5 * strength
            dy = (field[(y + 1) % size][x] - field[y - 1][x]) * 0.5 * strength  # rows count downwards
            length = math.sqrt(dx * dx + dy * dy + 1)
            pixels += bytes(int(round((c / length * 0.5 + 0.5) * 255)) for c in (-dx, dy, 1))
    write_rgb(path, size, size, bytes(pixels))


if __name__ == "__main__":
    main()
