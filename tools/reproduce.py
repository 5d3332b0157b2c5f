#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the pictures and numbers of docs/reproduction.md from nothing, and compares the numbers with the ranges of tools/reproduction/ranges.py.

  reproduce.py [--program build/release/rakelight] [--out build/reproduction] [--page docs/reproduction.md] [NAME...]
  reproduce.py --list

NAME is an entry (s1-fig3) or the beginning of several (s2). Writes NAME.png, and numbers.json with the numbers of all entries in the folder. --timed also
measures times, which have no range. --page also writes the numbers into the page. --scale 0.3 measures with smaller pictures. Exit code 1 if a number is
outside of its range. Only the standard library is needed."""
import argparse
import json
import pathlib
import re
import sys
import tempfile

from reproduction import pending, s1_attributes, s1_frames, s1_light, s1_models, s1_scenes, s1_seams, s2_pipeline, s2_shading, s2_visibility, s2_world, s3_bumps, s3_detail, s3_light, s3_maps
from reproduction.kit import Failure, Kit
from reproduction.ranges import ORDERS, RANGES
from sheet import PROGRAM, ROOT

MODULES = (s1_light, s1_models, s1_scenes, s1_frames, s1_attributes, s1_seams, s2_pipeline, s2_visibility, s2_shading, s2_world, s3_maps, s3_bumps, s3_detail, s3_light, pending)
ENTRIES = {entry.name: entry for module in MODULES for entry in module.ENTRIES}


def number(value):
    """Four significant digits, one where there are that many zeros after the point."""
    if abs(value) >= 1000 or value == int(value):
        return f"{value:.0f}"
    return f"{value:.4g}" if abs(value) >= 1e-4 else f"{value:.0e}"


def words_of(low, high):
    """A range, in words."""
    if high == float("inf"):
        return "more than 0" if 0 < low < 1e-8 else f"{number(low)} or more"
    return number(low) if low == high else f"{number(low)} to {number(high)}"


def faults(name, numbers):
    """The numbers that are outside of their range, or have none, and those that are not in the order of the claim."""
    found = []
    for what in sorted(numbers.keys() | RANGES[name].keys()):
        if what not in numbers or what not in RANGES[name]:
            found.append(f"{name}: {what}: {'not measured' if what in RANGES[name] else 'no range'}")
        else:
            low, high = RANGES[name][what]
            if not low <= numbers[what] <= high:
                found.append(f"{name}: {what}: {number(numbers[what])}, not {words_of(low, high)}")
    for low, high in ORDERS.get(name, ()):
        if low in numbers and high in numbers and not numbers[low] < numbers[high]:
            found.append(f"{name}: {low}: {number(numbers[low])}, not below {number(numbers[high])} of {high}")
    return found


def make(entry, options):
    """Numbers of an entry, and its picture; None if the program lacks a feature that it needs."""
    with tempfile.TemporaryDirectory() as folder:
        kit = Kit(options.program, folder, options.scale)
        why = pending.lacks(kit, entry.name)
        if why:
            print(f"{entry.name}: left out: {why}")
            return None
        numbers = entry.measure(kit)
        if entry.draw and options.scale == 1:
            entry.draw(kit, options.out / f"{entry.name}.png")
        return {"source": entry.source, "claim": entry.claim, "numbers": numbers, "times": entry.timed(kit) if entry.timed and options.timed else {}}


def rows(name, entry):
    """The numbers as a table of Markdown."""
    shown = [(what, number(value), words_of(*RANGES[name][what])) for what, value in entry["numbers"].items()]
    shown += [(what, number(value), "") for what, value in entry["times"].items()]
    return "".join(f"| {' | '.join(row)} |\n" for row in (("number", "value", "allowed"), ("---", "---:", "---"), *shown))


def update_page(page, made):
    """Puts the numbers between `Measured:` and the verdict, which begins with **, under the heading of an entry."""
    text = page.read_text()
    for name, entry in made.items():
        text, count = re.subn(rf"(^### {re.escape(name)}:.*?^Measured:)\n.*?(?=^\*\*)", lambda m: f"{m.group(1)}\n\n{rows(name, entry)}\n", text, count=1, flags=re.M | re.S)
        if not count:
            sys.exit(f"reproduce: {page} has no place for the numbers of {name}")
    page.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "build/reproduction")
    parser.add_argument("--page", type=pathlib.Path)
    parser.add_argument("--timed", action="store_true")
    parser.add_argument("--scale", type=float, default=1.0)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    if options.list:
        print("\n".join(f"{entry.name:20}{entry.source:32}{entry.claim}" for entry in ENTRIES.values()))
        return
    unknown = [n for n in options.names if not any(name.startswith(n) for name in ENTRIES)]
    if unknown:
        sys.exit(f"reproduce: no entry begins with '{unknown[0]}'; --list shows them")
    if not options.program.exists():
        sys.exit(f"reproduce: there is no program {options.program}: ./dev build")
    options.out = options.out.resolve()
    options.out.mkdir(parents=True, exist_ok=True)
    made, wrong = {}, []
    for name, entry in ENTRIES.items():
        if options.names and not any(name.startswith(n) for n in options.names):
            continue
        try:
            one = make(entry, options)
        except Failure as failure:
            wrong.append(f"{name}: {failure}")
            continue
        if one is None:
            continue
        made[name] = one
        wrong += faults(name, one["numbers"])
        print(f"{name}: {entry.claim}")
        for what, value in {**one["numbers"], **one["times"]}.items():
            print(f"    {what}: {number(value)}")
    numbers = options.out / "numbers.json"
    if options.names and numbers.exists():
        made = {**json.loads(numbers.read_text()), **made}
    numbers.write_text(json.dumps(made, indent=1) + "\n")
    if options.page:
        update_page(options.page, made)
    for fault in wrong:
        print(f"reproduce: {fault}", file=sys.stderr)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
