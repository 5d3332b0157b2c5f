# SPDX-License-Identifier: Apache-2.0
"""Third source: what modeled detail costs, normal mapping from nearby, what parallax is."""
import math

import bump_pictures as bumps

from .kit import Entry

WALL = ("data/maps/wall.obj", *bumps.maps("brick"), *bumps.LAMP, "--lighting", "lambert", "--camera-position", "0.6,0.3,2.6", "--camera-focal-point", "0,0,0", "--camera-view-angle", "34")
EDGES = (0.16, 0.08, 0.04, 0.02)  # [m] longest edges
AWAY = (1.2, 4.8, 19.2)  # [m] from the wall
BALLS = (("0.9,0.1,0.1", 3), ("0.1,0.1,0.9", 6))  # color, [m] from the eye


def modeled(edge):
    return (*WALL, "--bump", "displacement", "--displacement-edge", f"{edge:g}")


def finest(kit):
    return modeled(0.01 if kit.is_small else 0.005)


def measure_modeled(kit):
    found, count = {}, {}
    for edge in EDGES:
        count[edge] = kit.stats(modeled(edge))["triangles_in"]
        found[f"edges of {100 * edge:g} cm: triangles"] = count[edge]
        found[f"edges of {100 * edge:g} cm: difference to the finest [1/255]"] = kit.rmse(modeled(edge), finest(kit))
    found["normal map, 2 triangles: difference to the finest [1/255]"] = kit.rmse((*WALL, "--bump", "normal"), finest(kit))
    return found | {f"triangles, edges of {100 * b:g} cm over {100 * a:g} cm": count[b] / count[a] for a, b in zip(EDGES, EDGES[1:])}


def draw_modeled(kit, path):
    shown = {"no detail": (*WALL, "--bump", "none"), **{f"edges of {100 * edge:g} cm": modeled(edge) for edge in EDGES[1:]}, "normal map": (*WALL, "--bump", "normal")}
    kit.sheet(path, [list(shown.values())], 150, 130, below=[list(shown)], colors=96)


def time_modeled(kit):
    """Processor time of a picture [ms], the median of nine, and of the preparation."""
    found = {}
    for name, how in (*((f"edges of {100 * edge:g} cm", modeled(edge)) for edge in (*EDGES, 0.005)), ("normal map", (*WALL, "--bump", "normal"))):
        row = kit.row("bench", "render", *how, "--look", "plain", "--resolution", "640,480", "--threads", "1", "--frames", "9")
        found[f"{name} [ms]"] = row["cpu_ms"]
    return found


def from_away(away, method):
    """The wall at 70 degrees off its normal, from so far away, by one lens."""
    eye = 0.3 + away * math.sin(math.radians(70)), 0.2, away * math.cos(math.radians(70))
    return ("data/maps/wall.obj", *bumps.maps("brick"), *bumps.LAMP, "--lighting", "lambert", "--camera-position", "{:.4f},{:.4f},{:.4f}".format(*eye), "--camera-focal-point", "0.3,0,0",
            "--camera-view-angle", "26", "--bump", method)


def measure_near(kit):
    found = {}
    for away in AWAY:
        wrong = kit.rmse((*from_away(away, "normal"), "--samples", "8"), (*from_away(away, "displacement"), "--samples", "8"))
        seen = kit.stats(from_away(away, "normal"))["pixels_covered"] / math.prod(kit.size(320, 240))
        found[f"from {away:g} m: difference to displacement, of the wall's pixels [1/255]"] = wrong / math.sqrt(seen)
    return found


def draw_near(kit, path):
    kit.sheet(path, [[from_away(away, method) for away in AWAY] for method in ("normal", "displacement")], 200, 120, lines=["normal", "displaced"], columns=[f"{away:g} m" for away in AWAY], colors=64)


def balls(kit, eye):
    """A red ball 3 m before the eye and a blue one 6 m before it, seen from `eye` m to the right."""
    path, lines = kit.folder / "balls.scene.toml", []
    for k, (color, away) in enumerate(BALLS):
        lines += ["[[primitive]]", 'type = "sphere"', "radius = 0.25", f"position = [{-0.4 if k == 0 else 0.6}, 0, {-away}]", f'material = "m{k}"', "[[material]]", f'name = "m{k}"', f"color = [{color}]"]
    path.write_text("\n".join(lines) + "\n")
    return (path, "--allow-outside", "--shading", "unlit", "--background", "0,0,0", "--camera-position", f"{eye},0,0", "--camera-focal-point", f"{eye},0,-1", "--camera-view-angle", "40")


def measure_parallax(kit):
    """How far each ball moves in the picture as the viewer steps aside by 0.3 m."""
    at = []
    for eye in (0, 0.3):
        picture = kit.picture(balls(kit, eye))
        sums = [[0, 0], [0, 0]]
        for i in range(0, len(picture.pixels), 3):
            r, _, b = picture.pixels[i:i + 3]
            if max(r, b) > 100:
                sums[b > r][0] += i // 3 % picture.width
                sums[b > r][1] += 1
        at.append([total / count for total, count in sums])
    near, far = (abs(a - b) / kit.scale for a, b in zip(*at))
    return {"viewer 0.3 m aside: the ball at 3 m moves by [px]": near, "the ball at 6 m moves by [px]": far, "near over far": near / far}


def draw_parallax(kit, path):
    kit.sheet(path, [[balls(kit, 0), balls(kit, 0.3)]], 200, 100, below=[["the viewer", "the viewer 0.3 m aside"]], colors=16)


ENTRIES = (
    Entry("s3-modeled", "S3, introduction; S1 section 4", "Modeled detail makes triangles and time grow; a map is cheaper", measure_modeled, draw_modeled, time_modeled),
    Entry("s3-near", "S3, normal mapping", "Normal mapping looks wrong at small angles, especially when the viewer is near", measure_near, draw_near),
    Entry("s3-parallax", "S3, parallax mapping", "Parallax: when the viewer moves, distant objects move less than near ones", measure_parallax, draw_parallax),
)
