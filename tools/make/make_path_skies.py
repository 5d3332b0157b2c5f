#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the environments of the reference pictures of path tracing, equirectangular: data/paths/white.hdr, 1 in every direction, and
data/paths/sky.hdr, a blue sky over brown ground with a sun of 8 degrees radius that gives about as much light as all the rest.
  make_path_skies.py [FOLDER]
"""
import math
import pathlib
import sys

from make_hdr_ramp import HEIGHT, WIDTH, packed, rgbe

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "data/paths"
HEAD = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n"
ZENITH, HORIZON, GROUND, SUN = (0.18, 0.32, 0.75), (0.75, 0.85, 1.0), (0.22, 0.17, 0.12), (100.0, 90.0, 75.0)
SUN_UP, SUN_RIGHT, SUN_RADIUS = math.radians(38), math.radians(130), math.radians(8)  # SUN_RIGHT: from the picture's middle


def mixed(a, b, share):
    return [x + (y - x) * share for x, y in zip(a, b)]


def sky(x, y):
    up, right = math.pi * (0.5 - (y + 0.5) / HEIGHT), 2 * math.pi * ((x + 0.5) / WIDTH - 0.5)
    cosine = math.sin(up) * math.sin(SUN_UP) + math.cos(up) * math.cos(SUN_UP) * math.cos(right - SUN_RIGHT)
    if cosine > math.cos(SUN_RADIUS):
        return SUN
    return GROUND if up < 0 else mixed(HORIZON, ZENITH, math.sqrt(math.sin(up)))


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER
    rows = b"".join(packed([rgbe(sky(x, y)) for x in range(WIDTH)]) for y in range(HEIGHT))
    (folder / "sky.hdr").write_bytes((HEAD % (HEIGHT, WIDTH)).encode() + rows)
    (folder / "white.hdr").write_bytes((HEAD % (2, 4)).encode() + rgbe((1, 1, 1)) * 8)


if __name__ == "__main__":
    main()
