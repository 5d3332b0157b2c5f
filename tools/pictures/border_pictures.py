#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Real models cut into parts that were meshed anew one by one, in raking light, before and after --border-distance.

  border_pictures.py [--program build/release/rakelight] [--border-distance D] [--only NAME] [--size PX] [--band PX] OUT_FOLDER

D is in mean edge lengths of the uncut model; without it the pictures of `after` are left out. Writes NAME.png for each scene (and
NAME-pair.png: before, after), and prints how far the pictures are from what they should be, in codes of 8 bits:
  band     mean absolute difference from the reference over the pixels within --band pixels of a border (default 6)
  step     mean absolute difference of pixels that face each other across a border; that of the reference is the surface's own
  rest     as band, over all other pixels of the model: what the change did away from the borders
The reference has the triangles of the parts, so that nothing but normals differs, and along the cuts the normals of the uncut model
(make_border_models.py). The uncut model itself has other triangles: its picture is shown, and its step is that of a surface without a cut.
Borders are where the channel `object` changes and the channel `position` does not jump. Only the standard library is needed."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

from labels import HEIGHT, strip
from png8 import read_rgb, write_rgb
from sheet import PROGRAM, ROOT, difference, joined, rendered

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "make"))
import make_border_models  # noqa: E402
from border_mesh import mean_edge, read_obj  # noqa: E402

ACROSS = 4   # [px] at most between pixels that face each other: gaps are seen through
JUMP = 10    # codes of the channel `position` (255: the model's box) that are another place
TIMES = 6    # differences are shown so many times enlarged
AMBIENT = ("--light", "ambient:0.06,0.06,0.06")
SCENES = {
    "head": ("data/head/head.obj", ("--plane", "1,0.2,0:0.6", "--plane", "0.2,1,0:0.8", "--decimate", "0.25:0,3"),
             ("--camera-position", "0.1,0.34,0.8", "--camera-focal-point", "0.005,0.33,0", "--camera-view-angle", "20",
              "--light", "directional:-1,-0.3,-0.35", *AMBIENT)),
    "spot": ("data/spot/spot_slab5.glb", ("--plane", "0,0.3,1:0.3", "--plane", "0,0.3,1:0.55", "--decimate", "0.2:even", "--subdivide", "2:1"),
             ("--camera-direction", "-1,-0.3,0.3", "--light", "directional:-0.3,-0.4,1", *AMBIENT, "--camera-zoom-factor", "1.4")),
    "spot gap": ("data/spot/spot_slab5.glb", ("--plane", "0,0.3,1:0.3", "--plane", "0,0.3,1:0.55", "--decimate", "0.25:1", "--gap", "0.06"),
                 ("--camera-direction", "-1,-0.3,0.3", "--light", "directional:-0.3,-0.4,1", *AMBIENT, "--camera-zoom-factor", "1.4")),
    "teapot": ("builtin:teapot:tolerance=0.002", ("--plane", "1,0.3,0:0.42", "--plane", "0.2,1,0.2:0.5", "--decimate", "0.05:0,3"),
               ("--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "30",
                "--light", "directional:0.6,-0.5,-0.7", *AMBIENT, "--metallic", "0", "--roughness", "0.3")),
}
LOOK = ("--look", "plain", "--color", "#c8b8a8", "--crease-angle", "180", "--background", "#404448")


def facing_pairs(width, height, objects, positions):
    """Pairs of pixels that face each other across a border, as (index, index): each one from it, where nothing of the gap is mixed in."""
    codes = [objects[i:i + 3] for i in range(0, len(objects), 3)]
    nothing = b"\0\0\0"

    def is_place(i, j):
        return all(abs(a - b) <= JUMP for a, b in zip(positions[3 * i:3 * i + 3], positions[3 * j:3 * j + 3]))

    pairs = []
    for i, code in enumerate(codes):
        if code != nothing:
            y, x = divmod(i, width)
            for step, room in ((1, width - 1 - x), (width, height - 1 - y)):
                ahead = [i + k * step for k in range(1, min(ACROSS, room) + 1)]
                found = next((j for j in ahead if codes[j] != nothing and is_place(i, j)), i)  # the next pixel of a surface that goes on
                before, after = i - step, found + step
                if codes[found] != code and 0 <= before and after < len(codes) and (codes[before], codes[after]) == (code, codes[found]):
                    pairs.append((before, after))
    return pairs


