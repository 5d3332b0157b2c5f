#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes iridescence_values.inc: reflectances of films, computed here in double from the publications.

Independent of the GLSL: Airy's sum by complex amplitudes of each order instead of cosines, lengths in meters, the Gaussians of the
sensitivities as published (Belcour & Barla 2017, supplement; KHR_materials_iridescence, appendix).
    python3 iridescence_values.py > iridescence_values.inc
"""
import cmath
import math
import random

GAUSSIANS = [[(5.4856e-13, 1.6810e6, 4.3278e9), (9.7470e-14, 2.2399e6, 4.5282e9)], [(4.4201e-13, 1.7953e6, 9.3046e9)],
             [(5.2481e-13, 2.2084e6, 6.6121e9)]]
NORM = 1.0685e-7
XYZ_TO_RGB = [[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560], [0.0556434, -0.2040259, 1.0572252]]


def sensitivity(difference, shift):
    """Of a path difference [m]; shift: of the phase, one a component."""
    phase = 2 * math.pi * difference
    xyz = [sum(v * math.sqrt(2 * math.pi * var) * (cmath.exp(1j * (pos * phase + s)).real) * math.exp(-var * phase ** 2)
               for v, pos, var in gaussians) / NORM for gaussians, s in zip(GAUSSIANS, shift)]
    return [sum(m * x for m, x in zip(row, xyz)) for row in XYZ_TO_RGB]


def schlick(f0, cosine):
    return f0 + (1 - f0) * (1 - cosine) ** 5


def reflectance_of(n1, n2):
    return ((n2 - n1) / (n2 + n1)) ** 2


def film(f0, index, thickness, cosine):
    inside = math.cos(math.asin(math.sin(math.acos(cosine)) / index))
    r12 = schlick(reflectance_of(1, index), cosine)
    t121 = 1 - r12
    r23, shift = [], []
    for f in f0:
        root = math.sqrt(min(f, 0.9999))
        base = (1 + root) / (1 - root)
        r23.append(schlick(reflectance_of(index, base), inside))
        shift.append(math.pi + (math.pi if base < index else 0))
    difference = 2 * index * thickness * inside
    orders = [sensitivity(m * difference, [m * s for s in shift]) for m in (1, 2)]
    out = []
    for c in range(3):
        r123 = min(max(r12 * r23[c], 1e-5), 0.9999)
        rs = t121 ** 2 * r23[c] / (1 - r123)
        value = r12 + rs + sum((rs - t121) * math.sqrt(r123) ** m * 2 * orders[m - 1][c] for m in (1, 2))
        out.append(min(max(value, 0), 1))
    return out


def main():
    random.seed(5)
    print("// SPDX-License-Identifier: Apache-2.0")
    print("// Written by iridescence_values.py. f0 of the base; index, thickness [um] of the film; cosine; reflectance.")
    rows = [((0.04, 0.04, 0.04), 1.3, t, c) for t in (0.0, 0.1, 0.4) for c in (1.0, 0.5, 0.05)]
    for _ in range(120):
        rows.append((tuple(round(random.uniform(0, 1), 3) for _ in range(3)), round(random.uniform(1.01, 2), 3),
                     round(random.uniform(0, 1.2), 3), round(random.uniform(0.02, 1), 3)))
    for f0, index, thickness, cosine in rows:
        numbers = [*f0, index, thickness, cosine, *film(f0, index, thickness * 1e-6, cosine)]
        print("RL_FILM(" + ", ".join("%.9g" % x for x in numbers) + ")")


if __name__ == "__main__":
    main()
