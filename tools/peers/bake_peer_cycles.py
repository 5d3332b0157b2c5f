# SPDX-License-Identifier: Apache-2.0
"""The normals of a glTF model with its normal maps as Blender Cycles sees them, 0.5 + 0.5 n in glTF's axes. Runs inside Blender 3.4:

  blender -b --factory-startup --python-exit-code 1 --python tools/peers/bake_peer_cycles.py -- MODEL.glb OUT.png SIZE X,Y,Z DEGREES

The camera stands at X,Y,Z and looks along -Z. Cycles makes tangents itself (MikkTSpace), of the file's normals and texture coordinates."""
import math
import sys

import bpy
import numpy
from mathutils import Matrix, Vector

numpy.bool = bool  # Blender's importer names it, NumPy 1.24 has it no more


def show_normals(material):
    """Light in place of the surface, of the color of its normal."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    normal = next((n for n in nodes if n.type == "NORMAL_MAP"), None) or nodes.new("ShaderNodeNewGeometry")
    split, turned = nodes.new("ShaderNodeSeparateXYZ"), nodes.new("ShaderNodeCombineXYZ")
    links.new(normal.outputs["Normal"], split.inputs[0])
    down = nodes.new("ShaderNodeMath")
    down.operation = "MULTIPLY"
    down.inputs[1].default_value = -1
    links.new(split.outputs["Y"], down.inputs[0])
    for source, to in ((split.outputs["X"], "X"), (split.outputs["Z"], "Y"), (down.outputs[0], "Z")):
        links.new(source, turned.inputs[to])
    half = nodes.new("ShaderNodeVectorMath")
    half.operation = "MULTIPLY_ADD"
    links.new(turned.outputs[0], half.inputs[0])
    half.inputs[1].default_value = half.inputs[2].default_value = (0.5, 0.5, 0.5)
    light = nodes.new("ShaderNodeEmission")
    links.new(half.outputs[0], light.inputs["Color"])
    output = next(n for n in nodes if n.type == "OUTPUT_MATERIAL")
    links.new(light.outputs[0], output.inputs["Surface"])


def main():
    model, out, size, place, angle = sys.argv[sys.argv.index("--") + 1:]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("black")
    scene.world.color = (0, 0, 0)
    bpy.ops.import_scene.gltf(filepath=model)
    for material in bpy.data.materials:
        if material.use_nodes:
            show_normals(material)
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit, camera.angle, camera.clip_start, camera.clip_end = "VERTICAL", math.radians(float(angle)), 1e-3, 1e4
    scene.camera = bpy.data.objects.new("camera", camera)
    scene.collection.objects.link(scene.camera)
    x, y, z = map(float, place.split(","))
    to_blender = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))
    scene.camera.matrix_world = to_blender @ Matrix.Translation(Vector((x, y, z)))
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.use_adaptive_sampling = 1, False, False
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BLACKMAN_HARRIS", 0.01
    scene.render.resolution_x = scene.render.resolution_y = int(size)
    scene.render.resolution_percentage = 100
    scene.display_settings.display_device, scene.view_settings.view_transform = "None", "Standard"
    scene.render.image_settings.file_format, scene.render.image_settings.color_mode = "PNG", "RGB"
    scene.render.dither_intensity = 0
    scene.render.filepath = out
    bpy.ops.render.render(write_still=True)


main()
