#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The pictures of docs/bake.md: the scanned head, a decimated one, that with the maps that are baked for it, and what is left.

  bake_pictures.py OUT_FOLDER [--program build/release/rakelight] [--share 0.1] [--size 2048] [--keep FOLDER]

Writes bake-head.png and bake-maps.png, and says how far the pictures of the decimated head are from those of the full one. --keep: the
models, too."""
import sys
import argparse
import json
import pathlib
import shutil
import subprocess
import tempfile

from labels import HEIGHT, strip
from png8 import read_rgb, write_rgb
from sheet import PROGRAM, ROOT, difference, joined, nearest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "make"))
from border_mesh import read_obj, welded, write_obj  # noqa: E402
from quadric_decimation import decimated  # noqa: E402

HEAD = ROOT / "data/head"
VIEW = ("--view", "front", "--camera-zoom-factor", "1.1", "--color", "#c8b8a8", "--look", "plain", "--lighting", "lambert", "--background", "#303438",
        "--light", "directional:-0.6,-0.5,-1:color=0.9,0.9,0.9", "--light", "ambient:0.08,0.08,0.08", "--samples", "8")
WIDTH, HEIGHT_PX = 420, 440
MAPS = "normal", "height", "curvature", "occlusion"


def run(program, *words):
    return subprocess.run([program, *map(str, words)], check=True, capture_output=True, text=True)


def make_models(folder, share):
    """The head without its color map, and a decimated one."""
    for name in ("head.obj", "normal_from_bump.png"):
        shutil.copy(HEAD / name, folder)
    material = (HEAD / "head.mtl").read_text().splitlines()
    (folder / "head.mtl").write_text("".join(line + "\n" for line in material if not line.startswith("map_Kd")))
    whole = welded("head", [[m.positions[i] for i in t] for m in read_obj(folder / "head.obj") for t in m.triangles])
    low = decimated(whole, share)
    write_obj(folder / "low.obj", [(low, None)], "head.obj decimated by tools/pictures/bake_pictures.py of Rakelight")
    print(f"{len(whole.triangles)} triangles, and {len(low.triangles)}")


def rows(path):
    width, height, pixels = read_rgb(path)
    return [pixels[3 * width * y:3 * width * (y + 1)] for y in range(height)]


def distance(program, one, other):
    done = subprocess.run([program, "compare", one, other, "--json"], capture_output=True, text=True)
    row = json.loads(done.stdout)["rows"][0]
    return f"psnr {row['psnr_db']:.1f} db, flip {row['flip']:.3f}"


def labelled(words, width):
    return joined([strip(text, width, HEIGHT + 4) for text in words])


def draw(program, folder, out):
    pictures = {"full": ("head.obj",), "low": ("low.obj", "--normals", "model", "--crease-angle", "180"), "baked": ("baked.glb",)}
    for name, words in pictures.items():
        run(program, "render", folder / words[0], *words[1:], *VIEW, "--resolution", f"{WIDTH},{HEIGHT_PX}", "-o", folder / f"{name}.png")
    full = rows(folder / "full.png")
    shown, labels = [full], ["full"]
    for name in ("low", "baked"):
        shown.append(rows(folder / f"{name}.png"))
        labels.append(f"{name}: {distance(program, folder / 'full.png', folder / f'{name}.png')}")
        print(labels[-1])
    room = strip("", WIDTH, (HEIGHT_PX - WIDTH) // 2)
    below = [room + nearest(folder / "normal.png", WIDTH, WIDTH) + room, difference(shown[1], full, 2), difference(shown[2], full, 2)]
    sheet = joined(shown) + labelled(labels, WIDTH) + joined(below) + labelled(["map of normals", "low - full, 2 times", "baked - full, 2 times"], WIDTH)
    write_rgb(out / "bake-head.png", WIDTH * len(shown), len(sheet), b"".join(sheet))


def draw_maps(program, folder, out, side=360):
    for name in MAPS[1:]:  # three channels of 8 bits
        run(program, "render", "builtin:plane", "--look", "plain", "--material", "color=1,1,1", "--texture-base-color", folder / f"{name}.png", "--shading", "unlit",
            "--view", "top", "--camera-zoom-factor", "1", "--resolution", f"{side},{side}", "-o", folder / f"{name}-shown.png")
    shown = [nearest(folder / "normal.png", side, side)] + [rows(folder / f"{name}-shown.png") for name in MAPS[1:]]
    sheet = joined(shown) + labelled(MAPS, side)
    write_rgb(out / "bake-maps.png", side * len(MAPS), len(sheet), b"".join(sheet))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--share", type=float, default=0.1)
    parser.add_argument("--size", type=int, default=2048)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    program = options.program.resolve()
    with tempfile.TemporaryDirectory() as temporary:
        folder = (options.keep or pathlib.Path(temporary)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        options.out.mkdir(parents=True, exist_ok=True)
        make_models(folder, options.share)
        said = run(program, "bake", folder / "head.obj", folder / "low.obj", "-o", folder / "{map}.png", "--maps", ",".join(MAPS), "--bits", "8",
                   "--size", options.size, "--model", folder / "baked.glb")
        print(said.stderr.strip().replace(str(folder) + "/", ""))
        draw(program, folder, options.out)
        draw_maps(program, folder, options.out)


if __name__ == "__main__":
    main()
