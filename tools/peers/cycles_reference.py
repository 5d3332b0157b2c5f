# SPDX-License-Identifier: Apache-2.0
"""Reference pictures by Blender Cycles, made from the same scenes and options as those of rakelight render. Runs inside Blender 3.4:

  blender -b --factory-startup --python-exit-code 1 --python tools/peers/cycles_reference.py -- SCENE -o OUT.exr [OPTION...]

SCENE is a glTF file, or a world file as those in data/paths: models in OBJ, planes, spheres, metallic-roughness materials, photometric
point lights, an environment, a camera. Anything else in it is refused. Options are a part of those of rakelight render and mean the same.

How Cycles is set, so that both solve one problem:
- plain path tracing: no clamping, denoising, adaptive sampling, light threshold, filter of caustics;
- a pixel is the mean over its square (box filter, 1 px), written as linear half floats without loss;
- --max-depth N is Cycles' "max bounces" N for every kind of bounce: a path is scattered N + 1 times at most, and each scattering is
  lit directly;
- materials are not the importer's: its Principled BSDF has Disney's diffuse term, which glTF has not. Here they are glTF 2.0, appendix B,
  as far as Cycles' nodes can say it: Lambert, GGX without multiple scattering, mixed by metalness; see gltf_surface();
- occlusion maps do nothing, and both sides of a surface are seen."""
import argparse
import math
import pathlib
import struct
import sys
import tomllib

import bpy
import numpy
from mathutils import Euler, Matrix, Vector

TO_BLENDER = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))  # y up -> z up
MATERIAL = {"color", "metallic", "roughness", "specular_factor", "emission", "double_sided", "name"}
SPHERE_SEGMENTS = 512


def numbers(count):
    return lambda text: [float(word) for word in text.split(",", count - 1)]


def key_and_number(text):
    key, _, value = text.partition("=")
    return key, float(value)


def options():
    parser = argparse.ArgumentParser(prog="cycles_reference.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--resolution", type=numbers(2), default=[256, 256], metavar="W,H")
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--max-depth", type=int, default=8)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--threads", type=int, default=0)
    parser.add_argument("--camera-position", type=numbers(3), metavar="X,Y,Z")
    parser.add_argument("--camera-focal-point", type=numbers(3), metavar="X,Y,Z", default=[0, 0, 0])
    parser.add_argument("--camera-view-angle", type=float, metavar="DEG", default=40)
    parser.add_argument("--hdri-file", type=pathlib.Path)
    parser.add_argument("--hdri-intensity", type=float, default=1)
    parser.add_argument("--hdri-rotation", type=float, default=0, metavar="DEG")
    parser.add_argument("--material", type=key_and_number, action="append", default=[], metavar="KEY=VALUE",
                        help="metallic, roughness or specular_factor of all materials")
    parser.add_argument("--bump", choices=("auto", "none"), default="auto")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1:])


# ---- Shader nodes ----------------------------------------------------------------------------------------------------------------

class Nodes:
    """Of one material. A value is a number, a color, or the output of a node."""

    def __init__(self, material):
        self.tree = material.node_tree

    def add(self, kind, **inputs):
        node = self.tree.nodes.new(kind)
        for name, value in inputs.items():
            self.put(node.inputs[name.replace("_", " ")], value)
        return node

    def put(self, socket, value):
        if isinstance(value, bpy.types.NodeSocket):
            self.tree.links.new(value, socket)
        elif value is not None:
            socket.default_value = value

    def math(self, operation, *values):
        node = self.tree.nodes.new("ShaderNodeMath")
        node.operation = operation
        for socket, value in zip(node.inputs, values):
            self.put(socket, value)
        return node.outputs[0]

    def scaled(self, color, factor):
        node = self.tree.nodes.new("ShaderNodeVectorMath")
        node.operation = "SCALE"
        self.put(node.inputs[0], color[:3] if isinstance(color, tuple) else color)
        self.put(node.inputs["Scale"], factor)
        return node.outputs[0]

    def mix(self, share, a, b):
        node = self.add("ShaderNodeMixShader", Fac=share)
        self.put(node.inputs[1], a)
        self.put(node.inputs[2], b)
        return node.outputs[0]

    def sum(self, a, b):
        node = self.tree.nodes.new("ShaderNodeAddShader")
        self.put(node.inputs[0], a)
        self.put(node.inputs[1], b)
        return node.outputs[0]

    def ggx(self, base, metallic, specular, roughness, normal):
        node = self.add("ShaderNodeBsdfPrincipled", Base_Color=base, Metallic=metallic, Specular=specular, Roughness=roughness, Normal=normal)
        node.distribution = "GGX"
        return node.outputs[0]


