# SPDX-License-Identifier: Apache-2.0
"""Third source: the teapot smooth and bumpy, what the bumps act on, bumps in motion, a detailed mesh beside a coarse one."""
import math

import bake_pictures
import bump_pictures as bumps
from png8 import read_rgb

from .kit import Entry, brightness, detail

TEAPOT = (*bumps.TEAPOT, *bumps.KEY, *bumps.SHINY, "--lighting", "blinn-phong")
LEATHER = (*TEAPOT, *bumps.maps("leather"))
ROW = {"brick": "0.35", "leather": "0.35", "scratches": "0.5"}
STRONG = {"brick": "1", "leather": "1", "scratches": "1.5"}
CLIP = ("data/course/6-bumps.scene.toml", *bumps.maps("leather"))
SIZE = 192, 128
LIGHT = ("--lighting", "lambert", "--light", "directional:-0.6,-0.5,-1:color=0.9,0.9,0.9", "--light", "ambient:0.08,0.08,0.08")


def measure_smooth(kit):
    return {"teapot with a map and --bump none vs. no map [% of pixels]": kit.differing((*LEATHER, "--bump", "none"), TEAPOT, codes=0),
            "objects": kit.render(TEAPOT)[1]["objects"]}


def draw_smooth(kit, path):
    kit.sheet(path, [[TEAPOT]], 240, 170)


def measure_terms(kit):
    """Which terms of the light the bumps change [1/255]."""
    found = {}
    for terms in ("diffuse", "specular", "both"):
        for channel in ("diffuse", "specular"):
            paths = [kit.channel((*LEATHER, "--bump", how, "--bump-terms", terms), channel) for how in ("none", "normal")]
            found[f"bumps on {terms}: change of the {channel} term [1/255]"] = kit.rmse(*paths)
    return found


def draw_terms(kit, path):
    dull = tuple({"blinn-phong": "lambert"}.get(word, word) for word in LEATHER)
    parts = [(*LEATHER, "--bump-terms", "diffuse"), (*dull, "--bump-terms", "diffuse"), (*LEATHER, "--bump-terms", "specular"), LEATHER]
    kit.sheet(path, [parts], 208, 144, below=[["diffuse, smooth highlight", "diffuse, no highlight", "specular", "both"]], colors=160)


def bumpy(name, scale):
    return (*TEAPOT, *bumps.maps(name), "--bump", "normal", "--normal-scale", scale)


def measure_row(kit):
    found = {}
    for name in ROW:
        mild, strong = (kit.rmse(TEAPOT, bumpy(name, table[name])) for table in (ROW, STRONG))
        found |= {f"{name}, mild: difference to smooth [1/255]": mild, f"{name}, strong: difference to smooth [1/255]": strong}
    return found


def draw_row(kit, path):
    rows = [[TEAPOT, *(bumpy(name, table[name]) for name in table)] for table in (ROW, STRONG)]
    kit.sheet(path, rows, 190, 132, below=[["smooth", "brick, mild", "leather, mild", "scratches, mild"], ["smooth", "brick", "leather", "scratches"]], colors=160)


def frames(kit, how, count, *more):
    """Gray codes of the pictures of the clip, each a list."""
    name = kit.folder / f"lamp-{how}{len(more)}"
    kit.run("render", *CLIP, "--bump", how, *more, "--look", "plain", "--resolution", ",".join(map(str, SIZE)), "--fps", "4", "--frames", f"0:{count - 1}", "-o",
            f"{name}-{{frame}}.png", "--quiet")
    return [[sum(pixels[i:i + 3]) / 3 for i in range(0, len(pixels), 3)] for pixels in (read_rgb(f"{name}-{k}.png")[2] for k in range(count))]


def flicker(pictures, width):
    """Root of the mean square change of the detail from one picture to the next [1/255]."""
    details = [detail(p, width) for p in pictures]
    changes = [(a - b) ** 2 for one, other in zip(details, details[1:]) for a, b in zip(one, other)]
    return math.sqrt(sum(changes) / len(changes))


