# SPDX-License-Identifier: Apache-2.0
"""Normals and tangents: the program's bits, and no copies."""
import gc
import json
import struct
from dataclasses import replace

import numpy as np
import pytest
from conftest import DATA

import rakelight


def accessors(path):
    """[{attribute: array}] of the primitives of a GLB file without compression."""
    data = path.read_bytes()
    size = struct.unpack_from("<I", data, 12)[0]
    document, binary = json.loads(data[20:20 + size]), data[28 + size:]
    kinds = {5126: np.float32, 5125: np.uint32, 5123: np.uint16}
    counts = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}

    def array(index):
        accessor = document["accessors"][index]
        view = document["bufferViews"][accessor["bufferView"]]
        assert not view.get("byteStride") or view["byteStride"] == 4 * counts[accessor["type"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        columns = counts[accessor["type"]]
        return np.frombuffer(binary, kinds[accessor["componentType"]], accessor["count"] * columns, start).reshape(-1, columns)

    return [{name: array(i) for name, i in p["attributes"].items()} for mesh in document["meshes"] for p in mesh["primitives"]]


@pytest.mark.parametrize("scope", ["model", "object", "face"])
def test_normals_are_those_that_the_program_writes(program, tmp_path, scope):
    model = DATA / "spot" / "spot_slab5.glb"
    program.run("smooth", model, "-o", tmp_path / "program.glb", "--normals", scope)
    written = accessors(tmp_path / "program.glb")
    made = rakelight.attributes(rakelight.load(model).placed_meshes(), normals=scope, weight="auto", crease="auto", tangents=False)
    assert len(written) == len(made)
    for a, b in zip(written, made):
        assert a["NORMAL"].tobytes() == b.normals.tobytes()
    scene = rakelight.load(model).smooth(scope, tangents=False)
    for a, mesh in zip(written, scene.meshes):
        assert a["NORMAL"].tobytes() == mesh.normals.tobytes()


def test_tangents_are_those_that_the_program_writes(program, tmp_path):
    model = DATA / "maps" / "wall.obj"
    program.run("smooth", model, "-o", tmp_path / "program.glb", "--normals", "model", "--tangents", "always")
    made = rakelight.attributes(rakelight.load(model).placed_meshes())
    written = accessors(tmp_path / "program.glb")
    assert written and len(written) == len(made)
    for a, b in zip(written, made):
        assert a["TANGENT"].tobytes() == b.tangents.tobytes()


def test_a_smoothed_file_is_the_program_s(program, tmp_path):
    model = DATA / "spot" / "spot_slab5.glb"
    program.run("smooth", model, "-o", tmp_path / "a.glb")
    row = rakelight.smooth_file(model, tmp_path / "b.glb")
    assert (tmp_path / "a.glb").read_bytes() == (tmp_path / "b.glb").read_bytes()
    assert row["changed"]


def test_a_file_is_converted_as_the_program_does(tmp_path, program):
    model = DATA / "spot" / "spot_slab5.glb"
    program.run("convert", model, "-o", tmp_path / "a.obj")
    row = rakelight.convert_file(model, tmp_path / "a2" / "A.OBJ")
    assert row["meshes"] == row["meshes_without_normals"] == 5 and not row["copied"]  # normals stay as they are: the file has none
    vertices = [[line for line in path.read_text().splitlines() if line.startswith("v")] for path in (tmp_path / "a.obj", tmp_path / "a2" / "A.OBJ")]
    assert vertices[0] == vertices[1]
    scene = rakelight.load(model)
    for name in ("b.GLB", "c.gltf", "d.Obj", "e.PLY"):  # endings in any case
        scene.save(tmp_path / name)
        assert len(rakelight.load(tmp_path / name).placed_meshes()) > 0


@pytest.mark.parametrize("model", ["builtin:teapot", DATA / "spot" / "spot_slab5.glb"])
def test_repaired_seams_are_gone(model):
    cut = rakelight.load(model)
    if model == "builtin:teapot":
        cut = cut.smooth("object")
    before = cut.inspect(surfaces=False, check={"max_seam": 1})["check"]
    after = cut.repair_seams().inspect(surfaces=False, check={"max_seam": 1})["check"]
    assert not before["passed"] and after["passed"]


def hinge(bend_deg, lean_deg=0.0):
    """Two squares that bend where they meet. Their normals lean towards each other."""
    def square(x, turn, lean):
        c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
        vertices = np.array([[0, 0, 0], [0, 0, 1], [x * c, -abs(x) * s, 1], [x * c, -abs(x) * s, 0]], np.float32)
        faces = np.array([[0, 1, 2], [0, 2, 3]] if x > 0 else [[0, 2, 1], [0, 3, 2]], np.uint32)
        a = np.radians(90 - turn + lean)
        return rakelight.Mesh(vertices, faces, normals=np.tile(np.array([np.cos(a), np.sin(a), 0], np.float32), (4, 1)))
    return [square(-1, 0, -lean_deg), square(1, bend_deg, lean_deg)]


def test_creases_by_the_rule(tmp_path):
    meshes = hinge(45)
    by_angle, by_rule = (rakelight.attributes(meshes, crease=word) for word in ("angle", "auto"))
    assert not (by_angle[0].normals[:2] == by_rule[0].normals[:2]).all()
    np.testing.assert_allclose(by_rule[0].normals, [[0, 1, 0]] * 4, atol=1e-6)
    scene = rakelight.Scene.from_meshes(hinge(45, 15))
    given = scene.meshes[0].normals
    assert not (scene.repair_seams(crease="angle").meshes[0].normals == given).all()
    assert (scene.repair_seams(crease="auto").meshes[0].normals == given).all()
    assert not (scene.smooth(crease="angle").meshes[0].normals == scene.smooth(crease="auto").meshes[0].normals).all()
    scene.save(tmp_path / "in.glb")
    for word, turned in (("angle", 4), ("auto", 0)):
        assert rakelight.smooth_file(tmp_path / "in.glb", tmp_path / "out.glb", crease=word)["seams"]["turned"] == turned
    assert rakelight.inspect(scene, crease="auto", normals="model")["creases"]["hard"] == 1


def test_an_angle_alone_is_taken_and_else_the_rule(tmp_path):
    scene = rakelight.Scene.from_meshes(hinge(45, 15))
    scene.save(tmp_path / "in.glb")
    given = scene.meshes[0].normals
    for options, is_hard in (
        ({}, True),
        ({"crease_angle": 60}, False),
        ({"crease_angle": 30}, True),
        ({"crease_angle": 60, "crease": "auto"}, True),
        ({"crease": "angle"}, False),
    ):
        assert (scene.repair_seams(**options).meshes[0].normals == given).all() == is_hard, options
        report = rakelight.smooth_file(tmp_path / "in.glb", tmp_path / "out.glb", **options)
        assert (report["seams"]["turned"] == 0) == is_hard, options
        smooth = scene.smooth(**options).meshes
        assert np.allclose(smooth[0].normals, [[0, 1, 0]] * 4, atol=1e-6) == is_hard, options


@pytest.mark.parametrize("weight", ["max", "fit", "auto"])
def test_all_weights_have_words(weight, quad):
    np.testing.assert_allclose(rakelight.attributes(quad, weight=weight)[0].normals, [[0, 0, 1]] * 4, atol=1e-6)
    teapot = rakelight.load("builtin:teapot")
    assert not (teapot.smooth(weight=weight).meshes[0].normals == teapot.smooth(weight="angle").meshes[0].normals).all()
    assert rakelight.render(teapot, resolution=(16, 16), normals="model", weight=weight, crease="auto")["image"].shape == (16, 16, 3)


def test_threads_do_not_change_bits():
    meshes = rakelight.load(DATA / "knight" / "Knight_noNormals.glb").placed_meshes()
    many = rakelight.attributes(meshes)
    try:
        rakelight.set_threads(1)
        one = rakelight.attributes(meshes)
    finally:
        rakelight.set_threads(0)
    assert all(a.normals.tobytes() == b.normals.tobytes() for a, b in zip(many, one))


def address(array):
    return array.__array_interface__["data"][0]


def test_arrays_of_a_scene_are_its_own_memory(teapot):
    first, again = teapot.meshes[1], rakelight.Scene(teapot._core).meshes[1]
    for name in ("vertices", "faces", "uv"):
        assert address(getattr(first, name)) == address(getattr(again, name))
        assert not getattr(first, name).flags.writeable
    smooth = teapot.smooth()
    assert address(smooth.meshes[1].faces) == address(first.faces) or len(smooth.meshes[1].vertices) > len(first.vertices)


def test_arrays_outlive_their_scene():
    vertices = rakelight.load("builtin:teapot").meshes[0].vertices
    expected = vertices.copy()
    gc.collect()
    rakelight.load("builtin:sphere:tolerance=0.0001")  # takes the memory, where it were free
    np.testing.assert_array_equal(vertices, expected)


def test_faces_that_nothing_splits_are_the_array_that_was_given(quad):
    made = rakelight.attributes(quad)[0]
    assert made.faces is quad.faces
    np.testing.assert_array_equal(made.normals, [[0, 0, 1]] * 4)
    np.testing.assert_array_equal(made.source, [0, 1, 2, 3])


@pytest.mark.parametrize("kind", [np.int8, np.uint8, np.int16, np.int32, np.uint32, np.int64, np.uint64])
def test_faces_of_any_integers(quad, kind):
    made = rakelight.attributes((quad.vertices, quad.faces.astype(kind)))[0]
    np.testing.assert_array_equal(made.normals, [[0, 0, 1]] * 4)


def shifted(array):
    """The same numbers at an odd address."""
    return np.frombuffer(b"\0" + array.tobytes(), array.dtype, offset=1).reshape(array.shape)


def field(array):
    """The same numbers in records of an odd size."""
    records = np.zeros(len(array), [("flag", "u1"), ("values", array.dtype, array.shape[1:])])
    records["values"] = array
    return records["values"]


LAYOUTS = {
    "F": np.asfortranarray,
    "strided": lambda array: np.repeat(array, 2, axis=0)[::2],
    "backwards": lambda array: array[::-1].copy()[::-1],
    "mirrored": lambda array: array[:, ::-1].copy()[:, ::-1],
    "big endian": lambda array: array.astype(array.dtype.newbyteorder(">")),
    "unaligned": shifted,
    "unaligned big endian": lambda array: shifted(array.astype(array.dtype.newbyteorder(">"))),
    "field": field,
    "list": lambda array: array.tolist(),
    "read-only": lambda array: np.frombuffer(array.tobytes(), array.dtype).reshape(array.shape),
}


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("types", [(np.float32, np.uint32), (np.float64, np.int64), (np.float16, np.uint16)])
def test_arrays_of_any_layout(layout, types):
    corner = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    put, (real, whole) = LAYOUTS[layout], types
    expected = rakelight.attributes(rakelight.Mesh(np.float32(corner), np.uint32(faces), uv=np.float32(corner[:, :2])))[0]
    mesh = rakelight.Mesh(put(corner.astype(real)), put(faces.astype(whole)), uv=put(corner[:, :2].astype(real)), to_world=put(np.eye(4)))
    made = rakelight.attributes(mesh)[0]
    for name in ("normals", "tangents", "source"):
        assert getattr(made, name).tobytes() == getattr(expected, name).tobytes(), name
    inside = rakelight.Scene.from_meshes(mesh).meshes[0]
    np.testing.assert_array_equal(inside.vertices, corner)
    np.testing.assert_array_equal(inside.faces, faces)
    np.testing.assert_array_equal(inside.uv, corner[:, :2])


@pytest.mark.parametrize("shape", [(0,), (0, 3), (0, 2)])
def test_arrays_without_rows(shape):
    nothing = np.zeros(shape)
    columns = {"vertices": 3, "normals": 3, "tangents": 4, "uv": 2, "colors": 4}
    for name, width in columns.items():
        arrays = {key: np.zeros((0, columns[key])) for key in columns}
        arrays.update({"faces": np.zeros((0, 3), int), name: nothing})
        if shape in ((0,), (0, width)):
            assert rakelight.attributes(rakelight.Mesh(**arrays))[0].normals.shape == (0, 3)
        else:
            with pytest.raises(rakelight.UsageError, match=f"{name}: the shape must be"):
                rakelight.Mesh(**arrays)


def test_vertices_split_where_corners_differ():
    corner = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
    made = rakelight.attributes((corner, [[0, 1, 2], [0, 2, 3]]), crease_angle=30)[0]
    assert len(made.normals) == 6 and list(made.source[4:]) == [0, 2]
    np.testing.assert_array_equal(made.expand(corner), corner[made.source])
    assert np.asarray(made.faces).max() == 5


def test_a_mirrored_placement_keeps_the_outside(quad):
    mirror = np.diag([-1.0, 1, 1, 1])
    np.testing.assert_array_equal(rakelight.attributes(replace(quad, to_world=mirror))[0].normals, [[0, 0, 1]] * 4)


def test_normals_are_chosen_by_one_name_and_its_old_one(tmp_path):
    model = DATA / "spot" / "spot_slab5.glb"
    scene = rakelight.load(model)
    flat = [mesh.normals for mesh in scene.smooth(normals="face").meshes]
    for again in (scene.smooth("face"), scene.smooth(scope="face"), scene.smooth("flat")):
        assert all((mesh.normals == normals).all() for mesh, normals in zip(again.meshes, flat))
    new, old = (rakelight.attributes(scene.placed_meshes(), **{name: "object"}) for name in ("normals", "scope"))
    assert all((a.normals == b.normals).all() for a, b in zip(new, old))
    rakelight.smooth_file(model, tmp_path / "a.glb", normals="model")
    rakelight.smooth_file(model, tmp_path / "b.glb", scope="model")
    assert (tmp_path / "a.glb").read_bytes() == (tmp_path / "b.glb").read_bytes()
    with pytest.raises(rakelight.UsageError, match=r"unknown word 'seams'; use one of model, object, face; repair_seams\(\)"):
        scene.smooth(scope="seams")
