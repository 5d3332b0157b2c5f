#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tools/check/check_homes.py must notice functions away from home and crowded folders. Skipped, exit code 77, without Universal Ctags."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class CheckHomes(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = pathlib.Path(temporary.name)
        (self.root / "tools/check").mkdir(parents=True)
        shutil.copy(ROOT / "tools/check/check_homes.py", self.root / "tools/check")
        for folder in ("src", "include", "apps"):
            (self.root / folder).mkdir()

    def check(self):
        """(exit code, both outputs)"""
        done = subprocess.run([sys.executable, self.root / "tools/check/check_homes.py"], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def write(self, name, text):
        (self.root / "src" / name).write_text(f"namespace rakelight {{\n{text}\n}}\n")

    def test_a_function_at_home_passes(self):
        self.write("a.h", "int one();\nstruct A { int two(); };")
        self.write("a.cpp", "namespace { int own() { return 1; } }\nint one() { return own(); }\nint A::two() { return 2; }")
        self.assertEqual(self.check(), (0, "homes: 2 functions of headers, 0 (0.0 %) in sources of other names\n"))

    def test_a_function_in_a_source_of_another_name_is_found(self):
        self.write("a.h", "int one();")
        self.write("b.cpp", "int one() { return 1; }")
        code, text = self.check()
        self.assertEqual(code, 1)
        self.assertIn("100.0 % of the functions", text)

    def test_a_folder_of_more_than_40_files_is_found(self):
        for i in range(40):
            self.write(f"a{i}.h", "")
        self.assertEqual(self.check()[0], 0)
        self.write("b.h", "")
        self.assertIn("src: 41 files, more than 40", self.check()[1])


if __name__ == "__main__":
    if shutil.which("ctags") is None:
        print("skipped: ctags is not installed")
        sys.exit(77)
    unittest.main()
