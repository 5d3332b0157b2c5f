# SPDX-License-Identifier: Apache-2.0
"""Triangles cut into K * K smaller ones on a curved surface, for the border tools beside: curved PN triangles (Vlachos, Peters, Boyd,
Mitchell 2001), or flat. Only the standard library is needed."""
from border_mesh import Mesh, add, dot, scaled, sub


def control(p, n, q):
    """The control point next to p on the edge to q: the third of the way, in the plane at p with normal n (their b_210)."""
    w = dot(sub(q, p), n)
    return scaled(sub(add(scaled(p, 2), q), scaled(n, w)), 1 / 3)


def patch(corners, normals):
    """{(i, j, k): control point} of the cubic Bezier triangle over three corners."""
    points = {(3, 0, 0): corners[0], (0, 3, 0): corners[1], (0, 0, 3): corners[2]}
    rim = (0.0, 0.0, 0.0)
    for a in range(3):
        for b in range(3):
            if a != b:
                key = tuple(2 * (i == a) + (i == b) for i in range(3))
                points[key] = control(corners[a], normals[a], corners[b])
                rim = add(rim, points[key])
    center = scaled(add(add(corners[0], corners[1]), corners[2]), 1 / 3)
    mean = scaled(rim, 1 / 6)
    points[1, 1, 1] = add(mean, scaled(sub(mean, center), 0.5))
    return points


def point_of(points, weights):
    """The Bezier triangle at barycentric weights."""
    total = (0.0, 0.0, 0.0)
    for (i, j, k), p in points.items():
        ways = 6 if (i, j, k) == (1, 1, 1) else 1 if 3 in (i, j, k) else 3
        total = add(total, scaled(p, ways * weights[0] ** i * weights[1] ** j * weights[2] ** k))
    return total


def flat_patch(corners, _):
    """The control points of the flat triangle: evenly between the corners."""
    return {(i, j, 3 - i - j): scaled(add(add(scaled(corners[0], i), scaled(corners[1], j)), scaled(corners[2], 3 - i - j)), 1 / 3)
            for i in range(4) for j in range(4 - i)}


def subdivided(mesh, normals, k, curved=True):
    """Every edge becomes k. normals: of the vertices, for the curve. Vertices keep their numbers; new ones come behind them."""
    positions, triangles, numbers = list(mesh.positions), [], {}
    if k == 1:
        return mesh
    for face, t in enumerate(mesh.triangles):
        points = (patch if curved else flat_patch)([mesh.positions[i] for i in t], [normals[i] for i in t])

        def vertex(i, j):
            """The number of the vertex with weights i, j, k - i - j, over k."""
            shares = (i, j, k - i - j)
            corners = tuple(sorted((t[c], shares[c]) for c in range(3) if shares[c]))
            if len(corners) == 1:
                return corners[0][0]
            key = corners if len(corners) == 2 else (face, shares)
            if key not in numbers:
                numbers[key] = len(positions)
                positions.append(point_of(points, [s / k for s in shares]))
            return numbers[key]

        for i in range(k):
            for j in range(k - i):
                triangles.append((vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)))
                if i + j < k - 1:
                    triangles.append((vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)))
    return Mesh(mesh.name, positions, triangles)
