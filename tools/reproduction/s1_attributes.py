# SPDX-License-Identifier: Apache-2.0
"""First source: the printed routine, Gram-Schmidt, handedness, tangents that do not agree. Its frames are worked out in published.py, too."""
import math

import bump_pictures as bumps
from png8 import write_rgb

from . import published
from .kit import Entry, angle, cross

VIEW = ("--bump", "normal", "--light", "point:0.5,0.6,1.4:attenuation=0.6,0.2,0.2", "--light", "ambient:0.1,0.1,0.1", "--camera-position", "0.7,0.5,3.4",
        "--camera-focal-point", "0,0,0", "--camera-view-angle", "38", "--allow-outside")
HILLS = (*VIEW, "--texture-normal", "data/maps/brick_normal.png")
PUBLISHED = ("--normals", "model", "--crease-angle", "180", "--weight", "uniform", "--tangents", "published")
OFF, SHADER = ("--orthogonalize", "off"), ("--orthogonalize", "shader")
PLACES = [(0.35 + 0.03 * i, 0.35 + 0.03 * j) for i in range(11) for j in range(11)]


def model_of(kit, name, frames, model=None, view=HILLS):
    """Arguments of the hills, or another model, with frames of our own."""
    path = kit.folder / f"{name}.gltf"
    if not path.exists():
        published.write_gltf(path, model or published.hills(), frames)
    return (path, *view)


def averaged(kit):
    """The hills with averaged frames as they are, and with Gram-Schmidt once, at the vertices."""
    frames = published.averaged(published.hills())
    return (model_of(kit, "leaning", [(n, t, 1) for n, t, _ in frames]), model_of(kit, "once", [(n, published.orthogonal(n, t), 1) for n, t, _ in frames]))


def layers(kit, scene):
    return [row["layers"][0] for row in kit.explain(scene, PLACES)]


def farthest(one, other, what):
    return max(angle(a[what], b[what]) for a, b in zip(one, other))


def measure_routine(kit):
    """Frames of the engine beside those of the printed routine, at pixels."""
    scene = (published.write_obj(kit.folder / "hills.obj", published.hills()), *HILLS, *PUBLISHED)
    leaning, once = averaged(kit)
    ours, theirs = layers(kit, (*scene, *OFF)), layers(kit, (*leaning, *OFF))
    return {"sampled pixels": len(ours), "normals of both: difference [degrees]": farthest(ours, theirs, "normal_interpolated"), "tangents of both: difference [degrees]": farthest(ours, theirs, "tangent"),
            "tangents of both with Gram-Schmidt: difference [degrees]": farthest(layers(kit, scene), layers(kit, once), "tangent"),
            "tangents with Gram-Schmidt vs. those without [degrees]": farthest(layers(kit, scene), ours, "tangent")}


def ways(kit):
    leaning, once = averaged(kit)
    return {"none": (*leaning, *OFF), "at the vertices": (*once, *OFF), "at the pixels": (*leaning, *SHADER), "at both": once}


def measure_gram_schmidt(kit):
    found, shown = {}, ways(kit)
    for name, scene in shown.items():
        found[f"{name}: error of the right angle between normal and tangent [degrees]"] = max(abs(90 - angle(f["normal_interpolated"], f["tangent"])) for f in layers(kit, scene))
    for name in ("none", "at the vertices", "at both"):
        found[f"{name} vs. at the pixels [1/255]"] = kit.rmse(shown[name], shown["at the pixels"])
    found["pixels that differ by more than 10 codes, none vs. at the pixels [%]"] = kit.differing(shown["none"], shown["at the pixels"], codes=10)
    return found


def draw_gram_schmidt(kit, path):
    shown = ways(kit)
    last = shown["at the pixels"]
    kit.sheet(path, [[shown["none"], shown["at the vertices"], last], [(scene, last, 16) for scene in (shown["none"], shown["at the vertices"], last)]], 220, 176,
              below=[["no gram-schmidt", "at the vertices", "at the pixels"], ["difference x 16"] * 3])


