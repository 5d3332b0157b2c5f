#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the add-on as a zip that Blender installs. The same sources give the same bytes.

  make_zip.py [OUT.zip]"""
import pathlib
import sys
import zipfile

FOLDER = pathlib.Path(__file__).resolve().parent
NAME = "rakelight_seams"
TIME = (1980, 1, 1, 0, 0, 0)  # the first that a zip can hold


def make_zip(path):
    files = sorted((FOLDER / NAME).glob("*.py")) + [FOLDER / "README.md", FOLDER.parent / "LICENSE"]
    with zipfile.ZipFile(path, "w") as archive:
        for file in files:
            entry = zipfile.ZipInfo(f"{NAME}/{file.name}", TIME)
            entry.create_system = 3  # Unix, wherever this runs
            entry.external_attr = 0o100644 << 16
            # Stored: what deflate writes differs between versions of zlib.
            archive.writestr(entry, file.read_bytes(), zipfile.ZIP_STORED)


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else f"{NAME}.zip"
    make_zip(path)
    print(f"{path}: written")


if __name__ == "__main__":
    main()
