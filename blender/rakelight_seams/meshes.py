# SPDX-License-Identifier: Apache-2.0
"""Blender's meshes to arrays, and normals back to them as custom split normals.

What a corner (loop) is called is its number in the mesh; it stays the same on the whole way."""
from dataclasses import dataclass, field

import bpy
import numpy as np

from . import glb
from .program import Failure

# Modifiers that keep the corners of a mesh and its custom normals. Behind all others the surface is another one.
KEEPS_CORNERS = {
    "ARMATURE", "CAST", "CLOTH", "COLLISION", "CORRECTIVE_SMOOTH", "CURVE", "DISPLACE", "DYNAMIC_PAINT", "HOOK", "LAPLACIANDEFORM",
    "LAPLACIANSMOOTH", "LATTICE", "MESH_CACHE", "MESH_DEFORM", "MESH_SEQUENCE_CACHE", "PARTICLE_SYSTEM", "SHRINKWRAP",
    "SIMPLE_DEFORM", "SMOOTH", "SOFT_BODY", "SURFACE", "SURFACE_DEFORM", "UV_PROJECT", "UV_WARP", "VERTEX_WEIGHT_EDIT",
    "VERTEX_WEIGHT_MIX", "VERTEX_WEIGHT_PROXIMITY", "WARP", "WAVE",
}
# Blender's code of a custom normal, 16 bits for each of two angles, is off by up to 0.045 degrees where fans are bent far (measured on
# the head of the tests). Normals nearer than that count as one.
SAME_NORMAL_DEG = 0.05


@dataclass
class Surface:
    """A mesh and the selected objects that are to show it with the same normals."""

    mesh: bpy.types.Mesh  # what is read
    objects: list
    is_own: bool = False  # `mesh` was made here, with modifiers applied; no object shows it yet
    part: glb.Part = None


@dataclass
class Outcome:
    changed: list = field(default_factory=list)  # names of objects
    copied: list = field(default_factory=list)  # names of objects that got a mesh of their own
    turned: int = 0  # corners
    corners: int = 0
    max_deg: float = 0.0
    code_deg: float = 0.0  # what Blender's code of 16 bits is off by


def degrees_between(a, b):
    """[n] angles of unit vectors, exact for small ones too."""
    chord = np.linalg.norm(a.astype(np.float64) - b.astype(np.float64), axis=1)
    return np.degrees(2 * np.arcsin(np.minimum(1.0, chord / 2)))


def read_corner_normals(mesh):
    """[corners, 3] float32: what Blender shows."""
    normals = np.empty((len(mesh.loops), 3), np.float32)
    if hasattr(mesh, "calc_normals_split"):  # until Blender 4.0
        mesh.calc_normals_split()
        mesh.loops.foreach_get("normal", normals.reshape(-1))
        mesh.free_normals_split()
    else:
        mesh.corner_normals.foreach_get("vector", normals.reshape(-1))
    return normals


def read_part(name, mesh, matrices):
    positions = np.empty((len(mesh.vertices), 3), np.float32)
    mesh.vertices.foreach_get("co", positions.reshape(-1))
    if not np.isfinite(positions).all():
        raise Failure(f"{name}: vertex {np.flatnonzero(~np.isfinite(positions).all(axis=1))[0]} has a position that is not finite")
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    mesh.calc_loop_triangles()
    triangles = np.empty((len(mesh.loop_triangles), 3), np.int32)
    mesh.loop_triangles.foreach_get("loops", triangles.reshape(-1))
    return glb.Part(name, positions[corners], read_corner_normals(mesh), triangles, matrices)


def is_flattened(matrix):
    """Normals have no place in an object whose scale is zero along an axis, or not finite."""
    if not np.isfinite(matrix).all():
        return True
    columns = np.array(matrix, np.float64)[:3, :3]
    lengths = np.linalg.norm(columns, axis=0)
    return lengths.min() == 0 or abs(np.linalg.det(columns / lengths)) < 1e-9


