# SPDX-License-Identifier: Apache-2.0
"""Pictures have the program's bits."""
import copy
import os
import shutil
import struct

import numpy as np
import pytest
from conftest import DATA

import rakelight

SIZE = (96, 72)
RESOLUTION = ("--resolution", "96,72")
CASES = [
    ("builtin:teapot", {}, ()),
    ("builtin:teapot", {"camera": "isometric"}, ("--view", "isometric")),
    ("builtin:teapot", {"shading": "gouraud", "samples": 1}, ("--shading", "gouraud", "--samples", "1")),
    ("builtin:teapot", {"background": "transparent"}, ("--background", "transparent")),
    ("builtin:teapot", {"look": "plain", "light": "none"}, ("--look", "plain", "--light", "none")),
    ("builtin:teapot", {"light": ["point:0,2,3", "ambient:0.1,0.1,0.1"]}, ("--light", "point:0,2,3", "--light", "ambient:0.1,0.1,0.1")),
    ("builtin:teapot", {"tone_mapping": "aces", "exposure": 1.5}, ("--tone-mapping", "aces", "--exposure", "1.5")),
    ("builtin:teapot", {"ambient_occlusion": True, "light_intensity": 0.5}, ("--ambient-occlusion", "--light-intensity", "0.5")),
    ("builtin:teapot", {"up": "+Z", "edges": True}, ("--up", "+Z", "--edges")),
    (DATA / "knight" / "Knight_noNormals.glb", {"shadows": True}, ("--shadows",)),
    (DATA / "spot" / "spot_slab5.glb", {"normals": "seams"}, ("--normals", "seams")),
    (DATA / "motion" / "door.gltf", {"animation_time": 0.5}, ("--animation-time", "0.5")),
    (DATA / "world" / "room.scene.toml", {}, ()),
    (DATA / "maps" / "wall.obj", {"bump": "occlusion"}, ("--bump", "occlusion")),
]


@pytest.mark.parametrize("model, settings, options", CASES)
def test_the_image_is_the_program_s_png(program, model, settings, options):
    picture = rakelight.render(model, resolution=SIZE, **settings)
    np.testing.assert_array_equal(picture["image"], program.image(model, *RESOLUTION, *options))


def test_a_window_is_a_part_of_the_picture(program, teapot):
    picture = rakelight.render(teapot, resolution=SIZE, window=(20, 10, 30, 40))
    np.testing.assert_array_equal(picture["image"], program.image("builtin:teapot", *RESOLUTION, "--window", "20,10,30,40"))


def test_points_are_drawn_as_the_program_draws_them(program, tmp_path):
    cloud = tmp_path / "cloud.ply"
    points = np.random.default_rng(1).normal(size=(500, 3)).astype("<f4")
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    header = "ply\nformat binary_little_endian 1.0\nelement vertex 500\n" + "".join(f"property float {n}\n" for n in ("x", "y", "z", "nx", "ny", "nz"))
    cloud.write_bytes(header.encode() + b"end_header\n" + np.hstack([points, points]).tobytes())
    np.testing.assert_array_equal(rakelight.render(cloud, resolution=SIZE)["image"], program.image(cloud, *RESOLUTION))


def test_a_camera_is_the_program_s(program, teapot):
    camera = rakelight.Camera((1.5, 2.25, 3.1), (0.1, 0.4, 0.0), up=(0.1, 1, 0), vertical_fov=33)
    asked = ("--camera-position", "1.5,2.25,3.1", "--camera-focal-point", "0.1,0.4,0", "--camera-view-up", "0.1,1,0", "--camera-view-angle", "33")
    np.testing.assert_array_equal(
        rakelight.render(teapot, camera, resolution=SIZE)["image"], program.image("builtin:teapot", *RESOLUTION, *asked)
    )


