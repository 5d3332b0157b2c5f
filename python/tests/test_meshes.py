# SPDX-License-Identifier: Apache-2.0
"""Meshes of others go in and come out."""
import copy
import pickle
import types
from dataclasses import FrozenInstanceError, replace

import numpy as np
import pytest
from conftest import DATA

import rakelight


class Trimesh:
    """What trimesh has, as far as it is looked at."""

    def __init__(self, vertices, faces, name=None):
        self.vertices, self.faces = np.asarray(vertices, np.float64), np.asarray(faces, np.int64)
        self.vertex_normals = np.tile([0.0, 0, 1], (len(self.vertices), 1))
        self.visual = types.SimpleNamespace(uv=self.vertices[:, :2])
        self.metadata = {"name": name}


class Open3D:
    """What Open3D has: vectors that numpy reads, texture coordinates of corners."""

    def __init__(self, vertices, faces):
        self.vertices, self.triangles = list(map(tuple, vertices)), list(map(tuple, faces))
        self.vertex_normals, self.triangle_uvs = [], []


def test_trimesh(quad):
    scene = rakelight.Scene.from_meshes(Trimesh(quad.vertices, quad.faces))
    mesh = scene.meshes[0]
    np.testing.assert_array_equal(mesh.vertices, quad.vertices)
    np.testing.assert_array_equal(mesh.faces, quad.faces)
    np.testing.assert_array_equal(mesh.uv, np.stack([quad.vertices[:, 0], 1 - quad.vertices[:, 1]], axis=1))  # v down here
    again = Trimesh(**{key: mesh.trimesh_arguments()[key] for key in ("vertices", "faces")})
    np.testing.assert_array_equal(again.vertices, quad.vertices)


def test_open3d(quad):
    scene = rakelight.Scene.from_meshes([Open3D(quad.vertices, quad.faces)])
    assert scene.meshes[0].normals is None
    assert rakelight.render(scene, "front", resolution=(32, 32), channels="object")["object"].min() == 0


def test_a_scene_of_meshes(quad):
    class Meshes:
        geometry = {"a": None}

        def dump(self):
            return [Trimesh(quad.vertices, quad.faces), Trimesh(quad.vertices + 1, quad.faces)]

    assert len(rakelight.Scene.from_meshes(Meshes()).meshes) == 2


def test_names_of_a_dictionary(quad):
    scene = rakelight.Scene.from_meshes({"left": quad, "right": Trimesh(quad.vertices + 2, quad.faces)})
    assert scene.nodes == ["left", "right"] and [o.name for o in scene.objects] == ["left", "right"]
    np.testing.assert_array_equal(scene.bounds, [[0, 0, 0], [3, 3, 2]])


def test_colors_and_places(quad):
    red = rakelight.Mesh(quad.vertices, quad.faces, color=(1, 0, 0), name="red", to_world=np.diag([2.0, 2, 2, 1]))
    scene = rakelight.Scene.from_meshes([red])
    picture = rakelight.render(scene, "front", resolution=(32, 32), channels=["base_color", "object"])
    assert (picture["base_color"][picture["object"] == 0] == [1, 0, 0]).all()
    np.testing.assert_array_equal(scene.bounds[1], [2, 2, 0])
    np.testing.assert_array_equal(scene.placed_meshes()[0].to_world, red.to_world)


def test_a_saved_scene_is_loaded_again(teapot, tmp_path):
    with pytest.warns(rakelight.RakelightWarning):  # a classical material became metallic-roughness
        teapot.smooth().save(tmp_path / "teapot.glb")
    again = rakelight.load(tmp_path / "teapot.glb")
    assert again.nodes == teapot.nodes
    for a, b in zip(again.meshes, teapot.smooth().meshes):
        np.testing.assert_array_equal(a.normals, b.normals)
    data = (tmp_path / "teapot.glb").read_bytes()
    assert len(rakelight.load_bytes(data, "teapot.glb").meshes) == len(again.meshes)


def test_placed_meshes_go_back_into_a_scene(teapot):
    again = rakelight.Scene.from_meshes(teapot.placed_meshes())
    np.testing.assert_array_equal(again.bounds, teapot.bounds)
    a = rakelight.render(teapot, "front", resolution=(48, 36), channels=["depth", "normal", "object"])
    b = rakelight.render(again, "front", resolution=(48, 36), channels=["depth", "normal", "object"])
    for name in a:
        np.testing.assert_array_equal(a[name], b[name])


def test_a_scene_shows_itself(teapot):
    assert teapot._repr_png_().startswith(b"\x89PNG")
    assert "6 objects" in repr(teapot)


def test_texture_coordinates_of_trimesh_are_v_up():
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32)
    thing = types.SimpleNamespace(vertices=corners, faces=np.array([[0, 1, 2], [0, 2, 3]]), visual=types.SimpleNamespace(uv=corners[:, :2]),
                            metadata={"name": "plate"})
    made = rakelight.attributes(thing)
    assert (made[0].tangents[:, 3] == 1).all()  # as glTF: the bitangent points up in the picture
    assert rakelight.Scene.from_meshes(thing).meshes[0].name == "plate"


