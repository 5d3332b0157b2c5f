#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tools/check/check_docs.py must notice what it is there for."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DEV = 'echo unrelated) \ncase "$command" in\nbuild) build ;;\ntest) run ;;\nesac\n'
PROGRAM = """#!/bin/sh
if [ "$1" = --help ]; then printf 'Subcommands:\\n  render   draws\\n\\nExamples:\\n  rakelight render here.obj\\n'; exit 0; fi
case "$*" in *five*) exit 5 ;; esac
if [ "$1" = compare ]; then test -f "$2" && ls "$3"/*.png > /dev/null; exit; fi
if [ "$2" = --help ]; then printf 'Examples:\\n  rakelight render %s \\\\\\n      -o out.png\\n' "$EXAMPLE"; exit 0; fi
case "$2" in *.obj) test -e "$2" || exit 3 ;; *) echo "usage: $2" >&2; exit 2 ;; esac
"""


class CheckDocs(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = pathlib.Path(temporary.name)
        (self.root / "docs").mkdir()
        (self.root / "docs/page.md").write_text("# One page\n## Second *part* of it\n")
        (self.root / "dev").write_text(DEV)
        (self.root / "here.obj").write_text("v 0 0 0\n")
        self.program = self.root / "program"
        self.program.write_text(PROGRAM)
        self.program.chmod(0o755)

    def check(self, text, program=False, example="here.obj"):
        """(exit code, standard error) for a README with this text."""
        (self.root / "README.md").write_text(text)
        done = subprocess.run([sys.executable, ROOT / "tools/check/check_docs.py", "--root", self.root] + (["--program", self.program] if program else []),
                              capture_output=True, text=True, env={"EXAMPLE": example, "PATH": "/usr/bin:/bin"})
        return done.returncode, done.stderr

    def test_links_to_files_headings_and_other_sites_are_right(self):
        self.assertEqual(self.check("[a](docs/page.md) [b](docs/page.md#second-part-of-it) [c](#top) [d](https://example.org)\n# Top\n"), (0, ""))

    def test_links_to_nothing_are_faults(self):
        self.assertIn("no such file", self.check("![picture](docs/picture.png)")[1])
        self.assertIn("no such heading", self.check("[b](docs/page.md#third)")[1])

    def test_paths_in_backticks_must_exist(self):
        self.assertEqual(self.check("`docs/page.md`, `docs/*.md`, `docs/`, `other/page.md`"), (0, ""))
        self.assertIn("docs/gone.md", self.check("see `docs/gone.md`")[1])
        self.assertIn("docs/*.txt", self.check("see `docs/*.txt`")[1])

    def test_source_files_and_functions_in_backticks_must_exist(self):
        for path, text in {"src/one/view.h": "namespace a {\nint look_at();\n}", "src/two/list.h": "", "src/three/list.h": "", "include/a/list.h": "", "build/gone.h": ""}.items():
            (self.root / path).parent.mkdir(parents=True, exist_ok=True)
            (self.root / path).write_text(text)
        (self.root / "src/two/README.md").write_text("`list.h`, `view.h`, `one/view.h`\n")
        self.assertEqual(self.check("`look_at()` (`view.h`), `a::look_at()` in `one/view.h`, `view.h`: `look_at()`, `two/list.h`; `*.h` `list.hpp`"), (0, ""))
        self.assertIn("`gone.h`: there is no file", self.check("`gone.h`")[1])
        self.assertIn("`two/view.h`: there is no file", self.check("`two/view.h`")[1])
        self.assertIn("`list.h`: may be include/a/list.h or src/three/list.h", self.check("`list.h`")[1])
        for text in ("`look_from()` (`view.h`)", "`look_from()` in `view.h`", "`view.h`: `look_from()`"):
            self.assertIn("`look_from()` is not in src/one/view.h", self.check(text)[1])

    def test_functions_in_backticks_must_be_defined_or_declared(self):
        sources = {"src/view.cpp": "namespace n {\nstd::vector<int> View::look_at(int a) {\n    return look_from(a);\n}\n}\n", "include/a/list.h": "class RL_API View {\n    RL_API void turn() const;\n};\n",
                   "src/light.glsl": "RL_FN real fall_off(real d)\n", "python/a/__init__.py": "class Scene:\n    def smooth(self):\n        look_back()\n", "python/src/bind.cpp": '    m.def("load", &load);\n',
                   "tests/one/turn_test.py": "def run_twice():\n    pass\n", "build/gone.cpp": "void gone() {}\n"}
        for path, text in sources.items():
            (self.root / path).parent.mkdir(parents=True, exist_ok=True)
            (self.root / path).write_text(text)
        self.assertEqual(self.check("`look_at()`, `n::View::turn()`, `fall_off()`, `scene.smooth()`, `load()`, `find_package()`, `look_from(a)`"), (0, ""))
        for name in ("look_from", "look_back", "gone", "run_twice"):
            self.assertIn(f"`{name}()`: no source defines a function of that name", self.check(f"`{name}()`")[1])
        self.assertIn("`Turner::turn()`: no source defines a class of that name", self.check("`Turner::turn()`")[1])
        (self.root / "docs/page.md").write_text("`look_from()`\n")
        self.assertIn("docs/page.md: `look_from()`", self.check("")[1])
        (self.root / "docs/page.md").write_text("")
        (self.root / "tests/one/README.md").write_text("`run_twice()`\n")
        self.assertEqual(self.check(""), (0, ""))

    def test_dev_commands_must_exist(self):
        self.assertEqual(self.check("```\n./dev build  # builds\n./dev test\n```\n"), (0, ""))
        self.assertIn("./dev fly", self.check("```\n./dev fly\n```\n")[1])
        self.assertIn("./dev unrelated", self.check("run `./dev unrelated`")[1])

    def test_commands_of_the_program_must_run(self):
        self.assertEqual(self.check("```\nrakelight render here.obj\nbuild/release/rakelight render \\\n  here.obj  # words\n```\n", True), (0, ""))
        code, errors = self.check("```\nrakelight render --no-such-option\n```\n", True)
        self.assertEqual(code, 1)
        self.assertIn("usage: --no-such-option", errors)

    def test_indented_commands_must_run_but_synopses_need_not(self):
        self.assertEqual(self.check("words\n\n    rakelight render here.obj \\\n        --window 1,2\n\n    rakelight render MODEL -o PICTURE --a b|c [--d]\n", True), (0, ""))
        code, errors = self.check("words\n\n    rakelight render --no-such-option\n", True)
        self.assertEqual(code, 1)
        self.assertIn("usage: --no-such-option", errors)
        self.assertIn("#aa0000", self.check("    rakelight render five.obj --line-color '#aa0000'\n", True)[1])

    def test_examples_of_the_help_must_run(self):
        code, errors = self.check("", True, example="--gone")
        self.assertEqual(code, 1)
        self.assertIn("rakelight render --help: rakelight render --gone", errors)

    def test_a_check_may_find_something(self):
        self.assertEqual(self.check("```\nrakelight inspect five --check\n```\n", True), (0, ""))
        self.assertIn("exit code 5", self.check("```\nrakelight inspect five\n```\n", True)[1])

    def test_compare_has_pictures_and_folders_of_pictures_to_work_on(self):
        (self.root / "data/maps").mkdir(parents=True)
        (self.root / "data/maps/brick_height.png").write_bytes(b"a picture")
        self.assertEqual(self.check("```\nrakelight compare before.png after/ -o out.png\n```\n", True), (0, ""))
        self.assertEqual(self.check("```\nrakelight compare before.jpg after/\n```\n", True)[0], 1)

    def test_a_program_that_is_not_there_is_a_fault(self):
        self.program.unlink()
        self.assertEqual(self.check("", True)[0], 1)


if __name__ == "__main__":
    unittest.main()
