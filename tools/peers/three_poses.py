#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reference positions of posed models: where three.js has vertices at rest and at times of up to three clips, one JSON file a model.

  three_poses.py --three NODE_MODULES/three [--most 600] [--all] ROOT OUT MODELS...

MODELS are .gltf and .glb files below ROOT; --all takes all clips and the world matrices of all nodes (for small cases). Each position is
compared with gltf_pose.py; a model whose asset.extras name a "deviation" of three.js gets the positions of that instead, "reference" says so.
three.js runs in headless Chromium, on the CPU (no pixel is drawn). Needs chromium, numpy, and three from npm."""
import argparse
import functools
import http.server
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import threading

import numpy

import gltf_pose

PAGE = b"""<!doctype html><script type="importmap">
{"imports":{"three":"/three/build/three.module.js","three/addons/":"/three/examples/jsm/"}}</script><script type="module" src="/three_poses.js"></script>"""
HERE = pathlib.Path(__file__).resolve().parent
# Of the model's size: single precision, and three.js' chord for the arc between rotations less than 3.6 degrees apart.
TOLERANCE = 1e-5

KNOWN = {"simple_skin.gltf": {"deviation": "three.js does not normalize quaternions: those of the file are of length 0.99985", "tolerance": 5e-4}}


class Server(http.server.SimpleHTTPRequestHandler):
    """Serves the page, three.js and the models on the loopback interface, and takes the results."""

    def __init__(self, *arguments, folders, jobs, results, done, **others):
        self.folders, self.jobs, self.results, self.done = folders, jobs, results, done
        super().__init__(*arguments, **others)

    def answer(self, kind, body):
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def do_GET(self):
        if self.path == "/page":
            return self.answer("text/html", PAGE)
        if self.path == "/jobs":
            return self.answer("application/json", json.dumps(self.jobs).encode())
        return super().do_GET()

    def do_POST(self):
        body = self.rfile.read(int(self.headers["Content-Length"]))
        if self.path == "/done":
            self.done.set()
        else:
            self.results[int(self.path.rpartition("/")[2])] = json.loads(body)
        self.answer("text/plain", b"")

    def translate_path(self, path):
        path = super().translate_path(path)[len(self.directory):].lstrip("/")
        base, _, rest = path.partition("/")
        return str(self.folders[base] / rest) if base in self.folders else str(HERE / "three_poses.js")

    def log_message(self, *arguments):
        pass


def results_of(options, models):
    """What the page gives for each model, in their order; None where it gave nothing."""
    root, results, done = options.root.resolve(), {}, threading.Event()
    jobs = [{"name": str(i), "url": f"/models/{model.resolve().relative_to(root)}", "most": options.most, "all": options.all}
            for i, model in enumerate(models)]
    handler = functools.partial(Server, folders={"three": options.three.resolve(), "models": root}, jobs=jobs, results=results, done=done)
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory() as profile:
        browser = subprocess.Popen(["chromium", "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                                    f"--user-data-dir={profile}", f"http://127.0.0.1:{server.server_port}/page"],
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        done.wait(120 + 10 * len(models))
        browser.terminate()
        browser.wait()
    server.shutdown()
    return [results.get(i) for i in range(len(models))]


def points_by_rule(model, pose, strongest=None):
    """The points of a pose of the page anew, by gltf_pose.py; and the normals where there are any."""
    here, points, normals, known = gltf_pose.Pose(model, pose["clip"], pose["time"]), [], [], {}
    for node, primitive, vertex, *_ in pose["points"]:
        if (node, primitive) not in known:
            known[node, primitive] = here.positions(node, primitive, strongest), here.normals(node, primitive)
        positions, turned = known[node, primitive]
        points.append([node, primitive, vertex, *positions[vertex].tolist()])
        if turned is not None:
            normals.append([node, primitive, vertex, *turned[vertex].tolist()])
    return points, normals, [[row[0], *here.world[row[0]].T.reshape(-1).tolist()] for row in pose["nodes"]]


def difference(ours, theirs, key):
    if not theirs:
        return 0.0
    a, b = (numpy.array([row[key:] for row in rows], float) for rows in (ours, theirs))  # null where a number is not finite
    return float(numpy.where(numpy.isfinite(a - b), abs(a - b), math.inf).max())


def rounded(rows, key, decimals):
    return [row[:key] + [round(value, decimals) + 0.0 for value in row[key:]] for row in rows]


def by_rule(model, poses):
    """The poses of the page anew, or None where the model's data is not to be unpacked."""
    try:
        return [dict(zip(("points", "normals", "nodes"), points_by_rule(model, pose))) for pose in poses]
    except gltf_pose.Unsupported:
        return None


