#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes data/environment/ramp.hdr: an equirectangular picture whose middle holds five rows of color (white, skin, red, green, blue) in 13 steps of one
stop, from 2^-6 to 2^6, on black.     make_hdr_ramp.py OUT.hdr
"""
import math
import struct
import sys

WIDTH, HEIGHT = 256, 128
COLORS = [(1, 1, 1), (0.8, 0.5, 0.36), (1, 0.03, 0.02), (0.04, 0.8, 0.05), (0.03, 0.06, 1)]
LEFT, TOP, STEP, ROW = 102, 54, 4, 4  # px


def rgbe(color):
    brightest = max(color)
    if brightest < 1e-32:
        return bytes(4)
    mantissa, exponent = math.frexp(brightest)
    scale = mantissa * 256 / brightest
    return struct.pack("4B", *(int(c * scale) for c in color), exponent + 128)


def packed(row):
    """A row as the format has it: its four planes one after another, runs as 128 + length and the value."""
    out = bytearray([2, 2, WIDTH >> 8, WIDTH & 255])
    for plane in range(4):
        values, x = [pixel[plane] for pixel in row], 0
        while x < WIDTH:
            end = x + 1
            while end < WIDTH and values[end] == values[x] and end - x < 127:
                end += 1
            out += bytes([128 + end - x, values[x]])
            x = end
    return bytes(out)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    rows = []
    for y in range(HEIGHT):
        pixels = []
        for x in range(WIDTH):
            row, step = (y - TOP) // ROW, (x - LEFT) // STEP
            is_in = 0 <= row < len(COLORS) and 0 <= step < 13
            pixels.append(rgbe([c * 2.0 ** (step - 6) for c in COLORS[row]] if is_in else (0, 0, 0)))
        rows.append(packed(pixels))
    with open(sys.argv[1], "wb") as out:
        out.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (HEIGHT, WIDTH) + b"".join(rows))


if __name__ == "__main__":
    main()