def time_gram_schmidt(kit):
    """Shading of the hills, one thread [ns per pixel]: the fastest of five medians of nine, each way in turn."""
    scene, found = published.write_obj(kit.folder / "hills.obj", published.hills()), {}
    for _ in range(5):
        for name, how in (("none", OFF), ("at the pixels", SHADER)):
            row = kit.row("bench", "render", scene, *HILLS, *PUBLISHED, *how, "--look", "plain", "--resolution", "640,480", "--threads", "1", "--frames", "9")
            what = f"{name} [ns per pixel]"
            found[what] = min(found.get(what, 1e9), row["stages_ms"]["shading"] * 1e6 / row["stats"]["pixels_shaded"])
    return found


def mirrored(kit):
    """{way: arguments} of the two squares, the right one mirrored."""
    model = published.read_obj("data/maps/mirrored.obj")
    frames = published.averaged(model)
    own = {"step": [(n, published.turned(n, t, b), 1) for n, t, b in frames], "nostep": [(n, t, 1) for n, t, _ in frames]}
    made = {name: model_of(kit, name, f, model, tuple(w for w in bumps.MIRRORED[1:] if w not in ("--normals", "model"))) for name, f in own.items()}
    color = ("--color", "#aaaaaa", "--allow-outside")
    return {"averaged tangents": (*bumps.MIRRORED, "--tangents", "averaged"), "with the step": (*bumps.MIRRORED, "--tangents", "published"),
            "without it, signs kept": (*bumps.MIRRORED, "--tangents", "published-no-handedness"), "printed shader, step": (*made["step"], *color),
            "printed shader, no step": (*made["nostep"], *color)}


