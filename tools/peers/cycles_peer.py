#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Paths beside Blender Cycles, in turns on the same machine: time and error of pictures with as many samples, as a table.

  cycles_peer.py [--program build/release/rakelight] [--samples 64] [--rounds 3] [--threads 2] HELMET.gltf

HELMET is FlightHelmet.gltf of the glTF sample assets. Needs Blender 3.4 (data/paths/reference/README.md). The time is that of the fastest round,
without loading and without the ray tree. MSE: mean of squared differences over pixels and colors, linear, mean over the rounds: against a
long picture by the same program, so that it is noise alone. Cycles' long pictures are those of data/paths/reference."""
import argparse
import json
import os
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CYCLES = ("blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", ROOT / "tools/peers/cycles_reference.py", "--")
REFERENCE = ROOT / "data/paths/reference"
LONG = 2048  # samples of our long pictures
HELMET = ("--camera-position", "0.5,0.5,0.9", "--camera-focal-point", "0,0.36,0", "--camera-view-angle", "40",
          "--hdri-file", ROOT / "data/paths/sky.hdr")


def scenes(helmet):
    """Name, long picture by Cycles, words for both, words for ours alone."""
    return [("Cornell box, 256 x 256", "cornell.exr", (ROOT / "data/paths/cornell.scene.toml", "--resolution", "256,256"), ()),
            ("FlightHelmet in a sky, 640 x 360", "helmet-sky.exr", (helmet, "--resolution", "640,360", *HELMET),
             ("--cull", "none", "--hdri-ambient", "--hdri-skybox"))]


def run(words):
    plain = {**os.environ, "PATH": "/usr/bin:/bin"}  # Blender takes the modules of the first Python that it finds
    return subprocess.run(list(map(str, words)), check=True, capture_output=True, text=True, cwd=ROOT, env=plain).stdout


def ours(program, words, extra, samples, seed, threads, out):
    """Seconds."""
    said = run((program, "render", *words, *extra, "--engine", "trace", "--method", "path", "--max-depth", 8, "--samples", samples, "--seed", seed,
                "--threads", threads, "-o", out, "--json"))
    return json.loads(said)["rows"][0]["render_ms"] / 1000


def cycles(words, samples, seed, threads, out):
    """Seconds."""
    said = run((*CYCLES, *words, "--samples", samples, "--seed", seed, "--threads", threads, "-o", out))
    line = next(line for line in said.splitlines() if line.startswith("cycles render_time:"))
    parts = line.split(": ")[1].split(":")
    return sum(float(part) * 60 ** k for k, part in enumerate(reversed(parts)))


def mse(program, one, other):
    done = subprocess.run([program, "compare", one, other, "--json"], capture_output=True, text=True)
    return json.loads(done.stdout)["rows"][0]["rmse"] ** 2


def row(name, time, errors, base=None):
    error = sum(errors) / len(errors)
    relative = f"{time * error / base:.2f}" if base else "1"
    print(f"| {name} | {time:.2f} s | {error:.2e} | {relative} |", flush=True)
    return time * error


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("helmet", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/rakelight")
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    options = parser.parse_args()
    program = options.program.resolve()
    print("| scene and program | time | MSE | time x MSE, of Cycles' |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        long, out = pathlib.Path(folder) / "long.exr", pathlib.Path(folder) / "out.exr"
        for name, reference, words, extra in scenes(options.helmet.resolve()):
            ours(program, words, extra, LONG, 1000, options.threads, long)
            times, errors = ([], []), ([], [])
            for seed in range(1, options.rounds + 1):
                times[0].append(cycles(words, options.samples, seed, options.threads, out))
                errors[0].append(mse(program, REFERENCE / reference, out))
                times[1].append(ours(program, words, extra, options.samples, seed, options.threads, out))
                errors[1].append(mse(program, long, out))
            base = row(f"{name}: Cycles 3.4", min(times[0]), errors[0])
            row(f"{name}: paths", min(times[1]), errors[1], base)


if __name__ == "__main__":
    main()
