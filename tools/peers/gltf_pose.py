#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Where the vertices of a glTF model stand in a pose, by the words of the glTF 2.0 specification, in double precision.

An evaluation of its own, slow and short, to check other ones: node transforms, clips (section 3.11 and appendix C), morph targets (3.7.2.2),
skins with any number of joints (3.7.3). Reads .gltf and .glb; Draco and meshopt data it does not unpack (Unsupported). Needs numpy."""
import base64
import json
import pathlib
import struct
import urllib.parse

import numpy

COMPONENTS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
REST = {"translation": (0, 0, 0), "rotation": (0, 0, 0, 1), "scale": (1, 1, 1)}
PACKED = {"EXT_meshopt_compression", "KHR_meshopt_compression"}


class Unsupported(Exception):
    """Data that this evaluation does not unpack."""


class Model:
    """The JSON of a file, its buffers, and accessors as arrays [count, width] of doubles."""

    def __init__(self, path):
        content = pathlib.Path(path).read_bytes()
        self.folder, self.chunk = pathlib.Path(path).parent, b""
        if content[:4] == b"glTF":
            length = struct.unpack_from("<I", content, 12)[0]
            self.chunk, content = content[28 + length:], content[20:20 + length]
        self.json = json.loads(content)
        self.nodes, self.meshes = self.json.get("nodes", []), self.json.get("meshes", [])
        self.buffers, self.arrays = {}, {}

    def buffer(self, index):
        if index not in self.buffers:
            uri = self.json["buffers"][index].get("uri")
            if uri is None:
                self.buffers[index] = self.chunk
            elif uri.startswith("data:"):
                self.buffers[index] = base64.b64decode(uri.partition(",")[2])
            else:
                self.buffers[index] = (self.folder / urllib.parse.unquote(uri)).read_bytes()
        return self.buffers[index]

    def view(self, index, offset, kind, count, width):
        """[count, width] raw components of a buffer view."""
        view = self.json["bufferViews"][index]
        if PACKED & set(view.get("extensions", {})):
            raise Unsupported("meshopt")
        size = numpy.dtype(kind).itemsize * width
        start = view.get("byteOffset", 0) + offset
        return numpy.ndarray((count, width), kind, self.buffer(view["buffer"]), start,
                             (view.get("byteStride") or size, numpy.dtype(kind).itemsize)).copy()

    def accessor(self, index):
        if index in self.arrays:
            return self.arrays[index]
        source = self.json["accessors"][index]
        kind, width, count = COMPONENTS[source["componentType"]], WIDTHS[source["type"]], source["count"]
        raw = numpy.zeros((count, width), kind)
        if "bufferView" in source:
            raw = self.view(source["bufferView"], source.get("byteOffset", 0), kind, count, width)
        if sparse := source.get("sparse"):
            at, to = sparse["indices"], sparse["values"]
            rows = self.view(at["bufferView"], at.get("byteOffset", 0), COMPONENTS[at["componentType"]], sparse["count"], 1)[:, 0]
            raw[rows] = self.view(to["bufferView"], to.get("byteOffset", 0), kind, sparse["count"], width)
        values = raw.astype(float)
        if source.get("normalized"):  # section 3.6.2.2
            values = numpy.maximum(values / numpy.iinfo(raw.dtype).max, -1)
        self.arrays[index] = values
        return values


def slerp(a, b, t):
    """Appendix C.4, with the angle from the chord so that it holds for near-identical quaternions too."""
    if a @ b < 0:
        b = -b
    angle = 2 * numpy.arctan2(numpy.linalg.norm(a - b), numpy.linalg.norm(a + b))
    if angle < 1e-9:
        return a + (b - a) * t
    return (numpy.sin(angle * (1 - t)) * a + numpy.sin(angle * t) * b) / numpy.sin(angle)


def sampled(model, sampler, rotation, time):
    """The value of a sampler at a time: one row, for morph weights all targets' one after the other."""
    times = model.accessor(sampler["input"])[:, 0]
    way = sampler.get("interpolation", "LINEAR")
    cubic = way == "CUBICSPLINE"
    values = model.accessor(sampler["output"]).reshape(len(times), 3 if cubic else 1, -1)
    point = values[:, 1 if cubic else 0]
    if time <= times[0]:
        return point[0]
    if time >= times[-1]:
        return point[-1]
    k = int(numpy.searchsorted(times, time, "right")) - 1
    length = times[k + 1] - times[k]
    t = (time - times[k]) / length
    if way == "STEP":
        return point[k]
    if not cubic:
        return slerp(point[k], point[k + 1], t) if rotation else point[k] + (point[k + 1] - point[k]) * t
    return ((2 * t**3 - 3 * t**2 + 1) * point[k] + length * (t**3 - 2 * t**2 + t) * values[k, 2]
            + (3 * t**2 - 2 * t**3) * point[k + 1] + length * (t**3 - t**2) * values[k + 1, 0])


