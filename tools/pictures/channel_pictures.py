#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every channel of a picture beside it, for docs/channels.md.

  channel_pictures.py [--program build/release/rakelight] OUT.png

Those that the knight has none of are of data/materials/colors.gltf. Only the standard library is needed."""
import argparse
import pathlib
import subprocess
import tempfile

from sheet import PROGRAM, ROOT, write_sheet

WIDTH, HEIGHT = 200, 150
KNIGHT = ("data/knight/Knight_noNormals.glb", "--normals", "model", "--resolution", "250,250", "--window", f"25,38,{WIDTH},{HEIGHT}")
SQUARES = ("data/materials/colors.gltf", "--resolution", f"{WIDTH},{HEIGHT}")
CHANNELS = ("depth", "normal", "face-normal", "tangent", "uv", "position", "object", "mesh", "material", "triangle", "barycentric", "overdraw", "base-color",
            "ambient", "diffuse", "specular")
COLUMNS = 5


def pictures(program, folder, name, arguments, channels):
    """[(words, file)]: the picture and its channels."""
    out = pathlib.Path(folder) / f"{name}.png"
    subprocess.run([program.resolve(), "render", *arguments, "-o", out, "--channels", "all", "--channel-files", "png", "--quiet"], check=True, cwd=ROOT)
    return [("picture", str(out))] + [(channel, str(out.with_suffix(f".{channel}.png"))) for channel in channels]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        shown = pictures(options.program, folder, "knight", KNIGHT, CHANNELS) + pictures(options.program, folder, "squares", SQUARES, ("uv1", "emission"))
        rows = [shown[i:i + COLUMNS] for i in range(0, len(shown), COLUMNS)]
        write_sheet(options.picture, [[file for _, file in row] for row in rows], WIDTH, HEIGHT, below=[[words for words, _ in row] for row in rows])


if __name__ == "__main__":
    main()
