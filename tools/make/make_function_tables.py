#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tables and constants of the elementary functions in src/math, by integer arithmetic of 1400 bits.

  make_function_tables.py             prints them as C++
  make_function_tables.py --check     fails where a source in src/math has other numbers
"""
import os
import re
import sys
from fractions import Fraction

BITS = 1400
ONE = 1 << BITS


def atan_of(numerator, denominator):
    """Gregory's series, for |x| <= 1 / 2."""
    term = total = ONE * numerator // denominator
    n = 1
    while term:
        term = -term * numerator * numerator // (denominator * denominator)
        if abs(term) < 2:
            break
        n += 2
        total += term // n
    return total


def atan_of_sixteenths(k):
    """For x > 1 / 2 by atan x = atan 1/2 + atan((x - 1/2) / (1 + x/2))."""
    return atan_of(k, 16) if k <= 8 else atan_of(1, 2) + atan_of(2 * (k - 8), 32 + k)


def log_of(numerator, denominator):
    """2 artanh((x - 1) / (x + 1))"""
    a, b = numerator - denominator, numerator + denominator
    term = total = 2 * ONE * a // b
    n = 1
    while abs(term) > 1:
        term = term * a * a // (b * b)
        n += 2
        total += term // n
    return total


def exp_of(x):
    term = total = ONE
    n = 1
    while term:
        term = term * x // (ONE * n)
        total += term
        n += 1
    return total


PI = 4 * (4 * atan_of(1, 5) - atan_of(1, 239))  # Machin 1706
LN2 = log_of(2, 1)


def rounded(x, bits=53):
    """The nearest number of so many bits, as a fraction."""
    x = Fraction(x, ONE)
    if x == 0:
        return x
    exponent = 0
    while abs(x) * Fraction(2) ** -exponent >= 2:
        exponent += 1
    while abs(x) * Fraction(2) ** -exponent < 1:
        exponent -= 1
    unit = Fraction(2) ** (exponent - bits + 1)
    return round(x / unit) * unit


def pair(x, bits=53):
    high = rounded(x, bits)
    low = rounded(x - int(high * ONE))
    return f"{{{text(high)}, {text(low)}}}"


def text(x):
    return "0" if x == 0 else float(x).hex()


def tables():
    """(source, lines of C++ without what is only layout) of each table and constant."""
    words = (2 * ONE * ONE // PI) >> (BITS - 19 * 64)
    return [
        ("double_double.h", [f"half_pi{pair(PI // 2)}"]),
        ("reduce_angle.cpp", ["0, " + ", ".join(f"0x{words >> 64 * (18 - i) & (1 << 64) - 1:016x}" for i in range(19))]),
        ("trigonometric.cpp", [f"sixth{pair(ONE // 6, 23)}"]),
        ("inverse_trigonometric.cpp", [", ".join(pair(atan_of_sixteenths(k)) for k in range(17))]),
        ("exponential.cpp", [", ".join(pair(exp_of(LN2 * k // 16)) for k in range(16)), f"sixteenth_ln2{pair(LN2 // 16, 37)}",
                             f"ln2{pair(LN2)}"]),
        ("logarithm.cpp", [", ".join(pair(log_of(k, 16)) for k in range(11, 24)), f"ln2_by_steps{pair(LN2, 42)}",
                           f"reciprocal_ln2{pair(ONE * ONE // LN2)}",
                           f"two_thirds{pair(2 * ONE // 3, 23)}"]),
    ]


def without_layout(source):
    return re.sub(r"\s+|//[^\n]*", "", source)


def main():
    if sys.argv[1:] != ["--check"]:
        for source, lines in tables():
            print(f"// {source}", *lines, sep="\n")
        return 0
    folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "src", "math")
    wrong = 0
    for source, lines in tables():
        with open(os.path.join(folder, source), encoding="utf-8") as file:
            found = without_layout(file.read())
        for line in lines:
            if without_layout(line) not in found:
                print(f"src/math/{source} lacks: {line}", file=sys.stderr)
                wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
