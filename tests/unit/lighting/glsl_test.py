#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The lighting text is GLSL: a compiler takes it as a fragment shader of 3.30 core and of ES 3.00, every function called.

Usage: glsl_test.py SOURCE_FOLDER     (the repository)
Exit code 77 (skipped, said aloud) without glslangValidator; the checks of words and of the list run before that.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# Reserved or built in somewhere among GLSL 3.30, ES 3.00 and later ones: never names of ours.
RESERVED = set("active half input output filter common partition smooth flat shared fixed sample patch buffer resource precise "
               "superp noise namespace using template this packed goto inline noinline volatile public static extern external "
               "interface long short unsigned union enum typedef cast sizeof class asm texture".split())
SWIZZLE = re.compile(r"\.(?:[xyzw]{2,4}|[rgba]{1,4}|[stpq]{1,4})\b(?!\s*\()")
FORBIDDEN = re.compile(r"\b(out|inout|uniform|const|auto|template|dFdx|dFdy|gl_\w+|texture\w*|discard|break|while|do|goto)\b|#include|\?")
VERSIONS = {"330 core": "", "300 es": "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"}
# GLSL alone: the words and maps that C++ has in headers.
GLSL_ONLY = ("math/prelude.glsl", "lighting/maps.glsl", "lighting/albedo_tables.glsl", "image/agx_curves.glsl",
             "lighting/occlusion/depth_maps.glsl")
# Texts of passes over whole pictures: no part of lighting.h.
OF_PASSES = ("image/tone.glsl", "lighting/occlusion/horizons.glsl")


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


def listed_files(source):
    lines = (source / "lighting/all.glsl.list").read_text(encoding="utf-8").splitlines()
    return ["lighting/" + line.strip() for line in lines if line.strip() and not line.startswith("#")]


def faults_of_list(source, names):
    faults = []
    there = {str(path.relative_to(source)) for path in (source / "lighting").rglob("*.glsl")} - set(GLSL_ONLY) - set(OF_PASSES)
    if there != set(names) or len(names) != len(set(names)):
        faults.append(f"all.glsl.list and the folder differ: {sorted(there ^ set(names))}")
    included = re.findall(r'#include "(lighting/[\w/]+\.glsl)"', (source / "lighting/lighting.h").read_text(encoding="utf-8"))
    if included != names:
        faults.append("lighting.h includes in another order than all.glsl.list")
    return faults


def faults_of_words(name, text):
    code = without_comments(text)
    faults = [f"{name}: '{word}' is a reserved word of GLSL" for word in sorted(set(re.findall(r"\b[A-Za-z_]\w*", code)) & RESERVED)]
    if name not in GLSL_ONLY:  # the rest is a subset
        faults += [f"{name}: '{match}' is outside the subset" for match in sorted(set(m[0] for m in FORBIDDEN.finditer(code)))]
        faults += [f"{name}: swizzle '{match}'" for match in sorted(set(m[0] for m in SWIZZLE.finditer(code)))]
        faults += [f"{name}: literal '{match}' without f" for match in sorted(set(re.findall(r"(?<![\w.])\d+\.\d*(?:e[-+]?\d+)?(?![\w.])", code)))]
    return faults


def calls_of(text):
    """A statement for each RL_FN function: called with zeros of its parameters' types, so that nothing is left out."""
    statements, count = [], 0
    plain = re.sub(r"RL_IN(?:OUT)?\((\w+)\)", r"\1", without_comments(text))
    for result, name, parameters in re.findall(r"RL_(?:MAP_)?FN\s+(\w+)\s+(\w+)\s*\(([^)]*)\)", plain):
        arguments = []
        for parameter in filter(None, (p.strip() for p in parameters.split(","))):
            kind = parameter.split()[0]
            statements.append(f"    {kind} a{count};")
            if kind == "real":
                statements.append(f"    a{count} = seed;")
            arguments.append(f"a{count}")
            count += 1
        call = f"{name}({', '.join(arguments)});"
        statements.append(f"    {call}" if result == "void" else f"    {result} r{count} = {call}")
        if result == "real":
            statements.append(f"    total += r{count};")
        elif result == "vec3":
            statements.append(f"    total += dot(r{count}, vec3(1.0f));")
        count += 1
    return statements


def compile_as(version, header, text, statements):
    main = "\n".join(["uniform float seed;", "out vec4 color;", "void main()", "{", "    float total = 0.0f;", *statements,
                      "    color = vec4(total);", "}"])
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "all.frag"
        path.write_text(f"#version {version}\n{header}{text}\n{main}\n", encoding="utf-8")
        done = subprocess.run(["glslangValidator", str(path)], capture_output=True, text=True, check=False)
        return [] if done.returncode == 0 else [f"#version {version}: {done.stdout.strip()}"]


def main():
    source = pathlib.Path(sys.argv[1]) / "src"
    listed = listed_files(source)
    names = [*listed, *OF_PASSES]
    texts = {name: (source / name).read_text(encoding="utf-8") for name in [*GLSL_ONLY, *names]}
    faults = faults_of_list(source, listed)
    for name, text in texts.items():
        faults += faults_of_words(name, text)
    statements = calls_of("".join(texts[name] for name in names))
    calls = sum("(" in s for s in statements)
    if calls < 20:
        faults.append(f"only {calls} functions found: has the text another form now?")
    has_compiler = shutil.which("glslangValidator") is not None
    if has_compiler:
        for version, header in VERSIONS.items():
            faults += compile_as(version, header, "".join(texts.values()), statements)
    for fault in faults:
        print(fault)
    if faults:
        return 1
    if not has_compiler:
        print("SKIPPED: glslangValidator (glslang-tools) is not installed; only words and list were checked")
        return 77
    print(f"{calls} functions in {len(names)} files compile as {' and '.join(VERSIONS)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
