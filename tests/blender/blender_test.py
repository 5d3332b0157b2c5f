#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The add-on as a zip, installed into a Blender without settings of its own, and its tests in there.

  blender_test.py BLENDER RAKELIGHT [TEST...]"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def main():
    blender, program, *tests = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        zips = [os.path.join(folder, name) for name in ("one.zip", "two.zip")]
        for path in zips:
            subprocess.run([sys.executable, HERE.parents[1] / "blender/make_zip.py", path], check=True, stdout=subprocess.DEVNULL)
        one, two = (pathlib.Path(path).read_bytes() for path in zips)
        if one != two:
            sys.exit("two zips of the same sources differ")
        # A distribution's Blender takes the first python3 of its version in the PATH: that beside it has the numpy it was built for.
        paths = os.pathsep.join([os.path.dirname(shutil.which(blender)), os.environ["PATH"]])
        environment = {**os.environ, "PATH": paths, "BLENDER_USER_RESOURCES": os.path.join(folder, "user"), "TMPDIR": folder}
        done = subprocess.run(
            [blender, "--background", "--factory-startup", "--python-exit-code", "1", "--python", HERE / "in_blender.py", "--",
             os.path.abspath(program), zips[0], *tests],
            env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        print(done.stdout)
        left = [name for name in os.listdir(folder) if name.startswith("rakelight-")]
        # Blender's exit code alone is not believed: what ends it early may end it well.
        if done.returncode != 0 or "blender tests passed" not in done.stdout or left:
            sys.exit(f"exit code {done.returncode}; left behind: {left}")


if __name__ == "__main__":
    main()
