#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Cuts an OBJ into a grid of objects, as an exporter does that writes one object per part.

  cut_obj.py IN.obj OUT.obj --grid NX,NY,NZ

Each face goes to the cell that holds its center, each cell becomes an object `part_I`. Vertices and texture coordinates are
kept as they are, to the digit; normals (vn) are dropped, so that whoever reads the file has to make them. `mtllib` lines are
kept: put the material and its pictures beside OUT. `usemtl` and `s` stay in force as the order of the faces had them."""
import argparse
import sys


def corner_without_normal(corner):
    parts = corner.split("/")
    return "/".join(parts[:2]) if len(parts) > 1 and parts[1] else parts[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("input")
    parser.add_argument("output")
    parser.add_argument("--grid", default="2,3,1", help="cells along x, y, z (default 2,3,1: six parts)")
    options = parser.parse_args()
    grid = [max(1, int(n)) for n in options.grid.split(",")]

    head, positions, faces, state = [], [], [], []
    with open(options.input, encoding="utf-8", errors="surrogateescape") as file:
        for line in file:
            words = line.split()
            if not words:
                continue
            if words[0] == "v":
                positions.append(tuple(float(x) for x in words[1:4]))
            if words[0] in ("v", "vt", "mtllib"):
                head.append(line.rstrip("\n"))
            elif words[0] in ("usemtl", "s"):
                state = [s for s in state if s.split()[0] != words[0]] + [line.strip()]
            elif words[0] == "f":
                if any(c.startswith("-") or "/-" in c for c in words[1:]):
                    sys.exit(f"{options.input}: relative indices are not supported by this tool")
                faces.append((tuple(state), words[1:]))
    if not faces:
        sys.exit(f"{options.input}: no faces")

    low = [min(p[k] for p in positions) for k in range(3)]
    high = [max(p[k] for p in positions) for k in range(3)]
    parts = {}
    for face_state, corners in faces:
        indices = [int(c.split("/")[0]) - 1 for c in corners]
        cell = 0
        for k in range(3):
            center = sum(positions[i][k] for i in indices) / len(indices)
            step = (high[k] - low[k]) / grid[k] or 1.0
            cell = cell * grid[k] + min(grid[k] - 1, int((center - low[k]) / step))
        parts.setdefault(cell, []).append((face_state, corners))

    with open(options.output, "w", encoding="utf-8", errors="surrogateescape") as out:
        out.write("\n".join(head) + "\n")
        for number, cell in enumerate(sorted(parts)):
            out.write(f"o part_{number}\n")
            current = ()
            for face_state, corners in parts[cell]:
                if face_state != current:
                    out.write("".join(s + "\n" for s in face_state))
                    current = face_state
                out.write("f " + " ".join(corner_without_normal(c) for c in corners) + "\n")
    print(f"{options.output}: {len(parts)} objects, {len(faces)} faces")


if __name__ == "__main__":
    main()
