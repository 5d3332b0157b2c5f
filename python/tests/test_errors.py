# SPDX-License-Identifier: Apache-2.0
"""What is wrong is an exception that says so; nothing crashes."""
import re

import numpy as np
import pytest
from conftest import ROOT

import rakelight
from rakelight._run import settings_of

NAN, INF = float("nan"), float("inf")


def test_an_error_says_where(tmp_path):
    with pytest.raises(FileNotFoundError) as caught:
        rakelight.load("nowhere.glb")
    assert isinstance(caught.value, rakelight.NotFoundError) and isinstance(caught.value, rakelight.Error)
    assert caught.value.file == "nowhere.glb" and caught.value.reason and str(caught.value).startswith("nowhere.glb: ")
    broken = tmp_path / "broken.scene.toml"
    broken.write_text("[[light]]\ntype = 'sun'\n")
    with pytest.raises(rakelight.BadFileError) as caught:
        rakelight.load(broken)
    assert caught.value.file == str(broken) and "line 2" in caught.value.place


def test_a_setting_that_is_not_there_names_the_nearest(teapot):
    with pytest.raises(rakelight.UsageError, match="shadows"):
        rakelight.render(teapot, shadow=True)
    with pytest.raises(ValueError) as caught:
        rakelight.render(teapot, shading="fong")
    assert caught.value.setting == "shading"


@pytest.mark.parametrize("options", [
    {"resolution": (0, 10)}, {"resolution": (10,)}, {"resolution": (10, 10, 10)}, {"resolution": (70000, 10)}, {"resolution": "big"},
    {"resolution": (NAN, 1)}, {"window": (0, 0, 100, 100), "resolution": (10, 10)}, {"channels": []}, {"channels": ["color", "depht"]},
    {"camera": "nobody"}, {"camera": 7}, {"camera": 1.5}, {"camera": True},
    {"samples": 3}, {"light": object()}, {"grid": True}, {"channels": ["albedo"]},
])  # fmt: skip
def test_arguments_that_cannot_be(teapot, options):
    with pytest.raises(rakelight.UsageError):
        rakelight.render(teapot, **options)


@pytest.mark.parametrize("options, words", [
    ({"turntable": 36}, "turntable: is an option of the program, not of Python; draw the frames with Session"), ({"threads": 4}, r"use set_threads\(\)"),
    ({"output": "a.png"}, r"use render_file\(\)"), ({"watch": True}, "watch: is an option of the program"),
    ({"shadow_sise": 64}, "there is no setting 'shadow_sise'; did you mean 'shadow_size'"), ({"qqqqqqqq": 1}, "there is no setting 'qqqqqqqq'$"),
])  # fmt: skip
def test_a_setting_of_the_program_alone_is_said_to_be_one(teapot, options, words):
    for draw in (rakelight.render, rakelight.Session, rakelight.inspect):
        with pytest.raises(rakelight.UsageError, match=words) as caught:
            draw(teapot, **options)
        assert "[render]" not in str(caught.value)


def test_every_option_of_the_program_is_a_setting_or_is_said_to_be_none(teapot):
    options = (ROOT / "docs" / "command-line.md").read_text().split("\n## render\n")[1].split("\n## ")[0]
    names = {name for row in re.findall(r"^\| `(-[^`]*)`", options, re.M) for name in re.findall(r"--([a-z][a-z-]*)", row)}
    assert len(names) > 100
    page = (ROOT / "docs" / "python.md").read_text()
    for name in names:
        try:
            settings_of({name.replace("-", "_"): "1"})
        except rakelight.UsageError as error:
            assert "is an option of the program" in str(error), name
            assert f"`--{name}`" in page or name.startswith("ref-"), name


