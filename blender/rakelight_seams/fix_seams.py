# SPDX-License-Identifier: Apache-2.0
"""The operator Fix Seams."""
import bpy

from . import glb, meshes, program
from .program import Failure
from .run import RunsProgram
from .settings import FixOptions


class FixSeams(RunsProgram, FixOptions, bpy.types.Operator):
    """Make the normals of the selected mesh objects agree where they meet, as custom split normals"""

    bl_idname = "rakelight.fix_seams"
    bl_label = "Fix Seams"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if context.mode != "OBJECT":
            cls.poll_message_set("Switch to Object Mode")
            return False
        cls.poll_message_set("Select mesh objects")
        return any(item.type == "MESH" for item in context.selected_objects)

    def draw(self, context):
        self.draw_options(self.layout)
        self.draw_details(self.layout)

    def begin(self, context, source):
        self.surfaces = []
        self.surfaces, self.notes = meshes.collect(context, self.keep_instances, self.apply_modifiers)
        if not self.surfaces:
            raise Failure("Nothing to fix: " + ("; ".join(self.notes) or "no faces are selected"))
        glb.write(source, [surface.part for surface in self.surfaces])
        return self.arguments(meshes.rounding_distance(self.surfaces)) + (["--keep-instances"] if self.keep_instances else [])

    def finish(self, context, target, row):
        results = glb.read_normals(target, [surface.part for surface in self.surfaces])
        outcome = meshes.assign(self.surfaces, results)
        if outcome.copied:
            self.notes.append(f"Meshes of their own now: {', '.join(outcome.copied)}")
        for note in [f"rakelight: {remark}" for remark in program.remarks(row)] + self.notes:
            self.report({"INFO"}, note)  # the Info editor keeps all, the status bar shows the last
        text = describe(outcome, program.kept_flat(row))
        if self.notes:
            text += f"; {self.notes[0]}" + (f" ({len(self.notes) - 1} more notes in the Info editor)" if self.notes[1:] else "")
        self.report({"WARNING" if self.notes else "INFO"}, text)

    def forget(self):
        meshes.forget(getattr(self, "surfaces", []))
        self.surfaces = []


def describe(outcome, kept_flat):
    if outcome.turned:
        text = (f"{outcome.turned} of {outcome.corners} normals turned by at most {outcome.max_deg:.3g} degrees, "
                f"in {len(outcome.changed)} objects; Blender's code of them is off by at most {outcome.code_deg:.2g} degrees")
    else:
        text = f"{'All' if kept_flat else 'No seams: all'} {outcome.corners} normals stay"
    return f"{kept_flat}; {text}" if kept_flat else text



def draw_menu(menu, context):
    menu.layout.separator()
    menu.layout.operator_context = "INVOKE_DEFAULT"
    context.scene.rakelight_seams.pass_on(menu.layout.operator(FixSeams.bl_idname))
