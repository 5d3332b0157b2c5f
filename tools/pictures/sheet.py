# SPDX-License-Identifier: Apache-2.0
"""Sheets of rendered pictures, row by row, for the small tools beside. Only the standard library is needed."""
import pathlib
import subprocess
import tempfile

from labels import HEIGHT, strip, width_of
from png8 import read_rgb, write_indexed, write_rgb

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/release/rakelight"


def nearest(path, width, height):
    """A PNG file as rows of RGB bytes, width by height."""
    own_width, own_height, pixels = read_rgb(path)
    column = [3 * (x * own_width // width) for x in range(width)]
    return [b"".join(pixels[3 * own_width * (y * own_height // height) + c:][:3] for c in column) for y in range(height)]


def rendered(arguments, width, height, program, samples, folder):
    """What `render` makes of the arguments, model first, as rows of RGB bytes. Paths count from the repository's root."""
    out = pathlib.Path(folder) / "part.png"
    if "--samples" not in arguments:
        arguments = (*arguments, "--samples", str(samples))
    subprocess.run([pathlib.Path(program).resolve(), "render", *arguments, "-o", out, "--resolution", f"{width},{height}", "--quiet"],
                   check=True, cwd=ROOT)
    pixels = read_rgb(out)[2]
    return [pixels[3 * width * y:3 * width * (y + 1)] for y in range(height)]


def difference(part, base, times):
    """How far the colors of `part` lie from those of `base`, as rows of RGB bytes, so many times enlarged."""
    return [bytes(min(255, times * abs(a - b)) for a, b in zip(row, base_row)) for row, base_row in zip(part, base)]


def picture_of(part, width, height, program, samples, folder):
    """`part`: render's arguments, or the name of a PNG file, or (arguments, arguments, n): their difference n times."""
    if isinstance(part, str):
        return nearest(ROOT / part, width, height)
    if not isinstance(part[0], str):
        one, other = (rendered(p, width, height, program, samples, folder) for p in part[:2])
        return difference(one, other, part[2])
    return rendered(part, width, height, program, samples, folder)


def joined(parts):
    """Pictures as one row of pictures."""
    return [b"".join(rows) for rows in zip(*parts)]


def write_sheet(path, rows, width, height, program=PROGRAM, samples=8, columns=(), lines=(), below=(), colors=0):
    """rows: lists of equal length of parts as picture_of() takes them, each shown width by height.
    columns: words over each column; lines: words left of each row; below: rows of words under each picture. colors: of a palette
    where there are so few hues that it does not show; 0: all."""
    margin = max(map(width_of, lines)) + 6 if lines else 0
    with tempfile.TemporaryDirectory() as folder:
        shown = [[picture_of(part, width, height, program, samples, folder) for part in row] for row in rows]
    sheet = []
    if columns:
        sheet += joined([strip("", margin, HEIGHT + 4)] * bool(margin) + [strip(words, width, HEIGHT + 4) for words in columns])
    for i, parts in enumerate(shown):
        sheet += joined([strip(lines[i], margin, height), *parts] if lines else parts)
        if below:
            sheet += joined([strip(words, width, HEIGHT + 4) for words in below[i]])
    size = (margin + width * len(rows[0]), len(sheet))
    if colors:
        write_indexed(path, *size, b"".join(sheet), colors)
    else:
        write_rgb(path, *size, b"".join(sheet))
