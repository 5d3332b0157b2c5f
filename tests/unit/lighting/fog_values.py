#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes fog_values.inc: OpenGL 2.1 specification, section 3.10, computed here in double.

    python3 fog_values.py > fog_values.inc
"""
import math


def row(kind, d, start, end, density, factor):
    print(f"RL_FOG({kind}, {d:.9g}, {start:.9g}, {end:.9g}, {density:.9g}, {factor:.9g})")


print("// SPDX-License-Identifier: Apache-2.0")
print("// Written by fog_values.py. kind, distance, start, end, density, factor")
for d, start, end in ((0, 1, 9), (1, 1, 9), (3, 1, 9), (7.5, 1, 9), (9, 1, 9), (20, 1, 9), (3, 9, 1), (2, 3, 3), (4, 3, 3)):
    f = (end - d) / (end - start) if end != start else (1 if d < end else 0)
    row("RL_LINEAR_FOG", d, start, end, 0, max(0, min(1, f)))
for d, density in ((0, 0.3), (1, 0.3), (5, 0.3), (40, 0.3), (5, 0), (2, 4)):
    row("RL_EXPONENTIAL_FOG", d, 0, 1, density, math.exp(-density * d))
    row("RL_EXPONENTIAL_SQUARED_FOG", d, 0, 1, density, math.exp(-(density * d) ** 2))
