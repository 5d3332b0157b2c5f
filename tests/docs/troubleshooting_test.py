#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""docs/troubleshooting.md quotes the program: each message there is made here. troubleshooting_test.py PROGRAM [unittest arguments]"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs/troubleshooting.md"
CORNERS = ((-60, -60, 0), (60, -60, 0), (60, 60, 0), (-60, 60, 0), (0, 0, 140))
FACES = ((0, 2, 1), (0, 3, 2), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4))
COMMANDS = (  # exit code, arguments, environment
    (2, "spot.glb", {}),
    (1, "view spot.glb", {}),
    (3, "missing.glb -o x.png", {}),
    (1, "part.dae -o x.png", {"ALONE": "yes"}),
    (2, "spot.glb -o x.png --resolutio 3,4", {}),
    (2, "spot.glb -o x.png", {"RAKELIGHT_ISA": "avx9"}),
    (4, "cut.glb -o x.png", {}),
    (4, "text.glb -o x.png", {}),
    (4, "model.txt -o x.png", {}),
    (4, "empty.obj -o x.png", {}),
    (4, "spot.glb -o x.png --max-memory 100K", {}),
    (0, "model.obj -o x.png", {}),
    (0, "part.obj -o x.png", {}),
    (2, "spot.glb -o x.bmp", {}),
    (2, "smooth part.stl -o out.stl", {}),
    (2, "smooth spot.glb -o out.fbx", {}),
    (1, "spot.glb -o /proc/x.png", {}),
    (5, "inspect spot.glb --check", {}),
    (2, "spot.glb -o x.png --camera-index 3", {}),
    (2, "spot.glb -o x.png --animation-name walk", {}),
)


def stl():
    """A pyramid that stands on a base, Z up, as CAD programs write it."""
    facets = ("facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % CORNERS[corner] for corner in face) + "endloop\nendfacet\n" for face in FACES)
    return "solid part\n" + "".join(facets) + "endsolid part\n"


def obj():
    """The same pyramid."""
    return "".join("v %g %g %g\n" % corner for corner in CORNERS) + "".join("f %d %d %d\n" % tuple(k + 1 for k in face) for face in FACES)


class Troubleshooting(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        spot = (ROOT / "data/spot/spot_slab5.glb").read_bytes()
        for name, content in {"spot.glb": spot, "cut.glb": spot[:1000], "text.glb": b"<html>not found</html>\n", "model.txt": b"hello\n", "empty.obj": b"v 0 0 0\n",
                              "model.obj": b"mtllib no.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n", "part.stl": stl().encode(), "part.dae": b"<COLLADA><asset/></COLLADA>", "part.obj": obj().encode()}.items():
            (self.folder / name).write_bytes(content)

    def run_command(self, arguments, settings):
        environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY", "RAKELIGHT_IMPORT", "RAKELIGHT_ISA")} | settings
        program = PROGRAM
        if environment.pop("ALONE", None):
            program = shutil.copy(PROGRAM, self.folder / "alone")
        if "-o x.png" in arguments:
            arguments += " --resolution 32,32"
        return subprocess.run([program, *arguments.split()], cwd=self.folder, env=environment, capture_output=True, text=True, stdin=subprocess.DEVNULL)

    def test_each_message_of_the_page_is_made_by_a_command(self):
        said = []
        for code, arguments, settings in COMMANDS:
            done = self.run_command(arguments, settings)
            with self.subTest(arguments=arguments):
                self.assertEqual(done.returncode, code, done.stderr)
            said += done.stderr.splitlines()
        quoted = re.findall(r"^ {4}(rakelight: .*)$", PAGE.read_text(), re.M)
        self.assertGreaterEqual(len(quoted), len(COMMANDS))
        for message in quoted:
            with self.subTest(message=message):
                self.assertIn(message, said)


if __name__ == "__main__":
    PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
