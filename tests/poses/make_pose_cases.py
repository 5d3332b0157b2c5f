#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the small glTF models of pose evaluation beside itself, or into a folder: one matter a file, data URIs.

  make_pose_cases.py [FOLDER]

asset.extras of each: "about", what it is for; "deviation", where three.js is known to be off the specification; "invalid", what
the specification forbids in it though files have it; "tolerance", where more than rounding may differ, in sizes of the model. extras of a clip: "times",
where it is to be sampled. The bodies are prisms without any symmetry, so that no turn, mirroring or exchange goes unseen."""
import base64
import json
import math
import pathlib
import struct
import sys

FORMATS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
FLOAT, UBYTE, BYTE, USHORT, SHORT = 5126, 5121, 5120, 5123, 5122
TIMES = [0.0, 0.5, 0.75, 2.0]  # uneven: the tangents of splines are per second
ASKED = [0, 0.25, 0.5, 0.6, 1.0, 1.9, 2, 3]


class Case:
    """A file being made. Each method that adds something returns its index."""

    def __init__(self, name, about, deviation=None, extensions=(), **extras):
        self.name, self.data = name, b""
        self.json = {"asset": {"version": "2.0", "extras": {"about": about, **extras}}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                     "accessors": [], "bufferViews": [], "buffers": []}
        if deviation:
            self.json["asset"]["extras"]["deviation"] = deviation
        if extensions:
            self.json["extensionsUsed"] = list(extensions)

    def add(self, kind, **item):
        self.json.setdefault(kind, []).append(item)
        return len(self.json[kind]) - 1

    def view(self, content, **members):
        self.data += bytes(-len(self.data) % 4)
        index = self.add("bufferViews", buffer=0, byteOffset=len(self.data), byteLength=len(content), **members)
        self.data += content
        return index

    def packed(self, rows, component):
        flat = [value for row in rows for value in (row if isinstance(row, (list, tuple)) else [row])]
        return struct.pack(f"<{len(flat)}{FORMATS[component]}", *flat)

    def limits(self, rows, kind, component):
        """min and max as the file's numbers have them."""
        columns = list(zip(*[struct.unpack(f"<{WIDTHS[kind]}{FORMATS[component]}", self.packed([row], component)) for row in rows]))
        return {"min": [min(column) for column in columns], "max": [max(column) for column in columns]}

    def accessor(self, rows, kind, component=FLOAT, **members):
        limits = self.limits(rows, kind, component) if component == FLOAT and kind in ("SCALAR", "VEC3") else {}
        return self.add("accessors", bufferView=self.view(self.packed(rows, component)), componentType=component, count=len(rows), type=kind,
                        **limits, **members)

    def sparse(self, count, rows, kind="VEC3", base=None, component=FLOAT):
        """An accessor of zeros, or over base, with some rows {index: row} put in; its limits are added where it is a position's."""
        members = {} if base is None else {"bufferView": self.view(self.packed(base, component))}
        at, to = self.view(self.packed(sorted(rows), USHORT)), self.view(self.packed([rows[k] for k in sorted(rows)], component))
        if kind == "VEC3":
            members.update(self.limits([rows.get(k, base[k] if base else (0, 0, 0)) for k in range(count)], kind, component))
        return self.add("accessors", componentType=component, count=count, type=kind, **members,
                        sparse={"count": len(rows), "indices": {"bufferView": at, "componentType": USHORT}, "values": {"bufferView": to}})

    def node(self, root=True, **members):
        index = self.add("nodes", **members)
        if root:
            self.json["scenes"][0]["nodes"].append(index)
        return index

    def clip(self, channels, times=None, name=None):
        """channels: (target, way, key times, rows[, accessor index of the output]); target: (node, path) or a whole target object."""
        animation = {"channels": [], "samplers": []}
        for target, way, keys, rows, *own in channels:
            target = {"node": target[0], "path": target[1]} if isinstance(target, tuple) else target
            kind = {"translation": "VEC3", "scale": "VEC3", "rotation": "VEC4"}.get(target["path"], own[1] if len(own) > 1 else "SCALAR")
            output = own[0] if own and own[0] is not None else self.accessor(rows, kind)
            animation["samplers"].append({"input": self.accessor(keys, "SCALAR"), "output": output, "interpolation": way})
            animation["channels"].append({"sampler": len(animation["samplers"]) - 1, "target": target})
        if times is not None:
            animation["extras"] = {"times": times}
        if name is not None:
            animation["name"] = name
        return self.add("animations", **animation)

    def write(self, folder):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        self.json["buffers"] = [{"byteLength": len(self.data), "uri": uri}]
        (folder / (self.name + ".gltf")).write_text(json.dumps(self.json, separators=(",", ":")) + "\n")


