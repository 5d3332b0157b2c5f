#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the reference of the public headers by Doxygen (tools/package/api.doxyfile).

  api.py [build/api]

Exit code 1 with a line for each thing that Doxygen warns of: a public name without a comment, a parameter that is not there, ..."""
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/api").resolve()
    shutil.rmtree(folder / "html", ignore_errors=True)
    folder.mkdir(parents=True, exist_ok=True)
    settings = (ROOT / "tools/package/api.doxyfile").read_text() + f'\nOUTPUT_DIRECTORY = "{folder}"\nWARN_LOGFILE = "{folder}/warnings.txt"\n'
    subprocess.run(["doxygen", "-"], cwd=ROOT, input=settings, text=True, check=True)
    warnings = sorted(set((folder / "warnings.txt").read_text().replace(f"{ROOT}/", "").splitlines()))
    for warning in warnings:
        print(f"api: {warning}", file=sys.stderr)
    print(f"api: {len(list((folder / 'html').glob('*.html')))} pages, {len(warnings)} warnings")
    sys.exit(1 if warnings else 0)


if __name__ == "__main__":
    main()
