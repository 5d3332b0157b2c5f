#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A model with a normal map in three.js and Blender Cycles beside ours: the normals that the map makes, as colors, and a light.

  bake_peer.py --three NODE_MODULES/three [--no-cycles] [--program build/release/rakelight] [--size 512] MODEL.glb OUT.png

All look along -Z, so that the view's axes are the world's. three.js (MeshNormalMaterial and MeshLambertMaterial with the
map of the model's materials, tangents of the file) runs in headless Chromium. OUT.png: ours, theirs, and the difference 8 times: normals and
light by three.js, and normals by Cycles, which makes tangents itself (bake_peer_cycles.py). Said: the angle between the normals of the pixels
inside of the model, and the difference of the codes of light. Needs chromium, three from npm, Blender 3.4."""
import sys
import argparse
import base64
import functools
import http.server
import json
import math
import os
import pathlib
import subprocess
import tempfile
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "pictures"))
from png8 import read_rgb, write_rgb  # noqa: E402
from sheet import PROGRAM, difference, joined  # noqa: E402


PAGE = """<!doctype html><script type="importmap">
{"imports":{"three":"/three/build/three.module.js","three/addons/":"/three/examples/jsm/"}}</script><script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true });
renderer.setSize(SIZE, SIZE);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0x000000);
const { scene: model } = await new GLTFLoader().loadAsync('/model.glb');
scene.add(model);
const box = new THREE.Box3().setFromObject(model), middle = box.getCenter(new THREE.Vector3());
const size = box.getSize(new THREE.Vector3()), half = Math.max(size.x, size.y) * 0.525;
const camera = new THREE.PerspectiveCamera(30, 1, 0.01 * size.length(), 10 * size.length());
camera.position.set(middle.x, middle.y, box.max.z + half / Math.tan(Math.PI / 12));
const light = new THREE.DirectionalLight(0xffffff, Math.PI);  // radiance = cosine of white surfaces
light.position.set(1, 2, 3);
scene.add(light);
const pictures = { position: camera.position.toArray() };
for (const kind of ['normal', 'light']) {
  model.traverse(o => {
    if (!o.isMesh) return;
    const own = o.userData.own ??= o.material;
    const words = { normalMap: own.normalMap, normalScale: own.normalScale };
    o.material = kind === 'normal' ? new THREE.MeshNormalMaterial(words) : new THREE.MeshLambertMaterial(words);
  });
  renderer.render(scene, camera);
  pictures[kind] = renderer.domElement.toDataURL('image/png').split(',')[1];
}
await fetch('/done', { method: 'POST', body: JSON.stringify(pictures) });
</script>"""


class Server(http.server.SimpleHTTPRequestHandler):
    """Serves the page, three.js and the model on the loopback interface, and takes the pictures."""

    def __init__(self, *arguments, three, model, page, result, done, **others):
        self.three, self.model, self.page, self.result, self.done = three, model, page, result, done
        super().__init__(*arguments, **others)

    def do_GET(self):
        if self.path != "/page":
            return super().do_GET()
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(self.page.encode())

    def do_POST(self):
        self.result.update(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(200)
        self.end_headers()
        self.done.set()

    def translate_path(self, path):
        base, _, rest = path.lstrip("/").partition("/")
        return str(self.model if base == "model.glb" else self.three / rest if base == "three" else "/nowhere")

    def log_message(self, *arguments):
        pass


def three_pictures(options, folder):
    """What the page says of its camera; its pictures as {kind: file}."""
    result, done = {}, threading.Event()
    handler = functools.partial(Server, three=options.three.resolve(), model=options.model.resolve(), page=PAGE.replace("SIZE", str(options.size)),
                                result=result, done=done)
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    browser = subprocess.Popen(["chromium", "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                                f"--user-data-dir={folder}/profile", f"http://127.0.0.1:{server.server_port}/page"],
                               stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    came = done.wait(180)
    browser.terminate()
    browser.wait()
    server.shutdown()
    if not came:
        raise SystemExit("bake_peer.py: three.js gave no picture")
    files = {}
    for kind in ("normal", "light"):
        files[kind] = folder / f"three-{kind}.png"
        files[kind].write_bytes(base64.b64decode(result[kind]))
    return result, files


def our_pictures(options, camera, folder):
    position = camera["position"]
    words = [options.program.resolve(), "render", options.model, "-o", folder / "light.png", "--quiet", "--resolution", f"{options.size},{options.size}",
             "--camera-position", ",".join(map(repr, position)), "--camera-focal-point", f"{position[0]!r},{position[1]!r},{position[2] - 1!r}",
             "--camera-view-angle", "30", "--look", "plain", "--background", "0,0,0",
             "--color", "1,1,1", "--lighting", "lambert", "--light", "directional:-1,-2,-3", "--channels", "normal", "--channel-files", "png"]
    subprocess.run(list(map(str, words)), check=True)
    return {"light": folder / "light.png", "normal": folder / "light.normal.png"}


def cycles_picture(options, camera, folder):
    out = folder / "cycles.png"
    place = ",".join(map(repr, camera["position"]))
    plain = {**os.environ, "PATH": "/usr/bin:/bin"}  # Blender takes the modules of the first Python that it finds
    subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", pathlib.Path(__file__).with_name("bake_peer_cycles.py"), "--",
                    options.model.resolve(), out, str(options.size), place, "30"], check=True, capture_output=True, env=plain)
    return out


def rows(path):
    width, height, pixels = read_rgb(path)
    return [pixels[3 * width * y:3 * width * (y + 1)] for y in range(height)]


def inside(normals):
    """[(x, y)] whose neighbors are all of the model."""
    size = len(normals)
    is_model = [[normals[y][3 * x:3 * x + 3] not in (b"\0\0\0", b"\x80\x80\x80") for x in range(size)] for y in range(size)]
    return [(x, y) for y in range(1, size - 1) for x in range(1, size - 1)
            if all(is_model[y + j][x + i] for i in (-1, 0, 1) for j in (-1, 0, 1))]


def angle(a, b):
    a, b = ([c / 127.5 - 1 for c in v] for v in (a, b))
    cosine = sum(x * y for x, y in zip(a, b)) / math.sqrt(sum(x * x for x in a) * sum(x * x for x in b))
    return math.degrees(math.acos(max(-1.0, min(1.0, cosine))))


def say(name, values):
    values.sort()
    shares = ", ".join(f"{share} % below {values[min(len(values) - 1, len(values) * share // 100)]:.3g}" for share in (50, 95, 99))
    print(f"{name}: mean {sum(values) / len(values):.3g}, {shares}, most {values[-1]:.3g}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--three", type=pathlib.Path, required=True)
    parser.add_argument("--no-cycles", action="store_true")
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--size", type=int, default=512)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        camera, theirs = three_pictures(options, pathlib.Path(folder))
        ours = our_pictures(options, camera, pathlib.Path(folder))
        cycles = None if options.no_cycles else rows(cycles_picture(options, camera, pathlib.Path(folder)))
        theirs, ours = ({kind: rows(files[kind]) for kind in ("normal", "light")} for files in (theirs, ours))
    pairs = [("three.js", "normal", theirs["normal"]), ("three.js", "light", theirs["light"])]
    pairs += [("Cycles", "normal", cycles)] if cycles else []
    sheet = []
    for name, kind, pixels in pairs:
        both = set(inside(ours["normal"])) & set(inside(cycles if name == "Cycles" else theirs["normal"]))
        at = [(y, slice(3 * x, 3 * x + 3)) for x, y in sorted(both)]
        if kind == "normal":
            print(f"{name}: {len(at)} pixels inside of the model")
            say("degrees between normals", [angle(ours[kind][y][x], pixels[y][x]) for y, x in at])
        else:
            say("difference of light, of 255", [max(abs(a - b) for a, b in zip(ours[kind][y][x], pixels[y][x])) for y, x in at])
        sheet += joined([ours[kind], pixels, difference(ours[kind], pixels, 8)])
    write_rgb(options.picture, 3 * options.size, len(sheet), b"".join(sheet))


if __name__ == "__main__":
    main()
