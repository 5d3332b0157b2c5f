# SPDX-License-Identifier: Apache-2.0
"""Types, docstrings, examples."""
import ast
import inspect
import os
import pathlib
import re
import shutil
import subprocess
import sys
import warnings
from dataclasses import replace

import pytest
from conftest import DATA, ROOT

import rakelight
from rakelight import _core

EXAMPLES = ROOT / "python" / "examples"


def test_types_are_strict():
    pytest.importorskip("mypy")
    done = subprocess.run([sys.executable, "-m", "mypy", "--cache-dir=/dev/null", "--strict", str(ROOT / "python" / "rakelight")],
                          capture_output=True, text=True)  # fmt: skip
    assert done.returncode == 0, done.stdout


def test_the_stub_names_what_the_extension_has():
    tree = ast.parse((pathlib.Path(rakelight.__file__).parent / "_core.pyi").read_text())
    named = {node.name for node in tree.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))} | {"__version__"}
    assert named == {name for name in dir(_core) if not name.startswith("__")} | {"__version__"}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            methods = {m.name for m in node.body if isinstance(m, ast.FunctionDef)} - {"__init__"}
            assert methods == {name for name in dir(getattr(_core, node.name)) if not name.startswith("_")}


def test_all_public_names_are_described():
    for name in rakelight.__all__:
        thing = getattr(rakelight, name)
        if inspect.isfunction(thing) or (inspect.isclass(thing) and thing.__module__.startswith("rakelight")):
            assert thing.__doc__ and not thing.__doc__.startswith(f"{name}("), name
    for type_ in (rakelight.Scene, rakelight.Session, rakelight.Camera, rakelight.Attributes, rakelight.Picture):
        for name, member in vars(type_).items():
            if not name.startswith("_") and callable(member):
                assert member.__doc__, f"{type_.__name__}.{name}"


def test_the_page_runs(tmp_path, monkeypatch):
    blocks = re.findall(r"^```python\n(.*?)^```", (ROOT / "docs" / "python.md").read_text(), re.M | re.S)
    assert len(blocks) > 8
    shutil.copy(DATA / "spot" / "spot_slab5.glb", tmp_path / "helmet.glb")
    monkeypatch.chdir(tmp_path)
    names = {}
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # of numpy, too
        warnings.simplefilter("ignore", rakelight.RakelightWarning)
        for block in blocks:
            exec(compile("\n" + block, "docs/python.md", "exec"), names)
    assert names["np"].isfinite(names["points"]).all() and len(names["points"]) == names["seen"].sum() > 100
    assert (tmp_path / "helmet_fixed.glb").exists() and names["view"]["object"].shape == (128, 128)


def run(name, *words, code=0):
    """What it prints; where it fails, what it says."""
    done = subprocess.run([sys.executable, str(EXAMPLES / name), *map(str, words)], capture_output=True, text=True)
    assert done.returncode == code, done.stderr
    return done.stdout or done.stderr


def test_example_dataset(tmp_path):
    import numpy as np

    run("dataset.py", "builtin:teapot", tmp_path, "--views", 5, "--size", 64)
    assert len(list(tmp_path.glob("*.png"))) == 5
    with np.load(tmp_path / "0003.npz") as view:
        assert set(view.files) == {"depth", "normal", "object", "triangle"} and np.isfinite(view["depth"]).any()


def test_example_seam_gate(tmp_path):
    model = DATA / "spot" / "spot_slab5.glb"
    assert "part0" in run("seam_gate.py", model, "nowhere.glb", "--repair", tmp_path, code=1)
    assert run("seam_gate.py", tmp_path / model.name).startswith("ok")


def test_example_training_arrays(tmp_path):
    import numpy as np

    run("training_arrays.py", DATA / "spot" / "spot_slab5.glb", "--folder", tmp_path)
    with np.load(tmp_path / "spot_slab5.npz") as arrays:
        assert np.abs(arrays["position"]).max() == pytest.approx(1)
        assert np.linalg.norm(arrays["normal"], axis=1) == pytest.approx(1, abs=1e-5)
        assert arrays["face"].max() < len(arrays["position"])


def test_training_arrays_of_a_mirrored_object_face_outward(tmp_path):
    import numpy as np

    scene = rakelight.load("builtin:sphere")
    placed = [
        replace(mesh, name=name, to_world=np.diag([side, 1.0, 1.0, 1.0]) + 3 * side * np.eye(4)[[0]].T @ np.eye(4)[[3]])
        for mesh in scene.placed_meshes()
        for name, side in (("left", -1.0), ("right", 1.0))
    ]
    rakelight.Scene.from_meshes(placed).save(tmp_path / "spheres.glb")
    run("training_arrays.py", tmp_path / "spheres.glb", "--folder", tmp_path)
    with np.load(tmp_path / "spheres.npz") as arrays:
        corners = arrays["position"][arrays["face"]]
        outward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        centers = np.sign(corners[:, 0, :1]) * [0.75, 0, 0]
        assert set(np.sign(corners[:, 0, 0])) == {-1, 1}
        assert (np.sum(outward * (corners.mean(axis=1) - centers), axis=1) > 0).all()
        assert (np.sum(outward * arrays["normal"][arrays["face"][:, 0]], axis=1) > 0).all()


