#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Colors of data/paths/cornell.scene.toml: the Cornell box's published spectra as linear sRGB.

  cornell_colors.py [--check data/paths/cornell.scene.toml]

Spectra: Cornell University Program of Computer Graphics, "Cornell Box Data" (reflectances every 4 nm, the light every 100 nm, straight
lines between). Color matching functions of CIE 1931: the multi-lobe fit of Wyman, Sloan and Shirley 2013, "Simple Analytic
Approximations to the CIE XYZ Color Matching Functions", eq. 4. Primaries: IEC 61966-2-1.

  light        integral of light * matching functions / integral of y_bar, so that a spectrum of 1 everywhere has luminance 1
  reflectance  color of light * reflectance / color of light, part by part. So light that is reflected once has its true color; after more
               reflections three numbers are an approximation of a spectrum, whichever illuminant they were made for.
--check compares with the colors that a world file has (lamp.scene.toml has them too) and fails where one is off by more than its digits.
Only the standard library is needed."""
import argparse
import math
import pathlib
import sys
import tomllib

FIRST_NM, STEP_NM = 400, 4
LIGHT = ((400, 0.0), (500, 8.0), (600, 15.6), (700, 18.4))
LIGHT_REFLECTANCE = 0.78  # of the light's own surface, at every wavelength
REFLECTANCES = {
    "white": """
        0.343 0.445 0.551 0.624 0.665 0.687 0.708 0.723 0.715 0.710 0.745 0.758 0.739 0.767 0.777 0.765 0.751 0.745 0.748
        0.729 0.745 0.757 0.753 0.750 0.746 0.747 0.735 0.732 0.739 0.734 0.725 0.721 0.733 0.725 0.732 0.743 0.744 0.748
        0.728 0.716 0.733 0.726 0.713 0.740 0.754 0.764 0.752 0.736 0.734 0.741 0.740 0.732 0.745 0.755 0.751 0.744 0.731
        0.733 0.744 0.731 0.712 0.708 0.729 0.730 0.727 0.707 0.703 0.729 0.750 0.760 0.751 0.739 0.724 0.730 0.740 0.737""",
    "green": """
        0.092 0.096 0.098 0.097 0.098 0.095 0.095 0.097 0.095 0.094 0.097 0.098 0.096 0.101 0.103 0.104 0.107 0.109 0.112
        0.115 0.125 0.140 0.160 0.187 0.229 0.285 0.343 0.390 0.435 0.464 0.472 0.476 0.481 0.462 0.447 0.441 0.426 0.406
        0.373 0.347 0.337 0.314 0.285 0.277 0.266 0.250 0.230 0.207 0.186 0.171 0.160 0.148 0.141 0.136 0.130 0.126 0.123
        0.121 0.122 0.119 0.114 0.115 0.117 0.117 0.118 0.120 0.122 0.128 0.132 0.139 0.144 0.146 0.150 0.152 0.157 0.159""",
    "red": """
        0.040 0.046 0.048 0.053 0.049 0.050 0.053 0.055 0.057 0.056 0.059 0.057 0.061 0.061 0.060 0.062 0.062 0.062 0.061
        0.062 0.060 0.059 0.057 0.058 0.058 0.058 0.056 0.055 0.056 0.059 0.057 0.055 0.059 0.059 0.058 0.059 0.061 0.061
        0.063 0.063 0.067 0.068 0.072 0.080 0.090 0.099 0.124 0.154 0.192 0.255 0.287 0.349 0.402 0.443 0.487 0.513 0.558
        0.584 0.620 0.606 0.609 0.651 0.612 0.610 0.650 0.638 0.627 0.620 0.630 0.628 0.642 0.639 0.657 0.639 0.635 0.642""",
}
TO_SRGB = ((3.2406, -1.5372, -0.4986), (-0.9689, 1.8758, 0.0415), (0.0557, -0.2040, 1.0570))


def lobe(nm, middle, below, above):
    return math.exp(-0.5 * ((nm - middle) / (below if nm < middle else above)) ** 2)


def matching(nm):
    """x_bar, y_bar, z_bar: Wyman et al. 2013, eq. 4."""
    return (1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) - 0.065 * lobe(nm, 501.1, 20.4, 26.2),
            0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
            1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8))


def light_at(nm):
    for (low, a), (high, b) in zip(LIGHT, LIGHT[1:]):
        if nm <= high:
            return a + (b - a) * (nm - low) / (high - low)
    raise ValueError(nm)


def linear_srgb(spectrum):
    """Of a spectrum given every 4 nm from 400 on: trapezoids; y_bar over all wavelengths."""
    xyz = [0.0, 0.0, 0.0]
    for k, value in enumerate(spectrum):
        weight = STEP_NM * (0.5 if k in (0, len(spectrum) - 1) else 1.0)
        xyz = [sum_ + weight * value * bar for sum_, bar in zip(xyz, matching(FIRST_NM + STEP_NM * k))]
    whole = sum(matching(nm)[1] for nm in range(360, 831))
    return [sum(m * c for m, c in zip(row, xyz)) / whole for row in TO_SRGB]


def colors():
    reflectances = {name: [float(word) for word in text.split()] for name, text in REFLECTANCES.items()}
    shine = [light_at(FIRST_NM + STEP_NM * k) for k in range(len(reflectances["white"]))]
    emission = linear_srgb(shine)
    found = {name: [lit / own for lit, own in zip(linear_srgb([r * s for r, s in zip(values, shine)]), emission)]
             for name, values in reflectances.items()}
    return {**found, "light": [LIGHT_REFLECTANCE] * 3}, emission


def differences(world, found, emission):
    wanted = {**{(name, "color"): color for name, color in found.items()}, ("light", "emission"): emission}
    materials = {m["name"]: m for m in tomllib.loads(world.read_text())["material"]}
    for (name, key), values in wanted.items():
        said = materials[name].get(key, values)
        if any(abs(a - b) > 0.51e-4 * max(1.0, b) for a, b in zip(said, values)):
            yield f"{name}: {key} is {said}, the spectra say {values}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", type=pathlib.Path, metavar="WORLD")
    options = parser.parse_args()
    found, emission = colors()
    for name, color in found.items():
        print(f"{name:9}", *(f"{value:.4f}" for value in color))
    print("emission ", *(f"{value:.4f}" for value in emission))
    wrong = list(differences(options.check, found, emission)) if options.check else []
    print(*wrong, sep="\n", end="\n" if wrong else "")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
