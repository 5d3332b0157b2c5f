#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Puts pictures of equal height side by side:  side_by_side.py [--halve | --enlarge] OUT.png A.png B.png ...

--enlarge shows every pixel as 4 x 4. --halve averages 2 x 2 pixels first, in linear light: smooth borders from pictures rendered at twice the size."""
import sys

from png8 import read_rgb, write_rgb


def linear(code):
    s = code / 255
    return s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4


def code(light):
    s = light * 12.92 if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055
    return int(s * 255 + 0.5)


def halve(width, height, pixels):
    to_linear = [linear(c) for c in range(256)]
    to_code = [code(i / 4095) for i in range(4096)]
    stride, out = width * 3, bytearray()
    for y in range(0, height - 1, 2):
        above, below = pixels[y * stride:(y + 1) * stride], pixels[(y + 1) * stride:(y + 2) * stride]
        for x in range(0, stride - 5, 6):
            for c in (x, x + 1, x + 2):
                light = to_linear[above[c]] + to_linear[above[c + 3]] + to_linear[below[c]] + to_linear[below[c + 3]]
                out.append(to_code[int(light * 1023.75 + 0.5)])
    return width // 2, height // 2, bytes(out)


def enlarge(width, height, pixels):
    rows = [b"".join(pixels[i:i + 3] * 4 for i in range(3 * width * y, 3 * width * (y + 1), 3)) for y in range(height)]
    return width * 4, height * 4, b"".join(row for row in rows for _ in range(4))


def main():
    change = {"--halve": halve, "--enlarge": enlarge}.get(sys.argv[1]) if len(sys.argv) > 1 else None
    arguments = sys.argv[2 if change else 1:]
    if len(arguments) < 2:
        sys.exit(__doc__)
    pictures = [read_rgb(path) for path in arguments[1:]]
    if change:
        pictures = [change(*p) for p in pictures]
    height = pictures[0][1]
    if any(p[1] != height for p in pictures):
        sys.exit("the pictures differ in height")
    rows = []
    for y in range(height):
        rows += [pixels[y * width * 3:(y + 1) * width * 3] for width, _, pixels in pictures]
    write_rgb(arguments[0], sum(p[0] for p in pictures), height, b"".join(rows))


if __name__ == "__main__":
    main()
