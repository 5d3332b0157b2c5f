# SPDX-License-Identifier: Apache-2.0
"""First source: normal maps, tangents, Gram-Schmidt, handedness."""
import bump_pictures as bumps
from png8 import read_rgb

from sheet import ROOT

from .arrows import write_arrows
from .kit import Entry, Picture, angle, brightness, cross, dot, minus, unit

MAP = ROOT / "data/maps/brick_normal.png"
WALL = (*bumps.WALL, "--camera-position", "1.2,0.4,3.1", "--camera-focal-point", "0,0,0")
BARE, MAPPED = (*WALL, "--bump", "none"), (*WALL, "--bump", "normal")
CHARTED = ("builtin:teapot", "--texture-normal", "data/maps/brick_normal.png", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0",
           "--camera-view-angle", "30")
OF_FACES = ("builtin:teapot:divisions=3", *CHARTED[1:], "--normals", "flat", "--tangents", "published")
LEANINGS = {"middle": 0, "half-way": 0.5, "left": 1}  # of the shared normal, towards that of the left face
FACES = ("--camera-position", "0,1.6,4", "--camera-focal-point", "0,0.3,0", "--camera-view-angle", "27", "--lighting", "lambert", "--cull", "none")
LAMPS = {"left": ("--light", "directional:1,-0.7,-0.5"), "right": ("--light", "directional:-1,-0.7,-0.5")}


def codes_apart(one, other):
    return max(abs(a - b) for a, b in zip(one, other))


def measure_normals(kit):
    """Shares of the pixels of the wall whose normal is not that of the face. The normals' channel has (n + 1) / 2 as codes."""
    found = {}
    for name, scene in (("without the map", BARE), ("with the map", MAPPED)):
        picture = Picture(*read_rgb(kit.channel(scene, "normal", 180, 180)))
        pixels = picture.part(0.3, 0.3, 0.7, 0.7)
        found[f"pixels with a tilted normal, {name} [%]"] = 100 * sum(codes_apart(p, (127, 127, 255)) > 8 for p in pixels) / len(pixels)
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
    return {"mean blue of the map [1/255]": blue, "distance from green down to dark over dark down to green": sum(bricks) / len(bricks) / (sum(joints) / len(joints)),
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
    return {"sampled pixels": len(ups), "largest angle of the tangent to U [degrees]": worst, "bitangents that go up in the texture [%]": 100 * sum(ups) / len(ups)}


def draw_tangents(kit, path):
    """The faces with their texture coordinates as colors, and frames at some places: the tangent red, the bitangent green, the normal blue."""
    close = tuple({"30": "18"}.get(word, word) for word in OF_FACES)
    frames = [r["layers"][0] for r in kit.explain(close, [(0.08 + 0.105 * i, 0.1 + 0.13 * j) for i in range(9) for j in range(7)], 480, 360) if r["layers"]]
    arrows = [(f["position"], [(f["tangent"], (235, 40, 40)), ([f["handedness"] * x for x in cross(f["normal_interpolated"], f["tangent"])], (30, 200, 60)),
                               (f["normal_interpolated"], (70, 90, 255))]) for f in frames]
    shown = []
    for name, picture in (("map", kit.render((*close, "--samples", "4"), 480, 360)[0]), ("uv", kit.channel(close, "uv", 480, 360))):
        shown.append(kit.folder / f"arrows-{name}.png")
        write_arrows(picture, shown[-1], arrows, (0.9, 1.4, 2.6), (0.07, 0.45, 0), 18, 0.09)
    kit.sheet(path, [shown], 480, 360, below=[["with its map: rows of bricks go along the red tangents", "u is red, v (down) is green"]], colors=160)


def pair(kit, leaning):
    """Two faces that meet in an edge, seen alike; the normal of the edge leans from the middle (0) to that of the left face (1)."""
    path, (x, z) = kit.folder / f"pair{leaning}.obj", unit((-0.5145, 0.8575))
    middle = unit(((x * leaning), z * leaning + 1 - leaning, 0))
    path.write_text("\n".join(["v -1 0 0.6", "v 0 0.6 0.6", "v 1 0 0.6", "v -1 0 -0.6", "v 0 0.6 -0.6", "v 1 0 -0.6", f"vn {x} {z} 0", f"vn {-x} {z} 0",
                               "vn {} {} {}".format(*middle), "f 1//1 2//3 5//3 4//1", "f 2//3 3//2 6//2 5//3"]) + "\n")
    return (path, *FACES)


def measure_faces(kit):
    """Mean light of each face, from the outer border to the shared edge, over what it is with the normal in the middle."""
    found = {}
    for lamp, words in LAMPS.items():
        light = {}
        for name, leaning in LEANINGS.items():
            for side, x in (("left", 0.29), ("right", 0.54)):
                rows = kit.explain((*pair(kit, leaning), *words), [(x + 0.17 * i / 8, 0.5) for i in range(9)], 240, 200)
                light[name, side] = sum(brightness(r["color"]) for r in rows) / len(rows)
        for name in ("half-way", "left"):
            for side in ("left", "right"):
                found[f"lamp at the {lamp}, normal {name}: light of the {side} face over that with the normal in the middle"] = light[name, side] / light["middle", side]
    return found


def draw_faces(kit, path):
    words = ["normal in the middle", "half-way to the left", "of the left face"]
    kit.sheet(path, [[(*pair(kit, leaning), *lamp) for leaning in LEANINGS.values()] for lamp in LAMPS.values()], 240, 130,
              below=[[f"{w}, lamp {lamp}" for w in words] for lamp in LAMPS], colors=0)


ENTRIES = (
    Entry("s1-fig4", "S1 fig. 4", "A normal map gives each pixel its own normal", measure_normals, draw_normals),
    Entry("s1-fig5", "S1 fig. 5", "A flat wall of bricks looks deep with a normal map; the map is bluish, the top edges of bricks are green", measure_wall, draw_wall),
    Entry("s1-fig6-8", "S1 fig. 6, 7, 8", "The tangent is the direction perpendicular to the normal in which U grows", measure_tangents, draw_tangents),
    Entry("s1-fig10", "S1 fig. 10", "A vertex normal that leans to one face changes the light over the faces", measure_faces, draw_faces),
)