def cosine_of_view(nodes, normal):
    geometry = nodes.add("ShaderNodeNewGeometry")
    node = nodes.tree.nodes.new("ShaderNodeVectorMath")
    node.operation = "DOT_PRODUCT"
    nodes.put(node.inputs[0], geometry.outputs["Incoming"])
    nodes.put(node.inputs[1], geometry.outputs["Normal"] if normal is None else normal)
    return nodes.math("ABSOLUTE", node.outputs["Value"])


def dielectric(nodes, base, roughness, strength, normal):
    """Lambert * (1 - F) + GGX * F, F = Schlick's of v.h with f0 = 0.04, times KHR_materials_specular's strength.

    Nodes do not know the light's direction and so not h. The mean of F over all directions of light stands for it in Lambert's term:
    f0 + (1 - f0) g(n.v), with g fitted to 1e-5. GGX is Principled's, which has Fresnel's equations of v.h for n = 1.5 inside; their ratio to
    Schlick's at n.v, at most 1, is multiplied on top."""
    if strength == 0:
        return nodes.add("ShaderNodeBsdfDiffuse", Color=base, Normal=normal).outputs[0]
    x = nodes.math("SUBTRACT", 1.0, cosine_of_view(nodes, normal))
    g = 8.96e-3
    for factor in (7.78e-3, 9.32e-3, 2.02e-3, 8e-5):
        g = nodes.math("MULTIPLY_ADD", g, x, factor)
    rest = nodes.math("MULTIPLY_ADD", g, -0.96 * strength, 1 - 0.04 * strength)
    schlick = nodes.math("MULTIPLY_ADD", nodes.math("POWER", x, 5.0), 0.96, 0.04)
    ratio = nodes.math("DIVIDE", schlick, nodes.add("ShaderNodeFresnel", IOR=1.5, Normal=normal).outputs[0])
    gloss = nodes.ggx((0, 0, 0, 1), 0, 0.5, roughness, normal)
    diffuse = nodes.add("ShaderNodeBsdfDiffuse", Color=nodes.scaled(base, rest), Normal=normal).outputs[0]
    return nodes.sum(diffuse, nodes.mix(nodes.math("MULTIPLY", ratio, strength), None, gloss))


def gltf_surface(nodes, base, metallic, roughness, strength, normal):
    """glTF 2.0, appendix B: mix(dielectric, metal, metallic). A metal's F runs from f0 to 1 by the curve of Fresnel's equations for n = 1.5
    instead of Schlick's, and Smith's masking is not height-correlated, here and in dielectric()."""
    if metallic == 0:
        return dielectric(nodes, base, roughness, strength, normal)
    metal = nodes.ggx(base, 1, 0.5, roughness, normal)
    return metal if metallic == 1 else nodes.mix(metallic, dielectric(nodes, base, roughness, strength, normal), metal)


def value_of(socket):
    """What feeds an input: the output of a node, or its own value."""
    if socket.is_linked:
        return socket.links[0].from_socket
    value = socket.default_value
    return value if isinstance(value, float) else tuple(value)


