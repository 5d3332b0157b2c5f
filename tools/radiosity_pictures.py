#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures of radiosity for docs/radiosity.md: the Cornell box by five ways; by numbers of elements, with their edges; a table with
things on it; and how far the Cornell box is from its picture by paths.

  radiosity_pictures.py [--program build/release/rakelight] cornell|elements|table OUT.png
  radiosity_pictures.py [--program build/release/rakelight] compare [ELEMENTS...]

Only the standard library is needed."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

from sheet import PROGRAM, ROOT, write_sheet

sys.path.insert(0, str(ROOT / "tests/cli"))
import exr  # noqa: E402

CORNELL = "data/paths/cornell.scene.toml"
TABLE = "data/world/room.scene.toml"
RADIOSITY = ("--method", "radiosity", "--look", "plain")
LAMP = ("--light", "point:0.278,0.5,0.28:color=1,0.53,0.13:attenuation=1,0,8")
SIZE = 256
# Pieces of walls in a picture of 256 x 256: left, top, right, bottom.
WALLS = {"ceiling": (67, 47, 100, 73), "back wall": (87, 73, 167, 120), "floor": (40, 220, 213, 247), "left wall": (7, 80, 40, 173), "right wall": (217, 80, 250, 173),
         "short block, top": (143, 164, 173, 170), "tall block, front": (73, 113, 117, 213)}


def ways(program):
    """What the other methods can show of a lamp that is a surface: a point light in its place."""
    parts = [(CORNELL, "--engine", "soft", "--look", "plain", "--shadows", *LAMP)]
    names = ["soft, a point light"]
    if "gl" in subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.split("engines:")[-1].partition("\n")[0]:
        parts.append((CORNELL, "--engine", "gl", "--look", "plain", "--shadows", *LAMP))
        names.append("gl, a point light")
    parts += [(CORNELL, "--engine", "trace", "--method", "whitted", *LAMP), (CORNELL, "--engine", "trace", "--method", "path", "--samples", "1024"),
              (CORNELL, "--engine", "soft", *RADIOSITY)]
    return parts, [*names, "trace, Whitted, a point light", "trace, paths", "soft, radiosity"]


def linear(arguments, program, folder):
    """The linear colors of the Cornell box."""
    path = pathlib.Path(folder) / "picture.exr"
    subprocess.run([program, "render", CORNELL, *arguments, "-o", path, "--resolution", f"{SIZE},{SIZE}", "--quiet"], check=True, cwd=ROOT)
    return exr.read(path)[2]


def compare(program, counts):
    """Mean relative difference of each piece of wall from 4096 paths a pixel, mean over red, green and blue."""
    with tempfile.TemporaryDirectory() as folder:
        paths = linear(("--engine", "trace", "--method", "path", "--samples", "4096"), program, folder)
        for count in counts:
            lit = linear((*RADIOSITY, "--engine", "soft", "--samples", "8", "--radiosity-elements", str(count)), program, folder)
            print(f"{count} elements")
            for name, (left, top, right, bottom) in WALLS.items():
                means, pixels = [], []
                for channel in "RGB":
                    a, b = ([row[left:right] for row in picture[channel][1][top:bottom]] for picture in (lit, paths))
                    means.append(sum(map(sum, a)) / sum(map(sum, b)) - 1)
                    pixels.append(sum(abs(x - y) for one, other in zip(a, b) for x, y in zip(one, other)) / sum(map(sum, b)))
                print(f"  {name:18} mean {100 * sum(means) / 3:+5.2f} %   pixels {100 * sum(pixels) / 3:5.2f} %")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("which", choices=("cornell", "elements", "table", "compare"))
    parser.add_argument("words", nargs="*", help="the picture; of compare numbers of elements")
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    program = options.program.resolve()
    if options.which == "compare":
        compare(program, options.words or [2000, 20000])
    elif options.which == "cornell":
        parts, names = ways(program)
        write_sheet(options.words[0], [parts], 240, 240, program, columns=names)
    elif options.which == "elements":
        counts = ("500", "5000", "50000")
        rows = [[(CORNELL, *RADIOSITY, "--radiosity-elements", n, *more) for n in counts] for more in ((), ("--edges", "--line-color", "#000000", "--samples", "1"))]
        write_sheet(options.words[0], rows, 320, 320, program, columns=[f"{n} elements" for n in counts])
    else:
        write_sheet(options.words[0], [[(TABLE, "--engine", "soft", "--look", "plain", "--shadows"),
                                        (TABLE, *RADIOSITY, "--radiosity-elements", "100000"),
                                        (TABLE, "--engine", "trace", "--method", "path", "--samples", "256")]],
                    400, 300, program, columns=("soft", "radiosity, 100000 elements", "paths"))


if __name__ == "__main__":
    main()