def prism(levels=4):
    """A bent three-sided prism along y, its corners all at different distances: positions, indices."""
    corners, positions, triangles = [(0.5, 0.0), (-0.3, 0.4), (-0.2, -0.45)], [], []
    for level in range(levels):
        positions += [(x * (1 - 0.12 * level) + 0.05 * level * level, 0.9 * level, z * (1 + 0.07 * level)) for x, z in corners]
    for level in range(levels - 1):
        for a in range(3):
            i, j = 3 * level + a, 3 * level + (a + 1) % 3
            triangles += [i, i + 3, j, j, i + 3, j + 3]
    last = 3 * (levels - 1)
    return positions, triangles + [0, 1, 2, last, last + 2, last + 1]


def unit(row):
    length = math.sqrt(sum(value * value for value in row))
    return tuple(value / length for value in row)


def turn(axis, degrees):
    half, axis = math.radians(degrees) / 2, unit(axis)
    return (*(value * math.sin(half) for value in axis), math.cos(half))


def opposite(row):
    return tuple(-value for value in row)


def body(case, levels=4, targets=(), mode=None, **attributes):
    """A mesh of the prism. attributes: accessors by name; targets: accessors by name, one object each."""
    positions, triangles = prism(levels)
    primitive = {"attributes": {"POSITION": case.accessor(positions, "VEC3"), **attributes}}
    if mode is None:
        primitive["indices"] = case.accessor(triangles, "SCALAR", USHORT)
    else:
        primitive["mode"] = mode
    if targets:
        primitive["targets"] = list(targets)
    return primitive


def mesh(case, *primitives, **members):
    return case.add("meshes", primitives=list(primitives), **members)


def bend(case, kind, levels=4):
    """The displacements of a morph target: VEC3 accessor."""
    rows = [((0.3 * y, -0.1 * x, 0.2 * z) if kind == 0 else (-0.2 * z, 0.15 * y * y, 0.4 * x) if kind == 1 else (0.1 * y * z, 0.3, -0.2 * y))
            for x, y, z in prism(levels)[0]]
    return case.accessor(rows, "VEC3")


def cubic(points, slopes):
    """In-tangent, value, out-tangent of each key; the two tangents differ."""
    return [row for point, slope in zip(points, slopes) for row in (slope, point, tuple(0.8 * value - 0.1 for value in slope))]


def keyed():
    """Each animated property by each interpolation, on uneven keys."""
    rows = {"translation": [(0, 0, 0), (1, 0.5, -0.25), (-0.5, 2, 0), (0.25, 0, 3)], "scale": [(1, 1, 1), (2, 0.5, 1.5), (-1, 1, 0.25), (1, 3, 1)],
            "rotation": [turn((1, 2, 3), 10), turn((1, 0, 0), 80), turn((0, 1, 0.5), -60), turn((0.2, 0.1, 1), 150)],
            "weights": [0, 0.2, 1, 0, -0.5, 1.5, 0.25, 0.75]}
    for path, points in rows.items():
        for way in ("STEP", "LINEAR", "CUBICSPLINE"):
            case = Case(f"{path}_{way.lower().replace('cubicspline', 'cubic')}", f"{path} by {way}, times at, between, and after the keys")
            targets = [{"POSITION": bend(case, 0)}, {"POSITION": bend(case, 1)}] if path == "weights" else []
            node = case.node(mesh=mesh(case, body(case, targets=targets)), translation=[1, 2, 3], rotation=turn((0, 0, 1), 30), scale=[1, 2, 0.5])
            if way != "CUBICSPLINE":
                values = points
            elif path == "weights":
                values = [value for k in range(4) for value in (0.5, -1, points[2 * k], points[2 * k + 1], 1.5, 0.25 * k)]
            else:
                values = cubic(points, [tuple(0.6 * math.sin(3 * k + i) for i in range(len(points[0]))) for k in range(4)])
            case.clip([((node, path), way, TIMES, values)], ASKED)
            yield case


