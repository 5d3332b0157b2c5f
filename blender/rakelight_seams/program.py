# SPDX-License-Identifier: Apache-2.0
"""The program `rakelight`: where it is, a run of `rakelight smooth`, and its errors as one line."""
import json
import os
import shutil
import subprocess
import tempfile

import bpy


class Failure(Exception):
    """One line for the user: file, place, reason."""


def find(context):
    """The path of the program. Throws Failure with what to do where there is none."""
    add_on = context.preferences.addons.get(__package__)  # none with `blender --addons`, which keeps no preferences
    path = add_on.preferences.program if add_on else ""
    if path:
        path = bpy.path.abspath(path)
        if not (os.path.isfile(path) and os.access(path, os.X_OK)):
            raise Failure(f"{path}: not a program; Preferences > Add-ons > Rakelight Seams has its path")
        return path
    path = shutil.which("rakelight")
    if not path:
        raise Failure("The program rakelight is not on the PATH; install it, or set its path in Preferences > Add-ons > Rakelight Seams")
    return path


class Smooth:
    """A run of `rakelight smooth` from `source` to `target` in a process of its own. All its files lie in `folder`."""

    def __init__(self, program, folder, source, target, arguments):
        self.source, self.target = source, target
        self.output = tempfile.TemporaryFile(dir=folder)
        self.errors = tempfile.TemporaryFile(dir=folder)
        words = [program, "smooth", source, "-o", target, "--json", "--quiet", *arguments]
        flags = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # Windows opens a console otherwise
        try:
            self.process = subprocess.Popen(
                words, stdin=subprocess.DEVNULL, stdout=self.output, stderr=self.errors, creationflags=flags)
        except OSError as error:
            self.close()
            raise Failure(f"{program}: cannot be run: {error.strerror or error}") from None

    def is_done(self):
        return self.process.poll() is not None

    def stop(self):
        if not self.is_done():
            self.process.kill()
        self.process.wait()
        self.close()

    def close(self):
        self.output.close()
        self.errors.close()

    def result(self):
        """Waits for the end. What the program says of the file (`rows[0]` of its JSON), if all went well; throws Failure if not."""
        code = self.process.wait()
        self.output.seek(0)
        self.errors.seek(0)
        text, errors = self.output.read(), self.errors.read().decode("utf-8", "replace").strip()
        self.close()
        row = first_row(text)
        if code != 0 or "error" in row:
            raise Failure(describe(row.get("error"), errors, code))
        if not os.path.isfile(self.target):
            raise Failure("rakelight wrote no file")
        return row


def first_row(text):
    try:
        row = json.loads(text.decode("utf-8", "replace"))["rows"][0]
        return row if isinstance(row, dict) else {}
    except (ValueError, KeyError, IndexError, TypeError):
        return {}


def remarks(row):
    """The messages of the program's notes and warnings."""
    return [remark.get("message", "") if isinstance(remark, dict) else str(remark) for remark in row.get("remarks", [])]


def kept_flat(row):
    """What is said of borders that were left as they are because both sides are shaded hard there; empty: there are none."""
    seams = row.get("seams")
    flat, creases = (seams.get(name) or 0 if isinstance(seams, dict) else 0 for name in ("flat_pairs", "crease_pairs"))
    count = flat + creases
    if not count:
        return ""
    where = "of two objects" if creases else "between flat faces of two objects"
    edges = f"1 {'hard ' if creases else ''}edge {where} keeps its" if count == 1 else f"{count} {'hard ' if creases else ''}edges {where} keep their"
    return f"{edges} seam; to smooth across it, choose Normals: Whole model"


def describe(error, errors, code):
    """One line from the program's own error, else from what it wrote last."""
    if isinstance(error, dict) and error.get("message"):
        place = error.get("place")
        return f"rakelight: {place + ': ' if place else ''}{error['message']}"
    if errors:
        return errors.splitlines()[-1]
    return f"rakelight ended with {'signal ' + str(-code) if code < 0 else 'exit code ' + str(code)}"
