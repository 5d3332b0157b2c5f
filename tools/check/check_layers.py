#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks every #include against the tables below: modules, and the rooms of the soft engine, include only downwards, a library appears in one module only,
public headers name no library, sources that are compiled per instruction set include only what those may, the shared
lighting text uses no word that GLSL reserves, no hash table takes std::hash, for which a file can choose its names, tests
have temporary files in one way, the library names no options of the program (decision 9) and mixes numbers of a file under a key alone,
no two files define types of one name,
and functions of public headers are seen outside of the shared library. --compile also compiles every header alone. Exit code 1 when something is wrong, one line each."""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Module -> the modules it may include directly (with everything below them).
BELOW = {
    "base": [],
    "math": ["base"],
    "image": ["math"],
    "geometry": ["image"],
    "scene": ["image"],
    "prepare": ["scene", "geometry"],
    "lighting": ["math"],
    "io": ["scene"],
    "world": ["engines", "io", "prepare"],
    "engines": ["scene", "geometry"],
    "shading": ["engines", "lighting", "scene", "geometry"],
    "cpu_shading": ["shading"],
    "engines/raster": ["cpu_shading"],
    "engines/raster/inspect": ["engines/raster"],
    "engines/opengl": ["shading"],
    "engines/raytrace": ["cpu_shading"],
    "radiosity": ["engines/raytrace", "prepare"],
    "bake": ["radiosity"],
    "render": ["radiosity", "engines/raster", "engines/opengl", "engines/raytrace", "world"],
    "tools": ["render", "bake", "engines/raster/inspect"],
}

# Rooms of the soft engine -> the rooms that each may include; headers in the engine's own folder are for all of them.
ROOMS = {
    "kernels": [],
    "geometry": ["kernels"],
    "visibility": ["geometry", "kernels"],
    "lights": ["geometry", "kernels"],
    "marks": ["visibility", "geometry"],
    "shadows": ["visibility", "geometry", "kernels"],
    "occlusion": ["visibility", "geometry", "kernels"],
    "shade": ["occlusion", "lights", "marks", "visibility", "geometry", "kernels"],
    "inspect": ["shade", "occlusion", "shadows", "lights", "marks", "visibility", "geometry", "kernels"],
}

# Of an engine's headers what modules above it see, and what these headers may include of the engine themselves.
DOORS = {
    "engines/raster": re.compile(r"engines/raster/(raster_engine|geometry/clip|kernels/clip_planes|visibility/depth_formats|"
                                 r"lights/lit_corner|inspect/(inspection|explanation|traced_pixel|inspect_pixels|inspect_samples|inspect_shading|nearest_visible))\.h"),
    "engines/raytrace": re.compile(r"engines/raytrace/(raytrace_engine|surface_rays)\.h"),
    "engines/opengl": re.compile(r"engines/opengl/(opengl_engine|window_view)\.h"),
}

# Public headers in no module's folder: the version, and all headers in one.
ROOT_HEADERS = {"version": "render", "rakelight": "tools"}

# Third-party include (regular expression) -> the modules, or the one file of a module, that may use it.
LIBRARIES = {
    r"(tbb|oneapi)/": ["base"],
    r"xsimd/": ["math"],
    r"spng\.h|jpeglib\.h|webp/|Imath|OpenEXR|Imf|stb": ["io"],
    r"expat\.h": ["src/io/import/xml_events.cpp"],
    r"draco/|meshoptimizer\.h": ["io"],
    r"nlohmann/": ["io", "tools", "render", "apps/cli"],
    r"fmt/": ["base"],
    r"fast_float/": ["src/base/from_chars.h"],
    r"assimp/": ["apps/import"],
    r"CLI/": ["apps/common"],
    r"opensubdiv/": ["geometry"],
    r"GLFW/|imgui": ["apps/viewer"],
    r"embree": ["engines/raytrace"],
    r"epoxy/|EGL/|GL/": ["engines/opengl", "apps/viewer/view/gl_pictures.cpp"],
    r"toml": ["io"],
    r"pybind11/": ["python/src"],
}

# Sources compiled per instruction set see only these: nothing whose inline functions the linker could merge between sets.
ISA_ALLOWED = re.compile(r"(math/wide\w*\.h|math/prelude\.h|lighting/(lighting|light_parameters|read_albedos|albedo_tables)\.h|image/(srgb_table|denoise_tile|maps/mip_rows)\.h|shading/(text_numbers|material_factors|effect_factors|lights/shadow_factors|lights/light_box)\.h|scene/materials/texture_role_numbers\.h|lighting/\w+/\w+\.glsl|"
                         r"geometry/\w+/\w+_kernel_types\.h|geometry/fast/fast_weld_types\.h|geometry/kernels/\w+\.h|cpu_shading/(kernels/\w+|texture_view|material_job|mesh_view|channel_planes)\.h|engines/raster/(inspect/)?kernels/\w+\.(h|cpp)|engines/raytrace/kernels/\w+\.(h|cpp)|radiosity/kernels/\w+\.(h|cpp)|engines/raster/inspect/traced_pixel\.h|stdint\.h|stddef\.h|xsimd/xsimd\.hpp)")
ISA_FILES = ["src/cpu_shading/kernels", "src/engines/raster/kernels", "src/engines/raster/inspect/kernels", "src/engines/raytrace/kernels", "src/radiosity/kernels", "src/geometry/kernels", "src/image/kernels", "src/lighting/lighting.h", "src/lighting/read_albedos.h", "src/math/prelude.h"]

GLSL_RESERVED = set("active half input output filter common partition smooth flat shared fixed sample patch buffer resource "
                    "precise template this using noise superp cast namespace".split())

INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.M)


def closure(module):
    seen, todo = {module}, [module]
    while todo:
        for below in BELOW[todo.pop()]:
            if below not in seen:
                seen.add(below)
                todo.append(below)
    return seen


def module_of(path):
    """The module of a path below src/, by the longest name in the table."""
    parts = pathlib.PurePath(path).parts
    for n in (3, 2, 1):
        if "/".join(parts[:n]) in BELOW:
            return "/".join(parts[:n])
    return None


def sources(*folders):
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".h", ".cpp", ".glsl"):
                yield path.relative_to(ROOT)


def owner_of(header):
    """The module of rakelight/MODULE/NAME.h or rakelight_internal/MODULE/NAME.h."""
    parts = pathlib.PurePath(header).parts
    if len(parts) == 2:
        return ROOT_HEADERS.get(pathlib.PurePath(header).stem)
    return parts[1] if len(parts) == 3 and parts[1] in BELOW else None


def check_public_include(where, module, name, wrong):
    owner = owner_of(name)
    if owner is None or not (ROOT / "include" / name).exists() and name != "rakelight/version.h":
        wrong.append(f"{where}: <{name}> does not exist; public headers are rakelight/MODULE/NAME.h, those of the programs rakelight_internal/MODULE/NAME.h")
    elif module and owner not in closure(module):
        wrong.append(f"{where}: {module} may not include <{name}>, which belongs to {owner}")
    if where.startswith("include/rakelight/") and name.startswith("rakelight_internal/"):
        wrong.append(f"{where}: <{name}> is not installed")


def check_library(where, module, name, wrong):
    for pattern, modules in LIBRARIES.items():
        if re.match(pattern, name) and module not in modules and where not in modules:
            wrong.append(f"{where}: <{name}> may be used by {', '.join(modules)} only")


def check_door(where, path, module, name, wrong):
    for engine, door in DOORS.items():
        is_above = not module.startswith(engine)
        is_door = door.fullmatch(str(pathlib.PurePath(*path.parts[1:])))
        if name.startswith(engine + "/") and (is_above or is_door) and not door.fullmatch(name):
            wrong.append(f"{where}: \"{name}\" is no door of {engine} (DOORS in tools/check/check_layers.py)")


def check_room(where, path, name, wrong):
    """Includes between the rooms of the soft engine."""
    room, other = (re.match(r"(?:src/)?engines/raster/(\w+)/", str(p)) for p in (path, name))
    if room is None or other is None or room[1] == other[1]:
        return
    if room[1] not in ROOMS:
        wrong.append(f"{where}: the room '{room[1]}' is not in ROOMS (tools/check/check_layers.py)")
    elif other[1] not in ROOMS[room[1]]:
        wrong.append(f"{where}: the room '{room[1]}' may not include \"{name}\" (ROOMS in tools/check/check_layers.py)")


def check_file(path, wrong):
    text = (ROOT / path).read_text()
    relative = str(path)
    is_public = relative.startswith("include/")
    in_src = relative.startswith("src/")
    module = module_of(path.relative_to("src")) if in_src else owner_of(path.relative_to("include")) if is_public else "/".join(path.parts[:2])
    if module is None:
        wrong.append(f"{relative}: in no module of the table")
        return
    for bracket, name in INCLUDE.findall(text):
        where = f"{relative}"
        if name.startswith(("rakelight/", "rakelight_internal/")):
            check_public_include(where, module if module in BELOW else None, name, wrong)
        elif bracket == "<":
            check_library(where, module, name, wrong)
            if is_public and ("/" in name or name.endswith(".h")):
                wrong.append(f"{where}: public headers name no library, found <{name}>")
        elif in_src:
            other = module_of(name)
            if not (ROOT / "src" / name).exists() and not name.endswith(".inc"):
                wrong.append(f"{where}: \"{name}\" does not exist; includes count from src/")
            elif other and other not in closure(module):
                wrong.append(f"{where}: {module} may not include \"{name}\"")
            check_door(where, path, module, name, wrong)
            check_room(where, path, name, wrong)
        elif is_public:
            wrong.append(f"{where}: public headers include only public headers, found \"{name}\"")
        if any(relative.startswith(f) for f in ISA_FILES) and not ISA_ALLOWED.fullmatch(name):
            wrong.append(f"{where}: is compiled per instruction set and may not include \"{name}\"")


def check_temporary_files(path, wrong):
    """Names that two processes may choose alike make tests of two users, or of two builds, disturb each other."""
    if path.name != "temporary_folder.h" and re.search(r"temp_directory_path|TempDir\(|mkdtemp|tmpnam|mkstemp", (ROOT / path).read_text()):
        wrong.append(f"{path}: tests have their files in a TemporaryFolder (tests/support/temporary_folder.h)")


# A function of a namespace, declared in a public header: what the shared library must show.
DECLARATION = re.compile(r"^(?!\s|RL_API\b|(?:inline|constexpr|template|class|struct|enum|using|namespace|static_assert)\b)(?:\[\[\w+\]\] )?"
                         r"(?!RL_API\b)[\w:<>,&* ]+[ &*](\w+)\(", re.M)


def check_export(path, wrong):
    text = (ROOT / path).read_text()
    for found in DECLARATION.finditer(text):
        above = text[:found.start()].rstrip("\n").rpartition("\n")[2]
        if not above.startswith("template"):
            wrong.append(f"{path}: {found.group(1)}() has no RL_API (rakelight/base/export.h): the shared library would hide it")


def check_glsl(path, wrong):
    code = re.sub(r"//[^\n]*", "", (ROOT / path).read_text())
    for word in sorted(set(re.findall(r"\b[a-z]\w*\b", code)) & GLSL_RESERVED):
        wrong.append(f"{path}: '{word}' is a reserved word of GLSL")


def template_arguments(code, begin):
    """The arguments of a template, given where its '<' stands."""
    depth, arguments = 0, [""]
    for character in code[begin:]:
        depth += (character in "<({") - (character in ">)}")
        if depth == 0:
            return [a.strip() for a in arguments]
        if depth == 1 and character == ",":
            arguments.append("")
        elif depth > 1 or character != "<":
            arguments[-1] += character
    return []


def check_hash_tables(path, wrong):
    """Texts and numbers of a file are hashed under the key of the run (base/name_table.h, base/hash_key.h). Pointers are the system's."""
    code = re.sub(r"//[^\n]*", "", (ROOT / path).read_text())
    for found in re.finditer(r"\bunordered_(?:multi)?(map|set)\s*(?=<)", code):
        arguments = template_arguments(code, found.end())
        has_hash = len(arguments) > (2 if found.group(1) == "map" else 1)
        if not has_hash and not arguments[0].endswith("*"):
            wrong.append(f"{path}: std::{found.group(0)} of '{arguments[0]}' has no hash with a key: take NameMap or NameSet (base/name_table.h), "
                         "folded_product (base/hash_key.h) or an ordered table")


