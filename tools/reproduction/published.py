# SPDX-License-Identifier: Apache-2.0
"""The first source's routine for normals, tangents and bitangents, each vertex against each face as it is printed, and models with such attributes as glTF files.
v counts upwards here, as in the publication."""
import base64
import json
import math
import struct

from sheet import ROOT

from .kit import cross, dot, minus, unit


def read_obj(path):
    """(points, texture coordinates, triangles) of an OBJ file: one vertex for each pair that its faces name."""
    points, coordinates, vertices, triangles = [], [], {}, []
    for line in (ROOT / path).read_text().splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            points.append([float(x) for x in rest])
        elif word == "vt":
            coordinates.append([float(x) for x in rest[:2]])
        elif word == "f":
            face = [vertices.setdefault(tuple(int(i) - 1 for i in corner.split("/")[:2]), len(vertices)) for corner in rest]
            triangles += [(face[0], face[i], face[i + 1]) for i in range(1, len(face) - 1)]
    return [points[i] for i, _ in vertices], [coordinates[j] for _, j in vertices], triangles


def of_face(model, triangle):
    """Unit normal, tangent and bitangent of a face."""
    points, coordinates, _ = model
    p, q, r = (points[i] for i in triangle)
    a, b, c = (coordinates[i] for i in triangle)
    (du1, dv1), (du2, dv2), e1, e2 = minus(b, a), minus(c, a), minus(q, p), minus(r, p)
    determinant = du1 * dv2 - du2 * dv1
    return (unit(cross(e1, e2)), unit([(dv2 * x - dv1 * y) / determinant for x, y in zip(e1, e2)]),
            unit([(du1 * y - du2 * x) / determinant for x, y in zip(e1, e2)]))


def averaged(model):
    """[(normal, tangent, bitangent)] of the vertices: of all faces with a corner at the place; where a sum is 0, of the first."""
    points, _, triangles = model
    faces = [of_face(model, t) for t in triangles]
    found = []
    for point in points:
        near = [face for face, t in zip(faces, triangles) if any(points[i] == point for i in t)]
        sums = [([sum(x) for x in zip(*vectors)], vectors[0]) for vectors in zip(*near)]
        found.append(tuple(unit(total) if dot(total, total) > 1e-12 else first for total, first in sums))
    return found


def orthogonal(normal, tangent):
    """The tangent by Gram-Schmidt."""
    return unit([t - n * dot(normal, tangent) for n, t in zip(normal, tangent)])


def turned(normal, tangent, bitangent):
    """The tangent by the handedness step."""
    return [-x for x in tangent] if dot(cross(normal, tangent), bitangent) < 0 else tangent


def split(model):
    """The same faces, none with a vertex of another one."""
    points, coordinates, triangles = model
    order = [i for t in triangles for i in t]
    return [points[i] for i in order], [coordinates[i] for i in order], [(3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(triangles))]


def write_gltf(path, model, frames):
    """A model with a normal, a tangent and a sign of the bitangent, 1 or -1, for each vertex."""
    points, coordinates, triangles = model
    columns = [("POSITION", "VEC3", points), ("NORMAL", "VEC3", [f[0] for f in frames]), ("TANGENT", "VEC4", [(*f[1], f[2]) for f in frames]),
               ("TEXCOORD_0", "VEC2", [(u, 1 - v) for u, v in coordinates])]
    blob, views, accessors = b"", [], []
    for name, kind, rows in columns:
        body = struct.pack(f"<{len(rows) * len(rows[0])}f", *(x for row in rows for x in row))
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(body)})
        limits = {"min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]} if name == "POSITION" else {}
        accessors.append({"bufferView": len(accessors), "componentType": 5126, "count": len(rows), "type": kind, **limits})
        blob += body
    body = struct.pack(f"<{3 * len(triangles)}I", *(i for t in triangles for i in t))
    views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(body)})
    accessors.append({"bufferView": len(accessors), "componentType": 5125, "count": 3 * len(triangles), "type": "SCALAR"})
    blob += body
    primitive = {"attributes": {column[0]: i for i, column in enumerate(columns)}, "indices": len(columns), "material": 0}
    material = {"pbrMetallicRoughness": {"baseColorFactor": [0.6, 0.32, 0.23, 1], "metallicFactor": 0, "roughnessFactor": 0.6}, "doubleSided": True}
    path.write_text(json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "meshes": [{"primitives": [primitive]}],
                                "materials": [material], "buffers": [{"byteLength": len(blob), "uri": "data:application/octet-stream;base64," + base64.b64encode(blob).decode()}],
                                "bufferViews": views, "accessors": accessors}))
    return path


def hills(cells=5):
    """An uneven square of so many cells a side, whose averaged frames lean."""
    def height(x, y):
        return 0.45 * math.sin(2.3 * x + 0.6) * math.cos(1.9 * y - 0.4) + 0.22 * math.sin(4 * x * y + 2 * y)
    places = [(2 * x / cells - 1, 2 * y / cells - 1) for y in range(cells + 1) for x in range(cells + 1)]
    triangles = []
    for y in range(cells):
        for x in range(cells):
            a, b = y * (cells + 1) + x, (y + 1) * (cells + 1) + x
            triangles += [(a, a + 1, b + 1), (a, b + 1, b)]
    return [(x, y, height(x, y)) for x, y in places], [(x + 1, y + 1) for x, y in places], triangles


def write_obj(path, model):
    """The model without attributes."""
    points, coordinates, triangles = model
    lines = ["v {:.9g} {:.9g} {:.9g}".format(*p) for p in points] + ["vt {:.9g} {:.9g}".format(*c) for c in coordinates]
    path.write_text("\n".join(lines + ["f " + " ".join(f"{i + 1}/{i + 1}" for i in t) for t in triangles]) + "\n")
    return path
