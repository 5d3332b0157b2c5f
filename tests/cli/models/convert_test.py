#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight convert`: positions and normals keep their bits, textures go along, and what is missing stays missing.

  convert_test.py PROGRAM [unittest arguments]"""
import json
import os
import pathlib
import struct
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import models
import program
import sphere_halves as sphere

KNIGHT = pathlib.Path(__file__).resolve().parents[3] / "data/knight/Knight_noNormals.glb"
SHARED = pathlib.Path(os.environ.get("RAKELIGHT_SHARED", pathlib.Path(__file__).resolve().parents[4] / "shared"))


def single(numbers):
    return tuple(struct.unpack("<f", struct.pack("<f", x))[0] for x in numbers)


def corners_of_glb(path):
    """(position, normal or None) of each corner of all primitives, unplaced."""
    tree, binary = sphere.read_glb(path)

    def values(number, code, width):
        accessor = tree["accessors"][number]
        view = tree["bufferViews"][accessor["bufferView"]]
        at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        size = struct.calcsize("<" + code) * width
        return [struct.unpack_from(f"<{width}{code}", binary, at + view.get("byteStride", size) * i) for i in range(accessor["count"])]

    corners = []
    for mesh in tree["meshes"]:
        for primitive in mesh["primitives"]:
            positions = values(primitive["attributes"]["POSITION"], "f", 3)
            normals = values(primitive["attributes"]["NORMAL"], "f", 3) if "NORMAL" in primitive["attributes"] else [None] * len(positions)
            code = {5121: "B", 5123: "H", 5125: "I"}[tree["accessors"][primitive["indices"]]["componentType"]]
            corners += [(positions[i], normals[i]) for (i,) in values(primitive["indices"], code, 1)]
    return corners


def corners_of_obj(path):
    return [(single(p), single(n) if n else None) for p, n in sphere.obj_corners(path)]


class Convert(program.Case):
    def setUp(self):
        super().setUp()
        sphere.write_obj(self.folder / "half.obj", 1)

    def convert(self, *words):
        result = self.run_program("convert", *words)
        self.assertEqual(result.code, 0, result.err)
        return result

    def test_positions_and_normals_keep_their_bits(self):
        """Normals that are wrong at the cut stay so, through every format."""
        right = corners_of_obj(self.folder / "half.obj")
        for chain in (("glb",), ("gltf", "glb"), ("glb", "obj", "glb"), ("obj", "glb"), ("ply", "glb"), ("ply", "obj", "gltf", "glb")):
            with self.subTest(chain=chain):
                name = "half.obj"
                for i, kind in enumerate(chain):
                    self.convert(name, "-o", f"{i}/half.{kind}")
                    name = f"{i}/half.{kind}"
                self.assertEqual(sorted(corners_of_glb(self.folder / name)), sorted(right))
        self.convert("0/half.glb", "-o", "back.obj")
        self.assertEqual(sorted(corners_of_obj(self.folder / "back.obj")), sorted(right))

    def test_missing_normals_stay_missing(self):
        self.write("plain.obj", program.TWO_PARTS)
        self.convert("plain.obj", "-o", "a.glb")
        self.assertTrue(all(n is None for _, n in corners_of_glb(self.folder / "a.glb")))
        self.convert("a.glb", "-o", "b.obj")
        self.assertNotIn("vn", (self.folder / "b.obj").read_text())
        self.convert("a.glb", "-o", "c.ply")
        self.assertNotIn(b"property float nx", (self.folder / "c.ply").read_bytes())
        self.assertIn("'rakelight smooth' makes them", self.convert("plain.obj", "-o", "a.glb", "-v").err)
        row = json.loads(self.convert("plain.obj", "-o", "a.glb", "--json").out)["rows"][0]
        self.assertEqual((row["meshes"], row["meshes_without_normals"], row["copied"]), (2, 2, False))

    def test_normals_of_a_part_alone_cannot_go_to_ply(self):
        self.write("plain.obj", program.TWO_PARTS)
        result = self.convert("plain.obj", "half.obj", "--as-one", "-o", "both.ply")
        self.assertIn("PLY cannot store normals that only some meshes have", result.err)

    def test_smoothing_groups_go_to_obj_where_there_are_no_normals(self):
        text = program.TWO_PARTS.replace("o left\n", "o left\ns 1\n").replace("o right\n", "o right\ns 7\n")
        self.write("groups.obj", text)
        self.convert("groups.obj", "half.obj", "--as-one", "-o", "both.obj")
        lines = (self.folder / "both.obj").read_text().splitlines()
        self.assertEqual([line for line in lines if line.startswith("s ")], ["s 1", "s 7", "s off"])
        self.write("none.obj", program.TWO_PARTS)
        self.convert("none.obj", "none.obj", "--as-one", "-o", "two.obj")
        self.assertFalse([line for line in (self.folder / "two.obj").read_text().splitlines() if line.startswith("s ")])

    def textured(self):
        """An OBJ file with a picture of 4 x 4 pixels; the picture's bytes."""
        models.write_quarters(self.folder / "paint.png", 4)
        self.write("m.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd paint.png\n")
        self.write("square.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nusemtl paint\nf 1/1/1 2/2/1 3/3/1\n")
        return (self.folder / "paint.png").read_bytes()

    def test_textures_go_along(self):
        picture = self.textured()
        self.convert("square.obj", "-o", "a.glb")
        tree, binary = sphere.read_glb(self.folder / "a.glb")
        view = tree["bufferViews"][tree["images"][0]["bufferView"]]
        self.assertEqual(binary[view.get("byteOffset", 0):view.get("byteOffset", 0) + view["byteLength"]], picture)
        self.assertIn("baseColorTexture", tree["materials"][0]["pbrMetallicRoughness"])
        self.convert("a.glb", "-o", "out/b.obj")
        named = next(line.split()[1] for line in (self.folder / "out/b.mtl").read_text().splitlines() if line.startswith("map_Kd"))
        self.assertEqual((self.folder / "out" / named).read_bytes(), picture)
        self.convert("a.glb", "-o", "out/b.obj")  # again: the same files
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()), sorted(["b.obj", "b.mtl", named]))
        for name in ("square.obj", "a.glb", "out/b.obj"):
            self.run_program("render", name, "-o", name + ".png", "--resolution", "64,64", "--shading", "unlit")
        pictures = [program.png(self.folder / (name + ".png")) for name in ("square.obj", "a.glb", "out/b.obj")]
        self.assertEqual(pictures[0], pictures[1])
        self.assertEqual(pictures[0], pictures[2])

    def test_textures_that_obj_has_no_place_for_are_said(self):
        self.textured()
        self.convert("square.obj", "-o", "a.gltf")
        self.assertNotIn("cannot store", self.convert("a.gltf", "-o", "b.obj").err)
        path = self.folder / "a.gltf"
        tree = json.loads(path.read_text())
        tree["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = tree["materials"][0]["occlusionTexture"] = {"index": 0}
        path.write_text(json.dumps(tree))
        for verb in ("convert", "smooth"):
            result = self.run_program(verb, "a.gltf", "-o", verb + ".obj")
            self.assertEqual(result.code, 0, result.err)
            self.assertEqual(result.err.count("OBJ cannot store textures of occlusion, metallic roughness"), 1, result.err)

    def stl(self):
        """A wedge of 4 by 1 by 2 on the plane z = 0."""
        p = [(0, 0, 0), (4, 0, 0), (0, 1, 0), (4, 1, 0), (0, 0, 2), (0, 1, 2)]
        faces = ((0, 2, 3), (0, 3, 1), (0, 4, 5), (0, 5, 2), (0, 1, 4), (2, 5, 3), (1, 3, 5), (1, 5, 4))
        text = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex %d %d %d\n" % p[i] for i in face) + "endloop\nendfacet\n" for face in faces)
        self.write("wedge.stl", "solid wedge\n" + text + "endsolid wedge\n")

    def test_what_is_made_of_an_stl_file_looks_like_it(self):
        self.stl()
        size = ("--resolution", "96,72", "--lighting", "lambert", "--light", "studio", "--color", "#c04020")  # no format stores materials as STL does

        def picture(name, *options):
            self.assertEqual(self.run_program(name, "-o", "picture.png", *size, *options).code, 0)
            return program.png(self.folder / "picture.png")

        def difference(a, b):
            return max(abs(x - y) for row, other in zip(a[3], b[3]) for x, y in zip(row, other))

        wanted = picture("wedge.stl")
        for verb in ("convert", "smooth"):
            for kind in ("glb", "gltf", "obj"):
                with self.subTest(verb=verb, kind=kind):
                    result = self.run_program(verb, "wedge.stl", "-o", "a." + kind)
                    self.assertIn("the model was turned", result.err)
                    self.assertLessEqual(difference(picture("a." + kind), wanted), 1)
                    self.assertEqual(self.run_program("compare", "wedge.stl", "a." + kind, "--max-error", "1/255", *size).code, 0)
            self.assertIn("--up +Z shows it upright", self.run_program(verb, "wedge.stl", "-o", "a.ply").err)
            self.assertLessEqual(difference(picture("a.ply", "--up", "+Z"), wanted), 1)
        self.assertGreater(difference(picture("wedge.stl", "--up", "+Y"), wanted), 10)
        self.write("w.scene.toml", '[[model]]\nfile = "wedge.stl"\n')
        lies = "lies on its side"
        self.assertIn(lies, self.run_program("w.scene.toml", "-o", "w.png", *size).err)
        self.assertNotIn(lies, self.run_program("w.scene.toml", "-o", "w.png", "--up", "+Z", *size).err)

    def test_a_file_that_is_there_is_not_overwritten_by_a_texture(self):
        self.textured()
        self.convert("square.obj", "-o", "a.glb")
        (self.folder / "out").mkdir()
        (self.folder / "out/b.0.png").write_bytes(b"mine")
        self.convert("a.glb", "-o", "out/b.obj")
        self.assertEqual((self.folder / "out/b.0.png").read_bytes(), b"mine")
        self.assertIn("map_Kd b.0-2.png", (self.folder / "out/b.mtl").read_text())

    def test_the_same_format_is_a_copy_with_its_files(self):
        picture = self.textured()
        row = json.loads(self.convert("square.obj", "-o", "out/x.obj", "--json").out)["rows"][0]
        self.assertTrue(row["copied"])
        self.assertEqual((self.folder / "out/x.obj").read_bytes(), (self.folder / "square.obj").read_bytes())
        self.assertEqual((self.folder / "out/paint.png").read_bytes(), picture)
        self.assertTrue((self.folder / "out/m.mtl").exists())
        self.convert(KNIGHT, "-o", "k.glb")
        self.assertEqual((self.folder / "k.glb").read_bytes(), KNIGHT.read_bytes())
        self.convert("half.obj", "-o", "h.ply")
        self.convert("h.ply", "-o", "i.ply")
        self.assertEqual((self.folder / "h.ply").read_bytes(), (self.folder / "i.ply").read_bytes())

    def test_all_of_a_gltf_is_kept_in_the_other_container(self):
        self.convert(KNIGHT, "-o", "k.gltf")
        self.convert("k.gltf", "-o", "again/k.glb")
        (a, data_a), (b, data_b) = (sphere.read_glb(p) for p in (KNIGHT, self.folder / "again/k.glb"))
        for tree in (a, b):
            tree.pop("buffers")
        self.assertEqual(a, b)
        self.assertEqual(data_a.rstrip(b"\0"), data_b.rstrip(b"\0"))

    def test_clips_and_skins_of_other_formats(self):
        model = next(iter(sorted((SHARED / "assets").rglob("*.fbx"))), None) if SHARED.is_dir() else None
        if model is None:
            self.skipTest("there is no FBX model")
        result = self.run_program("convert", model, "-o", "a.glb")
        if "built without" in result.err:
            self.skipTest("this build reads no FBX")
        self.assertEqual(result.code, 0, result.err)
        self.run_program("smooth", model, "-o", "b.glb")
        trees = [sphere.read_glb(self.folder / name)[0] for name in ("a.glb", "b.glb")]
        for part in ("animations", "skins", "materials", "nodes", "images"):
            self.assertEqual(len(trees[0].get(part, [])), len(trees[1].get(part, [])), part)

    # --- the command line ---

    def test_the_ending_of_the_output_says_what_is_meant(self):
        for words in (("half.obj", "-o", "a.glb"), ("half.obj", "-oa.glb"), ("-o", "a.glb", "half.obj"), ("half.obj", "--output=A.GLB"), ("half.obj", "--output", "a.ply")):
            with self.subTest(words=words):
                self.assertEqual(self.run_program(*words).code, 0)
        self.assertEqual(self.files(), ["A.GLB", "a.glb", "a.ply", "half.obj"])
        self.assertEqual(sorted(corners_of_glb(self.folder / "A.GLB")), sorted(corners_of_obj(self.folder / "half.obj")))
        self.assertEqual(self.run_program("half.obj", "-o", "a.png", "--resolution", "16,16").code, 0)
        self.assertEqual((self.folder / "a.png").read_bytes()[1:4], b"PNG")

    def test_other_inputs(self):
        self.convert("builtin:sphere:tolerance=0.1", "-o", "s.glb")
        self.convert("half.obj", "s.glb", "--as-one", "-o", "both.glb")
        self.assertEqual(len(sphere.read_glb(self.folder / "both.glb")[0]["meshes"]), 2)
        with open(self.folder / "s.glb", "rb") as data:
            done = subprocess.run([program.PROGRAM, "convert", "-", "-o", "t.glb"], cwd=self.folder, stdin=data, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(corners_of_glb(self.folder / "s.glb"), corners_of_glb(self.folder / "t.glb"))
        self.write("w.scene.toml", '[[model]]\nfile = "half.obj"\nposition = [1, 2, 3]\n')
        self.convert("w.scene.toml", "-o", "w.obj")
        moved, still = (sorted(p for p, _ in corners_of_obj(self.folder / name)) for name in ("w.obj", "half.obj"))
        for p, q in zip(moved, still):
            self.assertAlmostEqual(p[0] - q[0], 1, 5)

    def test_several_models(self):
        sphere.write_obj(self.folder / "other.obj", -1)
        self.convert("half.obj", "other.obj", "-o", "out/")
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()), ["half.glb", "other.glb"])
        self.check_refused(self.run_program("convert", "half.obj", "other.obj", "-o", "one.glb"), 2, "models need a name for each output")

    def test_what_cannot_be_written_is_one_line(self):
        self.check_refused(self.run_program("convert", "half.obj", "-o", "a.stl"), 2, "STL cannot store vertex normals")
        self.check_refused(self.run_program("convert", "half.obj", "-o", "a.fbx"), 2, "cannot write 'a.fbx'", "write .glb, .gltf, .obj or .ply")
        self.check_refused(self.run_program("half.obj", "-o", "a.fbx"), 2, "cannot write 'a.fbx'")
        self.check_refused(self.run_program("convert", "half.obj"), 2, "output")
        self.check_refused(self.run_program("convert", "none.obj", "-o", "a.glb"), 3, "none.obj")
        self.check_refused(self.run_program("render", "half.obj", "-o", "a.glb"), 2, "'a.glb' names a model, not a picture", "rakelight convert")
        self.assertEqual(self.files(), ["half.obj"])


if __name__ == "__main__":
    program.main()
