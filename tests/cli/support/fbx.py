# SPDX-License-Identifier: Apache-2.0
"""FBX files of version 7.4 and 7.5 that tests make, as text and binary (with packed and plain arrays). Standard library only."""
import math
import struct
import zlib


class Id(int):
    """64 bits in binary files."""


class Array:
    def __init__(self, kind, values):
        self.kind, self.values = kind, values


def node(name, *properties, children=()):
    return name, properties, children


def as_text(tree, depth=0):
    lines, pad = [], "\t" * depth
    for name, properties, children in tree:
        if len(properties) == 1 and isinstance(properties[0], Array):
            a = properties[0]
            lines.append(f"{pad}{name}: *{len(a.values)} {{\n{pad}\ta: {','.join(repr(v) for v in a.values)}\n{pad}}}")
            continue
        words = ", ".join('"' + p + '"' if isinstance(p, str) else repr(float(p)) if isinstance(p, float) else str(int(p)) for p in properties)
        lines.append(f"{pad}{name}: {words}" + (" {\n" + as_text(children, depth + 1) + pad + "}" if children else ""))
    return "\n".join(lines) + "\n"


def binary_property(p, is_packed):
    if isinstance(p, Array):
        data = struct.pack(f"<{len(p.values)}{p.kind}", *p.values)
        packed = zlib.compress(data) if is_packed else data
        return p.kind.encode() + struct.pack("<III", len(p.values), int(is_packed), len(packed)) + packed
    if isinstance(p, str):
        words = p.split("::")
        text = (words[1] + "\0\1" + words[0]).encode() if len(words) == 2 else p.encode()
        return b"S" + struct.pack("<I", len(text)) + text
    return b"D" + struct.pack("<d", p) if isinstance(p, float) else b"L" + struct.pack("<q", p) if isinstance(p, Id) else b"I" + struct.pack("<i", p)


def binary_nodes(tree, at, is_packed, word):
    out, header = b"", 3 * struct.calcsize("<" + word) + 1
    for name, properties, children in tree:
        body = b"".join(binary_property(p, is_packed) for p in properties)
        begin = at + len(out) + header + len(name) + len(body)
        inside = binary_nodes(children, begin, is_packed, word) + b"\0" * header if children else b""
        out += struct.pack(f"<3{word}B", begin + len(inside), len(properties), len(body), len(name)) + name.encode() + body + inside
    return out


def write(path, tree, form="text"):
    """@param form  "text", "plain" or "packed" (binary), "wide" (binary 7.5, packed)"""
    if form == "text":
        path.write_text("; FBX 7.4.0 project file\n" + as_text(tree))
        return
    word, version = ("Q", 7500) if form == "wide" else ("I", 7400)
    nodes = binary_nodes(tree, 27, form != "plain", word)
    path.write_bytes(b"Kaydara FBX Binary  \0\x1a\0" + struct.pack("<I", version) + nodes + b"\0" * (3 * struct.calcsize("<" + word) + 1 + 160))


def barrel(smoothing, mapping="ByPolygon", edges=None, materials=None, sides=12, normals=None):
    """The side of a prism of radius 1 and height 2 about +Z, one quad a side, without normals."""
    points = [x for z in (0.0, 2.0) for i in range(sides) for x in (math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides), z)]
    corners = [c for i in range(sides) for c in (i, (i + 1) % sides, sides + (i + 1) % sides, -1 - (sides + i))]
    layer = [node("Version", 102), node("Name", ""), node("MappingInformationType", mapping), node("ReferenceInformationType", "Direct"),
             node("Smoothing", Array("i", smoothing))]
    materials = materials or [0] * sides
    elements = ["LayerElementSmoothing", "LayerElementMaterial"]
    inside = [node("Vertices", Array("d", points)), node("PolygonVertexIndex", Array("i", corners))]
    inside += [node("Edges", Array("i", edges))] if edges else []
    inside += [node("GeometryVersion", 124), node("LayerElementSmoothing", 0, children=layer)]
    inside += [node("LayerElementMaterial", 0, children=[node("Version", 101), node("Name", ""), node("MappingInformationType", "ByPolygon"),
                                                         node("ReferenceInformationType", "IndexToDirect"), node("Materials", Array("i", materials))])]
    if normals:
        elements.append("LayerElementNormal")
        inside.append(node("LayerElementNormal", 0, children=[node("Version", 101), node("Name", ""), node("MappingInformationType", "ByPolygonVertex"),
                                                              node("ReferenceInformationType", "Direct"), node("Normals", Array("d", normals))]))
    inside.append(node("Layer", 0, children=[node("Version", 100)] + [node("LayerElement", children=[node("Type", e), node("TypedIndex", 0)]) for e in elements]))
    p = lambda name, kind, label, value: node("P", name, kind, label, "", value)  # noqa: E731
    axes = [p(n, "int", "Integer", v) for n, v in (("UpAxis", 1), ("UpAxisSign", 1), ("FrontAxis", 2), ("FrontAxisSign", 1), ("CoordAxis", 0), ("CoordAxisSign", 1))]
    settings = node("GlobalSettings", children=[node("Version", 1000), node("Properties70", children=axes + [p("UnitScaleFactor", "double", "Number", 100.0)])])
    objects = [node("Geometry", Id(1000), "Geometry::g", "Mesh", children=inside), node("Model", Id(2000), "Model::barrel", "Mesh", children=[node("Version", 232)])]
    links = [node("C", "OO", Id(2000), Id(0)), node("C", "OO", Id(1000), Id(2000))]
    for m in sorted(set(materials)):
        objects.append(node("Material", Id(3000 + m), f"Material::m{m}", "", children=[node("Version", 102), node("ShadingModel", "phong")]))
        links.append(node("C", "OO", Id(3000 + m), Id(2000)))
    return [node("FBXHeaderExtension", children=[node("FBXHeaderVersion", 1003), node("FBXVersion", 7400)]), settings,
            node("Objects", children=objects), node("Connections", children=links)]
