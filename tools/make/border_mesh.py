# SPDX-License-Identifier: Apache-2.0
"""Triangle meshes as the border tools beside work on them: objects of an OBJ file in and out, normals, open borders, vectors.
Only the standard library is needed. A mesh is (positions, triangles): tuples of three floats, tuples of three indices."""
import collections
import math

Mesh = collections.namedtuple("Mesh", "name positions triangles")


class BadModel(Exception):
    """One line for whoever runs the tool."""


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scaled(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def unit(a, otherwise=(0.0, 0.0, 1.0)):
    size = length(a)
    return scaled(a, 1 / size) if size > 0 else otherwise


def mixed(a, b, t):
    return (a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t)


def cross_of(positions, triangle):
    """The normal of a face, as long as twice its area."""
    a, b, c = (positions[i] for i in triangle)
    return cross(sub(b, a), sub(c, a))


def number_of(corner, count):
    """Index from 0 of the position that a corner of OBJ names."""
    index = int(corner.partition("/")[0])
    index = index - 1 if index > 0 else count + index
    if not 0 <= index < count or corner.startswith("0"):
        raise IndexError
    return index


def read_obj(path):
    """[Mesh] for each object with faces: by `o`, in files without by `g`. Equal positions of an object are one vertex; polygons are fans;
    degenerate triangles go."""
    positions, objects, groups, name, group = [], {}, {}, "", "model"
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            for number, line in enumerate(file, 1):
                word, _, rest = line.partition("#")[0].strip().partition(" ")
                if word == "v":
                    position = tuple(float(x) + 0.0 for x in rest.split()[:3])
                    if len(position) < 3 or not all(map(math.isfinite, position)):
                        raise ValueError
                    positions.append(position)
                elif word == "o":
                    name = rest.strip() or "model"
                elif word == "g":
                    group = rest.strip() or "model"
                elif word == "f":
                    face = [positions[number_of(c, len(positions))] for c in rest.split()]
                    objects.setdefault(name or "model", []).append(face)
                    groups.setdefault(group, []).append(face)
    except OSError as error:
        raise BadModel(f"{path}: {error.strerror}") from None
    except (ValueError, IndexError):
        raise BadModel(f"{path}: line {number}: cannot read {line.strip()!r}") from None
    meshes = [mesh for mesh in (welded(*part) for part in (objects if name else groups).items()) if mesh.triangles]
    if not meshes:
        raise BadModel(f"{path}: no triangles")
    return meshes


def welded(name, faces):
    """Faces, given by positions, as a mesh."""
    numbers, triangles = {}, []
    for face in faces:
        corners = [numbers.setdefault(p, len(numbers)) for p in face]
        triangles += [(corners[0], b, c) for b, c in zip(corners[1:], corners[2:]) if len({corners[0], b, c}) == 3]
    return Mesh(name, list(numbers), triangles)


def compacted(name, positions, triangles):
    """The mesh without vertices that no triangle has."""
    used = sorted({i for t in triangles for i in t})
    place = {old: new for new, old in enumerate(used)}
    return Mesh(name, [positions[i] for i in used], [tuple(place[i] for i in t) for t in triangles])


def vertex_normals(positions, triangles):
    """Face normals weighted by the angle at the corner (Thuermer & Wuethrich 1998)."""
    sums = [(0.0, 0.0, 0.0)] * len(positions)
    for t in triangles:
        n = unit(cross_of(positions, t), (0.0, 0.0, 0.0))
        for k in range(3):
            p = positions[t[k]]
            a, b = sub(positions[t[k - 2]], p), sub(positions[t[k - 1]], p)
            sums[t[k]] = add(sums[t[k]], scaled(n, math.atan2(length(cross(a, b)), dot(a, b))))
    return [unit(s) for s in sums]


def edges_of(triangles):
    """{(a, b): [faces that go from a to b]}"""
    edges = collections.defaultdict(list)
    for f, t in enumerate(triangles):
        for k in range(3):
            edges[t[k - 1], t[k]].append(f)
    return edges


def open_edges(triangles):
    """[(a, b, face)]: edges, in the direction of their face, that no other face has."""
    edges = edges_of(triangles)
    return [(a, b, faces[0]) for (a, b), faces in edges.items() if len(faces) == 1 and (b, a) not in edges]


def mean_edge(positions, triangles):
    lengths = [length(sub(positions[a], positions[b])) for a, b in edges_of(triangles)]
    return sum(lengths) / len(lengths)


def write_obj(path, parts, remark):
    """parts: [(Mesh, normals or None)]"""
    lines, base = [f"# {remark}"], 1
    for mesh, normals in parts:
        lines.append(f"o {mesh.name}")
        lines += ["v %.8g %.8g %.8g" % p for p in mesh.positions]
        lines += ["vn %.6g %.6g %.6g" % n for n in normals or ()]
        corner = "%d//%d" if normals else "%d"
        for t in mesh.triangles:
            lines.append("f " + " ".join(corner % ((base + i,) * corner.count("%")) for i in t))
        base += len(mesh.positions)
    try:
        with open(path, "w", encoding="utf-8") as out:
            out.write("\n".join(lines) + "\n")
    except OSError as error:
        raise BadModel(f"{path}: {error.strerror}") from None
