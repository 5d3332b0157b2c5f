# SPDX-License-Identifier: Apache-2.0
"""Meshes cut by planes, for the border tools beside: triangles that cross a plane are cut at it, so that both sides have one border.
Only the standard library is needed."""
from border_mesh import Mesh, compacted, dot, mean_edge, mixed

NEAR = 0.02  # mean edge lengths: so near, a vertex counts as on the plane and an edge is not cut beside it


def plane_at(mesh, normal, share):
    """(unit normal, distance): the plane at that share of the mesh's extent along the normal."""
    heights = [dot(normal, p) for p in mesh.positions]
    return normal, min(heights) + share * (max(heights) - min(heights))


def cut(mesh, planes):
    """The mesh with its triangles cut at the planes. New vertices come behind the old ones."""
    positions, triangles, near = list(mesh.positions), mesh.triangles, NEAR * mean_edge(mesh.positions, mesh.triangles)
    for normal, distance in planes:
        height = [dot(normal, p) - distance for p in positions]
        side = [0 if abs(h) <= near else 1 if h > 0 else -1 for h in height]
        numbers, pieces = {}, []

        def crossing(a, b):
            a, b = sorted((a, b))
            if (a, b) not in numbers:
                numbers[a, b] = len(positions)
                positions.append(mixed(positions[a], positions[b], height[a] / (height[a] - height[b])))
            return numbers[a, b]

        for t in triangles:
            pieces += pieces_of(t, side, crossing)
        triangles = pieces
    return Mesh(mesh.name, positions, triangles)


def pieces_of(t, side, crossing):
    """The triangles that a triangle falls into."""
    for k in range(3):
        a, b, c = t[k], t[k - 2], t[k - 1]
        if side[a] and side[b] == side[c] == -side[a]:   # a alone on its side
            ab, ac = crossing(a, b), crossing(a, c)
            return [(a, ab, ac), (ab, b, c), (ab, c, ac)]
        if not side[a] and side[b] * side[c] < 0:         # a on the plane, between b and c
            middle = crossing(b, c)
            return [(a, b, middle), (a, middle, c)]
    return [t]


def cells(mesh, planes):
    """{sides of the planes, each -1 or 1: Mesh} of a mesh that was cut."""
    triangles = {}
    for t in mesh.triangles:
        center = [sum(mesh.positions[i][k] for i in t) / 3 for k in range(3)]
        sides = tuple(1 if dot(n, center) > d else -1 for n, d in planes)
        triangles.setdefault(sides, []).append(t)
    return {sides: compacted(mesh.name, mesh.positions, triangles[sides]) for sides in sorted(triangles)}
