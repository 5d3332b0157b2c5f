#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Models for borders that run along each other and share no vertices: tools/make/make_border_models.py, tools/pictures/border_pictures.py and
tests/support/border_scenes.py make what their words say."""
import json
import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tools/make"), str(ROOT / "tools/pictures"), str(ROOT / "tests/support")]
import border_pictures  # noqa: E402
import border_scenes  # noqa: E402
from border_mesh import add, cross_of, dot, length, mixed, open_edges, read_obj, sub, unit, vertex_normals  # noqa: E402
from nearest import Nearest, blend  # noqa: E402

BALL = "builtin:sphere:tolerance=0.01"


def area(meshes):
    return sum(length(cross_of(m.positions, t)) / 2 for m in meshes for t in m.triangles)


def border(mesh):
    return {mesh.positions[i] for a, b, _ in open_edges(mesh.triangles) for i in (a, b)}


def degrees(a, b):
    return math.degrees(math.acos(max(-1.0, min(1.0, dot(a, b)))))


def file_normals(path):
    """{object: [(position, normal)]} of an OBJ whose corners are v//vn with equal numbers."""
    found, positions, normals = {}, [], []
    for line in path.read_text().splitlines():
        word, _, rest = line.partition(" ")
        if word == "o":
            name, found[rest] = rest, []
        elif word == "v":
            positions.append(tuple(map(float, rest.split())))
        elif word == "vn":
            normals.append(tuple(map(float, rest.split())))
            found[name].append((positions[len(normals) - 1], normals[-1]))
    return found