def one_turn(name, about, turns, way="LINEAR", deviation=None, asked=(0, 0.25, 0.4, 0.5, 0.9, 1), output=None, **extras):
    case = Case(name, about, deviation, **extras)
    node = case.node(mesh=mesh(case, body(case)))
    keys = [k / (len(turns) - 1) for k in range(len(turns))]
    values = cubic(turns, [(0.0, 0.0, 0.0, 0.0)] * len(turns)) if way == "CUBICSPLINE" else turns
    own = [case.accessor([[round(value * output[1]) for value in row] for row in values], "VEC4", output[0], normalized=True)] if output else []
    case.clip([((node, "rotation"), way, keys, values, *own)], list(asked))
    return case


def turns():
    near = turn((1, 1, 0), 20)
    yield one_turn("rotation_flipped_sign", "the second key is the negative of its like: the short way is taken", [near, opposite(turn((1, 1, 0), 50)), turn((1, 1, 0), 90)])
    yield one_turn("rotation_flipped_sign_cubic", "splines do not look at signs: the long way, normalized", [near, opposite(turn((1, 1, 0.5), 50))], "CUBICSPLINE")
    yield one_turn("rotation_near_identical", "1e-4 degrees apart, then the same key twice, then its negative", [near, turn((1, 1, 0), 20.0001), turn((1, 1, 0), 20.0001), opposite(turn((1, 1, 0), 20.0001))])
    yield one_turn("rotation_small_angle", "3 degrees apart: the arc, or a normalized chord, within 1e-6", [near, turn((1, 1, 0), 23)])
    yield one_turn("rotation_half_turn", "180 degrees apart, dot product exactly 0: by the signs as they are", [(0, 0, 0, 1), (0, 0, 1, 0), (0, 0, 0, 1)])
    yield one_turn("rotation_beyond_half_turn", "200 degrees apart: the short way is 160 degrees back", [(0, 0, 0, 1), turn((0, 1, 0), 200)])
    yield one_turn("rotation_opposite_step", "the negative of a rotation is that rotation", [near, opposite(near)], "STEP")
    yield one_turn("rotation_short", "keys as normalized shorts, of length 1 within 1e-4", [near, turn((0, 1, 0), 140), turn((1, 0, 2), -100)], output=(SHORT, 32767), tolerance=1e-4,
                   deviation="three.js does not normalize quaternions that came from integers: they scale the body by up to 5e-5")
    yield one_turn("rotation_byte", "keys as normalized bytes, exact ones", [(0, 0, 0, 1), (0, 0, 1, 0), (-1, 0, 0, 0)], output=(BYTE, 127))


