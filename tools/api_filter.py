#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Hands a public header to Doxygen (INPUT_FILTER of tools/api.doxyfile), line by line: `int width = 0, height = 0;  ///< [px]` says [px] of
both, where Doxygen gives a comment to one. Comparison and element access that say nothing but their sign are left out."""
import re
import sys

TRAILING = re.compile(r"^(?P<code>.*?;)\s*///<\s?(?P<text>.*)$")
OBVIOUS = re.compile(r"^\s*(?:constexpr )?(?:bool operator==\(.*\) const(?: = default;| \{.*\})|(?:const )?[\w<>]+& operator\[\]\(.*\).*\{.*\})$")
FIELD = re.compile(r"^(?P<indent>\s+)(?P<type>(?:const )?[\w:]+(?:<[^;=]*?>)?(?:::\w+)?[&*]?)\s+(?P<names>[a-z_]\w*.*,.*);$")


def split(text):
    """The declarators of a list: commas inside brackets, angles and strings do not end one."""
    parts, depth, quoted = [""], 0, False
    for character in text:
        quoted ^= character == '"'
        depth += 0 if quoted else (character in "({[<") - (character in ")}]>")
        if character == "," and depth == 0 and not quoted:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts]


def fields(code):
    """The single declarations of one line; the line itself where it is no list."""
    match = FIELD.match(code)
    names = split(match["names"]) if match else []
    if len(names) < 2 or not all(re.match(r"[a-z_]\w*\s*(?:$|[={\[])", name) for name in names):
        return [code]
    return [f"{match['indent']}{match['type']} {name};" for name in names]


def joined(lines):
    """Statements that the formatter broke over two lines are one line, and an empty one keeps the count."""
    held = ""
    for line in lines:
        if held:
            line, held = held + " " + line.strip(), ""
            yield line
            yield ""
        elif re.match(r"^ {4,}[\w:<>, ]+(?:,|\w| =)$", line) and "(" not in line and "///" not in line and not line.rstrip().endswith("{"):
            held = line
        else:
            yield line
    if held:
        yield held


def filtered(text):
    above = []
    for line in joined(text.split("\n")):
        if re.match(r"\s*///(?!<)", line):
            above.append(re.sub(r"^\s*///\s?", "", line))
            yield line
            continue
        trailing = TRAILING.match(line)
        code, comment = (trailing["code"], trailing["text"]) if trailing else (line, " ".join(above))
        single = fields(code)
        if OBVIOUS.match(line):
            yield ""
        elif len(single) > 1 and comment:
            yield " ".join(f"{part.strip()} /**< {comment} */" for part in single)
        else:
            yield line
        above = []


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        print("\n".join(filtered(file.read())), end="")
