#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a picture costs by each engine, against triangles, pixels, lights and depth of reflections, and how much memory.

  engine_curves.py OUT.json [--program build/release/rakelight] [--rounds 3] [--frames 5] [--only triangles,pixels,lights,depth,memory] [--small]

Scenes are those of `rakelight bench render`; of depth data/rays/glass.scene.toml. Rounds go through all cases in turn, so that a slow moment of the
machine meets all of them. A point is the median over the rounds of the medians of their frames, its bar reaches from the fastest median to the slowest.
--small: a tenth of the sizes, for tests. tools/pictures/engine_plots.py draws the result. Only the standard library is needed."""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
GLASS = ROOT / "data/rays/glass.scene.toml"
PLAIN = ("--look", "plain")
RASTER = "soft,gl"
# What is measured: name, words of the program, engines.
PATHS = "paths, 4 a pixel"
WAYS = {"raster": ((), RASTER), "ray tracing (Whitted)": (("--method", "whitted"), "trace"), PATHS: (("--method", "path", "--samples", "4"), "trace"),
        "casting": (("--method", "cast"), "trace"), "casting, naive": (("--method", "cast", "--naive"), "trace")}
NAMES = {"soft": "z-buffer on the processor (soft)", "gl": "z-buffer by OpenGL (gl)"}
MOST_TESTS = 2.5e9  # of the naive loop: rays times triangles


def cases(kind, small):
    """x, words of bench, and which ways, of one curve."""
    cut = 10 if small else 1
    if kind == "triangles":
        for n in (1000, 10_000, 100_000, 1_000_000, 4_000_000):
            ways = [w for w in WAYS if w != "casting, naive" or 640 * 360 * n <= MOST_TESTS]
            yield n // cut, ("--triangles", str(n // cut), "--resolution", "640,360", "--lights", "2"), ways
    elif kind == "pixels":
        for w, h in ((160, 90), (320, 180), (640, 360), (1280, 720), (2560, 1440)):
            ways = [way for way in WAYS if (way != "casting, naive" or w * h * 10_000 <= MOST_TESTS) and (way != PATHS or w <= 1280)]
            yield w * h // cut ** 2, ("--triangles", str(10_000 // cut), "--resolution", f"{w // cut},{h // cut}", "--lights", "2"), ways
    elif kind == "lights":
        for n in (1, 2, 4, 8):
            yield n, ("--triangles", str(100_000 // cut), "--resolution", f"{640 // cut},{360 // cut}", "--lights", str(n), "--shadows"), [w for w in WAYS if w != "casting, naive"]
    else:
        for depth in (0, 1, 2, 4, 8, 16):
            words = (str(GLASS), "--resolution", f"{640 // cut},{360 // cut}", "--max-depth", str(depth))
            yield depth, words, ["ray tracing (Whitted)", PATHS, "raster"]


def bench(program, words, frames):
    command = [program, "bench", "render", *words, "--frames", str(frames), "--json", "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def has_engine(program, name):
    text = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    return name in text.split("engines:")[-1].splitlines()[0]


def measure(program, kind, options, engines_there):
    found = {}
    for _ in range(options.rounds):
        for x, words, ways in cases(kind, options.small):
            for way in ways:
                extra, engines = WAYS[way]
                engines = [e for e in engines.split(",") if e in engines_there]
                if not engines:
                    continue
                frames = 1 if "--naive" in extra else min(options.frames, 2) if way == PATHS else options.frames
                report = bench(program, [*words, *PLAIN, *extra, "--engine", ",".join(engines)], frames)
                for row in report["rows"]:
                    entry = found.setdefault((NAMES.get(row["engine"], way), x), {"ms": [], "first_ms": []})
                    entry["ms"].append(row["median_ms"]), entry["first_ms"].append(row["first_ms"])
                print(f"{kind} {x}: {way} " + ", ".join(f"{r['median_ms']:.2f} ms" for r in report["rows"]), file=sys.stderr)
    return [{"way": way, "x": x, "ms": statistics.median(e["ms"]), "low": min(e["ms"]), "high": max(e["ms"]), "first_ms": statistics.median(e["first_ms"])}
            for (way, x), e in found.items()]


def peak_mb(command):
    """Most memory that a process had."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = status
    if status != 0:
        raise SystemExit(f"{' '.join(map(str, command))}: failed")
    return usage.ru_maxrss / 1024


def memory(program, options, engines_there):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for n in (10_000, 100_000, 1_000_000, 4_000_000):
            n //= 10 if options.small else 1
            scene = pathlib.Path(folder) / "scene.glb"
            bench(program, ["--triangles", str(n), "--resolution", "64,36", "--engine", "soft", "--export", str(scene)], 1)
            for engine, way in (("soft", NAMES["soft"]), ("gl", NAMES["gl"]), ("trace", "ray tracing (Whitted)")):
                if engine in engines_there:
                    rows.append({"way": way, "x": n, "mb": peak_mb([program, "render", scene, "-o", f"{folder}/a.png", "--resolution", "640,360", "--engine", engine, *PLAIN])})
                    print(f"memory {n}: {way} {rows[-1]['mb']:.0f} MB", file=sys.stderr)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/rakelight")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--frames", type=int, default=5)
    parser.add_argument("--only", default="triangles,pixels,lights,depth,memory")
    parser.add_argument("--small", action="store_true")
    options = parser.parse_args()
    program = options.program.resolve()
    engines = {e for e in ("soft", "gl", "trace") if has_engine(program, e)}
    curves = json.loads(options.output.read_text())["curves"] if options.output.exists() else {}
    for kind in options.only.split(","):
        curves[kind] = memory(program, options, engines) if kind == "memory" else measure(program, kind, options, engines)
        options.output.write_text(json.dumps({"schema": "rakelight.engine-curves/1", "threads": os.cpu_count(), "curves": curves}, indent=1) + "\n")


if __name__ == "__main__":
    main()
