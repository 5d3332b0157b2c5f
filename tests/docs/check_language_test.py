#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tools/check/check_language.py must notice what it is there for, and pass what is no prose."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LONG = " ".join(["word"] * 36)
SHORT = " ".join(["word"] * 35)


class CheckLanguage(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = pathlib.Path(temporary.name)
        (self.root / "docs").mkdir()
        (self.root / "include").mkdir()

    def check(self, text, name="README.md"):
        """Standard error for a file with this text; empty when the check passes."""
        (self.root / name).write_text(text)
        done = subprocess.run([sys.executable, ROOT / "tools/check/check_language.py", "--root", self.root], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1 if done.stderr else 0)
        return done.stderr

    def test_a_sentence_may_have_35_words(self):
        self.assertEqual(self.check(f"A {SHORT[5:]}. Then {SHORT[5:]}.\n"), "")

    def test_a_longer_sentence_is_a_finding_with_its_line(self):
        self.assertIn("README.md:3: a sentence of 36 words", self.check(f"# Heading\n\nThen {LONG[5:]}.\n"))
        self.assertIn("README.md:2: a sentence of 36 words", self.check(f"Short.\nThen {LONG[5:60]}\n{LONG[60:]}.\n"))

    def test_pages_in_folders_of_docs_and_comments_of_headers_are_checked(self):
        self.assertIn("docs/page.md:1:", self.check(f"{LONG}.\n", "docs/page.md"))
        self.assertIn("include/a.h:1:", self.check(f"// {LONG}.\n", "include/a.h"))
        self.assertIn("include/a.h:2:", self.check(f"struct A {{\n    int a;  ///< {LONG[:50]}\n            ///< {LONG[50:]}.\n}};\n", "include/a.h"))

    def test_list_items_and_comments_of_fields_do_not_run_together(self):
        self.assertEqual(self.check("".join(f"- {SHORT[:60]}\n" for _ in range(9))), "")
        self.assertEqual(self.check("struct A {\n" + "".join(f"    int a;  ///< {SHORT[:60]}\n" for _ in range(9)) + "};\n", "include/a.h"), "")

    def test_what_is_no_prose_passes(self):
        self.assertEqual(self.check(f"```\n{LONG}\n```\n\n    {LONG}\n\n| {LONG} |\n\n- `--option` {LONG}\n\n`{LONG}` and [{SHORT[:40]}](docs/{'a' * 99}.md).\n"), "")
        self.assertEqual(self.check(f"/// Short.\n///\n///     {LONG}\n/// Source: {LONG}\n", "include/a.h"), "")
        self.assertEqual(self.check(f"{LONG}.\n", "docs/command-line.md"), "")

    def test_private_phrases_are_findings_with_the_usual_term(self):
        self.assertIn("README.md:2: \"not to be told from\": the usual term is indistinguishable", self.check("The pictures\nare not to be told\nfrom each other.\n"))


if __name__ == "__main__":
    unittest.main()
