# SPDX-License-Identifier: Apache-2.0
"""First source, section 2.1: the sum of the terms, and the lighting models that it names."""
from png8 import read_rgb

from .kit import Entry, Picture, dot, linear

SCENE = ("builtin:teapot", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "32", "--lighting", "phong", "--specular", "textbook",
         "--specular-horizon", "off", "--color", "#a4653a", "--roughness", "0.45", "--metallic", "0", "--light", "point:2,3,3:color=2,2,2:attenuation=1,0.1,0.05",
         "--light", "directional:1,-0.5,-0.4:color=0.4,0.4,0.6:specular=40,40,40", "--light", "ambient:0.13,0.13,0.13")
PLACES = [(0.2 + 0.04 * i, 0.3 + 0.05 * j) for i in range(16) for j in range(9)]
TERMS = ("ambient", "diffuse", "specular")
DISC = ("builtin:plane", "--lighting", "lambert", "--camera-focal-point", "0,0,0", "--camera-view-angle", "40", "--color", "#c8a878")
ABOVE = ("--camera-position", "0,3,0.01")
LIGHTS = {0: "0,-1,0", 30: "0.5,-0.8660254,0", 60: "0.8660254,-0.5,0", 80: "0.9848078,-0.1736482,0"}  # [degrees] off the normal
FLOOR = ("builtin:plane:size=24,24", "--camera-position", "0,0.7,5", "--camera-focal-point", "0,0.1,0", "--camera-view-angle", "34", "--color", "#303038", "--roughness", "0.35",
         "--metallic", "0", "--specular", "normalized", "--light", "directional:0,-0.14,1:color=0.6,0.6,0.6", "--background", "0,0,0")
BEHIND = ("builtin:plane:size=12,12", "--camera-position", "0,1.2,3.6", "--camera-focal-point", "0,0,0", "--camera-view-angle", "40", "--color", "#303038", "--roughness", "0.95",
          "--metallic", "0", "--light", "point:0,1.1,0.6:color=6,6,6", "--background", "0,0,0")
MODELS = {"phong": (), "blinn-phong": (), "pbr": ("--light-intensity", "0.03")}  # at grazing angles pbr's highlight is as much brighter
BALL = ("builtin:sphere", "--camera-position", "0,0,4.5", "--camera-focal-point", "0,0,0", "--camera-view-angle", "29", "--lighting", "pbr")
FURNACE = ("--color", "#ffffff", "--metallic", "1", "--light", "none", "--hdri-file", "data/paths/white.hdr", "--hdri-ambient", "--background", "#bcbcbc", "--exposure", "-1")
PLASTIC = ("--color", "#000000", "--metallic", "0", "--roughness", "0.1", "--light", "ambient:1,1,1")
LIT = ("--color", "#a4653a", "--metallic", "0", "--light", "directional:0.4,-0.5,-1:color=0.7,0.7,0.7", "--light", "ambient:0.1,0.1,0.1")
BRUSHED = ("data/maps/wall.obj", "--camera-position", "0,0,3.4", "--camera-focal-point", "0,0,0", "--camera-view-angle", "34", "--color", "#303034", "--metallic", "1",
           "--light", "point:0,0,3:color=0.4,0.4,0.4")


def formula(layer):
    """Ambient, diffuse and specular terms of Phong's model from normal, directions and constants alone, summed over the lights."""
    surface, total = layer["surface"], [0.0] * 3
    n, v = layer["normal"], layer["to_viewer"]
    for light in layer["lights"]:
        own = light["light_color"]
        n_l = max(0.0, dot(n, light["to_light"]))
        r = [2 * dot(n, light["to_light"]) * a - b for a, b in zip(n, light["to_light"])]
        lobe = max(0.0, dot(r, v)) ** surface["exponent"]
        for c in range(3):
            total[c] += surface["k_ambient"][c] * own["ambient"][c] + surface["k_diffuse"][c] * own["diffuse"][c] * n_l + surface["k_specular"][c] * own["specular"][c] * lobe
    return total


