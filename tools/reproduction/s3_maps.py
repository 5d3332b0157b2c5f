# SPDX-License-Identifier: Apache-2.0
"""Third source: interpolated normals, what the colors of a normal map mean, where it is lit."""
import math

import bump_pictures as bumps
from png8 import read_rgb, write_rgb

from sheet import ROOT

from .arrows import line
from .kit import Entry, Picture, angle, brightness, dot, linear, unit

MAPS = ROOT / "data/maps"
TEAPOT = ("builtin:teapot:divisions=4", "--camera-position", "0.9,1.4,2.6", "--camera-focal-point", "0.07,0.45,0", "--camera-view-angle", "29", *bumps.KEY, *bumps.SHINY,
          "--lighting", "blinn-phong")
FLAT, PHONG = (*TEAPOT, "--normals", "flat", "--shading", "flat"), (*TEAPOT, "--normals", "model", "--shading", "phong")
HEAD = ("data/head/head.obj", "--normals", "model", "--camera-position", "0.1,0.29,0.5", "--camera-focal-point", "0,0.282,0.1", "--camera-view-angle", "20", "--light",
        "directional:-1,-0.5,-0.6:color=0.8,0.8,0.8", "--light", "ambient:0.1,0.1,0.1")
DENTS = (*bumps.DENTS, *bumps.LAMP, "--bump", "normal")
FRAMES = {"vertex": ("--tangent-space", "vertex"), "transposed": ("--tangent-space", "transposed"), "pixel": ("--tangent-space", "pixel")}
LEANING = bumps.SHEET
STRAIGHT = tuple(word for word in bumps.SHEET if word not in ("--orthogonalize", "off"))
FACES = tuple({"model": "flat"}.get(word, word) for word in STRAIGHT)


def measure_normals(kit):
    """How far the normal at a pixel is from the corners' normals, mixed by the barycentric coordinates and normalized."""
    places = [(0.3 + 0.06 * i, 0.45 + 0.06 * j) for i in range(6) for j in range(4)]
    worst, count = 0, 0
    by_vertex, by_pixel = (kit.explain((*TEAPOT, "--normals", "model", "--shading", shading), places) for shading in ("gouraud", "phong"))
    for corners, pixel in zip(by_vertex, by_pixel):
        if corners["layers"] and len(corners["layers"][0]["corners"]) == 3:
            layer = corners["layers"][0]
            mixed = unit([dot(layer["barycentric"], axis) for axis in zip(*(c["normal"] for c in layer["corners"]))])
            worst = max(worst, angle(mixed, pixel["layers"][0]["normal_interpolated"]))
            count += 1
    flat, smooth = (len({bytes(p) for p in Picture(*read_rgb(kit.channel(scene, "normal"))).part(0, 0, 1, 1)}) for scene in (FLAT, PHONG))
    return {"sampled pixels": count, "normal: error to the interpolated one of the corners [degrees]": worst, "number of normals, phong over flat": smooth / flat,
            "flat vs. phong [1/255]": kit.rmse(FLAT, PHONG)}


def draw_normals(kit, path):
    kit.sheet(path, [[FLAT, kit.channel(FLAT, "normal"), PHONG, kit.channel(PHONG, "normal")]], 190, 142, below=[["flat", "its normals", "phong", "its normals"]], colors=0)


def light_inside(pictures):
    """The logarithm of the light of each picture, and the places that have five pixels of a row inside of the model in all of them."""
    width, background = pictures[0].width, pictures[0].pixels[:3]
    lights = [[math.log(max(1e-3, brightness([linear(c) for c in p.pixels[i:i + 3]]))) for i in range(0, len(p.pixels), 3)] for p in pictures]
    inside = [all(p.pixels[3 * i:3 * i + 3] != background for p in pictures) for i in range(len(lights[0]))]
    return lights, [i for i in range(2, len(inside) - 2) if 2 <= i % width < width - 2 and all(inside[i - 2:i + 3])]