def band_of(width, height, pairs, reach):
    """Flags of the pixels at most `reach` from one of a pair, in rows and columns."""
    flags = bytearray(width * height)
    for i in {i for pair in pairs for i in pair}:
        y, x = divmod(i, width)
        left, right = max(0, x - reach), min(width, x + reach + 1)
        for row in range(max(0, y - reach), min(height, y + reach + 1)):
            flags[row * width + left:row * width + right] = b"\1" * (right - left)
    return flags


def mean(numbers):
    return sum(numbers) / len(numbers) if numbers else 0.0


def measures(rows, reference, band, model, pairs):
    """(band, step, rest) of a picture, each a mean over pixels and the three colors."""
    a, b = b"".join(rows), b"".join(reference)
    far = [sum(abs(a[3 * i + c] - b[3 * i + c]) for c in range(3)) / 3 if model[i] else 0 for i in range(len(model))]
    step = [sum(abs(a[3 * i + c] - a[3 * j + c]) for c in range(3)) / 3 for i, j in pairs]
    return (mean([f for f, m, near in zip(far, model, band) if m and near]), mean(step),
            mean([f for f, m, near in zip(far, model, band) if m and not near]))


def channel_pictures(model, view, size, program, folder):
    """The channels `object` and `position` of a view, as RGB bytes."""
    out = pathlib.Path(folder) / "channels.png"
    subprocess.run([program.resolve(), "render", model, "-o", out, *view, "--resolution", f"{size},{size}", "--samples", "1", "--quiet",
                    "--channels", "object,position", "--channel-files", "png"], check=True, cwd=ROOT)
    return [read_rgb(out.with_suffix(f".{kind}.png"))[2] for kind in ("object", "position")]


def made_models(model, how, program, folder):
    """{kind: path} by make_border_models.py, and the mean edge of the uncut model."""
    subprocess.run([sys.executable, make_border_models.__file__, model, folder, *how, "--program", program.resolve()],
                   check=True, stdout=subprocess.DEVNULL, cwd=ROOT)
    paths = {kind: str(next(pathlib.Path(folder).glob(f"*-{kind}.obj"))) for kind in ("uncut", "parts", "reference")}
    uncut = read_obj(paths["uncut"])[0]
    return paths, mean_edge(uncut.positions, uncut.triangles)


def show(name, options, folder):
    model, how, view = SCENES[name]
    size, program = options.size, options.program
    paths, edge = made_models(model, how, program, folder)
    view = (*view, *LOOK)
    ways = {"uncut": (paths["uncut"], "--normals", "model"), "before": (paths["parts"], "--normals", "model"),
            "after": (paths["parts"], "--normals", "model", "--border-distance", f"{(options.border_distance or 0) * edge:.8g}"),
            "reference": (paths["reference"], "--normals", "file")}
    if options.border_distance is None:
        del ways["after"]
    pictures = {way: rendered((*arguments, *view), size, size, program, 8, folder) for way, arguments in ways.items()}
    objects, positions = channel_pictures(paths["parts"], view, size, program, folder)
    pairs = facing_pairs(size, size, objects, positions)
    band = band_of(size, size, pairs, options.band)
    covered = [any(objects[3 * i:3 * i + 3]) for i in range(size * size)]
    for way, rows in pictures.items():
        print("%-12s %-10s band %6.3f   step %6.3f   rest %6.3f" % (name, way, *measures(rows, pictures["reference"], band, covered, pairs)))
    shown = {"parts": [objects[3 * size * y:3 * size * (y + 1)] for y in range(size)], **pictures}
    for way in ("before", "after"):
        if way in pictures:
            shown[f"{way} - reference, x {TIMES}".replace("x", "*")] = difference(pictures[way], pictures["reference"], TIMES)
    if "after" in pictures:
        pair = joined([pictures["before"], pictures["after"]])
        write_rgb(options.folder / f"{name.replace(' ', '-')}-pair.png", 2 * size, len(pair), b"".join(pair))
    sheet = joined([strip(words, size, HEIGHT + 4) for words in shown]) + joined(list(shown.values()))
    write_rgb(options.folder / f"{name.replace(' ', '-')}.png", size * len(shown), len(sheet), b"".join(sheet))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--border-distance", type=float, metavar="D")
    parser.add_argument("--only", choices=SCENES)
    parser.add_argument("--size", type=int, default=480, metavar="PX")
    parser.add_argument("--band", type=int, default=6, metavar="PX")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    for name in SCENES:
        if options.only in (None, name):
            with tempfile.TemporaryDirectory() as folder:
                show(name, options, folder)


if __name__ == "__main__":
    main()
