#!/usr/bin/env python3
"""Reference values of the angular model's weights of one and two scatterings, with 60 digits (mpmath 1.3).

    pip install mpmath==1.3.0
    python3 scripts/high-precision-angular.py reference-data/high-precision-angular    (10 s)

Formulas: Bouthors, Neyret & Lefebvre 2006, equations 4.3 as printed but for kappa P, and the same with the optical path of
the way counted for two scatterings; evaluated directly, in the limit where cosines are equal or the sun's is 0. A second
table has both as integrals over depth. Inputs are exact in single precision.
"""
import struct
import sys
from pathlib import Path

from mpmath import exp, mp, mpf, nstr, quad

mp.dps = 60


def single(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def digits(value, count=20):
    return nstr(mpf(value), count, min_fixed=0, max_fixed=0)


# The third is two units in the last place above the second.
COSINES = [single(c) for c in (1.0, 0.7, 0.7 + 1.2e-7, 0.3, 0.01, 1e-4)]
DEPTHS = [single(10.0**k) for k in range(-8, 5)]


def back(x, mu_l, mu_v):
    """Turned back: mu_l = 0 is the limit of an infinite path."""
    scale = 1 / (mu_l + mu_v)
    if mu_l == 0:
        return scale, scale
    path = x / mu_l + x / mu_v
    return scale * (1 - exp(-path)), scale * (1 - (1 + path) * exp(-path))


def through(x, mu_l, mu_v):
    q = x / mu_v
    if mu_l == 0:
        return exp(-q) / mu_v, (1 + q) * exp(-q) / mu_v
    if mu_l == mu_v:
        return x / mu_v**2 * exp(-q), x / mu_v**2 * q * exp(-q)
    p = x / mu_l
    scale = 1 / (mu_v - mu_l)
    # Integrals of e^-s and s e^-s over the path's lengths from q to p.
    return scale * (exp(-q) - exp(-p)), scale * ((1 + q) * exp(-q) - (1 + p) * exp(-p))


def closed_table():
    yield "x,mu_l,mu_v,top_once,top_twice,bottom_once,bottom_twice"
    for x in DEPTHS:
        for mu_l in [0.0, *COSINES]:
            for mu_v in COSINES:
                arguments = [mpf(x), mpf(mu_l), mpf(mu_v)]
                row = [digits(value) for value in (*back(*arguments), *through(*arguments))]
                yield ",".join([repr(x), repr(mu_l), repr(mu_v), *row])


def depth_table():
    """The single-scattering integral of the paper over depth l, and the same with the path's length as a factor."""
    yield "x,mu_l,mu_v,top_once,top_twice,bottom_once,bottom_twice"
    mp.dps = 25
    for x in [0.0625, 1.0, 4.0]:
        for mu_l, mu_v in [(1.0, 0.5), (0.25, 0.75), (0.5, 0.5)]:
            row = []
            for way in [lambda l: l / mu_l + l / mu_v, lambda l: l / mu_l + (x - l) / mu_v]:
                for power in [0, 1]:
                    integral = quad(lambda l: way(l) ** power * exp(-way(l)), [0, x])
                    row.append(digits(integral / (mu_l * mu_v), 17))
            yield ",".join([repr(x), repr(mu_l), repr(mu_v), *row])


def main():
    folder = Path(sys.argv[1])
    for name, table in {"weights.csv": closed_table, "weights-by-quadrature.csv": depth_table}.items():
        (folder / name).write_text("\n".join(table()) + "\n")


main()
