#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Small scenes of parts that lie near each other, for tests of --border-distance: most must not join, and their names say why.

  border_scenes.py FOLDER        writes NAME.obj for each and prints its distance

Lengths are about 1 an edge. Each scene has a distance D in which open borders of different parts lie; no two parts share a vertex, and
normals of the parts differ there, so that a join shows. Standard library only."""
import collections
import math
import pathlib
import sys

# parts: [(name, positions, faces)]; joins: whether the borders must join at this distance.
Scene = collections.namedtuple("Scene", "name distance joins parts")


def sheet(name, across, along, at, flipped=False):
    """A grid of quads, across * along, its vertices at(u, v) with u, v from 0 to 1."""
    positions = [at(i / across, j / along) for j in range(along + 1) for i in range(across + 1)]
    corners = [j * (across + 1) + i for j in range(along) for i in range(across)]
    faces = [(a, a + 1, a + across + 2, a + across + 1) for a in corners]
    return name, positions, [f[::-1] for f in faces] if flipped else faces


def ring(name, around, profile, flipped=False):
    """A surface of revolution about +y through a profile of (radius, height); from inside to outside it faces up. A first radius of 0 is a fan."""
    def turned(r, y, k):
        return (r * math.sin(2 * math.pi * k / around), y, r * math.cos(2 * math.pi * k / around))
    positions = [turned(r, y, k) for r, y in profile for k in range(around)]
    faces = []
    for row in range(len(profile) - 1):
        for k in range(around):
            a, b = row * around + k, row * around + (k + 1) % around
            faces.append((a, a + around, b + around) if profile[row][0] == 0 else (a, a + around, b + around, b))
    return name, positions, [f[::-1] for f in faces] if flipped else faces


def arched(x, y, z, width, depth, rise):
    """A sheet that faces +y and bulges by `rise`, from (x, y, z) on, over width and depth."""
    return lambda u, v: (x + width * u, y + rise * 4 * u * (1 - u), z + depth * (1 - v))


def plates_lying_on_each_other():
    """The upper plate lies 0.1 above the lower one and 0.15 aside: its borders run beside the lower plate's, the same way round."""
    return 0.3, [sheet("lower", 3, 3, arched(0, 0, 0, 3, 3, 0)), sheet("upper", 4, 4, arched(0.15, 0.1, 0.15, 3, 3, 0.4))]


def alternatives_in_one_place():
    """Three variants of one panel, of which a viewer shows one at a time: their borders lie on each other, the same way round."""
    return 0.2, [sheet(f"variant_{k}", k + 2, k + 2, arched(-0.02 * k, 0, -0.02 * k, 3 + 0.04 * k, 3 + 0.04 * k, 0.3 * k)) for k in range(3)]


def button_in_a_hole():
    """The rim of the hole is rounded and ends upright; the button's cap ends 0.1 from it, at 90 degrees to it."""
    rim = [(1 + 0.4 * (1 - math.sin(a)), 0.4 * (math.cos(a) - 1)) for a in (math.pi / 2, math.pi / 3, math.pi / 6, 0)]
    cap = [(0, -0.25), (0.5, -0.3), (0.9, -0.4)]
    return 0.2, [ring("plate", 10, [*rim, (2.4, 0)]), ring("button", 8, cap)]


def collar_over_a_neck():
    """A flat collar, 0.1 from the lower end of an upright neck."""
    return 0.2, [ring("neck", 10, [(1, 0), (1, 1), (0.9, 2)], flipped=True), ring("collar", 8, [(1.1, 0), (2, 0), (2.8, -0.3)])]


def hair_cards():
    """Strips side by side, each 0.15 over the one before it: borders run against each other, but over the inside of the other strip."""
    def card(k):
        return lambda u, v: (0.85 * k + u, 0.1 * k + 0.6 * u * (1 - u) - 0.6 * v * v, 4 - 4 * v)
    return 0.25, [sheet(f"card_{k}", 2, 3 + k % 2, card(k)) for k in range(4)]


def opposite_shells():
    """An outer and an inner shell, 0.1 apart, back to back: borders run against each other, faces look opposite ways."""
    def dome(r):
        return lambda u, v: (r * math.sin(1.4 * (u - 0.5)), r * math.cos(1.4 * (u - 0.5)), 2 - 2 * v)
    return 0.2, [sheet("outside", 3, 2, dome(2)), sheet("inside", 4, 3, dome(1.9), flipped=True)]


def parallel_walls():
    """Three walls one behind the other, 0.1 apart, facing the same way, each bent more than the one behind it."""
    return 0.3, [sheet(f"wall_{k}", 3, 2 + k, lambda u, v, k=k: (3 * u, 2 * v, -0.1 * k + 0.3 * (2 - k) * math.sin(math.pi * u))) for k in range(3)]


def fish_scales():
    """Two rows of arched scales: each lies over the row below it and over its neighbor's side, which it meets in a valley of 80 degrees."""
    def scale(row, k):
        def at(u, v):
            x = (u - 0.5) * 1.1
            return (k + 0.5 * row + x, 0.15 * v - 0.9 * x * x + 0.02 * k, 0.8 * row + 1.2 * v)
        return at
    return 0.25, [sheet(f"scale_{row}_{k}", 4, 2, scale(row, k), flipped=True) for row in range(2) for k in range(3)]


def panels_with_a_gap():
    """Two panels of one arch, 0.05 apart, of three and five edges along the gap: these must join."""
    def arch(low, high):
        return lambda u, v: (2 * math.sin(low + (high - low) * u), 2 * math.cos(low + (high - low) * u), 3 - 3 * v)
    return 0.15, [sheet("left", 2, 3, arch(-0.8, -0.0125)), sheet("right", 3, 5, arch(0.0125, 0.8))]


APART = (plates_lying_on_each_other, alternatives_in_one_place, button_in_a_hole, collar_over_a_neck, hair_cards, opposite_shells, parallel_walls,
         fish_scales)
JOINED = (panels_with_a_gap,)


def scenes():
    """[Scene], those that must join last."""
    return [Scene(make.__name__.replace("_", "-"), *make()[:1], make in JOINED, make()[1]) for make in APART + JOINED]


def text_of(scene):
    lines, base = [], 1
    for name, positions, faces in scene.parts:
        lines += [f"o {name}", *("v %.7g %.7g %.7g" % p for p in positions)]
        lines += ["f " + " ".join(str(base + i) for i in face) for face in faces]
        base += len(positions)
    return "\n".join(lines) + "\n"


def write(folder):
    """Writes NAME.obj for each scene. @return [(path, Scene)]"""
    written = []
    for scene in scenes():
        path = pathlib.Path(folder) / f"{scene.name}.obj"
        path.write_text(text_of(scene))
        written.append((path, scene))
    return written


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for path, scene in write(folder):
        print(f"{path}: {len(scene.parts)} parts, distance {scene.distance}, {'must join' if scene.joins else 'must not join'}")


if __name__ == "__main__":
    main()
