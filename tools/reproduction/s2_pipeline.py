# SPDX-License-Identifier: Apache-2.0
"""Second source: the stages of the pipeline, projection in three steps, clipping before the division."""
import math

from .kit import PLAIN, Entry, cross, dot, minus, unit

EYE, CENTER, UP = (0.9, 1.4, 2.6), (0.07, 0.45, 0), (0, 1, 0)
TEAPOT = ("builtin:teapot", "--camera-position", ",".join(map(str, EYE)), "--camera-focal-point", ",".join(map(str, CENTER)))
NARROW = (*TEAPOT, "--camera-view-angle", "32")
CLOSE = (*TEAPOT, "--camera-view-angle", "11")
LOW = ("builtin:plane:divisions=8", "--camera-position", "0,0.13,0.45", "--camera-focal-point", "0,0.05,-1", "--camera-view-angle", "60")
BESIDE = ("data/world/room.scene.toml", "--camera-index", "1", "--camera-view-angle", "12")
ROWS = ("data/world/room.scene.toml", "--camera-position", "2.2,2.4,3.2", "--camera-focal-point", "0,0.5,0", "--camera-view-angle", "50")
SHOWN = ("model", "world", "camera", "normalized-frustum", "central-projection", "depth-mapping", "clip-space", "clipped", "device", "screen", "coverage", "picture")
STAGES = ("model", "world", "camera", "normalized-frustum", "central-projection", "depth-mapping", "clip-space", "clipped", "wrap-round", "device", "screen", "culled", "coverage",
          "depth", "visibility", "shading-frequency", "lighting", "picture")


def camera_of(point):
    """World to camera by the lecture's axes: w from the center to the eye, u = up x w, v = w x u."""
    w = unit(minus(EYE, CENTER))
    u = unit(cross(UP, w))
    v = cross(w, u)
    moved = minus(point, EYE)
    return dot(u, moved), dot(v, moved), dot(w, moved)


def largest(pairs):
    return max(abs(a - b) for one, other in pairs for a, b in zip(one, other))


def measure_stages(kit):
    folder, table = kit.stages(NARROW)
    world, camera, clip, device, screen = (table(s)["rows"] for s in ("world", "camera", "clip-space", "device", "screen"))
    width, height = kit.size(320, 240)
    f = 1 / math.tan(math.radians(16))
    return {"stages of the lecture that have a table": sum((folder / f"{s}.json").exists() for s in STAGES),
            "camera space: error to the lecture's formula [m]": largest((camera_of(p[2:5]), q[2:5]) for p, q in zip(world, camera)),
            "clip space: error to the projection of camera space [1]": largest(((f * c[2] * height / width, f * c[3], -c[4]), (q[2], q[3], q[4])) for c, q in zip(camera, clip)),
            "device space: error to x / w, y / w [1]": largest(((c[2] / c[4], c[3] / c[4]), d[2:4]) for c, d in zip(clip, device)),
            "screen: error to width (x + 1) / 2, height (1 - y) / 2 [px]": largest(((width * (d[2] + 1) / 2, height * (1 - d[3]) / 2), s[2:4]) for d, s in zip(device, screen))}


def draw_stages(kit, path):
    folder, _ = kit.stages(NARROW, 240, 180)
    rows = [SHOWN[:4], SHOWN[4:8], SHOWN[8:]]
    kit.sheet(path, [[folder / f"{s}.png" for s in row] for row in rows], 240, 180, below=[list(row) for row in rows], colors=64)


def times(matrix, v):
    return [dot(row, v) for row in matrix]


def measure_projection(kit):
    """The three matrices: what is at the border of the view, at the near and at the far plane comes where the lecture says."""
    wide = (*TEAPOT, "--camera-view-angle", "40")
    _, table = kit.stages(wide)
    matrix, depth = table("normalized-frustum")["numbers"]["matrix"], table("depth-mapping")["numbers"]
    width, height = kit.size(320, 240)
    up = math.tan(math.radians(20))
    corner = times(matrix, (up * width / height, up, -1, 1))
    printed = depth["matrix of steps 2 and 3, depth from 0 to 1"]
    planes = [times(printed, (0, 0, -depth[p], 1)) for p in ("near", "far")]
    chain = [times(printed, times(matrix, (*r[2:5], 1))) for r in table("camera")["rows"]]
    far = depth["far"] / (depth["far"] - depth["near"])  # the engine keeps near / distance
    keys = [(far * (1 - row[-1]),) for row in table("device")["rows"]]
    twice = [times(printed, (0, 0, -depth[p], depth[p])) for p in ("near", "far")]  # after step 2 with its own last row, w = distance
    return {"corner of the view after step 1, x / -z": corner[0] / -corner[2], "corner of the view after step 1, y / -z": corner[1] / -corner[2],
            "depth of the near plane": planes[0][2] / planes[0][3], "depth of the far plane": planes[1][2] / planes[1][3],
            "three steps vs. the engine, x, y, w [1]": largest(((c[0], c[1], c[3]), (q[2], q[3], q[4])) for c, q in zip(chain, table("clip-space")["rows"])),
            "three steps vs. the engine, depth [1]": largest(((c[2] / c[3],), k) for c, k in zip(chain, keys)),
            "all three multiplied as printed: depth of the far plane minus that of the near one": twice[1][2] / twice[1][3] - twice[0][2] / twice[0][3]}


