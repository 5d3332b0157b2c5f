# SPDX-License-Identifier: Apache-2.0
"""Small GLB files of which posing asks for much: targets, weights and joints, times the nodes that show them."""
import json
import struct

U16, F32 = 5123, 5126


class File:
    """Accessors over one buffer, and the tree around them."""

    def __init__(self):
        self.data = b""
        self.tree = {"asset": {"version": "2.0"}, "scene": 0, "accessors": [], "bufferViews": []}

    def accessor(self, values, shape, kind=F32, **more):
        packed = struct.pack(f"<{len(values)}{'H' if kind == U16 else 'f'}", *values)
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}[shape]
        self.tree["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(packed)})
        self.tree["accessors"].append({"bufferView": len(self.tree["bufferViews"]) - 1, "componentType": kind, "count": len(values) // width, "type": shape, **more})
        self.data += packed + b"\0" * (-len(packed) % 4)
        return len(self.tree["accessors"]) - 1

    def triangle(self):
        return self.accessor([0, 0, 0, 1, 0, 0, 0, 1, 0], "VEC3", min=[0, 0, 0], max=[1, 1, 0])

    def write(self, path, nodes, **tree):
        self.tree |= {"nodes": nodes, "scenes": [{"nodes": list(range(len(nodes)))}], "buffers": [{"byteLength": len(self.data)}], **tree}
        text = json.dumps(self.tree, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        path.write_bytes(b"glTF" + struct.pack("<III", 2, 28 + len(text) + len(self.data), len(text)) + b"JSON" + text + struct.pack("<I", len(self.data)) + b"BIN\0" + self.data)


def targets(path, nodes, count, step=2, own_weights=False, is_animated=False, has_normals=False):
    """One mesh with `count` targets that `nodes` nodes show `step` beside one another; in half of its targets a corner moves.

    own_weights: each node has a list of its own; is_animated: a clip has a channel for each, all of the same keys."""
    file = File()
    mesh = {"attributes": {"POSITION": file.triangle()}}
    moved, turned = (file.accessor([0, 0, z, 0, 0, 1, 0, 0, z], "VEC3") for z in (1, 0))
    if has_normals:
        mesh["attributes"]["NORMAL"] = file.accessor([0, 0, 1] * 3, "VEC3")
        mesh |= {"targets": [{"POSITION": turned if t % 2 else moved, "NORMAL": moved} for t in range(count)]}
    else:
        mesh |= {"targets": [{"POSITION": turned if t % 2 else moved} for t in range(count)]}
    shown = [{"mesh": 0, "translation": [step * n, 0, 0]} | ({"weights": [(n + t) % 9 / 8 for t in range(count)]} if own_weights else {}) for n in range(nodes)]
    more = {}
    if is_animated:
        sampler = {"input": file.accessor([0, 1], "SCALAR", min=[0], max=[1]), "output": file.accessor([0] * count + [1] * count, "SCALAR")}
        more = {"animations": [{"samplers": [sampler], "channels": [{"sampler": 0, "target": {"node": n, "path": "weights"}} for n in range(nodes)]}]}
    file.write(path, shown, meshes=[{"weights": [0.5] * count, "primitives": [mesh]}], **more)


def instances(path, count):
    """A triangle that EXT_mesh_gpu_instancing shows `count` times, at zeros that no byte of the file holds."""
    file = File()
    mesh = {"primitives": [{"attributes": {"POSITION": file.triangle()}}]}
    file.tree["accessors"].append({"componentType": F32, "count": count, "type": "VEC3"})
    file.write(path, [{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 1}}}}], meshes=[mesh], extensionsUsed=["EXT_mesh_gpu_instancing"])


def skins(path, count, joints, are_different=False):
    """As many nodes as skins, each of one joint over and over again; are_different: no two skins are alike."""
    file = File()
    corner = {"POSITION": file.triangle(), "JOINTS_0": file.accessor([0, 1, 0, 0] * 3, "VEC4", U16), "WEIGHTS_0": file.accessor([0.5, 0.5, 0, 0] * 3, "VEC4")}
    table = [{"joints": [s % 2 if are_different else 0] * (joints - 1) + [s // 2 % 2]} for s in range(count)]
    if are_different:
        for s, skin in enumerate(table):
            skin["joints"][: count.bit_length()] = [s >> bit & 1 for bit in range(count.bit_length())]
    file.write(path, [{}, {"translation": [0, 1, 0]}] + [{"mesh": 0, "skin": s} for s in range(count)], skins=table, meshes=[{"primitives": [{"attributes": corner}]}])
