# SPDX-License-Identifier: Apache-2.0
"""Third source: parallax, methods compared, outlines, costs."""
import bump_pictures as bumps
from png8 import write_rgb

from sheet import ROOT

from .kit import Entry

MAPS = ROOT / "data/maps"
MAPS_WALL = "data/maps/wall.obj"
METHODS = ("none", "normal", "parallax-limited", "parallax", "steep", "occlusion")
ANGLES = {view[0]: view for view in bumps.VIEWS}
SPHERE = (*bumps.SPHERE, "--bump-depth", "0.02", "--shading", "unlit", "--background", "0,0,0", "--color", "#ffffff")
WIDE = 240, 104
DEPTHS, DEEP = ("0.06", "0.2"), ("0.005", "0.05", "0.12")


def at(view, method, *more):
    return (*bumps.wall_at(*ANGLES[view]), "--bump", method, *more)


def ridges(kit, method, depth="0.06"):
    """Arguments of four upright ridges between grooves as wide, the grooves red; seen at 60 degrees a ridge hides five sixths of a groove 0.06 deep, and all of one 0.2 deep."""
    heights, normals, colors, side = kit.folder / "ridges.png", kit.folder / "ridges-normal.png", kit.folder / "grooves.png", 128
    if not colors.exists():
        is_ridge = [x % 32 < 16 for x in range(side)]
        slopes = [is_ridge[x - 1] - is_ridge[(x + 1) % side] for x in range(side)]
        write_rgb(heights, side, side, b"".join(bytes((255, 255, 255) if up else (0, 0, 0)) for up in is_ridge) * side)
        write_rgb(normals, side, side, b"".join(bytes((128 + 90 * slope, 128, 218 if slope else 255)) for slope in slopes) * side)
        write_rgb(colors, side, side, b"".join(bytes((150, 150, 150) if up else (230, 0, 0)) for up in is_ridge) * side)
    edge = 0.02 if kit.is_small else 0.004
    return (MAPS_WALL, "--texture-base-color", colors, "--height-map", heights, "--texture-normal", normals, "--shading", "unlit", "--allow-outside", "--bump", method, "--bump-depth", depth,
            "--bump-steps", "64,64", "--displacement-edge", edge, "--camera-position", "2.94,0,1.7", "--camera-focal-point", "0,0,0", "--camera-view-angle", "20")


def floor(kit, method, depth):
    """[%] of the pixels that show the floor of a groove; what has gray of the ridges mixed in, as their sides have, is none."""
    pixels = kit.picture(ridges(kit, method, depth), 480, 160).part(0.4, 0.3, 0.6, 0.7)
    return 100 * sum(p[0] > 150 and p[1] < 5 for p in pixels) / len(pixels)


def measure_methods(kit):
    found, size = {}, [side / kit.scale for side in WIDE]  # as small as it can be already
    for view in ANGLES:
        for method in METHODS[1:]:
            found[f"{method} at {view} degrees: difference to displacement [1/255]"] = kit.rmse(at(view, method), at(view, "displacement"), *size)
    found["error at 73 degrees that parallax-limited removes [%]"] = 100 - 100 * found["parallax-limited at 73 degrees: difference to displacement [1/255]"] / found[
        "normal at 73 degrees: difference to displacement [1/255]"]
    for depth in DEPTHS:
        for method in ("none", "parallax-limited", "parallax", "steep", "displacement"):
            found[f"grooves {depth} deep, {method}: pixels of the floor [%]"] = floor(kit, method, depth)
    return found


def draw_methods(kit, path):
    methods = {**{method: () for method in METHODS}, "self-shadow": ("--bump-self-shadow",), "displacement": ()}
    kit.sheet(path, [[*(at(view, {"self-shadow": "steep"}.get(method, method), *more) for view in ANGLES),
                      ridges(kit, {"self-shadow": "steep"}.get(method, method), "0.2")] for method, more in methods.items()], 176, 76, lines=list(methods),
              columns=[*(f"{view} degrees" for view in ANGLES), "deep grooves, 60"], colors=48)


def measure_parallax(kit):
    """What the maps do to a wall seen at 48 degrees, and how far the coordinates move [texels of 256]."""
    found = {}
    normal = at(48, "normal")
    for method in ("parallax-limited", "parallax", "steep"):
        found[f"{method} vs. normal mapping [1/255]"] = kit.rmse(normal, at(48, method), *WIDE)
    for view in ANGLES:
        numbers = kit.stages(at(view, "parallax-limited"), *WIDE)[1]("relief")["numbers"]
        found[f"mean shift at {view} degrees [% of the texture]"] = next(100 * value for name, value in numbers.items() if "mean" in name and "shift" in name)
    return found


def draw_parallax(kit, path):
    kit.sheet(path, [[MAPS / "brick_normal.png", MAPS / "brick_height.png", at(48, "normal"), at(48, "parallax-limited"), at(48, "parallax")]], 160, 160,
              below=[["normal map", "heights", "normal mapping", "parallax-limited", "parallax, by v.z"]])