def rebuild(material, forced, with_bumps):
    """An imported material's factors and textures under gltf_surface()."""
    nodes = Nodes(material)
    if not any(n.type == "BSDF_PRINCIPLED" for n in nodes.tree.nodes):
        sys.exit(f"{material.name}: the importer made no Principled BSDF of it")
    old = next(n for n in nodes.tree.nodes if n.type == "BSDF_PRINCIPLED")
    metallic = forced.get("metallic", value_of(old.inputs["Metallic"]))
    roughness = forced.get("roughness", value_of(old.inputs["Roughness"]))
    normal = old.inputs["Normal"].links[0].from_socket if with_bumps and old.inputs["Normal"].is_linked else None
    surface = gltf_surface(nodes, value_of(old.inputs["Base Color"]), metallic, roughness, forced.get("specular_factor", 1.0), normal)
    glow = value_of(old.inputs["Emission"])
    if not isinstance(glow, tuple) or any(glow[:3]):
        surface = nodes.sum(surface, nodes.add("ShaderNodeEmission", Color=glow, Strength=value_of(old.inputs["Emission Strength"])).outputs[0])
    alpha = value_of(old.inputs["Alpha"])
    if alpha != 1:
        surface = nodes.mix(alpha, nodes.add("ShaderNodeBsdfTransparent").outputs[0], surface)
    nodes.put(next(n for n in nodes.tree.nodes if n.type == "OUTPUT_MATERIAL").inputs["Surface"], surface)


def world_material(keys, forced):
    """Of a [[material]] that says all it needs."""
    if unknown := keys.keys() - MATERIAL:
        sys.exit(f"material {keys['name']}: cannot say {', '.join(unknown)} by Cycles' nodes")
    keys = {**keys, **forced}
    material = bpy.data.materials.new(keys["name"])
    material.use_nodes = True
    nodes = Nodes(material)
    nodes.tree.nodes.clear()
    surface = gltf_surface(nodes, (*keys["color"], 1), keys["metallic"], float(keys["roughness"]), keys.get("specular_factor", 1), None)
    strength = max(keys.get("emission", [0]))
    if strength > 0:
        glow = nodes.add("ShaderNodeEmission", Color=(*(c / strength for c in keys["emission"]), 1), Strength=strength)
        surface = nodes.sum(surface, glow.outputs[0])
    nodes.add("ShaderNodeOutputMaterial", Surface=surface)
    return material


# ---- Scenes ----------------------------------------------------------------------------------------------------------------------

def place(obj, part):
    """The object, whose vertices are y up, where position, rotation_deg and scale of a part put it."""
    scale = part.get("scale", 1)
    scale = scale if isinstance(scale, list) else [scale] * 3
    turn = Euler([math.radians(a) for a in part.get("rotation_deg", [0, 0, 0])], "XYZ").to_matrix().to_4x4()
    obj.matrix_world = TO_BLENDER @ Matrix.Translation(part.get("position", [0, 0, 0])) @ turn @ Matrix.Diagonal((*scale, 1))
    bpy.context.collection.objects.link(obj)


def add_mesh(name, vertices, faces, part, material, is_smooth=False):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    mesh.materials.append(material)
    mesh.polygons.foreach_set("use_smooth", [is_smooth] * len(faces))
    place(bpy.data.objects.new(name, mesh), part)


def read_obj(path):
    """Vertices, and the faces by object and material: v, o, usemtl and f with bare indices. Blender's importer would turn it."""
    vertices, objects, name, material = [], {}, "", ""
    for line in path.read_text().splitlines():
        word, _, rest = line.partition("#")[0].strip().partition(" ")
        if word == "v":
            vertices.append([float(x) for x in rest.split()])
        elif word == "o":
            name = rest
        elif word == "usemtl":
            material = rest
        elif word == "f":
            objects.setdefault((name, material), []).append([int(x) - 1 for x in rest.split()])
        elif word not in ("", "mtllib"):
            sys.exit(f"{path}: cannot read {line!r}")
    return vertices, objects


