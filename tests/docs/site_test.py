#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The site builds without a warning and without a network, and the check of the site notices what it is there for. Exit code 77 (skipped) without mkdocs."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CHECK = [sys.executable, ROOT / "tools/check/check_site.py"]


def has_theme():
    return shutil.which("mkdocs") is not None and pathlib.Path("/usr/share/mkdocs/themes/material").exists()


class Site(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def check(self, body):
        (self.folder / "index.html").write_text(f"<html><body>{body}</body></html>")
        done = subprocess.run([*CHECK, self.folder], capture_output=True, text=True)
        return done.returncode, done.stderr

    def test_the_site_builds_and_each_page_is_in_its_navigation(self):
        copy = self.folder / "copy"
        shutil.copytree(ROOT / "docs", copy / "docs")
        shutil.copytree(ROOT / "tools", copy / "tools", ignore=shutil.ignore_patterns("__pycache__"))
        shutil.copy(ROOT / "mkdocs.yml", copy)
        (copy / "build/api/html").mkdir(parents=True)  # Doxygen's part has a check of its own: tools/package/api.py
        (copy / "build/api/html/index.html").write_text("<html></html>")
        done = subprocess.run(["unshare", "-rn", "mkdocs", "build", "--strict"] if self.can_unshare() else ["mkdocs", "build", "--strict"],
                              cwd=copy, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("WARNING", done.stderr)
        self.assertNotIn("not included in the \"nav\"", done.stderr)
        done = subprocess.run([*CHECK, copy / "build/docs"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    @staticmethod
    def can_unshare():
        return subprocess.run(["unshare", "-rn", "true"], capture_output=True).returncode == 0

    def test_good_pages_pass(self):
        self.assertEqual(self.check('<h1 id="top">T</h1><a href="#top">a</a><a href="https://example.org">b</a><p>1 - 2</p>'), (0, ""))

    def test_links_to_nothing_are_faults(self):
        self.assertIn("no such file", self.check('<a href="gone.html">a</a>')[1])
        self.assertIn("no such place", self.check('<a href="#gone">a</a>')[1])

    def test_pages_that_load_from_elsewhere_are_faults(self):
        self.assertIn("loads https://", self.check('<script src="https://example.org/a.js"></script>')[1])
        self.assertIn("loads //", self.check('<img src="//example.org/a.png">')[1])

    def test_markdown_that_was_not_understood_is_a_fault(self):
        self.assertIn("not understood", self.check("<p>words:\n- one\n- two</p>")[1])
        self.assertIn("not understood", self.check("<p>| a | b |</p>")[1])


if __name__ == "__main__":
    if not has_theme():
        print("skipped: mkdocs-material is not there")
        sys.exit(77)
    unittest.main()