def bumpy(method, depth):
    """The wall with bumps of another depth; the normals of its map, which was made for 0.05, are scaled with it."""
    return at(48, method, "--bump-depth", depth, "--normal-scale", f"{float(depth) / 0.05:g}")


def measure_depth(kit):
    """Error of parallax and of normal mapping as the depth grows, at 48 degrees; and what shadows and the viewer do."""
    found, size = {}, [side / kit.scale for side in WIDE]
    for depth in DEEP:
        normal, parallax, true = (bumpy(method, depth) for method in ("normal", "parallax", "displacement"))
        found[f"depth {depth}, normal: difference to displacement [1/255]"] = kit.rmse(normal, true, *size)
        found[f"depth {depth}, parallax: difference to displacement [1/255]"] = kit.rmse(parallax, true, *size)
        found[f"depth {depth}: parallax vs. normal mapping [1/255]"] = kit.rmse(normal, parallax, *size)
    found["steep: pixels that shadows of bumps change [%]"] = kit.differing(at(48, "steep"), at(48, "steep", "--bump-self-shadow"), *size)
    wall = (MAPS_WALL, *bumps.maps("brick"), *bumps.LAMP, "--lighting", "lambert", "--camera-focal-point", "0.1,0.1,0", "--camera-view-angle", "20", "--bump")
    for method in ("normal", "parallax"):
        seen = [kit.explain((*wall, method, "--camera-position", eye), [(0.5, 0.5)], 320 / kit.scale, 240 / kit.scale)[0]["layers"][0] for eye in ("0.1,0.1,3", "2.5,0.1,1.4")]
        found[f"{method}: the same place from two sides, texture moves [% of the texture]"] = 100 * max(abs(a - b) for a, b in zip(*(layer["maps"][0]["uv"] for layer in seen)))
    return found


def draw_depth(kit, path):
    methods = ("normal", "parallax", "displacement")
    kit.sheet(path, [[bumpy(method, depth) for depth in DEEP] for method in methods], 200, 86, lines=list(methods), columns=[f"depth {d}" for d in DEEP], colors=64)


def measure_outline(kit):
    plain, moved = (*SPHERE, "--bump", "none"), (*SPHERE, *(("--displacement-edge", "0.05") if kit.is_small else ()), "--bump")
    return {f"{method}: pixels of the outline that change [%]": kit.differing(plain, (*moved, method), codes=0)
            for method in ("height", "normal", "parallax", "steep", "occlusion", "displacement")}


def draw_outline(kit, path):
    shown = ("none", "normal", "occlusion", "displacement")
    kit.sheet(path, [[(*bumps.SPHERE, "--bump-depth", "0.02", "--bump", method) for method in shown], [(*SPHERE, "--bump", method) for method in shown]], 180, 180,
              below=[list(shown), ["outline"] * 4])


def covered(kit, *more):
    return kit.stats((*at(73, "occlusion"), *more), *WIDE)["pixels_covered"]


def measure_border(kit):
    """Pixels that a wall covers whose relief sticks out at its border."""
    flat, deep = covered(kit), covered(kit, "--bump-silhouette")
    return {"pixels of the wall, parallax over none": flat / kit.stats(at(73, "none"), *WIDE)["pixels_covered"], "with --bump-silhouette over without": deep / flat}


def draw_border(kit, path):
    kit.sheet(path, [[at(73, "none"), at(73, "occlusion"), at(73, "occlusion", "--bump-silhouette"), at(73, "displacement")]], 208, 90,
              below=[["none", "occlusion", "occlusion, silhouette", "displacement"]], colors=64)


def time_methods(kit):
    """A wall that fills 640 x 360 pixels, one thread: shading [ns per pixel], processor time of all [ms]."""
    found = {}
    for method in (*METHODS, "displacement"):
        row = kit.row("bench", "render", "data/maps/wall.obj", "--look", "plain", *bumps.maps("brick"), "--camera-position", "0,0,1", "--camera-focal-point", "0,0,0", "--bump", method,
                      "--resolution", "640,360", "--frames", "5", "--threads", "1", "--lighting", "blinn-phong")
        found[f"{method} [ns per pixel]"] = row["stages_ms"]["shading"] * 1e6 / row["stats"]["pixels_shaded"]
        found[f"{method}, the whole picture [ms]"] = row["cpu_ms"]
    return found


ENTRIES = (
    Entry("s3-fig9", "S3 fig. 9", "A depth map with the normal map shifts the texture, the more the lower the view", measure_parallax, draw_parallax),
    Entry("s3-fig10", "S3 fig. 10", "Normal mapping is wrong at grazing angles, parallax repairs it, steep parallax can hide parts of the texture", measure_methods, draw_methods, time_methods),
    Entry("s3-depth", "S3, parallax mapping", "On small detail parallax and normal mapping hardly differ; parallax gets artifacts as depth grows", measure_depth, draw_depth),
    Entry("s3-outline", "S3, bump mapping", "Simulated bumps leave the outline smooth, real ones do not", measure_outline, draw_outline),
    Entry("s3-border", "S3, parallax mapping", "No parallax method shows bumps beyond the border of the texture", measure_border, draw_border),
)