def ball_world(kit, wall):
    """A world file: a gray ball, and beside it a red wall or none."""
    path = kit.folder / f"ball{int(wall)}.scene.toml"
    lines = ['[[primitive]]', 'type = "sphere"', 'radius = 0.5', 'material = "gray"', '[[material]]', 'name = "gray"', 'color = [0.7, 0.7, 0.7]', 'metallic = 0', 'roughness = 1',
             '[[light]]', 'type = "directional"', 'direction = [-0.6, -0.3, -0.7]', 'diffuse = [1, 1, 1]', '[[camera]]', 'position = [0.5, 0.3, 3.2]', 'target = [-0.25, 0, 0]',
             'vertical_fov_deg = 30']
    if wall:
        lines += ['[[primitive]]', 'type = "plane"', 'size = [2, 2]', 'position = [-0.8, 0, 0]', 'rotation_deg = [0, 0, -90]', 'material = "red"', '[[material]]', 'name = "red"',
                  'color = [0.8, 0.05, 0.05]', 'metallic = 0', 'roughness = 1']
    path.write_text("\n".join(lines) + "\n")
    return (path, "--allow-outside")


PATHS = ("--engine", "trace", "--method", "path", "--samples")
BESIDE = [(0.5 + 0.01 * i, 0.4 + 0.03 * j) for i in range(4) for j in range(6)]  # the ball's side towards the wall


def measure_sum(kit):
    rows = [row for row in kit.explain(SCENE, PLACES) if row["layers"]]
    off = max(abs(a - b) for row in rows for a, b in zip(formula(row["layers"][0]), row["color"]))
    bright = [row for row in rows if max(row["color"][:3]) > 1]
    alone, beside = (kit.explain(ball_world(kit, wall), BESIDE) for wall in (False, True))
    hue = {}
    for name, words in (("local", ()), ("by paths", (*PATHS, "64"))):
        pixels = kit.picture((*ball_world(kit, True), *words), 240, 200).part(0.5, 0.4, 0.56, 0.6)
        hue[name] = sum(p[0] for p in pixels) / sum(p[1] for p in pixels)
    return {"sampled pixels": len(rows), "color of the engine minus the printed sum, largest [linear]": off, "sampled pixels brighter than 1": len(bright),
            "the same pixels in the picture: largest code": max(max(row["codes"]) for row in bright), "the same pixels in the picture: smallest red code": min(row["codes"][0] for row in bright),
            "local light, a wall added: change of the ball [linear]": max(abs(a - b) for one, other in zip(alone, beside) for a, b in zip(one["color"], other["color"])),
            "ball beside a red wall, local: red over green": hue["local"], "ball beside a red wall, path tracing: red over green": hue["by paths"]}


def draw_sum(kit, path):
    terms = [kit.channel(SCENE, term, 190, 142) for term in TERMS]
    wall = ball_world(kit, True)
    kit.sheet(path, [[*terms, SCENE], [ball_world(kit, False), wall, (*wall, "--shadows"), (*wall, *PATHS, "256")]], 190, 142,
              below=[[*TERMS, "their sum"], ["local", "local, with a wall", "with shadows", "by paths"]], colors=160)


