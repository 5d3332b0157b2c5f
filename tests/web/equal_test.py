#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The program in Node beside the native one: the same bytes, the same exit codes.

    equal_test.py NATIVE CLI.js SHARED [--only smooth|render|hostile] [MODEL...]

Models are the GLB, OBJ, STL and PLY files of SHARED/assets, broken files those of SHARED/hostile. What the web build leaves out
(Draco, meshopt, KTX2, WebP textures) is counted, not compared.
"""
import argparse
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile

ENDINGS = {".glb", ".obj", ".stl", ".ply"}
LEFT_OUT = "this build leaves"


def run(command, output):
    done = subprocess.run([*command, "-o", output], capture_output=True, text=True, timeout=600)
    data = output.read_bytes() if output.exists() else None
    return done.returncode, data, done.stderr


def compare(job, native, web):
    verb, model = job
    ending = {"smooth": ".ply" if model.suffix.lower() == ".ply" else ".obj" if model.suffix.lower() == ".obj" else ".glb", "render": ".png"}[verb]
    options = {"smooth": [], "render": ["--resolution", "320,240"]}[verb]
    with tempfile.TemporaryDirectory() as folder:
        # Outputs of one name, as OBJ files name their materials' file.
        results = []
        for program, name in ((native, "native"), (web, "web")):
            place = pathlib.Path(folder, name)
            place.mkdir()
            results.append(run([*program, verb, model, *options], place / f"out{ending}"))
    (code, data, text), (web_code, web_data, web_text) = results
    if LEFT_OUT in web_text:
        return "left out"
    if code != web_code:
        return f"exit code {web_code}, not {code}: {web_text.strip()[:200]}"
    if data != web_data:
        return "other bytes"
    return ""


def verdict(model, native, web):
    codes = []
    for program in (native, web):
        done = subprocess.run([*program, "inspect", model, "--json"], capture_output=True, text=True, timeout=600)
        if LEFT_OUT in done.stdout + done.stderr:
            return "left out"
        codes.append(done.returncode)
    return "" if codes[0] == codes[1] else f"exit code {codes[1]}, not {codes[0]}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("native")
    parser.add_argument("cli")
    parser.add_argument("shared", type=pathlib.Path)
    parser.add_argument("--only")
    parser.add_argument("models", nargs="*", type=pathlib.Path)
    args = parser.parse_args()
    native, web = [args.native], ["node", args.cli]
    models = args.models or sorted(p for p in (args.shared / "assets").rglob("*") if p.suffix.lower() in ENDINGS)
    broken = sorted(p for p in (args.shared / "hostile").rglob("*") if p.suffix.lower() in ENDINGS | {".gltf"})
    jobs = [(verb, model) for verb in ("smooth", "render") if args.only in (None, verb) for model in models]
    if args.only in (None, "hostile") and not args.models:
        jobs += [("hostile", model) for model in broken]
    counts, wrong = {}, []
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        results = pool.map(lambda job: verdict(job[1], native, web) if job[0] == "hostile" else compare(job, native, web), jobs)
        for (verb, model), result in zip(jobs, results):
            kind = (verb, "left out" if result == "left out" else "wrong" if result else "equal")
            counts[kind] = counts.get(kind, 0) + 1
            if kind[1] == "wrong":
                wrong.append(f"{verb} {model}: {result}")
                print(wrong[-1], flush=True)
    print(", ".join(f"{verb} {kind} {count}" for (verb, kind), count in sorted(counts.items())))
    return 1 if wrong else 0


sys.exit(main())
