#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures of radiosity for docs/radiosity.md: the Cornell box by five ways; by numbers of elements, with their edges; a table with
things on it; and how far the Cornell box is from its picture by paths.

  radiosity_pictures.py [--program build/release/rakelight] cornell|elements|table OUT.png
  radiosity_pictures.py [--program build/release/rakelight] compare [ELEMENTS...]
  radiosity_pictures.py [--program build/release/rakelight] --three NODE_MODULES/three three OUT.png

Only the standard library is needed; three: Chromium, and three.js from npm."""
import argparse
import functools
import http.server
import pathlib
import subprocess
import sys
import tempfile
import threading

from labels import HEIGHT, strip
from png8 import read_rgb, write_rgb
from sheet import PROGRAM, ROOT, difference, joined, write_sheet

sys.path.insert(0, str(ROOT / "tests/cli/support"))
import exr  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "peers"))
import peer_pictures  # noqa: E402

CORNELL = "data/paths/cornell.scene.toml"
TABLE = "data/world/room.scene.toml"
RADIOSITY = ("--engine", "soft", "--method", "radiosity", "--look", "plain")
LAMP = ("--light", "point:0.278,0.5,0.28:color=1,0.53,0.13:attenuation=1,0,8")
SIZE = 256
# Pieces of walls in a picture of 256 x 256: left, top, right, bottom.
WALLS = {"ceiling": (67, 47, 100, 73), "back wall": (87, 73, 167, 120), "floor": (40, 220, 213, 247), "left wall": (7, 80, 40, 173), "right wall": (217, 80, 250, 173),
         "short block, top": (143, 164, 173, 170), "tall block, front": (73, 113, 117, 213)}


# A file with a camera, as it is: no light, no tone curve.
PAGE = """<!doctype html><style>body{margin:0;background:#000}</style><script type="importmap">
{"imports":{"three":"/three/build/three.module.js","three/addons/":"/three/examples/jsm/"}}</script><script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
renderer.setSize(WIDTH, HEIGHT);
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0);
const { scene: model, cameras } = await new GLTFLoader().loadAsync('/models/NAME');
scene.add(model);
scene.updateMatrixWorld(true);
const camera = cameras[0];
camera.aspect = WIDTH / HEIGHT;
camera.updateProjectionMatrix();
renderer.render(scene, camera);
</script>"""


class Server(peer_pictures.Server):
    text, size = PAGE, (SIZE, SIZE)


def rows_of(path):
    width, _, pixels = read_rgb(path)
    return [pixels[3 * width * y:3 * width * y + 3 * SIZE] for y in range(SIZE)]


def by_both(folder, server, program, *words):
    """The lit Cornell box as engine soft and as three.js show it, and their difference, side by side."""
    subprocess.run([program, "radiosity", CORNELL, "-o", folder / "lit.glb", "--quiet", *words], check=True, cwd=ROOT)
    subprocess.run([program, "render", folder / "lit.glb", "-o", folder / "own.png", "--resolution", f"{SIZE},{SIZE}", "--look", "plain",
                    "--background", "black", "--samples", "8", "--quiet"], check=True)
    peer_pictures.screenshot(f"http://127.0.0.1:{server.server_port}/page/lit.glb", (SIZE, SIZE), folder / "three.png")
    own, other = rows_of(folder / "own.png"), rows_of(folder / "three.png")
    off = [abs(a - b) for one, two in zip(own, other) for a, b in zip(one, two)]
    print(f"{' '.join(words) or 'colors of vertices'}: mean difference {sum(off) / len(off):.3f} of 255; {100 * sum(d > 2 for d in off) / len(off):.2f} % of the numbers "
          "differ by more than 2")
    return joined([own, other, difference(own, other, 10)])


def beside_three(picture, three, program):
    """The lit Cornell box as colors of vertices and as a lightmap."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Server, three=three.resolve(), models=folder))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        rows = joined([strip(words, SIZE, HEIGHT + 4) for words in ("soft", "three.js", "difference x 10")])
        rows += by_both(folder, server, program)
        rows += joined([strip(words, SIZE, HEIGHT + 4) for words in ("lightmap, soft", "three.js", "difference x 10")])
        rows += by_both(folder, server, program, "--lightmap", "1024")
    write_rgb(picture, 3 * SIZE, len(rows), b"".join(rows))


def ways(program):
    """What the other methods can show of a lamp that is a surface: a point light in its place."""
    parts = [(CORNELL, "--engine", "soft", "--look", "plain", "--shadows", *LAMP)]
    names = ["soft, point light"]
    if "gl" in subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.split("engines:")[-1].partition("\n")[0]:
        parts.append((CORNELL, "--engine", "gl", "--look", "plain", "--shadows", "--samples", "4", *LAMP))
        names.append("gl, point light")
    parts += [(CORNELL, "--engine", "trace", "--method", "whitted", *LAMP), (CORNELL, "--engine", "trace", "--method", "path", "--samples", "1024"),
              (CORNELL, *RADIOSITY)]
    return parts, [*names, "trace, point light", "trace, paths", "soft, radiosity"]


def linear(arguments, program, folder):
    """The linear colors of the Cornell box."""
    path = pathlib.Path(folder) / "picture.exr"
    subprocess.run([program, "render", CORNELL, *arguments, "-o", path, "--resolution", f"{SIZE},{SIZE}", "--quiet"], check=True, cwd=ROOT)
    return exr.read(path)[2]


def compare(program, counts):
    """Mean relative difference of each piece of wall from 1024 paths a pixel, mean over red, green and blue."""
    with tempfile.TemporaryDirectory() as folder:
        paths = linear(("--engine", "trace", "--method", "path", "--samples", "1024"), program, folder)
        for count in counts:
            lit = linear((*RADIOSITY, "--samples", "8", "--radiosity-elements", str(count)), program, folder)
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
    parser.add_argument("which", choices=("cornell", "elements", "table", "three", "compare"))
    parser.add_argument("--three", type=pathlib.Path, help="the package three of npm")
    parser.add_argument("words", nargs="*", help="the picture; of compare numbers of elements")
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    program = options.program.resolve()
    if options.which == "compare":
        compare(program, options.words or [2000, 20000])
    elif options.which == "three":
        beside_three(options.words[0], options.three, program)
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
