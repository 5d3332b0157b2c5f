#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes lighting_values.inc: what the lighting text must give, computed here in double from the published equations.

Independent of the C++: the mirrored and the halfway direction are made as vectors, powers are Python's. Colors are 1.
    python3 lighting_values.py > lighting_values.inc
"""
import math
import random


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


def power(base, exponent):
    return math.pow(base, exponent) if base > 0 else 0.0


def specular(model, form, horizon, n, l, v, e):
    n_dot_l = dot(n, l)
    if model == "phong":
        mirrored = tuple(2 * n_dot_l * n_i - l_i for n_i, l_i in zip(n, l))
        lobe = power(dot(mirrored, v), e)
        brdf = (e + 2) / (2 * math.pi) * lobe
    else:
        halfway = unit(tuple(a + b for a, b in zip(l, v)))
        lobe = power(dot(n, halfway), e)
        brdf = (e + 2) * (e + 4) / (8 * math.pi * (2 ** (-e / 2) + e)) * lobe
    if horizon and n_dot_l <= 0:
        return 0.0
    if form == "normalized":  # irradiance of a light of color 1 is pi
        return brdf * math.pi * max(n_dot_l, 0.0)
    return lobe


def row(n, l, v, e):
    n, l, v = unit(n), unit(l), unit(v)
    numbers = [*n, *l, *v, e, max(0.0, dot(n, l))]
    for model in ("phong", "blinn-phong"):
        for form, horizon in (("textbook", True), ("textbook", False), ("normalized", True)):
            numbers.append(specular(model, form, horizon, n, l, v, e))
    print("RL_TERMS(" + ", ".join(f"{x:.9g}" for x in numbers) + ")")


def main():
    print("// SPDX-License-Identifier: Apache-2.0")
    print("// Written by lighting_values.py. n, l, v, exponent, diffuse; Phong textbook, textbook without horizon, normalized; Blinn-Phong alike.")
    row((0, 0, 1), (0, 0, 1), (0, 0, 1), 1)
    row((0, 0, 1), (1, 0, 1), (-1, 0, 1), 20)
    row((0, 0, 1), (1, 0, 1), (1, 0, 1), 20)
    row((0, 0, 1), (1, 0, -0.1), (-1, 0, 0.2), 5)   # light below the horizon, viewer above
    row((0, 0, 1), (1, 0, -0.1), (-1, 0, 0.4), 5)
    numbers = random.Random(1975)
    for _ in range(120):
        n = tuple(numbers.gauss(0, 1) for _ in range(3))
        v = tuple(n_i + 0.8 * numbers.gauss(0, 1) for n_i in n)
        l = tuple(n_i + 1.5 * numbers.gauss(0, 1) for n_i in n)
        row(n, l, v, numbers.choice([1, 2, 5, 10, 48, 200]))
    print("// constant, linear, quadratic, distance, attenuation")
    for c, k, q, d in ((1, 0, 0, 7), (1, 0.1, 0.01, 10), (0, 0, 1, 4), (0.5, 2, 0, 3), (1, 1, 1, 0)):
        print(f"RL_ATTENUATION({c:.9g}, {k:.9g}, {q:.9g}, {d:.9g}, {1 / (c + k * d + q * d * d):.9g})")
    print("// distance, range (0: none), factor of KHR_lights_punctual")
    for d, r in ((2, 0), (2, 10), (9.5, 10), (10, 10), (11, 10)):
        window = 1 if r == 0 else max(min(1 - (d / r) ** 4, 1), 0)
        print(f"RL_RANGE({d:.9g}, {r:.9g}, {window / (d * d):.9g})")
    print("// angle, inner, outer [degrees], factor of KHR_lights_punctual")
    for angle, inner, outer in ((0, 10, 30), (10, 10, 30), (20, 10, 30), (29, 10, 30), (30, 10, 30), (50, 10, 30), (44, 0, 45)):
        cos_i, cos_o, cos_a = (math.cos(math.radians(x)) for x in (inner, outer, angle))
        t = max(0.0, min(1.0, (cos_a - cos_o) / (cos_i - cos_o)))
        print(f"RL_CONE({angle:.9g}, {inner:.9g}, {outer:.9g}, {t * t:.9g})")


if __name__ == "__main__":
    main()
