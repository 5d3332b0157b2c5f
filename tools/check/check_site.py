#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds the built site against what a reader without a network needs.

  check_site.py [build/docs]

- links and pictures lead to files of the site, and `#anchors` to places on them;
- no page loads a script, a style, a font or a picture from elsewhere;
- no table or list stands in a paragraph as its Markdown.

Exit code 1 with a line for each thing that is wrong."""
import html.parser
import pathlib
import re
import sys
import urllib.parse

LOADED = {("script", "src"), ("img", "src"), ("link", "href")}
MARKDOWN = re.compile(r"^\s*\|.*\|\s*$|^\s*[-*] \S|^```", re.M)


class Page(html.parser.HTMLParser):
    """What a page links to, what it loads, the names that it has, and the text of its paragraphs."""

    def __init__(self, text):
        super().__init__()
        self.links, self.loaded, self.names, self.paragraphs, self.open = [], [], set(), [], False
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.names.update(values[key] for key in ("id", "name") if values.get(key))
        for key in ("href", "src"):
            if values.get(key):
                is_loaded = (tag, key) in LOADED and "canonical" not in (values.get("rel") or "")
                (self.loaded if is_loaded else self.links).append(values[key])
        if tag == "p":
            self.open = True
            self.paragraphs.append("")

    def handle_endtag(self, tag):
        self.open = self.open and tag != "p"

    def handle_data(self, data):
        if self.open:
            self.paragraphs[-1] += data


def check(root, wrong):
    own = [path for path in root.rglob("*.html") if "api" not in path.relative_to(root).parts[:1] and path.name != "404.html"]
    pages = {path: Page(path.read_text(errors="replace")) for path in sorted(own)}
    for path, page in pages.items():
        where = path.relative_to(root)
        for target in page.links + page.loaded:
            if re.match(r"[a-z]+:|//", target):
                if target in page.loaded:
                    wrong(f"{where}: loads {target}")
                continue
            name, _, anchor = urllib.parse.unquote(target).partition("#")
            file = (path.parent / name.partition("?")[0]) if name else path
            file = file / "index.html" if file.is_dir() else file
            if not file.exists():
                wrong(f"{where}: link to {target}: there is no such file")
            elif anchor and file in pages and anchor not in pages[file].names:
                wrong(f"{where}: link to {target}: there is no such place")
        for paragraph in page.paragraphs:
            if MARKDOWN.search(paragraph):
                wrong(f"{where}: Markdown was not understood: {paragraph.strip()[:80]!r}")
    return len(pages)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2] / "build/docs").resolve()
    if not (root / "index.html").exists():
        sys.exit(f"site: there is no site in {root}")
    faults = []
    pages = check(root, faults.append)
    for fault in faults:
        print(f"site: {fault}", file=sys.stderr)
    print(f"site: {pages} pages, {len(faults)} wrong")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