def test_worlds_name_glsl_only_where_that_is_allowed(tmp_path):
    (tmp_path / "own.glsl").write_text("LightTerms user_terms(MaterialSurface s, LightSample light) { return no_terms(); }\n")
    world = tmp_path / "a.scene.toml"
    world.write_text("[[primitive]]\ntype = 'sphere'\n[render]\nlighting = 'own.glsl'\n")
    with pytest.raises(rakelight.BadFileError, match="allow-shaders") as refused:
        rakelight.load(world).render(resolution=(8, 8))
    assert refused.value.place == "line 4, column 1"
    with pytest.raises(rakelight.UsageError, match="engine soft cannot"):
        rakelight.load(world, allow_shaders=True).render(resolution=(8, 8))


def test_a_camera_that_is_not_there_names_the_sides(teapot, tmp_path):
    for draw in (rakelight.render, lambda scene, camera: rakelight.explain(scene, 1, 1, camera),
                 lambda scene, camera: rakelight.render_file(scene, tmp_path / "a.png", camera)):  # fmt: skip
        with pytest.raises(rakelight.UsageError, match="camera: there is no side or camera 'frnt'; did you mean 'front'"):
            draw(teapot, "frnt")
        with pytest.raises(rakelight.UsageError, match="sides are front, back, .*; the model has no cameras"):
            draw(teapot, 3)
    world = tmp_path / "a.scene.toml"
    world.write_text("[[model]]\nfile = 'builtin:teapot'\n[[camera]]\nname = 'Door'\nposition = [0, 0, 3]\n")
    scene = rakelight.load(world)
    door = scene.render("Door", resolution=(16, 16))
    assert (door.to_world == scene.render(0, resolution=(16, 16)).to_world).all()
    with pytest.raises(rakelight.UsageError, match="did you mean 'Door'"):
        scene.render("Doro")
    with pytest.raises(rakelight.UsageError, match="the model's cameras are 'Door'"):
        scene.render("1")


def test_a_session_draws_in_its_own_settings(teapot):
    with pytest.raises(rakelight.UsageError, match="shadows: is no argument of a session's render.*Session\\(scene"):
        rakelight.Session(teapot, resolution=(8, 8)).render("front", shadows=True)


@pytest.mark.parametrize("call, words", [
    (lambda s: rakelight.load_bytes("abc", "a.glb"), "data: bytes are expected, not str"), (lambda s: rakelight.load_bytes(b"x", None), "a file's name"),
    (lambda s: rakelight.load("a.glb", max_memory="1G"), "max_memory: a whole number"), (lambda s: rakelight.load("a.glb", max_memory=-1), "max_memory: must be 0"),
    (lambda s: rakelight.load("a.glb", max_memory=2**64), "max_memory: must be 0"), (lambda s: rakelight.Session(s, max_memory=-1), "max_memory"),
    (lambda s: rakelight.set_threads("4"), "threads: a whole number"), (lambda s: rakelight.set_threads(1025), "threads: must be 0 to 1024"),
    (lambda s: rakelight.explain(s, "a", 1), "x: a whole number"), (lambda s: rakelight.explain(s, 1, 2**40), "y: must be"),
    (lambda s: rakelight.explain_pixels(s, [1]), r"pixels: \(x, y\) is expected, not 1"), (lambda s: s.repair_seams(crease_angle="a"), "crease_angle"),
    (lambda s: s.repair_seams(crease="a"), "crease"), (lambda s: s.repair_seams(crease=1), "crease"),
    (lambda s: s.repair_seams(border_distance=None), "border_distance"), (lambda s: s.render(channels=None), "channels: a name"),
    (lambda s: s.render(channels=[1]), "channels: a name"), (lambda s: s.render(progress=3), "progress: True or a function"),
    (lambda s: rakelight.smooth_file("a.glb", "b.glb", border_distance="x"), "border_distance"),
    (lambda s: rakelight.smooth_file("a.glb", "b.glb", tangents=None), "tangents: 'auto'"), (lambda s: rakelight.attributes([], objects=["a"]), "objects: a whole"),
    (lambda s: rakelight.Session(s).render(threads=2), r"set_threads\(\)"), (lambda s: rakelight.Session(s).render(chanels="depth"), "did you mean 'channels'"),
])  # fmt: skip
def test_an_argument_of_the_wrong_type_is_named(teapot, call, words):
    with pytest.raises(rakelight.UsageError, match=words) as caught:
        call(teapot)
    assert "\n" not in str(caught.value)


