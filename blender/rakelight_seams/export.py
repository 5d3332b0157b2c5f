# SPDX-License-Identifier: Apache-2.0
"""File > Export > glTF without Seams: Blender's own exporter, then the program."""
import contextlib
import os
import shutil

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from .program import Failure, kept_flat, remarks
from .run import RunsProgram
from .settings import SeamOptions

TANGENTS = (
    ("AUTO", "Where needed", "Where a material has a normal map"),
    ("ALWAYS", "Always", "Wherever there are texture coordinates"),
    ("NEVER", "Never", "None"),
)


class ExportWithoutSeams(RunsProgram, SeamOptions, ExportHelper, bpy.types.Operator):
    """Write the selected objects as GLB, with normals and tangents that agree where they meet; the objects stay as they are"""

    bl_idname = "rakelight.export_glb"
    bl_label = "Export GLB without Seams"
    bl_options = {"REGISTER", "PRESET"}

    filename_ext = ".glb"
    filter_glob: StringProperty(default="*.glb", options={"HIDDEN"})
    tangents: EnumProperty(name="Tangents", items=TANGENTS, default="AUTO")
    apply_modifiers: BoolProperty(
        name="Apply Modifiers", default=False, description="All but Armature; shape keys are lost where it is on")
    animations: BoolProperty(name="Animations", default=True)

    invoke = ExportHelper.invoke  # the file browser, which calls execute()

    @classmethod
    def poll(cls, context):
        if context.mode != "OBJECT":
            cls.poll_message_set("Switch to Object Mode")
            return False
        cls.poll_message_set("Select objects")
        return bool(context.selected_objects)

    def draw(self, context):
        self.draw_options(self.layout)
        self.draw_details(self.layout)
        for name in ("tangents", "apply_modifiers", "animations"):
            self.layout.prop(self, name)

    def path(self):
        path = bpy.path.abspath(self.filepath)
        if os.path.basename(path).lower() in ("", ".glb"):
            raise Failure("No file name")
        return bpy.path.ensure_ext(path, self.filename_ext)  # the file browser has added it, a script may not have

    def begin(self, context, source):
        self.path()
        if not hasattr(bpy.types, "EXPORT_SCENE_OT_gltf"):
            raise Failure("Blender's own glTF exporter is off: Preferences > Add-ons > Import-Export: glTF 2.0 format")
        # Without its armature an object would be written without its skin.
        rigs = {m.object for item in context.selected_objects for m in item.modifiers if m.type == "ARMATURE" and m.object}
        added = [rig for rig in rigs if not rig.select_get() and rig.visible_get()]
        try:
            for rig in added:
                rig.select_set(True)
            bpy.ops.export_scene.gltf(
                filepath=source, export_format="GLB", use_selection=True, export_normals=True, export_tangents=False,
                export_apply=self.apply_modifiers, export_animations=self.animations)
        except RuntimeError as error:
            lines = [line.strip() for line in str(error).splitlines() if line.strip()]
            raise Failure(f"Blender's glTF exporter: {lines[-1] if lines else 'failed'}") from None
        finally:
            for rig in added:
                rig.select_set(False)
        if not os.path.isfile(source):
            raise Failure("Blender's glTF exporter wrote no file")
        return self.arguments() + ["--tangents", self.tangents.lower()]

    def finish(self, context, target, row):
        path = self.path()
        try:
            shutil.copyfile(target, path + ".part")  # so that an old file stays whole until the new one is
            os.replace(path + ".part", path)
        except OSError as error:
            with contextlib.suppress(OSError):
                os.remove(path + ".part")
            raise Failure(f"{path}: {error.strerror or error}") from None
        for remark in remarks(row):
            self.report({"INFO"}, f"rakelight: {remark}")
        flat = kept_flat(row)
        self.report({"INFO"}, f"{path}: written" + (f"; {flat}" if flat else ""))

    def forget(self):
        pass


def draw_menu(menu, context):
    menu.layout.operator(ExportWithoutSeams.bl_idname, text="glTF without Seams (.glb)")
