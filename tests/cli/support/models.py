# SPDX-License-Identifier: Apache-2.0
"""Models and pictures that the tests of the program make: GLB files, grids of many triangles, large PNG files. Standard library only."""
import json
import struct
import zlib

TRIANGLE = struct.pack("<9f", -0.4, -0.4, 0, 0.4, -0.4, 0, 0, 0.4, 0)


def write_glb(path, gltf, binary):
    gltf = {"asset": {"version": "2.0"}, **gltf, "buffers": [{"byteLength": len(binary)}]}
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(binary)))
        file.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
        file.write(struct.pack("<II", len(binary), 0x004E4942))
        file.write(binary)


def triangle_gltf(nodes, **more):
    """One triangle about the origin as mesh 0, in single precision, placed by the nodes."""
    return {"scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-0.4, -0.4, 0], "max": [0.4, 0.4, 0]}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}], **more}


def write_grid(path, side):
    """One object of 2 * side^2 triangles over the square from -1 to 1, in ridges of 0.01 m."""
    n = side + 1
    row = bytearray(12 * n)
    for x in range(n):
        struct.pack_into("<f", row, 12 * x, x / side * 2 - 1)
    data = bytearray()
    for y in range(n):
        for part, value in ((4, y / side * 2 - 1), (8, 0.01 * (y % 2))):
            number = struct.pack("<f", value)
            for k in range(4):
                row[part + k::12] = number[k:k + 1] * n
        data += row
    vertex_bytes = len(data)
    # A row's indices are those of the first with the same number added to each: one sum of long integers.
    first = int.from_bytes(b"".join(struct.pack("<6I", x, x + 1, n + x + 1, x, n + x + 1, n + x) for x in range(side)), "little")
    ones = int.from_bytes(b"\1\0\0\0" * (6 * side), "little")
    for y in range(side):
        data += (first + ones * (y * n)).to_bytes(24 * side, "little")
    write_glb(path, {"scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                     "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
                     "accessors": [{"bufferView": 0, "componentType": 5126, "count": n * n, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0.02]},
                                   {"bufferView": 1, "componentType": 5125, "count": 6 * side * side, "type": "SCALAR"}],
                     "bufferViews": [{"buffer": 0, "byteLength": vertex_bytes},
                                     {"buffer": 0, "byteOffset": vertex_bytes, "byteLength": len(data) - vertex_bytes}]}, bytes(data))


def write_quarters(path, side):
    """A PNG of side x side pixels whose quarters are red, green (above), blue and white (below)."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    half, pack, body = side // 2, zlib.compressobj(1), b""
    for y in range(side):
        colors = (b"\xff\0\0", b"\0\xff\0") if y < half else (b"\0\0\xff", b"\xff\xff\xff")
        body += pack.compress(b"\0" + colors[0] * half + colors[1] * half)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", body + pack.flush()) + chunk(b"IEND", b""))
