# SPDX-License-Identifier: Apache-2.0
"""First source: radiosity indoors, and textures seen from nearby."""
import bump_pictures as bumps
from png8 import read_rgb, write_rgb

from sheet import ROOT

from .kit import Entry, linear

ROOM = (("floor", "[0, 0, 0]", "[0, 0, 0]", "[4, 4]", "white"), ("ceiling", "[0, 2.5, 0]", "[180, 0, 0]", "[4, 4]", "white"), ("back", "[0, 1.25, -2]", "[90, 0, 0]", "[4, 2.5]", "white"),
        ("left", "[-2, 1.25, 0]", "[0, 0, -90]", "[2.5, 4]", "red"), ("right", "[2, 1.25, 0]", "[0, 0, 90]", "[2.5, 4]", "green"))
COLORS = {"white": "[0.75, 0.75, 0.75]", "red": "[0.6, 0.06, 0.05]", "green": "[0.1, 0.45, 0.1]"}
SIZE = 96, 72
LOCAL, PATHS = ("--engine", "trace", "--method", "whitted"), ("--engine", "trace", "--method", "path", "--samples", "128")
WALL = ("data/maps/wall.obj", *bumps.LAMP, "--camera-position", "0.35,0.25,0.9", "--camera-focal-point", "0.1,0.1,0", "--camera-view-angle", "40", "--lighting", "lambert", "--allow-outside",
        "--color", "#ffffff")
SIDES = (64, 128, 512)


def world(kit, is_room, is_panel=False):
    """A box and a ball in a room that is open towards the camera, or on its floor alone; one lamp, a point or a panel."""
    path, lines = kit.folder / f"room{int(is_room)}{int(is_panel)}.scene.toml", []
    for name, position, turn, size, material in ROOM if is_room else ROOM[:1]:
        lines += ["[[primitive]]", 'type = "plane"', f'name = "{name}"', f"position = {position}", f"rotation_deg = {turn}", f"size = {size}", f'material = "{material}"']
    lines += ["[[primitive]]", 'type = "sphere"', "radius = 0.5", "tolerance = 0.01", "position = [0.7, 0.5, 0.2]", 'material = "white"']
    lines += ["[[model]]", f'file = "{ROOT / "data/cages/cube.obj"}"', "scale = [0.45, 0.8, 0.45]", "position = [-0.7, 0.8, -0.5]", "rotation_deg = [0, 25, 0]", 'normals = "flat"', 'material = "white"']
    for name, color in COLORS.items():
        lines += ["[[material]]", f'name = "{name}"', f"color = {color}", "metallic = 0", "roughness = 1", "specular_factor = 0"]
    if is_panel:
        lines += ["[[primitive]]", 'type = "plane"', "position = [0, 2.1, 0.4]", "rotation_deg = [180, 0, 0]", "size = [0.9, 0.9]", 'material = "lamp"', "[[material]]", 'name = "lamp"',
                  "color = [0, 0, 0]", "emission = [6, 6, 6]"]
    else:
        lines += ["[[light]]", 'type = "point"', "position = [0, 2.1, 0.4]", "diffuse = [1.6, 1.6, 1.6]", "attenuation = [0, 0, 1]"]
    lines += ["[[camera]]", "position = [0, 1.25, 5.2]", "target = [0, 1.2, 0]",
              "vertical_fov_deg = 40"]
    path.write_text("\n".join(lines) + "\n")
    return (path, "--allow-outside", "--lighting", "lambert", "--background", "0,0,0")


def shot(kit):
    return ("--engine", "trace", "--method", "radiosity", "--radiosity-elements", "2000" if kit.is_small else "10000")