def clips():
    """Where keys begin, how many there are, what other clips and scenes do."""
    moves = [(1, 0, 0), (0, 2, 0), (0, 0, 3)]
    late = Case("times_begin_late", "keys from 1.5 s on: before them the first one holds; a second channel begins at 0")
    node = late.node(mesh=mesh(late, body(late)))
    late.clip([((node, "translation"), "LINEAR", [1.5, 2, 3], moves), ((node, "rotation"), "LINEAR", [0, 4], [(0, 0, 0, 1), turn((0, 1, 0), 90)])], [0, 1, 1.5, 1.75, 3.5, 4, 9])
    late.clip([((node, "scale"), "CUBICSPLINE", [1.5, 2, 3], cubic([(1, 1, 1), (2, 1, 1), (1, 3, 1)], [(5, 5, 5)] * 3)), ((node, "translation"), "STEP", [1.5, 2, 3], moves)], [0, 1, 1.5, 1.75, 2, 3, 9])
    yield late

    single = Case("single_key", "one key holds at all times, by each interpolation; the clip of one key at 0 has no duration", invalid="CUBICSPLINE of one key")
    node = single.node(mesh=mesh(single, body(single)), translation=[9, 9, 9])
    for way in ("STEP", "LINEAR", "CUBICSPLINE"):
        for at in (0, 1):
            single.clip([((node, "translation"), way, [at], cubic([moves[1]], [moves[0]]) if way == "CUBICSPLINE" else moves[1:2])], [0, 1, 2], f"{way} {at}")
    yield single

    outside = Case("no_keys_in_range", "asked before the first key and after the last only: ends hold")
    node = outside.node(mesh=mesh(outside, body(outside)))
    outside.clip([((node, "rotation"), "LINEAR", [10, 11, 12], [turn((1, 0, 0), d) for d in (15, 70, -40)])], [0, 5, 20])
    yield outside

    several = Case("several_clips", "what a clip does not reach stays at rest, whatever another clip did before; a clip without a mesh below it; an empty target")
    first = several.node(mesh=mesh(several, body(several)), translation=[0.5, 0, 0])
    second = several.node(mesh=0, translation=[3, 0, 0], rotation=turn((0, 1, 0), 45))
    alone = several.node(translation=[1, 1, 1])
    several.clip([((first, "translation"), "LINEAR", [0, 1], [(0, 0, 0), (0, 5, 0)])], [0, 0.5, 1], "same name")
    several.clip([((second, "scale"), "LINEAR", [0, 1], [(1, 1, 1), (1, 2, 3)])], [0, 0.5, 1], "same name")
    several.clip([((alone, "translation"), "LINEAR", [0, 1], moves[:2])], [0.5], "")
    several.clip([((first, "rotation"), "STEP", [0, 1, 2], [turn((1, 0, 0), d) for d in (0, 90, 45)]), ((first, "scale"), "LINEAR", [0, 2], [(1, 1, 1), (2, 2, 2)]),
                  ((second, "translation"), "CUBICSPLINE", [0, 2], cubic(moves[:2], [(1, 2, 3)] * 2))], [0, 0.99, 1, 1.5, 2])
    yield several

    names = Case("names", "names alike, empty, and with characters that mean something elsewhere: channels go by the index")
    same = mesh(names, body(names), name="a.b")
    all_names = ["a.b", "a.b", "a b", "a_b", "[0]", "x/y:z", "", "position", "a.b"]
    made = [names.node(mesh=same, name=name, translation=[2 * k, 0, 0]) for k, name in enumerate(all_names)]
    names.clip([((node, "scale"), "LINEAR", [0, 1], [(1, 1, 1), (1 + 0.25 * k, 1, 1 - 0.05 * k)]) for k, node in enumerate(made)], [0, 0.5, 1])
    yield names

    scenes = Case("two_scenes", "the default scene is the second; the clip moves nodes of both")
    first = scenes.node(mesh=mesh(scenes, body(scenes)))
    second = scenes.node(False, mesh=0, translation=[0, 1, 0])
    scenes.json["scenes"].append({"nodes": [second]})
    scenes.json["scene"] = 1
    scenes.clip([((first, "translation"), "LINEAR", [0, 1], moves[:2]), ((second, "translation"), "LINEAR", [0, 1], moves[1:])], [0, 0.5, 1])
    yield scenes

    sparse = Case("sparse_keys", "key times and values of a channel from sparse accessors")
    node = sparse.node(mesh=mesh(sparse, body(sparse)))
    times = sparse.sparse(4, {1: 0.5, 3: 2.0}, "SCALAR", [0, 0.1, 1.0, 1.1])
    sparse.json["accessors"][times].update(min=[0], max=[2])
    values = sparse.sparse(4, {1: (1, 2, 3), 2: (0, -1, 0)})
    sparse.json["animations"] = [{"channels": [{"sampler": 0, "target": {"node": node, "path": "translation"}}], "samplers": [{"input": times, "output": values}], "extras": {"times": ASKED}}]
    yield sparse


