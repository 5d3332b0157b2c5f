# SPDX-License-Identifier: Apache-2.0
"""Closes the seams between mesh objects: hands them to the program `rakelight` and writes its normals back as custom split normals.

Reading order: fix_seams.py (the operator), meshes.py (Blender's meshes <-> arrays), glb.py (arrays <-> files), program.py."""

bl_info = {
    "name": "Rakelight Seams",
    "description": "Close the seams in the shading between objects",
    "author": "Rakelight",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Rakelight; File > Export",
    "category": "Mesh",
}

if "bpy" in locals():  # "Reload Scripts" runs this file again: its modules are to be read anew too
    import importlib

    for module in (settings, program, glb, meshes, run, fix_seams, export, panel):  # noqa: F821
        importlib.reload(module)
else:
    from . import settings, program, glb, meshes, run, fix_seams, export, panel  # noqa: F401

import bpy

CLASSES = (
    settings.Preferences,
    settings.Settings,
    fix_seams.FixSeams,
    export.ExportWithoutSeams,
    panel.SeamPanel,
    panel.DetailPanel,
)


def register():
    for item in CLASSES:
        bpy.utils.register_class(item)
    bpy.types.Scene.rakelight_seams = bpy.props.PointerProperty(type=settings.Settings)
    bpy.types.TOPBAR_MT_file_export.append(export.draw_menu)
    bpy.types.VIEW3D_MT_object.append(fix_seams.draw_menu)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(fix_seams.draw_menu)
    bpy.types.TOPBAR_MT_file_export.remove(export.draw_menu)
    del bpy.types.Scene.rakelight_seams
    for item in reversed(CLASSES):
        bpy.utils.unregister_class(item)
