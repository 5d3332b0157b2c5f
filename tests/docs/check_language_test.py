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
        for folder in ("docs", "include", "src/part", "apps/viewer/view", "apps/cli", "apps/other", "python/src", "bench"):
            (self.root / folder).mkdir(parents=True)

    def check(self, text, name="README.md"):
        """Standard error for a file with this text; empty when the check passes."""
        (self.root / name).write_text(text)
        done = subprocess.run([sys.executable, ROOT / "tools/check/check_language.py", "--root", self.root], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1 if done.stderr else 0)
        (self.root / name).unlink()
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

    def test_comments_of_sources_are_checked(self):
        for name in ("src/part/a.h", "src/part/b.cpp", "src/part/c.glsl", "apps/cli/a.cpp", "python/src/a.cpp"):
            with self.subTest(name):
                self.assertIn(f"{name}:2: a sentence of 36 words", self.check(f"int a;\n// {LONG}.\n", name))
                self.assertIn("the usual term is indistinguishable", self.check("int a;  // not to be told from b\n", name))
                self.assertEqual(self.check(f"int a;\n// {SHORT}.\n", name), "")
        self.assertEqual(self.check(f"// {LONG}.\n", "bench/a.cpp") + self.check(f"// {LONG}.\n", "src/part/a.txt"), "")

    def test_sentences_with_formulas_are_left_out_in_sources_only(self):
        for formula in ("a = b", "a^2", "a -> b", "a * b", "2 pi"):
            with self.subTest(formula):
                self.assertEqual(self.check(f"// {LONG} {formula}.\n", "src/part/a.cpp"), "")
                self.assertIn("a sentence of", self.check(f"// {formula}. Then {LONG}.\n", "src/part/a.cpp"))
                self.assertIn("a sentence of", self.check(f"// Then {LONG} {formula}.\n", "include/a.h"))
        self.assertIn("a sentence of", self.check(f"// {LONG} pixel.\n", "src/part/a.cpp"))

    def test_no_comment_of_the_viewer_and_the_command_line_begins_with_a_fragment(self):
        for word in ("What", "Of", "Where", "Likewise"):
            for name in ("apps/viewer/view/a.h", "apps/cli/a.cpp"):
                with self.subTest(word, name=name):
                    self.assertIn(f'{name}:2: a comment that begins with "{word}"', self.check(f"int a;\n/// {word} is drawn.\n", name))
                    self.assertIn(f'{name}:1: a comment that begins with "{word}"', self.check(f"int a;  ///< {word} is drawn.\n", name))
                    self.assertEqual(self.check(f"/// Drawn is\n/// {word} is drawn. {word} is it.\n/// {word}ever it is.\n", name), "")
        self.assertIn("begins with \"Likewise\"", self.check("// Likewise, a light.\n", "apps/cli/a.cpp"))
        for word in ("What", "Of", "Where", "Likewise"):
            self.assertEqual(self.check(f"// {word} is drawn.\n", "src/part/a.cpp") + self.check(f"// {word} is drawn.\n", "apps/other/a.cpp"), "")


if __name__ == "__main__":
    unittest.main()
