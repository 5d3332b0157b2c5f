#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes src/lighting/albedo_tables.inc: directional albedos of the lobes of ggx.glsl and sheen.glsl, in double.

    python3 tools/make/make_albedo_tables.py > src/lighting/albedo_tables.inc     (some minutes)
What a column and a row mean is said in src/lighting/albedo_tables.h. GGX: normals as seen from v, spread evenly over half
a disc (Heitz 2018, "Sampling the GGX Distribution of Visible Normals", listing 1); what leaves is the mean of G2 / G1.
Sheen: the BRDF over half the hemisphere.
"""
import math

COLUMNS, ROWS, SHEEN_ROWS = 32, 32, 16
RINGS, TURNS = 80, 48


def half_disc():
    """Places x, y and their share; rings are denser at the edge, where the lobe's long tail lies."""
    places = []
    for i in range(RINGS):
        q = (i + 0.5) / RINGS
        radius, share = math.sqrt(1 - q ** 3), 3 * q * q / RINGS / TURNS
        for k in range(TURNS):
            angle = math.pi * ((k + 0.5) / TURNS - 0.5)
            places.append((radius * math.cos(angle), radius * math.sin(angle), share))
    return places


DISC = half_disc()


def column_cosine(column, alpha):
    y = (column / (COLUMNS - 1)) ** 2
    return alpha * y / (1 + alpha - y)


def smith_lambda(cosine, alpha):
    return 0.5 * (math.sqrt(1 + alpha * alpha * (1 - cosine * cosine) / (cosine * cosine)) - 1)


def lobe(n_dot_v, alpha):
    c = max(n_dot_v, 1e-6)
    s = math.sqrt(max(0.0, 1 - c * c))
    scale = 1 / math.sqrt(alpha * alpha * s * s + c * c)
    x, z = alpha * s * scale, c * scale
    lambda_v, squeeze = smith_lambda(c, alpha), 0.5 * (1 + z)
    all_sum = grazing = 0.0
    for t1, sine, share in DISC:
        t2 = (1 - squeeze) * math.sqrt(1 - t1 * t1) + squeeze * sine
        up = math.sqrt(max(0.0, 1 - t1 * t1 - t2 * t2))
        hx, hy, hz = alpha * (x * up - z * t2), alpha * t1, max(0.0, x * t2 + z * up)
        unit = 1 / math.sqrt(hx * hx + hy * hy + hz * hz)
        v_dot_h = min(1.0, max(0.0, (s * hx + c * hz) * unit))
        cosine = 2 * v_dot_h * hz * unit - c
        if cosine > 0:
            seen = share * (1 + lambda_v) / (1 + lambda_v + smith_lambda(min(1.0, cosine), alpha))
            all_sum += seen
            grazing += seen * (1 - v_dot_h) ** 5
    return min(1.0, all_sum), grazing


def loss_over_square(cosine, alpha):
    return (1 - lobe(cosine, alpha)[0]) * ((cosine + alpha) / alpha) ** 2


def lost_share(row, alpha):
    """1 - E_mean of a row of lobe_loss_table as it is read, 2 times the integral of (1 - E) c dc, with c = q^3."""
    total, steps = 0.0, 4000
    for i in range(steps):
        q = (i + 0.5) / steps
        width = alpha / (q ** 3 + alpha)
        x = math.sqrt((1 - width) * (1 + alpha)) * (COLUMNS - 1)
        k = min(int(x), COLUMNS - 2)
        total += width * width * (row[k] + (row[k + 1] - row[k]) * (x - k)) * 2 * q ** 3 * 3 * q * q / steps
    return total


def sheen_lambda(cosine, alpha):
    """Estevez & Kulla 2017, eq. 3, with the fit of their table 1."""
    w = (1 - alpha) ** 2
    a, b, c, d, e = (p0 * w + p1 * (1 - w) for p0, p1 in
                     ((25.3245, 21.5473), (3.32435, 3.82987), (0.16801, 0.19823), (-1.27393, -1.97760), (-4.85967, -4.32054)))

    def fit(x):
        return a / (1 + b * x ** c) + d * x + e
    return math.exp(fit(cosine) if cosine < 0.5 else 2 * fit(0.5) - fit(1 - cosine))


def sheen(n_dot_v, alpha):
    n_dot_v = max(n_dot_v, 1e-4)
    lambda_v = sheen_lambda(n_dot_v, alpha)
    s, total, rings, turns = math.sqrt(max(0.0, 1 - n_dot_v * n_dot_v)), 0.0, 128, 64
    for i in range(rings):
        c = ((i + 0.5) / rings) ** 2  # denser at the horizon
        weight = 2 * (i + 0.5) / rings / rings
        across = math.sqrt(1 - c * c)
        shown = 1 / (4 * n_dot_v * c * (1 + lambda_v + sheen_lambda(c, alpha)))
        for k in range(turns):
            angle = math.pi * (k + 0.5) / turns
            hx, hy, hz = across * math.cos(angle) + s, across * math.sin(angle), c + n_dot_v
            sine2 = (hx * hx + hy * hy) / (hx * hx + hy * hy + hz * hz)
            d = (2 + 1 / alpha) * sine2 ** (0.5 / alpha) / (2 * math.pi)
            total += d * shown * c * weight * 2 * math.pi / turns
    return total


def print_rows(name, rows):
    print(f"const float {name}[] = {{")
    for row in rows:
        numbers = [f"{x:.7g}" for x in row]
        print("    " + ", ".join(n + ("f" if "." in n or "e" in n else ".0f") for n in numbers) + ",")
    print("};")


def main():
    print("// SPDX-License-Identifier: Apache-2.0")
    print("// Written by tools/make/make_albedo_tables.py.")
    lobes, grazings, losses, sheens = [], [], [], []
    for r in range(ROWS):
        alpha = max((r / (ROWS - 1)) ** 2, 1e-3)
        lobes.append([loss_over_square(column_cosine(c, alpha), alpha) for c in range(COLUMNS)])
        pairs = [lobe((c / (COLUMNS - 1)) ** 2, alpha) for c in range(COLUMNS)]
        grazings.append([p[1] / p[0] for p in pairs])
        losses.append(lost_share(lobes[-1], alpha) / alpha ** 2)
    for r in range(SHEEN_ROWS):
        alpha = max((r / (SHEEN_ROWS - 1)) ** 2, 5e-3)
        sheens.append([sheen((c / (COLUMNS - 1)) ** 2, alpha) for c in range(COLUMNS)])
    print_rows("lobe_loss_table", lobes)
    print_rows("grazing_table", grazings)
    print_rows("loss_table", [losses[i:i + 16] for i in range(0, ROWS, 16)])
    print_rows("sheen_table", sheens)


if __name__ == "__main__":
    main()
