# SPDX-License-Identifier: Apache-2.0
"""What not every build of the program has: rays, the fixed-function preset, the slopes of depth. Entries that need them are left out without."""
from .kit import Entry

FIXED = ("--preset", "fixed-function")
TEAPOT = ("builtin:teapot", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "29", "--color", "#a4653a", "--roughness", "0.3",
          "--metallic", "0", "--texture-normal", "data/maps/leather_normal.png")
ONE = ("--light", "point:2,3,3:color=0.7,0.7,0.7", "--light", "ambient:0.13,0.13,0.13")
FULL = (*TEAPOT, *ONE, "--lighting", "pbr", "--shadows")
NARROW = ("builtin:teapot", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "32")
NAMES = ("s1-table1", "s2-slopes")
RAYS = ("s2-rays", "s3-fig1")


def lacks(kit, name):
    """Why the entry cannot be made with this program; None: it can be."""
    if name in RAYS and kit.run("render", "builtin:plane", "--engine", "trace", "--resolution", "8,8", "-o", kit.folder / "try.png", codes=range(256)).returncode:
        return "this program follows no rays"
    if name == "s1-table1" and "--preset" not in kit.run("render", "--help").stdout:
        return "this program has no --preset"
    if name == "s2-slopes" and not slopes(kit):
        return "this program's stages tell no slopes"
    return None


def slopes(kit):
    """Numbers and columns of all stages that speak of dz/dx."""
    folder, _ = kit.stages(NARROW)
    return [path for path in sorted(folder.glob("*.json")) if "dz/dx" in path.read_text()]


def lamps(count):
    return [word for i in range(count) for word in ("--light", f"point:{i - 5},3,3:color=0.08,0.08,0.08")]


def measure_table(kit):
    fixed = (*TEAPOT, *ONE, *FIXED)
    same = (*TEAPOT, *ONE, "--shading", "gouraud", "--lighting", "blinn-phong", "--bump", "none", "--shadows", "off")
    eight, eleven = ((*TEAPOT, *lamps(n), *FIXED) for n in (8, 11))
    return {"preset beside gouraud, blinn-phong, no bumps, no shadows [1/255]": kit.rmse(fixed, same),
            "preset beside the programmable pipeline [1/255]": kit.rmse(fixed, FULL),
            "evaluations, programmable over preset": kit.stats(FULL)["lighting_evaluations"] / kit.stats(fixed)["lighting_evaluations"],
            "a ninth to eleventh light: change with the preset [1/255]": kit.rmse(eight, eleven),
            "a normal map: change with the preset [1/255]": kit.rmse(fixed, (*(w for w in fixed if "normal" not in w),))}


def draw_table(kit, path):
    kit.sheet(path, [[(*TEAPOT, *ONE, *FIXED), FULL]], 240, 170, below=[["fixed function", "programmable"]])


def time_table(kit):
    """Processor time of a picture, the median of nine."""
    return {f"{name} [ms]": kit.row("bench", "render", *scene, "--resolution", "640,360", "--frames", "9")["cpu_ms"]
            for name, scene in (("fixed function", (*TEAPOT, *ONE, *FIXED)), ("programmable", FULL))}


def measure_slopes(kit):
    return {"stages that tell dz/dx": len(slopes(kit))}


ENTRIES = (
    Entry("s1-table1", "S1 table 1", "The fixed-function pipeline beside the programmable one", measure_table, draw_table, time_table),
    Entry("s2-slopes", "S2, incremental principle", "The slopes of a triangle's depth are used from pixel to pixel", measure_slopes),
)
