# SPDX-License-Identifier: Apache-2.0
"""Positions far from zero keep their digits."""
from dataclasses import replace

import numpy as np
import pytest

import rakelight

FAR = np.array([4.5e6, 120.0, -5.2e6])  # [m] as maps have them
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0.125], [0, 1, 0.1]]) / 3
FACES = np.array([[0, 1, 2], [0, 2, 3]])


def test_a_scene_keeps_the_digits_of_far_positions():
    scene = rakelight.Scene.from_meshes((FAR + CORNERS, FACES))
    mesh = scene.meshes[0]
    assert mesh.vertices.dtype == np.float32 and np.abs(mesh.vertices).max() < 2 and any(mesh.origin)
    np.testing.assert_allclose(mesh.positions(), FAR + CORNERS, rtol=0, atol=1e-7)  # float32 would be off by 0.25
    np.testing.assert_allclose(scene.bounds, [FAR, FAR + CORNERS.max(axis=0)], rtol=0, atol=1e-7)
    np.testing.assert_allclose(mesh.trimesh_arguments()["vertices"], FAR + CORNERS, rtol=0, atol=1e-7)
    near = rakelight.render((CORNERS, FACES), "front", resolution=(40, 30), channels="object")["object"]
    np.testing.assert_array_equal(rakelight.render(scene, "front", resolution=(40, 30), channels="object")["object"], near)


def test_the_origin_is_the_one_that_loaders_choose(tmp_path):
    positions = FAR + CORNERS
    header = "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
    faces = b"".join(b"\x03" + np.asarray(face, "<i4").tobytes() for face in FACES)
    header += "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    (tmp_path / "far.ply").write_bytes(header.encode() + positions.astype("<f8").tobytes() + faces)
    loaded, made = rakelight.load(tmp_path / "far.ply").meshes[0], rakelight.Scene.from_meshes((positions, FACES)).meshes[0]
    assert loaded.origin == made.origin
    assert loaded.vertices.tobytes() == made.vertices.tobytes()


def test_attributes_of_far_positions_are_those_of_near_ones():
    near = rakelight.attributes((CORNERS, FACES), crease_angle=90)[0]
    far = rakelight.attributes((FAR + CORNERS, FACES), crease_angle=90)[0]
    np.testing.assert_allclose(far.normals, near.normals, rtol=0, atol=1e-5)


def test_meshes_of_one_model_have_one_origin():
    left, right = FAR + CORNERS, FAR + CORNERS + (1 / 3, 0, 0)
    scene = rakelight.Scene.from_meshes({"left": (left, FACES), "right": (right, FACES)})
    assert scene.meshes[0].origin == scene.meshes[1].origin
    apart = rakelight.Scene.from_meshes([rakelight.Mesh(left, FACES), rakelight.Mesh(CORNERS, FACES, to_world=np.diag([2.0, 2, 2, 1]))])
    assert any(apart.meshes[0].origin) and not any(apart.meshes[1].origin)


def test_equal_places_are_one_whatever_their_type():
    left, right = FAR + CORNERS, FAR + CORNERS + (1 / 3, 0, 0)
    signed = np.eye(4)
    signed[0, 1] = -0.0
    for place in (np.eye(4), np.eye(4, dtype=int), np.eye(4, dtype=np.float32), np.eye(4).tolist(), np.asfortranarray(np.eye(4)), signed):
        scene = rakelight.Scene.from_meshes([rakelight.Mesh(left, FACES), rakelight.Mesh(right, FACES, to_world=place)])
        assert scene.meshes[0].origin == scene.meshes[1].origin
    shift = np.eye(4) + 3.0 * np.eye(4)[[0]].T @ np.eye(4)[[3]]
    places = [shift, shift.astype(np.int32)]
    scene = rakelight.Scene.from_meshes([rakelight.Mesh(v, FACES, to_world=place) for v, place in zip((left, right), places)])
    assert scene.meshes[0].origin == scene.meshes[1].origin


def test_a_far_mesh_goes_back_into_a_scene():
    scene = rakelight.Scene.from_meshes(rakelight.Mesh(FAR + CORNERS, FACES, to_world=np.diag([1.0, 2, 1, 1])))
    again = rakelight.Scene.from_meshes(scene.placed_meshes())
    np.testing.assert_array_equal(again.bounds, scene.bounds)
    assert again.meshes[0].origin == scene.meshes[0].origin
    placed = again.placed_meshes()[0]
    np.testing.assert_allclose(placed.positions(world=True), (FAR + CORNERS) * (1, 2, 1), rtol=0, atol=1e-6)
    moved = replace(placed, vertices=placed.positions() - FAR, origin=(0, 0, 0))  # and nearer
    assert not any(rakelight.Scene.from_meshes(moved).meshes[0].origin)


def test_float32_and_near_positions_are_taken_as_they_are(quad):
    for vertices in (quad.vertices + np.float32(1e7), quad.vertices.astype(np.float64) + 1e6, CORNERS):
        mesh = rakelight.Scene.from_meshes((vertices, quad.faces)).meshes[0]
        assert mesh.origin == (0, 0, 0)
        np.testing.assert_array_equal(mesh.vertices, np.asarray(vertices, np.float32))


def test_large_whole_numbers_are_positions():
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]]) + 2**30
    np.testing.assert_array_equal(rakelight.Scene.from_meshes((vertices, [[0, 1, 2]])).meshes[0].positions(), vertices)


def test_far_positions_that_are_not_finite_stay_so():
    vertices = np.concatenate([FAR + CORNERS, FAR + [[np.nan, 0, 0], [np.inf, 0, 1e300]]])
    mesh = rakelight.Scene.from_meshes((vertices, FACES)).meshes[0]
    np.testing.assert_allclose(mesh.positions()[:4], FAR + CORNERS, rtol=0, atol=1e-7)
    assert not np.isfinite(mesh.vertices[4:, 0]).any()


@pytest.mark.parametrize("origin", [(np.nan, 0, 0), (1, 2), "abc", "123", ("1", "2", "3")])
def test_origins_that_cannot_be(quad, origin):
    with pytest.raises(rakelight.UsageError):
        replace(quad, origin=origin)
