#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a tileable height map and the tangent-space normal map (green up) of the same relief, by formula:

    make_bump_maps.py brick|leather|scratches|dents OUT_STEM [SIZE]    ->  OUT_STEM_height.png, OUT_STEM_normal.png

brick: courses in running bond with rounded borders and a soft grain; leather: cells about scattered points, their
borders the creases; scratches: straight grooves of every direction in a plate; dents: a bump and a dent. White is high. The normal map holds the
slopes of the relief at the depth of DEPTHS, in widths of the texture: with that depth a height bump looks the same."""
import pathlib
import math
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "pictures"))
from png8 import write_rgb  # noqa: E402


DEPTHS = {"brick": 0.05, "leather": 0.02, "scratches": 0.006, "dents": 0.15}


def smooth(t):
    t = min(max(t, 0.0), 1.0)
    return t * t * (3 - 2 * t)


def periodic_noise(size, cells, seed):
    """Value noise of `cells` by `cells` random values, smoothly interpolated, in 0..1; [row][column]."""
    draw = random.Random(seed)
    grid = [[draw.random() for _ in range(cells)] for _ in range(cells)]

    def at(x, y):
        u, v = x * cells / size, y * cells / size
        i, j = int(u), int(v)
        s, t = smooth(u - i), smooth(v - j)
        i, j, right, below = i % cells, j % cells, (i + 1) % cells, (j + 1) % cells
        top = grid[j][i] * (1 - s) + grid[j][right] * s
        bottom = grid[below][i] * (1 - s) + grid[below][right] * s
        return top * (1 - t) + bottom * t
    return [[at(x, y) for x in range(size)] for y in range(size)]


def brick(size):
    rows, columns, joint, rounding = 8, 4, 0.10, 0.16  # joint and rounding in heights of a course
    draw = random.Random(1978)
    lift = [[draw.random() for _ in range(columns)] for _ in range(rows)]
    coarse, fine = periodic_noise(size, 16, 1), periodic_noise(size, 64, 2)

    def height(x, y):
        v = (y + 0.5) / size * rows
        row = int(v) % rows
        u = ((x + 0.5) / size * columns + 0.5 * (row % 2)) % columns
        across = (0.5 - abs(u % 1 - 0.5)) * rows / columns  # to the nearest border, in heights of a course
        down = 0.5 - abs(v % 1 - 0.5)
        top = 0.78 + 0.14 * lift[row][int(u)] + 0.06 * coarse[y][x]
        return smooth((min(across, down) - joint / 2) / rounding) * top + 0.05 * fine[y][x]
    return height


def leather(size):
    cells = 20
    draw = random.Random(2000)
    points = [[(draw.uniform(0.1, 0.9), draw.uniform(0.1, 0.9)) for _ in range(cells)] for _ in range(cells)]
    swell, fine = periodic_noise(size, 6, 3), periodic_noise(size, 64, 4)

    def height(x, y):
        u, v = (x + 0.5) * cells / size, (y + 0.5) * cells / size
        i, j, near = int(u), int(v), []
        for dj in (-1, 0, 1):
            for di in (-1, 0, 1):
                a, b = points[(j + dj) % cells][(i + di) % cells]
                near.append(math.hypot(i + di + a - u, j + dj + b - v))
        first, second = sorted(near)[:2]  # Worley 1996: the second nearest less the nearest is 0 on the borders
        return smooth((second - first) / 0.45) * (0.62 + 0.2 * swell[y][x]) + 0.12 * fine[y][x]
    return height


def scratches(size):
    draw = random.Random(42)
    field = [[0.0] * size for _ in range(size)]
    for _ in range(150):
        x, y, angle = draw.random() * size, draw.random() * size, draw.gauss(0.35, 0.5) + (math.pi if draw.random() < 0.5 else 0)
        length, depth, bend = draw.uniform(0.08, 0.5) * size, draw.uniform(0.25, 1.0), draw.gauss(0, 0.4) / size
        for step in range(int(length * 2)):
            share = step / (length * 2)
            groove = depth * smooth(8 * share) * smooth(8 * (1 - share))  # it runs out at both ends
            for dy in range(-2, 3):
                for dx in range(-2, 3):
                    i, j = math.floor(x) + dx, math.floor(y) + dy
                    far = abs((i + 0.5 - x) * -math.sin(angle) + (j + 0.5 - y) * math.cos(angle))
                    cut = groove * smooth(1 - far / 1.6)
                    field[j % size][i % size] = max(field[j % size][i % size], cut)
            x, y, angle = x + 0.5 * math.cos(angle), y + 0.5 * math.sin(angle), angle + 0.5 * bend
    fine = periodic_noise(size, 32, 5)
    return lambda x, y: 0.96 - 0.9 * field[y][x] + 0.04 * fine[y][x]


def dents(size):
    def height(x, y):
        u, v = (x + 0.5) / size, (y + 0.5) / size
        bump, dent = math.hypot(u - 0.27, v - 0.5) / 0.2, math.hypot(u - 0.73, v - 0.5) / 0.2
        return 0.5 + 0.5 * smooth(1 - bump) - 0.5 * smooth(1 - dent)
    return height


def normals(field, size, depth):
    """Central differences, wrapped round; rows count downwards, green points up."""
    strength, pixels = depth * size, bytearray()
    for y in range(size):
        for x in range(size):
            dx = (field[y][(x + 1) % size] - field[y][x - 1]) * 0.5 * strength
            dy = (field[(y + 1) % size][x] - field[y - 1][x]) * 0.5 * strength
            length = math.sqrt(dx * dx + dy * dy + 1)
            pixels += bytes(int(round((c / length * 0.5 + 0.5) * 255)) for c in (-dx, dy, 1))
    return bytes(pixels)


def main():
    kind, stem, size = sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) > 3 else 256
    height = {"brick": brick, "leather": leather, "scratches": scratches, "dents": dents}[kind](size)
    field = [[min(max(height(x, y), 0.0), 1.0) for x in range(size)] for y in range(size)]
    gray = bytearray()
    for row in field:
        for h in row:
            gray += bytes([int(round(h * 255))] * 3)
    write_rgb(stem + "_height.png", size, size, bytes(gray))
    write_rgb(stem + "_normal.png", size, size, normals(field, size, DEPTHS[kind]))


if __name__ == "__main__":
    main()
