# SPDX-License-Identifier: Apache-2.0
"""Arrows in a picture of a scene: directions at places, as its camera sees them."""
import math

from png8 import read_rgb, write_rgb

from .kit import cross, dot, minus, unit


def projection(eye, center, view_angle, width, height):
    """A function from a place to its pixel, for a camera that is upright."""
    w = unit(minus(eye, center))
    u = unit(cross((0, 1, 0), w))
    v, far = cross(w, u), height / 2 / math.tan(math.radians(view_angle) / 2)

    def pixel(point):
        moved = minus(point, eye)
        return width / 2 - far * dot(u, moved) / dot(w, moved), height / 2 + far * dot(v, moved) / dot(w, moved)
    return pixel


def line(picture, width, height, start, end, color):
    """Two pixels wide."""
    steps = max(1, round(max(abs(a - b) for a, b in zip(start, end))) * 2)
    for k in range(steps + 1):
        x, y = (round(a + (b - a) * k / steps) for a, b in zip(start, end))
        for i, j in ((x, y), (x + 1, y), (x, y + 1)):
            if 0 <= i < width and 0 <= j < height:
                picture[3 * (j * width + i):3 * (j * width + i) + 3] = bytes(color)


def write_arrows(source, path, arrows, eye, center, view_angle, length):
    """arrows: (place, [(direction, color)]); those that point at the eye become dots."""
    width, height, pixels = read_rgb(source)
    picture, pixel = bytearray(pixels), projection(eye, center, view_angle, width, height)
    for place, directions in arrows:
        for direction, color in directions:
            start, end = pixel(place), pixel([p + length * d for p, d in zip(place, direction)])
            line(picture, width, height, start, end, color)
            back = [0.3 * (a - b) for a, b in zip(start, end)]
            for turn in (0.5, -0.5):
                line(picture, width, height, end, (end[0] + back[0] - turn * back[1], end[1] + back[1] + turn * back[0]), color)
    write_rgb(path, width, height, bytes(picture))
