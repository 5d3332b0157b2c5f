# SPDX-License-Identifier: Apache-2.0
"""Reads EXR files as the OpenEXR file layout says, apart from any library: scan lines, one part, ZIP or no compression."""
import struct
import zlib

FORMATS = {0: "I", 1: "e", 2: "f"}  # UINT, HALF, FLOAT


def text(data, at):
    end = data.index(0, at)
    return data[at:end].decode(), end + 1


def header_of(data):
    """({attribute: bytes}, where the table of blocks begins)"""
    flags = struct.unpack_from("<I", data, 4)[0]  # version 2; bit 10: names may be long, which changes nothing else
    assert data[:4] == b"\x76\x2f\x31\x01" and flags & ~0x400 == 2
    at, attributes = 8, {}
    while data[at]:
        name, at = text(data, at)
        _, at = text(data, at)
        size = struct.unpack_from("<I", data, at)[0]
        attributes[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def channels_of(value):
    """[(name, format letter)] in the order of the file"""
    at, channels = 0, []
    while value[at]:
        name, at = text(value, at)
        channels.append((name, FORMATS[struct.unpack_from("<I", value, at)[0]]))
        at += 16
    return channels


def unpacked(block, size):
    """ZIP: halves of the bytes taken apart, differences, deflate. A block that did not shrink is stored."""
    if len(block) == size:
        return block
    data = bytearray(zlib.decompress(block))
    for i in range(1, len(data)):
        data[i] = (data[i - 1] + data[i] - 128) & 255
    out = bytearray(size)
    out[0::2], out[1::2] = data[:(size + 1) // 2], data[(size + 1) // 2:]
    return bytes(out)


def windows(path):
    """(data window, display window), each (x0, y0, x1, y1), the last pixels included"""
    header, _ = header_of(path.read_bytes())
    return tuple(struct.unpack("<4i", header[name]) for name in ("dataWindow", "displayWindow"))


def read(path):
    """(width, height, {channel: (format letter, rows of numbers)})"""
    data = path.read_bytes()
    header, at = header_of(data)
    x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    lines = {0: 1, 2: 1, 3: 16}[header["compression"][0]]
    channels = channels_of(header["channels"])
    row_bytes = sum(struct.calcsize(kind) for _, kind in channels) * width
    result = {name: (kind, []) for name, kind in channels}
    for place in struct.unpack_from(f"<{-(-height // lines)}Q", data, at):
        y, size = struct.unpack_from("<ii", data, place)
        rows = min(lines, y1 - y + 1)
        block, offset = unpacked(data[place + 8:place + 8 + size], rows * row_bytes), 0
        for _ in range(rows):
            for name, kind in channels:
                result[name][1].append(struct.unpack_from(f"<{width}{kind}", block, offset))
                offset += width * struct.calcsize(kind)
    return width, height, result
