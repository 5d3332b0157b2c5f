#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Shadows, fog and --light-cutoff side by side, for docs/shadows.md; photometric lights and ranges, and --viewer-infinity, for
docs/lighting.md and docs/lighting-models.md; ambient occlusion for docs/ambient-occlusion.md.

  light_pictures.py [--program build/release/rakelight] shadows|fog|cutoff|ranges|viewer|occlusion OUT.png

The scene is made here: solids on a floor, or a row of columns. Only the standard library is needed."""
import sys
import argparse
import math
import pathlib
import tempfile

from sheet import PROGRAM, write_sheet

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "make"))
from make_many_lights import world  # noqa: E402

WIDTH, HEIGHT = 240, 160
AMBIENT = ("--light", "ambient:0.12,0.12,0.14")
SUN = ("--light", "directional:-1,-1.3,0.75:color=0.9,0.9,0.85:specular=0.2,0.2,0.2", *AMBIENT)
GRAZING = ("--light", "directional:-1,-0.12,0.3:color=3,2.9,2.7:specular=0,0,0", *AMBIENT)
LAMP = ("--light", "point:0.2,1.1,0.9:attenuation=0.6,0,0.5", *AMBIENT)
SPOT = ("--light", "spot:2.5,3.5,2:direction=-2.6,-3.3,-2.2:cutoff=24:exponent=6:color=1.4,1.4,1.4", *AMBIENT)
SHADOWS = (("--shadows", "off", *SUN), ("--shadows", *SUN), ("--shadows", *LAMP), ("--shadows", *SPOT),
           ("--shadows", "--shadow-size", "128", "--shadow-filter", "0", *SUN),
           ("--shadows", "--shadow-size", "128", "--shadow-filter", "4", *SUN), ("--shadows", *GRAZING),
           ("--shadows", "--shadow-bias", "0", *LAMP))
SOLIDS = ("--camera-position", "2.6,2.6,4.6", "--camera-focal-point", "0,0.35,0", "--camera-view-angle", "34")
GRAY, BLUE = ("--background", "0.735,0.735,0.735"), ("--background", "0.5,0.55,0.75")  # as the fog
FOGS = (("--fog", "none", *GRAY), ("--fog", "linear:4,24", *GRAY), ("--fog", "exp:0.1", *GRAY), ("--fog", "exp2:0.08:color=0.5,0.55,0.75", *BLUE))
COLUMNS = ("--camera-position", "0.6,1.7,5", "--camera-focal-point", "-0.3,1.1,-6", "--camera-view-angle", "40", "--shadows", *SUN)


LAMPS = (("photometric-directional", "photometric-directional:-1,-1.3,-0.75:intensity=3"),
         ("photometric-point", "photometric-point:0.2,1.4,0.9:intensity=5"),
         ("spot, inner=0 outer=28", "photometric-spot:2.2,3.2,2.4:direction=-2.2,-3.1,-2.2:inner=0:outer=28:intensity=60"),
         ("spot, inner=26 outer=28", "photometric-spot:2.2,3.2,2.4:direction=-2.2,-3.1,-2.2:inner=26:outer=28:intensity=60"),
         ("point", "point:0.2,1.4,0.9"), ("point, range=2.5", "point:0.2,1.4,0.9:range=2.5"),
         ("photometric-point, range=2.5", "photometric-point:0.2,1.4,0.9:intensity=5:range=2.5"),
         ("photometric-point, range=1.6", "photometric-point:0.2,1.4,0.9:intensity=5:range=1.6"))
LOW_SUN = ("--light", "directional:0,-0.55,0.85:color=0.9,0.9,0.9:specular=2.5,2.5,2.5", *AMBIENT)
WIDE = ("--camera-position", "0.2,1.7,2.6", "--camera-focal-point", "0,0.35,0", "--camera-view-angle", "75")


class Obj:
    """Writes faces with normals."""

    def __init__(self):
        self.lines, self.count = ["mtllib m.mtl"], 0

    def object(self, name, material):
        self.lines += [f"o {name}", f"usemtl {material}"]

    def face(self, points, normals):
        for p in points:
            self.lines.append("v {:.6f} {:.6f} {:.6f}".format(*p))
        for n in normals:
            self.lines.append("vn {:.6f} {:.6f} {:.6f}".format(*n))
        self.lines.append("f " + " ".join(f"{self.count + k}//{self.count + k}" for k in range(1, len(points) + 1)))
        self.count += len(points)

    def box(self, low, high):
        for axis in range(3):
            for sign in (0, 1):
                u, v = (axis + 1) % 3, (axis + 2) % 3
                normal = [0, 0, 0]
                normal[axis] = 2 * sign - 1
                points = []
                for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    p = [0, 0, 0]
                    p[axis], p[u], p[v] = (low, high)[sign][axis], (low, high)[a][u], (low, high)[b][v]
                    points.append(p)
                self.face(points if sign else points[::-1], [normal] * 4)

    def ring(self, at, rings, segments):
        """A surface of revolution about +Y: rings of (radius, height, normal outward, normal up)."""
        for (r0, y0, n0, m0), (r1, y1, n1, m1) in zip(rings, rings[1:]):
            for s in range(segments):
                a, b = (2 * math.pi * k / segments for k in (s, s + 1))
                corner = lambda r, y, t: (at[0] + r * math.cos(t), at[1] + y, at[2] - r * math.sin(t))
                normal = lambda n, m, t: (n * math.cos(t), m, -n * math.sin(t))
                self.face([corner(r0, y0, a), corner(r0, y0, b), corner(r1, y1, b), corner(r1, y1, a)],
                          [normal(n0, m0, a), normal(n0, m0, b), normal(n1, m1, b), normal(n1, m1, a)])

    def floor(self, half):
        self.object("floor", "floor")
        self.face([(-half, 0, half), (half, 0, half), (half, 0, -half), (-half, 0, -half)], [(0, 1, 0)] * 4)


def solids():
    obj = Obj()
    obj.floor(4)
    obj.object("ball", "red")
    arcs = [(math.pi * k / 32 - math.pi / 2) for k in range(33)]
    obj.ring((-0.6, 0.6, 0.3), [(0.6 * math.cos(a), 0.6 * math.sin(a), math.cos(a), math.sin(a)) for a in arcs], 64)
    obj.object("box", "blue")
    obj.box((0.5, 0, -0.9), (1.2, 0.9, -0.2))
    obj.object("bars", "gray")
    for k in range(6):
        x = -1.5 + 0.25 * k
        obj.box((x, 0, -1.2), (x + 0.08, 1.3, -1.12))
    return obj


def columns():
    obj = Obj()
    obj.floor(40)
    for k in range(12):
        for x in (-2, 2):
            obj.object(f"column {k} {x}", "red" if x < 0 else "blue")
            obj.ring((x, 0, 1 - 3 * k), [(0.35, 0, 1, 0), (0.35, 2.4, 1, 0)], 32)
            obj.box((x - 0.5, 2.4, 0.5 - 3 * k), (x + 0.5, 2.6, 1.5 - 3 * k))
    return obj


def write_cutoffs(picture, folder, program):
    """A thousand lamps without and with --light-cutoff, and below four times what that takes away."""
    scene = folder / "lamps.scene.toml"
    scene.write_text(world())
    parts = [(str(scene), "--light-cutoff", value) for value in ("0", "0.0003", "0.001", "0.004")]
    lost = [(part, (str(scene), "--light-cutoff", "0"), 4) for part in parts]
    write_sheet(picture, [parts, lost], 200, 112, program, samples=4, colors=64, columns=("light-cutoff 0", "0.0003", "0.001", "0.004"),
                lines=("", "4 x lost"))


def write_model(scene, folder):
    (folder / "m.mtl").write_text("".join(f"newmtl {m}\nKd {c}\nKs 0.3 0.3 0.3\nNs 30\n" for m, c in (
        ("floor", "0.8 0.78 0.74"), ("red", "0.8 0.35 0.3"), ("blue", "0.35 0.5 0.8"), ("gray", "0.7 0.7 0.7"))))
    (folder / "scene.obj").write_text("\n".join(scene.lines) + "\n")
    return str(folder / "scene.obj")


def write_solids(subject, picture, program):
    """The solids under lights of both kinds, with and without an end; or seen from here and from infinity."""
    with tempfile.TemporaryDirectory() as folder:
        model = write_model(solids(), pathlib.Path(folder))
        if subject == "occlusion":
            around = (model, *SOLIDS, "--light", "ambient:0.9,0.9,0.9")
            tiles = [around, *((*around, "--ambient-occlusion", *radius) for radius in
                               ((), ("--ambient-occlusion-radius", "0.1"), ("--ambient-occlusion-radius", "0.8")))]
            return write_sheet(picture, [tiles], 240, 180, program, samples=4,
                               columns=("ambient light", "ambient-occlusion", "radius 0.1 m", "radius 0.8 m"))
        if subject == "ranges":
            tiles = [(model, *SOLIDS, "--shadows", "--light", light, *AMBIENT) for _, light in LAMPS]
            words = [name for name, _ in LAMPS]
            return write_sheet(picture, [tiles[:4], tiles[4:]], 180, 120, program, below=[words[:4], words[4:]])
        here, far = (model, *WIDE, *LOW_SUN), (model, *WIDE, *LOW_SUN, "--viewer-infinity")
        write_sheet(picture, [[here, far, (here, far, 3)]], 240, 180, program, columns=("", "viewer-infinity", "3 x difference"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("subject", choices=("shadows", "fog", "cutoff", "ranges", "viewer", "occlusion"))
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    if options.subject in ("ranges", "viewer", "occlusion"):
        return write_solids(options.subject, options.picture, options.program)
    scene, camera, parts = (solids(), SOLIDS, SHADOWS) if options.subject == "shadows" else (columns(), COLUMNS, FOGS)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if options.subject == "cutoff":
            return write_cutoffs(options.picture, folder, options.program)
        write_model(scene, folder)
        pictures = [(str(folder / "scene.obj"), *camera, *arguments) for arguments in parts]
        write_sheet(options.picture, [pictures[first:first + 4] for first in range(0, len(pictures), 4)], WIDTH, HEIGHT, options.program)


if __name__ == "__main__":
    main()
