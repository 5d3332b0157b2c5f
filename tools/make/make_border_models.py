#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A model cut into parts that are then meshed anew one by one: borders that run along each other and share no vertices.

  make_border_models.py MODEL.obj OUT_FOLDER [--plane X,Y,Z:SHARE ...] [--subdivide K[:PARTS] ...] [--decimate SHARE[:PARTS] ...]
                        [--flat] [--gap G] [--noise S] [--normals] [--program PROGRAM]

Writes, with NAME of the model,
  NAME-uncut.obj      the model as it is: one object, no normals;
  NAME-parts.obj      an object `part_I` for each cell that the planes cut it into, without normals (--normals: each part's own, smooth);
  NAME-reference.obj  the same vertices and triangles as NAME-parts.obj with normals: those of the uncut model along the cuts, each part's
                      own elsewhere. What a picture of NAME-parts.obj differs from its picture by is the normals along the cuts alone.
--plane: a normal, and the share of the model's extent along it where the plane lies (default 0,1,0:0.5). Parts of parallel planes are
  numbered along the normal.
--subdivide: each edge becomes K, on the curved surface of PN triangles through the model's vertices (--flat: on the flat triangles).
  The whole model is subdivided and then cut, as a part is that was tessellated from the surface itself.
--decimate: the part keeps that share of its triangles, by quadric edge collapses; its border stays near the cut, with fewer vertices.
  PARTS: numbers as 0,2, or even, or odd (default: all). --decimate comes after --subdivide.
--gap, --noise: in mean edge lengths of the model: parts are pulled apart along the normals of the planes; vertices are moved at random,
  by the same numbers in every run.

Positions alone are read: texture coordinates, normals and materials are dropped, and objects become one. Other formats than OBJ are
converted by `PROGRAM smooth` first. Only the standard library is needed."""
import argparse
import math
import pathlib
import subprocess
import sys
import tempfile

from border_mesh import BadModel, Mesh, add, length, mean_edge, open_edges, read_obj, scaled, unit, vertex_normals, welded, write_obj
from nearest import Nearest, blend
from plane_cut import cells, cut, plane_at
from pn_triangles import subdivided
from quadric_decimation import decimated

PROGRAM = pathlib.Path(__file__).resolve().parents[2] / "build/release/rakelight"


class Noise:
    """Numbers from -1 to 1: a linear congruential generator with Knuth's constants for MMIX."""

    def __init__(self):
        self.state = 1

    def next(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 33) / 2**30 - 1

    def vector(self, size):
        return tuple(size * self.next() for _ in range(3))


def plane_of(word):
    try:
        normal, _, share = word.partition(":")
        normal, share = tuple(float(x) for x in normal.split(",")), float(share or "0.5")
        if len(normal) != 3 or not 0 < length(normal) < math.inf or not 0 < share < 1:
            raise ValueError
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{word}' is not X,Y,Z:SHARE with a share between 0 and 1") from None
    return unit(normal), share


def chosen(number, low, high):
    """How --subdivide and --decimate read NUMBER[:PARTS]. @return (number, is_chosen(part))"""
    def read(word):
        value, _, parts = word.partition(":")
        try:
            value = number(value)
            if not low <= value <= high:
                raise ValueError
            if parts in ("", "even", "odd"):
                return value, lambda i: parts == "" or i % 2 == (parts == "odd")
            wanted = {int(x) for x in parts.split(",")}
            return value, lambda i: i in wanted
        except ValueError:
            raise argparse.ArgumentTypeError(f"'{word}' is not NUMBER[:PARTS] with a number from {low} to {high}") from None
    return read


def amount(word):
    try:
        value = float(word)
        if 0 <= value <= 10:
            return value
    except ValueError:
        pass
    raise argparse.ArgumentTypeError(f"'{word}' is not a number from 0 to 10")


def load(path, program):
    """All of a model as one mesh."""
    if path.suffix.lower() == ".obj":
        meshes = read_obj(path)
    else:
        with tempfile.TemporaryDirectory() as folder:
            converted = pathlib.Path(folder) / "model.obj"
            try:
                done = subprocess.run([program, "smooth", path, "-o", converted, "--quiet"], capture_output=True, text=True)
            except OSError as error:
                raise BadModel(f"{path}: not OBJ, and {program}: {error.strerror}") from None
            if done.returncode:
                raise BadModel((done.stderr.strip().splitlines() or [f"{path}: not converted"])[-1])
            meshes = read_obj(converted)
    return welded("uncut", [[m.positions[i] for i in t] for m in meshes for t in m.triangles])


def last_of(choices, part, otherwise):
    return ([value for value, is_chosen in choices if is_chosen(part)] or [otherwise])[-1]


def parts_of(uncut, planes, options):
    """{sides of the planes: part}, each meshed by itself."""
    normals, whole, order = vertex_normals(uncut.positions, uncut.triangles), {}, sorted(cells(cut(uncut, planes), planes))
    parts = {}
    for i, sides in enumerate(order):
        k = last_of(options.subdivide, i, 1)
        if k not in whole:
            whole[k] = cells(cut(subdivided(uncut, normals, k, not options.flat), planes), planes)
        if sides not in whole[k]:
            raise BadModel(f"part {i}: nothing is left of it once it is subdivided")
        part = decimated(whole[k][sides], last_of(options.decimate, i, 1.0))
        parts[sides] = Mesh(f"part_{i}", part.positions, part.triangles)
    return parts


def reference_normals(part, uncut, normals, surface, planes, edge):
    """The part's own, but at borders by a plane those of the uncut model at the nearest point."""
    own = vertex_normals(part.positions, part.triangles)
    for v in sorted({i for a, b, _ in open_edges(part.triangles) for i in (a, b)}):
        p = part.positions[v]
        if min(abs(sum(x * y for x, y in zip(n, p)) - d) for n, d in planes) < edge / 2:
            found = surface.find(p, 4 * edge)
            if found:
                own[v] = unit(blend(found[2], [normals[i] for i in uncut.triangles[found[1]]]), own[v])
    return own


def moved(part, sides, planes, gap, noise_size, noise):
    shift = (0.0, 0.0, 0.0)
    for side, (normal, _) in zip(sides, planes):
        shift = add(shift, scaled(normal, side * gap / 2))
    return Mesh(part.name, [add(add(p, shift), noise.vector(noise_size)) for p in part.positions], part.triangles)


def report(parts, edge):
    """What each part has, and how far its border lies from the others'."""
    rims = [[(m.positions[a], m.positions[b]) for a, b, _ in open_edges(m.triangles)] for m in parts]
    for i, mesh in enumerate(parts):
        line = f"  {mesh.name}: {len(mesh.positions)} vertices, {len(mesh.triangles)} triangles, {len(rims[i])} border edges"
        others = Nearest([s for k, rim in enumerate(rims) if k != i for s in rim])
        found = sorted(f[0] / edge for f in (others.find(a, 3 * edge) for a, _ in rims[i]) if f)
        if found:
            line += f"; distance to other borders: median {found[len(found) // 2]:.3f}, most {found[-1]:.3f} mean edges"
        print(line)


def parsed():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--plane", type=plane_of, action="append", metavar="X,Y,Z:SHARE")
    parser.add_argument("--subdivide", type=chosen(int, 1, 16), action="append", default=[], metavar="K[:PARTS]")
    parser.add_argument("--decimate", type=chosen(float, 0.001, 1), action="append", default=[], metavar="SHARE[:PARTS]")
    parser.add_argument("--flat", action="store_true")
    parser.add_argument("--gap", type=amount, default=0.0, metavar="G")
    parser.add_argument("--noise", type=amount, default=0.0, metavar="S")
    parser.add_argument("--normals", action="store_true")
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    return parser.parse_args()


def make(options):
    uncut = load(options.model, options.program)
    edge = mean_edge(uncut.positions, uncut.triangles)
    planes = [plane_at(uncut, *plane) for plane in options.plane or [((0.0, 1.0, 0.0), 0.5)]]
    parts = parts_of(uncut, planes, options)
    if len(parts) < 2:
        raise BadModel(f"{options.model}: the planes leave it in one part")
    normals = vertex_normals(uncut.positions, uncut.triangles)
    surface = Nearest([[uncut.positions[i] for i in t] for t in uncut.triangles])
    references = [reference_normals(p, uncut, normals, surface, planes, edge) for p in parts.values()]
    noise = Noise()
    placed = [moved(part, sides, planes, options.gap * edge, options.noise * edge, noise) for sides, part in parts.items()]
    options.folder.mkdir(parents=True, exist_ok=True)
    own = [vertex_normals(m.positions, m.triangles) if options.normals else None for m in placed]
    for kind, meshes, remark in (("uncut", [(uncut, None)], "the model as it is"), ("parts", list(zip(placed, own)), "its parts, meshed one by one"),
                                 ("reference", list(zip(placed, references)), "its parts with normals of the uncut model along the cuts")):
        path = options.folder / f"{options.model.stem}-{kind}.obj"
        write_obj(path, meshes, f"{options.model.name} by tools/make/make_border_models.py of Rakelight: {remark}")
        print(f"{path}: {len(meshes)} object{'s' * (len(meshes) > 1)}, {sum(len(m.triangles) for m, _ in meshes)} triangles")
    print(f"mean edge of the uncut model: {edge:.6g}")
    report(placed, edge)


def main():
    try:
        make(parsed())
    except (BadModel, OSError) as error:
        sys.exit(f"make_border_models.py: {error}")


if __name__ == "__main__":
    main()
