#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes tone_values.inc: what the tone curves must give, computed here in double from the published formulas.

Independent of the C++: AgX by the closed form with its own constants, in place of tables. Clamped to 0..1 where the
curve's publication does.
    python3 tone_values.py > tone_values.inc
"""
import math

COLORS = [(0, 0, 0), (.0005, .0005, .0005), (.02, .05, .03), (.18, .18, .18), (.5, .2, .05), (.75, .75, .75), (1, 1, 1),
          (2, .5, .1), (.1, 4, .3), (8, 8, 8), (30, 2, 60), (1000, 1000, 1000)]


def times(matrix, c):
    return [sum(a * b for a, b in zip(row, c)) for row in matrix]


def unit(c):
    return [min(max(x, 0), 1) for x in c]


def reinhard(c):
    luminance = .2126 * c[0] + .7152 * c[1] + .0722 * c[2]
    return [x * (luminance / (1 + luminance)) / luminance if luminance > 0 else 0 for x in c]


def neutral(c):
    f90, k_d = .04, .15
    k_s = .8 - f90
    x = min(c)
    f = x - x * x / (4 * f90) if x <= 2 * f90 else f90
    c = [v - f for v in c]
    p = max(c)
    if p <= k_s:
        return c
    p_n = 1 - (1 - k_s) ** 2 / (p + 1 - 2 * k_s)
    g = 1 / (k_d * (p - p_n) + 1)
    return [v * p_n / p * g + p_n * (1 - g) for v in c]


def aces(c):
    v = times([[.59719, .35458, .04823], [.07600, .90834, .01566], [.02840, .13383, .83777]], c)
    v = [(x * (x + .0245786) - .000090537) / (x * (.983729 * x + .4329510) + .238081) for x in v]
    return unit(times([[1.60475, -.53108, -.07367], [-.10208, 1.10813, -.00605], [-.00327, -.07276, 1.07602]], v))


def agx_contrast(light):
    low, high, pivot = -12.473931188332413, 4.026068811667588, 20 / 33
    x = min(max((math.log2(light) - low) / (high - low), 0), 1) if light > 0 else 0
    a, power = (69.86278913545539, 3.25) if x > pivot else (59.507875, 3)
    return .5 + 2 * (x - pivot) * (1 + a * abs(x - pivot) ** power) ** (-1 / power)


def agx(c):
    v = times([[.842479062253094, .0784335999999992, .0792237451477643],
               [.0423282422610123, .878468636469772, .0791661274605434],
               [.0423756549057051, .0784336, .879142973793104]], c)
    v = times([[1.19687900512017, -.0980208811401368, -.0990297440797205],
               [-.0528968517574562, 1.15190312990417, -.0989611768448433],
               [-.0529716355144438, -.0980434501171241, 1.15107367264116]], [agx_contrast(x) for x in v])
    return [x ** 2.2 for x in unit(v)]


def braces(c):
    return "{" + ", ".join(f"{float(x):.9g}f" if "." in f"{float(x):.9g}" else f"{float(x):.9g}" for x in c) + "}"


if __name__ == "__main__":
    print("// Made by tone_values.py: curve, light, what is displayed (linear).")
    for curve in (reinhard, neutral, aces, agx):
        for color in COLORS:
            print(f"{{ToneMapping::{curve.__name__}, {braces(color)}, {braces(curve(color))}}},")