def halves(kit, scene, base, name):
    """[1/255] differences of the left and of the right, mirrored half."""
    w, h = kit.size(600, 300)
    found = []
    for x in (0, w // 2):
        paths = [kit.folder / f"half-{name}-{x}-{k}.png" for k in (0, 1)]
        for arguments, path in zip((scene, base), paths):
            kit.run("render", *arguments, "--look", "plain", "--resolution", f"{w},{h}", "--window", f"{x},0,{w // 2},{h}", "-o", path, "--quiet")
        found.append(kit.rmse(*paths))
    return found


def frame_errors(kit, scene):
    """Wrong signs of tangent and bitangent in the mirrored half: there U goes to the left, V up."""
    frame = kit.explain(scene, [(0.72, 0.42)], 600, 300)[0]["layers"][0]
    bitangent = [frame["handedness"] * x for x in cross(frame["normal_interpolated"], frame["tangent"])]
    return (frame["tangent"][0] > 0) + (bitangent[1] < 0)


def measure_handedness(kit):
    found, shown = {}, mirrored(kit)
    for name in list(shown)[1:3]:
        found[f"{name}: left half [1/255]"], found[f"{name}: mirrored half [1/255]"] = halves(kit, shown[name], shown["averaged tangents"], name[:6])
    for name, scene in shown.items():
        found[f"{name}: axes of the mirrored half that point the wrong way"] = frame_errors(kit, scene)
    return found


def draw_handedness(kit, path):
    shown = mirrored(kit)
    names = ("averaged tangents", "with the step", "printed shader, no step", "without it, signs kept")
    kit.sheet(path, [[shown[n] for n in names[:2]], [shown[n] for n in names[2:]]], 300, 154, below=[list(names[:2]), list(names[2:])])


def turned_frames(model, angles):
    """Frames of the faces, each turned about its normal by an angle of its own [degrees]."""
    found = []
    for k in range(len(model[2])):
        n, t, b = published.of_face(model, model[2][k])
        c, s = math.cos(math.radians(angles[k])), math.sin(math.radians(angles[k]))
        found += [(n, [c * x + s * y for x, y in zip(t, b)], 1)] * 3
    return found


def any_tangents(kit):
    """A flat wall of triangles whose tangents go along U, all another way, each another way; and a map that leans everywhere alike."""
    flat = published.split([[(x, y, 0) for x, y, _ in published.hills(4)[0]], *published.hills(4)[1:]])
    count, slope = len(flat[2]), kit.folder / "slope.png"
    write_rgb(slope, 8, 8, bytes((200, 128, 230)) * 64)
    how = {"along u": [0] * count, "all turned by 50 degrees": [50] * count, "each turned differently": [137 * k % 360 for k in range(count)]}
    return {name: model_of(kit, "any" + name[:5].strip(), turned_frames(flat, angles), flat, VIEW) for name, angles in how.items()}, ("--texture-normal", slope)


def measure_any(kit):
    found = {}
    scenes, slope = any_tangents(kit)
    for name, scene in scenes.items():
        rows = kit.explain((*scene, *slope), PLACES)
        first = rows[0]["layers"][0]["normal"]
        found[f"{name}: largest difference of normals, map of constant tilt [degrees]"] = max(angle(first, row["layers"][0]["normal"]) for row in rows)
    return found


def draw_any(kit, path):
    scenes, slope = any_tangents(kit)
    bricks = ("--texture-normal", "data/maps/brick_normal.png")
    kit.sheet(path, [[(*scene, *more) for scene in scenes.values()] for more in (slope, bricks)], 200, 160, below=[list(scenes)] * 2, colors=0)


def smoothed(kit):
    """The hills with normals smoothed and tangents of the faces, and with both smoothed; no Gram-Schmidt of the tangents of the former, which would not agree either."""
    model = published.split(published.hills())
    faces, both = [published.of_face(model, t) for t in model[2] for _ in range(3)], published.averaged(model)
    return {"normals smoothed": model_of(kit, "normals", [(s[0], published.orthogonal(s[0], f[1]), 1) for s, f in zip(both, faces)], model),
            "tangents smoothed, too": model_of(kit, "all", [(s[0], published.orthogonal(s[0], s[1]), 1) for s in both], model)}


def measure_smoothed(kit):
    """Angle between the tangents of vertices at one place, and what it makes of the picture."""
    found, shown = {}, smoothed(kit)
    for name, scene in shown.items():
        jumps = []
        for x in range(40):  # a row of pixels over the edges between faces
            a, b = (row["layers"][0] for row in kit.explain(scene, [(0.35 + x / 130, 0.5), (0.35 + (x + 0.25) / 130, 0.5)], 480 / kit.scale, 360 / kit.scale))
            jumps.append(angle(a["tangent"], b["tangent"]))
        found[f"{name}: largest rotation of the tangent from pixel to pixel [degrees]"] = max(jumps)
    found["normals alone vs. both [1/255]"] = kit.rmse(*shown.values())
    return found


def draw_smoothed(kit, path):
    one, both = smoothed(kit).values()
    kit.sheet(path, [[one, both, (one, both, 8)]], 220, 176, below=[["normals smoothed only", "tangents, too", "difference x 8"]])


ENTRIES = (
    Entry("s1-routine", "S1 section 5.2", "The printed routine, each vertex against each face, gives the attributes of the engine", measure_routine),
    Entry("s1-fig7", "S1 fig. 7, section 4.2", "Any tangent perpendicular to the normal would do, but those of neighboring faces have to agree", measure_any, draw_any),
    Entry("s1-tangents-smoothed", "S1 section 5.1", "Tangents and bitangents must be smoothed as normals are", measure_smoothed, draw_smoothed),
    Entry("s1-fig13", "S1 fig. 13, section 5.3", "Averaged frames are not orthogonal; Gram-Schmidt repairs them, per vertex or in the shader; the picture hardly changes", measure_gram_schmidt,
          draw_gram_schmidt, time_gram_schmidt),
    Entry("s1-handedness", "S1 section 5.4", "t = -t where dot(cross(n, t), b) < 0 repairs texture coordinates of the wrong orientation", measure_handedness, draw_handedness),
)
