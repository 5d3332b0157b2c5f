# SPDX-License-Identifier: Apache-2.0
"""The preferences, and the options that both operators and the sidebar have."""
import math

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, StringProperty

NORMALS = (
    ("SEAMS", "Seams only", "Normals stay, hard edges and weighted normals too; they are joined only where objects meet"),
    ("MODEL", "Whole model", "All normals are made anew over all objects, with hard edges by the creases alone"),
    ("OBJECT", "Each object", "All normals are made anew within each object: borders between objects stay visible"),
)
WEIGHTS = (
    ("ANGLE", "Angle", "By the angle of the corner"),
    ("UNIFORM", "Uniform", "Every triangle alike"),
    ("AREA", "Area", "By the area of the triangle"),
    ("ANGLE_AREA", "Angle and area", "By the angle of the corner times the area of the triangle"),
    ("MAX", "Max", "By the sine of the angle, divided by the lengths of both edges: exact on spheres"),
    ("FIT", "Fit", "No weight: a surface is fitted to two rings of neighbors"),
    ("AUTO", "Automatic", "Planes, fits and weights, chosen at each vertex"),
)
CREASES = (
    ("AUTO", "Automatic", "Edge by edge, from the planes on both sides: no angle to choose"),
    ("ANGLE", "By angle", "Edges bent more than the crease angle stay sharp"),
)


class SeamOptions:
    """Annotations are inherited: operators and the scene's settings have the same properties."""

    normals: EnumProperty(name="Normals", items=NORMALS, default="SEAMS")
    crease: EnumProperty(name="Creases", description="Which edges stay sharp", items=CREASES, default="AUTO")
    crease_angle: FloatProperty(
        name="Crease Angle", description="Edges bent more than this stay sharp",
        subtype="ANGLE", default=math.radians(60), min=0, max=math.pi)
    weight: EnumProperty(name="Weight", description="How a triangle pulls on a normal", items=WEIGHTS, default="AUTO")
    border_distance: FloatProperty(
        name="Border Distance", subtype="DISTANCE", default=0, min=0, soft_max=1, precision=5,
        description="Normals also agree along borders of different objects at most this far apart that share no vertices; 0: off")
    weld_distance: FloatProperty(
        name="Weld Distance", subtype="DISTANCE", default=0, min=0, soft_max=1, precision=6,
        description="Vertices of different objects at most this far apart count as one place; 0: equal but for rounding")

    def arguments(self, rounding=0.0):
        """The options of `rakelight smooth`; `rounding`: what the weld distance is where none is set, 0: the program's own."""
        words = ["--normals", self.normals.lower()]
        if self.normals != "SEAMS" or self.border_distance > 0:
            words += ["--weight", self.weight.lower().replace("_", "-")]
        words += ["--crease-angle", repr(min(180.0, math.degrees(self.crease_angle))), "--crease", self.crease.lower()]
        if self.border_distance > 0:
            words += ["--border-distance", repr(self.border_distance)]
        weld = self.weld_distance or rounding
        if weld > 0:
            words += ["--weld-distance", repr(weld)]
        return words

    def draw_options(self, layout):
        layout.label(text="Normals:")
        layout.prop(self, "normals", text="")
        layout.prop(self, "crease")
        angle = layout.row()
        angle.enabled = self.crease == "ANGLE" or self.border_distance > 0
        angle.prop(self, "crease_angle")
        layout.prop(self, "border_distance")

    def draw_details(self, layout):
        layout.prop(self, "weight")
        layout.prop(self, "weld_distance")


class FixOptions(SeamOptions):
    keep_instances: BoolProperty(
        name="Keep Instances", default=False,
        description="Objects that share a mesh go on sharing it, with the normals of the first; "
                    "else those that touch different things get a mesh of their own")
    apply_modifiers: BoolProperty(
        name="Apply Modifiers", default=False,
        description="Apply all visible modifiers but Armature first, so that the shown surface is what gets the normals")

    def draw_details(self, layout):
        super().draw_details(layout)
        layout.prop(self, "keep_instances")
        layout.prop(self, "apply_modifiers")


class Settings(FixOptions, bpy.types.PropertyGroup):
    """The sidebar's options, kept with the scene."""

    def pass_on(self, button):
        """To the operator behind a button, as far as it has them."""
        for name in self.bl_rna.properties.keys():
            if name in button.bl_rna.properties and name not in ("rna_type", "name"):
                setattr(button, name, getattr(self, name))


class Preferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: StringProperty(
        name="Program", subtype="FILE_PATH",
        description="The program rakelight; empty: it is looked for on the PATH")

    def draw(self, context):
        from . import program

        self.layout.prop(self, "program")
        try:
            self.layout.label(text="Found: " + program.find(context), icon="CHECKMARK")
        except program.Failure as failure:
            self.layout.label(text=str(failure), icon="ERROR")