def test_limits_that_are_not_there(teapot):
    with pytest.raises(rakelight.UsageError, match="there is no limit 'maxseam'; did you mean 'max_seam'"):
        rakelight.inspect(teapot, check={"maxseam": 1})
    with pytest.raises(rakelight.UsageError, match="use max_seam, no_degenerate, .*unit_normals"):
        rakelight.inspect(teapot, check={"qqqqqqqq": 1})
    for wrong in (1.0, "closed", ["closed"], {1: 2}):
        with pytest.raises(rakelight.UsageError, match="check: True or limits"):
            rakelight.inspect(teapot, check=wrong)
    with pytest.raises(rakelight.UsageError, match="borders=True"):
        rakelight.inspect(teapot, borders=False, check=True)


@pytest.mark.parametrize("make, words", [
    (lambda: rakelight.Camera((NAN, 0, 0)), "position: three finite numbers"), (lambda: rakelight.Camera((1, 2)), "position: three"),
    (lambda: rakelight.Camera((0, 0, 1), (0, 0)), "target: three"), (lambda: rakelight.Camera((0, 0, 1), up=(0, 0, 0)), "up: "),
    (lambda: rakelight.Camera((0, 0, 1), vertical_fov=180), "vertical_fov: .* not 180"), (lambda: rakelight.Camera((0, 0, 1), vertical_fov=200), "not 200"),
    (lambda: rakelight.Camera((0, 0, 1), horizontal_fov=0), "horizontal_fov"), (lambda: rakelight.Camera((0, 0, 1), near=-1), "near: "),
    (lambda: rakelight.Camera((0, 0, 1), far=NAN), "far: "), (lambda: rakelight.Camera((0, 0, 1), near=2, far=1), "near must be less than far"),
    (lambda: rakelight.Camera((1, 2, 3), (1, 2, 3)), "same point"), (lambda: rakelight.Camera.from_matrix(np.zeros((4, 4))), "last row"),
    (lambda: rakelight.Camera.from_matrix(np.diag([0, 0, 0, 1])), "axes"), (lambda: rakelight.Camera.from_matrix(np.diag([-1, 1, 1, 1])), "left-handed"),
    (lambda: rakelight.Camera.from_matrix(np.eye(4)[[1, 0, 2, 3]]), "left-handed"), (lambda: rakelight.Camera.from_matrix(np.diag([1, 2, 1, 1])), "different lengths"),
    (lambda: rakelight.Camera.from_matrix([[1, 0.1, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]), "perpendicular"), (lambda: rakelight.Camera.from_matrix(np.eye(3)), "shape"),
    (lambda: rakelight.Camera.orbit(0, 0, 1, target=(0, 0)), "target: three"), (lambda: rakelight.Camera.orbit("a", 0, 1), "azimuth"),
    (lambda: rakelight.Mesh(np.zeros((3, 2)), [[0, 1, 2]]), r"vertices: the shape must be \(n, 3\), not \(3, 2\)"),
    (lambda: rakelight.Mesh(TRIANGLE, [0, 1, 2]), "faces: the shape"), (lambda: rakelight.Mesh(TRIANGLE, [[0, 1, 2], [0]]), "faces: .*several lengths"),
    (lambda: rakelight.Mesh(TRIANGLE, [[0, 1]]), "faces: the shape"), (lambda: rakelight.Mesh(TRIANGLE, None), "faces: an array"),
    (lambda: rakelight.Mesh(TRIANGLE, [[0, 1, 2]], uv=TRIANGLE), "uv: the shape"),
    (lambda: rakelight.Mesh(TRIANGLE, [[0, 1, 2]], to_world=np.eye(3)), "to_world: the shape"),
])  # fmt: skip
def test_cameras_and_meshes_are_looked_at_when_they_are_made(make, words):
    with pytest.raises(rakelight.UsageError, match=words):
        make()


TRIANGLE = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]


