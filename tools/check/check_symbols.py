#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Keeps the promise of the same bits everywhere at the level of symbols.

1. Modules must not call libm's elementary functions: libm picks its variant by processor. math/functions.h and
   math/wide.h have our own. (sqrt, floor, fabs and their like are exact and allowed.)
2. Objects compiled per instruction set must name their flavour in every weak or global symbol they define: of two inline
   functions of one name the linker keeps one body, whatever instructions it has.

Usage: check_symbols.py [--nm NM] LIST     LIST has lines "module FILE" and "isa FLAVOUR FILE"
Exit code 1 and one line for each fault, or one line where files of the list are not built.
"""
import argparse
import os
import re
import subprocess
import sys

ELEMENTARY = {name + suffix
              for name in ("sin cos tan sincos asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp exp2 exp10 expm1 "
                           "log log2 log10 log1p pow cbrt hypot erf erfc lgamma tgamma").split()
              for suffix in ("", "f", "l")}
# What sanitizers and coverage add to every object.
INSTRUMENTATION = re.compile(r"^(__odr_asan|__asan|__tsan|__ubsan|__gcov|__llvm_|__sancov|__start___|__stop___|DW\.ref\.)")
DEFINED_FOR_THE_LINKER = set("TDBRGSCVWu")  # nm's letters: global and weak definitions


def libm_calls(nm_text):
    """Names of libm's elementary functions among the undefined symbols."""
    found = set()
    for line in nm_text.splitlines():
        parts = line.split()
        if len(parts) >= 2 and parts[-2] in ("U", "w"):
            name = parts[-1].split("@")[0]
            bare = re.sub(r"^__(.*)_finite$", r"\1", name)
            if bare in ELEMENTARY:
                found.add(name)
    return sorted(found)


def nameless_symbols(nm_text, flavour):
    """Weak and global definitions that carry the name of no namespace of this flavour. `nm_text` is demangled."""
    has_flavour = re.compile(rf"\b(xsimd_)?{re.escape(flavour)}::")
    found = []
    for line in nm_text.splitlines():
        match = re.match(r"^[0-9a-fA-F]+ ([A-Za-z]) (.+)$", line)
        if match is None or match[1] not in DEFINED_FOR_THE_LINKER:
            continue
        if not INSTRUMENTATION.match(match[2]) and not has_flavour.search(match[2]):
            found.append(match[2])
    return found


def run_nm(nm, options, path):
    done = subprocess.run([nm, *options, path], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"check_symbols: {path}: {done.stderr.strip() or 'nm failed'}")
    return done.stdout


def not_built(lines):
    """The files of a list that are not there: of targets that were not built."""
    return [path for path in (line.split(" ", 1 if line.startswith("module ") else 2)[-1] for line in lines)
            if not os.path.exists(path)]


def check_line(nm, line):
    kind, _, rest = line.partition(" ")
    if kind == "module":
        return [f"{rest}: calls libm's {name}; use math/functions.h or math/wide.h" for name in libm_calls(run_nm(nm, [], rest))]
    if kind == "isa":
        flavour, _, path = rest.partition(" ")
        return [f"{path}: '{name}' does not carry the name of its instruction set"
                for name in nameless_symbols(run_nm(nm, ["-C", "--defined-only"], path), flavour)]
    sys.exit(f"check_symbols: bad line: {line}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--nm", default="nm")
    parser.add_argument("list")
    arguments = parser.parse_args()
    with open(arguments.list, encoding="utf-8") as file:
        lines = [line.strip() for line in file if line.strip()]
    missing = not_built(lines)
    if missing:
        sys.exit(f"check_symbols: nothing is checked: {len(missing)} of {len(lines)} files are not built yet, the first is "
                 f"{missing[0]}; build all targets, then run this again")
    faults = [fault for line in lines for fault in check_line(arguments.nm, line)]
    for fault in faults:
        print(f"check_symbols: {fault}", file=sys.stderr)
    if faults:
        return 1
    modules = sum(line.startswith("module ") for line in lines)
    print(f"check_symbols: {modules} modules call no elementary function of libm, "
          f"{len(lines) - modules} objects per instruction set name theirs")
    return 0


if __name__ == "__main__":
    sys.exit(main())
