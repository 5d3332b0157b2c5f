#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The first pictures of models beside those of other viewers, on one sheet: look plain, the default look, F3D, three.js.

  peer_pictures.py --three NODE_MODULES/three [--program build/release/rakelight] MODELS OUT.png

MODELS is the folder of the model set. F3D runs under Xvfb with antialiasing, its HDRI light left out (version 1 asks for a file); three.js
in headless Chromium with its room environment and neutral tone curve, as its usual glTF viewers have it. Needs f3d, xvfb-run, chromium."""
import sys
import argparse
import functools
import http.server
import pathlib
import subprocess
import tempfile
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "pictures"))
from labels import HEIGHT, strip  # noqa: E402
from look_sheet import words_for  # noqa: E402
from png8 import read_rgb, write_rgb  # noqa: E402
from sheet import PROGRAM, joined  # noqa: E402


LIST = """FlightHelmet.gltf GlamVelvetSofa.glb MetalRoughSpheresNoTextures.glb 10_custom_normals.gltf Suzanne.gltf BabylonShaderBall_Simple.gltf
BoomBoxWithAxes.gltf Knight.glb frostAxe_noMorph.glb cakeBirthday.glb right.glb NormalTangentTest.glb""".split()
SIZE = 256, 192
PAGE = """<!doctype html><style>body{margin:0;background:#191919}</style><script type="importmap">
{"imports":{"three":"/three/build/three.module.js","three/addons/":"/three/examples/jsm/"}}</script><script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
renderer.setSize(WIDTH, HEIGHT);
renderer.toneMapping = THREE.NeutralToneMapping;
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0x191919);
scene.environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
const { scene: model } = await new GLTFLoader().loadAsync('/models/NAME');
scene.add(model);
const box = new THREE.Box3().setFromObject(model), size = box.getSize(new THREE.Vector3()).length(), middle = box.getCenter(new THREE.Vector3());
const camera = new THREE.PerspectiveCamera(30, WIDTH / HEIGHT, size / 100, size * 100);
camera.position.copy(middle).add(new THREE.Vector3(0.45, 0.35, 1).normalize().multiplyScalar(size / 2 / Math.sin(Math.PI / 12) * 0.85));
camera.lookAt(middle);
renderer.render(scene, camera);
document.title = 'done';
</script>"""


class Server(http.server.SimpleHTTPRequestHandler):
    """Serves the page, three.js and the models on the loopback interface."""
    text, size = PAGE, SIZE

    def __init__(self, *arguments, three, models, **others):
        self.three, self.models = three, models
        super().__init__(*arguments, **others)

    def do_GET(self):
        if not self.path.startswith("/page/"):
            return super().do_GET()
        body = self.text.replace("NAME", self.path[len("/page/"):]).replace("WIDTH", str(self.size[0])).replace("HEIGHT", str(self.size[1])).encode()
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(body)

    def translate_path(self, path):
        base, _, rest = path.lstrip("/").partition("/")
        return str({"three": self.three, "models": self.models}.get(base, pathlib.Path("/nowhere")) / rest)

    def log_message(self, *arguments):
        pass


def rows_of(path):
    """The middle of a picture, as rows of RGB bytes of SIZE; blank where there is no picture."""
    width, height = SIZE
    if not path.is_file():
        return [bytes(3 * width)] * height
    own_width, own_height, pixels = read_rgb(path)
    left, top = max(0, (own_width - width) // 2), 0 if own_height < height + 120 else 0
    rows = [pixels[3 * (own_width * y + left):3 * (own_width * y + left + width)] for y in range(top, min(own_height, top + height))]
    return rows + [bytes(3 * width)] * (height - len(rows))


def run(command):
    subprocess.run(command, capture_output=True, timeout=180, stdin=subprocess.DEVNULL, check=False)


def screenshot(url, size, path):
    """Of a page in headless Chromium."""
    run(["chromium", "--headless=new", "--no-sandbox", "--hide-scrollbars", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--virtual-time-budget=30000", f"--window-size={size[0]},{size[1] + 150}", f"--screenshot={path}", url])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--three", type=pathlib.Path, required=True)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    models = options.models.resolve()
    handler = functools.partial(Server, three=options.three.resolve(), models=models)
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    sheet = joined([strip(words, SIZE[0], HEIGHT + 4) for words in ("plain", "default", "f3d", "three.js")])
    size = ",".join(map(str, SIZE))
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for name in LIST:
            model = next(iter(sorted(models.rglob(name))))
            out = {part: folder / f"{name}.{part}.png" for part in ("plain", "default", "f3d", "three")}
            for look in ("plain", "default"):
                run([options.program.resolve(), "render", model, "-o", out[look], "--resolution", size, "--look", look, "--quiet"])
            run(["xvfb-run", "-a", "f3d", model, "--output", out["f3d"], "--resolution", size, "--fxaa"])
            url = f"http://127.0.0.1:{server.server_port}/page/{model.relative_to(models)}"
            screenshot(url, SIZE, out["three"])
            sheet += joined([rows_of(path) for path in out.values()])
            sheet += [b"".join(row) for row in zip(strip(words_for(name, SIZE[0]), SIZE[0] * 4, HEIGHT + 4))]
    write_rgb(options.picture, SIZE[0] * 4, len(sheet), b"".join(sheet))


if __name__ == "__main__":
    main()
