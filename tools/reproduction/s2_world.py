# SPDX-License-Identifier: Apache-2.0
"""Second source: central projection, one model placed twice, kinds of primitives, primitives that do not depend on one another, flat shading where it fits, waves."""
import base64
import json
import math
import struct

from png8 import write_rgb

from sheet import ROOT

from .kit import Entry, dot

EYE, ANGLE = (0.4, 0.9, 3.0), 40
FAN = ("--allow-outside", "--camera-position", ",".join(map(str, EYE)), "--camera-focal-point", "0.4,0.9,0", "--camera-view-angle", str(ANGLE), "--near", "1", "--far", "8")
DISTANCES = (1.5, 3, 6)
SUN = ("--light", "directional:0.6,-0.9,-0.7:color=0.7,0.7,0.7", "--light", "ambient:0.15,0.15,0.15")
PLACED = ((0.9, 0, 0.2), 35, 0.6)  # position, turn about y [degrees], scale
FLAT = (("box, Lambert, sun", "data/cages/cube.obj", "lambert", "directional:-1,-1.6,-0.7"), ("box, highlight", "data/cages/cube.obj", "blinn-phong", "directional:2.4,-2,3.2"),
        ("box, lamp nearby", "data/cages/cube.obj", "lambert", "point:1.5,2,1.8:attenuation=0.3,0.2,0.1"), ("sphere, Lambert, sun", "builtin:sphere:tolerance=0.02", "lambert", "directional:-1,-1.6,-0.7"))
MODES = ("points", "lines", "line loop", "line strip", "triangles", "triangle strip", "triangle fan")
CORNERS = [(0.9 * math.cos(math.radians(60 * i + 30)), 0.9 * math.sin(math.radians(60 * i + 30)), 0.0) for i in range(6)]
ORDER = {"triangles": (0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5), "triangle strip": (0, 1, 5, 2, 4, 3), "triangle fan": (0, 1, 2, 3, 4, 5)}
FRONT = ("--shading", "unlit", "--camera-position", "0,0,4", "--camera-focal-point", "0,0,0", "--camera-view-angle", "32", "--background", "0,0,0", "--color", "#e8a040")


def fan(kit):
    """An OBJ model: rays from the eye, three points on each, neighbors joined by faces; and lines across, with their middle points."""
    path = kit.folder / "fan.obj"
    rays = [(x, y) for x in (-0.35, 0.25) for y in (-0.3, -0.12, 0.08, 0.28)]
    points = [(EYE[0] + d * x, EYE[1] + d * y, EYE[2] - d) for x, y in rays for d in DISTANCES]
    faces = []
    for k in (0, 1, 2, 4, 5, 6):
        a, b = 3 * k + 1, 3 * k + 4
        faces += [(a, b, b + 1, a + 1), (a + 1, b + 1, b + 2, a + 2)]
    path.write_text("".join("v {:.6f} {:.6f} {:.6f}\n".format(*p) for p in points) + "".join("f {} {} {} {}\n".format(*f) for f in faces))
    return (path, *FAN)


def crossing_lines(kit):
    """Triangles from near to far, each with the middle point of one side as a corner of a second."""
    path, lines = kit.folder / "lines.obj", []
    for i in range(8):
        a = (EYE[0] - 0.8 + 0.2 * i, EYE[1] - 0.4, EYE[2] - 2)
        b = (EYE[0] + 1.4 - 0.5 * i, EYE[1] + 0.9, EYE[2] - 6)
        middle = [(x + y) / 2 for x, y in zip(a, b)]
        lines += ["v {:.6f} {:.6f} {:.6f}".format(*p) for p in (a, (a[0] + 0.1, a[1], a[2]), middle, b)] + [f"f {4 * i + 1} {4 * i + 2} {4 * i + 3}", f"f {4 * i + 3} {4 * i + 2} {4 * i + 4}"]
    path.write_text("\n".join(lines) + "\n")
    return (path, *FAN)


