# SPDX-License-Identifier: Apache-2.0
"""Second source: own color, flat, Gouraud, Phong; rays beside incremental synthesis."""
from .kit import Entry

SHADINGS = ("unlit", "flat", "gouraud", "phong")
TEAPOT = ("builtin:teapot", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "29", "--lighting", "blinn-phong",
          "--color", "#a4653a", "--roughness", "0.3", "--metallic", "0", "--light", "point:2,3,3", "--light", "ambient:0.13,0.13,0.13")
COARSE = ("builtin:teapot:divisions=4", *TEAPOT[1:])
FINEST = "builtin:teapot:divisions=48"
LAMP = ("--light", "point:3,4,5:color=0.9,0.9,0.9", "--light", "ambient:0.15,0.15,0.16", "--color", "#c8a878")
BALL, FINE = (("builtin:sphere:tolerance=" + off, *LAMP) for off in ("0.05", "0.0005"))
GLASS = ("data/rays/glass.scene.toml",)
TRACE, CAST, NAIVE = ("--engine", "trace"), ("--engine", "trace", "--method", "cast"), ("--engine", "trace", "--method", "cast", "--naive")
CYCLIC = ("data/visibility/cyclic.obj", "--shading", "unlit", "--camera-position", "0,0,5", "--camera-focal-point", "0,0,0", "--camera-view-angle", "46")
SHADOW = ("data/world/room.scene.toml",)


def measure_shading(kit):
    found = {}
    for shading in SHADINGS:
        small, large = (kit.stats((*COARSE, "--shading", shading), w, h)["lighting_evaluations"] for w, h in ((320, 240), (640, 480)))
        found[f"{shading}: evaluations at 320 x 240"] = small
        found[f"{shading}: evaluations, twice as wide and high over 320 x 240"] = large / small if small else 1
    truth = (FINEST, *TEAPOT[1:], "--shading", "flat")
    for shading in SHADINGS:
        found[f"{shading}, 4 divisions: inside, difference to faces as small as pixels [1/255]"] = inside(kit, (*COARSE, "--shading", shading), truth)
    fine = ("builtin:teapot:divisions=16", *TEAPOT[1:])
    for shading in ("gouraud", "phong"):
        found[f"{shading}, 16 divisions: inside, difference to faces as small as pixels [1/255]"] = inside(kit, (*fine, "--shading", shading), truth)
    return found


def inside(kit, one, other):
    """[1/255] root of the mean square difference where both pictures show the teapot and so do the pixels three to each side."""
    masks = [kit.picture((scene[0], *TEAPOT[1:7], "--shading", "unlit", "--color", "#ffffff", "--background", "0,0,0")) for scene in (one, other)]
    a, b = kit.picture(one), kit.picture(other)
    w, h, total, count = a.width, a.height, 0, 0
    near = [dx + dy * w for dx in (-3, 0, 3) for dy in (-3, 0, 3)]
    for y in range(3, h - 3):
        for i in range(y * w + 3, y * w + w - 3):
            if all(m.pixels[3 * (i + d)] > 128 for m in masks for d in near):
                total += sum((p - q) ** 2 for p, q in zip(a.pixels[3 * i:3 * i + 3], b.pixels[3 * i:3 * i + 3]))
                count += 3
    return (total / count) ** 0.5


def time_shading(kit):
    """Processor time of a picture of 320 x 240, one thread, the median of 15."""
    found = {}
    for shading in SHADINGS:
        row = kit.row("bench", "render", *COARSE, "--look", "plain", "--resolution", "320,240", "--threads", "1", "--shading", shading, "--frames", 15)
        found[f"{shading}, 4 divisions [ms]"] = row["cpu_ms"]
    return found


def draw_shading(kit, path):
    kit.sheet(path, [[(*scene, "--shading", shading) for shading in SHADINGS] for scene in (COARSE, TEAPOT)], 190, 135, below=[list(SHADINGS)] * 2)


