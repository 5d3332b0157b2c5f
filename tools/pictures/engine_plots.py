#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plots of what tools/pictures/engine_curves.py measured, as SVG and PNG, for docs/ray-tracing-vs-rasterization.md.

  engine_plots.py CURVES.json OUT_FOLDER

Needs matplotlib (Debian: python3-matplotlib)."""
import argparse
import json
import pathlib

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

# Color and marker of each way, the same in all plots (Okabe and Ito's palette).
STYLES = {"z-buffer on the processor (soft)": ("#0072b2", "o"), "z-buffer by OpenGL (gl)": ("#56b4e9", "s"), "ray tracing (Whitted)": ("#d55e00", "^"),
          "casting": ("#e69f00", "v"), "casting, naive": ("#cc79a7", "x"), "paths, 4 a pixel": ("#009e73", "D")}
AXES = {"triangles": "triangles", "pixels": "pixels", "lights": "lights, each with shadows", "depth": "most reflections and refractions that a ray goes on after", "memory": "triangles"}


def plot(kind, rows, folder):
    value = "mb" if kind == "memory" else "ms"
    pyplot.rcParams.update({"svg.hashsalt": "rakelight", "font.size": 9, "svg.fonttype": "none"})
    figure, axes = pyplot.subplots(figsize=(6.4, 4.8), dpi=110)
    for way, (color, marker) in STYLES.items():
        points = sorted((row for row in rows if row["way"] == way), key=lambda row: row["x"])
        if not points:
            continue
        y = [row[value] for row in points]
        bars = [[row[value] - row.get("low", row[value]) for row in points], [row.get("high", row[value]) - row[value] for row in points]]
        axes.errorbar([row["x"] for row in points], y, yerr=bars, label=way, color=color, marker=marker, markersize=4, linewidth=1.3, capsize=2)
    if kind == "depth":
        axes.set_xscale("symlog", base=2, linthresh=1)
        axes.set_xticks([0, 1, 2, 4, 8, 16], [0, 1, 2, 4, 8, 16])
    elif kind == "lights":
        axes.set_xscale("log", base=2)
        axes.set_xticks([1, 2, 4, 8], [1, 2, 4, 8])
    else:
        axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(AXES[kind])
    axes.set_ylabel("most memory of the program [MiB]" if kind == "memory" else "time of a picture [ms]")
    axes.grid(True, which="major", linewidth=0.4, color="#cccccc")
    axes.legend(fontsize=8, frameon=False, loc="upper center", bbox_to_anchor=(0.5, -0.14), ncol=2)
    figure.tight_layout()
    for ending in ("svg", "png"):
        metadata = {"Date": None} if ending == "svg" else {"Software": None}
        figure.savefig(folder / f"curves-{kind}.{ending}", metadata=metadata)
    pyplot.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("curves", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    options = parser.parse_args()
    curves = json.loads(options.curves.read_text())["curves"]
    options.folder.mkdir(parents=True, exist_ok=True)
    for kind, rows in curves.items():
        plot(kind, rows, options.folder)


if __name__ == "__main__":
    main()
