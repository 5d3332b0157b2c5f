#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every value of a valid glTF file is put wrong in turn; the program must answer each file as files are answered.

The base file has one of each: sparse accessor, normalized integers, skin, morph target, animation, camera, light, textures
with samplers and transforms, alpha mask, several primitives. A case is one value of its JSON (found by walking the tree)
replaced by one of REPLACEMENTS, or removed. For each case the program must end by itself within LIMIT_S with one of the exit
codes 0 (drawn), 1, 3 or 4, print at most one error, exactly one where it fails, only lines of its own form, nothing on standard
output, and leave behind no file but the picture that was asked for.

    mutate_gltf.py PROGRAM [--cases N] [--keep DIR]

--cases N takes N cases spread evenly over all of them; without it all run. --keep DIR leaves the files of failed cases there.
"""
import argparse
import base64
import concurrent.futures
import copy
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

LIMIT_S = 60
REMOVED = object()
REPLACEMENTS = [-1, 0, 1, 2.5, 2**31, 2**32, 2**53, 2**64, 1e308, -1e308, "", "string", None, True, [], {}, [[]], REMOVED]
EXIT_CODES = (0, 1, 3, 4)


def png(width, height):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + b"".join(bytes([x * 60, y * 60, 128, 255 - x]) for x in range(width)) for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Buffer:
    """Buffer views of one buffer, each at a multiple of four."""

    def __init__(self):
        self.bytes, self.views = b"", []

    def view(self, data, **more):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data), **more})
        self.bytes += data
        return len(self.views) - 1


def floats(*values):
    return struct.pack("<%df" % len(values), *values)


def base_file():
    buffer = Buffer()
    corners = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
    positions = buffer.view(b"".join(floats(*p) for p in corners), target=34962, byteStride=12)
    normals = buffer.view(b"".join(struct.pack("<bbbx", 0, 0, 127) for _ in corners), target=34962, byteStride=4)
    tangents = buffer.view(floats(1, 0, 0, 1) * 4)
    texcoords = buffer.view(struct.pack("<8H", 0, 65535, 65535, 65535, 65535, 0, 0, 0))
    indices = buffer.view(struct.pack("<6H", 0, 1, 2, 0, 2, 3), target=34963)
    strip = buffer.view(bytes([0, 1, 3, 2]))
    sparse_at, sparse_with = buffer.view(struct.pack("<2H", 1, 3)), buffer.view(floats(0, 0, 0.25, 0, 0, 0.5))
    joints, weights = buffer.view(bytes([0, 1, 0, 0]) * 4), buffer.view(bytes([255, 0, 0, 0]) * 4)
    colors = buffer.view(bytes([255, 128, 64, 255]) * 4)
    inverse = buffer.view(floats(*([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] * 2)))
    times, turns, amounts = buffer.view(floats(0, 1)), buffer.view(floats(0, 0, 0, 1, 0, 0, 1, 0)), buffer.view(floats(0, 1))
    picture = buffer.view(png(4, 4))

    def accessor(view, kind, type_name, count=4, **more):
        return {"bufferView": view, "byteOffset": 0, "componentType": kind, "count": count, "type": type_name, **more}

    accessors = [
        accessor(positions, 5126, "VEC3", min=[-1, -1, 0], max=[1, 1, 0]),
        accessor(normals, 5120, "VEC3", normalized=True),
        accessor(tangents, 5126, "VEC4"),
        accessor(texcoords, 5123, "VEC2", normalized=True),
        accessor(indices, 5123, "SCALAR", 6),
        accessor(strip, 5121, "SCALAR"),
        {"componentType": 5126, "count": 4, "type": "VEC3", "sparse": {
            "count": 2, "indices": {"bufferView": sparse_at, "byteOffset": 0, "componentType": 5123},
            "values": {"bufferView": sparse_with, "byteOffset": 0}}},
        accessor(joints, 5121, "VEC4"),
        accessor(weights, 5121, "VEC4", normalized=True),
        accessor(colors, 5121, "VEC4", normalized=True),
        accessor(inverse, 5126, "MAT4", 2),
        accessor(times, 5126, "SCALAR", 2, min=[0], max=[1]),
        accessor(turns, 5126, "VEC4", 2),
        accessor(amounts, 5126, "SCALAR", 2),
    ]
    corner_data = {"POSITION": 0, "NORMAL": 1, "TANGENT": 2, "TEXCOORD_0": 3, "COLOR_0": 9}
    texture = {"index": 0, "texCoord": 0, "extensions": {
        "KHR_texture_transform": {"offset": [0.1, 0.2], "rotation": 0.5, "scale": [2, 3], "texCoord": 0}}}
    return {
        "asset": {"version": "2.0", "minVersion": "2.0"},
        "extensionsUsed": ["KHR_lights_punctual", "KHR_mesh_quantization", "KHR_texture_transform", "KHR_materials_ior",
                           "KHR_materials_emissive_strength", "KHR_materials_specular", "KHR_materials_anisotropy"],
        "extensionsRequired": ["KHR_mesh_quantization"],
        "extensions": {"KHR_lights_punctual": {"lights": [
            {"type": "spot", "color": [1, 0.5, 0.25], "intensity": 40, "range": 20,
             "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.7}}]}},
        "scene": 0,
        "scenes": [{"name": "all", "nodes": [0, 2, 3, 4]}],
        "nodes": [
            {"name": "part", "mesh": 0, "skin": 0, "children": [1], "weights": [0.5]},
            {"name": "joint", "rotation": [0, 0, 0, 1], "translation": [0, 0, 0.5], "scale": [1, 1, 1]},
            {"name": "strip", "mesh": 1, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 2, 0, 0, 1]},
            {"name": "eye", "camera": 0, "translation": [0, 0, 6]},
            {"name": "lamp", "extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0, 0, 5]},
        ],
        "cameras": [{"type": "perspective", "perspective": {"aspectRatio": 1, "yfov": 0.8, "znear": 0.1, "zfar": 100}},
                    {"type": "orthographic", "orthographic": {"xmag": 2, "ymag": 2, "znear": 0, "zfar": 100}}],
        "meshes": [
            {"name": "quad", "weights": [0.25], "primitives": [
                {"attributes": {**corner_data, "JOINTS_0": 7, "WEIGHTS_0": 8}, "indices": 4, "material": 0, "mode": 4,
                 "targets": [{"POSITION": 6}]}]},
            {"name": "strip", "primitives": [{"attributes": {"POSITION": 0}, "indices": 5, "mode": 5, "material": 1},
                                             {"attributes": {"POSITION": 0}, "mode": 6}]},
        ],
        "materials": [
            {"name": "all", "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1], "metallicFactor": 0.5,
             "roughnessFactor": 0.5, "baseColorTexture": texture, "metallicRoughnessTexture": {"index": 0}},
             "normalTexture": {"index": 0, "scale": 0.5}, "occlusionTexture": {"index": 0, "strength": 0.5},
             "emissiveTexture": {"index": 0}, "emissiveFactor": [0.1, 0.1, 0.1], "alphaMode": "MASK", "alphaCutoff": 0.25,
             "doubleSided": True, "extensions": {
                 "KHR_materials_emissive_strength": {"emissiveStrength": 2}, "KHR_materials_ior": {"ior": 1.4},
                 "KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [1, 1, 1]},
                 "KHR_materials_anisotropy": {"anisotropyStrength": 0.5, "anisotropyRotation": 0.5}}},
            {"name": "plain"}],
        "textures": [{"sampler": 0, "source": 0}],
        "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 33648, "wrapT": 33071}],
        "images": [{"bufferView": picture, "mimeType": "image/png"}],
        "skins": [{"inverseBindMatrices": 10, "joints": [1, 3], "skeleton": 1}],
        "animations": [{"name": "turn", "channels": [
            {"sampler": 0, "target": {"node": 1, "path": "rotation"}},
            {"sampler": 1, "target": {"node": 0, "path": "weights"}}],
            "samplers": [{"input": 11, "output": 12, "interpolation": "LINEAR"},
                         {"input": 11, "output": 13, "interpolation": "STEP"}]}],
        "accessors": accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(buffer.bytes),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(buffer.bytes).decode()}],
    }


def places(value, path=()):
    """Paths to all values below the root."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, part in items:
        yield (*path, key)
        yield from places(part, (*path, key))


