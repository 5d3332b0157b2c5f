#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes picture_metric_values.inc: SSIM and FLIP of small pictures, computed here from the papers' formulas.

Independent of the C++: double precision throughout, every window and every filter as one two-dimensional sum in place of rows and
columns, FLIP's colors by way of XYZ, YyCxCz and CIELab with all their factors. Standard library only; a minute.
    python3 picture_metric_values.py > picture_metric_values.inc
"""
import math

MASK = 0xffffffff


def noise(x, y, c):
    """As test::noise() of image_support.h."""
    state = (x * 73856093 ^ y * 19349663 ^ c * 83492791) & MASK
    state = ((state ^ state >> 13) * 1274126177) & MASK
    return state ^ state >> 16


# Each picture is a function of x, y, c that gives a code 0..255; the same ones stand in metric_pictures.h.
PICTURES = {
    "black": lambda x, y, c: 0,
    "white": lambda x, y, c: 255,
    "gray": lambda x, y, c: 128,
    "gray_130": lambda x, y, c: 130,
    "green": lambda x, y, c: 255 if c == 1 else 0,
    "blue": lambda x, y, c: 255 if c == 2 else 0,
    "noise": lambda x, y, c: noise(x, y, c) & 255,
    "other_noise": lambda x, y, c: noise(x + 100, y, c) & 255,
    "ramp": lambda x, y, c: 10 + 7 * x + 3 * y + 10 * c,
    "noisy_ramp": lambda x, y, c: 10 + 7 * x + 3 * y + 10 * c + noise(x, y, c) % 9,
    "step": lambda x, y, c: 60 if x < 12 else 190,
    "step_beside": lambda x, y, c: 60 if x < 13 else 190,
    "dot": lambda x, y, c: 255 if (x, y) == (11, 9) else 128,
    "checks": lambda x, y, c: 255 * ((x ^ y) & 1),
}
PAIRS = [("black", "white"), ("gray", "gray_130"), ("green", "blue"), ("noise", "other_noise"), ("ramp", "noisy_ramp"),
         ("step", "step_beside"), ("gray", "dot"), ("checks", "gray"), ("ramp", "ramp")]
WIDTH, HEIGHT = 24, 19


def picture(name):
    return [[[PICTURES[name](x, y, c) for c in range(3)] for x in range(WIDTH)] for y in range(HEIGHT)]


def ssim(a, b):
    """Wang et al. 2004 with L = 255."""
    luma = [[[.299 * p[0] + .587 * p[1] + .114 * p[2] for p in row] for row in image] for image in (a, b)]
    weights = [[math.exp(-((i - 5) ** 2 + (j - 5) ** 2) / (2 * 1.5 ** 2)) for i in range(11)] for j in range(11)]
    total = sum(map(sum, weights))
    c1, c2, values = (.01 * 255) ** 2, (.03 * 255) ** 2, []
    for y in range(HEIGHT - 10):
        for x in range(WIDTH - 10):
            window = [(weights[j][i] / total, luma[0][y + j][x + i], luma[1][y + j][x + i]) for j in range(11) for i in range(11)]
            ma, mb = sum(w * p for w, p, _ in window), sum(w * q for w, _, q in window)
            va, vb = sum(w * (p - ma) ** 2 for w, p, _ in window), sum(w * (q - mb) ** 2 for w, _, q in window)
            cov = sum(w * (p - ma) * (q - mb) for w, p, q in window)
            values.append((2 * ma * mb + c1) * (2 * cov + c2) / ((ma ** 2 + mb ** 2 + c1) * (va + vb + c2)))
    return sum(values) / len(values)


def matrix_of_primaries():
    """Linear sRGB to XYZ from the chromaticities of BT.709 and D65."""
    def xyz(x, y):
        return [x / y, 1, (1 - x - y) / y]
    columns, white = [xyz(.64, .33), xyz(.3, .6), xyz(.15, .06)], xyz(.3127, .329)
    def det(p, q, r):
        return (p[0] * (q[1] * r[2] - q[2] * r[1]) - q[0] * (p[1] * r[2] - p[2] * r[1]) + r[0] * (p[1] * q[2] - p[2] * q[1]))
    whole = det(*columns)
    scale = [det(*[white if j == i else columns[j] for j in range(3)]) / whole for i in range(3)]
    return [[columns[j][i] * scale[j] for j in range(3)] for i in range(3)], white


TO_XYZ, WHITE = matrix_of_primaries()


def solve(matrix, v):
    """The x with matrix x = v, by Cramer's rule."""
    def det(m):
        return sum(m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]) for i in range(3))
    return [det([[v[r] if c == i else matrix[r][c] for c in range(3)] for r in range(3)]) / det(matrix) for i in range(3)]


def linear(code):
    v = code / 255
    return v / 12.92 if v <= .04045 else ((v + .055) / 1.055) ** 2.4


def ycxcz(rgb):
    x, y, z = (sum(m * v for m, v in zip(row, rgb)) / w for row, w in zip(TO_XYZ, WHITE))
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)]