def test_meshes_of_a_scene_cannot_be_changed(quad):
    scene = rakelight.Scene.from_meshes(rakelight.Mesh(quad.vertices, quad.faces, uv=quad.vertices[:, :2]))
    mesh = scene.meshes[0]
    for name in ("vertices", "faces", "uv"):
        array = getattr(mesh, name)
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1
        with pytest.raises(ValueError):
            array.flags.writeable = True
        with pytest.raises(FrozenInstanceError):
            setattr(mesh, name, array + 1)
    with pytest.raises(TypeError):
        scene.meshes[0] = mesh
    with pytest.raises(TypeError):
        mesh.arrays["weight"] = quad.vertices[:, 0]


def test_a_scene_does_not_see_what_is_done_to_arrays_later(quad):
    vertices = quad.vertices.copy()
    scene = rakelight.Scene.from_meshes((vertices, quad.faces))
    vertices += 7
    np.testing.assert_array_equal(scene.bounds, [[0, 0, 0], [1, 1, 0]])


def test_a_scene_with_other_meshes(teapot):
    body = teapot.meshes[1]
    wide = teapot.with_meshes({1: replace(body, vertices=body.vertices * np.float32([2, 1, 1]), normals=None)})
    assert wide.nodes == teapot.nodes and wide.materials == teapot.materials
    assert wide.meshes[1].name == body.name and wide.meshes[1].material == body.material and wide.meshes[1].normals is None
    np.testing.assert_array_equal(wide.meshes[1].vertices, body.vertices * [2, 1, 1])
    np.testing.assert_array_equal(teapot.meshes[1].vertices, body.vertices)
    assert np.shares_memory(wide.meshes[0].vertices, teapot.meshes[0].vertices)
    a, b = (scene.render("front", resolution=(48, 36), channels="object")["object"] for scene in (teapot, wide))
    assert (a != b).any()


def test_what_replaces_a_mesh_may_have_a_color_and_other_counts(teapot, quad):
    scene = teapot.with_meshes({2: rakelight.Mesh(quad.vertices, quad.faces, color=(0, 1, 0), name="plate")})
    assert len(scene.meshes[2].faces) == 2 and scene.meshes[2].name == "plate" and len(scene.materials) == len(teapot.materials) + 1
    assert scene.with_meshes({}).meshes[2].material == scene.meshes[2].material


@pytest.mark.parametrize("meshes", [
    {99: ([[0, 0, 0]], [])}, {-1: ([[0, 0, 0]], [])}, {0: ([[0, 0, 0]], [[0, 1, 2]])}, {0: 5},
    {0: rakelight.Mesh([[0, 0, 0]], [], to_world=np.eye(4))}, {"body": ([[0, 0, 0]], [])}, [([[0, 0, 0]], [])],
])  # fmt: skip
def test_meshes_that_replace_none(teapot, meshes):
    with pytest.raises(rakelight.UsageError):
        teapot.with_meshes(meshes)


def test_a_moving_mesh_is_replaced_by_one_with_as_many_vertices():
    scene = rakelight.load(DATA / "motion" / "door.gltf")
    number = 0
    mesh = scene.meshes[number]
    half = scene.with_meshes({number: replace(mesh, vertices=mesh.vertices * np.float32(0.5))})
    assert half.animations == scene.animations
    rakelight.render(half, animation_time=0.5, resolution=(16, 16))
    with pytest.raises(rakelight.UsageError, match="joints"):
        scene.with_meshes({number: ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])})


def test_what_can_be_pickled(teapot, quad):
    mesh = pickle.loads(pickle.dumps(teapot.meshes[1]))
    np.testing.assert_array_equal(mesh.vertices, teapot.meshes[1].vertices)
    assert mesh.name == teapot.meshes[1].name and mesh.arrays == {}
    made = pickle.loads(pickle.dumps(rakelight.attributes(quad)[0]))
    np.testing.assert_array_equal(made.normals, [[0, 0, 1]] * 4)
    picture = teapot.render(resolution=(8, 6), channels=["image", "depth"])
    again = pickle.loads(pickle.dumps(picture))
    assert type(again) is rakelight.Picture and again.png() == picture.png() and (again.to_world == picture.to_world).all()
    pixel = teapot.explain(4, 3, resolution=(8, 6))
    assert pickle.loads(pickle.dumps(pixel)) == pixel
    with pytest.raises(rakelight.NotFoundError) as caught:
        rakelight.load("nowhere.glb")
    error = pickle.loads(pickle.dumps(caught.value))
    assert type(error) is rakelight.NotFoundError and str(error) == str(caught.value) and error.file == "nowhere.glb"


def test_scenes_and_sessions_are_not_pickled(teapot):
    with pytest.raises(TypeError, match="a Scene cannot be pickled: send"):
        pickle.dumps(teapot)
    with pytest.raises(TypeError, match="a Session cannot be pickled: make"):
        pickle.dumps(rakelight.Session(teapot))
    assert copy.copy(teapot) is teapot and copy.deepcopy(teapot) is teapot
