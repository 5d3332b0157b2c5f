#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Attribute arrays for training: of each model positions, normals and tangents without seams, and texture coordinates, in one space and
scale, as one .npz a model.

    python3 training_arrays.py models/*.glb --folder arrays
"""
import argparse
import pathlib

import numpy as np

import rakelight


def unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-30)


def arrays_of(scene):
    """{name: array} of all triangles of a scene, in the world; the box about it becomes -1..1 along its longest side."""
    placed = [mesh for mesh in scene.placed_meshes() if mesh.topology == "triangles"]
    low, high = scene.bounds
    center, scale = (low + high) / 2, 2 / max(high - low)
    parts = {"position": [], "normal": [], "tangent": [], "uv": [], "object": [], "face": []}
    first = 0
    for number, (mesh, made) in enumerate(zip(placed, rakelight.attributes(placed, scope="model"))):
        matrix = mesh.to_world
        linear = matrix[:3, :3]
        count = len(made.normals)
        positions = made.expand(mesh.vertices) + np.asarray(mesh.origin)
        parts["position"].append(((positions @ linear.T + matrix[:3, 3]) - center) * scale)
        parts["normal"].append(unit(made.normals @ np.linalg.inv(linear)))
        tangents = np.zeros((count, 4))
        if made.tangents is not None:
            tangents[:, :3] = unit(made.tangents[:, :3] @ linear.T)
            tangents[:, 3] = made.tangents[:, 3] * np.sign(np.linalg.det(linear))
        parts["tangent"].append(tangents)
        parts["uv"].append(np.zeros((count, 2)) if mesh.uv is None else made.expand(mesh.uv))
        parts["object"].append(np.full(count, number))
        parts["face"].append(np.asarray(made.faces, dtype=np.int64) + first)
        first += count
    types = {"object": np.int32, "face": np.int32}
    return {name: np.concatenate(part).astype(types.get(name, np.float32)) for name, part in parts.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", nargs="+", help="files, or builtin:teapot")
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("arrays"))
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for model in arguments.models:
        arrays = arrays_of(rakelight.load(model))
        output = arguments.folder / f"{pathlib.Path(model).stem.replace(':', '-')}.npz"
        np.savez(output, **arrays)
        print(f"{output}: {len(arrays['position'])} vertices, {len(arrays['face'])} triangles")


if __name__ == "__main__":
    main()