def measure_rays(kit):
    held = kit.render((*BALL, *NAIVE, "--tessellate", "--shading", "unlit"), 64 / kit.scale, 48 / kit.scale)[1]
    exact, cut = (*BALL, *CAST), (*BALL, *CAST, "--tessellate")
    traced, drawn = (*GLASS, *TRACE), (*GLASS, "--engine", "soft")
    rays = kit.stats(traced, 240, 160)["rays"]
    shadowed, plain = (*SHADOW, "--shadows"), (*SHADOW, "--shadows", "off")
    return {"tests of the naive loop over pixels x triangles": held["stats"]["rays"]["triangle_tests"] / (64 * 48 * held["triangles"]),
            "pixels of the naive loop that differ from the tree's [%]": kit.differing((*BALL, *NAIVE, "--tessellate"), cut, codes=0),
            "sphere by its formula vs. its triangles: pixels that differ [%]": kit.differing(exact, cut),
            "the same, triangles with a hundredth of the error: pixels that differ [%]": kit.differing((*FINE, *CAST), (*FINE, *CAST, "--tessellate")),
            "triangles by rays vs. incremental synthesis: pixels that differ [%]": kit.differing(cut, (*BALL, "--tessellate")),
            "reflected rays": rays["reflected"], "refracted rays": rays["refracted"],
            "glass and mirrors vs. local light [1/255]": kit.rmse(traced, drawn, 240, 160),
            "raster: pixels that an algorithm for shadows changes [%]": kit.differing(shadowed, plain),
            "rays vs. the z-buffer, cyclic overlap: pixels that differ [%]": kit.differing((*CYCLIC, *CAST), CYCLIC)}


def draw_rays(kit, path):
    kit.sheet(path, [[(*BALL, *CAST), (*BALL, "--tessellate"), (*GLASS, *TRACE), (*GLASS, "--engine", "soft")]], 190, 142,
              below=[["a formula, by rays", "triangles, incremental", "light of everything", "local light"]], colors=160)


def time_rays(kit):
    """Processor time [ms] of pictures of teapots, 320 x 240, one thread: the median of a few."""
    found = {}
    for divisions in (2, 5, 10):
        model = f"builtin:teapot:divisions={divisions}"
        triangles = kit.render((model,), 64, 48)[1]["triangles"]
        for name, how, frames in (("every pixel with every triangle", NAIVE, 1), ("rays with a tree", CAST, 5), ("incremental synthesis", (), 5)):
            row = kit.row("bench", "render", model, "--look", "plain", "--resolution", "320,240", "--threads", "1", "--shading", "unlit", *how, "--frames", frames)
            found[f"{triangles} triangles, {name} [ms]"] = row["cpu_ms"]
    for name, model, how, size in (("eye rays alone, 1560 triangles", ("builtin:teapot:divisions=5", "--shading", "unlit"), CAST, "1920,1080"),
                                   ("incremental synthesis, 1560 triangles", ("builtin:teapot:divisions=5", "--shading", "unlit"), (), "1920,1080"),
                                   ("recursive rays, glass", GLASS, TRACE, "320,240"), ("recursive rays, glass", GLASS, TRACE, "1920,1080")):
        row = kit.row("bench", "render", *model, "--look", "plain", "--resolution", size, "--threads", "1", *how, "--frames", 1)
        found[f"{name}, {size.replace(',', ' x ')} [ms]"] = row["cpu_ms"]
    return found


ENTRIES = (
    Entry("s2-shading", "S2, local illumination", "Own color, flat, Gouraud and Phong shading: each is better than the one before and needs more evaluations", measure_shading, draw_shading, time_shading),
    Entry("s2-rays", "S2, comparison", "Rays work per pixel, draw anything they can hit, have mirrors, refraction, shadows and visibility, and are slow", measure_rays, draw_rays, time_rays),
)
