# SPDX-License-Identifier: Apache-2.0
"""What stays of a scene whose meshes are replaced."""
import json
import struct
from dataclasses import replace

import numpy as np
import pytest
from conftest import ROOT

import rakelight

pytestmark = pytest.mark.filterwarnings("ignore:.*attributes are not written", "ignore:.*classical material")  # of save()
ASSETS = ROOT.parent / "shared" / "assets"
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32)
FACES = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)
CUBE = """v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1
s 1\nf 4 3 2 1\ns 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"""


@pytest.fixture
def two_sets(tmp_path):
    """A GLB file of a red quad with two sets of texture coordinates and other numbers of its vertices, and of a blue one behind it."""
    arrays = {
        "POSITION": ("VEC3", CORNERS),
        "TEXCOORD_0": ("VEC2", CORNERS[:, :2].copy()),
        "TEXCOORD_1": ("VEC2", CORNERS[:, 1::-1] / np.float32(3)),
        "_HEAT": ("SCALAR", np.arange(4, dtype=np.float32)),
    }
    data, views, accessors = b"", [], []
    for kind, values in [*arrays.values(), ("SCALAR", FACES.ravel())]:
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": values.nbytes})
        accessor = {"bufferView": len(accessors), "componentType": 5125 if values.dtype == np.uint32 else 5126, "count": len(values), "type": kind}
        accessors.append({**accessor, "min": [0, 0, 0], "max": [1, 1, 0]} if kind == "VEC3" else accessor)
        data += values.tobytes()
    colors = {"red": [1, 0, 0, 1], "blue": [0, 0, 1, 1]}
    primitive = {"attributes": {name: i for i, name in enumerate(arrays)}, "indices": len(arrays), "material": 0}
    tree = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0}, {"mesh": 1, "translation": [0, 0, -0.5]}],
        "meshes": [{"primitives": [primitive]}, {"primitives": [{**primitive, "material": 1}]}],
        "materials": [{"name": name, "pbrMetallicRoughness": {"baseColorFactor": color}} for name, color in colors.items()],
        "buffers": [{"byteLength": len(data)}], "bufferViews": views, "accessors": accessors,
    }  # fmt: skip
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    path = tmp_path / "two_sets.glb"
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
    return path


def check_same(scene, other, folder, **options):
    """They draw the same, their second texture coordinates too, and are saved as the same bytes."""
    options = {"resolution": (64, 48), "channels": ["image", "normal", "uv", "uv1"], **options}
    a, b = rakelight.render(scene, **options), rakelight.render(other, **options)
    for channel in a:
        np.testing.assert_array_equal(a[channel], b[channel])
    scene.save(folder / "a.glb"), other.save(folder / "b.glb")
    assert (folder / "a.glb").read_bytes() == (folder / "b.glb").read_bytes()
    return a


def test_a_mesh_that_replaces_itself_changes_nothing(two_sets, tmp_path):
    scene = rakelight.load(two_sets)
    picture = check_same(scene, scene.with_meshes({0: replace(scene.meshes[0])}), tmp_path)
    assert np.nanmax(picture["uv1"]) == pytest.approx(1 / 3, abs=0.02) and b"TEXCOORD_1" in (tmp_path / "b.glb").read_bytes()
    cube = tmp_path / "cube.obj"
    cube.write_text(CUBE)
    scene = rakelight.load(cube)
    check_same(scene, scene.with_meshes({0: replace(scene.meshes[0])}), tmp_path, crease_angle=180)
    check_same(scene, scene.with_meshes({0: replace(scene.meshes[0])}), tmp_path, subdivide=2)


def test_a_file_with_two_sets_of_texture_coordinates(tmp_path):
    path = ASSETS / "gltf" / "MultiUVTest" / "MultiUVTest.glb"
    if not path.exists():
        pytest.skip("the asset is not there")
    scene = rakelight.load(path)
    check_same(scene, scene.with_meshes({0: replace(scene.meshes[0])}), tmp_path)


def test_a_built_in_shape_that_replaces_itself_stays_exact():
    if "trace" not in rakelight.build_info()["engines"]:
        pytest.skip("this build has no engine trace")
    scene = rakelight.load("builtin:sphere")
    mesh = scene.meshes[0]
    options = {"engine": "trace", "resolution": (48, 36), "channels": "normal"}
    exact = rakelight.render(scene, **options)["normal"]
    np.testing.assert_array_equal(rakelight.render(scene.with_meshes({0: mesh}), **options)["normal"], exact)
    moved = scene.with_meshes({0: replace(mesh, vertices=mesh.vertices * np.float32([1, 0.5, 1]))})
    assert (rakelight.render(moved, **options)["normal"] != exact).any()


