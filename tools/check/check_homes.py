#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Where functions have their home: a function that a header declares should be defined in the source file of the same name.

  check_homes.py [--most PERCENT] [--list]

Prints how many of the functions that headers declare are defined in a source of another name, and folders of sources with more than 40 files directly in
them. Exit code 1 where either is too much. --list names the headers and sources. Needs Universal Ctags (Debian: universal-ctags); skipped, exit code 77,
where it is not there. Functions in namespaces without a name are no one else's and do not count."""
import argparse
import collections
import json
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = ("src", "include", "apps", "python", "tests/unit", "tests/cli", "tools")
MOST_FILES = 40


def tags():
    """The declarations and definitions of functions: dictionaries of ctags."""
    files = [path for folder in ("src", "include", "apps") for path in sorted((ROOT / folder).rglob("*")) if path.suffix in (".h", ".cpp")]
    command = ["ctags", "--languages=C++", "--map-C++=+.h", "--kinds-C++=pf", "--fields=+nSz", "--output-format=json", "-L", "-", "-f", "-"]
    text = "\n".join(str(path.relative_to(ROOT)) for path in files)
    for line in subprocess.run(command, cwd=ROOT, input=text, capture_output=True, text=True, check=True).stdout.splitlines():
        tag = json.loads(line)
        if tag.get("_type") == "tag" and "__anon" not in tag.get("scope", ""):
            yield tag


def homes():
    """(functions, those elsewhere): the name, the headers that declare it, and the source."""
    declared, defined = collections.defaultdict(set), []
    for tag in tags():
        key = (tag.get("scope", "").removeprefix("rakelight").removeprefix("::"), tag["name"])
        if tag["kind"] == "prototype" and tag["path"].endswith(".h"):
            declared[key].add(tag["path"])
        elif tag["kind"] == "function" and tag["path"].endswith(".cpp"):
            defined.append((key, tag["path"]))
    known = [(key[1], sorted(declared[key]), source) for key, source in defined if key in declared]
    elsewhere = [found for found in known if pathlib.Path(found[2]).stem not in {pathlib.Path(header).stem for header in found[1]}]
    return known, elsewhere


def crowded_folders():
    for folder in SOURCES:
        for path in [ROOT / folder, *sorted((ROOT / folder).rglob("*"))]:
            if path.is_dir() and path.name != "__pycache__":
                count = sum(1 for file in path.iterdir() if file.is_file())
                if count > MOST_FILES:
                    yield f"{path.relative_to(ROOT)}: {count} files, more than {MOST_FILES}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--most", type=float, default=8, help="percent of functions that may be defined elsewhere")
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    if shutil.which("ctags") is None:
        print("skipped: ctags is not installed")
        sys.exit(77)
    known, elsewhere = homes()
    if options.list:
        pairs = collections.Counter((headers[0], source) for _, headers, source in elsewhere)
        for (header, source), count in sorted(pairs.items()):
            print(f"{count:3} {header} {source}")
    faults = list(crowded_folders())
    share = 100 * len(elsewhere) / max(len(known), 1)
    if share > options.most:
        faults.append(f"{share:.1f} % of the functions are defined in a source of another name than their header's, more than {options.most:g} % (--list)")
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"homes: {len(known)} functions of headers, {len(elsewhere)} ({share:.1f} %) in sources of other names")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