def measure_lambert(kit):
    """Diffuse light over the cosine, for angles of the light and of the viewer; what attenuation does with the distance."""
    def lit(light, eye=ABOVE):
        return kit.explain((*DISC, *eye, "--light", light), [(0.5, 0.5)])[0]["color"][0]
    at = {degrees: lit(f"directional:{way}") for degrees, way in LIGHTS.items()}
    eyes = [("--camera-position", eye) for eye in ("0,3,0.01", "2,2,1", "-3,0.5,0", "0,0.2,3")]
    seen = [lit(f"directional:{LIGHTS[30]}", eye) for eye in eyes]
    below = kit.explain((*DISC, *ABOVE, "--cull", "none", "--light", "directional:0,1,0"), [(0.5, 0.5)])[0]["color"][0]
    lamps = {d: lit(f"point:0,{d},0:attenuation=0.5,0.25,0.125") for d in (1, 2, 4)}
    expected = {d: 1 / (0.5 + 0.25 * d + 0.125 * d * d) for d in lamps}
    return {**{f"light at {degrees} degrees over light at 0": value / at[0] for degrees, value in at.items() if degrees},
            "light from below": below, "four viewers: largest change": max(seen) - min(seen),
            "lamp at 2 m over that at 1 m, relative to the formula": lamps[2] / lamps[1] / (expected[2] / expected[1]),
            "lamp at 4 m over that at 1 m, relative to the formula": lamps[4] / lamps[1] / (expected[4] / expected[1])}


def draw_lambert(kit, path):
    kit.sheet(path, [[(*DISC, "--camera-position", "0.7,2,2.4", "--light", f"directional:{way}") for way in LIGHTS.values()]], 180, 120,
              below=[[f"light at {degrees} degrees" for degrees in LIGHTS]], colors=32)


