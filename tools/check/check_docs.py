#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds the documentation (*.md) and the examples of --help against what is there.

  check_docs.py [--program build/release/rakelight] [--root FOLDER]

- links lead to files, and `#anchors` to headings;
- paths in backticks that begin with a folder of the repository exist (`*` matches as in a shell);
- names of source files in backticks (README.md, CONTRIBUTING.md, architecture.md), `draw_list.h` or `kernels/hits.h`, are in the folder of the
  page, or of one file of the repository alone; a function before the name, `resolve_reference()` (`file.h`), stands in that file;
- functions in backticks (docs/, README.md, CONTRIBUTING.md), `render()` or `Context::parallel_for()`, are defined or declared in a source: DEFINED_IN
  (C++, GLSL, Python), or the folder of the page. The class before the name is one, too. FOREIGN are those of others;
- `./dev WORD` is a command of ./dev;
- commands `rakelight VERB ...` in code blocks, fenced or indented, and in the examples of `rakelight VERB --help`, run. Models that are
  not there are replaced by one of data/, as are the pictures and the folders (before/) that `compare` gets; where no such model can be made (model.fbx), the program must get as far as not finding it.
  What stands indented with MODEL, [OPTION] or a|b is no command but a synopsis. Each runs once, wherever it stands, and with less work: LESS_WORK.