def collect(context, keep_instances, apply_modifiers):
    """The selected mesh objects as surfaces, and notes on what is left out. Changes nothing that is shown."""
    objects, notes = [], []
    for item in context.selected_objects:
        if item.type != "MESH":
            notes.append(f"{item.name} is not a mesh")
        elif item.library:
            notes.append(f"{item.name} is linked from another file")
        elif not item.data.polygons and not (apply_modifiers and item.modifiers):
            notes.append(f"{item.name} has no faces")
        elif is_flattened(item.matrix_world):
            notes.append(f"{item.name} has a scale that is zero or not finite")
        else:
            objects.append(item)
    surfaces = []
    try:
        applied = meshes_with_modifiers(context, objects, notes) if apply_modifiers else {}
        by_mesh = {}
        for item in objects:
            if item.name in applied:
                surfaces.append(Surface(applied[item.name], [item], is_own=True))
            elif keep_instances and item.data.name_full in by_mesh:
                by_mesh[item.data.name_full].objects.append(item)
            else:
                surfaces.append(Surface(item.data, [item]))
                by_mesh[item.data.name_full] = surfaces[-1]
        for item in objects:
            hiding = [m.name for m in item.modifiers if m.show_viewport and m.type not in KEEPS_CORNERS]
            if hiding and item.name not in applied:
                notes.append(f"{item.name} gets its normals below its modifiers {', '.join(hiding)}")
        for surface in surfaces:
            matrices = [[list(row) for row in item.matrix_world] for item in surface.objects]
            surface.part = read_part(surface.objects[0].name, surface.mesh, matrices)
    except BaseException:
        forget(surfaces)
        raise
    forget([s for s in surfaces if not len(s.part.triangles)])
    return [s for s in surfaces if len(s.part.triangles)], notes


def rounding_distance(surfaces):
    """[m] how far apart Blender may have put what is one place to the user, or 0 where all objects stand alike and places are exact.
    World matrices are products of locations, angles and scales in float; 2^-20 is eight of its steps. The program allows for less: it
    takes matrices as exact."""
    matrices = [np.array(matrix, np.float64) for surface in surfaces for matrix in surface.part.matrices]
    if all(np.array_equal(matrix, matrices[0]) for matrix in matrices):
        return 0.0
    reach = 0.0
    for surface in surfaces:
        largest = float(np.abs(surface.part.positions).max())
        for matrix in np.array(surface.part.matrices, np.float64):
            scale = np.linalg.norm(matrix[:3, :3], axis=0).max()
            reach = max(reach, largest * scale + np.linalg.norm(matrix[:3, 3]))
    return reach * 2.0**-20


def meshes_with_modifiers(context, objects, notes):
    """Object name -> new mesh, where all visible modifiers but Armature are applied. Armatures stay: skins are fixed in bind pose."""
    fit = []
    for item in objects:
        if any(m.show_viewport and m.type != "ARMATURE" for m in item.modifiers):
            if item.data.shape_keys:
                notes.append(f"{item.name} has shape keys, its modifiers stay")
            else:
                fit.append(item)
    armatures = [m for item in fit for m in item.modifiers if m.type == "ARMATURE" and m.show_viewport]
    try:
        for modifier in armatures:
            modifier.show_viewport = False
        graph = context.evaluated_depsgraph_get()
        graph.update()
        return {item.name: bpy.data.meshes.new_from_object(item.evaluated_get(graph), preserve_all_data_layers=True, depsgraph=graph)
                for item in fit}
    finally:
        for modifier in armatures:
            modifier.show_viewport = True


def forget(surfaces):
    """Removes the meshes that were made and that nobody shows."""
    for surface in surfaces:
        if surface.is_own and surface.mesh.users == 0:
            bpy.data.meshes.remove(surface.mesh)


def assign(surfaces, results):
    """Writes normals back. Everything that can fail is asked before the first mesh is touched."""
    for surface, normals in zip(surfaces, results):
        if len(surface.mesh.loops) != len(normals) or not all(item.data for item in surface.objects):
            raise Failure(f"{surface.part.name}: the mesh has changed in the meantime")
    outcome = Outcome()
    by_mesh = {}
    for surface, normals in zip(surfaces, results):
        turns = degrees_between(surface.part.normals, normals)
        # Not by the angle: what the program leaves alone keeps its bits.
        turned = (surface.part.normals != normals).any(axis=1)
        outcome.corners += len(turns)
        outcome.turned += int(turned.sum())
        had_one = (surface.part.normals != 0).any(axis=1)  # corners of faces without area have none
        outcome.max_deg = max(outcome.max_deg, float(turns[had_one].max(initial=0)))
        if surface.is_own:
            put_in_place(surface)
        if turned.any():
            outcome.changed += [item.name for item in surface.objects]
        if surface.is_own and turned.any():
            outcome.code_deg = max(outcome.code_deg, write_corner_normals(surface.mesh, normals))
        elif not surface.is_own:
            by_mesh.setdefault(surface.mesh.name_full, []).append((surface, normals, bool(turned.any())))
    for group in by_mesh.values():
        assign_shared(group, outcome)
    return outcome


