#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes material_values.inc: Oren-Nayar, Ward, GGX and sheen, computed here in double from the published equations.

Independent of the C++: by angles and trigonometric functions where that has vectors.
    python3 material_values.py > material_values.inc
"""
import math
import random


def direction(theta, phi):
    return (math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta))


def oren_nayar(light, viewer, sigma):  # eq. 30 over rho
    a = 1 - 0.5 * sigma ** 2 / (sigma ** 2 + 0.33)
    b = 0.45 * sigma ** 2 / (sigma ** 2 + 0.09)
    alpha, beta = max(light[0], viewer[0]), min(light[0], viewer[0])
    return (a + b * max(0.0, math.cos(viewer[1] - light[1])) * math.sin(alpha) * math.tan(beta)) / math.pi


def halfway(light, viewer):
    """Not unit; then the angle to the normal and about it."""
    h = [a + b for a, b in zip(direction(*light), direction(*viewer))]
    return h, math.atan2(math.hypot(h[0], h[1]), h[2]), math.atan2(h[1], h[0])


def ward(light, viewer, ax, ay, form):
    h, delta, phi = halfway(light, viewer)
    lobe = math.exp(-math.tan(delta) ** 2 * (math.cos(phi) ** 2 / ax ** 2 + math.sin(phi) ** 2 / ay ** 2))
    cosines = math.cos(light[0]) * math.cos(viewer[0])
    if form == "bounded":  # with h as it comes
        return lobe / (math.pi * ax * ay) * sum(x * x for x in h) / h[2] ** 4
    return lobe / (4 * math.pi * ax * ay) / (math.sqrt(cosines) if form == "1992" else cosines)


def smith_lambda(d, ax, ay):
    width = (ax * math.cos(d[1])) ** 2 + (ay * math.sin(d[1])) ** 2
    return 0.5 * (math.sqrt(1 + width * math.tan(d[0]) ** 2) - 1)


def ggx(light, viewer, ax, ay):
    _, delta, phi = halfway(light, viewer)
    e = math.tan(delta) ** 2 * (math.cos(phi) ** 2 / ax ** 2 + math.sin(phi) ** 2 / ay ** 2)
    d = 1 / (math.pi * ax * ay * math.cos(delta) ** 4 * (1 + e) ** 2)
    g = 1 / (1 + smith_lambda(light, ax, ay) + smith_lambda(viewer, ax, ay))
    return d * g / (4 * math.cos(light[0]) * math.cos(viewer[0]))


def sheen_lambda(cosine, alpha):
    w = (1 - alpha) ** 2
    a, b, c, d, e = (w * p + (1 - w) * q for p, q in zip((25.3245, 3.32435, 0.16801, -1.27393, -4.85967),
                                                        (21.5473, 3.82987, 0.19823, -1.97760, -4.32054)))

    def fit(x):
        return a / (1 + b * math.pow(x, c)) + d * x + e
    return math.exp(fit(cosine)) if cosine < 0.5 else math.exp(2 * fit(0.5) - fit(1 - cosine))


def sheen(light, viewer, alpha):
    _, delta, _ = halfway(light, viewer)
    d = (2 + 1 / alpha) * math.sin(delta) ** (1 / alpha) / (2 * math.pi)
    c, k = math.cos(light[0]), math.cos(viewer[0])
    return d / ((1 + sheen_lambda(c, alpha) + sheen_lambda(k, alpha)) * 4 * c * k)


def row(light, viewer, ax, ay, sigma):
    numbers = [*direction(*light), *direction(*viewer), ax, ay, sigma, oren_nayar(light, viewer, sigma)]
    numbers += [ward(light, viewer, ax, ay, form) for form in ("1992", "duer", "bounded")]
    numbers += [ggx(light, viewer, ax, ax), ggx(light, viewer, ax, ay), sheen(light, viewer, ax)]
    print("RL_MATERIAL(" + ", ".join(f"{x:.9g}" for x in numbers) + ")")


def main():
    print("// SPDX-License-Identifier: Apache-2.0")
    print("// Written by material_values.py. Normal +z, tangent +x: l, v, alpha_x, alpha_y, sigma; Oren-Nayar; Ward 1992, Duer, "
          "bounded; GGX with alpha_x, with both; sheen with alpha_x.")
    row((0, 0), (0, 0), 0.5, 0.5, 0.3)
    row((0.6, 0), (0.6, math.pi), 0.2, 0.4, 0)
    numbers = random.Random(1992)
    for _ in range(120):
        light = (numbers.uniform(0, 1.5), numbers.uniform(-3.1, 3.1))
        viewer = (numbers.uniform(0, 1.5), numbers.uniform(-3.1, 3.1))
        if numbers.random() < 0.5:  # near the mirror, where lobes are not 0
            viewer = (min(1.5, max(0, light[0] + numbers.gauss(0, 0.15))), light[1] + math.pi + numbers.gauss(0, 0.15))
        row(light, viewer, numbers.uniform(0.08, 1), numbers.uniform(0.08, 1), numbers.uniform(0, 1))


if __name__ == "__main__":
    main()
