#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A world of a hundred balls on a floor under many lamps that thin out by 1 / (1 + 4 d^2) and have no range.

  make_many_lights.py OUT.scene.toml [LIGHTS] [CUTOFF]

LIGHTS (default 1000) stand over the floor by the sequence of Roberts 2018, half a meter to one high, of all colors, as
bright together whatever their number. CUTOFF goes into [render] as light-cutoff."""
import sys

SIDE, STEPS = 20.0, (0.7548776662466927, 0.5698402909980532)


def world(count=1000, cutoff=None):
    text = ["[render]", "resolution = [1280, 720]"]
    if cutoff:
        text.append(f"light-cutoff = {cutoff}")
    text += ["[[camera]]", "position = [0, 7, 15]", "target = [0, 0, 0.5]", "[[primitive]]", 'type = "plane"', f"size = [{SIDE}, {SIDE}]",
             'material = "white"', "[[material]]", 'name = "white"', "color = [0.8, 0.8, 0.8]", "specular = [0.3, 0.3, 0.3]", "shininess = 40"]
    for i in range(100):
        x, z = 2.0 * (i % 10) - 9, 2.0 * (i // 10) - 9
        text += ["[[primitive]]", 'type = "sphere"', "radius = 0.5", "tolerance = 0.002", f"position = [{x}, 0.5, {z}]",
                 'material = "white"']
    for i in range(count):
        x, z = (SIDE * ((0.5 + (i + 1) * step) % 1 - 0.5) for step in STEPS)
        color = [round(120 / count * (0.3 + 0.7 * ((i * k) % 7) / 6), 6) for k in (1, 3, 5)]
        text += ["[[light]]", 'type = "point"', f"position = [{x:.4f}, {0.5 + 0.5 * (i % 5) / 4:.3f}, {z:.4f}]",
                 "attenuation = [1, 0, 4]", f"diffuse = {color}"]
    return "\n".join(text) + "\n"


def main():
    with open(sys.argv[1], "w", encoding="ascii") as file:
        file.write(world(int(sys.argv[2]) if len(sys.argv) > 2 else 1000, *sys.argv[3:4]))


if __name__ == "__main__":
    main()
