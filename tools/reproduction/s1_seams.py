# SPDX-License-Identifier: Apache-2.0
"""First source: heads of many objects by the three scopes; attributes stored with the model."""
import json
import shutil
import subprocess
import sys

from sheet import ROOT

from .kit import Entry

VIEW = ("--camera-position", "0.1,0.29,0.5", "--camera-focal-point", "0,0.282,0.1", "--camera-view-angle", "20",
        "--light", "point:0.5,0.5,0.6:color=0.9,0.85,0.8:attenuation=0.6,0.2,0.4",
        "--light", "point:-0.7,0.1,0.35:color=0.3,0.45,0.75:attenuation=0.4,0.2,0.4", "--light", "ambient:0.02,0.02,0.02")
PUBLISHED = ("--weight", "uniform", "--crease-angle", "180", "--tangents", "published")
SCOPES = {"face": "flat", "object": "object", "model": "model"}
SPOT = "data/spot/spot_slab5.glb"
SPOT_VIEW = ("--lighting", "blinn-phong", "--camera-position", "1.7,0.35,-1.15", "--camera-focal-point", "-0.02,0.42,-0.23", "--camera-view-angle", "36",
             "--light", "directional:-0.9,-0.7,1.1:color=0.68,0.66,0.63", "--light", "ambient:0.06,0.07,0.09")
SIDE = 320  # [px] of a picture of the page: seams are seen without enlarging it


def head(kit, is_colored=True):
    """The head scan, cut into six objects; without its color map seams are easier to see."""
    folder = kit.folder / ("colored" if is_colored else "gray")
    path = folder / "head6.obj"
    if not path.exists():
        folder.mkdir()
        for name in ("color.jpg", "normal_from_bump.png"):
            shutil.copy(ROOT / "data/head" / name, folder)
        lines = (ROOT / "data/head/head.mtl").read_text().splitlines()
        (folder / "head.mtl").write_text("\n".join(line for line in lines if is_colored or not line.startswith("map_Kd")) + "\n")
        subprocess.run([sys.executable, ROOT / "tools/make/cut_obj.py", ROOT / "data/head/head.obj", path, "--grid", "2,3,1"], check=True, capture_output=True)
    return path


def scopes(kit, is_colored=True):
    exposure = () if is_colored else ("--exposure", "-1.2")
    return {name: (head(kit, is_colored), *VIEW, *exposure, *PUBLISHED, "--normals", word) for name, word in SCOPES.items()}


def spot_scopes():
    """Spot has no map, and triangles that are large in the picture."""
    return {name: (SPOT, *SPOT_VIEW, *PUBLISHED, "--normals", word) for name, word in SCOPES.items()}


def measure_head(kit):
    found = {}
    for model, path, shown in (("Spot", SPOT, spot_scopes()), ("head scan", head(kit), scopes(kit))):
        for name, word in SCOPES.items():
            seams = kit.row("inspect", path, "--normals", word, "--crease-angle", "180", "--weight", "uniform")["seams"]
            found[f"{model}: largest seam between objects, {name} [degrees]"] = seams["before"]["max_deg"]
        face, per_object = (kit.rmse(shown[name], shown["model"], SIDE, SIDE) for name in ("face", "object"))
        found |= {f"{model}: per face vs. whole model [1/255]": face, f"{model}: per object vs. whole model [1/255]": per_object,
                  f"{model}: objects": len(kit.row("inspect", path)["objects"])}
    return found


def draw_head(kit, path):
    """Spot; and the bridge of the head scan's nose from nearby without color map. All colors are kept so that no band looks like a seam."""
    shown = list(spot_scopes().values())
    kit.sheet(path, [shown, [(one, shown[2], 4) for one in shown]], SIDE, SIDE, colors=0, below=[["face level", "per object", "whole model"], ["difference x 4"] * 3])
    parts = []
    for name, scene in scopes(kit, is_colored=False).items():
        parts.append(kit.folder / f"near-{name}.png")
        kit.run("render", *scene, "--look", "plain", "--samples", "4", "--resolution", "1120,1120", "--window", "390,230,170,170", "-o", parts[-1], "--quiet")
    kit.sheet(path.with_name(f"{path.stem}-near.png"), [parts], 255, 255, below=[["face level", "per object", "whole model"]], colors=0)


def measure_stored(kit):
    """Is a model that was stored with its normals the same as one that gets them when it is loaded?"""
    stored, scene = kit.folder / "stored.glb", ("--view", "left", "--bump", "none")
    kit.run("smooth", SPOT, "-o", stored, "--normals", "model", "--quiet")
    loaded, own = (SPOT, *scene, "--normals", "model"), (stored, *scene, "--normals", "file")
    return {"largest difference of the pictures [1/255]": 255 * kit.compare(loaded, own)["max_error"],
            "without stored normals vs. with them [1/255]": kit.rmse((SPOT, *scene, "--normals", "flat"), own)}


def draw_stored(kit, path):
    kit.run("smooth", SPOT, "-o", kit.folder / "stored.glb", "--normals", "model", "--quiet")
    scene = ("--view", "left", "--bump", "none")
    loaded, own = (SPOT, *scene, "--normals", "model"), (kit.folder / "stored.glb", *scene, "--normals", "file")
    kit.sheet(path, [[(SPOT, *scene, "--normals", "flat"), loaded, own, (loaded, own, 64)]], 180, 135, below=[["none in the file", "made at load", "stored", "difference x 64"]])


def time_attributes(kit):
    done = kit.run("bench", "smooth", "--triangles", "20k", "--objects", "16", "--repetitions", "3", "--brute-force", "--json")
    rows = {row["what"]: row["ns_per_triangle"] * 20e3 / 1e6 for row in json.loads(done.stdout)["rows"]}
    return {f"20k triangles, {what} [ms]": rows[what] for what in ("brute force, normals", "normals", "normals + tangents")}


ENTRIES = (
    Entry("s1-fig9-12", "S1 fig. 9, 11, 12", "A head of many objects: facets with attributes per face, seams per object, no seams over the whole model", measure_head, draw_head),
    Entry("s1-stored", "S1 section 3.1", "Attributes computed at load can take seconds, so they are stored", measure_stored, draw_stored, time_attributes),
)
