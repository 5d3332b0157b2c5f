#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""An independent PNG decoder for the test of ours: the standard library's zlib and the PNG specification, nothing else.

Prints one line a picture: name, width, height, channels, bits, FNV-1a 64 of the samples (rows from the top, components
interleaved, 16-bit ones with the high byte first). Palettes are resolved, tRNS becomes an alpha channel, gray of fewer than
8 bits is spread over 0..255.

    python3 tests/support/png_reference.py ../shared/assets/textures/pngsuite/*.png > tests/unit/io/pictures/pngsuite_expected.txt
"""
import os
import struct
import sys
import zlib

CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
PASSES = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)]


def chunks(data):
    at = 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + 8 + length]
        at += length + 12


def unfilter(kind, line, above, bpp):
    out = bytearray(line)
    for i in range(len(out)):
        a = out[i - bpp] if i >= bpp else 0
        b = above[i]
        c = above[i - bpp] if i >= bpp else 0
        if kind == 1:
            out[i] = (out[i] + a) & 255
        elif kind == 2:
            out[i] = (out[i] + b) & 255
        elif kind == 3:
            out[i] = (out[i] + (a + b) // 2) & 255
        elif kind == 4:
            p = a + b - c
            pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
            out[i] = (out[i] + (a if pa <= pb and pa <= pc else b if pb <= pc else c)) & 255
    return out


def samples_of(line, count, depth):
    if depth == 16:
        return list(struct.unpack(">%dH" % count, bytes(line[:2 * count])))
    return [line[i * depth // 8] >> (8 - depth - i * depth % 8) & ((1 << depth) - 1) for i in range(count)]


def decode(data):
    parts = list(chunks(data))
    width, height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", parts[0][1])
    palette = b"".join(body for kind, body in parts if kind == b"PLTE")
    trns = b"".join(body for kind, body in parts if kind == b"tRNS")
    raw = zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT"))
    n = CHANNELS[color]
    picture = [[None] * width for _ in range(height)]
    at = 0
    for x0, y0, dx, dy in PASSES if interlace else [(0, 0, 1, 1)]:
        w, h = (width - x0 + dx - 1) // dx, (height - y0 + dy - 1) // dy
        if w == 0 or h == 0:
            continue
        size = (w * n * depth + 7) // 8
        above = bytearray(size)
        for row in range(h):
            above = unfilter(raw[at], raw[at + 1:at + 1 + size], above, max(1, n * depth // 8))
            at += 1 + size
            values = samples_of(above, w * n, depth)
            for i in range(w):
                picture[y0 + row * dy][x0 + i * dx] = tuple(values[i * n:i * n + n])
    return width, height, depth, color, palette, trns, picture


def resolve(depth, color, palette, trns, pixel):
    top = 65535 if depth == 16 else 255
    if color == 3:
        index = pixel[0]
        rgb = tuple(palette[3 * index:3 * index + 3])
        return rgb + ((trns[index] if index < len(trns) else 255),) if trns else rgb
    scale = 255 // ((1 << depth) - 1) if depth < 8 else 1
    result = tuple(v * scale for v in pixel)
    if trns and color in (0, 2):
        key = struct.unpack(">%dH" % (len(trns) // 2), trns)
        result += (0 if key == pixel else top,)
    return result


def main():
    for path in sys.argv[1:]:
        with open(path, "rb") as file:
            width, height, depth, color, palette, trns, picture = decode(file.read())
        code, channels = 0xCBF29CE484222325, 0
        for row in picture:
            for pixel in row:
                values = resolve(depth, color, palette, trns, pixel)
                channels = len(values)
                for byte in struct.pack(">%dH" % channels, *values) if depth == 16 else bytes(values):
                    code = (code ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
        print(os.path.basename(path), width, height, channels, 16 if depth == 16 else 8, "%016x" % code)


main()