def measure_radiosity(kit):
    found, size = {}, [side / kit.scale for side in SIZE]
    for name, is_room in (("room", True), ("floor alone", False)):
        scene = world(kit, is_room)
        local, radiosity = (kit.rmse((*scene, *how), (*scene, *PATHS), *size) for how in (LOCAL, shot(kit)))
        found |= {f"{name}: local light and shadows vs. paths [1/255]": local, f"{name}: radiosity vs. paths [1/255]": radiosity}
    for name, how in (("local light", LOCAL), ("radiosity", shot(kit)), ("paths", PATHS)):
        found[f"ball's shadow on the floor, {name}: mean code"] = kit.picture((*world(kit, True), *how), *size).mean(0.66, 0.86, 0.7, 0.89)
    for name, is_panel in (("point lamp", False), ("panel", True)):
        pixels = [linear(p[1]) for p in kit.picture((*world(kit, False, is_panel), *PATHS), *(2 * side for side in size)).part(0.74, 0.83, 0.885, 0.85)]
        low, high = min(pixels), max(pixels)
        found[f"edge of the ball's shadow, {name}, paths: half-lit pixels [%]"] = 100 * sum(low + 0.25 * (high - low) < p < low + 0.75 * (high - low) for p in pixels) / len(pixels)
    return found


def draw_radiosity(kit, path):
    rows = [[(*world(kit, is_room), *how) for how in (LOCAL, shot(kit), PATHS)] for is_room in (True, False)]
    for row, is_room in zip(rows, (True, False)):
        row.append((*world(kit, is_room, True), *PATHS))
    kit.sheet(path, rows, 180, 135, below=[["local light, shadows", "radiosity", "paths", "paths, lamp a panel"]] * 2, colors=160)


def colors(kit):
    """Pictures of bricks and joints, with grain of 512 x 512 texels, and means of it: {texels a side: path}."""
    side, height = SIDES[-1], read_rgb(ROOT / "data/maps/brick_height.png")
    made, state = [], 12345
    for y in range(side):
        row = []
        for x in range(side):
            state = (1103515245 * state + 12345) % 2 ** 31
            grain = (state >> 16) % 41 - 20
            is_brick = height[2][3 * (y * height[1] // side * height[0] + x * height[0] // side)] > 110
            row.append(tuple(c + grain for c in ((168, 84, 62) if is_brick else (168, 162, 150))))
        made.append(row)
    found = {}
    for n in SIDES:
        k, found[n] = side // n, kit.folder / f"bricks{n}.png"
        write_rgb(found[n], n, n, bytes(sum(made[k * y + j][k * x + i][c] for j in range(k) for i in range(k)) // (k * k) for y in range(n) for x in range(n) for c in range(3)))
    return found


def near_walls(kit):
    """{name: arguments}: the wall with three textures, with the finest and a normal map, and of true bricks."""
    if "bricks" not in kit.made:
        kit.made["bricks"] = colors(kit)
    made = kit.made["bricks"]
    found = {f"texture of {n} texels": (*WALL, "--texture-base-color", path, "--bump", "none") for n, path in made.items()}
    found["64 texels and a normal map"] = (*WALL, *bumps.maps("brick"), "--texture-base-color", made[SIDES[0]], "--bump", "normal")
    edge = "0.02" if kit.is_small else "0.008"
    return found, (*WALL, *bumps.maps("brick"), "--texture-base-color", made[SIDES[-1]], "--bump", "displacement", "--bump-bias", "1", "--displacement-edge", edge)


def measure_textures(kit):
    shown, true = near_walls(kit)
    found = {f"{name}: difference to true bricks [1/255]": kit.rmse(scene, true) for name, scene in shown.items()}
    first, finest, mapped = (found[f"{name}: difference to true bricks [1/255]"] for name in ("texture of 64 texels", "texture of 512 texels", "64 texels and a normal map"))
    return found | {"error that 64 times the texels remove [%]": 100 - 100 * finest / first, "error that the normal map removes [%]": 100 - 100 * mapped / first}


def draw_textures(kit, path):
    shown, true = near_walls(kit)
    names = list(shown)
    kit.sheet(path, [[shown[names[0]], shown[names[2]], shown[names[3]], true]], 190, 142, below=[["64 texels a side", "512 texels", "64 texels, normal map", "true bricks, 512"]], colors=160)


ENTRIES = (
    Entry("s1-radiosity", "S1 section 2.1", "Radiosity transports light from surface to surface and is effective indoors", measure_radiosity, draw_radiosity),
    Entry("s1-textures", "S1 section 4", "Finer textures help little at close range, where the shading of the relief is missing", measure_textures, draw_textures),
)