def test_further_texture_coordinates_need_as_many_vertices(two_sets):
    scene = rakelight.load(two_sets)
    with pytest.raises(rakelight.UsageError, match="mesh 0: there are 3 vertices for further sets of texture coordinates of 4"):
        scene.with_meshes({0: (CORNERS[:3], [[0, 1, 2]])})
    moved = scene.with_meshes({0: replace(scene.meshes[0], vertices=CORNERS * np.float32(2), uv=CORNERS[:, :2] / np.float32(4))})
    picture = rakelight.render(moved, "front", resolution=(64, 48), channels=["uv", "uv1"])
    assert np.nanmax(picture["uv"]) == pytest.approx(0.25, abs=0.02) and np.nanmax(picture["uv1"]) == pytest.approx(1 / 3, abs=0.02)


def test_groups_and_polygons_stay_with_the_same_faces_alone(tmp_path):
    (tmp_path / "cube.obj").write_text(CUBE)
    scene = rakelight.load(tmp_path / "cube.obj")
    mesh = scene.meshes[0]
    faces = np.asarray(mesh.faces)

    def shape(scene, **options):
        options = {"resolution": (64, 48), "channels": "normal", "crease_angle": 180, **options}
        return rakelight.render(scene, "isometric", **options)["normal"]

    stretched = scene.with_meshes({0: replace(mesh, vertices=mesh.vertices * np.float32([1, 2, 1]))})
    groups = rakelight.inspect(scene)["objects"][0]["smoothing_groups"]
    assert groups == rakelight.inspect(stretched)["objects"][0]["smoothing_groups"] != "no"
    for order in (faces[::-1], faces[np.random.default_rng(0).permutation(len(faces))], faces[:, [1, 2, 0]]):
        other = scene.with_meshes({0: replace(mesh, faces=order)})
        fresh = rakelight.Scene.from_meshes(rakelight.Mesh(mesh.vertices, order))
        assert rakelight.inspect(other)["objects"][0]["smoothing_groups"] == "no"
        for options in ({}, {"subdivide": 2}):
            np.testing.assert_array_equal(shape(other, **options), shape(fresh, **options))
            assert (shape(other, **options) != shape(scene, **options)).any()


def test_materials_and_other_numbers_are_those_of_the_new_mesh(two_sets):
    scene = rakelight.load(two_sets)
    mesh = scene.meshes[0]
    np.testing.assert_array_equal(mesh.arrays["_HEAT"], [0, 1, 2, 3])
    pair = np.arange(8.0).reshape(4, 2)
    other = scene.with_meshes({0: replace(mesh, material=np.int64(1), arrays={"cold": [4, 3, 2, 1], "pair": pair})})
    assert other.meshes[0].material == 1 and list(other.meshes[0].arrays) == ["cold", "pair"]
    np.testing.assert_array_equal(other.meshes[0].arrays["cold"], np.float32([4, 3, 2, 1]))
    np.testing.assert_array_equal(other.meshes[0].arrays["pair"], pair)
    a, b = (rakelight.render(s, "front", resolution=(8, 8), channels="material")["material"][4, 4] for s in (scene, other))
    assert (a, b) == (0, 1)
    kept = other.with_meshes({0: replace(mesh, material=None, arrays={})}).meshes[0]
    assert kept.material == 1 and not kept.arrays
    green = scene.with_meshes({0: replace(mesh, color=(0, 1, 0))})  # a color comes before the number
    assert green.meshes[0].material == len(scene.materials) == len(green.materials) - 1
    again = rakelight.Scene.from_meshes(scene.placed_meshes())
    np.testing.assert_array_equal(again.meshes[0].arrays["_HEAT"], [0, 1, 2, 3])


@pytest.mark.parametrize("change, words", [
    ({"material": 2}, "mesh 0: material 2 is not one of the 2"), ({"material": -1}, "material -1"), ({"material": 2**70}, "material 1180"),
    ({"material": 0.0}, "mesh 0: material: a number"), ({"material": "red"}, "material: a number"),
    ({"arrays": {"heat": [1, 2, 3]}}, "mesh 0: arrays: heat: there are 3 rows for 4 vertices"),
    ({"arrays": {"heat": np.zeros((4, 2, 2))}}, "arrays: heat: the shape"), ({"arrays": {"heat": np.zeros((4, 17))}}, "17 columns"),
    ({"arrays": {"heat": np.zeros((4, 0))}}, "arrays: heat: the shape"), ({"arrays": {"heat": ["a"] * 4}}, "arrays: heat: numbers"),
    ({"arrays": {"heat": [[1], [1, 2]]}}, "arrays: heat"), ({"arrays": {1: [1, 2, 3, 4]}}, "argument"), ({"arrays": [1]}, "arrays: "),
])  # fmt: skip
def test_materials_and_other_numbers_that_cannot_be(two_sets, change, words):
    scene = rakelight.load(two_sets)
    with pytest.raises(rakelight.UsageError, match=words):
        scene.with_meshes({0: replace(scene.meshes[0], **change)})