def test_channels_are_the_program_s_exr(program):
    model = DATA / "maps" / "wall.obj"
    layers = program.layers(model, *RESOLUTION, "--channels", "all")
    picture = rakelight.render(model, resolution=SIZE, channels=["color", "all"])
    names = {"color": "RGB", "depth": ["depth.Z"], "object": ["object.id"], "triangle": ["triangle.id"]}
    found = {}
    for layer, values in layers.items():
        found.setdefault(layer.partition(".")[0].replace("-", "_") if "." in layer else "color", {})[layer.rpartition(".")[2]] = values
    assert set(found) >= {"color", "depth", "normal", "object", "position", "uv", "tangent", "base_color", "specular"}, sorted(found)
    compared = 0
    for name, parts in found.items():
        array = picture[name] if picture[name].ndim == 3 else picture[name][..., None]
        orders = ("RGBA", "XYZW", "UV", "Z", "Y", "V", ("id",))
        order = next((o for o in orders if set(parts) <= set(o)), sorted(parts))
        for number, part in enumerate(p for p in order if p in parts):
            expected = parts[part]
            assert array[..., number].tobytes() == expected.tobytes(), (name, part, array[..., number], expected)
            compared += 1
    assert compared >= 30, names


def test_pictures_of_a_session_are_those_of_single_calls():
    scene = rakelight.load(DATA / "knight" / "Knight_noNormals.glb")
    settings = {"background": "white", "samples": 4, "light": "default"}
    session = rakelight.Session(scene, resolution=SIZE, **settings)
    for camera in ("front", None, rakelight.Camera.orbit(40, 20, 5), "back", "isometric"):
        single = rakelight.render(scene, camera, resolution=SIZE, channels=["image", "depth", "object"], **settings)
        view = session.render(camera, channels=["image", "depth", "object"])
        for name in ("image", "depth", "object"):
            np.testing.assert_array_equal(view[name], single[name])


def test_what_came_before_does_not_change_a_picture(teapot):
    session = rakelight.Session(teapot, resolution=SIZE)
    first = session.render("front")
    session.render("top", channels=["depth", "normal"], resolution=(40, 30))
    again = session.render("front")
    np.testing.assert_array_equal(first["image"], again["image"])
    other = rakelight.Session(teapot, resolution=SIZE)
    other.render("front", channels="depth")  # no colors: the look is taken later
    np.testing.assert_array_equal(other.render("front")["image"], first["image"])


def test_the_environment_stays_whatever_the_view(tmp_path):
    stl = tmp_path / "wedge.stl"
    stl.write_text("solid wedge\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in corners) + "endloop\nendfacet\n"
        for corners in [((0, 0, 0), (1, 0, 1), (0, 1, 0)), ((0, 0, 0), (0, 1, 0), (0, 0, 1))]) + "endsolid wedge\n")  # fmt: skip
    scene = rakelight.load(stl)
    session = rakelight.Session(
        scene, resolution=SIZE, hdri_file=str(DATA / "environment" / "ramp.hdr"), hdri_ambient=True, hdri_skybox=True)  # fmt: skip
    camera = rakelight.Camera.orbit(40, 20, 5)
    first = session.render(camera, channels="color")["color"]
    assert len(np.unique(first)) > 10
    np.testing.assert_array_equal(session.render(camera, channels="color")["color"], first)


def test_shapes_and_types(teapot):
    picture = rakelight.render(teapot, resolution=(40, 30), channels=["image", "color", "all"])
    shapes = {name: (array.shape, array.dtype) for name, array in picture.items()}
    assert shapes["image"] == ((30, 40, 3), np.uint8)
    assert shapes["color"] == ((30, 40, 4), np.float32)
    assert shapes["depth"] == ((30, 40), np.float32)
    assert shapes["face_normal"] == ((30, 40, 3), np.float32)
    assert shapes["tangent"] == ((30, 40, 4), np.float32)
    assert shapes["uv"] == ((30, 40, 2), np.float32)
    assert shapes["object"] == ((30, 40), np.uint32)
    assert all(array.flags.c_contiguous and array.flags.writeable for array in picture.values())
    nothing = ~np.isfinite(picture["depth"])
    assert nothing.any() and (picture["object"][nothing] == rakelight.NONE).all()
    assert set(np.unique(picture["object"][~nothing])) <= set(range(len(teapot.nodes)))


def test_only_asked_channels_are_there(teapot):
    assert list(rakelight.render(teapot, resolution=(8, 8), channels="face-normal")) == ["face_normal"]


