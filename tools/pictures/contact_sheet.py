#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""All models of a folder in one picture, each with its name, to look at once.

  contact_sheet.py [--program build/release/rakelight] [--columns N] [--size W,H] FOLDER OUT.png [OPTION OF render ...]

Models that are not drawn have a red tile, and a line on standard error with what the program said. Exit code 1 if there
are any. Only the standard library is needed."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

from labels import GLYPHS, width_of
from png8 import write_rgb
from sheet import PROGRAM, write_sheet

SUFFIXES = {".glb", ".gltf", ".obj", ".fbx", ".dae", ".3ds", ".ase", ".blend", ".stl", ".ply", ".off", ".x"}


def words_for(name, width):
    """The name in the letters that there are, as much of its end as there is room for."""
    words = "".join(c if c in GLYPHS else "-" for c in name.lower())
    while width_of(words) > width:
        words = words[1:]
    return words


def draw(model, out, options, width, height):
    """None, or why there is no picture."""
    command = [options.program, "render", model, "-o", out, "--resolution", f"{width},{height}", "--quiet", *options.render]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=120, stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return "more than 120 s"
    return None if done.returncode == 0 else f"exit code {done.returncode}: {(done.stderr.strip().splitlines() or ['no message'])[-1]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--columns", type=int, default=8)
    parser.add_argument("--size", default="160,120")
    options, options.render = parser.parse_known_args()
    width, height = (int(n) for n in options.size.split(","))
    models = sorted(m for m in options.folder.rglob("*") if m.suffix.lower() in SUFFIXES and m.is_file())
    if not models:
        sys.exit(f"contact_sheet: no model in {options.folder}")
    missing = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_rgb(folder / "fault.png", 1, 1, bytes((150, 30, 30)))
        write_rgb(folder / "none.png", 1, 1, bytes((40, 40, 44)))
        shown = []
        for i, model in enumerate(models):
            out = folder / f"{i}.png"
            fault = draw(model, out, options, width, height)
            if fault:
                missing += 1
                print(f"{model}: {fault}", file=sys.stderr)
            shown.append((words_for(model.name, width - 6), str(folder / "fault.png" if fault else out)))
        shown += [("", str(folder / "none.png"))] * (-len(shown) % options.columns)
        rows = [shown[i:i + options.columns] for i in range(0, len(shown), options.columns)]
        write_sheet(options.picture, [[file for _, file in row] for row in rows], width, height, below=[[words for words, _ in row] for row in rows])
    print(f"{len(models)} models, {missing} not drawn")
    sys.exit(missing > 0)


if __name__ == "__main__":
    main()
