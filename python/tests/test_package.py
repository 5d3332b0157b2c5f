# SPDX-License-Identifier: Apache-2.0
"""Types, docstrings, examples."""
import ast
import inspect
import pathlib
import re
import shutil
import subprocess
import sys
import warnings

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
        warnings.simplefilter("ignore", rakelight.RakelightWarning)
        for block in blocks:
            exec(compile("\n" + block, "docs/python.md", "exec"), names)
    assert (tmp_path / "helmet_fixed.glb").exists() and names["view"]["object"].shape == (128, 128)


def run(name, *words, code=0):
    done = subprocess.run([sys.executable, str(EXAMPLES / name), *map(str, words)], capture_output=True, text=True)
    assert done.returncode == code, done.stderr
    return done.stdout


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
