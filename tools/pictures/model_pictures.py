#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Lighting models (rows) by roughness (columns) on a sphere, for docs/lighting-models.md.

  model_pictures.py [--program build/release/rakelight] OUT.png

Each sphere is a world file with one material. Only the standard library is needed."""
import argparse
import pathlib
import tempfile

from sheet import PROGRAM, write_sheet

WORLD = """[[primitive]]
type = "sphere"
material = "m"

[[camera]]
position = [0, 0, 5]
target = [0, 0, 0]
orthographic_height = 2.1

[[light]]
type = "directional"
direction = [0.6, -0.6, -0.8]

[[light]]
type = "directional"
direction = [-0.8, -0.2, -0.4]
diffuse = [0.25, 0.25, 0.3]

[[light]]
type = "ambient"
ambient = [0.12, 0.12, 0.12]

[render]
background = "#6f707a"

[[material]]
name = "m"
"""
PLASTIC, METAL, STEEL = "color = [0.52, 0.07, 0.03]\nmetallic = 0", "color = [0.79, 0.52, 0.17]\nmetallic = 1", "color = [0.6, 0.58, 0.55]\nmetallic = 1"
ROUGH = "roughness = {}"
MODELS = {  # what stands left of the row: its material
    "oren-nayar": f'{PLASTIC}\n{ROUGH}\nlighting = "oren-nayar"',
    "phong": f'{PLASTIC}\n{ROUGH}\nlighting = "phong"',
    "blinn-phong": f'{PLASTIC}\n{ROUGH}\nlighting = "blinn-phong"',
    "blinn-phong, metal": f'{METAL}\n{ROUGH}\nlighting = "blinn-phong"',
    "ward": f'{PLASTIC}\n{ROUGH}\nlighting = "ward"',
    "ward, metal": f'{METAL}\n{ROUGH}\nlighting = "ward"',
    "pbr": f'{PLASTIC}\n{ROUGH}\nlighting = "pbr"',
    "pbr, metal": f'{METAL}\n{ROUGH}\nlighting = "pbr"',
    "brushed up": f'{STEEL}\n{ROUGH}\nanisotropy = 0.8',
    "brushed around": f'{STEEL}\n{ROUGH}\nanisotropy = 0.8\nanisotropy_rotation_deg = 90',
    "clearcoat": f'{PLASTIC}\nroughness = 0.7\nclearcoat = 1\nclearcoat_roughness = {{}}',
    "sheen": 'color = [0.03, 0.06, 0.2]\nmetallic = 0\nroughness = 0.9\nsheen_color = [0.8, 0.7, 0.6]\nsheen_roughness = {}',
}
COLUMNS = ("0.1", "0.3", "0.5", "0.7", "1")
WIDTH, HEIGHT = 64, 64


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows = []
        for m, model in enumerate(MODELS.values()):
            files = [pathlib.Path(folder) / f"{m}-{c}.scene.toml" for c in range(len(COLUMNS))]
            for file, column in zip(files, COLUMNS):
                file.write_text(WORLD + model.format(column) + "\n")
            rows.append([(str(file),) for file in files])
        write_sheet(options.picture, rows, WIDTH, HEIGHT, options.program, samples=4, columns=COLUMNS, lines=tuple(MODELS), colors=256)


if __name__ == "__main__":
    main()