# An option of a command line in a text: "--engine", "-o". Arguments of other programs, and words of a format, are in these files.
OPTION = re.compile(r"(?<![\w-])--[a-z]|(?:^|(?<=[\s'(]))-[a-z](?=[\s',);]|$)")
OPTIONS_OF_OTHERS = {"src/io/import/helper_process.cpp", "src/engines/opengl/programs/shader_check.cpp", "src/io/movie/ffmpeg_movies.cpp", "src/io/obj/mtl_map.cpp", "src/io/obj/obj_remarks.cpp",
                     "src/tools/stages/projection_stages.cpp", "src/tools/stages/shadow_stage.cpp"}


def strings_of(text):
    """(line, content) of the string literals, not of those in comments."""
    for number, line in enumerate(text.splitlines(), 1):
        for literal, _ in re.findall(r'"((?:[^"\\]|\\.)*)"|(//.*)', line):
            yield number, literal


def check_options(path, text, wrong):
    """A program that uses the library has no options: messages quote the key of a setting, 'engine'."""
    if str(path) in OPTIONS_OF_OTHERS or path.parts[0] not in ("src", "include") and path.parts[:2] != ("python", "src"):
        return
    for number, literal in strings_of(text):
        if OPTION.search(literal):
            wrong.append(f"{path}:{number}: the library does not know options (decision 9): quote the key, 'engine', and name it by naming() or in the remark")