@pytest.mark.parametrize("model, settings", [
    ("builtin:teapot", {}), (DATA / "knight" / "Knight_noNormals.glb", {"shadows": True}),
    (DATA / "maps" / "sheet.obj", {"height_map": DATA / "maps" / "brick_height.png", "bump": "occlusion", "bump_depth": 0.1}),
    (DATA / "maps" / "wall.obj", {"texture_normal": DATA / "maps" / "brick_normal.png"}), (DATA / "world" / "room.scene.toml", {}),
])  # fmt: skip
def test_data_without_colors_have_the_same_bits(model, settings):
    names = [name for name in rakelight.render(model, resolution=(8, 8), channels="all") if name not in ("ambient", "diffuse", "specular", "emission")]
    with_colors = rakelight.render(model, "isometric", resolution=SIZE, channels=["color", *names], **settings)
    alone = rakelight.render(model, "isometric", resolution=SIZE, channels=names, **settings)
    for name in names:
        assert alone[name].tobytes() == with_colors[name].tobytes(), name
    light = rakelight.render(model, "isometric", resolution=SIZE, channels="lighting", **settings)
    both = rakelight.render(model, "isometric", resolution=SIZE, channels=["image", "lighting"], **settings)
    for name in light:
        assert light[name].tobytes() == both[name].tobytes(), name


def test_intrinsics_and_matrix_take_positions_to_their_pixels(teapot):
    picture = rakelight.render(teapot, rakelight.Camera.orbit(30, 25, 4, (0, 0.5, 0)), resolution=(640, 480), channels=["position", "depth"])
    y, x = np.nonzero(np.isfinite(picture["depth"]))
    points = picture["position"][y, x].astype(np.float64)
    local = (points - picture.to_world[:3, 3]) @ picture.to_world[:3, :3] * (1, -1, -1)
    np.testing.assert_allclose(local[:, 2], picture["depth"][y, x], atol=3e-3)  # half the size of a pixel there
    pixels = local @ picture.intrinsics.T
    np.testing.assert_allclose(pixels[:, :2] / pixels[:, 2:], np.stack([x, y], 1) + 0.5, atol=0.01)


def test_png_and_npz(teapot, tmp_path):
    picture = rakelight.render(teapot, resolution=(40, 30), channels=["image", "depth"])
    picture.save(tmp_path / "a.png")
    data = (tmp_path / "a.png").read_bytes()
    assert data == picture._repr_png_() and struct.unpack(">II", data[16:24]) == (40, 30)
    picture.save(tmp_path / "a.npz")
    with np.load(tmp_path / "a.npz") as file:
        np.testing.assert_array_equal(file["depth"], picture["depth"])
        assert file["to_world"].shape == (4, 4)
    assert rakelight.render(teapot, resolution=(8, 8), channels="depth")._repr_png_() is None


def test_a_file_is_the_program_s(program, tmp_path):
    program.run("render", "builtin:teapot", "-o", tmp_path / "a.png", *RESOLUTION, "--grid")
    row = rakelight.render_file("builtin:teapot", tmp_path / "b.png", resolution=SIZE, grid=True)
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    assert row["width"] == 96 and row["triangles"] == 6320


@pytest.mark.parametrize("setting", [{"camera_zoom_factor": 0.5}, {"camera_orthographic": True}, {"camera_azimuth_angle": 30}])
def test_a_named_view_keeps_the_camera_settings_of_the_session(setting):
    scene = rakelight.load("builtin:teapot")
    session = rakelight.Session(scene, resolution=(64, 48), **setting)
    asked = rakelight.render(scene, None, view="front", resolution=(64, 48), **setting)["image"]
    assert (session.render("front")["image"] == asked).all()
    assert (session.render("front")["image"] == asked).all()
    assert (asked != rakelight.render(scene, "front", resolution=(64, 48))["image"]).any()


