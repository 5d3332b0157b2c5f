# SPDX-License-Identifier: Apache-2.0
"""What not every build of the program has: rays, the fixed-function preset, the slopes of depth, bitangents of their own, the full model of Oren and Nayar.
Entries that need them are left out without."""
import bump_pictures as bumps

from .kit import Entry

FIXED = ("--preset", "fixed-function")
TEAPOT = ("builtin:teapot", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "29", "--color", "#a4653a", "--roughness", "0.3",
          "--metallic", "0", "--texture-normal", "data/maps/leather_normal.png")
ONE = ("--light", "point:2,3,3:color=0.7,0.7,0.7", "--light", "ambient:0.13,0.13,0.13")
FULL = (*TEAPOT, *ONE, "--lighting", "pbr", "--shadows")
NARROW = ("builtin:teapot", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "32")
NEED = {"s1-table1": "--preset", "s1-bitangents": "--bitangents", "s1-oren-nayar": "oren-nayar-full"}
SHEARED = bumps.SHEARED
SQUARE = ("data/maps/wall.obj", *bumps.SHEARED[1:])
ROUGH = ("builtin:sphere", "--color", "#c04030", "--roughness", "1", "--camera-position", "0,0,4.5", "--camera-focal-point", "0,0,0", "--camera-view-angle", "29",
         "--light", "directional:1,-0.3,-0.4")
BALL = ("builtin:sphere", "--camera-position", "0,0,4.5", "--camera-focal-point", "0,0,0", "--camera-view-angle", "29", "--color", "#ffffff", "--metallic", "0", "--background", "0,0,0",
        "--light", "directional:-0.3,-0.3,-1")
# Texts of one's own: the equation of Lambert's model, and three steps of its light.
TEXT = """RL_FN LightTerms user_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light)
{{
    LightTerms terms;
    real lit = lambert_cosine(dot(s.diffuse_n, light.l));
    terms.ambient = s.base.ambient * (light.ambient * light.attenuation);
    terms.diffuse = s.base.diffuse * (light.diffuse * ({lit} * light.attenuation));
    terms.specular = vec3(0.0f);
    return terms;
}}
"""
TEXTS = {"lambert": "lit", "steps": "floor(lit * 3.0f + 0.5f) / 3.0f"}
RAYS = ("s1-sum", "s1-pbr", "s1-radiosity", "s2-rays", "s2-waves", "s3-fig1")


def lacks(kit, name):
    """Why the entry cannot be made with this program; None: it can be."""
    if name in RAYS and kit.run("render", "builtin:plane", "--engine", "trace", "--resolution", "8,8", "-o", kit.folder / "try.png", codes=range(256)).returncode:
        return "this program follows no rays"
    if name == "s1-table1" and kit.run("render", "builtin:plane", "--engine", "gl", "--resolution", "8,8", "-o", kit.folder / "try.png", codes=range(256)).returncode:
        return "OpenGL cannot be used here"
    if name in NEED and NEED[name] not in kit.run("render", "--help").stdout:
        return f"this program has no {NEED[name]}"
    if name == "s2-slopes" and "slopes" not in " ".join(map(str, kit.stages(NARROW)[1]("depth").get("columns", ()))):
        return "this program's stages tell no slopes"
    return None


def lamps(count):
    return [word for i in range(count) for word in ("--light", f"point:{i - 5},3,3:color=0.08,0.08,0.08")]


def by_text(kit, name):
    """The ball, lit by a text of one's own."""
    path = kit.folder / f"{name}.glsl"
    path.write_text(TEXT.format(lit=TEXTS[name]))
    return (*BALL, "--engine", "gl", "--lighting", path)


def colors_of(kit, scene):
    return len(set(kit.picture(scene).part(0, 0, 1, 1)))


def measure_own_texts(kit):
    own, built_in = by_text(kit, "lambert"), (*BALL, "--engine", "gl", "--lighting", "lambert")
    return {"control: the equation of Lambert as a text of one's own vs. the built-in one, largest difference [1/255]": 255 * kit.compare(own, built_in)["max_error"],
            "shaders: a text with three steps of light, different colors in the picture": colors_of(kit, by_text(kit, "steps")),
            "shaders: the preset alone, different colors in the picture": colors_of(kit, (*BALL, *FIXED))}


def measure_table(kit):
    fixed, size = (*TEAPOT, *ONE, *FIXED), (320 / kit.scale, 240 / kit.scale)
    bare = ("data/maps/wall.obj", "--camera-position", "1.2,0.4,3.1", "--camera-focal-point", "0,0,0", "--camera-view-angle", "36", *ONE)  # a classical material
    words = ("--shading", "gouraud", "--lighting", "blinn-phong", "--specular", "textbook", "--viewer-infinity", "--bump", "none", "--shadows", "off")
    eight, eleven = ((*TEAPOT, *lamps(n), *FIXED) for n in (8, 11))
    return {"a classical material: preset vs. its options one by one [1/255]": kit.rmse((*bare, *FIXED), (*bare, *words)),
            "preset vs. the programmable pipeline [1/255]": kit.rmse(fixed, FULL),
            "evaluations, programmable over preset": kit.stats(FULL, *size)["lighting_evaluations"] / kit.stats(fixed, *size)["lighting_evaluations"],
            "a ninth to eleventh light: change with the preset [1/255]": kit.rmse(eight, eleven),
            "a normal map: change with the preset [1/255]": kit.rmse(fixed, (*(w for w in fixed if "normal" not in w),)), **measure_own_texts(kit)}