@pytest.mark.parametrize("text", ['{"asset": {"version": "2.0"}}', '{"asset": {"version": "2.0"}, "nodes": [{"name": "a"}]}'])
def test_training_arrays_of_nothing(tmp_path, text):
    (tmp_path / "empty.gltf").write_text(text)
    said = run("training_arrays.py", tmp_path / "empty.gltf", "--folder", tmp_path, code=1)
    assert said.startswith(str(tmp_path / "empty.gltf")) and said.count("\n") == 1, said
    points = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n"
    (tmp_path / "points.ply").write_text(points)
    assert run("training_arrays.py", tmp_path / "points.ply", code=1).endswith("points.ply: there are no triangles\n")
    assert "nowhere.glb" in run("training_arrays.py", "nowhere.glb", "--folder", tmp_path, code=1)


def test_the_tag_of_a_wheel_is_what_its_files_ask_for(tmp_path, monkeypatch):
    import repair_wheel

    file = tmp_path / "_core.so"
    file.write_bytes(b"\x7fELF")
    versions = ["GLIBC_2.2.5", "GLIBC_2.34"]
    monkeypatch.setattr(repair_wheel, "output", lambda *command: "".join(f"  0x0010:   Name: {v}  Flags: none\n" for v in versions))
    monkeypatch.setattr(repair_wheel.platform, "machine", lambda: "aarch64")
    assert repair_wheel.platform_tag(tmp_path) == "manylinux_2_36_aarch64"
    assert repair_wheel.too_new(file, (2, 36)) == []
    versions += ["GLIBC_2.38", "GLIBCXX_3.4.31"]
    assert repair_wheel.platform_tag(tmp_path) == "manylinux_2_38_aarch64"
    assert repair_wheel.too_new(file, (2, 36)) == ["GLIBC_2.38", "GLIBCXX_3.4.31"]
    assert repair_wheel.too_new(file, repair_wheel.glibc_of("rakelight-1-cp3-cp3-manylinux_2_38_aarch64.whl")) == ["GLIBCXX_3.4.31"]


def cached(build):
    """{name: value} of what a build folder was configured with."""
    lines = re.findall(r"^(\w+):\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.M)
    return dict(lines)


def test_what_is_installed(tmp_path):
    build = pathlib.Path(rakelight.__file__).parents[2]
    if not (build / "CMakeCache.txt").exists() or not shutil.which("cmake"):
        pytest.skip("the module is in no build folder")
    cache = cached(build)
    if any(os.path.isabs(cache[name]) for name in ("RAKELIGHT_PYTHON_DIR", "CMAKE_INSTALL_LIBDIR")):
        pytest.skip("the module or the library would be installed outside of the test's folder")
    if cache.get("CMAKE_SKIP_INSTALL_RPATH") in ("ON", "1", "TRUE", "YES"):
        pytest.skip("the package of a distribution finds the library in the system's folder alone")
    for component in ("python", "library"):
        command = ["cmake", "--install", str(build), "--component", component, "--prefix", str(tmp_path)]
        subprocess.run(command, check=True, capture_output=True)
    files = {str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*") if path.is_file()}
    names = {pathlib.PurePath(file).name for file in files}
    assert {"METADATA", "py.typed", "_core.pyi", "__init__.py"} < names and "rakelight-import" not in names
    assert not any("__pycache__" in file for file in files)
    package = next(tmp_path.rglob("py.typed")).parent
    assert {path.name for path in (ROOT / "python" / "rakelight").iterdir() if path.suffix in (".py", ".pyi")} < names
    script = "import importlib.metadata, rakelight; print(importlib.metadata.version('rakelight'), rakelight.__version__, rakelight.__file__)"
    environment = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
    environment.update({"PYTHONPATH": str(package.parent), "PYTHONDONTWRITEBYTECODE": "1"})
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, env=environment, cwd=tmp_path)
    assert done.stdout.split() == [rakelight.__version__] * 2 + [str(package / "__init__.py")], done.stderr


@pytest.mark.parametrize("folder, way", [
    ("lib/python3/dist-packages", "$ORIGIN/../../.."), ("/opt/venv/lib/python3.11/site-packages", "$ORIGIN/../../../../../../usr/local/lib"),
    ("/usr/local/lib/python3/dist-packages", "$ORIGIN/../../.."), ("../share/python/", "$ORIGIN/../../../local/lib"),
])  # fmt: skip
def test_where_the_module_looks_for_the_library(tmp_path, folder, way):
    if not shutil.which("cmake"):
        pytest.skip("there is no cmake")
    script = tmp_path / "way.cmake"
    script.write_text(f"""set(CMAKE_INSTALL_PREFIX /usr/local)
set(CMAKE_INSTALL_FULL_LIBDIR /usr/local/lib)
include({ROOT}/python/InstallRpath.cmake)
rl_python_rpath(way "{folder}")
file(WRITE {tmp_path}/way "${{way}}")
""")
    subprocess.run(["cmake", "-P", str(script)], check=True)
    assert (tmp_path / "way").read_text().rstrip("/") == way
