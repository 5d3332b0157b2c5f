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


def pixels(mesh, **options):
    """What an unlit picture of the unit square shows at (column, row) of 4 x 4 places, codes of sRGB."""
    camera = rakelight.Camera((0.5, 0.5, 1), (0.5, 0.5, 0), vertical_fov=2 * np.degrees(np.arctan(0.5)))  # the square fills it
    picture = rakelight.render(mesh, camera, resolution=(32, 32), shading="unlit", look="plain", **options)["image"]
    return picture[4::8, 4::8, :3].astype(int)


def visual(**parts):
    return types.SimpleNamespace(**parts)


class Plain:
    """A mesh of another library: the square of `quad`, with more of it."""

    def __init__(self, quad, **parts):
        self.vertices, self.faces = np.asarray(quad.vertices), np.asarray(quad.faces)
        self.__dict__.update(parts)


RED = [200, 10, 20, 255]


def test_vertex_colors_of_trimesh(quad):
    colors = np.tile(np.uint8(RED), (4, 1))
    for look in (visual(vertex_colors=colors), visual(kind="vertex", vertex_colors=colors), visual(vertex_colors=colors[:, :3]),
                 visual(vertex_colors=colors / 255.0), visual(kind="vertex", vertex_colors=np.uint8(RED))):
        assert np.abs(pixels(Plain(quad, visual=look)) - RED[:3]).max() <= 1
    made_up = visual(kind=None, vertex_colors=np.tile(np.uint8([102, 102, 102, 255]), (4, 1)))
    assert rakelight.Scene.from_meshes(Plain(quad, visual=made_up)).meshes[0].colors is None


def test_face_colors_of_trimesh_have_no_gradients(quad):
    faces = np.uint8([RED, [10, 200, 30, 255]])
    thing = Plain(quad, visual=visual(kind="face", face_colors=faces, vertex_colors=np.zeros((4, 4), np.uint8)), vertex_normals=np.tile([0.0, 0, 1], (4, 1)))
    seen = pixels(thing)
    assert {tuple(row) for row in seen.reshape(-1, 3)[[1, 2, 3, 4, 8, 13]]} <= {(200, 10, 20), (10, 200, 30)}
    assert (seen[3, 2] == [200, 10, 20]).all() and (seen[0, 1] == [10, 200, 30]).all()  # below and above the diagonal
    assert len(rakelight.attributes(thing)[0].normals) == 4, "arrays of the caller's are not split for colors"


CORNERS = np.uint8([[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [255, 255, 0]]])  # row 0 is the top of the picture
TILES = np.repeat(np.repeat(CORNERS, 32, axis=0), 32, axis=1)  # so large that no two are filtered into one pixel


class Image:
    """What PIL has."""

    def __init__(self, array, mode="RGB"):
        self.array, self.mode, self.info = array, mode, {}

    def convert(self, mode):
        assert mode == ("RGBA" if "A" in self.mode else "RGB")
        return self.array


