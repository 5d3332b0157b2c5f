# SPDX-License-Identifier: Apache-2.0
"""Second source: back faces, the painter's algorithm, the z-buffer and what it keeps of a distance."""
from sheet import ROOT

from .kit import Entry

FRONT = ("--shading", "unlit", "--camera-position", "0,0,5", "--camera-focal-point", "0,0,0")
CYCLIC = ("data/visibility/cyclic.obj", *FRONT, "--camera-view-angle", "46")
CROSSING = ("data/visibility/crossing.obj", *FRONT, "--camera-view-angle", "36")
PLANES = ("data/visibility/near_planes.gltf",)
TEAPOT = ("builtin:teapot", "--camera-position", "1.6,1.5,2.4", "--camera-focal-point", "0.05,0.45,0", "--camera-view-angle", "41")
BALL = ("builtin:sphere", "--camera-position", "2.2,1.6,3.4", "--camera-focal-point", "0,0,0", "--camera-view-angle", "29")
BOX = ("data/visibility/open_box.obj", "--camera-position", "2.4,3.4,4.2", "--camera-focal-point", "0,0.5,0", "--camera-view-angle", "32")
FORMATS = ("z16", "z24", "z32", "z-float")
FAR = ("data/visibility/near_planes.gltf", "--camera-index", "1")


def seen_by(scene, method):
    return (*scene, "--visibility", method, "--samples", "1")


def measure_culling(kit):
    back, front, none = ("--cull", "back"), ("--cull", "front"), ("--cull", "none")
    stats = kit.stats((*BALL, *back))
    return {"faces of a closed sphere that culling drops [%]": 100 * stats["culled_back"] / stats["triangles_in"],
            "pixels of it that change [%]": kit.differing((*BALL, *none), (*BALL, *back), codes=0),
            "pixels of an open box that change [%]": kit.differing((*BOX, *none), (*BOX, *back)),
            "box treated as clockwise: cull back vs. cull front [% of pixels]":
                kit.differing((*BOX, *back, "--front-face", "cw", "--shading", "unlit"), (*BOX, *front, "--shading", "unlit"), codes=0)}


def draw_culling(kit, path):
    kit.sheet(path, [[(*BALL, "--cull", "none"), (*BALL, "--cull", "back"), (*BOX, "--cull", "none"), (*BOX, "--cull", "back")]], 190, 142,
              below=[["closed, all faces", "closed, front faces", "open, all faces", "open, front faces"]])


def turned(kit):
    """The cyclic overlap with its faces in the opposite order: (arguments)."""
    path = kit.folder / "turned.obj"
    lines = (ROOT / CYCLIC[0]).read_text().splitlines()
    groups, rest = [], []
    for line in lines:
        if line.startswith("usemtl"):
            groups.append([line])
        elif line.startswith("f "):
            groups[-1].append(line)
        elif not line.startswith(("o ", "g ")):
            rest.append(line)
    (kit.folder / "colors.mtl").write_text((ROOT / "data/visibility/colors.mtl").read_text())
    path.write_text("\n".join(rest + [line for group in reversed(groups) for line in group]) + "\n")
    return (path, *CYCLIC[1:])


def measure_painter(kit):
    found = {}
    for name, scene in (("cyclic overlap", CYCLIC), ("crossing triangles", CROSSING), ("teapot", TEAPOT)):
        found[f"{name}: pixels that the painter has wrong [%]"] = kit.differing(seen_by(scene, "painter"), seen_by(scene, "z-reversed"), 240, 240)
    other = turned(kit)
    found["cyclic overlap in the opposite order: pixels that change, painter [%]"] = kit.differing(seen_by(CYCLIC, "painter"), seen_by(other, "painter"), 240, 240)
    found["cyclic overlap in the opposite order: pixels that change, z-buffer [%]"] = kit.differing(seen_by(CYCLIC, "z24"), seen_by(other, "z24"), 240, 240)
    return found


def draw_painter(kit, path):
    kit.sheet(path, [[seen_by(scene, method) for scene in (CYCLIC, CROSSING) for method in ("painter", "z24")]], 180, 180,
              below=[["painter", "z-buffer", "painter", "z-buffer"]], colors=32)


def measure_buffer(kit):
    found = {}
    for name, scene in (("cyclic", CYCLIC), ("crossing", CROSSING), ("teapot", TEAPOT)):
        pictures = [seen_by(scene, method) for method in FORMATS]
        found[f"{name}: pixels that differ, the worst of four formats [%]"] = max(kit.differing(p, seen_by(scene, "z-reversed"), 240, 240) for p in pictures)
    for method in ("z16", "z24"):
        found[f"planes 2 cm apart at 20 m: pixels that {method} has wrong [%]"] = kit.differing(seen_by(PLANES, method), seen_by(PLANES, "z-reversed"), 240, 240)
    for near in ("0.15", "5"):
        planes = ("--near", near, "--far", "40")
        found[f"the same with near {near} m, far 40 m: pixels that z16 has wrong [%]"] = kit.differing((*seen_by(PLANES, "z16"), *planes), (*seen_by(PLANES, "z-reversed"), *planes), 240, 240)
    return found


def draw_buffer(kit, path):
    kit.sheet(path, [[TEAPOT, kit.channel(TEAPOT, "depth", 180, 180), seen_by(PLANES, "z16"), seen_by(PLANES, "z24")]], 180, 180,
              below=[["the picture", "its depths", "16 bits, 2 cm at 20 m", "24 bits"]], colors=64)


def measure_precision(kit):
    numbers = kit.stages(FAR)[1]("depth-precision")["numbers"]
    near, far = numbers["near [m]"], numbers["far [m]"]
    at = near + 0.02 * (far - near)
    return {"near [m]": near, "far [m]": far, "depths in the first 2 % of the range [%]": 100 * numbers["share of the depths in the first 2 % of the range"],
            "the same by the formula [%]": 100 * far * (at - near) / (at * (far - near)),
            "range that 98 % of the depths reach [%]": 100 * numbers["part of the range that 98 % of the depths reach"]}


def draw_precision(kit, path):
    folder, _ = kit.stages(FAR, 360, 240)
    kit.sheet(path, [[folder / "depth-curve.png", folder / "depth-steps.png"]], 640, 400, below=[["depth over distance", "step over distance, logarithms"]], colors=48)


ENTRIES = (
    Entry("s2-culling", "S2, back-face culling", "Back faces of closed objects can be dropped by the order of their corners; open objects need them", measure_culling, draw_culling),
    Entry("s2-painter", "S2, painter's algorithm", "A few triangles are enough for which no order of painting is right", measure_painter, draw_painter),
    Entry("s2-z-buffer", "S2, z-buffer", "One depth for each pixel, of 16 to 32 bits, solves visibility", measure_buffer, draw_buffer),
    Entry("s2-depth-precision", "S2, z-buffer", "With far = 1000 near, 98 % of the values describe the first 2 % of the range", measure_precision, draw_precision),
)
