# SPDX-License-Identifier: Apache-2.0
"""Scenes of objects that meet, and what Blender itself says of their normals."""
import os

import bmesh
import bpy
import numpy as np
from mathutils import Matrix
from mathutils.kdtree import KDTree

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def clear():
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.ops.preferences.addon_enable(module="rakelight_seams")
    bpy.ops.preferences.addon_enable(module="io_scene_gltf2")


def set_program(path):
    bpy.context.preferences.addons["rakelight_seams"].preferences.program = path


def add(name, mesh, matrix=None):
    item = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(item)
    item.matrix_world = matrix or Matrix()
    bpy.context.view_layer.update()
    return item


def select(objects):
    for item in bpy.context.view_layer.objects:
        item.select_set(item in objects)
    bpy.context.view_layer.objects.active = objects[0] if objects else None


def mesh_of(name, positions, faces, smooth=True):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([tuple(map(float, p)) for p in positions], [], faces)
    mesh.polygons.foreach_set("use_smooth", [smooth] * len(mesh.polygons))
    mesh.update()
    return mesh


def cut(positions, faces, cell_of):
    """{cell: (positions, faces)}: faces go to the cell that cell_of(center) says; vertices keep every bit."""
    cells = {}
    for face in faces:
        cells.setdefault(cell_of(np.mean([positions[v] for v in face], axis=0)), []).append(face)
    parts = {}
    for cell, group in sorted(cells.items()):
        used = sorted({v for face in group for v in face})
        number = {v: i for i, v in enumerate(used)}
        parts[cell] = ([positions[v] for v in used], [[number[v] for v in face] for face in group])
    return parts


def head_parts():
    """The head of data/head as six objects, with nothing shared between them."""
    positions, faces = [], []
    with open(os.path.join(ROOT, "data/head/head.obj")) as file:
        for line in file:
            words = line.split()
            if words and words[0] == "v":
                positions.append(np.array([float(x) for x in words[1:4]], np.float32))
            elif words and words[0] == "f":
                faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    low, high = np.min(positions, axis=0), np.max(positions, axis=0)
    grid = np.array([2, 3, 1])
    parts = cut(positions, faces, lambda center: tuple(np.minimum((center - low) / (high - low) * grid, grid - 1).astype(int)))
    return [add(f"head {cell}", mesh_of(f"head {cell}", *part)) for cell, part in parts.items()]


def ball(cuts=(0.0,), segments=24, rings=12, quads=True):
    """A sphere's parts as (positions, faces): cut at the given heights of z."""
    made = bmesh.new()
    bmesh.ops.create_uvsphere(made, u_segments=segments, v_segments=rings, radius=1)
    if not quads:
        bmesh.ops.triangulate(made, faces=made.faces[:])
    made.verts.ensure_lookup_table()
    positions = [np.array(v.co, np.float32) for v in made.verts]
    faces = [[v.index for v in face.verts] for face in made.faces]
    made.free()
    return list(cut(positions, faces, lambda center: int(np.sum(center[2] > np.array(cuts)))).values())


def corner_normals(mesh):
    """[corners, 3], as Blender has them: not by the add-on's own code."""
    if hasattr(mesh, "calc_normals_split"):
        mesh.calc_normals_split()
        return np.array([loop.normal[:] for loop in mesh.loops], np.float64)
    return np.array([normal.vector[:] for normal in mesh.corner_normals], np.float64)


def degrees_between(a, b):
    a, b = np.asarray(a, np.float64), np.asarray(b, np.float64)
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), np.sum(a * b, axis=-1)))


def places_of(objects, near):
    """Of every object's vertices the number of their place in the world; within `near` it is one place."""
    world = []
    for item in objects:
        matrix = np.array(item.matrix_world, np.float64)
        world.append(np.array([v.co[:] for v in item.data.vertices], np.float64) @ matrix[:3, :3].T + matrix[:3, 3])
    tree = KDTree(sum(map(len, world)))
    for number, place in enumerate(np.vstack(world)):
        tree.insert(place, number)
    tree.balance()
    return [[min(found[1] for found in tree.find_range(place, near)) for place in part] for part in world]


def seams(objects, crease_deg=60.0, near=4e-5):
    """Angles in the world at both ends of every edge at which faces of two objects meet with less than the crease angle."""
    edges = {}
    for number, (item, keys) in enumerate(zip(objects, places_of(objects, near))):
        mesh = item.data
        turn = np.linalg.inv(np.array(item.matrix_world, np.float64)[:3, :3]).T
        normals = corner_normals(mesh) @ turn.T
        for face in mesh.polygons:
            if face.area == 0:
                continue
            own = turn @ np.array(face.normal)
            loops = list(face.loop_indices)
            for a, b in zip(loops, loops[1:] + loops[:1]):
                ends = sorted((keys[mesh.loops[k].vertex_index], tuple(normals[k])) for k in (a, b))
                edges.setdefault((ends[0][0], ends[1][0]), []).append((number, own, ends[0][1], ends[1][1]))
    angles = []
    for sides in edges.values():
        for i, (one, face_a, *ends_a) in enumerate(sides):
            for two, face_b, *ends_b in sides[:i]:
                if one != two and degrees_between(face_a, face_b) < crease_deg:
                    angles += [degrees_between(a, b) for a, b in zip(ends_a, ends_b)]
    return np.array(angles)


def state(item):
    """All that Fix Seams may change of an object, to be compared."""
    mesh = item.data
    return (
        mesh.name, mesh.users, getattr(mesh, "use_auto_smooth", None), mesh.has_custom_normals, len(item.modifiers),
        tuple(edge.use_edge_sharp for edge in mesh.edges), corner_normals(mesh).tobytes(),
    )