def test_textures_of_trimesh(quad):
    uv = np.asarray(quad.vertices)[:, :2]  # v up: the top of the picture is at y = 1
    for material in (visual(image=Image(TILES), diffuse=np.uint8([102, 102, 102, 255])), visual(baseColorTexture=Image(TILES), baseColorFactor=None)):
        seen = pixels(Plain(quad, visual=visual(kind="texture", uv=uv, material=material)))
        for y, x in ((0, 0), (0, 3), (3, 0), (3, 3)):
            assert (seen[y, x] == CORNERS[y // 3, x // 3]).all()


def test_a_factor_of_a_physical_material_is_linear(quad):
    material = visual(baseColorTexture=None, baseColorFactor=np.uint8([128, 255, 0, 255]))
    assert (pixels(Plain(quad, visual=visual(kind="texture", uv=None, material=material)))[1, 1] == [188, 255, 0]).all()  # sRGB of 128 / 255
    material = visual(image=None, diffuse=np.uint8([128, 255, 0, 255]))
    assert (pixels(Plain(quad, visual=visual(kind="texture", uv=None, material=material)))[1, 1] == [128, 255, 0]).all()


def test_a_picture_without_texture_coordinates_leaves_the_plain_color(quad):
    for material in (visual(image=Image(TILES), diffuse=np.uint8(RED)), visual(baseColorTexture=Image(TILES), baseColorFactor=[0.5776, 0.003035, 0.006995])):
        for uv in (None, np.zeros((0, 2)), np.zeros((3, 2))):
            thing = Plain(quad, visual=visual(kind="texture", uv=uv, material=material))
            with pytest.warns(rakelight.RakelightWarning, match="not taken over: its texture, because it has no texture coordinates"):
                seen = pixels(thing)
            assert np.abs(seen - RED[:3]).max() <= 1


def test_alpha_of_colors_and_textures_is_seen(quad):
    half = np.tile(np.uint8([255, 0, 0, 128]), (4, 1))
    seen = pixels(Plain(quad, visual=visual(kind="vertex", vertex_colors=half)), background="#0000ff")
    assert np.abs(seen - [188, 0, 188]).max() <= 2  # half of either, in linear light
    holes = np.dstack([TILES, np.repeat(np.repeat(np.uint8([[0, 255], [255, 255]]), 32, axis=0), 32, axis=1)])
    uv = np.asarray(quad.vertices)[:, :2]
    seen = pixels(Plain(quad, visual=visual(kind="texture", uv=uv, material=visual(image=Image(holes, "RGBA"), diffuse=None))), background="#0000ff")
    assert (seen[0, 0] == [0, 0, 255]).all() and (seen[0, 3] == [0, 255, 0]).all()
    opaque = visual(baseColorTexture=Image(holes, "RGBA"), alphaMode="OPAQUE")
    assert (pixels(Plain(quad, visual=visual(kind="texture", uv=uv, material=opaque)))[0, 0] == [255, 0, 0]).all()


class Legacy:
    """What Open3D's TriangleMesh has, with a surface. Its textures are turned over as they are read: row 0 is at v = 0."""

    def __init__(self, quad, **parts):
        self.vertices, self.triangles = list(map(tuple, quad.vertices)), list(map(tuple, quad.faces))
        self.vertex_normals, self.triangle_uvs, self.vertex_colors, self.textures, self.triangle_material_ids = [], [], [], [], []
        self.__dict__.update(parts)


def test_colors_and_textures_of_open3d(quad):
    assert np.abs(pixels(Legacy(quad, vertex_colors=[(200 / 255, 10 / 255, 20 / 255)] * 4)) - RED[:3]).max() <= 1
    uv = [tuple(quad.vertices[i][:2]) for face in quad.faces for i in face]
    for ids in ([], [0, 0]):
        seen = pixels(Legacy(quad, triangle_uvs=uv, textures=[TILES[::-1]], triangle_material_ids=ids))
        for y, x in ((0, 0), (0, 3), (3, 0), (3, 3)):
            assert (seen[y, x] == CORNERS[y // 3, x // 3]).all()


def test_what_is_not_taken_over_is_said(quad):
    uv = np.asarray(quad.vertices)[:, :2]
    rich = visual(baseColorTexture=Image(TILES), normalTexture=Image(TILES), metallicFactor=1.0, emissiveFactor=np.zeros(3))
    cases = [
        (Plain(quad, visual=visual(kind="texture", uv=uv, material=rich), name="body"), "mesh 'body': not taken over: of its material normalTexture, metallicFactor$"),
        (Plain(quad, visual=visual(kind="vertex", vertex_colors=np.zeros((3, 4), np.uint8))), "its vertex colors are not one color for each"),
        (Plain(quad, visual=visual(kind="texture", uv=uv, material=visual(materials=[1, 2, 3]))), "its 3 materials"),
        (Plain(quad, visual=visual(kind="texture", uv=uv, material=visual(image=np.zeros((2, 2, 3)), diffuse=None))), "its texture is no picture of 8 bits"),
        (Legacy(quad, textures=[TILES, TILES], triangle_uvs=[(0, 0)] * 6, triangle_material_ids=[0, 1]), "its 2 textures are of several materials"),
        (Legacy(quad, textures=[TILES]), "its textures have no coordinates for each corner"),
    ]
    for thing, words in cases:
        with pytest.warns(rakelight.RakelightWarning, match=words):
            scene = rakelight.Scene.from_meshes([thing, thing])
        assert [(r.kind, r.times) for r in scene.remarks] == [("dropped", 2)]
    scene = rakelight.Scene.from_meshes(quad)
    with pytest.warns(rakelight.RakelightWarning, match="3 materials"):
        assert len(scene.with_meshes({0: cases[2][0]}).remarks) == 1


def test_a_texture_of_a_mesh(quad, tmp_path):
    mesh = replace(quad, uv=quad.vertices[:, :2] * (1, -1) + (0, 1), texture=TILES)
    seen = pixels(mesh)
    assert (seen[0, 0] == CORNERS[0, 0]).all() and (seen[3, 3] == CORNERS[1, 1]).all()
    rakelight.Scene.from_meshes(mesh).save(tmp_path / "tiles.glb")
    assert (pixels(str(tmp_path / "tiles.glb")) == seen).all()
    gray = replace(mesh, texture=TILES[:, :, 1], color=(1, 0, 0))
    assert (pixels(gray)[0, 3] == [255, 0, 0]).all() and (pixels(gray)[0, 0] == 0).all()
    for wrong in (TILES / 255.0, TILES[None], np.zeros((0, 4, 3), np.uint8), np.zeros((2, 2, 2), np.uint8)):
        with pytest.raises(rakelight.UsageError, match="texture: uint8 of the shape"):
            rakelight.Scene.from_meshes(replace(mesh, texture=wrong))
    with pytest.raises(rakelight.UsageError, match="needs texture coordinates"):
        rakelight.Scene.from_meshes(replace(quad, texture=TILES))
