#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads a Containerfile: what is wrong with its form, else the RUN steps of its last stage, one a line.

  container_steps.py FILE"""
import json
import re
import sys

KNOWN = {"FROM", "RUN", "COPY", "WORKDIR", "USER", "ENTRYPOINT", "CMD", "ENV", "ARG", "LABEL"}


def instructions(text):
    """(line number, name, rest), with continued lines joined."""
    out, held, start = [], "", 0
    for number, line in enumerate(text.splitlines(), 1):
        if not held and (not line.strip() or line.startswith("#")):
            continue
        start = start or number
        held += line.rstrip("\\") if line.endswith("\\") else line
        if line.endswith("\\"):
            continue
        name, _, rest = held.strip().partition(" ")
        out.append((start, name, rest.strip()))
        held, start = "", 0
    return out


def faults(found):
    stages, user, out = [], "root", []
    for line, name, rest in found:
        if name not in KNOWN:
            out.append(f"line {line}: no instruction {name}")
        if not rest:
            out.append(f"line {line}: {name} says nothing")
        if name != "FROM" and name != "ARG" and not stages:
            out.append(f"line {line}: {name} before FROM")
        if name == "FROM":
            match = re.fullmatch(r"(\S+:\S+)(?: AS (\w+))?", rest)
            if not match:
                out.append(f"line {line}: FROM names no image with a version")
            stages.append(match.group(2) if match else None)
            user = "root"
        if name == "COPY":
            words = rest.split()
            source = [word[7:] for word in words if word.startswith("--from=")]
            if source and source[0] not in stages[:-1]:
                out.append(f"line {line}: no stage {source[0]} before this one")
            if len(words) - len(source) < 2:
                out.append(f"line {line}: COPY from where to where?")
        if name == "USER":
            user = rest
        if name in ("ENTRYPOINT", "CMD"):
            try:
                words = json.loads(rest)
                assert isinstance(words, list) and all(isinstance(word, str) for word in words)
            except (ValueError, AssertionError):
                out.append(f"line {line}: {name} is no list of words")
    if len(stages) < 2:
        out.append("one stage: what builds would be in the image")
    if user in ("root", "0"):
        out.append("the last stage runs as root")
    return out


def main():
    found = instructions(open(sys.argv[1], encoding="utf-8").read())
    wrong = faults(found)
    if wrong:
        sys.exit("\n".join(wrong))
    last = max(i for i, (_, name, _) in enumerate(found) if name == "FROM")
    print("\n".join(rest for _, name, rest in found[last:] if name == "RUN"))


main()
