# SPDX-License-Identifier: Apache-2.0
"""Point clouds for tests and for the eye: points spread over surfaces, written as PLY, OBJ and XYZ. Standard library only.

  clouds.py FOLDER [COUNT]   writes some"""
import math
import pathlib
import random
import struct
import sys

FLOATS, BYTES, WORDS = "float", "uchar", "ushort"


def sphere(count, seed=1):
    """(place, normal, color 0..1) scattered evenly over the unit sphere, colored by direction."""
    rng, points = random.Random(seed), []
    for _ in range(count):
        z, angle = rng.uniform(-1, 1), rng.uniform(0, 2 * math.pi)
        r = math.sqrt(1 - z * z)
        n = (r * math.cos(angle), z, r * math.sin(angle))
        stripe = 0.35 if int(math.floor((angle / math.pi + z) * 4)) % 2 else 1.0
        points.append((n, n, (0.9 * stripe, (0.25 + 0.6 * (n[1] + 1) / 2) * stripe, 0.25)))
    return points


def torus(count, seed=2):
    rng, points = random.Random(seed), []
    while len(points) < count:
        a, b = rng.uniform(0, 2 * math.pi), rng.uniform(0, 2 * math.pi)
        if rng.random() > (1 + 0.4 * math.cos(b)) / 1.4:
            continue
        n = (math.cos(b) * math.cos(a), math.sin(b), math.cos(b) * math.sin(a))
        place = tuple((math.cos(a), 0, math.sin(a))[k] + 0.4 * n[k] for k in range(3))
        points.append((place, n, (0.2 + 0.7 * (n[0] + 1) / 2, 0.3, 0.3 + 0.6 * (n[2] + 1) / 2)))
    return points


def of_mesh(path, count, seed=3):
    """Points spread over the triangles of an OBJ file by their areas, colored by height."""
    places, triangles = [], []
    for line in pathlib.Path(path).read_text(errors="replace").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            places.append(tuple(float(w) for w in words[1:4]))
        if words[:1] == ["f"]:
            corners = [int(w.split("/")[0]) for w in words[1:]]
            corners = [c - 1 if c > 0 else len(places) + c for c in corners]
            triangles += [(corners[0], corners[k], corners[k + 1]) for k in range(1, len(corners) - 1)]
    normals, sums = [], []
    for a, b, c in triangles:
        u = [places[b][k] - places[a][k] for k in range(3)]
        v = [places[c][k] - places[a][k] for k in range(3)]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        length = math.sqrt(sum(x * x for x in n))
        normals.append(tuple(x / length for x in n) if length else (0, 0, 1))
        sums.append(length)
    low, high = min(p[1] for p in places), max(p[1] for p in places)
    rng, points = random.Random(seed), []
    for t in rng.choices(range(len(triangles)), sums, k=count):
        s, q = math.sqrt(rng.random()), rng.random()
        weights = (1 - s, s * (1 - q), s * q)
        place = tuple(sum(weights[i] * places[triangles[t][i]][k] for i in range(3)) for k in range(3))
        h = (place[1] - low) / (high - low or 1)
        points.append((place, normals[t], (0.9 - 0.5 * h, 0.35 + 0.5 * h, 0.3 + 0.3 * h)))
    return points


def numbers(color, kind):
    scale = {FLOATS: 1, BYTES: 255, WORDS: 65535}[kind]
    return tuple(c if kind == FLOATS else int(c * scale + 0.5) for c in color)


def ply(points, *, normals=True, names=("red", "green", "blue"), kind=BYTES, text=False, arrays=()):
    """@param names  of the color's properties; empty: none
    @param arrays  (name, function of the place)"""
    properties = [("float", axis) for axis in "xyz"]
    if normals:
        properties += [("float", "n" + axis) for axis in "xyz"]
    properties += [(kind, name) for name in names] + [("float", name) for name, _ in arrays]
    head = f"ply\nformat {'ascii' if text else 'binary_little_endian'} 1.0\nelement vertex {len(points)}\n"
    head += "".join(f"property {t} {name}\n" for t, name in properties) + "end_header\n"
    codes = {"float": "f", "uchar": "B", "ushort": "H"}
    row = struct.Struct("<" + "".join(codes[t] for t, _ in properties))
    out = [head.encode()]
    for place, normal, color in points:
        values = place + (normal if normals else ()) + (numbers(color, kind) if names else ()) + tuple(f(place) for _, f in arrays)
        out.append((" ".join(f"{v:.7g}" for v in values) + "\n").encode() if text else row.pack(*values))
    return b"".join(out)


def obj(points):
    """Vertices with colors and no faces."""
    return "".join("v {:.6f} {:.6f} {:.6f} {:.4f} {:.4f} {:.4f}\n".format(*place, *color) for place, _, color in points)


def xyz(points, normals=True):
    return "".join(" ".join(f"{v:.6g}" for v in place + (normal if normals else ()) + numbers(color, BYTES)) + "\n"
                   for place, normal, color in points)


def main():
    folder, count = pathlib.Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 50000
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "sphere.ply").write_bytes(ply(sphere(count), arrays=[("intensity", lambda p: p[0] * 10)]))
    (folder / "sphere_plain.ply").write_bytes(ply(sphere(count), names=()))
    (folder / "torus_unlit.ply").write_bytes(ply(torus(count), normals=False, names=("diffuse_red", "diffuse_green", "diffuse_blue")))
    (folder / "torus.xyz").write_text(xyz(torus(count)))
    (folder / "torus.obj").write_text(obj(torus(count)))
    (folder / "places.xyz").write_text("".join("{:.6g} {:.6g} {:.6g}\n".format(*p[0]) for p in torus(count)))
    (folder / "few.ply").write_bytes(ply(sphere(40)))
    if len(sys.argv) > 3:
        (folder / "model.ply").write_bytes(ply(of_mesh(sys.argv[3], count), names=("r", "g", "b"), kind=FLOATS))


if __name__ == "__main__":
    main()
