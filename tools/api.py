#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the reference of the public headers: build/api/html, by Doxygen (tools/api.doxyfile).

Exit code 1 with a line for each thing that Doxygen warns of: a public name without a comment, a parameter that is not there, ..."""
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def main():
    folder = ROOT / "build/api"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    subprocess.run(["doxygen", "tools/api.doxyfile"], cwd=ROOT, check=True)
    warnings = sorted(set((folder / "warnings.txt").read_text().replace(f"{ROOT}/", "").splitlines()))
    for warning in warnings:
        print(f"api: {warning}", file=sys.stderr)
    print(f"api: {len(list((folder / 'html').glob('*.html')))} pages, {len(warnings)} warnings")
    sys.exit(1 if warnings else 0)


if __name__ == "__main__":
    main()
