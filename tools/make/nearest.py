# SPDX-License-Identifier: Apache-2.0
"""The nearest of many segments or triangles, for the border tools beside. Only the standard library is needed."""
import collections
import itertools
import math

from border_mesh import add, cross, dot, length, scaled, sub


def on_segment(p, a, b):
    """Weights of a and b at the nearest point."""
    along = sub(b, a)
    size = dot(along, along)
    t = min(1.0, max(0.0, dot(sub(p, a), along) / size)) if size > 0 else 0.0
    return (1 - t, t)


def on_triangle(p, a, b, c):
    """Weights of the corners at the nearest point: inside, or on the nearest edge."""
    n = cross(sub(b, a), sub(c, a))
    size = dot(n, n)
    if size > 0:
        u, v = dot(cross(sub(c, b), sub(p, b)), n) / size, dot(cross(sub(a, c), sub(p, c)), n) / size
        if u >= 0 and v >= 0 and u + v <= 1:
            return (u, v, 1 - u - v)
    ab, bc, ca = on_segment(p, a, b), on_segment(p, b, c), on_segment(p, c, a)
    return min(((*ab, 0.0), (0.0, *bc), (ca[1], 0.0, ca[0])), key=lambda w: length(sub(p, blend(w, (a, b, c)))))


def blend(weights, corners):
    total = (0.0, 0.0, 0.0)
    for w, corner in zip(weights, corners):
        total = add(total, scaled(corner, w))
    return total


class Nearest:
    """Segments or triangles, as lists of corners, in a grid."""

    def __init__(self, items):
        self.items, self.cells = items, collections.defaultdict(list)
        self.size = sum(length(sub(i[0], i[1])) for i in items) / max(1, len(items)) or 1.0
        for number, item in enumerate(items):
            for cell in self.cells_of([min(c) for c in zip(*item)], [max(c) for c in zip(*item)]):
                self.cells[cell].append(number)

    def cells_of(self, low, high):
        return itertools.product(*(range(math.floor(a / self.size), math.floor(b / self.size) + 1) for a, b in zip(low, high)))

    def find(self, p, most):
        """(distance, number of the item, weights of its corners), or None where nothing is so near."""
        radius = min(self.size, most)
        while True:
            near = {i for cell in self.cells_of([x - radius for x in p], [x + radius for x in p]) for i in self.cells.get(cell, ())}
            best = None
            for i in sorted(near):
                weights = (on_segment if len(self.items[i]) == 2 else on_triangle)(p, *self.items[i])
                distance = length(sub(p, blend(weights, self.items[i])))
                if distance <= radius and (best is None or distance < best[0]):
                    best = (distance, i, weights)
            if best or radius >= most:
                return best
            radius = min(2 * radius, most)