def add_obj(path, part, materials):
    vertices, objects = read_obj(path)
    for (name, material), faces in objects.items():
        used = sorted({v for face in faces for v in face})
        number = {v: k for k, v in enumerate(used)}
        add_mesh(name, [vertices[v] for v in used], [[number[v] for v in face] for face in faces], part, materials[material])


def sphere(radius):
    """Vertices and faces about +y."""
    rings, around = SPHERE_SEGMENTS // 2, SPHERE_SEGMENTS
    vertices = [(0, radius, 0), (0, -radius, 0)]
    for ring in range(1, rings):
        y, r = radius * math.cos(math.pi * ring / rings), radius * math.sin(math.pi * ring / rings)
        vertices += [(r * math.sin(2 * math.pi * k / around), y, r * math.cos(2 * math.pi * k / around)) for k in range(around)]
    faces = []
    for k in range(around):
        after, last = (k + 1) % around, 2 + (rings - 2) * around
        faces += [(0, 2 + k, 2 + after), (1, last + after, last + k)]
        faces += [(2 + r * around + k, 2 + (r + 1) * around + k, 2 + (r + 1) * around + after, 2 + r * around + after) for r in range(rings - 2)]
    return vertices, faces


def add_primitive(part, materials):
    material = materials[part["material"]]
    if part["type"] == "plane":
        x, z = (side / 2 for side in part["size"])
        add_mesh("plane", [(-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z)], [(0, 1, 2, 3)], part, material)
    elif part["type"] == "sphere":
        add_mesh("sphere", *sphere(part.get("radius", 1)), part, material, is_smooth=True)
    else:
        sys.exit(f"no primitive {part['type']} here")


def add_point_light(position, intensity_cd, color):
    """I candela, taken as W/sr: Blender's watts go evenly into 4 pi sr."""
    light = bpy.data.lights.new("point", "POINT")
    light.energy = 4 * math.pi * intensity_cd
    light.color = color
    light.shadow_soft_size = 0
    place(bpy.data.objects.new("point", light), {"position": position})


def load_world(path, wanted):
    world = tomllib.loads(path.read_text())
    if unknown := world.keys() - {"model", "primitive", "material", "light", "environment", "camera", "render"}:
        sys.exit(f"{path}: cannot make {', '.join(unknown)}")
    materials = {m["name"]: world_material(m, dict(wanted.material)) for m in world.get("material", [])}
    for part in world.get("model", []):
        add_obj(path.parent / part["file"], part, materials)
    for part in world.get("primitive", []):
        add_primitive(part, materials)
    for light in world.get("light", []):
        if light["type"] != "photometric-point":
            sys.exit(f"{path}: no light {light['type']} here")
        add_point_light(light["position"], light.get("intensity_cd", 1), light.get("color", [1, 1, 1]))
    if sky := world.get("environment"):
        set_sky(path.parent / sky["file"], sky.get("intensity", 1), sky.get("rotation_deg", 0))
    camera = world["camera"][0]
    set_camera(camera["position"], camera.get("target", [0, 0, 0]), camera["vertical_fov_deg"])


def load_gltf(path, wanted):
    numpy.bool = bool  # the importer of 2022 asks for it; numpy 1.24 has it no more
    bpy.ops.preferences.addon_enable(module="io_scene_gltf2")
    bpy.ops.import_scene.gltf(filepath=str(path), convert_lighting_mode="COMPAT")  # COMPAT: W = 4 pi cd
    for material in bpy.data.materials:
        rebuild(material, dict(wanted.material), wanted.bump == "auto")
    for light in bpy.data.lights:
        light.shadow_soft_size = 0
    set_camera(wanted.camera_position, wanted.camera_focal_point, wanted.camera_view_angle)