@pytest.mark.parametrize("mesh, words", [
    ((np.zeros((3, 2)), [[0, 1, 2]]), r"vertices: the shape must be \(n, 3\), not \(3, 2\)"),
    ((np.zeros(9), [[0, 1, 2]]), "vertices: the shape"),
    ((np.zeros((3, 3, 3)), [[0, 1, 2]]), "vertices: the shape"),
    ((np.array(["a", "b", "c"]), [[0, 1, 2]]), "vertices"),
    ((np.zeros((3, 3), complex), [[0, 1, 2]]), "vertices: numbers are expected, not complex128"),
    ((np.zeros((3, 3), object), [[0, 1, 2]]), "vertices: numbers"),
    ((None, [[0, 1, 2]]), "vertices"),
    ((TRIANGLE, None), "faces"),
    ((TRIANGLE, [[0, 1, 3]]), "index 3 of triangle 0 is not one of the 3 vertices"),
    ((TRIANGLE, [[0, 1, 2], [0, -1, 2]]), "index -1 of triangle 1"),
    ((TRIANGLE, np.array([[0, 1, 2**40]])), "index 1099511627776"),
    ((TRIANGLE, np.array([[0, 1, 2**63]], np.uint64)), "index 9223372036854775808"),
    ((TRIANGLE, [[0.0, 1.0, 2.0]]), "faces: integers are expected, not float64"),
    ((TRIANGLE, [[0, 1, 2, 0]]), "faces: the shape must be"),
    ((TRIANGLE, [[True, False, True]]), "faces: integers"),
    (([], [[0, 1, 2]]), "not one of the 0 vertices"),
])  # fmt: skip
def test_meshes_that_cannot_be(mesh, words):
    with pytest.raises(rakelight.UsageError, match=words):
        rakelight.attributes(mesh)
    with pytest.raises(rakelight.UsageError, match=words):
        rakelight.Scene.from_meshes([mesh])


@pytest.mark.parametrize("name, values", [
    ("normals", np.zeros((2, 3))), ("normals", np.zeros((3, 4))), ("uv", np.zeros((3, 3))), ("tangents", np.zeros((3, 3))),
    ("colors", np.zeros((3, 3))), ("to_world", np.eye(3)), ("to_world", np.full((4, 4), NAN)), ("to_world", np.ones((4, 4))),
    ("color", [1]), ("color", "red"),
])  # fmt: skip
def test_arrays_that_do_not_fit(name, values):
    with pytest.raises(rakelight.UsageError, match=name):
        rakelight.Scene.from_meshes(rakelight.Mesh(TRIANGLE, [[0, 1, 2]], **{name: values}))


def test_what_is_no_mesh():
    for thing in (5, object(), "teapot", [3], {"a": 1}):
        with pytest.raises(rakelight.UsageError):
            rakelight.Scene.from_meshes(thing)


def test_numbers_that_are_not_finite_have_no_say():
    vertices = np.array(TRIANGLE + [[NAN, 0, 0], [INF, 1, 1]], np.float32)
    made = rakelight.attributes((vertices, [[0, 1, 2], [0, 1, 3], [1, 2, 4]]))[0]
    assert made.degenerate_faces == 2 and np.isfinite(made.normals).all()
    scene = rakelight.Scene.from_meshes((vertices, [[0, 1, 2], [0, 1, 3]]))
    assert rakelight.render(scene, resolution=(16, 16))["image"].shape == (16, 16, 3)


