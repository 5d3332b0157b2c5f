#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Puts pictures of equal height side by side:  side_by_side.py OUT.png A.png B.png ..."""
import sys

from png8 import read_rgb, write_rgb


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    pictures = [read_rgb(path) for path in sys.argv[2:]]
    height = pictures[0][1]
    if any(p[1] != height for p in pictures):
        sys.exit("the pictures differ in height")
    rows = []
    for y in range(height):
        rows += [pixels[y * width * 3:(y + 1) * width * 3] for width, _, pixels in pictures]
    write_rgb(sys.argv[1], sum(p[0] for p in pictures), height, b"".join(rows))


if __name__ == "__main__":
    main()
