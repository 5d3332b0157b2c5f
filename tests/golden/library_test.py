#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every golden scene has the same bytes by the program and by the library.  library_test.py PROGRAM EXAMPLE_SETTINGS"""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "tools/check"), str(ROOT / "tools/pictures")]
import golden  # noqa: E402


def settings_of(arguments):
    """The model, and the options as KEY=VALUE; those that stand alone as KEY."""
    model, settings, i = None, [], 0
    while i < len(arguments):
        word, i = arguments[i], i + 1
        if not word.startswith("--"):
            model = word
        elif "=" in word or i == len(arguments) or arguments[i].startswith("--") or arguments[i] == model:
            settings.append(word[2:])
        else:
            settings.append(word[2:] + "=" + arguments[i])
            i += 1
    return model, settings


def draw_by_library(example, row, folder):
    model, settings = settings_of(row["arguments"])
    settings.append("look=plain")
    if not any(s.startswith("resolution=") for s in settings):
        settings.append("resolution={},{}".format(*row["size"]))
    if "channel" in row:
        settings += ["channels=" + row["channel"], "channel-files=png"]
    subprocess.run([example, model, folder / "library.png", *settings], cwd=ROOT, check=True, stdin=subprocess.DEVNULL)
    return folder / ("library." + row["channel"] + ".png" if "channel" in row else "library.png")


def main():
    program, example = sys.argv[1:]
    rows, wrong = golden.read_scenes(ROOT / "tests/golden/scenes.json"), []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for row in rows:
            fault = golden.render(program, row, folder / "program.png")
            if fault:
                wrong.append(f"{row['name']}: {fault}")
            elif (folder / "program.png").read_bytes() != draw_by_library(example, row, folder).read_bytes():
                wrong.append(f"{row['name']}: program and library draw other bytes")
    print("\n".join(wrong) or f"{len(rows)} scenes have the same bytes by program and library")
    return 1 if wrong or len(rows) < 40 else 0


if __name__ == "__main__":
    sys.exit(main())
