# SPDX-License-Identifier: Apache-2.0
"""First source: lighting by vertices beside lighting by pixels."""
import shading_table as spheres

from .kit import Entry, brightness

SPHERE = tuple(word for word in spheres.VIEW if word not in ("--resolution", "512,512"))
FACE = ("builtin:plane", "--camera-position", "0,2.6,1.2", "--camera-focal-point", "0,0,0", "--camera-view-angle", "34", "--lighting", "blinn-phong")
SPOT = (*FACE, "--light", "spot:0,1,0:direction=0,-1,0:cutoff=16:exponent=9", "--light", "ambient:0.1,0.1,0.1")
SHINE = (*FACE, "--roughness", "0.2", "--light", "directional:0,-0.91,0.42:color=0.2,0.2,0.2:specular=1,1,1")
SPOTTED = ("data/spot/spot_slab5.glb", "--normals", "model", "--view", "left", "--light", "directional:1,-1,-0.8:color=0.7,0.7,0.7", "--light", "ambient:0.1,0.1,0.1")
PARTS = ("--shading", "gouraud", "--shading", "object:part0=flat", "--shading", "object:part2=phong")
SMALL = 84, 64
TWO_SPHERES = ("data/materials/spheres.gltf", "--light", "directional:-1,-1,-1", "--light", "ambient:0.1,0.1,0.1")


def sphere(kit, rows, shading):
    """Arguments of a sphere with so many rows of faces."""
    path = kit.folder / f"sphere{rows}.obj"
    if not path.exists():
        spheres.write_sphere(path, rows)
    return (path, *SPHERE, "--shading", shading)


def finest(kit):
    return 64 if kit.is_small else 128


def measure_spheres(kit):
    best, found = sphere(kit, finest(kit), "phong"), {}
    for rows in (8, 16, 32):
        for shading in ("gouraud", "phong"):
            one = sphere(kit, rows, shading)
            found[f"{kit.render(one, 512, 512)[1]['triangles']} triangles, {shading}: difference to the finest [1/255]"] = kit.rmse(one, best, 512, 512)
    coarse = {shading: sphere(kit, 8, shading) for shading in ("gouraud", "phong")}
    brightest = {shading: max(map(sum, kit.picture(a, 512, 512).part(0, 0, 1, 1))) / 3 for shading, a in coarse.items()}
    found["brightest pixel of 224 triangles, gouraud [1/255]"] = brightest["gouraud"]
    found["brightest pixel of 224 triangles, phong [1/255]"] = brightest["phong"]
    evaluations = {shading: kit.stats(a, 512, 512)["lighting_evaluations"] for shading, a in coarse.items()}
    found["lighting evaluations, phong over gouraud, 224 triangles"] = evaluations["phong"] / evaluations["gouraud"]
    return found


def draw_spheres(kit, path):
    rows = [[sphere(kit, n, shading) for shading in ("gouraud", "phong")] for n in (8, 16)]
    kit.sheet(path, [rows[0] + rows[1]], 180, 180, below=[["224, vertices", "224, pixels", "960, vertices", "960, pixels"]])


def time_spheres(kit):
    """Processor time of a picture of 512 x 512 [ms], one thread, the median of nine; with its own light, and with seven more."""
    found, more = {}, [word for i in range(7) for word in ("--light", f"point:{i - 3},2,4:color=0.1,0.1,0.1")]
    for count, lights in ((1, ()), (8, more)):
        for shading in ("gouraud", "phong"):
            row = kit.row("bench", "render", *sphere(kit, 32, shading), *lights, "--look", "plain", "--resolution", "512,512", "--threads", "1", "--frames", "9")
            found[f"3968 triangles, {count} point light{'s' * (count > 1)}, {shading} [ms]"] = row["cpu_ms"]
    return found


