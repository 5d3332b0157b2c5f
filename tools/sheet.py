# SPDX-License-Identifier: Apache-2.0
"""Sheets of rendered pictures, row by row, for the small tools beside. Only the standard library is needed."""
import pathlib
import subprocess
import tempfile

from png8 import read_rgb, write_rgb

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/release/rakelight"


def nearest(path, width, height):
    """A PNG file as rows of RGB bytes, width by height."""
    own_width, own_height, pixels = read_rgb(path)
    column = [3 * (x * own_width // width) for x in range(width)]
    return [b"".join(pixels[3 * own_width * (y * own_height // height) + c:][:3] for c in column) for y in range(height)]


def rendered(arguments, width, height, program, samples, folder):
    """What `render` makes of the arguments, model first, as rows of RGB bytes. Paths count from the repository's root."""
    out = pathlib.Path(folder) / "part.png"
    subprocess.run([pathlib.Path(program).resolve(), "render", *arguments, "-o", out, "--resolution", f"{width},{height}",
                    "--samples", str(samples), "--quiet"], check=True, cwd=ROOT)
    pixels = read_rgb(out)[2]
    return [pixels[3 * width * y:3 * width * (y + 1)] for y in range(height)]


def write_sheet(path, rows, width, height, program=PROGRAM, samples=8):
    """rows: lists of equal length of render's arguments, or names of PNG files; each is shown width by height."""
    sheet = b""
    with tempfile.TemporaryDirectory() as folder:
        for row in rows:
            parts = [nearest(ROOT / part, width, height) if isinstance(part, str) else
                     rendered(part, width, height, program, samples, folder) for part in row]
            sheet += b"".join(part[y] for y in range(height) for part in parts)
    write_rgb(path, width * len(rows[0]), height * len(rows), sheet)
