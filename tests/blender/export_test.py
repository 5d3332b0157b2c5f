# SPDX-License-Identifier: Apache-2.0
"""The export through the program: seam-free files, skins and clips as Blender's exporter writes them."""
import json
import os
import struct
import subprocess
import tempfile
import unittest

import bpy
import program
import scenes
from fix_seams_test import halves


def document(path):
    with open(path, "rb") as file:
        data = file.read()
    return json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])


def is_seamless(path):
    done = subprocess.run([program.PATH, "inspect", path, "--check", "--max-seam", "0.1"], capture_output=True)
    assert done.returncode in (0, 5), done
    return done.returncode == 0


class Export(unittest.TestCase):
    def setUp(self):
        scenes.clear()
        scenes.set_program(program.PATH)
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = os.path.join(self.folder.name, "out.glb")

    def test_a_file_without_seams_with_tangents(self):
        objects = halves()
        for item in objects:
            layer = item.data.uv_layers.new(name="map")
            for loop, corner in zip(item.data.loops, layer.data):
                corner.uv = item.data.vertices[loop.vertex_index].co.xy
        other = scenes.add("other", objects[0].data)
        before = [scenes.state(item) for item in objects]
        scenes.select(objects)
        plain = os.path.join(self.folder.name, "plain.glb")
        bpy.ops.export_scene.gltf(filepath=plain, use_selection=True)
        self.assertFalse(is_seamless(plain))
        bpy.ops.rakelight.export_glb(filepath=self.path, tangents="ALWAYS")
        self.assertTrue(is_seamless(self.path))
        written = document(self.path)
        self.assertEqual(sorted(node["name"] for node in written["nodes"]), ["lower", "upper"])
        self.assertTrue(all("TANGENT" in mesh["primitives"][0]["attributes"] for mesh in written["meshes"]))
        self.assertEqual([scenes.state(item) for item in objects], before)
        self.assertFalse(other.select_get())

    def rigged(self):
        """Both halves of a sphere on one armature of two bones, with a clip."""
        objects = halves()
        rig = scenes.add("rig", bpy.data.armatures.new("rig"))
        scenes.select([rig])
        bpy.ops.object.mode_set(mode="EDIT")
        rig.data.edit_bones.new("bone").tail = (0, 0, 1)
        rig.data.edit_bones.new("still").tail = (1, 0, 0)
        bpy.ops.object.mode_set(mode="OBJECT")
        for item in objects:
            for name, sign in (("bone", 1), ("still", -1)):
                group = item.vertex_groups.new(name=name)
                for vertex in item.data.vertices:
                    group.add([vertex.index], (1 + sign * vertex.co.z) / 2, "REPLACE")
            item.modifiers.new("rig", "ARMATURE").object = rig
            item.parent = rig
        bone = rig.pose.bones["bone"]
        for frame, height in ((1, 0), (10, 1)):
            bone.location.y = height
            bone.keyframe_insert("location", frame=frame)
        return objects, rig

    def test_skins_and_clips_stay(self):
        objects, rig = self.rigged()
        scenes.select(objects)
        bpy.ops.rakelight.export_glb(filepath=self.path)
        self.assertFalse(rig.select_get())
        self.assertTrue(is_seamless(self.path))
        written = document(self.path)
        self.assertEqual(len(written["skins"]), 1)
        self.assertEqual(len(written["animations"]), 1)
        self.assertTrue(all("JOINTS_0" in mesh["primitives"][0]["attributes"] for mesh in written["meshes"]))

    def test_rigged_fbx_is_fixed_between_import_and_export(self):
        def read(path):
            scenes.clear()
            scenes.set_program(program.PATH)
            bpy.ops.preferences.addon_enable(module="io_scene_fbx")
            bpy.ops.import_scene.fbx(filepath=path)
            return [item for item in bpy.data.objects if item.type == "MESH"]

        bpy.ops.preferences.addon_enable(module="io_scene_fbx")
        self.rigged()
        cut, fixed = (os.path.join(self.folder.name, name) for name in ("cut.fbx", "fixed.fbx"))
        bpy.ops.export_scene.fbx(filepath=cut)
        objects = read(cut)
        self.assertGreater(scenes.seams(objects).max(), 10)
        scenes.select(objects)
        bpy.ops.rakelight.fix_seams()
        bpy.ops.export_scene.fbx(filepath=fixed)
        objects = read(fixed)
        self.assertLess(scenes.seams(objects).max(), 0.1)
        for item in objects:
            self.assertEqual([m.type for m in item.modifiers], ["ARMATURE"])
            self.assertEqual(sorted(group.name for group in item.vertex_groups), ["bone", "still"])

    def test_a_name_without_the_ending_gets_it(self):
        scenes.select(halves())
        bpy.ops.rakelight.export_glb(filepath=self.path[: -len(".glb")])
        self.assertEqual(os.listdir(self.folder.name), ["out.glb"])
        self.assertTrue(is_seamless(self.path))

    def test_no_file_name_is_said_before_anything_is_written(self):
        scenes.select(halves())
        for path in ("", self.folder.name + os.sep, os.path.join(self.folder.name, ".glb")):
            with self.assertRaisesRegex(RuntimeError, "No file name"):
                bpy.ops.rakelight.export_glb(filepath=path)
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_a_failure_leaves_the_old_file(self):
        with open(self.path, "w") as file:
            file.write("old")
        scenes.select(halves())
        scenes.set_program("/bin/false")
        with self.assertRaisesRegex(RuntimeError, "exit code 1"):
            bpy.ops.rakelight.export_glb(filepath=self.path)
        with open(self.path) as file:
            self.assertEqual(file.read(), "old")

    def test_a_place_that_cannot_be_written(self):
        scenes.select(halves())
        with self.assertRaisesRegex(RuntimeError, "No such file or directory"):
            bpy.ops.rakelight.export_glb(filepath=os.path.join(self.folder.name, "nowhere", "out.glb"))
