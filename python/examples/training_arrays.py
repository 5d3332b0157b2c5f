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
    """{name: array} of all triangles of a scene, in the world; the box about it becomes -1..1 along its longest side. None: it has none."""
    placed = [mesh for mesh in scene.placed_meshes() if mesh.topology == "triangles" and len(mesh.faces) > 0]
    if not placed or scene.bounds is None:
        return None
    low, high = scene.bounds
    center, scale = (low + high) / 2, 2 / max(*(high - low), 1e-30)
    parts = {"position": [], "normal": [], "tangent": [], "uv": [], "object": [], "face": []}
    first = 0
    for number, (mesh, made) in enumerate(zip(placed, rakelight.attributes(placed, normals="model"))):
        matrix = mesh.to_world
        linear = matrix[:3, :3]
        count = len(made.normals)
        is_mirrored = np.linalg.det(linear) < 0
        cofactors = np.cross(linear[[1, 2, 0]], linear[[2, 0, 1]]) * (-1 if is_mirrored else 1)  # perpendicular to what linear makes
        parts["position"].append((made.expand(mesh.positions(world=True)) - center) * scale)
        parts["normal"].append(unit(made.normals @ cofactors.T))
        tangents = np.zeros((count, 4))
        if made.tangents is not None:
            tangents[:, :3] = unit(made.tangents[:, :3] @ linear.T)
            tangents[:, 3] = -made.tangents[:, 3] if is_mirrored else made.tangents[:, 3]
        parts["tangent"].append(tangents)
        parts["uv"].append(np.zeros((count, 2)) if mesh.uv is None else made.expand(mesh.uv))
        parts["object"].append(np.full(count, number))
        faces = np.asarray(made.faces, dtype=np.int64) + first
        parts["face"].append(faces[:, ::-1] if is_mirrored else faces)  # counter-clockwise seen from outside
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
        try:
            arrays = arrays_of(rakelight.load(model))
        except rakelight.Error as error:
            raise SystemExit(str(error))
        if arrays is None:
            raise SystemExit(f"{model}: there are no triangles")
        output = arguments.folder / f"{pathlib.Path(model).stem.replace(':', '-')}.npz"
        np.savez(output, **arrays)
        print(f"{output}: {len(arrays['position'])} vertices, {len(arrays['face'])} triangles")


if __name__ == "__main__":
    main()
