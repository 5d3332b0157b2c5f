# SPDX-License-Identifier: Apache-2.0
"""What the tests of the program share: running it in a folder of its own, and reading 8-bit PNG files. Standard library only."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[3] / "tools/pictures"))
import png8  # noqa: E402

PROGRAM = ""  # main() sets it
SANITIZED = os.environ.get("RAKELIGHT_SANITIZED") == "1"

SQUARE = "o {name}\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"
TWO_PARTS = "o left\nv -1 0 0\nv 0 0 0\nv 0 1 0.5\nv -1 1 0\nf 1 2 3 4\no right\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nf 5 6 7 8\n"


class Result:
    def __init__(self, done):
        self.code, self.out, self.err = done.returncode, done.stdout, done.stderr
        self.lines = self.err.splitlines()


def png(path):
    """(width, height, channels, rows of bytes) of an 8-bit, non-interlaced PNG."""
    width, height, channels, pixels = png8.read_pixels(path)
    return width, height, channels, [pixels[at:at + width * channels] for at in range(0, len(pixels), width * channels)]


class Case(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="rakelight_cli_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def run_program(self, *arguments, **environment):
        """Pictures are plain ones, by the options alone, unless the test names a look."""
        draws = arguments[:1] in (("render",), ("explain",), ("stages",)) or (arguments[:1] == ("compare",) and "--engines" in arguments)
        if draws and "--look" not in arguments:
            arguments += ("--look", "plain")
        return Result(subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, timeout=300,
                                     stdin=subprocess.DEVNULL, env={**os.environ, **environment}))

    def write(self, name, text=None):
        path = self.folder / name
        path.write_text(SQUARE.format(name="square") if text is None else text)
        return path

    def files(self):
        return sorted(p.name for p in self.folder.iterdir())

    def wait_for(self, name):
        for _ in range(1200):
            if (self.folder / name).exists():
                return
            time.sleep(0.05)
        self.fail(f"{name} did not come")

    def check_refused(self, result, code, *words):
        """One line on standard error, nothing on standard output, the expected code."""
        self.assertEqual(result.code, code, result.err)
        self.assertEqual(len(result.lines), 1, result.err)
        self.assertTrue(result.err.startswith("rakelight: error: "), result.err)
        self.assertEqual(result.out, "")
        for word in words:
            self.assertIn(word, result.err)


def main():
    """Runs the tests of the file that calls it: FILE PROGRAM [unittest arguments]."""
    global PROGRAM
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