def mutated(tree, path, replacement):
    tree = copy.deepcopy(tree)
    owner = tree
    for key in path[:-1]:
        owner = owner[key]
    if replacement is REMOVED:
        del owner[path[-1]]
    else:
        owner[path[-1]] = replacement
    return tree


def problem_of(done, folder):
    lines = done.stderr.decode("utf-8", "replace").splitlines()
    errors = [line for line in lines if line.startswith("rakelight: error: ")]
    strange = [line for line in lines if not line.startswith(("rakelight: error: case.gltf", "rakelight: warning: case.gltf"))]
    if done.returncode not in EXIT_CODES:
        return "exit code %d" % done.returncode
    if strange:
        return "a line of another form: " + strange[0][:200]
    if len(errors) != (done.returncode != 0):
        return "%d errors at exit code %d" % (len(errors), done.returncode)
    if len(set(lines)) != len(lines):
        return "the same line twice: " + max(lines, key=lines.count)[:200]
    if done.stdout:
        return "words on standard output"
    left = sorted(set(os.listdir(folder)) - {"case.gltf"})
    if left != (["case.png"] if done.returncode == 0 else []):
        return "files left: %s at exit code %d" % (left, done.returncode)
    return None


def run_case(program, text, keep, name):
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "case.gltf"), "w") as file:
            file.write(text)
        command = [program, "render", "case.gltf", "-o", "case.png", "--resolution", "24,16", "--threads", "1"]
        try:
            done = subprocess.run(command, cwd=folder, capture_output=True, timeout=LIMIT_S, stdin=subprocess.DEVNULL)
            problem = problem_of(done, folder)
        except subprocess.TimeoutExpired:
            problem = "no end after %d s" % LIMIT_S
        if problem and keep:
            os.makedirs(keep, exist_ok=True)
            shutil.copy(os.path.join(folder, "case.gltf"), os.path.join(keep, name + ".gltf"))
        return problem


def main():
    options = argparse.ArgumentParser()
    options.add_argument("program")
    options.add_argument("--cases", type=int)
    options.add_argument("--keep")
    options = options.parse_args()
    program = os.path.abspath(options.program)
    base = base_file()
    problem = run_case(program, json.dumps(base), options.keep, "base")
    if problem:
        sys.exit("the base file itself: " + problem)
    cases = [(path, k) for path in places(base) for k in range(len(REPLACEMENTS))]
    if options.cases and options.cases < len(cases):
        cases = [cases[i * len(cases) // options.cases] for i in range(options.cases)]

    def one(case):
        path, k = case
        name = "-".join(map(str, path)) + "-%d" % k
        shown = "removed" if REPLACEMENTS[k] is REMOVED else "= " + json.dumps(REPLACEMENTS[k])
        problem = run_case(program, json.dumps(mutated(base, path, REPLACEMENTS[k])), options.keep, name)
        return problem and "%s %s: %s" % ("/".join(map(str, path)), shown, problem)

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        problems = [p for p in pool.map(one, cases) if p]
    print("%d cases, %d problems" % (len(cases), len(problems)))
    for problem in problems:
        print("  " + problem)
    sys.exit(bool(problems))


if __name__ == "__main__":
    main()
