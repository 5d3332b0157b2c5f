# SPDX-License-Identifier: Apache-2.0
"""First source: normal maps, tangents, Gram-Schmidt, handedness."""
import bump_pictures as bumps
from png8 import read_rgb

from sheet import ROOT

from .kit import Entry, Picture, angle, brightness, cross, dot, minus

MAP = ROOT / "data/maps/brick_normal.png"
WALL = (*bumps.WALL, "--camera-position", "1.2,0.4,3.1", "--camera-focal-point", "0,0,0")
BARE, MAPPED = (*WALL, "--bump", "none"), (*WALL, "--bump", "normal")
CHARTED = ("builtin:teapot", "--texture-normal", "data/maps/brick_normal.png", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0",
           "--camera-view-angle", "30")
OF_FACES = ("builtin:teapot:divisions=3", *CHARTED[1:], "--normals", "flat", "--tangents", "published")
SHEET = tuple(word for word in bumps.SHEET if word not in ("--orthogonalize", "off"))
WAYS = ("off", "attribute", "shader")


def codes_apart(one, other):
    return max(abs(a - b) for a, b in zip(one, other))


def measure_normals(kit):
    """Shares of the pixels of the wall whose normal is not that of the face. The normals' channel has (n + 1) / 2 as codes."""
    found = {}
    for name, scene in (("without the map", BARE), ("with the map", MAPPED)):
        picture = Picture(*read_rgb(kit.channel(scene, "normal", 180, 180)))
        pixels = picture.part(0.3, 0.3, 0.7, 0.7)
        found[f"pixels whose normal leans, {name} [%]"] = 100 * sum(codes_apart(p, (127, 127, 255)) > 8 for p in pixels) / len(pixels)
    return found


def draw_normals(kit, path):
    kit.sheet(path, [[BARE, kit.channel(BARE, "normal", 180, 180), MAPPED, kit.channel(MAPPED, "normal", 180, 180)]], 180, 180,
              below=[["face normal", "its channel", "normal of each pixel", "its channel"]])


def measure_wall(kit):
    """Of the map: blue on average; how long it is from a green border down to a dark one (a brick) over the way on to the next green one (a joint)."""
    picture = Picture(*read_rgb(MAP))
    bricks, joints = [], []
    for column in range(0, picture.width, 5):
        green = [picture.pixels[3 * (y * picture.width + column) + 1] for y in range(picture.height)]
        borders = [(y, c > 128) for y, c in enumerate(green) if abs(c - 128) > 50]
        for (y, is_green), (next_y, is_next_green) in zip(borders, borders[1:]):
            if is_green != is_next_green:
                (bricks if is_green else joints).append(next_y - y)
    blue = sum(picture.pixels[2::3]) / (picture.width * picture.height)
    return {"mean blue of the map [1/255]": blue, "down from green to dark over down from dark to green": sum(bricks) / len(bricks) / (sum(joints) / len(joints)),
            "difference with and without [1/255]": kit.rmse(BARE, MAPPED, 180, 180)}


def draw_wall(kit, path):
    kit.sheet(path, [[BARE, MAPPED, MAP]], 180, 180, below=[["without", "with", "the map"]])


def neighbors(kit, scene, places):
    """Layers of three pixels beside one another, where one triangle shows at all three."""
    w, h = kit.size(640, 480)
    for x, y in places:
        rows = kit.explain(scene, [(x, y), (x + 1.5 / w, y), (x, y + 1.5 / h)], 640, 480)
        shown = [(r["shows"] or {}).get("triangle") for r in rows], [(r["shows"] or {}).get("object") for r in rows]
        if shown[0][0] is not None and len(set(shown[0])) == len(set(shown[1])) == 1:
            yield [r["layers"][0] for r in rows]


def measure_tangents(kit):
    """Largest angle between the tangent and the way in which u grows, by differences from pixel to pixel; share of bitangents that go up in the texture."""
    worst, ups = 0, []
    grid = [(0.3 + 0.05 * i, 0.4 + 0.05 * j) for i in range(9) for j in range(5)]
    for a, b, c in neighbors(kit, OF_FACES, grid):
        (u0, v0), (u1, v1), (u2, v2) = (layer["texcoords"][0] for layer in (a, b, c))
        p, q = minus(b["position"], a["position"]), minus(c["position"], a["position"])
        du1, dv1, du2, dv2 = u1 - u0, v1 - v0, u2 - u0, v2 - v0
        area = du1 * dv2 - du2 * dv1
        along_u = [(dv2 * x - dv1 * y) / area for x, y in zip(p, q)]
        along_v = [(du1 * y - du2 * x) / area for x, y in zip(p, q)]
        worst = max(worst, angle(along_u, a["tangent"]))
        bitangent = [a["handedness"] * x for x in cross(a["normal_interpolated"], a["tangent"])]
        ups.append(dot(bitangent, along_v) < 0)  # v is stored downwards
    return {"places": len(ups), "largest angle of the tangent to U [degrees]": worst, "bitangents that go up in the texture [%]": 100 * sum(ups) / len(ups)}


