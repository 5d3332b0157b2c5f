#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the language of the documentation: short sentences, and the terms of the field.

  check_language.py [--root FOLDER] [--words 35] [FILE ...]

- no sentence of README.md, CONTRIBUTING.md, CHANGELOG.md, docs/**/*.md or of a comment in include/**/*.h has more than 35 words;
- the same holds for comments of *.h, *.cpp and *.glsl in src, apps and python/src, except sentences with a formula: those that
  contain '=', '^', '->', '*' or the word pi;
- none of them uses a phrase of PHRASES, which lists private phrases with the usual term for each;
- no comment in apps/viewer and apps/cli begins with a word of FRAGMENT, which makes a fragment instead of a sentence.

Only prose is checked: code blocks, tables, headings, list items that begin with code (descriptions of options) and lines that
name a source are left out, and so is docs/command-line.md, which the program writes. Code, links and formulas count as one word.
With FILEs only those are checked. Exit code 1 with a line `file:line: message` for each finding."""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
GENERATED = {"docs/command-line.md"}

# Private phrase -> the usual term.
PHRASES = {
    r"not to be told (?:from|apart)": "indistinguishable",
    r"cannot be told (?:from|apart)": "indistinguishable",
    r"what stands all around": "environment",
    r"what is all around": "environment",
    r"what cameras see": "the view of the camera",
    r"takes? the place of all": "override",
    r"(?:surfaces|faces|parts) (?:are|is) taken away": "hidden-surface removal, culling",
    r"is said once": "is reported once",
    r"it is said\b": "it is reported",
    r"(?:is|are|was|were|it) held against": "compared with, checked against",
    r"holds? (?:the \w+|it|them) against": "compare with, check against",
    r"throws? (?:\w+ )?shadows?": "cast a shadow",
    r"meetings of (?:a |the )?(?:\w+ of )?rays": "hits, intersections",
    r"as it stands in the file": "as the file has it",
    r"the house of": "the module of",
    r"\brooms? of the (?:soft )?engine": "subfolder of the engine",
    r"way of the data": "data flow",
}
COMPILED = {re.compile(pattern.replace(" ", r"\s+"), re.I): term for pattern, term in PHRASES.items()}

# Abbreviations whose full stop ends no sentence.
ABBREVIATION = re.compile(r"\b(e\.g|i\.e|etc|vs|eq|eqs|Eq|Fig|fig|sec|pp|p|al|cf|approx|No|no)\.(?=\s+[a-z0-9(])|\b(e\.g|i\.e|Fig|Eq|al)\.(?=\s)")
END = re.compile(r"(?<=[.!?])(?<!\.\.\.)[)\"'*_\]]*\s+(?=[\"'(*_\[]*[A-Z0-9`~\x00])")
FORMULA = re.compile(r"[=^*]|->|\bpi\b")
FRAGMENT = re.compile(r"(?:(What|Of|Where) |(Likewise)\b)")
CODE_SUFFIXES = {".h", ".cpp", ".glsl"}
CODE_FOLDERS = ("src", "apps", "python/src", "web")
PLAIN_FOLDERS = ("apps/viewer", "apps/cli")
SOURCE = re.compile(r"\s*(?:@see\b|@copyright|Sources?:|SPDX)")


class Text:
    """A run of prose: its words with the number of the line of each character."""

    def __init__(self):
        self.text, self.lines = "", []

    def add(self, line, number):
        line = line.strip() + " "
        self.text += line
        self.lines += [number] * len(line)

    def keep_length(self, pattern, replacement):
        """Replaces, padded to the old length, so that `lines` holds."""
        def padded(match):
            new = match.expand(replacement)
            return new + "\x01" * (len(match.group()) - len(new))
        self.text = re.sub(pattern, padded, self.text)

    def sentences(self):
        """(line, sentence) of each."""
        self.keep_length(r"``[^`]+``|`[^`]+`|\$[^$]+\$", r"`")
        self.keep_length(r"<[^<>\s][^<>]*>", "")
        self.keep_length(r"!?\[([^\]]*)\]\([^)\s]*\)", r"\1")
        self.keep_length(ABBREVIATION.pattern, r"\1\2")
        at = 0
        while True:
            match = END.search(self.text, at)
            sentence = self.text[at:match.start() if match else None]
            if sentence.strip("\x01 "):
                start = at + len(sentence) - len(sentence.lstrip("\x01 "))
                yield self.lines[min(start, len(self.lines) - 1)], sentence.replace("\x01", "").strip()
            if not match:
                return
            at = match.end()


def words(sentence):
    return [word for word in sentence.split() if re.search(r"[\w`]", word)]


def markdown_texts(lines):
    """Runs of prose of a page: paragraphs and list items."""
    text, is_code, in_list = Text(), False, False
    for number, line in enumerate(lines, 1):
        item = re.match(r"\s*(?:[-*+]|\d+\.)\s+", line)
        if line.lstrip().startswith(("```", "~~~")):
            is_code = not is_code
        if is_code or re.match(r"\s*(?:```|~~~|\||#|!\[|>|<!--|!!!)", line) or not line.strip() or item or (line.startswith("    ") and not in_list):
            yield text
            text = Text()
        if item and not is_code:
            in_list = True
            text.add(line[item.end():], number)
        elif is_code or not line.strip() or re.match(r"\s*(?:```|~~~|\||#|!\[|<!--|!!!)", line):
            pass
        elif line.startswith("    ") and not in_list:
            pass
        else:
            in_list = in_list and line.startswith(" ")
            text.add(line.lstrip("> "), number)
    yield text


def comment_texts(lines):
    """Runs of prose of a source or header: comments on lines of their own, and those behind code."""
    text, is_behind = Text(), False
    for number, line in enumerate(lines, 1):
        match = re.match(r"(.*?)(?:^|\s)//[/!]?(<?)( ?.*)$", line)
        code, body = (match.group(1).strip(), match.group(3)) if match else ("x", "")
        starts_behind = bool(match and (code or (match.group(2) and not is_behind)))
        is_example = re.match(r"\s{4,}\S", body) and not code and not is_behind
        if not match or starts_behind or (is_behind and not code and not match.group(2)) or is_example or not body.strip() or re.match(r"\s*(?:@|\\|- |\* )", body):
            yield text
            text = Text()
        is_behind = bool(match) and (bool(code) or (is_behind and bool(match.group(2))))
        if match and not is_example and body.strip():
            text.add(re.sub(r"^\s*(?:[@\\]\w+(?:\[\w+\])?|[-*] )\s*", "", body) if not SOURCE.match(body) else body, number)
    yield text


def is_in(name, folders):
    return any(name.startswith(folder + "/") for folder in folders)


def findings(path, limit, name):
    """(line, message) of each fault; `name` is the path from the root."""
    lines = path.read_text(encoding="utf-8").splitlines()
    for text in (comment_texts if path.suffix in CODE_SUFFIXES else markdown_texts)(lines):
        if not text.text.strip() or SOURCE.match(text.text):
            continue
        for pattern, term in COMPILED.items():
            for match in pattern.finditer(text.text):
                yield text.lines[match.start()], f"\"{' '.join(match.group().split())}\": the usual term is {term}"
        if path.suffix == ".md" and re.match(r"\**`", text.text):
            continue  # the description of an option, a key or a file
        fragment = FRAGMENT.match(text.text)
        if fragment and is_in(name, PLAIN_FOLDERS):
            yield text.lines[0], f"a comment that begins with \"{fragment.group(1) or fragment.group(2)}\": {text.text[:60].strip()} ..."
        for line, sentence in text.sentences():
            count = len(words(sentence))
            if count > limit and not SOURCE.match(sentence) and not (is_in(name, CODE_FOLDERS) and FORMULA.search(sentence)):
                yield line, f"a sentence of {count} words: {sentence[:60]} ..."


def checked_files(root):
    pages = [root / "README.md", root / "CONTRIBUTING.md", root / "CHANGELOG.md", *sorted((root / "docs").rglob("*.md"))]
    yield from (page for page in pages if page.exists() and page.relative_to(root).as_posix() not in GENERATED)
    yield from sorted((root / "include").rglob("*.h"))
    for folder in CODE_FOLDERS:
        yield from sorted(file for file in (root / folder).rglob("*") if file.suffix in CODE_SUFFIXES)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT)
    parser.add_argument("--words", type=int, default=35, help="the most words of a sentence")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    root, faults = options.root.resolve(), []
    files = [file.resolve() for file in options.files] or list(checked_files(root))
    for file in files:
        name = (file.relative_to(root) if file.is_relative_to(root) else file).as_posix()
        faults += [f"{name}:{line}: {message}" for line, message in sorted(findings(file, options.words, name))]
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"language: {len(files)} files, {len(faults)} findings")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
