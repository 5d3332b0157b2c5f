#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Which lists of tools/package/packages.txt the commands of ./dev install, and when: seen with programs that stand in for dpkg-query, apt-get, cmake and what
comes after them. tests/packages/readme.sh does it in a bare Debian."""
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
STAND_IN = '#!/bin/bash\necho "${0##*/} $*" >>"$LOG"\n'
STAND_INS = {"dpkg-query": '[ -e "$INSTALLED/${@: -1}" ] && echo installed\n', "id": "echo ${USER_ID:-0}\n", "sudo": '"$@"\n'}
NAMES = ("apt-get", "cmake", "ctest", "python3", "mkdocs", "git", "clang-format", "ldconfig", "env")


def lists():
    """Name of each list -> its packages."""
    found, name = {}, None
    for line in (ROOT / "tools/package/packages.txt").read_text().splitlines():
        if line.startswith("["):
            name = line.strip("[]")
            found[name] = []
        elif line and not line.startswith("#"):
            found[name].append(line)
    return found


class Setup(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        for name in ("bin", "installed", "root/tools/package", "root/tools/pictures"):
            (self.folder / name).mkdir(parents=True)
        for name in ("dev", "tools/package/packages.txt"):
            shutil.copy2(ROOT / name, self.folder / "root" / name)
        (self.folder / "root/tools/pictures/demo.sh").write_text("")
        for name in (*NAMES, *STAND_INS):
            self.stand_in(name)

    def stand_in(self, name):
        file = self.folder / "bin" / name
        file.write_text(STAND_INS[name].join(["#!/bin/bash\n", ""]) if name in ("dpkg-query", "id") else STAND_IN + STAND_INS.get(name, ""))
        file.chmod(0o755)

    def dev(self, *words, **environment):
        """What ./dev WORDS calls, one line each."""
        log = self.folder / "log"
        log.write_text("")
        for tool in ("bash", "readlink", "dirname", "nproc", "mkdir", "cat", "grep", "xargs"):
            target = self.folder / "bin" / tool
            if not target.exists():
                target.symlink_to(shutil.which(tool))
        self.done = subprocess.run([shutil.which("bash"), self.folder / "root/dev", *words], capture_output=True, text=True,
                                   env={"PATH": str(self.folder / "bin"), "LOG": str(log), "INSTALLED": str(self.folder / "installed"), **environment})
        return log.read_text().splitlines()

    def installed(self, calls):
        return [word for call in calls if "apt-get install" in call for word in call.split() if not word.startswith("-") and "=" not in word and word not in ("apt-get", "install", "env", "sudo")]

    def test_each_command_installs_its_lists_before_it_configures(self):
        known = lists()
        for words, wanted in [(["install", str(self.folder / "prefix")], ["program", "viewer"]), (["build", "package"], ["program", "viewer"]),
                              (["demo"], ["program", "viewer"]), (["reproduce"], ["program", "viewer", "gl"]), (["build"], ["program", "viewer", "gl", "tests"]),
                              (["build", "deb"], ["program", "viewer", "python"]), (["test"], ["program", "viewer", "gl", "tests"]), (["docs"], ["docs"]), (["format"], ["format"]),
                              (["setup"], ["program", "viewer", "python", "gl", "tests"]), (["setup", "wheel"], ["wheel"])]:
            with self.subTest(words=words):
                calls = self.dev(*words)
                self.assertEqual(self.done.returncode, 0, self.done.stderr)
                self.assertEqual(set(self.installed(calls)), {package for name in wanted for package in known[name]})
                names = [call.split()[0] for call in calls if not call.startswith("env ")]
                self.assertEqual(names[:1], ["apt-get"])
                if words != ["reproduce"]:  # that asks twice
                    self.assertNotIn("apt-get", names[2:])

    def test_what_is_there_is_not_installed(self):
        for package in lists()["docs"]:
            (self.folder / "installed" / package).touch()
        self.assertEqual(self.installed(self.dev("docs")), [])
        (self.folder / "installed/doxygen").unlink()
        self.assertEqual(self.installed(self.dev("docs")), ["doxygen"])

    def test_users_who_are_not_root_go_through_sudo_or_are_told(self):
        calls = self.dev("setup", "docs", USER_ID="1000")
        self.assertTrue(any(call.startswith("sudo ") and "apt-get install" in call for call in calls))
        (self.folder / "bin/sudo").unlink()
        self.dev("setup", "docs", USER_ID="1000")
        self.assertEqual(self.done.returncode, 1)
        self.assertIn("dev: run as root: apt-get update", self.done.stderr)

    def test_a_prefix_of_the_users_own_needs_no_root(self):
        for package in [package for name in ("program", "viewer") for package in lists()[name]]:
            (self.folder / "installed" / package).touch()
        calls = self.dev("install", str(self.folder / "prefix"), USER_ID="1000")
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertEqual([call for call in calls if call.startswith(("sudo", "ldconfig"))], [])
        self.assertIn(f"cmake --install build/package --prefix {self.folder / 'prefix'}", calls)

    def test_without_apt_the_configuration_goes_on(self):
        (self.folder / "bin/apt-get").unlink()
        self.assertIn("cmake --preset package", self.dev("build", "package"))
        self.assertIn("no Debian", self.done.stderr)

    def test_an_unknown_list_is_an_error(self):
        self.assertEqual(self.dev("setup", "everything"), [])
        self.assertEqual(self.done.returncode, 2)

    def test_pages_and_recipes_name_lists_that_exist(self):
        known = set(lists())
        for path in ("packages/container/Containerfile", ".github/workflows/ci.yml", ".ci/run", "docs/install.md", "docs/python.md", "docs/uninstall.md", "CONTRIBUTING.md"):
            for words in re.findall(r"\./dev setup((?: [a-z]+)*)", (ROOT / path).read_text()):
                self.assertLessEqual({word for word in words.split() if word not in ("and", "installed", "installs")}, known, path)


if __name__ == "__main__":
    unittest.main()
