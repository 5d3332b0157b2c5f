#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `rakelight smooth`, `render` and others with --border-distance: parts whose borders run along each other without shared vertices.

  near_borders_test.py PROGRAM [unittest arguments]"""
import json
import math
import struct

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
import border_scenes  # noqa: E402

RINGS, GAP = 4, 0.001
SIZE = ("--resolution", "64,64")


def half_tube(first_deg, rings, gap):
    """Points and faces (from 0) of half of a tube of radius 1 about z; 9 points a ring, the first and the last at its borders."""
    points = [(math.cos(math.radians(first_deg + 22.5 * k)) + gap, math.sin(math.radians(first_deg + 22.5 * k)), 2 * ring / rings)
              for ring in range(rings + 1) for k in range(9)]
    corners = [9 * ring + k for ring in range(rings) for k in range(8)]
    return points, [f for a in corners for f in ((a, a + 1, a + 10), (a, a + 10, a + 9))]


def halves(gap=GAP):
    """An OBJ file of a tube of two halves; the second has twice as many rings."""
    text, base = "", 1
    for name, first_deg, rings, shift in (("left", 90, RINGS, 0), ("right", -90, 2 * RINGS, gap)):
        points, faces = half_tube(first_deg, rings, shift)
        text += f"o {name}\n" + "".join("v %.7f %.7f %.7f\n" % p for p in points)
        text += "".join("f %d %d %d\n" % tuple(base + v for v in face) for face in faces)
        base += len(points)
    return text


def obj_normals(path):
    """{position: text of its normal} of each object."""
    points, normals, objects = [], [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["vn"]:
            normals.append(" ".join(words[1:]))
        elif words[:1] == ["o"]:
            objects.append({})
        elif words[:1] == ["f"]:
            for word in words[1:]:
                v, _, n = word.split("/")
                objects[-1][points[int(v) - 1]] = normals[int(n) - 1]
    return objects


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def seam_deg(left, right):
    """The largest angle along the border at the top between the second half's normals and the first one's, interpolated."""
    border = {p[2]: tuple(map(float, n.split())) for p, n in left.items() if abs(p[0]) < 1e-3 and p[1] > 0}
    largest = 0
    for p, n in right.items():
        if abs(p[0]) > 2 * GAP or p[1] < 0:
            continue
        z = p[2] * RINGS / 2
        a, b = border[math.floor(z) * 2 / RINGS], border[math.ceil(z) * 2 / RINGS]
        between = unit([x + y for x, y in zip(a, b)])
        dot = sum(x * y for x, y in zip(between, unit(tuple(map(float, n.split())))))
        largest = max(largest, math.degrees(math.acos(max(-1, min(1, dot)))))
    return largest


def read_glb(path):
    data = path.read_bytes()
    size = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + size]), data[28 + size:]


class NearBorders(program.Case):
    def setUp(self):
        super().setUp()
        self.write("plain.obj", halves())
        self.fine("smooth", "plain.obj", "-o", "model.obj", "--normals", "object")

    def fine(self, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual(result.code, 0, result.err)
        return result

    def smoothed(self, name, *words):
        self.fine("smooth", "model.obj", "-o", name, "--border-distance", 2 * GAP, *words)
        return self.folder / name

    def test_smooth_joins_authored_and_made_normals(self):
        before = obj_normals(self.folder / "model.obj")
        self.assertGreater(seam_deg(*before), 20)
        for normals in ("seams", "model"):
            after = obj_normals(self.smoothed("out.obj", "--normals", normals))
            self.assertLess(seam_deg(*after), 0.05, normals)
            for half, joined in zip(before, after):
                for p, n in half.items():
                    if abs(p[0]) > 2 * GAP:
                        self.assertEqual(joined[p], n, "every digit away from the border")
        apart = obj_normals(self.smoothed("out.obj", "--normals", "object"))
        self.assertGreater(seam_deg(*apart), 20, "two objects")

    def test_smooth_writes_other_formats_alike(self):
        wanted = obj_normals(self.smoothed("out.obj"))
        tree, data = read_glb(self.smoothed("out.glb"))
        for mesh, half in zip(tree["meshes"], wanted):
            attributes = mesh["primitives"][0]["attributes"]
            places, normals = (tree["accessors"][attributes[name]] for name in ("POSITION", "NORMAL"))
            at = [tree["bufferViews"][a["bufferView"]].get("byteOffset", 0) + a.get("byteOffset", 0) for a in (places, normals)]
            by_place = {tuple(round(x, 4) for x in p): n for p, n in half.items()}
            for i in range(places["count"]):
                p, n = (struct.unpack_from("<3f", data, start + 12 * i) for start in at)
                text = by_place[tuple(round(x, 4) for x in p)]
                for x, y in zip(n, map(float, text.split())):
                    self.assertAlmostEqual(x, y, 6)
        self.assertNotEqual(self.smoothed("out.ply").read_bytes(), (self.fine("smooth", "model.obj", "-o", "apart.ply"), (self.folder / "apart.ply").read_bytes())[1])

    def test_smooth_says_what_it_did(self):
        done = self.fine("smooth", "model.obj", "-o", "out.obj", "-v", "--border-distance", 2 * GAP)
        self.assertIn("18 border vertices follow 10 leading ones; 28 normals turn (at most", done.err)
        row = json.loads(self.fine("smooth", "model.obj", "-o", "out.obj", "--border-distance", 2 * GAP, "--json").out)["rows"][0]
        self.assertEqual((row["borders"]["leading"], row["borders"]["following"], row["borders"]["turned"]), (10, 18, 28))
        self.assertEqual([m["normals"] for m in row["meshes"]], ["turned", "turned"])
        row = json.loads(self.fine("smooth", "model.obj", "-o", "out.obj", "--json").out)["rows"][0]
        self.assertNotIn("borders", row)
        done = self.fine("smooth", "model.obj", "-o", "out.obj", "--border-distance", GAP / 2)
        self.assertIn("--border-distance 0.0005 turns nothing", done.err)
        self.assertIn("inspect` proposes a distance", done.err)
        self.assertIn("turns nothing: faces are flat", self.fine("smooth", "model.obj", "-o", "out.obj", "--border-distance", 1, "--normals", "face").err)
        self.fine("smooth", "model.obj", "--preview", "page.html", "--border-distance", 2 * GAP)
        page = (self.folder / "page.html").read_text()
        self.assertIn("28 normals turn", page)
        seams = page.split("run along each other without shared vertices")[1].split("</table>")[0]
        before, after = (float(seams.split(f">{name}</td><td>")[1].split("<")[0]) for name in ("before", "after"))
        self.assertGreater(before, 20)
        self.assertLess(after, 0.05)

    def test_wrong_values_and_other_names_are_answered(self):
        for verb, more in (("smooth", ("-o", "x.obj")), ("render", ("-o", "x.png"))):
            for value, word in (("-1", "0 or more"), ("inf", "not a number"), ("nan", "not a number"), ("far", "not a number")):
                self.check_refused(self.run_program(verb, "model.obj", *more, "--border-distance", value), 2, "--border-distance", word)
            self.check_refused(self.run_program(verb, "model.obj", *more, "--gap", "1"), 2, "--gap", "--border-distance")

    def jump(self, *words):
        """The largest change of the normal channel from one pixel to the next, across the tube as seen from above."""
        self.fine("render", *words, "-o", "a.png", *SIZE, "--view", "top", "--samples", "1", "--channels", "normal", "--channel-files", "png")
        width, _, channels, rows = program.png(self.folder / "a.normal.png")
        row = rows[32]
        pixels = [row[channels * x:channels * x + 3] for x in range(width // 4, width - width // 4)]
        return max(max(abs(a - b) for a, b in zip(p, q)) for p, q in zip(pixels, pixels[1:]))

    def test_pictures_have_no_seam(self):
        near = ("--border-distance", 2 * GAP)
        open_seam = self.jump("model.obj")
        self.assertGreater(open_seam, 35)
        for words in (("model.obj",), ("model.obj", "--normals", "model"), ("model.obj", "--normals", "seams"), ("plain.obj",)):
            if words[0] == "plain.obj":
                words += ("--normals", "model")
            self.assertLess(self.jump(*words, *near), 15, words)
        self.assertEqual(self.jump("model.obj", "--normals", "file", *near), open_seam)
        told = self.fine("render", "model.obj", "-o", "a.png", *SIZE, "--normals", "file", *near, "-v").err
        self.assertIn("--border-distance turns nothing: --normals file keeps what the file has", told)
        self.assertIn("turns nothing", self.fine("render", "model.obj", "-o", "a.png", *SIZE, "--border-distance", GAP / 2).err)

    def test_the_world_file_has_the_key_and_other_verbs_the_option(self):
        self.write("world.scene.toml", f'[[model]]\nfile = "model.obj"\n[render]\nborder-distance = {2 * GAP}\n')
        self.assertLess(self.jump("world.scene.toml"), 15)
        self.assertGreater(self.jump("world.scene.toml", "--border-distance", "0"), 35)
        self.assertIn("28 normals turn", self.fine("smooth", "world.scene.toml", "-o", "world.obj", "-v").err)
        near = ("--border-distance", 2 * GAP)
        self.fine("explain", "model.obj", "--pixel", "30,30", *SIZE, *near)
        self.fine("stages", "model.obj", "-o", "stages", *SIZE, *near)
        self.fine("render", "model.obj", "-o", "a.png", *SIZE, *near)
        self.assertEqual(self.fine("compare", "a.png", "model.obj", "--look", "plain", *SIZE, *near).code, 0)


    def test_parts_that_only_lie_near_one_another_keep_every_byte(self):
        for path, scene in border_scenes.write(self.folder):
            for normals in ("model", "seams"):
                name = pathlib.Path(path).name
                self.fine("smooth", name, "-o", "model.obj", "--normals", "model")
                source = name if normals == "model" else "model.obj"
                for out, more in (("without.obj", ()), ("with.obj", ("--border-distance", scene.distance))):
                    self.fine("smooth", source, "-o", out, "--normals", normals, *more)
                same = (self.folder / "without.obj").read_bytes() == (self.folder / "with.obj").read_bytes()
                self.assertEqual(same, not scene.joins, (scene.name, normals))

    def test_the_swords_and_shields_of_the_knight_stay_apart(self):
        knight = pathlib.Path(__file__).resolve().parents[3] / "data/knight/Knight_noNormals.glb"
        for distance in (0.0091, 0.1):
            told = json.loads(self.fine("smooth", knight, "-o", "k.glb", "--border-distance", distance, "--json").out)
            self.assertEqual(told["rows"][0]["borders"]["turned"], 0, distance)

    def test_flat_faces_that_somebody_authored_are_alike_for_all_verbs(self):
        points = ["0 0 0", "1 0 0", "1 1 0", "0 1 0", "0 1.01 0", "1 1.01 0", "1 1.8 0.6", "0 1.8 0.6"]
        self.write("flat.obj", "".join(f"v {p}\n" for p in points) + "vn 0 0 1\nvn 0 -0.6048582 0.7963320\n"
                   "o a\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\no b\nf 5//2 6//2 7//2\nf 5//2 7//2 8//2\n")
        near = ("--border-distance", 0.05)
        self.assertNotIn("border_proposal", json.loads(self.fine("inspect", "flat.obj", "--json").out)["rows"][0])
        told = json.loads(self.fine("smooth", "flat.obj", "-o", "out.obj", *near, "--json").out)
        self.assertEqual(told["rows"][0]["borders"]["turned"], 0)
        self.assertEqual(self.run_program("inspect", "out.obj", "--check", *near).code, 0)
        self.fine("smooth", "flat.obj", "-o", "model.obj", "--normals", "model", *near)
        self.assertNotEqual((self.folder / "model.obj").read_text(), (self.folder / "out.obj").read_text())


if __name__ == "__main__":
    program.main()
