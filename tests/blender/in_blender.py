# SPDX-License-Identifier: Apache-2.0
"""Runs in Blender: installs the zip as a user does, then the tests. After `--`: program, zip, names of tests or none."""
import os
import sys
import types
import unittest

import bpy

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
arguments = sys.argv[sys.argv.index("--") + 1 :]
sys.modules["program"] = types.SimpleNamespace(PATH=arguments[0])
bpy.ops.preferences.addon_install(filepath=arguments[1])
bpy.ops.preferences.addon_enable(module="rakelight_seams")

names = arguments[2:] or ["fix_seams_test", "failures_test", "export_test"]
result = unittest.TextTestRunner(verbosity=2).run(unittest.defaultTestLoader.loadTestsFromNames(names))
bpy.ops.preferences.addon_disable(module="rakelight_seams")
if not result.wasSuccessful() or result.testsRun == 0 or hasattr(bpy.types.Scene, "rakelight_seams"):
    sys.exit(1)
print("blender tests passed")