@pytest.mark.parametrize("vertices, faces", [
    (np.zeros((0, 3)), np.zeros((0, 3), int)), ([], []), (TRIANGLE, []), (TRIANGLE, np.zeros((0, 3))), (TRIANGLE, [[0, 0, 0]]),
])  # fmt: skip
def test_nothing_is_fine_for_attributes_and_nothing_to_draw(vertices, faces):
    made = rakelight.attributes((vertices, faces))[0]
    assert made.normals.shape == (len(vertices), 3)
    if len(faces) == 0:
        with pytest.raises(rakelight.BadFileError, match="nothing to draw"):
            rakelight.render((vertices, faces))


def test_no_meshes():
    assert rakelight.attributes([]) == []
    with pytest.raises(rakelight.BadFileError):
        rakelight.render([])


@pytest.mark.parametrize("options", [
    {"normals": "all"}, {"scope": "all"}, {"normals": None}, {"normals": "face", "scope": "object"}, {"weight": "heavy"}, {"weight": 1},
    {"crease": "soft"}, {"crease": 60},
    {"crease_angle": "wide"}, {"weld_distance": "far"}, {"crease_angle": 181}, {"crease_angle": NAN}, {"weld_distance": -1}, {"weld_distance": NAN},
    {"weld_distance": INF}, {"tangent_mode": "own"}, {"objects": [1]},
])  # fmt: skip
def test_options_of_attributes_that_cannot_be(quad, options):
    with pytest.raises(rakelight.UsageError):
        rakelight.attributes([quad, quad], **options)


def test_endings_that_nobody_writes(teapot, tmp_path):
    with pytest.raises(rakelight.UsageError, match="use .glb, .gltf, .obj or .ply"):
        teapot.save(tmp_path / "a.stl")
    with pytest.raises(rakelight.UsageError):
        rakelight.render(teapot, resolution=(8, 8)).save(tmp_path / "a.bmp")
    with pytest.raises(rakelight.Error):
        rakelight.render_file(teapot, tmp_path / "a.doc")
    with pytest.raises(rakelight.UsageError):
        rakelight.smooth_file("a.glb", "b.glb", normals="all")
    with pytest.raises(rakelight.UsageError, match="Python makes no movies.*rakelight render"):
        rakelight.render_file(teapot, tmp_path / "turn.MP4")
    with pytest.raises(rakelight.UsageError):
        rakelight.set_threads(-1)
    with pytest.raises(rakelight.UsageError):
        rakelight.explain(teapot, 5000, 0)


def test_a_file_is_a_name_and_its_content_is_not_printed(teapot, tmp_path):
    for draw in (rakelight.load, rakelight.render, rakelight.inspect):
        with pytest.raises(rakelight.UsageError, match="load_bytes") as caught:
            draw(b"glTF\x02\0\0\0secret")
        assert "secret" not in str(caught.value)
    for wrong in (None, 5, b"a.glb"):
        for call in (rakelight.load, teapot.save, lambda path: rakelight.smooth_file(path, "a.glb"), lambda path: rakelight.render_file(teapot, path)):
            with pytest.raises(rakelight.UsageError, match="a file's name is expected"):
                call(wrong)


def test_a_picture_makes_its_folder_or_says_why_not(teapot, tmp_path):
    picture = rakelight.render(teapot, resolution=(8, 8))
    picture.save(tmp_path / "new" / "folder" / "a.png")
    picture.save(tmp_path / "other" / "a.npz")
    assert (tmp_path / "new" / "folder" / "a.png").read_bytes() == picture.png()
    with np.load(tmp_path / "other" / "a.npz") as saved:
        assert (saved["image"] == picture["image"]).all()
    (tmp_path / "file").write_text("")
    with pytest.raises(rakelight.Error, match="cannot be written") as caught:
        picture.save(tmp_path / "file" / "a.png")
    assert caught.value.file == str(tmp_path / "file" / "a.png")


def test_a_scene_stays_when_a_call_fails(teapot):
    session = rakelight.Session(teapot, resolution=(16, 16))
    with pytest.raises(rakelight.UsageError):
        session.render("nobody")
    assert session.render("front")["image"].shape == (16, 16, 3)