def by_place(table, other):
    """Rows of two tables by object and vertex: [(row, row of the other)]."""
    found = {tuple(row[:2]): row for row in other}
    return [(row, found[tuple(row[:2])]) for row in table if tuple(row[:2]) in found]


def measure_central(kit):
    """What the transformation makes of rays through the eye, of the frustum, of straight lines."""
    _, table = kit.stages(fan(kit))
    rays = {}
    for camera, device in by_place(table("camera")["rows"], table("device")["rows"]):
        rays.setdefault((round(camera[2] / camera[4], 3), round(camera[3] / camera[4], 3)), []).append(device[2:5])
    spread = [max(p[c] for p in ray) - min(p[c] for p in ray) for c in (0, 1) for ray in rays.values()]
    steps = table("depth-mapping")["numbers"]["matrix of steps 2 and 3, depth from 0 to 1"]
    at_eye = [dot(row, (0, 0, 0, 1)) for row in steps]
    w, h = kit.size(320, 240)
    slope = math.tan(math.radians(ANGLE / 2))
    wrong = inside = outside = 0
    _, ball = kit.stages(("builtin:sphere:radius=1.6:tolerance=0.2", *FAN[1:]))
    for camera, device in by_place(ball("camera")["rows"], ball("device")["rows"]):
        x, y, d = camera[2], camera[3], -camera[4]
        is_seen = 1 <= d <= 8 and abs(y) <= slope * d and abs(x) <= slope * d * w / h
        is_in_box = abs(device[2]) <= 1 and abs(device[3]) <= 1 and 1 / 8 <= device[4] <= 1
        wrong, inside, outside = wrong + (is_seen != is_in_box), inside + is_seen, outside + (not is_seen)
    _, lines = kit.stages(crossing_lines(kit))
    rows = [row[2:4] for row in lines("screen")["rows"]]
    bent, place = [], []
    for i in range(0, 32, 4):
        (ax, ay), _, (mx, my), (bx, by) = rows[i:i + 4]
        length = math.hypot(bx - ax, by - ay)
        bent.append(abs((bx - ax) * (my - ay) - (by - ay) * (mx - ax)) / length)
        place.append(math.hypot(mx - ax, my - ay) / length)
    return {"rays through the eye": len(rays), "points of one ray: x and y in the box differ by up to": max(spread),
            "the same: depth keys differ by at least": min(max(p[2] for p in ray) - min(p[2] for p in ray) for ray in rays.values()),
            "the eye itself: w": at_eye[3], "the eye itself: x and y": max(map(abs, at_eye[:2])), "vertices inside of the frustum": inside, "vertices outside of it": outside,
            "vertices inside of only one of frustum and box": wrong, "midpoints of lines: distance from the line [px]": max(bent),
            "midpoint of a line from 2 m to 6 m: fraction of the line in the picture": sum(place) / len(place)}


def draw_central(kit, path):
    folder, _ = kit.stages(fan(kit), 240, 180)
    kit.sheet(path, [[folder / f"{s}.png" for s in ("camera", "normalized-frustum", "depth-mapping")]], 240, 180,
              below=[["rays from the eye", "sides at 45 degrees", "the box: rays are parallel"]], colors=48)


def placed(kit, name, *places):
    """A world file with the cube of data/cages at each place: (position, turn, scale)."""
    path = kit.folder / f"{name}.scene.toml"
    lines = []
    for position, turn, scale in places:
        lines += ["[[model]]", f'file = "{ROOT / "data/cages/cube.obj"}"', f"position = [{', '.join(map(str, position))}]", f"rotation_deg = [0, {turn}, 0]", f"scale = {scale}", 'normals = "flat"']
    path.write_text("\n".join(lines) + "\n")
    return (path, "--allow-outside", *SUN)


ORIGIN = (0, 0, 0), 0, 1