def test_the_picture_itself_is_a_channel_of_a_file(program, tmp_path, teapot):
    listed = rakelight.render_file(teapot, tmp_path / "a.exr", resolution=SIZE, channels=["image", "depth", "face_normal"])
    program.run("render", "builtin:teapot", "-o", tmp_path / "b.exr", *RESOLUTION, "--channels", "depth,face-normal")
    assert (tmp_path / "a.exr").read_bytes() == (tmp_path / "b.exr").read_bytes() and listed["width"] == 96
    rakelight.render_file(teapot, tmp_path / "c.png", resolution=SIZE, channels="image")
    rakelight.render_file(teapot, tmp_path / "d.png", resolution=SIZE)
    assert (tmp_path / "c.png").read_bytes() == (tmp_path / "d.png").read_bytes()
    assert {file.name for file in tmp_path.iterdir()} == {"a.exr", "b.exr", "c.png", "d.png"} | {f"{n}.{c}.exr" for n in "ab" for c in ("depth", "face-normal")}
    for channels in ([], ["image", "depht"]):
        with pytest.raises(rakelight.UsageError):
            rakelight.render_file(teapot, tmp_path / "e.png", channels=channels)


@pytest.mark.filterwarnings("ignore:.*normal map")
def test_files_are_found_after_the_working_directory_changes(tmp_path, monkeypatch):
    models = ["world/room.scene.toml", "head/head.obj"]
    for folder in ("world", "head"):
        shutil.copytree(DATA / folder, tmp_path / folder)
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path)
    for model in models:
        monkeypatch.chdir(tmp_path)
        expected = rakelight.render(model, resolution=SIZE)["image"]
        scene = rakelight.load(model)
        os.chdir(tmp_path / "elsewhere")
        np.testing.assert_array_equal(rakelight.render(scene, resolution=SIZE)["image"], expected)
        assert rakelight.render(scene.smooth(), resolution=(8, 6), channels="object")["object"].shape == (6, 8)
        assert scene.source == model


def test_a_copy_is_a_picture(teapot):
    picture = teapot.render("front", resolution=(16, 12), channels=["image", "depth"])
    for other in (picture.copy(), copy.copy(picture), copy.deepcopy(picture)):
        assert type(other) is rakelight.Picture and other.png() == picture.png() and other.near == picture.near
        del other["depth"]
        assert "depth" in picture
    assert picture.copy()["image"] is picture["image"] and copy.deepcopy(picture)["image"] is not picture["image"]


def test_cameras_with_the_same_numbers_are_equal():
    Camera = rakelight.Camera
    camera = Camera(np.array([1, 2, 3.5], np.float32), [0, 0, 0], up=np.array([0, 1, 0]), vertical_fov=np.float64(40))
    same = Camera((1, 2, 3.5), up=(0, 1, 0), vertical_fov=40)
    assert camera == same and hash(camera) == hash(same) and eval(repr(camera)) == camera
    assert camera != Camera((1, 2, 3.5), vertical_fov=40) and len({camera, same}) == 1
    matrix = np.eye(4)
    assert Camera.from_matrix(matrix) == Camera.from_matrix(matrix.tolist())
    for wrong in (None, "front", ["a", "b", "c"], 5, "123", b"123", np.str_("123"), ("1", "2", "3"), (1, 2, b"3"), np.array(["1", "2", "3"])):
        with pytest.raises(rakelight.UsageError, match="position: numbers"):
            Camera(wrong)
    for name in ("target", "up"):
        with pytest.raises(rakelight.UsageError, match=f"{name}: numbers"):
            Camera((0, 0, 1), **{name: "123"})
    with pytest.raises(rakelight.UsageError, match="vertical_fov: numbers"):
        Camera((0, 0, 1), vertical_fov="40")


def test_a_picture_is_shown_by_channels_and_shapes(teapot):
    picture = rakelight.render(teapot, resolution=(8, 6), channels=["image", "depth"])
    assert repr(picture) == "<rakelight.Picture image [6, 8, 3] uint8, depth [6, 8] float32>"


def test_a_camera_of_a_matrix_is_the_matrix_that_is_drawn(quad):
    rng = np.random.default_rng(4)
    for scale in (1, 3.5):
        for kind in (np.float64, np.float32):
            axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
            axes[:, 0] *= np.linalg.det(axes)  # right-handed
            matrix = np.eye(4)
            matrix[:3, :3], matrix[:3, 3] = axes, rng.normal(size=3)
            asked = matrix.copy()
            asked[:3, :3] *= scale  # a picture does not change with it
            drawn = rakelight.render(quad, rakelight.Camera.from_matrix(asked.astype(kind)), resolution=(8, 8), channels="object").to_world
            np.testing.assert_allclose(drawn, matrix, atol=1e-6)
