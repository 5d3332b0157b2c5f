# SPDX-License-Identifier: Apache-2.0
"""Fewer triangles by edge collapses, for the border tools beside: Garland & Heckbert 1997, "Surface Simplification Using Quadric
Error Metrics", with their constraint planes along open borders (section 6). Only the standard library is needed."""
import collections
import heapq

from border_mesh import compacted, cross, cross_of, dot, edges_of, length, mixed, sub, unit

BORDER_WEIGHT = 100.0  # of a constraint plane, against that of a face as large as the edge's square
LEAST_COSINE = 0.85    # of the angle by which a collapse turns a face


def plane_quadric(n, p, weight):
    """Upper half of weight * (n, d)(n, d)^T, where d = -n.p"""
    d = -dot(n, p)
    return [weight * x for x in (n[0] * n[0], n[0] * n[1], n[0] * n[2], n[0] * d, n[1] * n[1], n[1] * n[2], n[1] * d,
                                 n[2] * n[2], n[2] * d, d * d)]


def error_at(q, p):
    x, y, z = p
    return (q[0] * x * x + 2 * q[1] * x * y + 2 * q[2] * x * z + 2 * q[3] * x + q[4] * y * y + 2 * q[5] * y * z + 2 * q[6] * y
            + q[7] * z * z + 2 * q[8] * z + q[9])


def best_place(q, a, b):
    """(error, place) of the least error; where the quadric has no clear minimum near the edge, the best of its ends and middle."""
    rows = ((q[0], q[1], q[2]), (q[1], q[4], q[5]), (q[2], q[5], q[7]))
    side = (-q[3], -q[6], -q[8])
    minors = cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])
    determinant, size = dot(rows[0], minors[0]), q[0] + q[4] + q[7]
    places = [a, b, mixed(a, b, 0.5)]
    if abs(determinant) > 1e-4 * size ** 3:
        best = tuple(sum(side[r] * minors[r][c] for r in range(3)) / determinant for c in range(3))
        if length(sub(best, places[2])) <= length(sub(a, b)):
            places = [best]
    return min((error_at(q, p), p) for p in places)


class Decimation:
    def __init__(self, mesh):
        self.positions, self.faces = list(mesh.positions), dict(enumerate(mesh.triangles))
        self.faces_of = collections.defaultdict(set)
        for f, t in self.faces.items():
            for i in t:
                self.faces_of[i].add(f)
        edges = edges_of(mesh.triangles)
        self.locked = {i for (a, b), faces in edges.items() if len(faces) + len(edges.get((b, a), ())) > 2 for i in (a, b)}
        self.on_border = {i for (a, b) in edges if self.is_border(a, b) for i in (a, b)}
        self.quadrics = [[0.0] * 10 for _ in self.positions]
        for t in mesh.triangles:
            self.add_planes(t)
        self.stamps, self.heap = [0] * len(self.positions), []
        for a, b in sorted({tuple(sorted(e)) for e in edges}):
            self.offer(a, b)

    def is_border(self, a, b):
        return len(self.faces_of[a] & self.faces_of[b]) == 1

    def add_planes(self, t):
        """The plane of a face, by its area, and through each open edge one at a right angle to it."""
        n = cross_of(self.positions, t)
        for i in t:
            self.grow(i, plane_quadric(unit(n), self.positions[i], length(n) / 2))
        for k in range(3):
            a, b = t[k - 1], t[k]
            if self.is_border(a, b):
                along = sub(self.positions[b], self.positions[a])
                for i in (a, b):
                    self.grow(i, plane_quadric(unit(cross(along, n)), self.positions[a], BORDER_WEIGHT * dot(along, along)))

    def grow(self, i, quadric):
        self.quadrics[i] = [x + y for x, y in zip(self.quadrics[i], quadric)]

    def offer(self, a, b):
        """Puts the edge's collapse on the heap. What a border vertex takes in from inside does not move it; two of them meet along the
        border alone."""
        if a in self.locked or b in self.locked:
            return
        q = [x + y for x, y in zip(self.quadrics[a], self.quadrics[b])]
        if (a in self.on_border) != (b in self.on_border):
            place = self.positions[a if a in self.on_border else b]
            error = error_at(q, place)
        elif a in self.on_border and not self.is_border(a, b):
            return
        else:
            error, place = best_place(q, self.positions[a], self.positions[b])
        heapq.heappush(self.heap, (error, a, b, self.stamps[a], self.stamps[b], place))

    def neighbors(self, i):
        return {j for f in self.faces_of[i] for j in self.faces[f]} - {i}

    def is_allowed(self, a, b, place):
        """The link condition (the surface stays a manifold), and no face turns far."""
        both = self.faces_of[a] & self.faces_of[b]
        near_a, near_b = self.neighbors(a), self.neighbors(b)
        if near_a & near_b != {i for f in both for i in self.faces[f]} - {a, b} or len(near_a | near_b) <= 5:
            return False
        for f in self.faces_of[a] ^ self.faces_of[b]:
            old = cross_of(self.positions, self.faces[f])
            corners = [place if i in (a, b) else self.positions[i] for i in self.faces[f]]
            if dot(unit(old), unit(cross_of(corners, (0, 1, 2)), (0.0, 0.0, 0.0))) < LEAST_COSINE:
                return False
        return True

    def collapse(self, a, b, place):
        """b goes into a."""
        for f in self.faces_of[a] & self.faces_of[b]:
            for i in self.faces.pop(f):
                self.faces_of[i].discard(f)
        for f in self.faces_of.pop(b):
            self.faces[f] = tuple(a if i == b else i for i in self.faces[f])
            self.faces_of[a].add(f)
        self.positions[a] = place
        if b in self.on_border:
            self.on_border.add(a)
        self.grow(a, self.quadrics[b])
        self.stamps[a] += 1
        self.stamps[b] = -1
        for i in sorted(self.neighbors(a)):
            self.offer(*sorted((a, i)))

    def run(self, triangles):
        while len(self.faces) > triangles and self.heap:
            _, a, b, stamp_a, stamp_b, place = heapq.heappop(self.heap)
            if (stamp_a, stamp_b) == (self.stamps[a], self.stamps[b]) and self.is_allowed(a, b, place):
                self.collapse(a, b, place)


def decimated(mesh, share):
    """The mesh with that share of its triangles, or a few more where no collapse is allowed. Vertices are numbered anew."""
    work = Decimation(mesh)
    work.run(max(1, round(share * len(mesh.triangles))))
    return compacted(mesh.name, work.positions, [work.faces[f] for f in sorted(work.faces)])
