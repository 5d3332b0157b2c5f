# SPDX-License-Identifier: Apache-2.0
"""Meshes of others go in and come out."""
import types

import numpy as np
import pytest

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
