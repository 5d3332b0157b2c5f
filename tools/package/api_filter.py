#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Hands a public header to Doxygen (INPUT_FILTER of tools/package/api.doxyfile), line by line, so that headers need not say what their code says:

- `int width = 0, height = 0;  ///< [px]` says [px] of both, where Doxygen gives a comment to one;
- a field without a comment whose type is one of ours leads to that type;
- the comment at the head of a file is about the file;
- arrays of a channel lead to the channel's bit, `using` to what it stands for;
- begin(), size() and the like, copies, moves, comparison and element access are what they are everywhere."""
import pathlib
import re
import sys

TRAILING = re.compile(r"^(?P<code>.*?;)\s*///<\s?(?P<text>.*)$")
OBVIOUS = re.compile(r"^\s*(?:constexpr )?(?:bool operator==\(.*\) const\b.*|(?:const )?[\w<>]+& operator\[\]\(.*\).*\{.*\}|"
                     r"(?P<name>\w+)\((?:const )?(?P=name)&{1,2}(?: \w+)?\).*|(?P<type>\w+)& operator=\((?P=type)&{0,2}(?: \w+)?\).*)$")
STANDARD = re.compile(r"^\s*(?:explicit )?(?:[\w:<>*& ]+ )?(?:begin|end|size|empty|data|push_back|clear|operator bool|operator\*|operator->)\(.*\).*\{")
FIELD = re.compile(r"^(?P<indent>\s+|(?=inline ))(?P<type>(?:const |inline constexpr )?[\w:]+(?:<[^;=]*?>)?(?:::\w+)?[&*]?)\s+(?P<names>[a-z_]\w*.*);$")
ARITHMETIC = re.compile(r"^(?:constexpr |inline )?\S+(?: |& )operator[-+*/]=?\(.*\).*\{")
USING = re.compile(r"^using \w+ = (?P<type>[A-Z]\w+)<")
WORDS = re.compile(r"^inline constexpr Word<(?P<type>\w+)> \w+\[\]")
OURS = re.compile(r"\b([A-Z]\w+)(?:::\w+)?\b")


ENGINE = pathlib.Path(__file__).resolve().parents[2] / "include/rakelight/engines/engine.h"
CHANNELS = set(re.findall(r"\bchannel_(\w+) = 1u", ENGINE.read_text(encoding="utf-8")))


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
    """(type, single declarations) of the line of a field or a list of them; (None, ...) where it is none."""
    match = FIELD.match(code)
    names = split(match["names"]) if match else []
    if not names or match["type"] in ("return", "using", "friend", "virtual") or not all(re.match(r"[a-z_]\w*\s*(?:$|[={\[])", name) for name in names):
        return None, [code]
    return match["type"], [f"{match['indent']}{match['type']} {name};" for name in names]


def joined(lines):
    """Statements that the formatter broke over several lines become one line; empty ones keep the count."""
    held, kept = "", 0
    for line in lines:
        if held:
            held, kept = held + " " + line.strip(), kept + 1
            if ";" in line:
                yield held
                yield from [""] * kept
                held, kept = "", 0
        elif re.match(r"^ {4}(?! )[\w:<>, {}()=.]+(?:,|\w|>| =)$", line) and not re.match(r"^\s*(?:public|private|virtual|static|return|template)\b", line) \
                and ("(" not in line or re.match(r"^ {4}\w+ \w+\{", line) or " = " in line) and not re.match(r"^\s+\w+,$", line):
            held = line
        else:
            yield line
    if held:
        yield held


def head(lines):
    """The lines with their first comment as that of the file."""
    end = next((at for at, line in enumerate(lines) if not line.startswith("//")), 0)
    return ["/** @file"] + [line[2:] for line in lines[1:end]] + [f"*/ {lines[end]}"] + lines[end + 1:] if end > 1 else lines


def name_of(declaration):
    return re.search(r"([a-z_]\w*)\s*(?:$|[={\[;])", declaration)[1]


def own_comment(line, kind, single):
    """The comment of each declaration of a line that has none; None where a reader has to be told."""
    ours = OURS.search(kind) if kind else None
    meant = USING.match(line) or WORDS.match(line)
    if STANDARD.match(line):
        return ["As containers of the standard library have it."]
    if ARITHMETIC.match(line):
        return ["Arithmetic of linear algebra."]
    if meant:
        return [f"{'Words of' if 'Word<' in line else 'See'} {meant['type']}."]
    if kind and name_of(single[0]) in CHANNELS:
        return [f"See channel_{name_of(part)}." for part in single]
    return [f"See {ours[1]}."] * len(single) if ours else None


def filtered(text):
    above = []
    for line in joined(head(text.split("\n"))):
        if re.match(r"\s*///(?!<)", line):
            above.append(re.sub(r"^\s*///\s?", "", line))
            yield line
            continue
        trailing = TRAILING.match(line)
        code, comment = (trailing["code"], trailing["text"]) if trailing else (line, " ".join(above))
        kind, single = fields(code)
        own = None if comment else own_comment(line, kind, single)
        if OBVIOUS.match(line):
            yield "" if line.rstrip().endswith((";", "}")) else f"/** Copies, moves or compares. */ {line.strip()}"
        elif own or (comment and len(single) > 1):
            yield " ".join(f"/** {said} */ {part.strip()}" for part, said in zip(single, own or [comment] * len(single)))
        else:
            yield f"{code} ///< {comment}" if trailing else line
        above = []


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        print("\n".join(filtered(file.read())), end="")