def measure_instances(kit):
    both = placed(kit, "both", ORIGIN, PLACED)
    _, table = kit.stages((*both, "--camera-position", "2,2,5", "--camera-focal-point", "0.3,0,0"))
    rows = {stage: table(stage)["rows"] for stage in ("model", "world")}
    begin = next(i for i, row in enumerate(rows["model"]) if i and row[1] == 0)  # of the second one
    first, second, world = ([row[2:5] for row in of] for of in (rows["model"][:begin], rows["model"][begin:], rows["world"][begin:]))
    (x, y, z), turn, scale = PLACED
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    affine = [(x + scale * (c * p[0] + s * p[2]), y + scale * p[1], z + scale * (c * p[2] - s * p[0])) for p in second]
    far = placed(kit, "far", ORIGIN, ((40, 0, 0), 0, 1))
    views = [(*world_of, "--camera-position", f"{2 + x},2,4", "--camera-focal-point", f"{x},0,0", "--camera-view-angle", "40", "--near", "1", "--far", "20")
             for world_of, x in ((placed(kit, "one", ORIGIN), 0), (far, 0), (far, 40))]
    return {"vertices compared": len(second), "model space: second minus first [m]": max(abs(a - b) for p, q in zip(first, second) for a, b in zip(p, q)),
            "world space: second minus the transformed model [m]": max(abs(a - b) for p, q in zip(world, affine) for a, b in zip(p, q)),
            "first of two vs. one alone: pixels that differ [%]": kit.differing(views[0], views[1], codes=0),
            "second of two, camera shifted alike, vs. one alone: pixels that differ [%]": kit.differing(views[0], views[2], codes=2)}


def draw_instances(kit, path):
    eye = ("--camera-position", "2,3,8", "--camera-focal-point", "0.4,0,0", "--camera-view-angle", "36")
    scenes = {"one": (ORIGIN,), "twice": (((-0.9, 0, 0), 0, 1), ((1.4, 0, 0.2), 35, 0.6)), "three": (((-1.2, 0, 0), 0, 1), ((0.8, 0, 0.6), 35, 0.6), ((1.9, 0.3, -1.6), 70, 1.3))}
    kit.sheet(path, [[(*placed(kit, name, *places), *eye) for name, places in scenes.items()]], 200, 150, below=[["the model", "placed twice", "placed three times"]], colors=64)


def primitive(kit, mode):
    """A glTF file with one primitive of six corners, as OpenGL names its kinds."""
    path = kit.folder / f"{mode.replace(' ', '-')}.gltf"
    order = ORDER.get(mode, range(6))
    body = struct.pack("<18f", *(x for p in CORNERS for x in p)) + struct.pack(f"<{len(order)}H", *order)
    low, high = ([f(p[c] for p in CORNERS) for c in range(3)] for f in (min, max))
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "materials": [{"doubleSided": True}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": MODES.index(mode), "material": 0}]}],
        "buffers": [{"byteLength": len(body), "uri": "data:application/octet-stream;base64," + base64.b64encode(body).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": 72}, {"buffer": 0, "byteOffset": 72, "byteLength": 2 * len(order)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3", "min": low, "max": high}, {"bufferView": 1, "componentType": 5123, "count": len(order), "type": "SCALAR"}]}))
    return (path, "--allow-outside", *FRONT, "--line-width", "3", "--point-size", "9")


def polygon(kit):
    """The same six corners as one polygon of an OBJ file."""
    path = kit.folder / "polygon.obj"
    path.write_text("".join("v {:.9g} {:.9g} {:.9g}\n".format(*p) for p in CORNERS) + "f 1 2 3 4 5 6\n")
    return (path, "--allow-outside", *FRONT)


def lit_pixels(kit, scene):
    picture = kit.picture(scene, 240, 240)
    return sum(max(picture.pixels[i:i + 3]) > 127 for i in range(0, len(picture.pixels), 3))