def measure_motion(kit):
    width = SIZE[0]
    found = {"none": frames(kit, "none", 4), "normal": frames(kit, "normal", 4), "strong": frames(kit, "normal", 4, "--normal-scale", "3")}
    still = {how: math.sqrt(sum(d * d for d in detail(p[1], width)) / len(p[1])) for how, p in found.items()}
    moving = {how: flicker(p, width) for how, p in found.items()}
    return {"detail of one picture, bumpy over smooth": still["normal"] / still["none"],
            "detail of one picture, strong bumps over smooth": still["strong"] / still["none"],
            "change of detail from picture to picture, bumpy over smooth": moving["normal"] / moving["none"],
            "change of detail from picture to picture, strong bumps over smooth": moving["strong"] / moving["none"],
            "mild bumps: gain from motion, factor": moving["normal"] / moving["none"] / (still["normal"] / still["none"]),
            "strong bumps: gain from motion, factor": moving["strong"] / moving["none"] / (still["strong"] / still["none"]),
            "change of detail, smooth [1/255]": moving["none"], "change of detail, bumpy [1/255]": moving["normal"]}


def draw_motion(kit, path):
    """Three moments of each kind; the clip beside it is a PNG file that moves."""
    kit.sheet(path, [[(*CLIP, "--bump", how, "--animation-time", t) for t in ("0.5", "1.5", "2.5")] for how in ("none", "normal")], 192, 128,
              lines=["none", "normal"], columns=["0.5 s", "1.5 s", "2.5 s"])
    clip = path.with_name(path.stem + "-clip.apng")
    kit.run("render", *CLIP, "--bump", "normal", "--look", "plain", "--resolution", "144,96", "--samples", "4", "--fps", "4", "-o", clip, "--quiet")
    clip.replace(clip.with_suffix(".png"))


def measure_phong(kit):
    """Phong's model: no ambient term, the viewer's place, the color of the highlight."""
    lamp = ("--light", "directional:0.7,-0.9,-0.8:color=0.8,0.8,0.3")
    scene = ("builtin:sphere", "--lighting", "phong", "--color", "#c03030", "--roughness", "0.4", "--camera-focal-point", "0,0,0", "--camera-view-angle", "29")
    front = ("--camera-position", "0,0,4.5")
    behind = [kit.explain((*scene, *front, *lamp, *more), [(0.78, 0.72)])[0]["color"] for more in ((), ("--light", "ambient:0.1,0.1,0.1"))]
    terms = []
    for eye in ("1.4,1.8,-1.6", "0.4,1,1.5"):
        flat = ("builtin:plane", "--lighting", "phong", "--roughness", "0.4", "--camera-view-angle", "29", *lamp, "--camera-focal-point", "0,0,0", "--camera-position")
        terms.append(kit.explain((*flat, eye), [(0.5, 0.5)])[0]["layers"][0]["lights"][0])
    shine = max((kit.explain((*scene, *front, *lamp), [(0.3 + 0.02 * i, 0.2 + 0.02 * i)])[0]["layers"][0]["lights"][0]["specular"] for i in range(12)), key=sum)
    near, far = (kit.explain(("builtin:plane", "--lighting", "phong", "--camera-position", "0,3,0.1", "--camera-focal-point", "0,0,0", "--light", f"point:0,{d},0:attenuation=0,0,1"),
                             [(0.5, 0.5)])[0]["layers"][0]["lights"][0]["diffuse"][0] for d in (1, 2))
    spread = {}
    for name, more in (("nearby", ()), ("infinitely far", ("--viewer-infinity",))):
        floor = kit.explain(("builtin:plane", "--lighting", "phong", "--roughness", "0.4", *lamp, "--camera-position", "1.4,1.8,-1.6", "--camera-focal-point", "0,0,0", *more),
                            [(0.4 + 0.05 * i, 0.5) for i in range(5)])
        shine_there = [row["layers"][0]["lights"][0]["specular"][0] for row in floor]
        spread[f"a floor, viewer {name}: specular term, largest minus smallest [linear]"] = max(shine_there) - min(shine_there)
    return {**spread, "no ambient term, face turned away: light [linear]": brightness(behind[0]), "ambient term, face turned away: light [linear]": brightness(behind[1]),
            "viewer moved: change of the diffuse term [linear]": max(abs(a - b) for a, b in zip(terms[0]["diffuse"], terms[1]["diffuse"])),
            "viewer moved: change of the specular term [linear]": max(abs(a - b) for a, b in zip(terms[0]["specular"], terms[1]["specular"])),
            "highlight of a red sphere, red over green, lamp 0.8, 0.8, 0.3": shine[0] / shine[1], "the same, red over blue": shine[0] / shine[2],
            "diffuse light of a lamp at 1 m over that at 2 m": near / far}


