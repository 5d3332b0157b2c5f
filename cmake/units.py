#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Which sources may be compiled together as one unit. Standard library only.

  units.py MOST FILE...    prints FILE,NUMBER lines: the sources of each number make one unit, of at most MOST sources; others are not named

Two sources may share a unit if no name that one keeps to itself (in an unnamed namespace, or static) is mentioned in the other or its headers: neither can a
name be defined twice, nor can an overload of one source win a call of the other in silence. Sources of one unit have the same using-directives,
a using-declaration or alias is the same in the other or not mentioned there, and one that defines a macro stays alone."""
import functools
import os
import re
import sys

KEYWORDS = set("TEST TEST_F TEST_P TYPED_TEST INSTANTIATE_TEST_SUITE_P TYPED_TEST_SUITE alignas catch const constexpr decltype defined for if noexcept operator requires return sizeof static_assert switch throw while template typename namespace struct class union enum using void try bool char int unsigned long float double auto".split())
NO_TYPES = set("return throw else case new delete goto not and or co_return co_yield typename struct class enum union namespace using".split())
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
USING = re.compile(r"^using\s+(?:namespace\s+|enum\s+)?[\w:]+(?:\s*=[^;]*)?;", re.M)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*$", re.M)


def without_text(source):
    """Without comments, strings and directives."""
    return DIRECTIVE.sub("", COMMENT_OR_STRING.sub(lambda m: " 0 " if m[0][0] != "/" else " ", source))


def outermost(text, begin):
    """Up to the brace that closes the block at `begin`, with nested blocks as {} and parentheses as ()."""
    out, depth, at = [], [], begin
    while at < len(text):
        c = text[at]
        if c in "{(":
            if not depth:
                out.append(c)
            depth.append(c)
        elif c in "})":
            if not depth:
                break
            depth.pop()
            if not depth:
                out.append(c)
        elif not depth:
            out.append(c)
        at += 1
    return "".join(out)


def own_names(text):
    """Names at the outermost level of unnamed namespaces, and static functions; rather too many than too few."""
    names = set()
    text = USING.sub("", text)
    for opening in re.finditer(r"\bnamespace\s*\{", text):
        level = outermost(text, opening.end())
        names.update(re.findall(r"\b(\w+)\s*=(?!=)", level))  # of "int a = 1, b = 2;" the second, too
        level = re.sub(r"=[^;]*;|\btemplate\s*<[^;(){}]*?>(?=\s)", ";", level)
        names.update(re.findall(r"\b(?:struct|class|union|enum(?:\s+class)?|concept|using|namespace)\s+(\w+)(?!\w|::)", level))
        names.update(re.findall(r"(?<![:.])\b(\w+)\s*(?:\(\)|\[[^\]]*\]|\{\}|;)", level))
    names.update(re.findall(r"^static\s[^;{}()=]*?(\w+)\s*[(=;]", text, re.M))
    return {name for name in names if name not in KEYWORDS and not name.isdigit() and name != "fs"}


def declared_names(text):
    """Variables and parameters: mentions of these are of the source's own."""
    names = {name for before, name in re.findall(r"(\w+)\s+(\w+)\s*(?=[=;,)({\[:])", text) if before not in NO_TYPES}
    names.update(re.findall(r"[\w>\])][&*>]+\s(\w+)\s*(?=[=;,)({\[:])", text))  # "a & b" has a blank before, too
    for bound in re.findall(r"\bauto\s*&{0,2}\s*\[([^\]]*)\]", text):
        names.update(re.findall(r"\w+", bound))
    return names


def mentioned_in(text):
    """But for its own variables and parameters."""
    mentioned = set(re.findall(r"(?<![\w.:>])[A-Za-z_]\w*", text)) | set(re.findall(r"(?<=[^:]:)[A-Za-z_]\w*|(?<=[^-]>)[A-Za-z_]\w*", text))
    return mentioned - declared_names(text)


def headers_of(path, whole):
    """The project's headers that a file includes: beside it, or in a folder above it, or in include/ beside one."""
    found = []
    for name in re.findall(r'^\s*#\s*include\s+["<]([^">]+\.h)[">]', whole, re.M):
        for folder in folders_above(os.path.dirname(path)):
            header = os.path.join(folder, name)
            if os.path.isfile(header):
                found.append(os.path.normpath(header))
                break
    return found


@functools.cache
def folders_above(folder):
    folders = [folder]
    while not os.path.isdir(os.path.join(folder, "include")) and os.path.dirname(folder) != folder:
        folder = os.path.dirname(folder)
        folders.append(folder)
    return [*folders, *(os.path.join(folder, name) for name in ("src", "include", "tests"))]


def defined_in(text):
    """Functions outside of types."""
    names = set()
    for opening in re.finditer(r"\bnamespace\s*[\w:]*\s*\{", text):
        names.update(re.findall(r"\b(\w+)\s*\(\)", outermost(text, opening.end())))
    return names


@functools.cache
def called_in_header(path):
    """And what it declares: an overload of a source before it could win a call, or be no overload. With headers that it includes."""
    with open(path, encoding="utf-8") as file:
        whole = file.read()
    text = without_text(whole)
    called = set(re.findall(r"(?<![\w.:>])([A-Za-z_]\w*)\s*\(", text)) - (declared_names(text) - defined_in(text))
    for header in headers_of(path, whole):
        called |= called_in_header(header)
    return called


class Source:
    def __init__(self, path):
        self.path = path
        with open(path, encoding="utf-8") as file:
            whole = file.read()
        text = without_text(whole)
        self.has_macros = bool(re.search(r"^\s*#\s*(define|undef|pragma)", whole, re.M))
        self.directives = set(re.findall(r"^using (?:namespace|enum) [^;]*", text, re.M))
        self.used = {name.rpartition("::")[2]: name for name in re.findall(r"^using ([\w:]+::\w+);", text, re.M)}
        self.used |= re.findall(r"^using (\w+) = ([^;]*);", text, re.M)
        self.own = own_names(text)
        self.mentioned = mentioned_in(text) | self.own
        for header in headers_of(path, whole):
            self.mentioned |= called_in_header(header)

    def fits(self, other):
        return (self.directives == other.directives and not (self.own & other.mentioned or other.own & self.mentioned) and
                self.lends_no_name(other) and other.lends_no_name(self))

    def lends_no_name(self, other):
        """By a using-declaration or an alias."""
        return all(other.used.get(name) == whole or name not in other.mentioned for name, whole in self.used.items())


def units_of(sources, most):
    """First fit, after those that fit with the fewest."""
    sources = [source for source in sources if not source.has_macros]
    units = []
    for source in sorted(sources, key=lambda s: sum(s.fits(other) for other in sources)):
        for unit in units:
            if len(unit) < most and all(source.fits(other) for other in unit):
                unit.append(source)
                break
        else:
            units.append([source])
    return [unit for unit in units if len(unit) > 1]


def main():
    sources = [Source(path) for path in sys.argv[2:]]
    for number, unit in enumerate(units_of(sources, int(sys.argv[1]))):
        for source in unit:
            print(f"{source.path},{number}")


if __name__ == "__main__":
    main()