def measure_primitives(kit):
    filled = primitive(kit, "triangles")
    lit = {mode: lit_pixels(kit, primitive(kit, mode)) for mode in MODES[:4]}
    return {**{f"{mode} vs. separate triangles: pixels that differ [%]": kit.differing(filled, primitive(kit, mode), 240, 240, 0) for mode in MODES[5:]},
            "polygon vs. separate triangles: pixels that differ [%]": kit.differing(filled, polygon(kit), 240, 240, 0),
            "triangles of the polygon": kit.render(polygon(kit), 240, 240)[1]["triangles"], "line strip over line loop, pixels": lit["line strip"] / lit["line loop"],
            "lines over line loop, pixels": lit["lines"] / lit["line loop"], "six points: pixels over the area of six discs of 9": lit["points"] / (6 * math.pi * 4.5 ** 2)}


def draw_primitives(kit, path):
    shown = [(*primitive(kit, mode), *(("--wireframe",) if mode.startswith("triangle") else ())) for mode in MODES] + [(*polygon(kit), "--wireframe", "--line-width", "3")]
    kit.sheet(path, [shown[:4], shown[4:]], 140, 140, below=[list(MODES[:4]), [*MODES[4:], "polygon"]], colors=32)


def shuffled(kit, is_reversed):
    """The teapot as an OBJ file, its faces in the order of the file or the other way round."""
    path = kit.folder / f"teapot{int(is_reversed)}.obj"
    if not path.exists():
        plain = kit.folder / "teapot.obj"
        kit.run("smooth", "builtin:teapot:divisions=6", "-o", plain, "--quiet")
        lines = [line for line in plain.read_text().splitlines() if not line.startswith(("o ", "g ", "usemtl", "mtllib"))]
        faces = [line for line in lines if line.startswith("f ")]
        path.write_text("\n".join([line for line in lines if not line.startswith("f ")] + (faces[::-1] if is_reversed else faces)) + "\n")
    return (path, "--allow-outside", "--normals", "file", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "32", *SUN)


def measure_independent(kit):
    one, other = (shuffled(kit, way) for way in (False, True))
    return {"faces in the opposite order: pixels that change [%]": kit.differing(one, other, codes=0),
            **{f"{n} threads vs. one: pixels that change [%]": kit.differing((*one, "--threads", "1"), (*one, "--threads", n), codes=0) for n in ("2", "7")}}


def draw_independent(kit, path):
    one, other = (shuffled(kit, way) for way in (False, True))
    kit.sheet(path, [[one, other, (one, other, 64)]], 200, 150, below=[["as in the file", "the other way round", "difference x 64"]], colors=128)


def flat_scene(model, lighting, light, shading):
    return (model, "--normals", "auto" if model.startswith("builtin") else "flat", "--lighting", lighting, "--color", "#a4653a", "--roughness", "0.3", "--metallic", "0", "--light", light,
            "--light", "ambient:0.15,0.15,0.15", "--camera-position", "2.4,2,3.2", "--camera-focal-point", "0,0,0", "--camera-view-angle", "40", "--shading", shading)


def measure_flat(kit):
    found = {}
    for name, *scene in FLAT:
        found[f"{name}: flat vs. Phong shading [1/255]"] = kit.rmse(flat_scene(*scene, "flat"), flat_scene(*scene, "phong"))
    lit = {shading: kit.stats(flat_scene(*FLAT[0][1:], shading))["lighting_evaluations"] for shading in ("flat", "phong")}
    found["box: evaluations of flat shading"] = lit["flat"]
    found["box: evaluations, Phong over flat"] = lit["phong"] / lit["flat"]
    return found


def draw_flat(kit, path):
    kit.sheet(path, [[flat_scene(*scene, shading) for _, *scene in FLAT] for shading in ("flat", "phong")], 170, 128, below=[[f"{name.lower()}: {how}" for name, *_ in FLAT] for how in ("flat", "phong")],
              colors=128)