class BorderModels(program.Case):
    def make(self, model, folder, *options):
        return subprocess.run([sys.executable, ROOT / "tools/make/make_border_models.py", model, folder, "--program", program.PROGRAM, *options],
                              cwd=self.folder, capture_output=True, text=True, timeout=300)

    def made(self, folder, *options):
        """{kind: [Mesh]} of a ball."""
        done = self.make(BALL, folder, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.paths = {kind: next((self.folder / folder).glob(f"*-{kind}.obj")) for kind in ("uncut", "parts", "reference")}
        return {kind: read_obj(path) for kind, path in self.paths.items()}

    def test_a_cut_alone_leaves_the_surface_and_gives_both_sides_one_border(self):
        models = self.made("cut", "--plane", "0.3,1,0.2:0.6")
        low, high = models["parts"]
        self.assertGreater(len(border(low)), 20)
        self.assertEqual(border(low), border(high))
        self.assertAlmostEqual(area(models["parts"]), area(models["uncut"]), places=5)
        self.assertEqual(open_edges(models["uncut"][0].triangles), [])

    def test_parts_meshed_anew_meet_without_shared_vertices(self):
        options = ("--plane", "0,1,0:0.3", "--plane", "0,1,0:0.6", "--decimate", "0.2:0", "--subdivide", "3:2")
        models = self.made("anew", *options)
        coarse, same, fine = models["parts"]
        self.assertLess(len(border(coarse)), len(border(same)) / 1.5)
        self.assertGreater(len(border(fine)), len(border(same)) / 2 * 2.5)
        self.assertLess(len(border(fine) & border(same)), len(border(fine)) / 2)
        lost = 4 * math.pi - area(models["uncut"])
        self.assertLess(4 * math.pi - area(models["parts"]), 4 * lost, "decimation keeps the shape")
        rim = Nearest([[coarse.positions[a], coarse.positions[b]] for a, b, _ in open_edges(coarse.triangles)])
        for p in border(same):
            if p[1] < -0.2:
                self.assertIsNotNone(rim.find(p, 0.05))
        for p in fine.positions:
            self.assertLess(abs(length(p) - 1), 0.01, "on the curved surface")
        first = self.paths["parts"].read_bytes()
        self.made("again", *options)
        self.assertEqual(self.paths["parts"].read_bytes(), first)

    def test_the_reference_has_the_normals_of_the_whole_along_cuts_and_those_of_the_part_elsewhere(self):
        models = self.made("reference", "--decimate", "0.1:0")
        normals, own_off, whole_off = file_normals(self.paths["reference"]), [], []
        for part, whole in zip(models["parts"], models["reference"]):
            self.assertEqual((part.positions, part.triangles), (whole.positions, whole.triangles))
            rim, own = border(part), dict(zip(part.positions, vertex_normals(part.positions, part.triangles)))
            for p, n in normals[part.name]:
                if p in rim:
                    whole_off.append(degrees(n, unit(p)))
                    own_off.append(degrees(own[p], unit(p)))
                else:
                    self.assertLess(degrees(n, own[p]), 0.1)
        self.assertLess(max(whole_off), 1)
        self.assertGreater(max(own_off), 5)
        row = json.loads(self.run_program("inspect", self.paths["parts"], "--json").out)["rows"][0]
        self.assertEqual([(o["name"], o["normals"]) for o in row["objects"]], [("part_0", "no"), ("part_1", "no")])

    def test_gap_and_noise_are_in_mean_edges(self):
        plain, apart = self.made("plain")["parts"], self.made("apart", "--gap", "0.5", "--noise", "0.01", "--normals")["parts"]
        edge = float(self.make(BALL, "edge").stdout.split("mean edge of the uncut model: ")[1].split()[0])
        for side, a, b in zip((-1, 1), plain, apart):
            moves = [sub(q, p) for p, q in zip(a.positions, b.positions)]
            self.assertLess(max(abs(m[1] - side * edge / 4) for m in moves), 0.0101 * edge)
            self.assertGreater(max(abs(m[0]) for m in moves), 0.005 * edge)
        self.assertEqual(len(file_normals(self.paths["parts"])["part_1"]), len(apart[1].positions))

    def test_what_cannot_be_made_is_one_line(self):
        self.write("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 7\n")
        self.write("empty.obj", "v 0 0 0\n")
        self.write("flat.obj")
        for model, options, words in (("bad.obj", (), "line 3"), ("empty.obj", (), "no triangles"), ("none.obj", (), "No such file"),
                                      ("none.glb", (), "none.glb"), ("flat.obj", ("--plane", "0,0,1"), "one part"),
                                      ("flat.obj", ("--plane", "0,0,0:0.5"), "X,Y,Z:SHARE"), ("flat.obj", ("--decimate", "2"), "from 0.001 to 1"),
                                      ("flat.obj", ("--subdivide", "2:top"), "NUMBER[:PARTS]"), ("flat.obj", ("--gap", "-1"), "0 to 10")):
            done = self.make(model, "out", *options)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(words, done.stderr.splitlines()[-1])
            self.assertNotIn("Traceback", done.stderr)


class BorderPictures(program.Case):
    def test_pairs_face_each_other_across_borders_and_gaps_but_not_at_silhouettes(self):
        a, b, c, nothing = b"\1\0\0", b"\2\0\0", b"\3\0\0", b"\0\0\0"
        row = [a] * 4 + [nothing] + [b] * 4 + [c] * 4
        near, far = b"\x50\x50\x50", b"\xf0\x50\x50"
        places = [near] * 9 + [far] * 4
        pairs = border_pictures.facing_pairs(13, 1, b"".join(row), b"".join(places))
        self.assertEqual(pairs, [(2, 6)])
        self.assertEqual(list(border_pictures.band_of(13, 1, pairs, 1)), [0, 1, 1, 1, 0, 1, 1, 1, 0, 0, 0, 0, 0])


class BorderScenes(program.Case):
    def test_borders_lie_within_the_distance_with_other_normals_and_no_shared_vertex(self):
        for path, scene in border_scenes.write(self.folder):
            with self.subTest(scene.name):
                meshes = read_obj(path)
                self.assertEqual(len(meshes), len(scene.parts))
                self.assertLess(sum(len(m.triangles) for m in meshes), 110)
                self.assertEqual(len({p for m in meshes for p in m.positions}), sum(len(m.positions) for m in meshes))
                self.assertGreater(self.largest_turn(meshes, scene.distance), 10, "a join would show")
                self.assertEqual(self.run_program("check", path).code, 0)

    def largest_turn(self, meshes, distance):
        """[degrees] between the normals of a border edge's middle and of the nearest place on another part's border, where it is so near."""
        normals, most = [vertex_normals(m.positions, m.triangles) for m in meshes], 0
        rims = [[(a, b) for a, b, _ in open_edges(m.triangles)] for m in meshes]
        for i, rim in enumerate(rims):
            others = [(k, e) for k, edges in enumerate(rims) if k != i for e in edges]
            found = Nearest([[meshes[k].positions[v] for v in e] for k, e in others])
            for a, b in rim:
                near = found.find(mixed(meshes[i].positions[a], meshes[i].positions[b], 0.5), distance)
                if near:
                    k, e = others[near[1]]
                    most = max(most, degrees(unit(add(normals[i][a], normals[i][b])), unit(blend(near[2], [normals[k][v] for v in e]))))
        return most


if __name__ == "__main__":
    program.main()