# Mixing by a known constant. These are random numbers, or have a key or another bound beside it.
MIXER = re.compile(r"0x9e3779b9", re.I)
MIXES = {"src/base/hash_key.cpp", "src/bake/sky_rays.cpp", "src/engines/raytrace/paths/path_numbers.cpp", "src/geometry/weld/near_cells.cpp", "src/geometry/borders/border_proposal.cpp", "src/geometry/fast/fast_weld.cpp",
         "src/geometry/fast/fast_weld_types.h", "src/geometry/input/position_hash.h", "src/tools/bench/bench_model.cpp", "src/tools/bench/bench_scene.cpp", "src/tools/bench/bench_textures.cpp"}


def check_mixers(path, text, wrong):
    if str(path) not in MIXES and MIXER.search(text):
        wrong.append(f"{path}: mixes by a known constant: a file can choose numbers that collide; take folded_product() with the key of the run (base/hash_key.h)")


# What opens and closes, after comments and literals are off. A type that is only declared, or specialized, is none.
NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|R"\w*\(.*?\)\w*"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)\'|^[ \t]*#(?:[^\n]|\\\n)*', re.M | re.S)
BRACES = re.compile(r"\bnamespace\s*([\w:]*)\s*\{|\b(?:struct|class|union|enum(?:\s+class|\s+struct)?)\s+(?:RL_API\s+|alignas\([^)]*\)\s*)?(\w+)(?:\s+final)?(?:\s*:[^:;{()][^;{()]*)?\s*\{|[{}]")