def draw_phong(kit, path):
    scene = ("builtin:sphere", "--lighting", "phong", "--color", "#c03030", "--roughness", "0.4", "--camera-focal-point", "0,0,0", "--camera-view-angle", "29", "--camera-position", "0,0,4.5",
             "--light", "directional:0.7,-0.9,-0.8:color=0.8,0.8,0.3")
    kit.sheet(path, [[scene, (*scene, "--light", "ambient:0.1,0.1,0.1")]], 200, 160, below=[["no ambient term", "with it"]], colors=0)


def hilly(path, cells, depth):
    """A square of so many cells a side, with hills `depth` high: OBJ with texture coordinates."""
    places = [(x / cells, y / cells) for y in range(cells + 1) for x in range(cells + 1)]
    lines = [f"v {2 * u - 1:.6f} {2 * v - 1:.6f} {depth * math.sin(9 * u) ** 2 * math.sin(7 * v) ** 2:.6f}\nvt {u:.6f} {v:.6f}" for u, v in places]
    for y in range(cells):
        for x in range(cells):
            a, b = y * (cells + 1) + x + 1, (y + 1) * (cells + 1) + x + 1
            lines.append(f"f {a}/{a} {a + 1}/{a + 1} {b + 1}/{b + 1} {b}/{b}")
    path.write_text("\n".join(lines) + "\n")


def baked(kit):
    """Arguments of the detailed mesh, the coarse one, and that with the map baked for it; their triangles."""
    high, low, out = kit.folder / "head.obj", kit.folder / "low.obj", kit.folder / "baked.glb"
    if kit.is_small:
        hilly(high, 48, 0.08)
        hilly(low, 1, 0)
        view = ("--view", "front")
    elif not low.exists():
        bake_pictures.make_models(kit.folder, 0.1)
    if not out.exists():
        kit.run("bake", high, low, "-o", kit.folder / "{map}.png", "--maps", "normal", "--bits", "8", "--size", "128" if kit.is_small else "1024", "--model", out, "--quiet")
    if not kit.is_small:
        view = ("--view", "front", "--camera-zoom-factor", "1.1", "--color", "#c8b8a8")
    return [(high, *view, *LIGHT), (low, *view, "--normals", "model", "--crease-angle", "180", *LIGHT), (out, *view, *LIGHT)]


def measure_baked(kit):
    high, low, mapped = baked(kit)
    triangles = [kit.render(scene, 280, 300)[1]["triangles"] for scene in (high, low)]
    bare, with_map = kit.rmse(high, low, 280, 300), kit.rmse(high, mapped, 280, 300)
    return {"triangles, detailed over coarse": triangles[0] / triangles[1], "coarse vs. detailed [1/255]": bare, "coarse with the map vs. detailed [1/255]": with_map,
            "error that the map leaves [%]": 100 * with_map / bare}


def draw_baked(kit, path):
    high, low, mapped = baked(kit)
    kit.sheet(path, [[high, low, mapped, kit.folder / "normal.png"]], 220, 236, below=[["detailed", "a tenth of the triangles", "with the map", "the map"]], colors=160)


ENTRIES = (
    Entry("s3-fig1", "S3 fig. 1", "A coarse mesh with a normal map looks like the detailed one", measure_baked, draw_baked),
    Entry("s3-phong", "S3, Phong's model", "Without the ambient term faces turned away are black; diffuse light does not depend on the viewer; highlights have the light's color; 1 / d^2", measure_phong, draw_phong),
    Entry("s3-fig11", "S3 fig. 11", "The teapot without bumps is smooth", measure_smooth, draw_smooth),
    Entry("s3-fig12", "S3 fig. 12", "Bumps in the diffuse term under a smooth highlight look unnatural; without highlight they suit walls, paper, cotton, wood", measure_terms, draw_terms),
    Entry("s3-fig13", "S3 fig. 13", "Teapots with mild and with strong bumps", measure_row, draw_row),
    Entry("s3-motion", "S3, practical part", "Bumps are much easier to see in motion than in still pictures, unless they are strong", measure_motion, draw_motion),
)
