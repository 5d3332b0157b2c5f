#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How often lighting is evaluated, what it costs and what it gives: one sphere at five tessellations x own color / flat / Gouraud /
Phong, against the picture with Phong shading of the finest.

  shading_table.py [--program build/release/rakelight] [--repeat N] [--picture OUT.png]

Prints a table: lighting evaluations, fastest time of the engine of N runs [ms], and the root of the mean square difference over all channels
[1/255, as displayed]. --picture puts the four of the second tessellation side by side. Only the standard library is needed."""
import argparse
import json
import math
import pathlib
import subprocess
import tempfile

from png8 import read_rgb, write_rgb

ROOT = pathlib.Path(__file__).resolve().parents[2]
FREQUENCIES = ("unlit", "flat", "gouraud", "phong")
ROWS = (8, 16, 32, 64, 128)
SHOWN = 16
MATERIAL = "newmtl plastic\nKd 0.7 0.3 0.15\nKa 0.7 0.3 0.15\nKs 0.7 0.7 0.7\nNs 40\n"
VIEW = ("--camera-position", "0,0,5", "--camera-focal-point", "0,0,0", "--camera-view-angle", "25", "--cull", "back", "--background",
        "0,0,0", "--resolution", "512,512", "--lighting", "blinn-phong", "--light", "point:2,3,4", "--light", "ambient:0.1,0.1,0.1",
        "--normals", "file")


def write_sphere(path, rows):
    """A unit sphere with its exact normals; twice as many columns as rows."""
    columns = 2 * rows
    points = [(0.0, 1.0, 0.0)]
    points += [(math.sin(b) * math.sin(a), math.cos(b), math.sin(b) * math.cos(a)) for b in (math.pi * r / rows for r in range(1, rows))
               for a in (2 * math.pi * c / columns for c in range(columns))]
    points.append((0.0, -1.0, 0.0))

    def at(r, c):
        return 2 + r * columns + c % columns
    faces = [(1, at(0, c), at(0, c + 1)) for c in range(columns)]
    for r in range(rows - 2):
        faces += [(at(r, c), at(r + 1, c), at(r + 1, c + 1), at(r, c + 1)) for c in range(columns)]
    faces += [(len(points), at(rows - 2, c + 1), at(rows - 2, c)) for c in range(columns)]
    lines = ["mtllib sphere.mtl", "usemtl plastic"] + ["%s %.9g %.9g %.9g" % (kind, *p) for kind in ("v", "vn") for p in points]
    lines += ["f " + " ".join(f"{i}//{i}" for i in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")
    path.with_name("sphere.mtl").write_text(MATERIAL)


def render(program, model, picture, shading):
    done = subprocess.run([program, "render", model, "-o", picture, "--shading", shading, "--json", *VIEW], check=True, capture_output=True,
                          text=True)
    return json.loads(done.stdout)["rows"][0]


def difference(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a[2], b[2])) / len(a[2]))


def measure(options, folder):
    """[(rows, frequency, row of the program, ms)], pictures lie in `folder`. Rounds go through all cases, so that a slow moment of the
    machine falls on all of them."""
    cases = [(rows, shading) for rows in ROWS for shading in FREQUENCIES]
    times, answers = {case: [] for case in cases}, {}
    for rows in ROWS:
        write_sphere(folder / f"sphere{rows}.obj", rows)
    for _ in range(options.repeat):
        for rows, shading in cases:
            answers[rows, shading] = render(options.program, folder / f"sphere{rows}.obj", folder / f"{rows}_{shading}.png", shading)
            times[rows, shading].append(answers[rows, shading]["render_ms"])
    return [(rows, shading, answers[rows, shading], min(times[rows, shading])) for rows, shading in cases]


def write_side_by_side(path, folder):
    parts = [read_rgb(folder / f"{SHOWN}_{shading}.png") for shading in FREQUENCIES]
    width, height, _ = parts[0]
    lines = [b"".join(pixels[y * width * 3:(y + 1) * width * 3] for _, _, pixels in parts) for y in range(height)]
    write_rgb(path, width * len(parts), height, b"".join(lines))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/rakelight", type=pathlib.Path)
    parser.add_argument("--repeat", default=7, type=int)
    parser.add_argument("--picture", type=pathlib.Path)
    options = parser.parse_args()
    options.program = options.program.resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        found = measure(options, folder)
        finest = read_rgb(folder / f"{ROWS[-1]}_phong.png")
        print("| triangles | shading | lighting evaluations | render [ms] | difference [1/255] |\n|---:|---|---:|---:|---:|")
        for rows, shading, row, ms in found:
            error = difference(read_rgb(folder / f"{rows}_{shading}.png"), finest)
            print(f"| {row['triangles']} | {shading} | {row['stats']['lighting_evaluations']} | {ms:.2f} | {error:.3f} |")
        if options.picture:
            write_side_by_side(options.picture, folder)


if __name__ == "__main__":
    main()
