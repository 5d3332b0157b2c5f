# SPDX-License-Identifier: Apache-2.0
"""8-bit PNG in and out with the standard library alone, for the tests and the small tools beside."""
import collections
import itertools
import struct
import zlib


def read_pixels(path):
    """(width, height, channels, bytes of rows) of an 8-bit PNG without palette and interlace."""
    with open(path, "rb") as file:
        blob = file.read()
    at, data, header = 8, b"", None
    while at < len(blob):
        size, kind = struct.unpack(">I4s", blob[at:at + 8])
        chunk = blob[at + 8:at + 8 + size]
        at += 12 + size
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", chunk)
        elif kind == b"IDAT":
            data += chunk
    width, height, depth, color, _, _, interlace = header
    if depth != 8 or color == 3 or interlace:
        raise ValueError(f"{path}: want 8 bits without palette and interlace")
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[color]
    raw, stride = zlib.decompress(data), width * channels
    previous, rows = bytearray(stride), []
    for y in range(height):
        start = y * (stride + 1)
        row = bytearray(raw[start + 1:start + 1 + stride])
        unfilter(raw[start], row, previous, channels)
        rows.append(bytes(row))
        previous = row
    return width, height, channels, b"".join(rows)


def read_rgb(path):
    """(width, height, bytes of RGB rows); alpha is dropped."""
    width, height, channels, pixels = read_pixels(path)
    if channels < 3:
        raise ValueError(f"{path}: want RGB or RGBA")
    if channels == 4:
        rgb = bytearray(width * height * 3)
        for c in range(3):
            rgb[c::3] = pixels[c::4]
        pixels = bytes(rgb)
    return width, height, pixels


def unfilter(kind, row, above, channels):
    """Undoes the row filters of the PNG specification (section 9), each in a loop of its own: pictures are large."""
    if kind == 1:
        for c in range(channels):
            row[c::channels] = bytes(v & 255 for v in itertools.accumulate(row[c::channels]))
    elif kind == 2:
        row[:] = bytes((v + b) & 255 for v, b in zip(row, above))
    elif kind == 3:
        for x, b in enumerate(above):
            row[x] = (row[x] + ((row[x - channels] if x >= channels else 0) + b) // 2) & 255
    elif kind == 4:
        for c in range(channels):
            row[c::channels] = bytes(paeth(row[c::channels], above[c::channels]))


def paeth(row, above):
    left = corner = 0
    for v, up in zip(row, above):
        a, b, c = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
        left = (v + (left if a <= b and a <= c else up if b <= c else corner)) & 255
        corner = up
        yield left


def write_rgb(path, width, height, pixels):
    write_pixels(path, width, height, 3, pixels)


def palette_of(counts, most):
    """{color: its place in a palette of at most so many colors}, the palette: by cutting the set with the widest component,
    weighed by its pixels, at the middle of those (Heckbert 1982, "Color image quantization for frame buffer display")."""
    def spread(box):
        return max((max(c[k] for c in box) - min(c[k] for c in box), k) for k in range(3))
    boxes = [sorted(counts)]
    widest = [spread(boxes[0])]
    while len(boxes) < most and max(widest)[0] > 0:
        i = max(range(len(boxes)), key=lambda j: widest[j][0] * sum(counts[c] for c in boxes[j]) ** 0.5)
        box = sorted(boxes[i], key=lambda c: c[widest[i][1]])
        half, passed, cut = sum(counts[c] for c in box) / 2, 0, 1
        for cut in range(1, len(box)):
            passed += counts[box[cut - 1]]
            if passed >= half:
                break
        boxes[i:i + 1] = [box[:cut], box[cut:]]
        widest[i:i + 1] = [spread(box[:cut]), spread(box[cut:])]
    mean = [bytes(round(sum(c[k] * counts[c] for c in box) / sum(counts[c] for c in box)) for k in range(3)) for box in boxes]
    return {c: i for i, box in enumerate(boxes) for c in box}, mean


def write_indexed(path, width, height, pixels, most=256):
    """RGB rows as a picture of at most so many colors: a third of the size, for sheets of few hues."""
    cells = [pixels[i:i + 3] for i in range(0, len(pixels), 3)]
    place, palette = palette_of(collections.Counter(cells), most)
    rows = b"".join(b"\0" + bytes(place[c] for c in cells[width * y:width * (y + 1)]) for y in range(height))
    write_chunks(path, struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0), rows, chunk(b"PLTE", b"".join(palette)))


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def write_chunks(path, header, rows, between=b""):
    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + between + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def filtered(row, previous, step):
    """The row by each filter of the PNG specification (section 9), with the filter's number before it."""
    left = bytes(step) + row[:-step]
    corner = bytes(step) + previous[:-step]
    yield b"\0" + row
    yield b"\1" + bytes((a - b) & 255 for a, b in zip(row, left))
    yield b"\2" + bytes((a - b) & 255 for a, b in zip(row, previous))
    yield b"\3" + bytes((a - (b + c) // 2) & 255 for a, b, c in zip(row, left, previous))
    yield b"\4" + bytes((a - nearest_of(b, c, d)) & 255 for a, b, c, d in zip(row, left, previous, corner))


def nearest_of(left, up, corner):
    """Paeth's predictor."""
    a, b, c = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
    return left if a <= b and a <= c else up if b <= c else corner


def write_pixels(path, width, height, channels, pixels):
    """channels: 3 RGB or 4 RGBA. Each row by the filter that leaves the smallest numbers, or all by one: what is smaller."""
    rows, previous, stride = [], bytes(width * channels), width * channels
    for y in range(height):
        row = pixels[y * stride:(y + 1) * stride]
        rows.append(list(filtered(row, previous, channels)))
        previous = row
    small = [min(ways, key=lambda way: sum(min(b, 256 - b) for b in way[1:])) for ways in rows]
    choices = [b"".join(small)] + [b"".join(ways[k] for ways in rows) for k in range(5)]
    best = min(choices, key=lambda data: len(zlib.compress(data, 9)))
    write_chunks(path, struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 6, 0, 0, 0), best)