def draw_tangents(kit, path):
    kit.sheet(path, [[CHARTED, kit.channel(CHARTED, "uv"), kit.channel(CHARTED, "tangent"), kit.channel(CHARTED, "normal")]], 180, 135,
              below=[["with its map", "u, v", "tangent", "normal"]], colors=0)


def leaning(kit, way):
    """[degrees] largest distance of normal and tangent from a right angle, as they come to the pixel."""
    rows = kit.explain((*SHEET, "--orthogonalize", way), [(0.3 + 0.1 * i, 0.3 + 0.1 * j) for i in range(5) for j in range(5)])
    layers = [r["layers"][0] for r in rows if r["layers"]]
    return max(abs(90 - angle(layer["normal_interpolated"], layer["tangent"])) for layer in layers)


def measure_gram_schmidt(kit):
    found = {f"{way}: normal and tangent are off a right angle [degrees]": leaning(kit, way) for way in WAYS}
    off, once, late = ((*SHEET, "--orthogonalize", way) for way in WAYS)
    found["off beside per vertex [1/255]"] = kit.rmse(off, once)
    found["per pixel beside per vertex [1/255]"] = kit.rmse(late, once)
    found["pixels that differ by more than 10 codes, off [%]"] = kit.differing(off, once, codes=10)
    return found


def draw_gram_schmidt(kit, path):
    off, once, late = ((*SHEET, "--orthogonalize", way) for way in WAYS)
    kit.sheet(path, [[off, once, late, (off, once, 8)]], 180, 140, below=[["off", "per vertex", "per pixel", "difference x 8"]])


def halves(kit, mode):
    """[1/255] differences of the left and of the right, mirrored half to `averaged`."""
    w, h = kit.size(600, 300)
    paths = []
    for name in ("averaged", mode):
        for x in (0, w // 2):
            paths.append(kit.folder / f"half-{name}-{x}.png")
            kit.run("render", *bumps.MIRRORED, "--tangents", name, "--look", "plain", "--resolution", f"{w},{h}", "--window", f"{x},0,{w // 2},{h}", "-o", paths[-1],
                    "--quiet")
    return kit.rmse(paths[0], paths[2]), kit.rmse(paths[1], paths[3])


def measure_handedness(kit):
    found = {}
    for name, mode in (("with the step", "published"), ("without it", "published-no-handedness")):
        found[f"{name}: left half [1/255]"], found[f"{name}: mirrored half [1/255]"] = halves(kit, mode)
    return found


def draw_handedness(kit, path):
    kit.sheet(path, [[(*bumps.MIRRORED, "--tangents", mode) for mode in bumps.MODES]], 300, 154, below=[list(bumps.MODES)])


def measure_faces(kit):
    """Brightness along a line over each face, from the outer border to the shared edge."""
    found = {}
    for name, left, right in (("centered", (0.22, 0.33), (0.36, 0.47)), ("tilted", (0.56, 0.66), (0.7, 0.8))):
        for side, xs in (("left", left), ("right", right)):
            rows = [r for r in kit.explain(bumps.FACES, [(xs[0] + (xs[1] - xs[0]) * i / 8, 0.45) for i in range(9)], 420, 200) if r["layers"]]
            light = [brightness(r["color"]) for r in rows]
            found[f"{name}: light over the {side} face, most less least [linear]"] = max(light) - min(light)
    return found


def draw_faces(kit, path):
    kit.sheet(path, [[bumps.FACES]], 420, 200)


ENTRIES = (
    Entry("s1-fig4", "S1 fig. 4", "A normal map gives each pixel its own normal", measure_normals, draw_normals),
    Entry("s1-fig5", "S1 fig. 5", "A flat wall of bricks gets depth by its map; the map is bluish, the bricks' tops are green", measure_wall, draw_wall),
    Entry("s1-fig6-8", "S1 fig. 6, 7, 8", "Of all directions across the normal the tangent is the one in which U grows", measure_tangents, draw_tangents),
    Entry("s1-fig10", "S1 fig. 10", "A vertex normal that leans to one face changes the light over the faces", measure_faces, draw_faces),
    Entry("s1-fig13", "S1 fig. 13, section 5.3", "Averaged frames are not orthogonal; Gram-Schmidt repairs them, per vertex or in the shader; little of it is seen", measure_gram_schmidt,
          draw_gram_schmidt),
    Entry("s1-handedness", "S1 section 5.4", "t = -t where dot(cross(n, t), b) < 0 repairs texture coordinates that lie the wrong way round", measure_handedness, draw_handedness),
)