def size_of(points):
    """The diagonal of the box of points."""
    corners = numpy.array([point[3:] for point in points], float)
    return float(numpy.linalg.norm(corners.max(axis=0) - corners.min(axis=0)))


def decimals_of(size):
    return max(0, math.ceil(6 - math.log10(size))) if size > 0 else 9


def finished(result, path, name, with_normals):
    """The JSON of a model from what the page gave, and how far three.js is from the specification, in sizes."""
    model = gltf_pose.Model(path)
    extras = model.json["asset"].get("extras")
    extras = KNOWN.get(path.name, extras if isinstance(extras, dict) else {})
    theirs, ours = result["poses"], by_rule(model, result["poses"])
    use_ours = "deviation" in extras
    size = size_of(ours[0]["points"]) if use_ours else result["size"]
    decimals = decimals_of(size)
    out = {"model": name, "three": result["three"], "size": float(f"{size:.7g}"), "reference": "numpy" if use_ours else "three",
           "three_differs": None, **{key: extras[key] for key in ("about", "deviation", "invalid", "tolerance") if key in extras}, "poses": []}
    if ours:
        worst = max(max(difference(a["points"], b["points"], 3) / size, difference(a["nodes"], b["nodes"], 1)) for a, b in zip(ours, theirs))
        out["three_differs"] = float(f"{worst:.2g}") if math.isfinite(worst) else "no position"
    for k, pose in enumerate(theirs):
        source = ours[k] if use_ours else pose
        out["poses"].append({**{key: pose[key] for key in ("clip", "name", "time")}, "points": rounded(source["points"], 3, decimals)})
        if source["nodes"]:
            out["poses"][-1]["nodes"] = rounded(source["nodes"], 1, 7)
        if with_normals and ours and ours[k]["normals"]:
            out["poses"][-1]["normals"] = rounded(ours[k]["normals"], 3, 6)
    return out


def strongest(count, out, path):
    """The same poses with the strongest joints of a vertex alone, scaled to 1; None where that changes nothing."""
    model, changed = gltf_pose.Model(path), 0.0
    decimals = decimals_of(out["size"])
    poses = []
    for pose in out["poses"]:
        points = points_by_rule(model, {**pose, "nodes": []}, count)[0]
        changed = max(changed, difference(points, pose["points"], 3) / out["size"])
        poses.append({**{key: pose[key] for key in ("clip", "name", "time")}, "points": rounded(points, 3, decimals)})
    return {**{key: out[key] for key in ("model", "three", "size")}, "reference": "numpy", "joints": count, "poses": poses} \
        if changed > TOLERANCE else None


def write(folder, name, out):
    (folder / name).write_text(json.dumps(out, separators=(",", ":"), allow_nan=False) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("models", type=pathlib.Path, nargs="+")
    parser.add_argument("--three", type=pathlib.Path, required=True)
    parser.add_argument("--most", type=int, default=600, help="points of a model in a pose (600)")
    parser.add_argument("--all", action="store_true", help="all clips, matrices of all nodes, normals")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    bad = 0
    for path, result in zip(options.models, results_of(options, options.models)):
        name = str(path.resolve().relative_to(options.root.resolve()))
        if result is None or "error" in result:
            print(f"{name}: {'no answer' if result is None else result['error']}")
            bad += 1
            continue
        out = finished(result, path, name, options.all)
        worst, file = out["three_differs"], name.replace("/", "__").rpartition(".")[0]
        worst = math.inf if isinstance(worst, str) else worst
        told = out["reference"] == "numpy"
        unexpected = worst is not None and (worst > TOLERANCE) != told
        bad += unexpected
        print(f"{name}: {len(out['poses'])} poses, {len(out['poses'][0]['points'])} points, "
              f"{'not compared' if worst is None else f'{worst:.1e} of its size apart'}{', deviation' * told}{' UNEXPECTED' * unexpected}")
        write(options.out, file + ".json", out)
        for count in (4, 8) if worst is not None else ():
            if fewer := strongest(count, out, path):
                write(options.out, f"{file}.strongest{count}.json", fewer)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
