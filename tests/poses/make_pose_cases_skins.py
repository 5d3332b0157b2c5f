# SPDX-License-Identifier: Apache-2.0
"""The cases of make_pose_cases.py with morph targets and with skins."""
import math

from make_pose_cases import BYTE, FLOAT, SHORT, UBYTE, USHORT, Case, bend, body, mesh, prism, turn

DEGREES = (0, 25, -40)


def morphs():
    def targets(case, count=2):
        return [{"POSITION": bend(case, k)} for k in range(count)]

    shaded = Case("morph_normals_tangents", "targets with normals and tangents; the second without normals, the third without positions",
                  "three.js takes the base positions for the displacements of a target without POSITION")
    rows = prism()[0]
    normal = shaded.accessor([tuple(v / math.hypot(x, 1, z) for v in (x, 1, z)) for x, _, z in rows], "VEC3")
    tangent = shaded.accessor([(1, 0, 0, 1 if k % 2 else -1) for k in range(len(rows))], "VEC4")
    lean = shaded.accessor([(0.2 * y, -0.1, 0.3 * x) for x, y, _ in rows], "VEC3")
    node = shaded.node(mesh=mesh(shaded, body(shaded, NORMAL=normal, TANGENT=tangent, targets=[
        {"POSITION": bend(shaded, 0), "NORMAL": lean, "TANGENT": lean}, {"POSITION": bend(shaded, 1), "TANGENT": lean}, {"NORMAL": lean}])), rotation=turn((0, 0, 1), 20), scale=[1, 1, -2])
    shaded.clip([((node, "weights"), "LINEAR", [0, 1], [0, 0, 0.5, 1, 0.5, 1])], [0, 0.5, 1])
    yield shaded

    whole = Case("morph_normals", "targets with positions and normals, under a mirroring, uneven scale")
    normal = whole.accessor([tuple(v / math.hypot(x, 1, z) for v in (x, 1, z)) for x, _, z in rows], "VEC3")
    lean = whole.accessor([(0.2 * y, -0.1, 0.3 * x) for x, y, _ in rows], "VEC3")
    node = whole.node(mesh=mesh(whole, body(whole, NORMAL=normal, targets=[{"POSITION": bend(whole, k), "NORMAL": lean} for k in range(2)])), rotation=turn((0, 0, 1), 20), scale=[1, 1, -2])
    whole.clip([((node, "weights"), "LINEAR", [0, 1], [0, 0, 1, 0.5])], [0, 0.5, 1])
    yield whole

    sparse = Case("morph_sparse", "sparse targets: over nothing, over a base array, and of all zeros")
    count = len(rows)
    base = [(0.1, 0.2, 0.01 * k) for k in range(count)]
    zeros = sparse.add("accessors", componentType=FLOAT, count=count, type="VEC3", min=[0, 0, 0], max=[0, 0, 0])
    node = sparse.node(mesh=mesh(sparse, body(sparse, targets=[{"POSITION": sparse.sparse(count, {1: (1, 2, 3), 7: (-1, 0, 0.5), 11: (0, 0, 4)})},
                                                               {"POSITION": sparse.sparse(count, {0: (0, 5, 0), 10: (2, 0, 0)}, base=base)}, {"POSITION": zeros}]), weights=[0.5, 0.25, 1]))
    sparse.clip([((node, "weights"), "LINEAR", [0, 1], [0, 0, 0, 1, 1, 1])], [0, 0.3, 1])
    yield sparse

    default = Case("morph_node_weights", "one mesh with default weights: as they are, overridden by a node, animated; rest after the clip")
    shape = mesh(default, body(default, targets=targets(default)), weights=[0.6, -0.3])
    default.node(mesh=shape)
    default.node(mesh=shape, weights=[0, 1], translation=[4, 0, 0])
    moved = default.node(mesh=shape, translation=[8, 0, 0])
    both = default.node(mesh=shape, weights=[1, 1], translation=[12, 0, 0])
    default.clip([((moved, "weights"), "LINEAR", [0, 1], [0, 0, 1, 0.5])], [0, 0.5, 1])
    default.clip([((both, "weights"), "STEP", [0, 1], [0, 0.25, 0.75, 1])], [0, 0.5, 1])
    yield default

    parts = Case("morph_two_primitives", "a mesh of two primitives and one set of weights; many targets")
    shape = mesh(parts, body(parts, targets=targets(parts, 3) * 3), body(parts, 3, targets=[{"POSITION": bend(parts, k % 3, 3)} for k in range(9)]), weights=[0.1] * 9)
    node = parts.node(mesh=shape)
    parts.clip([((node, "weights"), "LINEAR", [0, 1, 2], [0.1 * ((5 * k) % 7 - 2) for k in range(27)])], [0, 0.4, 1, 1.5, 2])
    yield parts

    small = Case("weights_byte", "morph weights as normalized bytes, positions of targets as they are")
    node = small.node(mesh=mesh(small, body(small, targets=targets(small))))
    small.clip([((node, "weights"), "LINEAR", [0, 1], [], small.accessor([0, 255, 128, 51], "SCALAR", UBYTE, normalized=True))], [0, 0.5, 1])
    yield small

    grid = Case("morph_quantized", "KHR_mesh_quantization: positions as shorts, displacements as normalized bytes, the node brings the size", extensions=["KHR_mesh_quantization"])
    grid.json["extensionsRequired"] = ["KHR_mesh_quantization"]
    positions, triangles = prism()
    view = grid.view(b"".join(grid.packed([[round(1000 * v) for v in row] + [0]], SHORT) for row in positions), byteStride=8)
    codes = [[round(1000 * v) for v in row] for row in positions]
    whole = grid.add("accessors", bufferView=view, componentType=SHORT, count=count, type="VEC3", **grid.limits(codes, "VEC3", SHORT))
    steps = [[100 - 17 * k, -127, 11 * k - 60] for k in range(count)]
    view = grid.view(b"".join(grid.packed([row + [0]], BYTE) for row in steps), byteStride=4)
    less = grid.add("accessors", bufferView=view, componentType=BYTE, count=count, type="VEC3", normalized=True, **grid.limits(steps, "VEC3", BYTE))
    node = grid.node(mesh=mesh(grid, {"attributes": {"POSITION": whole}, "indices": grid.accessor(triangles, "SCALAR", USHORT), "targets": [{"POSITION": less}]}), scale=[0.001, 0.001, 0.001])
    grid.clip([((node, "weights"), "LINEAR", [0, 1], [0, 500])], [0, 0.5, 1])
    yield grid