def slits(kit, scale):
    """A screen with two slits before a wall, lit from the front; all of it so many times as large. The camera stands between screen and wall."""
    path = kit.folder / f"slits{scale}.obj"
    edges = (-2, -0.25, -0.15, 0.15, 0.25, 2)
    boxes = [(edges[i], edges[i + 1]) for i in (0, 2, 4)]
    points = [(-2, -1, 0), (2, -1, 0), (2, 1, 0), (-2, 1, 0)] + [p for a, b in boxes for p in ((a, -1, 1), (b, -1, 1), (b, 1, 1), (a, 1, 1))]
    path.write_text("".join("v {:.9g} {:.9g} {:.9g}\n".format(*(scale * x for x in p)) for p in points) + "".join("f {} {} {} {}\n".format(*range(4 * i + 1, 4 * i + 5)) for i in range(4)))
    return (path, "--allow-outside", "--engine", "trace", "--shadows", "--cull", "none", "--lighting", "lambert", "--light", "directional:0,0,-1", "--camera-position", f"0,0,{0.95 * scale}",
            "--camera-focal-point", "0,0,0", "--camera-view-angle", "50", "--near", 0.01 * scale, "--far", 10 * scale, "--background", "0,0,0")


def measure_waves(kit):
    large, small = slits(kit, 1), slits(kit, 1e-5)
    picture = kit.picture(large, 480, 120)
    row = [max(picture.at((x + 0.5) / picture.width, 0.5)) for x in range(picture.width)]
    edges = sum((a > 0) != (b > 0) for a, b in zip(row, row[1:]))
    lit = [code for code in row if code]
    return {"bright stripes on the wall": edges / 2, "codes inside of the stripes, largest minus smallest": max(lit) - min(lit),
            "width of a stripe over that of its slit": len(lit) / 2 / (picture.width * 0.1 / (2 * 0.95 * math.tan(math.radians(25)) * picture.width / picture.height)),
            "all a hundred thousand times smaller: pixels that differ [%]": kit.differing(large, small, 480, 120)}


def fringes(kit):
    """What waves would show, worked out by Fraunhofer's formula: two slits of 30 wavelengths, 100 apart, far away. No render of the program."""
    out, width, line = kit.folder / "waves.png", 240, b""
    for x in range(width):
        sine = (x - width / 2 + 0.5) / width * 0.16
        slit, pair = math.pi * 30 * sine, math.pi * 100 * sine
        light = (math.sin(slit) / slit * math.cos(pair)) ** 2
        line += bytes((round(255 * light ** (1 / 2.2)),) * 3)
    write_rgb(out, width, 120, line * 120)
    return out


def draw_waves(kit, path):
    kit.sheet(path, [[slits(kit, 1), slits(kit, 1e-5), fringes(kit)]], 240, 120, below=[["by rays", "by rays, 100,000 times smaller", "waves, by a formula"]], colors=64)


ENTRIES = (
    Entry("s2-central", "S2, central projection", "The frustum becomes a box; rays through the eye become parallel; the eye goes to infinity; lines stay lines", measure_central, draw_central),
    Entry("s2-instances", "S2, world transformation", "Two objects of a scene may differ only in their world matrices", measure_instances, draw_instances),
    Entry("s2-primitives", "S2, primitives", "Points, lines, strips, loops, triangles, strips and fans; polygons are made of triangles", measure_primitives, draw_primitives),
    Entry("s2-independent", "S2, the pipeline", "Primitives pass through the pipeline independently, mostly in parallel", measure_independent, draw_independent),
    Entry("s2-flat", "S2, flat shading", "Flat shading is good for diffuse objects of one color without curved parts", measure_flat, draw_flat),
    Entry("s2-waves", "S2, ray tracing", "Rays cannot show wave effects of light", measure_waves, draw_waves),
)