Exit code 1 with a line for each thing that is wrong. Without a program its commands are left out, and it is said."""
import argparse
import functools
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
STAND_INS = {".glb": "data/spot/spot_slab5.glb", ".gltf": "data/motion/door.gltf", ".obj": "tests/golden/models/solids.obj", ".toml": "data/world/room.scene.toml", ".png": "data/maps/brick_height.png"}
# Amounts of work: what a page shows with more of it is run with this much, and light by radiosity with so many elements.
LESS_WORK = {"--samples": "16", "--noise": "0.2", "--lightmap": "256", "--size": "256", "--radiosity-elements": "1000"}
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```(\w*)\n(.*?)^```", re.M | re.S)
INDENTED = re.compile(r"^(?: {4}.*\n?)+", re.M)
SYNOPSIS = re.compile(r"(?:^|\s)[A-Z]{2,}\b|\[|\|")
SPAN = re.compile(r"`([^`\n]+)`")
# A file of sources, with a function said to be in it: `NAME()` (`FILE`), `NAME()` in `FILE`, `FILE`: `NAME()`.
SOURCE = re.compile(r"(?:`(?:\w+::)*(\w+)\(\)`(?: \(|\s+in\s+))?`((?:[\w-]+/)*[\w-]+\.(?:h|cpp|glsl|inc|py|sh|cmake))`(?:(?:: | \()`(?:\w+::)*(\w+)\(\)`)?")

# A function in backticks: `name()`, `Class::name()`, `module.name()`.
FUNCTION = re.compile(r"`(?:::)?((?:\w+(?:::|\.))*)(\w+)\(\)`")
DEFINED_IN = ("src", "include", "apps", "web", "python", "tools", "blender", "examples", "cmake")
# What defines or declares a name: a function after its type, a class, a function of Python, one that pybind11 binds, a macro, a function of CMake or the shell,
# an operator of Blender.
DEFINITION = re.compile(r"^[ \t]*(?!(?:return|else|throw|case|delete|new|using|goto)\b)(?:[&*]*[\w:\[][\w:<>,&*\[\]]*[ \t]+)+[&*]*(?:\w+::)*(\w+)[ \t]*\("
                        r"|\b(?:class|struct|namespace)[ \t]+(?:RL_\w+[ \t]+)?(?:\w+::)*(\w+)|\bdef[ \t]+(\w+)[ \t]*\(|\.def\w*\(\s*\"(\w+)\""
                        r"|^[ \t]*#[ \t]*define[ \t]+(\w+)\(|^[ \t]*(?:function|macro)\([ \t]*(\w+)|^(\w+)[ \t]*\(|std::function<[^;\n]*>[ \t]+(\w+)|\bbl_idname = \"\w+\.(\w+)\"", re.M)
SOURCES = {".h", ".hpp", ".cpp", ".inc", ".glsl", ".py", ".cmake", ".sh", ".js"}
FOREIGN = {"find_package": "CMake", "add_subdirectory": "CMake", "getVertexPosition": "three.js"}


def pages(root):
    return sorted(p for p in root.rglob("*.md") if "build" not in p.relative_to(root).parts)


def anchors(text):
    """The names that headings get: lower case, words joined by '-'."""
    return {re.sub(r"[^\w\- ]", "", line.lstrip("# ").strip().lower()).replace(" ", "-")
            for line in text.splitlines() if line.startswith("#")}


def check_links(page, text, wrong):
    for target in LINK.findall(FENCE.sub("", text)):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = page.parent / path if path else page
        if not file.exists():
            wrong(f"link to {target}: there is no such file")
        elif anchor and file.suffix == ".md" and anchor not in anchors(file.read_text()):
            wrong(f"link to {target}: there is no such heading")


def check_paths(root, text, wrong):
    folders = {p.name for p in root.iterdir() if p.is_dir() and not p.name.startswith(".")} - {"build"}
    for span in SPAN.findall(FENCE.sub("", text)):
        for word in span.split():
            word = word.strip(",;:()")
            if word.partition("/")[0] in folders and "/" in word and not re.search(r"[<>{}$]", word):
                if not any(root.glob(word.rstrip("/"))):
                    wrong(f"`{word}`: there is nothing of that name")


def files_below(folder):
    """Paths of its files, from it; without what is built and what is hidden."""
    return [path.relative_to(folder).as_posix() for path in folder.rglob("*")
            if path.is_file() and not any(part == "build" or part.startswith(".") for part in path.relative_to(folder).parts)]


def file_of(page, name, files, root):
    """The file that a page means, or in words why there is none."""
    at = page.parent.relative_to(root).as_posix()
    below = "" if at == "." else at + "/"
    for folder in (below, "", "src/"):
        if folder + name in files:
            return folder + name, ""
    known = [file for file in files if file.endswith("/" + name)]
    near = [file for file in known if below and file.startswith(below)] or known
    if len(near) == 1:
        return near[0], ""
    return None, f"may be {' or '.join(sorted(near)[:3])}: write the folder, too" if near else "there is no file of that name"


def check_file_names(page, text, files, root, wrong):
    if page.name not in ("README.md", "CONTRIBUTING.md", "architecture.md"):
        return
    for function, name, after in SOURCE.findall(FENCE.sub("", text)):
        path, why = file_of(page, name, files, root)
        if why:
            wrong(f"`{name}`: {why}")
            continue
        text_of_file = (root / path).read_text()
        for called in filter(None, (function, after)):
            if not re.search(rf"\b{called}\b", text_of_file):
                wrong(f"`{called}()` is not in {path}")


@functools.cache
def names_in(file):
    """What a source defines or declares."""
    return {name for names in DEFINITION.findall(file.read_text(errors="replace")) for name in names if name}


@functools.cache
def names_below(root, folder):
    """What the sources of a folder define or declare."""
    files = (path for path in (root / folder).rglob("*") if path.suffix in SOURCES and "build" not in path.relative_to(root).parts)
    return frozenset(name for path in files if path.is_file() for name in names_in(path))


def check_functions(page, text, root, wrong):
    at = page.relative_to(root)
    if not (at.parts[0] == "docs" or page.name in ("README.md", "CONTRIBUTING.md")):
        return
    folders = {*DEFINED_IN, *at.parts[:-1][:2]} if at.parts[0] != "docs" else set(DEFINED_IN)
    known = set().union(*(names_below(root, folder) for folder in folders if (root / folder).is_dir()), FOREIGN)
    for owners, name in sorted(set(FUNCTION.findall(FENCE.sub("", text)))):
        if name not in known:
            wrong(f"`{name}()`: no source defines a function of that name")
        owner = re.split(r"::|\.", owners)[-2] if "::" in owners else ""
        if owner and owner not in known and owner != "std":
            wrong(f"`{owner}::{name}()`: no source defines a class of that name")


def dev_commands(root):
    """The words before `)` in the last case of ./dev."""
    text = (root / "dev").read_text()
    return set(re.findall(r"^([a-z]+)\)", text[text.rindex("\ncase "):], re.M))


def check_dev(root, text, wrong):
    known = dev_commands(root)
    code = "\n".join(body for _, body in FENCE.findall(text)) + "\n" + "\n".join(SPAN.findall(FENCE.sub("", text)))
    for word in re.findall(r"\./dev ([a-z]\w*)", code):
        if word not in known:
            wrong(f"./dev {word}: ./dev has no such command")


def commands_in(text):
    """Command lines of the program in code, continued lines joined, comments off."""
    for line in re.sub(r"\\\n\s*", " ", text).splitlines():
        match = re.match(r"\s*(?:\$ )?(?:\S*/)?rakelight (.+)", line)
        if match:
            yield match.group(1)


def commands_of_page(text):
    """Those of fenced blocks, then those of indented ones."""
    for _, body in FENCE.findall(text):
        yield from commands_in(body)
    for body in INDENTED.findall(FENCE.sub("", text)):
        yield from (command for command in commands_in(body) if not SYNOPSIS.search(command.partition("#")[0]))


def with_less_work(words):
    """A command line, its amounts of work made those of LESS_WORK where they ask for more."""
    def less(option, value):
        limit = LESS_WORK.get(option)
        asks_more = limit and (float(value) < float(limit) if option == "--noise" else float(value) > float(limit))
        return limit if asks_more else value
    words = words[:1] + [less(option, value) for option, value in zip(words, words[1:])]
    solves = words[0] == "radiosity" or ("--method", "radiosity") in zip(words, words[1:])
    return words + ["--radiosity-elements", LESS_WORK["--radiosity-elements"]] * (solves and "--radiosity-elements" not in words)


@functools.cache
def run_command(root, program, command):
    """Runs one command line in a folder of its own, where its models stand under their names; `*.glb` finds two. What is wrong with it."""
    words = shlex.split(command, comments=True)
    source = words[words.index("<") + 1] if "<" in words else None  # standard input
    words = words[:next((at for at, word in enumerate(words) if word in ("|", "<", ">")), len(words))]
    words = [name for word in words for name in ((word.replace("*", "a"), word.replace("*", "b")) if "*" in word else (word,))]
    words = with_less_work(words)
    with tempfile.TemporaryDirectory() as temporary:
        folder, is_missing = pathlib.Path(temporary), False
        for at, word in enumerate(words):
            option = words[at - 1] if at else ""
            if word.startswith("file:///home/"):  # a model in somebody's folder
                name = word.rpartition("/")[2].replace("%20", " ")
                is_missing |= not provide(root, folder, name)
                words[at] = f"{folder.as_uri()}/{word.rpartition('/')[2]}"
            if option in ("-o", "--output"):
                pass  # the program makes folders
            elif option == "--config":
                (folder / word).write_text("[render]\nsamples = 8\n")
            elif words[0] == "join-windows" and word.endswith((".png", ".exr", ".hdr")):
                is_missing = True  # windows that the command before has made
            elif words[0] == "compare" and word.endswith("/"):  # a folder of pictures
                provide(root, folder, word + "picture.png")
            elif words[0] == "compare" and word.endswith(".png"):
                provide(root, folder, word)
            elif word.endswith("/"):  # a folder of models
                provide(root, folder, word + "model.obj")
            elif option.startswith("--texture-") or option in ("--height-map", "--hdri-file", "--vertex-shader") or word.endswith(".glsl") or re.fullmatch(r"[\w./-]+\.(glb|gltf|obj|fbx|dae|stl|ply|3ds|ase|blend|off|x|scene\.toml)", word):
                is_missing |= not provide(root, folder, word)
        if source:
            provide(root, folder, source)
        with open(folder / source if source else "/dev/null", "rb") as piped:
            done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, errors="replace", timeout=400, stdin=piped)
    checks = any(re.match("--(check$|max-|min-)", word) for word in words) or any(word.endswith(".xml") for word in words)
    allowed = {0} | ({3} if is_missing else set()) | ({5} if checks else set())  # a check may find something
    allowed |= {3} if "--ref" in words else set()  # the reference is yet to be made
    if done.returncode not in allowed:
        return f"rakelight {command}: exit code {done.returncode}: {(done.stderr.strip().splitlines() or ['no message'])[-1]}"
    return ""


def provide(root, folder, name):
    """Puts a model there under the name; False where none can be made."""
    source = root / name if (root / name).exists() else root / STAND_INS.get(pathlib.Path(name).suffix, "no such model")
    if not source.exists():
        return False
    target = folder / name
    target.parent.mkdir(parents=True, exist_ok=True)
    for beside in source.parent.iterdir():
        if beside.is_file() and beside != source:
            shutil.copyfile(beside, target.parent / beside.name)
    shutil.copyfile(source, target)
    return True


def help_texts(program):
    """(name, text) of the program's help and of each verb's."""
    def text(*words):
        return subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True, stdin=subprocess.DEVNULL).stdout
    top = text()
    yield "rakelight --help", top
    for verb in re.findall(r"^  ([a-z-]+) {2,}", top[top.index("Subcommands:"):], re.M):
        yield f"rakelight {verb} --help", text(verb)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT)
    options = parser.parse_args()
    root, faults, counts = options.root.resolve(), [], {"pages": 0, "commands": 0}
    program = options.program or root / "build/release/rakelight"
    program = program.resolve() if program.exists() else None
    if options.program and not program:
        sys.exit(f"docs: there is no program {options.program}")

    def speaker(where):
        return lambda what: faults.append(f"docs: {where}: {what}")

    files = set(files_below(root))
    for page in pages(root):
        text, wrong = page.read_text(), speaker(page.relative_to(root))
        counts["pages"] += 1
        check_links(page, text, wrong)
        check_paths(root, text, wrong)
        check_dev(root, text, wrong)
        check_file_names(page, text, files, root, wrong)
        check_functions(page, text, root, wrong)
        for command in commands_of_page(text) if program else ():
            counts["commands"] += 1
            if fault := run_command(root, program, command):
                wrong(fault)
    for name, text in help_texts(program) if program else ():
        for command in commands_in(text.partition("Examples:")[2]):
            counts["commands"] += 1
            if fault := run_command(root, program, command):
                speaker(name)(fault)
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"docs: {counts['pages']} pages, {counts['commands']} commands, {len(faults)} wrong" +
          ("" if program else "; no program is built, its commands were left out"))
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