def measure_face(kit):
    found = {}
    for name, scene in (("spot light", SPOT), ("highlight", SHINE)):
        for shading in ("gouraud", "phong"):
            middle, side = kit.explain((*scene, "--shading", shading), [(0.5, 0.5), (0.3, 0.5)])
            found[f"{name}, {shading}: middle minus side [linear]"] = brightness(middle["color"]) - brightness(side["color"])
    return found


def draw_face(kit, path):
    kit.sheet(path, [[(*scene, "--shading", shading) for scene in (SPOT, SHINE) for shading in ("gouraud", "phong")]], 180, 135,
              below=[["spot, vertices", "spot, pixels", "highlight, vertices", "highlight, pixels"]])


def same_places(kit):
    """{part: [%] of its places whose codes in the mixed picture are those of the picture that is all lit as the part's word says}."""
    places = [(0.04 + 0.04 * i, 0.05 + 0.06 * j) for i in range(24) for j in range(16)]
    rows = {how: kit.explain((*SPOTTED, *words), places) for how, words in (("mixed", PARTS), *((h, ("--shading", h)) for h in ("flat", "gouraud", "phong")))}
    found = {}
    for part, hows in (("part0", ("flat", "phong")), ("part2", ("phong", "flat")), ("other parts", ("gouraud", "phong"))):
        names = [row["shows"]["object"] if row["shows"] else None for row in rows["mixed"]]
        of_part = [k for k, name in enumerate(names) if name and (name == part or part == "other parts" and name not in ("part0", "part2"))]
        for how in hows:
            found[f"{part}: sampled pixels equal to all {how} [%]"] = 100 * sum(rows["mixed"][k]["codes"] == rows[how][k]["codes"] for k in of_part) / len(of_part)
    return found


def measure_mixed(kit):
    count = {shading: kit.stats((*SPOTTED, "--shading", shading))["lighting_evaluations"] for shading in ("gouraud", "phong")}
    mixed = kit.stats((*SPOTTED, *PARTS))["lighting_evaluations"]
    automatic = {shading: (*TWO_SPHERES, "--shading", shading) for shading in ("gouraud", "auto", "phong")}
    small = {name: kit.rmse(a, automatic["phong"], *(side / kit.scale for side in SMALL)) for name, a in automatic.items()}
    lit = {name: kit.stats(a, *(side / kit.scale for side in SMALL))["lighting_evaluations"] for name, a in automatic.items()}
    return {"evaluations, mixed over gouraud": mixed / count["gouraud"], "evaluations, mixed over phong": mixed / count["phong"], **same_places(kit),
            "two spheres, gouraud: difference to phong [1/255]": small["gouraud"], "two spheres, auto: difference to phong [1/255]": small["auto"],
            "two spheres, auto: evaluations over phong": lit["auto"] / lit["phong"], "two spheres, gouraud: evaluations over phong": lit["gouraud"] / lit["phong"]}


def draw_mixed(kit, path):
    spheres = [kit.render((*TWO_SPHERES, "--shading", shading), *SMALL)[0] for shading in ("gouraud", "auto", "phong")]
    kit.sheet(path, [[(*SPOTTED, "--shading", "gouraud"), (*SPOTTED, *PARTS), (*SPOTTED, "--shading", "phong")], spheres], 252, 192,
              below=[["vertices", "one part a face, one a pixel", "pixels"], ["vertices, 84 x 64", "auto", "pixels"]])


ENTRIES = (
    Entry("s1-fig3", "S1 fig. 3, section 2.3", "Per-vertex lighting fails on coarse meshes and blurs highlights; per-pixel lighting costs more", measure_spheres, draw_spheres,
          time_spheres),
    Entry("s1-large-face", "S1 section 2.3, S2", "Per-vertex lighting shows no sharp reflections, spot lights or fine detail, and no highlight inside a large face", measure_face, draw_face),
    Entry("s1-mixed", "S1 section 2.3.3", "Engines mix per-vertex and per-pixel lighting", measure_mixed, draw_mixed),
)
