#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders the golden scenes and compares them with the pictures that were looked at and committed.

  golden.py [SCENE...]            exit 1 when a picture differs; before | after | difference then lie in build/golden
  golden.py --update [SCENE...]   takes the new pictures over: look at them, and say in the commit why they changed

Scenes stand in tests/golden/scenes.json, one a line: the arguments of `rakelight render` without -o, the size of the picture,
the data channel whose picture is meant in place of the color ("channel", where there is one), and the tolerance, the largest difference of a channel in 1/255. It is 0 where no "reason" stands: the soft engine gives the
same bits everywhere. Only the standard library is needed."""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "pictures"))
from png8 import read_pixels, write_rgb  # noqa: E402


ROOT = pathlib.Path(__file__).resolve().parents[2]


def read_scenes(path):
    """The rows of the file, checked, so that a slip in it is not taken for a picture that agrees."""
    content = json.loads(path.read_text())
    if content.get("schema") != "rakelight.golden/1":
        sys.exit(f"golden: {path}: the schema is not rakelight.golden/1")
    rows = content["rows"]
    for row in rows:
        unknown = set(row) - {"name", "shows", "size", "tolerance", "reason", "arguments", "channel"}
        if unknown:
            sys.exit(f"golden: {row['name']}: unknown field {sorted(unknown)[0]}")
        if row["tolerance"] != 0 and not row.get("reason"):
            sys.exit(f"golden: {row['name']}: a tolerance needs a reason")
    names = [row["name"] for row in rows]
    if len(set(names)) != len(names):
        sys.exit("golden: a name stands twice")
    return rows


def render(program, row, picture):
    """Renders into `picture`; returns what went wrong, or None."""
    arguments = list(row["arguments"])
    channel = row.get("channel")
    if channel:
        arguments += ["--channels", channel, "--channel-files", "png"]
    if "--resolution" not in arguments:
        arguments += ["--resolution", "{},{}".format(*row["size"])]
    done = subprocess.run([program, "render", *arguments, "--look", "plain", "-o", picture, "--quiet"], cwd=ROOT, capture_output=True, text=True,
                          errors="replace", stdin=subprocess.DEVNULL)
    if done.returncode != 0:
        return f"exit code {done.returncode}: {(done.stderr.strip().splitlines() or ['no message'])[-1]}"
    if channel:
        picture.with_suffix(f".{channel}.png").replace(picture)
    size = list(read_pixels(picture)[:2])
    return None if size == row["size"] else f"the picture is {size}, scenes.json says {row['size']}"


def difference(before, after):
    """(largest difference of a channel, number of pixels that differ), or words where sizes or channels differ."""
    if before[:3] != after[:3]:
        return "was {}x{} with {} channels".format(*before[:3]) + ", is {}x{} with {} channels".format(*after[:3])
    channels, worst, pixels = before[2], 0, 0
    for at in range(0, len(before[3]), channels):
        a, b = before[3][at:at + channels], after[3][at:at + channels]
        if a != b:
            pixels += 1
            worst = max(worst, *(abs(x - y) for x, y in zip(a, b)))
    return worst, pixels


def shown(picture):
    """RGB rows; a picture with alpha lies on a checkerboard."""
    width, height, channels, pixels = picture
    rows = []
    for y in range(height):
        row = pixels[y * width * channels:(y + 1) * width * channels]
        if channels == 4:
            over = bytearray()
            for x in range(width):
                alpha, board = row[4 * x + 3], 150 if (x // 8 + y // 8) % 2 else 100
                over += bytes((c * alpha + board * (255 - alpha)) // 255 for c in row[4 * x:4 * x + 3])
            row = bytes(over)
        rows.append(row)
    return rows


def write_side_by_side(path, before, after):
    """before | after | eight times the difference, with a gap of 4 pixels; shorter pictures end in black."""
    parts = [(before[0], shown(before)), (after[0], shown(after))]
    if before[:2] == after[:2]:
        parts.append((before[0], [bytes(min(255, 8 * abs(a - b)) for a, b in zip(*rows)) for rows in zip(parts[0][1], parts[1][1])]))
    height, gap = max(len(rows) for _, rows in parts), bytes(12)
    lines = [gap.join(rows[y] if y < len(rows) else bytes(3 * width) for width, rows in parts) for y in range(height)]
    write_rgb(path, len(lines[0]) // 3, height, b"".join(lines))


def check(row, picture, reference, out):
    """One line about what differs, or None."""
    after = read_pixels(picture)
    if not reference.exists():
        return f"there is no {reference.name} yet; --update takes the picture over"
    before = read_pixels(reference)
    found = difference(before, after)
    if not isinstance(found, str) and found[0] <= row["tolerance"]:
        return None
    out.mkdir(parents=True, exist_ok=True)
    beside = out / f"{row['name']}.png"
    write_side_by_side(beside, before, after)
    words = found if isinstance(found, str) else f"{found[1]} pixels differ, by up to {found[0]} of 255"
    return f"{words}; before | after | difference: {beside}"


def run(options):
    rows = read_scenes(options.golden / "scenes.json")
    pictures = options.golden / "pictures"
    unknown = set(options.scenes) - {row["name"] for row in rows}
    if unknown:
        sys.exit(f"golden: no scene is called {sorted(unknown)[0]}; there are: " + ", ".join(row["name"] for row in rows))
    wrong = [] if options.scenes else sorted(f"{p.name}: no scene has this picture" for p in pictures.glob("*.png")
                                             if p.stem not in {row["name"] for row in rows})
    chosen = [row for row in rows if not options.scenes or row["name"] in options.scenes]
    with tempfile.TemporaryDirectory() as folder:
        for row in chosen:
            picture, reference = pathlib.Path(folder) / (row["name"] + ".png"), pictures / (row["name"] + ".png")
            failed = render(options.program, row, picture)
            differs = None if failed else check(row, picture, reference, options.out)
            if differs and options.update:
                pictures.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(picture, reference)
                print(f"golden: {row['name']}: taken over ({differs})")
            elif failed or differs:
                wrong.append(f"{row['name']}: {failed or differs}")
    for line in wrong:
        print(f"golden: {line}", file=sys.stderr)
    print(f"golden: {len(chosen)} scenes, {len(wrong)} wrong")
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE")
    parser.add_argument("--update", action="store_true", help="take the new pictures over")
    parser.add_argument("--program", default=ROOT / "build/release/rakelight", type=pathlib.Path)
    parser.add_argument("--golden", default=ROOT / "tests/golden", type=pathlib.Path, help="folder of scenes.json and pictures")
    parser.add_argument("--out", default=ROOT / "build/golden", type=pathlib.Path)
    options = parser.parse_args()
    options.program = options.program.resolve()
    sys.exit(run(options))


if __name__ == "__main__":
    main()