def set_camera(position, target, vertical_fov_deg):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle = math.radians(vertical_fov_deg)
    camera.clip_start, camera.clip_end = 1e-3, 1e4
    eye = TO_BLENDER @ Vector(position)
    obj = bpy.data.objects.new("camera", camera)
    obj.matrix_world = Matrix.Translation(eye) @ (TO_BLENDER @ Vector(target) - eye).to_track_quat("-Z", "Y").to_matrix().to_4x4()
    bpy.context.collection.objects.link(obj)
    bpy.context.scene.camera = obj


def set_sky(file, intensity, rotation_deg):
    """The middle of the picture lies along -Z of glTF, which is +Y here; Cycles puts it along +X."""
    world = bpy.context.scene.world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    nodes = Nodes(world)
    nodes.tree.nodes.clear()
    turned = nodes.add("ShaderNodeMapping", Vector=nodes.add("ShaderNodeTexCoord").outputs["Generated"],
                       Rotation=(0, 0, -math.radians(90 + rotation_deg)))
    picture = nodes.add("ShaderNodeTexEnvironment", Vector=turned.outputs[0])
    picture.image = bpy.data.images.load(str(file.resolve()))
    picture.image.colorspace_settings.name = "Linear"
    back = nodes.add("ShaderNodeBackground", Color=picture.outputs[0], Strength=intensity)
    nodes.add("ShaderNodeOutputWorld", Surface=back.outputs[0])
    world.cycles.sampling_method = "MANUAL"
    world.cycles.sample_map_resolution = max(picture.image.size[0], 4)


# ---- Picture ---------------------------------------------------------------------------------------------------------------------

def set_cycles(scene, wanted):
    cycles, render = scene.cycles, scene.render
    render.engine = "CYCLES"
    cycles.device, cycles.samples, cycles.seed = "CPU", wanted.samples, wanted.seed
    cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_fast_gi = cycles.use_auto_tile = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.blur_glossy = cycles.light_sampling_threshold = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    for kind in ("max", "diffuse", "glossy", "transmission"):
        setattr(cycles, f"{kind}_bounces", wanted.max_depth)
    cycles.transparent_max_bounces = 64
    cycles.pixel_filter_type = "BOX"
    for obj in bpy.data.objects:
        obj.cycles.shadow_terminator_geometry_offset = obj.cycles.shadow_terminator_offset = 0
    render.threads_mode, render.threads = ("FIXED", wanted.threads) if wanted.threads else ("AUTO", 1)
    render.resolution_x, render.resolution_y, render.resolution_percentage = int(wanted.resolution[0]), int(wanted.resolution[1]), 100
    render.use_compositing = render.use_sequencer = render.film_transparent = False


def write(scene, path):
    """Half floats, three channels, without date, host and paths in the header."""
    for name in dir(scene.render):
        if name.startswith("use_stamp_"):
            setattr(scene.render, name, name == "use_stamp_render_time")
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth, settings.exr_codec = "OPEN_EXR", "RGB", "16", "ZIP"
    scene.render.filepath = str(path.resolve())
    bpy.ops.render.render(write_still=True)


def header_text(path, name):
    """A text attribute of an EXR header: name, type, length, text."""
    data = path.read_bytes()[:65536]
    at = data.find(name.encode() + b"\0string\0")
    if at < 0:
        return "unknown"
    at += len(name) + 8
    return data[at + 4: at + 4 + struct.unpack_from("<i", data, at)[0]].decode()


def main():
    wanted = options()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("black")
    scene.world.color = (0, 0, 0)
    if wanted.hdri_file:
        set_sky(wanted.hdri_file, wanted.hdri_intensity, wanted.hdri_rotation)
    (load_world if wanted.scene.name.endswith(".scene.toml") else load_gltf)(wanted.scene, wanted)
    set_cycles(scene, wanted)
    write(scene, wanted.output)
    for field in ("samples", "synchronization_time", "render_time", "total_time"):
        print(f"cycles {field}: {header_text(wanted.output, 'cycles.ViewLayer.' + field)}")


main()
