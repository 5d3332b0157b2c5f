# SPDX-License-Identifier: Apache-2.0
"""What mkdocs.yml needs beside its settings: headings get the anchors that the repository browser gives them (as tools/check/check_docs.py
checks), and the pages that Doxygen has made in build/api lie in the site as api/."""
import pathlib
import re

from mkdocs.structure.files import File

API = pathlib.Path(__file__).resolve().parents[2] / "build/api/html"


def anchor(text, separator="-"):
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", separator)


def on_config(config):
    config["mdx_configs"].setdefault("toc", {})["slugify"] = anchor
    return config


def on_files(files, config):
    for path in sorted(API.rglob("*")) if API.exists() else ():
        if path.is_file():
            name = "api/" + path.relative_to(API).as_posix()
            file = File(name, str(API.parent), config["site_dir"], use_directory_urls=False)
            file.abs_src_path = str(path)
            files.append(file)
    return files
