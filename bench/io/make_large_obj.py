#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a large OBJ file for measurements: a sphere with bumps as a grid of triangles, in a few objects.

    make_large_obj.py OUT.obj [--triangles 2000000] [--objects 8] [--texcoords] [--normals] [--quads]

All of it comes from formulas: the same bytes on every machine. Without options: 1M vertices, 2M triangles, 75 MB. The objects are
bands of latitude that share a circle of positions, each with vertices of its own (the seams that `smooth` closes).
"""
import argparse
import math


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out")
    parser.add_argument("--triangles", type=int, default=2_000_000)
    parser.add_argument("--objects", type=int, default=8)
    parser.add_argument("--texcoords", action="store_true")
    parser.add_argument("--normals", action="store_true")
    parser.add_argument("--quads", action="store_true", help="faces of four corners")
    options = parser.parse_args()
    side = max(2, math.isqrt(options.triangles // 2))  # cells along each direction
    around = [(math.cos(2 * math.pi * j / side), math.sin(2 * math.pi * j / side)) for j in range(side)]
    with open(options.out, "w", encoding="ascii", newline="\n") as out:
        out.write("# a sphere with bumps\n")
        first = 1  # the number of the object's first vertex
        for k in range(options.objects):
            rows = range(side * k // options.objects, side * (k + 1) // options.objects + 1)
            out.write(f"o band_{k}\n")
            write_vertices(out, rows, side, around, options)
            write_faces(out, first, len(rows) - 1, side, options)
            first += len(rows) * side


def write_vertices(out, rows, side, around, options):
    for i in rows:
        latitude = math.pi * (i / side - 0.5) * 0.999
        up, wide = math.sin(latitude), math.cos(latitude)
        lines = []
        for j, (c, s) in enumerate(around):
            r = 1 + 0.05 * around[i * 7 % side][1] * around[j * 5 % side][0]
            lines.append(f"v {r * wide * c:.6f} {r * up:.6f} {r * wide * s:.6f}\n")
            if options.texcoords:
                lines.append(f"vt {j / side:.5f} {i / side:.5f}\n")
            if options.normals:
                lines.append(f"vn {wide * c:.4f} {up:.4f} {wide * s:.4f}\n")
        out.write("".join(lines))


def write_faces(out, first, rows, side, options):
    def corner(n):
        return f"{n}" if not (options.texcoords or options.normals) else \
            f"{n}/{n if options.texcoords else ''}" + (f"/{n}" if options.normals else "")

    for i in range(rows):
        lines = []
        low = [corner(first + i * side + j % side) for j in range(side + 1)]
        high = [corner(first + (i + 1) * side + j % side) for j in range(side + 1)]
        for j in range(side):
            if options.quads:
                lines.append(f"f {low[j]} {high[j]} {high[j + 1]} {low[j + 1]}\n")
            else:
                lines.append(f"f {low[j]} {high[j]} {high[j + 1]}\nf {low[j]} {high[j + 1]} {low[j + 1]}\n")
        out.write("".join(lines))


if __name__ == "__main__":
    main()