def measure_combination(kit):
    """Light is the texture's color times the light of the surface: their logarithms add up. Where they have nothing to do with each other, so do the squares of
    their details. The pictures are large, because small ones lose the detail of the map."""
    bare, mapped = (*HEAD, "--bump", "none"), (*HEAD, "--bump", "normal")
    found = {"texture and map vs. texture alone [1/255]": kit.rmse(bare, mapped), "pixels that the map changes [%]": kit.differing(bare, mapped)}
    (alone, both), places = light_inside([kit.picture(scene, 1066, 800) for scene in (bare, mapped)])
    added = [b - a for a, b in zip(alone, both)]
    of_texture, of_both, of_map = (math.sqrt(sum((light[i] - sum(light[i - 2:i + 3]) / 5) ** 2 for i in places)) for light in (alone, both, added))
    return found | {"detail of the head, texture and map over texture alone": of_both / of_texture,
                    "detail of the head, texture and map over that of both if independent": of_both / math.hypot(of_texture, of_map)}


def head_part(kit, name):
    """A part of the head's color or normal map, as the program shows it."""
    path = kit.folder / f"part-{name}.png"
    kit.run("render", "builtin:plane", "--look", "plain", "--material", "color=1,1,1", "--texture-base-color", ROOT / "data/head" / name, "--shading", "unlit",
            "--view", "top", "--camera-zoom-factor", "1.1", "--resolution", "180,180", "-o", path, "--quiet", "--allow-outside")
    return path


def draw_combination(kit, path):
    bare, mapped = (*HEAD, "--bump", "none"), (*HEAD, "--bump", "normal")
    kit.sheet(path, [[head_part(kit, "color.jpg"), head_part(kit, "normal_from_bump.png"), bare, mapped]], 180, 180, below=[["texture", "normal map", "without", "with the map"]], colors=200)


def lean(picture, x, y):
    """Codes of red and green over 128, of a place from 0 to 1."""
    red, green, _ = picture.at(x, y)
    return red - 128, green - 128


def measure_colors(kit):
    """The map of a bump (left half) and of a dent (right half): what the sides of each have, and what `explain` reads of the flat part."""
    picture = Picture(*read_rgb(MAPS / "dents_normal.png"))
    found = {}
    for name, x in (("bump", 0.25), ("dent", 0.75)):
        found[f"{name}: red at its right side, over 128"] = lean(picture, x + 0.12, 0.5)[0]
        found[f"{name}: red at its left side, over 128"] = lean(picture, x - 0.12, 0.5)[0]
        found[f"{name}: green at its top, over 128"] = lean(picture, x, 0.38)[1]
        found[f"{name}: green at its bottom, over 128"] = lean(picture, x, 0.62)[1]
    found["section: steep texels whose red points downhill [%]"] = downhill()
    found["smallest blue of the map"] = min(picture.pixels[2::3])
    codes = ((*bumps.ZERO, "--normal-map-zero", zero) for zero in ("127.5", "128"))
    for zero, scene in zip(("127.5", "128"), codes):
        texel = kit.explain(scene, [(0.5, 0.15)], 192, 192)[0]["layers"][0]["normal_texel"]
        found[f"code 128 with zero at {zero}: tilt of the normal [degrees]"] = angle(texel, (0, 0, 1))
    return found


def section():
    """Row of heights through the middle of bump and dent, from 0 to 1, and of the map's colors."""
    heights, normals = (Picture(*read_rgb(MAPS / f"dents_{name}.png")) for name in ("height", "normal"))
    places = [(x + 0.5) / heights.width for x in range(heights.width)]
    return [heights.at(x, 0.5)[0] / 255 for x in places], [normals.at(x, 0.5) for x in places]


def downhill():
    """[%] of the steep places of the section whose red leans downhill: more than 128 where the surface falls to the right."""
    heights, colors = section()
    slopes = [(heights[i + 1] - heights[i - 1], colors[i][0] - 128) for i in range(1, len(heights) - 1)]
    steep = [slope * red < 0 for slope, red in slopes if abs(slope) > 0.02]
    return 100 * sum(steep) / len(steep)


def write_section(path, side):
    """The section as a picture, with the normals of the map as arrows in its colors."""
    heights, colors = section()
    picture = bytearray(bytes((24, 24, 28)) * side * side)
    points = [(round(x * side / len(heights)), round(side * (0.75 - 0.3 * h))) for x, h in enumerate(heights)]
    for one, other in zip(points, points[1:]):
        line(picture, side, side, one, other, (200, 200, 200))
    for (x, y), color in list(zip(points, colors))[4::7]:
        leaning = [2 * c / 255 - 1 for c in color]
        line(picture, side, side, (x, y), (x + 38 * leaning[0], y - 38 * leaning[2]), color)
    write_rgb(path, side, side, bytes(picture))
    return path