def identity(x=0.0, y=0.0, z=0.0):
    return (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1)


def shares(count, joints):
    """Weights of each vertex over a row of joints, most along the prism."""
    rows = []
    for vertex in range(count):
        along = (vertex // 3) / (count // 3 - 1) * (joints - 1)
        row = [max(0.0, 1 - abs(joint - along) / 1.5) + 0.01 * (vertex % 3) * (abs(joint - along) < 1.4) for joint in range(joints)]
        rows.append([value / sum(row) for value in row])
    return rows


def weighted(rows, sets, scale=1.0):
    """JOINTS_n and WEIGHTS_n rows of vertices with weights over all joints: {"JOINTS_0": ...}."""
    out = {}
    for index in range(sets):
        out[f"JOINTS_{index}"] = [[at if at < len(row) and row[at] > 0 else 0 for at in range(4 * index, 4 * index + 4)] for row in rows]
        out[f"WEIGHTS_{index}"] = [[row[at] * scale if at < len(row) else 0 for at in range(4 * index, 4 * index + 4)] for row in rows]
    return out


def attributes(case, rows, joint_type=UBYTE, weight_type=FLOAT):
    most = {UBYTE: 255, USHORT: 65535}.get(weight_type)
    out = {}
    for name, values in rows.items():
        if name.startswith("JOINTS"):
            out[name] = case.accessor(values, "VEC4", joint_type)
        elif most:
            codes = [[round(most * v) for v in row] for row in values]
            for row in codes:
                row[row.index(max(row))] += most - sum(row)
            out[name] = case.accessor(codes, "VEC4", weight_type, normalized=True)
        else:
            out[name] = case.accessor(values, "VEC4")
    return out


def skeleton(case, joints, spacing, bound=True, root=True, **members):
    """A chain of joints along y; (skin index, joint nodes)."""
    nodes = []
    for k in range(joints):
        nodes.append(case.node(root and not k, **({"translation": [0, spacing, 0]} if k else members)))
        if k:
            case.json["nodes"][nodes[-2]]["children"] = [nodes[-1]]
    more = {"inverseBindMatrices": case.accessor([identity(0, -k * spacing, 0) for k in range(joints)], "MAT4")} if bound else {}
    return case.add("skins", joints=nodes, **more), nodes


def swing(nodes, axis=(1, 0.3, 0.2), step=1.0):
    return [((node, "rotation"), "LINEAR", [0, 1, 2], [turn(axis, step * d * (1 + 0.2 * k)) for d in DEGREES]) for k, node in enumerate(nodes)]


def plain(name, about, deviation=None, joints=4, sets=1, scale=1.0, types=(UBYTE, FLOAT), mode=None, bound=True, node=None, root=None, extra=None, **extras):
    """The prism on a chain of joints, which swings."""
    case = Case(name, about, deviation, **extras)
    spacing = 2.7 / (joints - 1)
    skin, nodes = skeleton(case, joints, spacing, bound, **(root or {}))
    rows = weighted(shares(12, joints), sets, scale)
    shape = mesh(case, body(case, mode=mode, **attributes(case, rows, *types)))
    own = case.node(mesh=shape, skin=skin, **(node or {}))
    case.clip(swing(nodes) + (extra(own, nodes) if extra else []), [0, 0.37, 1, 1.6, 2])
    return case


def joints_of_many():
    yield plain("skin", "four joints, weights as floats")
    yield plain("skin_weights_ubyte", "weights as normalized bytes that sum to 255", types=(UBYTE, UBYTE))
    case = Case("skin_weights_ubyte_254", "weights as normalized bytes that sum to 254", "three.js scales byte weights to 1 and rounds them to bytes again",
                invalid="weights that do not sum to 1")
    skin, nodes = skeleton(case, 4, 0.9)
    case.node(skin=skin, mesh=mesh(case, body(case, JOINTS_0=case.accessor([[0, 1, 2 * (k > 5), 3 * (k > 5)] for k in range(12)], "VEC4", UBYTE),
                                              WEIGHTS_0=case.accessor([[20 * k + 7, 247 - 20 * k, 0, 0] if k < 6 else [1, 100 - 2 * k, 100, 53 + 2 * k] for k in range(12)], "VEC4", UBYTE, normalized=True))))
    case.clip(swing(nodes), [0, 0.37, 1, 1.6, 2])
    yield case
    yield plain("skin_joints_ushort", "joints as shorts, weights as normalized shorts", types=(USHORT, USHORT))
    yield plain("skin_8_joints", "eight joints in JOINTS_0 and JOINTS_1, at most four of a vertex count",
                "three.js drops JOINTS_1 and WEIGHTS_1 and scales what is left to 1", joints=8, sets=2)
    for count in (8, 12):
        case = Case(f"skin_{count}_joints_all", f"all {count} joints of each vertex count, none as much as another",
                    "three.js drops JOINTS_1 and WEIGHTS_1 and scales what is left to 1")
        skin, nodes = skeleton(case, count, 2.7 / (count - 1))
        rows = [[1 + (3 * vertex + 5 * joint) % count for joint in range(count)] for vertex in range(12)]
        rows = [[value / sum(row) for value in row] for row in rows]
        case.node(mesh=mesh(case, body(case, **attributes(case, weighted(rows, count // 4)))), skin=skin)
        case.clip(swing(nodes), [0, 0.37, 1, 1.6, 2])
        yield case
    case = Case("skin_same_joint_twice", "a joint that comes twice in a vertex' four, and zero weights on other joints", invalid="a joint twice in a vertex")
    skin, nodes = skeleton(case, 4, 0.9)
    case.node(skin=skin, mesh=mesh(case, body(case, JOINTS_0=case.accessor([[k % 4, k % 4, 3, 0] for k in range(12)], "VEC4", UBYTE),
                                              WEIGHTS_0=case.accessor([[0.25, 0.5, 0.25, 0] for _ in range(12)], "VEC4"))))
    case.clip(swing(nodes), [0, 0.37, 1, 1.6, 2])
    yield case
    yield plain("skin_weights_not_normalized", "weights sum to 0.5: divided by their sum, as the fourth coordinate of the specification's matrix is", scale=0.5,
                invalid="weights that do not sum to 1")


def skins():
    yield from joints_of_many()
    yield plain("skin_moving_root_and_mesh_node", "the skeleton's root is moved, and so is the node of the mesh, which does not count", root={"translation": [1, 0, 0]},
                node={"translation": [5, 6, 7], "scale": [2, 2, 2]},
                extra=lambda own, nodes: [((own, "translation"), "LINEAR", [0, 2], [(9, 9, 9), (-9, 0, 0)]), ((nodes[0], "translation"), "LINEAR", [0, 2], [(0, 0, 0), (3, 1, 0)])])
    yield plain("skin_flat_mesh_node", "the node of the mesh is scaled to 0, which does not count", "three.js goes there and back through the node's own matrix: all is at 0",
                node={"scale": [0, 0, 0]})
    yield plain("skin_negative_scale_joint", "a joint mirrors, another is stretched by its clip through 0",
                extra=lambda own, nodes: [((nodes[1], "scale"), "LINEAR", [0, 2], [(-1, 1, 1), (-1, 2, 0.5)]), ((nodes[2], "scale"), "LINEAR", [0, 2], [(1, 1, 1), (1, -1, 1)])])
    yield plain("skin_no_inverse_bind", "without inverse bind matrices: identities", bound=False)
    yield plain("skin_points", "points on a skeleton", "three.js does not skin points and lines", mode=0)
    yield plain("skin_line_strip", "a strip of lines on a skeleton", "three.js does not skin points and lines", mode=3)
    yield from shared()


def shared():
    case = Case("skin_shared", "two nodes share a skin, one of them below a moved parent; two meshes")
    skin, nodes = skeleton(case, 4, 0.9)
    rows = attributes(case, weighted(shares(12, 4), 1))
    first, second = mesh(case, body(case, **rows)), mesh(case, body(case, **{name: rows[name] for name in rows}))
    low = case.node(False, mesh=second, skin=skin, translation=[1, 1, 1])
    case.node(mesh=first, skin=skin)
    case.node(children=[low], translation=[0, 0, 7], scale=[1, 3, 1])
    case.clip(swing(nodes), [0, 0.37, 1, 2])
    yield case

    case = Case("skin_one_mesh_two_skins", "one mesh on two skeletons that swing apart, and inverse bind matrices that differ")
    rows = attributes(case, weighted(shares(12, 4), 1))
    shape = mesh(case, body(case, **rows))
    (one, first), (two, second) = skeleton(case, 4, 0.9), skeleton(case, 4, 1.1, translation=[4, 0, 0])
    case.node(mesh=shape, skin=one)
    case.node(mesh=shape, skin=two)
    case.clip(swing(first) + swing(second, (0, 1, 1), -1.5), [0, 0.37, 1, 2])
    yield case

    case = Case("skin_and_plain", "one mesh, with a skin and without: its joints do not count without",
                "three.js makes a skinned mesh without a skeleton of the second: no position comes")
    skin, nodes = skeleton(case, 4, 0.9)
    shape = mesh(case, body(case, **attributes(case, weighted(shares(12, 4), 1))))
    case.node(mesh=shape, skin=skin)
    case.node(mesh=shape, translation=[4, 0, 0])
    case.clip(swing(nodes), [0, 1])
    yield case

    case = Case("skin_morph", "targets first, then joints; two primitives, one of them on a joint alone; the mesh hangs on a joint")
    skin, nodes = skeleton(case, 4, 0.9)
    rows = attributes(case, weighted(shares(12, 4), 1))
    alone = {"JOINTS_0": case.accessor([[2, 0, 0, 0]] * 9, "VEC4", UBYTE), "WEIGHTS_0": case.accessor([[1, 0, 0, 0]] * 9, "VEC4")}
    shape = mesh(case, body(case, targets=[{"POSITION": bend(case, k)} for k in range(2)], **rows),
                 body(case, 3, targets=[{"POSITION": bend(case, k, 3)} for k in range(2)], **alone), weights=[0.5, 0])
    own = case.node(False, mesh=shape, skin=skin)
    case.json["nodes"][nodes[-1]]["children"] = [own]
    case.clip(swing(nodes) + [((own, "weights"), "CUBICSPLINE", [0, 2], [0, 0, 0, 0.5, 1, 0, 0, 1, 1, 0, 0, 0])], [0, 0.37, 1, 2])
    yield case

    case = Case("skin_scattered_joints", "joints in another order than their nodes, a node between them that is no joint, and a skeleton property below the moved root")
    parent = case.node(translation=[1, 0, 2], rotation=turn((0, 1, 0), 30))
    skin, nodes = skeleton(case, 5, 0.7, root=False)
    case.json["nodes"][parent]["children"] = [nodes[0]]
    order = [nodes[4], nodes[1], nodes[0], nodes[3]]
    case.json["skins"][skin].update(joints=order, skeleton=nodes[0], inverseBindMatrices=case.accessor([identity(0, -0.7 * nodes.index(node), 0) for node in order], "MAT4"))
    case.node(mesh=mesh(case, body(case, **attributes(case, weighted(shares(12, 4), 1)))), skin=skin)
    case.clip(swing(nodes) + [((parent, "translation"), "LINEAR", [0, 2], [(0, 0, 0), (0, -4, 0)])], [0, 0.37, 1, 2])
    yield case

    case = Case("skin_quantized", "KHR_mesh_quantization: positions as normalized shorts, the inverse bind matrices bring the size", extensions=["KHR_mesh_quantization"])
    case.json["extensionsRequired"] = ["KHR_mesh_quantization"]
    skin, nodes = skeleton(case, 4, 0.9)
    size = 3.0
    case.json["skins"][skin]["inverseBindMatrices"] = case.accessor([(size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0, 0, -0.9 * k, 0, 1) for k in range(4)], "MAT4")
    positions, triangles = prism()
    codes = [[round(32767 * v / size) for v in row] for row in positions]
    view = case.view(b"".join(case.packed([row + [0]], SHORT) for row in codes), byteStride=8)
    whole = case.add("accessors", bufferView=view, componentType=SHORT, count=12, type="VEC3", normalized=True, **case.limits(codes, "VEC3", SHORT))
    rows = attributes(case, weighted(shares(12, 4), 1), UBYTE, UBYTE)
    case.node(skin=skin, mesh=mesh(case, {"attributes": {"POSITION": whole, **rows}, "indices": case.accessor(triangles, "SCALAR", USHORT)}))
    case.clip(swing(nodes), [0, 0.37, 1, 1.6, 2])
    yield case
