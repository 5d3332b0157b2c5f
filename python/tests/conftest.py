# SPDX-License-Identifier: Apache-2.0
"""The program beside the module: both draw the same. RAKELIGHT_PROGRAM names it."""
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "data"
sys.path[:0] = [str(ROOT / "tests" / "cli" / "support"), str(ROOT / "tools" / "pictures"), str(ROOT / "tools" / "package")]

import exr  # noqa: E402
import png8  # noqa: E402

import rakelight  # noqa: E402


class Program:
    """Runs the program `rakelight`."""

    def __init__(self, path, folder):
        self.path, self.folder = path, folder

    def run(self, *words):
        done = subprocess.run([self.path, *map(str, words)], capture_output=True, text=True, cwd=self.folder)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def image(self, model, *options):
        """[H, W, 3 or 4] uint8 of the PNG file that it writes."""
        path = self.folder / "program.png"
        self.run("render", model, "-o", path, *options)
        width, height, channels, pixels = png8.read_pixels(path)
        return np.frombuffer(pixels, np.uint8).reshape(height, width, channels)

    def layers(self, model, *options):
        """{layer: [H, W]} of the EXR file that it writes: "R", "depth.Z", ..."""
        path = self.folder / "program.exr"
        self.run("render", model, "-o", path, "--channel-files", "layers", *options)
        types = {"f": np.float32, "I": np.uint32}
        return {name: np.array(rows, dtype=types[kind]) for name, (kind, rows) in exr.read(path)[2].items()}


@pytest.fixture
def program(tmp_path):
    path = os.environ.get("RAKELIGHT_PROGRAM")
    if not path:
        pytest.skip("RAKELIGHT_PROGRAM names no program")
    return Program(path, tmp_path)


@pytest.fixture(scope="session")
def teapot():
    return rakelight.load("builtin:teapot")


@pytest.fixture
def quad():
    """Two triangles in the plane z = 0."""
    return rakelight.Mesh(
        np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32), np.array([[0, 1, 2], [0, 2, 3]], np.uint32)
    )