def types_of(text):
    """Qualified names of the types of namespaces, but for those in a namespace without a name, which no other file sees."""
    stack = []  # the names of namespaces; None: anything else
    for match in BRACES.finditer(NOISE.sub(" ", text)):
        if match[0] == "}":
            stack = stack[:-1]
            continue
        if match[2] and None not in stack and "" not in stack:
            yield "::".join([*stack, match[2]])
        stack.append(match[1] if match[0].startswith("namespace") else None)


def check_one_definition(wrong):
    """Two types of one name in two files share the functions that a compiler makes for them: the linker keeps those of one."""
    seen = {}
    for path in sources("src", "include", "apps"):
        program = "/".join(path.parts[:2]) if path.parts[0] == "apps" else ""  # linked into one program each, all with apps/common
        for name in types_of((ROOT / path).read_text()):
            first = seen.setdefault(name, (path, program))
            if first[0] != path and "RL_ISA" not in name and (not program or not first[1] or program == first[1] or "apps/common" in (program, first[1])):
                wrong.append(f"{path}: {name} is also defined in {first[0]}")


def compile_alone(path):
    per_isa = "wide" in path.name or any(str(path).startswith(f) for f in ISA_FILES)
    if path.name in ("wide_scalar.h", "wide_xsimd.h", "wide_xsimd_memory.h", "wide_pair.h", "wide_functions.h", "wide_vector.h", "prelude.h"):
        return None  # parts of wide.h and lighting.h
    command = ["g++", "-std=c++20", "-fsyntax-only", "-x", "c++", "-I", "src", "-I", "include", "-Wall", "-Wno-pragma-once-outside-header"]
    command += ["-I", "build/release/include"] if (ROOT / "build/release/include").exists() else []
    command += ["-DRL_ISA=scalar", "-DRL_ISA_scalar=1"] if per_isa else []
    run = subprocess.run(command + [str(path)], cwd=ROOT, capture_output=True, text=True)
    return None if run.returncode == 0 else f"{path}: does not compile alone: {run.stderr.strip().splitlines()[0]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--compile", action="store_true", help="also compile every header alone")
    options = parser.parse_args()
    wrong = []
    for path in sources("src", "include", "apps", "examples", "python"):
        check_file(path, wrong)
        text = (ROOT / path).read_text()
        check_options(path, text, wrong)
        check_mixers(path, text, wrong)
        if path.parts[0] == "include":
            check_export(path, wrong)
        if path.parts[0] != "examples":
            check_hash_tables(path, wrong)
        if path.suffix == ".glsl":
            check_glsl(path, wrong)
    check_one_definition(wrong)
    for path in sources("tests", "fuzz", "bench"):
        check_temporary_files(path, wrong)
    if options.compile:
        headers = [p for p in sources("src", "include") if p.suffix == ".h"]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            wrong += [w for w in pool.map(compile_alone, headers) if w]
    print("\n".join(wrong) or "layers: every include goes down, every hash table has a key, no message of the library names an option")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