def highlight(kit, scene):
    """Height over width of a highlight, where it has half of its largest light or more; and [%] of the floor where it is not black."""
    picture = Picture(*read_rgb(kit.channel(scene, "specular")))
    values = [linear(sum(picture.pixels[i:i + 3]) / 3) for i in range(0, len(picture.pixels), 3)]
    half = max(values) / 2
    lit = [(i % picture.width, i // picture.width) for i, value in enumerate(values) if value > half]
    width, height = (1 + max(p[k] for p in lit) - min(p[k] for p in lit) for k in (0, 1))
    return height / width, 100 * sum(value > 0 for value in values) / kit.stats(scene)["pixels_covered"]


def floors(model):
    """The floor with the lamp ahead of the viewer, and beside him."""
    return (*FLOOR, "--lighting", model, *MODELS[model]), (*BEHIND, "--lighting", model)


def measure_blinn(kit):
    found = {f"lamp ahead at 8 degrees, {model}: height of the highlight over its width": highlight(kit, floors(model)[0])[0] for model in MODELS}
    return found | {f"lamp beside the viewer, {model}: part of the floor with a highlight [%]": highlight(kit, floors(model)[1])[1] for model in MODELS}


def draw_blinn(kit, path):
    kit.sheet(path, [[floors(model)[k] for model in MODELS] for k in (0, 1)], 200, 125, below=[[f"{model}, lamp {where}" for model in MODELS] for where in ("ahead", "beside")], colors=160)


def time_blinn(kit):
    """Shading of a floor that fills the picture, one thread [ns per pixel]: the fastest of five medians of nine, each model in turn."""
    found = {}
    for name, light, more in (("lamp", "point:1,2,1", ()), ("sun, viewer infinitely far", "directional:0.3,-1,-0.4", ("--viewer-infinity",))):
        for _ in range(5):
            for model in ("phong", "blinn-phong"):
                row = kit.row("bench", "render", "builtin:plane", "--look", "plain", "--resolution", "640,360", "--threads", "1", "--frames", "9", "--lighting", model,
                              "--camera-position", "0,1,0.1", "--camera-focal-point", "0,0,0", "--light", light, *more)
                what = f"{name}, {model} [ns per pixel]"
                found[what] = min(found.get(what, 1e9), row["stages_ms"]["shading"] * 1e6 / row["stats"]["pixels_shaded"])
    return found


def furnace(kit, roughness, *more):
    """Light that a white ball of metal sends back in even light from all around, which is 1: the mean of its middle."""
    pixels = kit.picture((*BALL, *FURNACE, "--roughness", roughness, *PATHS, "64", *more), 80 / kit.scale, 60 / kit.scale).part(0.3, 0.3, 0.7, 0.7)
    return sum(2 * linear(p[1]) for p in pixels) / len(pixels)


def measure_pbr(kit):
    found = {f"white ball in even light, roughness {r}: reflected light": furnace(kit, r) for r in ("0.3", "0.9")}
    found["the same, roughness 0.9, with multiple scattering"] = furnace(kit, "0.9", "--multiple-scattering")
    off, ends = 0, []
    for row in kit.explain((*BALL, *PLASTIC), [(x / 100, 0.5) for x in range(19, 51)]):
        if row["layers"]:
            n_v = dot(row["layers"][0]["normal"], row["layers"][0]["to_viewer"])
            ends.append((n_v, row["color"][0]))
            off = max(off, abs(row["color"][0] - (0.04 + 0.96 * (1 - n_v) ** 5)))
    facing, rim = max(ends), min(ends)
    found |= {"Fresnel: black plastic seen straight on: reflected light": facing[1], "Fresnel: the same at its rim over straight on": rim[1] / facing[1],
              "Fresnel: largest difference to Schlick's formula": off}
    plane = ("builtin:plane", *ABOVE, "--camera-focal-point", "0,0,0", "--lighting", "pbr", "--color", "#000000", "--metallic", "0", "--light", "directional:0,-1,0", "--roughness")
    sharp, dull = (kit.explain((*plane, r), [(0.5, 0.5)])[0]["color"][0] for r in ("0.3", "0.6"))
    found["microfacets: middle of a highlight, roughness 0.3 over 0.6"] = sharp / dull
    return found


def draw_pbr(kit, path):
    white = [(*BALL, *FURNACE, *PATHS, "256", "--roughness", *how) for how in (("0.3",), ("0.6",), ("0.9",), ("0.9", "--multiple-scattering"))]
    kit.sheet(path, [[*((*BALL, *LIT, "--roughness", r) for r in ("0.2", "0.4", "0.7")), (*BALL, *PLASTIC)], white], 160, 120,
              below=[["roughness 0.2", "roughness 0.4", "roughness 0.7", "black, fresnel alone"], ["white metal, 0.3", "white metal, 0.6", "white metal, 0.9", "0.9, multiple"]])


def ward(x, y):
    return (*BRUSHED, "--lighting", "ward", "--material", f"ward_alpha={x},{y}")


BLINN = (*BRUSHED, "--roughness", "0.5", "--lighting", "blinn-phong")


def measure_ward(kit):
    scenes = {"widths 0.1, 0.3": ward(0.1, 0.3), "widths 0.3, 0.1": ward(0.3, 0.1), "widths 0.2, 0.2": ward(0.2, 0.2), "Blinn-Phong": BLINN}
    return {f"{name}: height of the highlight over its width": highlight(kit, scene)[0] for name, scene in scenes.items()}


def draw_ward(kit, path):
    kit.sheet(path, [[ward(0.1, 0.3), ward(0.3, 0.1), ward(0.2, 0.2), BLINN]], 170, 150,
              below=[["ward 0.1, 0.3", "ward 0.3, 0.1", "ward 0.2, 0.2", "blinn-phong"]])


ENTRIES = (
    Entry("s1-sum", "S1 fig. 1, section 2.1; S3", "A color is the sum of the ambient, diffuse and specular terms, clamped to the largest color; it has no light from other objects", measure_sum,
          draw_sum),
    Entry("s1-lambert", "S1 section 2.1; S3", "Diffuse light is proportional to the cosine of the light's angle, and equal in all directions", measure_lambert, draw_lambert),
    Entry("s1-blinn-phong", "S1 section 2.1", "Blinn-Phong is faster than Phong and its highlights are right over a wider range of angles", measure_blinn, draw_blinn, time_blinn),
    Entry("s1-pbr", "S1 section 2.1", "Physically based rendering conserves energy and has a Fresnel effect and microfacets", measure_pbr, draw_pbr),
    Entry("s1-ward", "S1 section 2.1", "Ward's model is for reflection that depends on the direction, as of brushed metal", measure_ward, draw_ward),
)