def draw_colors(kit, path):
    parts = [MAPS / "dents_height.png", MAPS / "dents_normal.png", write_section(kit.folder / "section.png", 200), DENTS]
    kit.sheet(path, [parts], 200, 200, below=[["heights: bump, dent", "normal map", "section, normals in their colors", "lit from the upper left"]], colors=0)


def inward(kit):
    """A normal map with a round part whose blue is below one half."""
    path, side = kit.folder / "inward.png", 64
    pixels = bytearray()
    for y in range(side):
        for x in range(side):
            is_inside = (x - 31.5) ** 2 + (y - 31.5) ** 2 < 18 ** 2
            pixels += bytes((200, 128, 50) if is_inside else (128, 128, 255))
    write_rgb(path, side, side, bytes(pixels))
    return ("data/maps/wall.obj", "--texture-normal", path, "--bump", "normal", *bumps.LAMP, "--camera-position", "0,0,3.3", "--camera-focal-point", "0,0,0",
            "--camera-view-angle", "36", "--allow-outside")


def measure_blue(kit):
    scene = inward(kit)
    lit = kit.explain(scene, [(0.5, 0.5), (0.5, 0.12)], 180, 180)
    normals = [row["layers"][0]["normal"] for row in lit]
    return {"warnings": sum("into the surface" in line for line in kit.render(scene, 180, 180)[2].splitlines()),
            "normal of the part, component along that of the face": normals[0][2], "normal of the rest, component along that of the face": normals[1][2],
            "light of the part over that of the rest": lit[0]["color"][1] / lit[1]["color"][1]}


def draw_blue(kit, path):
    scene = inward(kit)
    kit.sheet(path, [[kit.folder / "inward.png", scene]], 180, 180, below=[["map, blue 50 in the disc", "what comes of it"]], colors=64)


def measure_frames(kit):
    found = {"leaning frames: pixel vs. world [1/255]": kit.rmse(LEANING, (*LEANING, *FRAMES["pixel"])),
             "orthonormal frames: pixel vs. world [1/255]": kit.rmse(STRAIGHT, (*STRAIGHT, *FRAMES["pixel"]))}
    for name, scene in (("leaning", LEANING), ("faces' own", FACES)):
        found[f"{name} frames: transposed vs. inverse, both at the vertices [1/255]"] = kit.rmse((*scene, *FRAMES["vertex"]), (*scene, *FRAMES["transposed"]))
    found["leaning frames: light at vertices vs. world, pixels that differ [%]"] = kit.differing(LEANING, (*LEANING, *FRAMES["vertex"]))
    return found


def draw_frames(kit, path):
    """The two kinds of frames by the inverse and by the transposed matrix, and eight times how far these differ."""
    rows = []
    for scene in (LEANING, FACES):
        vertex, transposed = ((*scene, *FRAMES[name]) for name in ("vertex", "transposed"))
        rows.append([scene, vertex, transposed, (vertex, transposed, 8)])
    kit.sheet(path, rows, 190, 148, below=[[f"{kind}, {way}" for way in ("world", "inverse", "transposed", "difference x 8")] for kind in ("leaning", "of faces")])


ENTRIES = (
    Entry("s3-fig2-3", "S3 fig. 2, 3", "Normals between the vertices are interpolated, so flat polygons look curved with Phong shading", measure_normals, draw_normals),
    Entry("s3-fig4", "S3 fig. 4", "A texture and a normal map together look uneven", measure_combination, draw_combination),
    Entry("s3-fig5-7", "S3 fig. 5, 6, 7", "Red is x, green is y, blue is z, 128 is 0; dents and bumps have opposite colors on opposite sides", measure_colors, draw_colors),
    Entry("s3-blue", "S3, normal mapping", "Blue below one half would point into the surface and cause artifacts", measure_blue, draw_blue),
    Entry("s3-fig8", "S3 fig. 8, normal mapping", "The inverse of TBN transforms light to tangent space; the transposed matrix is enough where T and B are orthogonal", measure_frames, draw_frames),
)