def linear_of_ycxcz(v):
    y = (v[0] + 16) / 116
    return solve(TO_XYZ, [n * w for n, w in zip((v[1] / 500 + y, y, y - v[2] / 200), WHITE)])


def hunt_lab(rgb):
    def f(t):
        return t ** (1 / 3) if t > (6 / 29) ** 3 else t / (3 * (6 / 29) ** 2) + 4 / 29
    x, y, z = (f(sum(m * v for m, v in zip(row, rgb)) / w) for row, w in zip(TO_XYZ, WHITE))
    lightness = 116 * y - 16
    return [lightness, .01 * lightness * 500 * (x - y), .01 * lightness * 200 * (y - z)]


def hyab(p, q):
    return abs(p[0] - q[0]) + math.hypot(p[1] - q[1], p[2] - q[2])


def convolve(plane, weights):
    """With a square of weights; the picture's edges go on outside."""
    r, out = len(weights) // 2, []
    for y in range(HEIGHT):
        rows = [plane[min(max(y + j, 0), HEIGHT - 1)] for j in range(-r, r + 1)]
        out.append([sum(w * row[min(max(x + i - r, 0), WIDTH - 1)] for line, row in zip(weights, rows) for i, w in enumerate(line))
                    for x in range(WIDTH)])
    return out


def csf_weights(terms, ppd):
    r = math.ceil(3 * math.sqrt(.04 / (2 * math.pi ** 2)) * ppd)
    def value(x, y):
        d = (x / ppd) ** 2 + (y / ppd) ** 2
        return sum(a * math.sqrt(math.pi / b) * math.exp(-math.pi ** 2 * d / b) for a, b in terms)
    weights = [[value(x, y) for x in range(-r, r + 1)] for y in range(-r, r + 1)]
    total = sum(map(sum, weights))
    return [[w / total for w in row] for row in weights]


CSF = [[(1, .0047)], [(1, .0053)], [(34.1, .04), (13.5, .025)]]


def seen(image, ppd):
    planes = [[[ycxcz([linear(code) for code in p])[c] for p in row] for row in image] for c in range(3)]
    planes = [convolve(plane, csf_weights(terms, ppd)) for plane, terms in zip(planes, CSF)]
    return [[hunt_lab([min(max(v, 0), 1) for v in linear_of_ycxcz([plane[y][x] for plane in planes])]) for x in range(WIDTH)] for y in range(HEIGHT)]


def feature_weights(ppd, is_point, along_y):
    sigma = .5 * .082 * ppd
    r = math.ceil(3 * sigma)
    def value(x, y):
        bell, t = math.exp(-(x * x + y * y) / (2 * sigma ** 2)), y if along_y else x
        return (t * t / sigma ** 2 - 1) * bell if is_point else -t * bell
    weights = [[value(x, y) for x in range(-r, r + 1)] for y in range(-r, r + 1)]
    positive, negative = (sum(s * w for row in weights for w in row if s * w > 0) for s in (1, -1))
    return [[w / (positive if w > 0 else negative) for w in row] for row in weights]


def features(image, ppd, is_point):
    gray = [[(ycxcz([linear(code) for code in p])[0] + 16) / 116 for p in row] for row in image]
    x, y = (convolve(gray, feature_weights(ppd, is_point, along_y)) for along_y in (False, True))
    return [[math.hypot(p, q) for p, q in zip(*rows)] for rows in zip(x, y)]


def flip(a, b, ppd):
    """Andersson et al. 2020: the mean error, and that of pixel (12, 9)."""
    labs = seen(a, ppd), seen(b, ppd)
    edges, points = ([features(image, ppd, is_point) for image in (a, b)] for is_point in (False, True))
    largest = hyab(hunt_lab([0, 1, 0]), hunt_lab([0, 0, 1])) ** .7
    errors = []
    for y in range(HEIGHT):
        for x in range(WIDTH):
            d = hyab(labs[0][y][x], labs[1][y][x]) ** .7
            color = .95 / (.4 * largest) * d if d < .4 * largest else .95 + (d - .4 * largest) / (.6 * largest) * .05
            feature = (max(abs(edges[0][y][x] - edges[1][y][x]), abs(points[0][y][x] - points[1][y][x])) / math.sqrt(2)) ** .5
            errors.append(color ** (1 - feature))
    return sum(errors) / len(errors), errors[9 * WIDTH + 12]


def main():
    print("// Made by picture_metric_values.py: pictures, pixels per degree, SSIM, mean FLIP, FLIP of pixel (12, 9).")
    for a, b in PAIRS:
        for ppd in (67, 20) if a in ("noise", "step") else (67,):
            mean, middle = flip(picture(a), picture(b), ppd)
            print(f'{{{a}, {b}, {ppd}, {ssim(picture(a), picture(b)):.15g}, {mean:.15g}, {middle:.15g}, "{a} and {b}"}},')


if __name__ == "__main__":
    main()
