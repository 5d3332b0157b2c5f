# SPDX-License-Identifier: Apache-2.0
"""The sidebar (N) of the 3D View."""
import bpy

from .export import ExportWithoutSeams
from .fix_seams import FixSeams


class Sidebar:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Rakelight"


class SeamPanel(Sidebar, bpy.types.Panel):
    bl_idname = "RAKELIGHT_PT_seams"
    bl_label = "Seams"

    def draw(self, context):
        layout, settings = self.layout, context.scene.rakelight_seams
        settings.draw_options(layout)
        count = sum(item.type == "MESH" for item in context.selected_objects)
        layout.label(text=f"{count} mesh objects selected")
        settings.pass_on(layout.operator(FixSeams.bl_idname, icon="MOD_NORMALEDIT"))
        settings.pass_on(layout.operator(ExportWithoutSeams.bl_idname, icon="EXPORT"))


class DetailPanel(Sidebar, bpy.types.Panel):
    bl_idname = "RAKELIGHT_PT_details"
    bl_parent_id = "RAKELIGHT_PT_seams"
    bl_label = "More"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        context.scene.rakelight_seams.draw_details(self.layout)
