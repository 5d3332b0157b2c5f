#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Each public name has a comment that Doxygen understands, and what tools/package/api_filter.py tells it. Exit code 77 (skipped) without doxygen."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


class Reference(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def filtered(self, text):
        (self.folder / "a.h").write_text(text)
        return subprocess.run([sys.executable, "-B", ROOT / "tools/package/api_filter.py", self.folder / "a.h"], capture_output=True, text=True, check=True).stdout

    def test_no_public_name_is_without_a_comment(self):
        done = subprocess.run([sys.executable, ROOT / "tools/package/api.py", self.folder], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        page = (self.folder / "html/structrakelight_1_1RenderSettings.html").read_text()
        self.assertIn("of the whole picture, 1..65536", page)

    def test_a_comment_goes_to_every_field_of_its_line(self):
        self.assertEqual(self.filtered("struct A {\n    int w = 0, h{1};  ///< [px]\n};\n"), "struct A {\n/** [px] */ int w = 0; /** [px] */ int h{1};\n};\n")
        self.assertEqual(self.filtered("struct A {\n    /// [m]\n    std::map<int, int> a{}, b{};\n};\n").count("/** [m] */"), 2)

    def test_fields_of_our_types_lead_to_them_and_others_stay_without(self):
        self.assertIn("/** See Report. */ std::vector<Report> all{};", self.filtered("struct A {\n    std::vector<Report> all{};\n};\n"))
        self.assertNotIn("/**", self.filtered("struct A {\n    int count = 0;\n    double length() const;\n};\n"))

    def test_lines_keep_their_numbers(self):
        for header in sorted((ROOT / "include/rakelight").rglob("*.h")):
            text = header.read_text()
            self.assertEqual(self.filtered(text).count("\n"), text.count("\n"), header)


if __name__ == "__main__":
    if shutil.which("doxygen") is None:
        print("skipped: doxygen is not there")
        sys.exit(77)
    unittest.main()
