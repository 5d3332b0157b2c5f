#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A data set of one model: views from all sides with depth, normals and ids, and the cameras in cameras.json.

    python3 dataset.py helmet.glb out --views 1000 --size 256
"""
import argparse
import json
import pathlib
import time

import numpy as np

import rakelight


def directions(count):
    """[count, 3] unit vectors, evenly over the sphere: a Fibonacci lattice."""
    k = np.arange(count) + 0.5
    y = 1 - 2 * k / count
    angle = np.pi * (1 + 5**0.5) * k
    ring = np.sqrt(1 - y * y)
    return np.stack([ring * np.sin(angle), y, ring * np.cos(angle)], axis=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", help="a file, or builtin:teapot")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--views", type=int, default=1000)
    parser.add_argument("--size", type=int, default=256, help="[px] of a side")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)

    scene = rakelight.load(arguments.model)
    if scene.bounds is None:
        raise SystemExit(f"{arguments.model}: there is nothing to draw")
    low, high = scene.bounds
    center, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
    distance = radius / np.sin(np.radians(20)) * 1.05  # all of the model at any angle, by a field of view of 40 degrees

    session = rakelight.Session(scene, resolution=(arguments.size, arguments.size))
    cameras = []
    began = time.perf_counter()
    for number, direction in enumerate(directions(arguments.views)):
        camera = rakelight.Camera(center + distance * direction, center, vertical_fov=40)
        view = session.render(camera, channels=["image", "depth", "normal", "object", "triangle"])
        name = f"{number:04d}"
        (arguments.folder / f"{name}.png").write_bytes(view.png())
        ids = {key: view.pop(key) for key in ("object", "triangle")}
        np.savez_compressed(arguments.folder / f"{name}.npz", depth=view["depth"], normal=view["normal"].astype(np.float16), **ids)
        cameras.append({"name": name, "to_world": view.to_world.tolist(), "intrinsics": view.intrinsics.tolist()})
    seconds = time.perf_counter() - began
    (arguments.folder / "cameras.json").write_text(json.dumps({"objects": scene.nodes, "views": cameras}, indent=1))
    print(f"{len(cameras)} views in {seconds:.1f} s, {len(cameras) / max(seconds, 1e-9):.0f} a second")


if __name__ == "__main__":
    main()
