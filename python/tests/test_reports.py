# SPDX-License-Identifier: Apache-2.0
"""Explanations and inspections."""
import json
import os
import shutil

import pytest
from conftest import DATA

import rakelight


def test_an_explanation_is_of_the_picture_s_pixel(teapot):
    picture = rakelight.render(teapot, resolution=(64, 48), channels=["image", "color"])
    pixel = rakelight.explain(teapot, 30, 24, resolution=(64, 48))
    assert list(pixel.codes) == picture["image"][24, 30].tolist()
    assert list(pixel.color) == picture["color"][24, 30].tolist()
    assert pixel.sum == pixel.color and not pixel.is_background
    assert pixel.object in teapot.nodes and pixel.material == "porcelain"
    assert pixel.triangles[0]["fate"] == "visible" and "Light" in str(pixel)
    assert rakelight.explain(teapot, 0, 0, resolution=(64, 48)).is_background


def test_several_pixels(teapot):
    several = rakelight.explain_pixels(teapot, [(1, 2), (30, 24)], resolution=(64, 48))
    assert [(p.x, p.y) for p in several] == [(1, 2), (30, 24)]
    assert several[1] == rakelight.explain(teapot, 30, 24, resolution=(64, 48))


def test_an_inspection_is_the_program_s(program):
    model = DATA / "spot" / "spot_slab5.glb"
    row = json.loads(program.run("inspect", model, "--json"))["rows"][0]
    row.pop("remarks", None), row.pop("warnings", None)
    found = rakelight.inspect(model)
    for key in ("triangles", "bounds", "objects", "seams", "borders"):
        assert found[key] == row[key], key


def test_pictures_are_in_reports_as_they_are_named(program, monkeypatch):
    shutil.copytree(DATA / "head", program.folder / "models" / "head")
    monkeypatch.chdir(program.folder)
    expected = json.loads(program.run("inspect", "models/head/head.obj", "--json"))["rows"][0]["textures"]
    assert [texture["path"] for texture in expected] and not any(os.path.isabs(texture["path"]) for texture in expected)
    scene = rakelight.load("models/head/head.obj")
    assert rakelight.inspect(scene)["textures"] == expected
    monkeypatch.chdir("/")
    for other in (scene, scene.smooth(), scene.repair_seams(), scene.with_meshes({0: scene.meshes[0]})):
        assert rakelight.inspect(other)["textures"] == expected


def test_limits(teapot):
    assert "check" not in rakelight.inspect(teapot)
    assert rakelight.inspect(teapot, check={"closed": True})["check"]["failures"]
    assert rakelight.inspect(teapot, check={"max_seam": None, "no_degenerate": False})["check"]["passed"]
    split = DATA / "spot" / "spot_slab5.glb"  # with seams of more than a degree
    failed = rakelight.inspect(split, check=True)["check"]
    assert failed == rakelight.inspect(split, check={})["check"] == rakelight.inspect(split, check={"no_degenerate": True})["check"]
    assert not failed["passed"] and failed == rakelight.inspect(split, check={"max_seam": 1})["check"]
    assert rakelight.inspect(split, check={"max_seam": 180})["check"]["passed"] and "check" not in rakelight.inspect(split, check=False)
    with pytest.raises(rakelight.UsageError):
        rakelight.inspect(teapot, check={"perfect": True})
    with pytest.raises(rakelight.UsageError):
        rakelight.inspect(teapot, borders=False, check={"max_seam": 1})


def test_a_split_by_material_is_a_split(tmp_path):
    model = tmp_path / "car.obj"  # two squares in one plane, one object: their normals differ by 20 degrees
    corners = "v -1 0 0\nv 0 0 0\nv 0 0 -1\nv -1 0 -1\nv 1 0 0\nv 1 0 -1\nvn -0.173648 0.984808 0\nvn 0.173648 0.984808 0\n"
    model.write_text(f"o car\n{corners}usemtl red\nf 1//1 2//1 3//1 4//1\nusemtl blue\nf 2//2 5//2 6//2 3//2\n")
    scene = rakelight.load(model)
    found = rakelight.inspect(scene, check={"max_seam": 1})
    assert len(found["objects"]) == 1 and found["shared_positions"] == 2 and found["seams"]["seam_deg"] == pytest.approx(20, abs=1e-3)
    assert "of 'car'" in found["check"]["failures"][0]["message"]
    assert rakelight.inspect(scene.repair_seams(), check={"max_seam": 0.01})["check"]["passed"]