def draw_table(kit, path):
    own = kit.render(by_text(kit, "steps"), 240, 170)[0]
    kit.sheet(path, [[(*TEAPOT, *ONE, *FIXED), FULL, own]], 240, 170, below=[["fixed function", "programmable", "own text, three steps"]])


def time_table(kit):
    """Processor time of a picture, the median of nine."""
    return {f"{name} [ms]": kit.row("bench", "render", *scene, "--resolution", "640,360", "--frames", "9")["cpu_ms"]
            for name, scene in (("fixed function", (*TEAPOT, *ONE, *FIXED)), ("programmable", FULL))}


def measure_slopes(kit):
    """Depths by steps of the slopes, beside those of the engine, of all visible triangles; and from pixel to pixel inside of one."""
    table = kit.stages(NARROW)[1]("depth")
    numbers, rows = table["numbers"], table["rows"]
    wall = ("builtin:plane", "--camera-position", "0,1,2", "--camera-focal-point", "0,0,0", "--camera-view-angle", "30")
    w, h = kit.size(320, 240)
    a, b = (row["triangles"][0] for row in kit.explain(wall, [(0.5 + 0.2 / w, 0.4), (0.5 + 10.2 / w, 0.4 + 6 / h)]))
    slope = a["depth_plane"]["slope"]
    return {"triangles": len(rows), "largest difference, all visible triangles [depth key]": numbers["largest difference, all visible triangles"],
            "largest change of the depth key by the steps": max(abs(row[7] - row[3]) for row in rows),
            "floor, ten pixels on and six down: key minus that of the slopes [depth key]": b["depth_key"] - a["depth_key"] - 10 * slope[0] - 6 * slope[1],
            "floor: change of the key on that path [depth key]": abs(b["depth_key"] - a["depth_key"])}


def draw_slopes(kit, path):
    folder, _ = kit.stages(NARROW, 320, 240)
    kit.sheet(path, [[folder / "depth.png", folder / "picture.png"]], 320, 240, below=[["depth", "the picture"]], colors=128)


def measure_bitangents(kit):
    """Sheared texture coordinates: v is not across u, so the cross product is not its direction."""
    own = (*SHEARED, "--bitangents", "attribute")
    return {"bitangents of their own vs. the cross product [1/255]": kit.rmse(SHEARED, own, 208, 208), "pixels that differ [%]": kit.differing(SHEARED, own, 208, 208),
            "a square that is not sheared: pixels that differ [%]": kit.differing(SQUARE, (*SQUARE, "--bitangents", "attribute"), 208, 208)}


def draw_bitangents(kit, path):
    own = (*SHEARED, "--bitangents", "attribute")
    kit.sheet(path, [[SHEARED, own, (own, SHEARED, 4)]], 208, 208, below=[["cross product", "bitangents of their own", "difference x 4"]], colors=0)


def measure_rough(kit):
    """The rough models beside Lambert's: at the rim towards the light, and in color."""
    found, color = {}, {}
    for model in ("lambert", "oren-nayar", "oren-nayar-full"):
        middle, rim = (row["color"] for row in kit.explain((*ROUGH[:-1], "directional:0,0,-1", "--lighting", model), [(0.5, 0.5), (0.21, 0.5)]))
        side = kit.explain((*ROUGH, "--lighting", model), [(0.42, 0.45)])[0]["color"]
        found[f"{model}, lit from the viewer: light at the rim over that of the middle"], color[model] = rim[0] / middle[0], side[0] / side[1]
    found["red over green, full over qualitative"] = color["oren-nayar-full"] / color["oren-nayar"]
    found["full vs. qualitative [1/255]"] = kit.rmse((*ROUGH, "--lighting", "oren-nayar"), (*ROUGH, "--lighting", "oren-nayar-full"))
    return found


def draw_rough(kit, path):
    models = ("lambert", "oren-nayar", "oren-nayar-full")
    kit.sheet(path, [[(*ROUGH[:-1], light, "--lighting", model) for model in models] for light in ("directional:0,0,-1", ROUGH[-1])], 200, 160,
              below=[[f"{model}, from viewer" for model in models], list(models)], colors=0)


ENTRIES = (
    Entry("s1-table1", "S1 table 1", "The fixed-function pipeline compared with the programmable one", measure_table, draw_table, time_table),
    Entry("s1-oren-nayar", "S1 section 2.1", "The model of Oren and Nayar is for rough matte surfaces", measure_rough, draw_rough),
    Entry("s1-bitangents", "S1 section 5.2, S3", "The smoothed bitangent is a separate attribute", measure_bitangents, draw_bitangents),
    Entry("s2-slopes", "S2, incremental principle", "The slopes of a triangle's depth are reused from pixel to pixel", measure_slopes, draw_slopes),
)