def hierarchy():
    chain = Case("deep_chain", "nine nodes below one another, each turned, scaled and moved by its clip; shear arises")
    last = None
    for k in range(9):
        node = chain.node(last is None, translation=[0, 1, 0.1 * k], mesh=mesh(chain, body(chain)) if not k else 0)
        if last is not None:
            chain.json["nodes"][last]["children"] = [node]
        last = node
    chain.clip([((k, "rotation"), "LINEAR", [0, 1], [turn((1, k, 0.5), 0), turn((1, k, 0.5), 35)]) for k in range(9)]
               + [((k, "scale"), "LINEAR", [0, 1], [(1, 1, 1), (1.2, 0.8, 1)]) for k in range(0, 9, 2)], [0, 0.3, 0.7, 1])
    yield chain

    mirrored = Case("negative_scale", "mirroring parents: one by its scale, one by a matrix, one by a clip through 0; turned children")
    shape = mesh(mirrored, body(mirrored))
    for k, members in enumerate(({"scale": [-1, 1, 1]}, {"matrix": [0, 0, 2, 0, 0, -1, 0, 0, 1.5, 0, 0, 0, 1, 2, 3, 1]}, {"scale": [1, 1, 1]})):
        child = mirrored.node(False, mesh=shape, translation=[4 * k, 0, 1])
        mirrored.node(mesh=shape, children=[child], **members)
    mirrored.clip([((k, "rotation"), "LINEAR", [0, 1], [(0, 0, 0, 1), turn((1, 1, 0), 120)]) for k in (0, 2, 4)]
                  + [((5, "scale"), "LINEAR", [0, 1], [(1, 1, 1), (1, -1, -2)])], [0, 0.25, 0.5, 0.8, 1])
    yield mirrored

    seen = Case("camera_and_light", "the parent of a camera and a light, and a camera itself, are moved: world matrices of all nodes", extensions=["KHR_lights_punctual"])
    seen.json["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {}}]}}
    seen.add("cameras", type="perspective", perspective={"yfov": 0.8, "znear": 0.1})
    camera, light = seen.node(False, camera=0, translation=[0, 0, 5]), seen.node(False, extensions={"KHR_lights_punctual": {"light": 0}}, rotation=turn((1, 0, 0), -60))
    arm = seen.node(children=[camera, light], translation=[0, 1, 0])
    free = seen.node(camera=0, rotation=turn((0, 1, 0), 20))
    seen.node(mesh=mesh(seen, body(seen)))
    seen.clip([((arm, "rotation"), "LINEAR", [0, 1, 2], [turn((0, 1, 0), d) for d in (0, 120, 240)]), ((arm, "scale"), "LINEAR", [0, 2], [(1, 1, 1), (2, 2, 2)]),
               ((light, "translation"), "STEP", [0, 1], [(0, 0, 0), (1, 2, 3)]), ((free, "translation"), "CUBICSPLINE", [0, 2], cubic([(0, 0, 0), (5, 5, 5)], [(1, 0, 0)] * 2))], [0, 0.5, 1, 1.7, 2])
    yield seen

    pointer = Case("animation_pointer", "KHR_animation_pointer onto translation, rotation and weights of nodes and the weights of a mesh, beside an ordinary channel",
                   "three.js itself does not know KHR_animation_pointer: these channels move nothing", ["KHR_animation_pointer"])
    shape = mesh(pointer, body(pointer, targets=[{"POSITION": bend(pointer, 0)}, {"POSITION": bend(pointer, 1)}]), weights=[0.1, 0.2])
    first, second = pointer.node(mesh=shape, weights=[0.3, 0]), pointer.node(mesh=shape, translation=[4, 0, 0])
    to = [{"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": path}}}
          for path in (f"/nodes/{first}/translation", f"/nodes/{first}/rotation", f"/nodes/{first}/weights", "/meshes/0/weights")]
    pointer.clip([(to[0], "LINEAR", [0, 1], [(0, 0, 0), (1, 2, 3)], None, "VEC3"), (to[1], "LINEAR", [0, 1], [turn((0, 0, 1), 10), opposite(turn((0, 0, 1), 100))], None, "VEC4"),
                  (to[2], "LINEAR", [0, 1], [0, 1, 1, 0]), (to[3], "STEP", [0, 1], [0.5, 0, 0, 0.5]), ((second, "scale"), "LINEAR", [0, 1], [(1, 1, 1), (1, 2, 1)])], [0, 0.5, 1])
    yield pointer


def main():
    from make_pose_cases_skins import morphs, skins
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent
    for group in (keyed, turns, clips, hierarchy, morphs, skins):
        for case in group():
            case.write(folder)


if __name__ == "__main__":
    main()