def put_in_place(surface):
    """The object shows the mesh with its modifiers applied, and loses these."""
    item = surface.objects[0]
    name = item.data.name
    old = item.data
    for key, value in old.items():
        surface.mesh[key] = value
    item.data = surface.mesh
    for modifier in [m for m in item.modifiers if m.show_viewport and m.type != "ARMATURE"]:
        item.modifiers.remove(modifier)
    if old.users == 0:
        bpy.data.meshes.remove(old)
    surface.mesh.name = name


def assign_shared(group, outcome):
    """`group`: (surface, normals, turned) of one mesh. Objects whose normals agree go on sharing; who needs others gets a copy. Objects
    that are not selected keep what they show, unless instances are kept."""
    mesh = group[0][0].mesh
    kept_together = len(group) == 1 and len(group[0][0].objects) > 1
    selected = {item for surface, _, _ in group for item in surface.objects}
    others = [item for item in bpy.data.objects if item.data == mesh and item not in selected]
    is_taken = mesh.library is not None or (bool(others) and not kept_together) or not all(turned for _, _, turned in group)
    clusters = []  # [normals, objects]
    for surface, normals, turned in group:
        if not turned:
            continue
        for cluster in clusters:
            if degrees_between(cluster[0], normals).max() <= SAME_NORMAL_DEG:
                cluster[1].extend(surface.objects)
                break
        else:
            clusters.append((normals, list(surface.objects)))
    targets = [mesh.copy() if is_taken or number else mesh for number in range(len(clusters))]
    for target, (normals, objects) in zip(targets, clusters):
        if target != mesh:
            for item in objects:
                item.data = target
            outcome.copied += [item.name for item in objects]
        outcome.code_deg = max(outcome.code_deg, write_corner_normals(target, normals))


def write_corner_normals(mesh, normals):
    """How far Blender's own normals are from `normals` afterwards, in degrees."""
    if hasattr(mesh, "use_auto_smooth"):  # until Blender 4.0 custom normals are shown only with it
        mesh.use_auto_smooth = True
    mesh.normals_split_custom_set(normals)
    off = code_error(mesh, normals)
    if off > SAME_NORMAL_DEG:
        # Blender averages corners between two sharp edges that differ by less than 0.8 degrees (0.9999 in its source).
        mark_sharp_edges(mesh, normals)
        mesh.normals_split_custom_set(normals)
        off = code_error(mesh, normals)
    mesh.update()
    return off


def code_error(mesh, normals):
    got = read_corner_normals(mesh)
    kept = (got != 0).any(axis=1)  # faces without area have no normals in Blender, and nothing to shade
    return float(degrees_between(got, normals)[kept].max(initial=0))


def mark_sharp_edges(mesh, normals):
    """Sharp is every edge across which `normals` differ at one of its ends."""
    count = len(mesh.loops)
    vertices, edges = np.empty(count, np.int32), np.empty(count, np.int32)
    mesh.loops.foreach_get("vertex_index", vertices)
    mesh.loops.foreach_get("edge_index", edges)
    starts, totals = np.empty(len(mesh.polygons), np.int32), np.empty(len(mesh.polygons), np.int32)
    mesh.polygons.foreach_get("loop_start", starts)
    mesh.polygons.foreach_get("loop_total", totals)
    following = np.arange(1, count + 1)
    following[starts + totals - 1] = starts
    # Of each loop's edge the corners at its ends, that at the vertex of the lower number first: the same way from both sides.
    ends = np.stack([np.arange(count), following], axis=1)
    ends[vertices > vertices[following]] = ends[vertices > vertices[following]][:, ::-1]
    order = np.argsort(edges, kind="stable")
    pairs = np.flatnonzero(edges[order][:-1] == edges[order][1:])
    one, two = ends[order[pairs]], ends[order[pairs + 1]]
    differ = (np.abs(normals[one] - normals[two]) > 1e-5).any(axis=(1, 2))
    sharp = np.empty(len(mesh.edges), bool)
    mesh.edges.foreach_get("use_edge_sharp", sharp)
    sharp[edges[order[pairs[differ]]]] = True
    mesh.edges.foreach_set("use_edge_sharp", sharp)
