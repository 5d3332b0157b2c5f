#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What files say of smooth and hard edges, and of the colors of faces: smoothing groups of FBX and OBJ, OFF.

  groups_test.py PROGRAM [unittest arguments]"""
import json
import math
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import fbx
import program
import sphere_halves as reader

FIELD = pathlib.Path(os.environ.get("RAKELIGHT_SHARED", pathlib.Path(__file__).resolve().parents[4] / "shared")) / "repro/field"
SIDES = 12
TWO = [1] * 6 + [2] * 6


def edges_of(hard):
    """(corners where the edges of the barrel begin, 1 for each smooth one); those upright at the given points are hard."""
    edges = [corner for i in range(SIDES) for corner in (4 * i, 4 * i + 2, 4 * i + 3)]  # below, above, upright at the point i
    return edges, [0 if corner % 4 == 3 and corner // 4 in hard else 1 for corner in edges]


class Groups(program.Case):
    def corner_normals(self, model, *options):
        """{(point 0..11, side 0..11): normals} of a barrel's corners after `smooth`, in the plane of the rings."""
        result = self.run_program("smooth", model, "-o", "out.glb", *options)
        if "built without" in result.err:
            self.skipTest("this build reads no FBX")
        self.assertEqual(result.code, 0, result.err)
        self.assertEqual(self.run_program("convert", "out.glb", "-o", "out.obj").code, 0)  # triangles
        corners, found = reader.obj_corners(self.folder / "out.obj"), {}
        for t in range(0, len(corners), 3):
            numbers = [round(math.degrees(math.atan2(p[1], p[0])) / 30) % SIDES for p, _ in corners[t:t + 3]]
            side = min(set(numbers)) if max(numbers) - min(numbers) == 1 else SIDES - 1
            for number, (_, n) in zip(numbers, corners[t:t + 3]):
                self.assertAlmostEqual(n[2], 0, 5)
                found.setdefault((number, side), set()).add(round(math.degrees(math.atan2(n[1], n[0])), 2))
        return found

    def check(self, found, hard):
        """Smooth corners look along their radius, those at hard edges along their side."""
        self.assertEqual(len(found), 2 * SIDES)
        for (point, side), angles in found.items():
            wanted = 30 * side + 15 if point in hard else 30 * point
            for angle in angles:
                self.assertAlmostEqual((angle - wanted + 180) % 360 - 180, 0, delta=0.05, msg=(point, side))

    def test_groups_of_polygons(self):
        for form in ("text", "plain", "packed", "wide"):
            for smoothing, hard in ((TWO, {0, 6}), ([0] * SIDES, set(range(SIDES))), ([4] * SIDES, set()),
                                    ([1] * 3 + [3] * 3 + [2] * 6, {0}), ([-1 << 31] * 6 + [1] * 6, {0, 6})):
                with self.subTest(form=form, smoothing=smoothing):
                    fbx.write(self.folder / "a.fbx", fbx.barrel(smoothing), form)
                    self.check(self.corner_normals("a.fbx"), hard)

    def test_edges(self):
        for form in ("text", "packed"):
            for hard in ({0, 6}, set(), {2, 3, 9}, set(range(SIDES))):
                with self.subTest(form=form, hard=hard):
                    edges, smoothing = edges_of(hard)
                    fbx.write(self.folder / "a.fbx", fbx.barrel(smoothing, "ByEdge", edges), form)
                    self.check(self.corner_normals("a.fbx"), hard)

    def test_two_materials_are_two_meshes_of_one_object(self):
        materials = [i % 2 for i in range(SIDES)]
        fbx.write(self.folder / "a.fbx", fbx.barrel(TWO, materials=materials), "packed")
        self.check(self.corner_normals("a.fbx"), {0, 6})
        edges, smoothing = edges_of({0, 6})
        fbx.write(self.folder / "b.fbx", fbx.barrel(smoothing, "ByEdge", edges, materials=materials))
        self.check(self.corner_normals("b.fbx"), {0, 6})

    def test_normals_of_the_file_go_before_groups(self):
        radial = [x for i in range(SIDES) for k in (i, i + 1, i + 1, i) for x in (math.cos(math.pi * k / 6), math.sin(math.pi * k / 6), 0.0)]
        fbx.write(self.folder / "a.fbx", fbx.barrel(TWO, normals=radial))
        self.check(self.corner_normals("a.fbx"), set())

    def test_what_cannot_be_read_is_said(self):
        fbx.write(self.folder / "a.fbx", fbx.barrel(TWO, "ByVertice"))
        self.corner_normals("a.fbx")
        self.assertIn("smoothing groups that cannot be read are left out", self.run_program("smooth", "a.fbx", "-o", "b.obj").err)
        fbx.write(self.folder / "short.fbx", fbx.barrel(TWO[:5]))
        self.assertIn("smoothing groups that cannot be read are left out", self.run_program("smooth", "short.fbx", "-o", "b.obj").err)

    def test_the_fields_files(self):
        if not FIELD.is_dir():
            self.skipTest("the shared models are not there")
        self.check(self.corner_normals(FIELD / "fbx_sm_two.fbx"), {0, 6})
        self.check(self.corner_normals(FIELD / "fbx_sm_zero.fbx"), set(range(SIDES)))

    # --- OBJ ---

    def barrel_obj(self, line):
        points = [(math.cos(math.pi * i / 6), math.sin(math.pi * i / 6), z) for z in (0, 2) for i in range(SIDES)]
        faces = [f"f {i + 1} {(i + 1) % SIDES + 1} {SIDES + (i + 1) % SIDES + 1} {SIDES + i + 1}\n" for i in range(SIDES)]
        self.write("a.obj", "".join(f"v {x} {y} {z}\n" for x, y, z in points) + "o a\n" + line + "".join(faces))
        return "a.obj"

    def test_on_is_group_1(self):
        for word, hard in (("on", set()), ("1", set()), ("ON", set()), ("off", set(range(SIDES))), ("Off", set(range(SIDES))), ("0", set(range(SIDES)))):
            with self.subTest(word=word):
                name = self.barrel_obj(f"s {word}\n")
                self.check({k: v for k, v in self.corner_normals(name, "--crease-angle", "0").items()}, hard)
                self.assertNotIn("not a number", self.run_program("smooth", name, "-o", "b.glb").err)

    # --- OFF ---

    def test_faces_of_off_have_their_colors(self):
        """Both looks: red below the diagonal, blue above it."""
        self.write("c.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n")
        result = self.run_program("render", "c.off", "-o", "c.png", "--resolution", "64,64", "--shading", "unlit", "--camera-position", "0.5,0.5,2",
                                  "--camera-focal-point", "0.5,0.5,0", "--json")
        self.assertEqual(result.code, 0, result.err)
        _, _, channels, rows = program.png(self.folder / "c.png")
        pixel = lambda x, y: tuple(rows[y][channels * x:channels * x + 3])  # noqa: E731
        self.assertEqual((pixel(40, 36), pixel(24, 28)), ((255, 0, 0), (0, 0, 255)))
        self.assertFalse([r for r in json.loads(result.out)["rows"][0]["remarks"] if r.get("kind", r.get("remark")) == "dropped"])
        if FIELD.is_dir():
            self.assertEqual((FIELD / "face_colors.off").read_text(), (self.folder / "c.off").read_text())

    # --- Blend ---

    def test_what_to_do_with_a_blend_file_that_is_not_read(self):
        for number, data in enumerate((b"BLENDER17-01v0500" + bytes(200), b"BLENDER-v405", b"BLENDER-v300ENDB" + bytes(40), b"(\xb5/\xfd" + bytes(60),
                                       b"BLENDER-v293TEST" + (200).to_bytes(4, "little") + bytes(20))):
            (self.folder / f"{number}.blend").write_bytes(data)
            result = self.run_program("render", f"{number}.blend", "-o", "a.png")
            if "built without" in result.err:
                self.skipTest("this build reads no Blend files")
            self.check_refused(result, 4, f"{number}.blend", "export glTF")


if __name__ == "__main__":
    program.main()