def target_of(channel):
    """(node, property) or ("mesh N", "weights") of a channel; None where it moves nothing that stands somewhere."""
    target = channel["target"]
    pointer = target.get("extensions", {}).get("KHR_animation_pointer", {}).get("pointer")
    if pointer is None:
        return (target["node"], target["path"]) if "node" in target else None
    parts = pointer.strip("/").split("/")
    if len(parts) == 3 and parts[0] == "nodes" and parts[2] in (*REST, "weights"):
        return int(parts[1]), parts[2]
    return (f"mesh {parts[1]}", "weights") if parts[0] == "meshes" and parts[2:] == ["weights"] else None


def matrix_of(move, turn, stretch):
    x, y, z, w = numpy.asarray(turn, float) / numpy.linalg.norm(turn)
    result = numpy.eye(4)
    result[:3, :3] = numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                                  [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                                  [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]) * numpy.asarray(stretch, float)
    result[:3, 3] = move
    return result


class Pose:
    """The model at rest, or at a time of one of its clips; what the clip does not reach stays at rest."""

    def __init__(self, model, clip=None, time=0.0):
        self.model, self.moved, self.world = model, {}, {}
        if clip is not None:
            animation = model.json["animations"][clip]
            for channel in animation["channels"]:
                if place := target_of(channel):
                    self.moved[place] = sampled(model, animation["samplers"][channel["sampler"]], place[1] == "rotation", time)
        parent = {child: index for index, node in enumerate(model.nodes) for child in node.get("children", [])}
        for index in range(len(model.nodes)):
            self.place(index, parent)

    def place(self, index, parent):
        if index not in self.world:
            own = self.local(index)
            self.world[index] = self.place(parent[index], parent) @ own if index in parent else own
        return self.world[index]

    def local(self, index):
        node = self.model.nodes[index]
        if "matrix" in node:
            return numpy.array(node["matrix"], float).reshape(4, 4).T
        return matrix_of(*(self.moved.get((index, path), node.get(path, REST[path])) for path in REST))

    def weights(self, index, targets):
        """Of the clip, else of the node, else of the clip's mesh, else of the mesh, else 0."""
        node = self.model.nodes[index]
        mesh = self.moved.get((f"mesh {node['mesh']}", "weights"), self.model.meshes[node["mesh"]].get("weights", [0] * targets))
        return self.moved.get((index, "weights"), node.get("weights", mesh))

    def morphed(self, index, primitive, name):
        base = self.model.accessor(primitive["attributes"][name])
        targets = primitive.get("targets", [])
        for weight, target in zip(self.weights(index, len(targets)), targets):
            if name in target:
                base = base + weight * self.model.accessor(target[name])
        return base

    def vertex_matrices(self, index, primitive, strongest):
        """[vertices, 4, 4] from object space to the world, or one for all."""
        node = self.model.nodes[index]
        attributes = primitive["attributes"]
        if "skin" not in node or "JOINTS_0" not in attributes:
            return self.world[index][None]
        skin = self.model.json["skins"][node["skin"]]
        joints = numpy.array([self.world[joint] for joint in skin["joints"]])
        if "inverseBindMatrices" in skin:
            inverse = self.model.accessor(skin["inverseBindMatrices"])[:len(joints)]
            joints = joints @ inverse.reshape(-1, 4, 4).transpose(0, 2, 1)
        sets = [name[7:] for name in attributes if name.startswith("JOINTS_")]
        at = numpy.hstack([self.model.accessor(attributes["JOINTS_" + number]) for number in sets]).astype(int)
        weights = numpy.hstack([self.model.accessor(attributes["WEIGHTS_" + number]) for number in sets])
        if strongest:
            order = numpy.argsort(-weights, axis=1, kind="stable")[:, :strongest]
            at, weights = numpy.take_along_axis(at, order, 1), numpy.take_along_axis(weights, order, 1)
        return numpy.einsum("vk,vkij->vij", weights, joints[at])

    def positions(self, index, primitive, strongest=None):
        """[vertices, 3] in the world. Weights that do not sum to 1 make a fourth coordinate: it is divided by.

        :param strongest: only so many joints of a vertex, those of the greatest weight, count"""
        primitive = self.model.meshes[self.model.nodes[index]["mesh"]]["primitives"][primitive]
        if "KHR_draco_mesh_compression" in primitive.get("extensions", {}):
            raise Unsupported("draco")
        base = self.morphed(index, primitive, "POSITION")
        points = numpy.einsum("vij,vj->vi", numpy.broadcast_to(matrices := self.vertex_matrices(index, primitive, strongest),
                                                               (len(base), *matrices.shape[1:])), numpy.c_[base, numpy.ones(len(base))])
        return points[:, :3] / points[:, 3:]

    def normals(self, index, primitive):
        """[vertices, 3] unit normals in the world, by the inverse transpose; None without normals or where a matrix is flat."""
        primitive = self.model.meshes[self.model.nodes[index]["mesh"]]["primitives"][primitive]
        if "NORMAL" not in primitive["attributes"]:
            return None
        base = self.morphed(index, primitive, "NORMAL")
        linear = self.vertex_matrices(index, primitive, None)[:, :3, :3]
        if (abs(numpy.linalg.det(linear)) < 1e-12).any():
            return None
        turned = numpy.einsum("vji,vj->vi", numpy.broadcast_to(numpy.linalg.inv(linear), (len(base), 3, 3)), base)
        return turned / numpy.linalg.norm(turned, axis=1, keepdims=True)