def measure_parallel(kit):
    """Parallel projection: what is as large at any distance, and what the printed matrix says of x and y."""
    found, boxes = {}, ("builtin:sphere", "--shading", "unlit", "--background", "0,0,0", "--camera-view-angle", "40")
    for name, words in (("parallel", ("--camera-orthographic",)), ("central", ())):
        near, far = (kit.stats((*boxes, "--camera-position", f"0,0,{z}", "--camera-focal-point", f"0,0,{z - 4}", *words))["pixels_covered"] for z in (4, 6))
        found[f"{name} projection: pixels of a sphere at 6 m over those at 4 m"] = far / near
    w, h = kit.size(320, 240)
    for name, words in (("parallel", ("--camera-orthographic",)), ("central", ())):
        _, table = kit.stages((*NARROW, *words))
        pairs = zip(table("camera")["rows"], table("device")["rows"])
        scales = [s for c, d in pairs for s in (d[2] / c[2] * w / h, d[3] / c[3]) if min(abs(c[2]), abs(c[3])) > 0.01]
        found[f"{name} projection: x and y of the box over those of the camera, largest over smallest"] = max(scales) / min(scales)
    return found


def draw_parallel(kit, path):
    kit.sheet(path, [[(*ROWS, "--camera-orthographic"), ROWS]], 300, 200, below=[["parallel projection", "central projection"]], colors=64)


def draw_projection(kit, path):
    folder, _ = kit.stages((*TEAPOT, "--camera-view-angle", "40"), 240, 180)
    names = ("camera", "normalized-frustum", "central-projection", "depth-mapping")
    kit.sheet(path, [[folder / f"{s}.png" for s in names]], 240, 180, below=[["camera space", "1: sides at 45 degrees", "2: on the plane z = -1", "3: depth"]], colors=48)


def measure_wrap(kit):
    folder, table = kit.stages(LOW)
    numbers = table("wrap-round")["numbers"]
    pictures = [folder / p["file"] for p in table("wrap-round")["pictures"]]
    return {"triangles through the plane of the eye": numbers["through the eye's plane"],
            "pixels that clipping first changes [%]": kit.differing(pictures[0], pictures[1]),
            "smallest w after clipping [m]": min(corner[2] for row in table("clipped")["rows"] for corner in row[3])}


def draw_wrap(kit, path):
    folder, table = kit.stages(LOW, 240, 180)
    pictures = [folder / p["file"] for p in table("wrap-round")["pictures"]]
    kit.sheet(path, [[pictures[0], pictures[1], folder / "picture.png"]], 240, 180, below=[["divided, then nothing clipped", "clipped before the division", "the picture"]], colors=64)


def middle(kit):
    """[%] of the pixels of a close view, cut at all four sides, that differ from the middle of a wide one, where nothing is cut."""
    w, h = kit.size(320, 240)
    wide, close = kit.folder / "wide.png", kit.folder / "close.png"
    angle = 2 * math.degrees(math.atan(5 * math.tan(math.radians(5.5))))
    planes = ("--near", "1", "--far", "9")
    kit.run("render", *TEAPOT, "--camera-view-angle", f"{angle:.9f}", *planes, *PLAIN, "--resolution", f"{5 * w},{5 * h}", "--window", f"{2 * w},{2 * h},{w},{h}", "-o", wide, "--quiet")
    kit.run("render", *CLOSE, *planes, *PLAIN, "--resolution", f"{w},{h}", "-o", close, "--quiet")
    return kit.differing(close, wide)


def measure_clipping(kit):
    _, table = kit.stages(CLOSE)
    rows = {row[0]: row for row in table("clip-planes")["rows"]}
    everything, beside = kit.stats(NARROW), kit.stats(BESIDE)
    return {"polygons cut at the four sides": sum(rows[p][2] for p in ("left", "right", "bottom", "top")), "polygons completely outside": sum(row[3] for row in rows.values()),
            "objects dropped, teapot in view": everything["objects_outside"], "objects dropped, close view of a table": beside["objects_outside"],
            "close view vs. the middle of a wide one: pixels that differ [%]": middle(kit)}


def draw_clipping(kit, path):
    folder, table = kit.stages(LOW, 240, 180)
    planes = [p["file"] for p in table("clip-planes")["pictures"] if p["file"] in ("clip-left.png", "clip-right.png")]
    kit.sheet(path, [[*(folder / p for p in planes), folder / "screen.png"]], 240, 180, below=[[*(p[5:-4] + " plane: blue stays" for p in planes), "what is left"]], colors=64)


ENTRIES = (
    Entry("s2-stages", "S2, the pipeline", "The printed matrices lead from model to world, camera, clip, device and screen space", measure_stages, draw_stages),
    Entry("s2-projection", "S2, projective transformation", "The frustum is normalized to 90 degrees, projected, and its depth mapped to a fixed range", measure_projection, draw_projection),
    Entry("s2-parallel", "S2, parallel projection", "Parallel projection does not change x and y", measure_parallel, draw_parallel),
    Entry("s2-wrap-round", "S2, wrap-round", "Without clipping before the division, points behind the eye appear in front of it", measure_wrap, draw_wrap),
    Entry("s2-clipping", "S2, clipping", "Objects outside of the view are dropped first; those partly visible are clipped by -h <= x, y, z <= h", measure_clipping, draw_clipping),
)
