#!/usr/bin/env python3
"""Reference values of the one-dimensional model, with 60 digits (mpmath 1.3).

    pip install mpmath==1.3.0
    python3 scripts/high-precision-1d.py reference-data/high-precision-1d    (5 s)

Formulas: Bouthors, Neyret & Lefebvre 2006, appendix A, written as printed there (T_2b also with tau_c(-2H)), evaluated
directly; 60 digits leave room for the cancellation. Inputs are exact in single precision.
"""
import struct
import sys
from pathlib import Path

from mpmath import exp, expint, mp, mpf, nstr, quad

mp.dps = 60


def single(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def digits(value):
    return nstr(mpf(value), 20, min_fixed=0, max_fixed=0)


# beta, b, c, kappa_c, t, r, kappa_s: rows 0 and 80 degrees of Appendix B, and a column that is its own unit.
SETS = [
    [0.9961, 1.1796, 0.0138, 0.0265, 0.8389, 0.0547, 0.0252],
    [0.9961, 0.5043, 0.0280, 0.0700, 0.7149, 0.3554, 0.0252],
    [0.9, 0.8, 0.5, 1.0, 0.7, 0.1, 1.0],
]
LIGHTS = [1.0, 0.5, 0.01, 0.0, "diffuse"]
# Optical thickness 1e-8 to 1e4, two per decade.
DEPTHS = [10 ** (k / 2) for k in range(-16, 9)]


def unscattered(light, depth):
    if light == "diffuse":
        return 2 * expint(3, depth)
    if light == 0.0:
        return mpf(0 if depth > 0 else 1)
    return exp(-depth / light)


def fluxes(values, light, h):
    beta, b, c, kappa_c, t, r, kappa_s = (mpf(v) for v in values)
    h = mpf(h)
    tau_c = lambda length: exp(-kappa_c * length)
    x = kappa_c * h
    t_ms = (b + (1 - b) * exp(-c * h)) * beta / (h - (h - 1) * beta)
    t_0 = unscattered(light, kappa_s * h)
    t_1 = t * x * tau_c(h)
    t_2a = (x * t) ** 2 / 2 * tau_c(h)
    t_2 = t_2a + r**2 / 4 * (1 + (2 * x - 1) * tau_c(-2 * h)) * tau_c(3 * h)
    t_2_printed = t_2a + r**2 / 4 * (1 + (2 * x - 1) * tau_c(2 * h)) * tau_c(3 * h)
    r_1 = r / 2 * (1 - tau_c(2 * h))
    r_2 = r * t / 2 * (1 - (2 * x + 1) * tau_c(2 * h))
    left = t_ms - t_0 - t_1
    return [t_ms, 1 - t_ms, t_0, t_1, t_2, left - t_2, r_1, r_2, 1 - t_ms - r_1 - r_2, t_2_printed, left - t_2_printed]


def flux_table():
    yield (
        "beta,b,c,kappa_c,t,r,kappa_s,mu_l,thickness,t_ms,r_ms,t_0,t_1,t_2,t_3_plus,r_1,r_2,r_3_plus,"
        "t_2_as_printed,t_3_plus_as_printed"
    )
    for values in SETS:
        values = [single(v) for v in values]
        for light in LIGHTS:
            light = light if light == "diffuse" else single(light)
            for depth in DEPTHS:
                h = single(depth / values[6])
                row = [digits(f) for f in fluxes(values, light, h)]
                yield ",".join([repr(v) for v in values] + [str(light), repr(h)] + row)


def e3_table():
    yield "x,e3,one_minus_2_e3"
    for k in range(-32, 12):
        x = single(10 ** (k / 4))
        yield f"{x!r},{digits(expint(3, x))},{digits(1 - 2 * expint(3, x))}"


def order_table():
    """The paper's own integrals, by quadrature, kappa_c = 1 and t = r = 1.

    Its T_2a prints tau_c(H - k), where H - l - k is left to go; the closed form printed for it is the right one.
    """
    yield "x,t_1,r_1,t_2a,t_2b,r_2"
    mp.dps = 25
    s = lambda length: exp(-length)
    for x in [0.0625, 0.25, 1.0, 2.0, 5.0]:
        h = mpf(x)
        t_1 = quad(lambda l: s(l) * exp(-(h - l)), [0, h])
        r_1 = quad(lambda l: s(l) * exp(-l), [0, h])
        t_2a = quad(lambda l: s(l) * quad(lambda k: s(k) * exp(-(h - l - k)), [0, h - l]), [0, h])
        t_2b = quad(lambda k: s(k) * quad(lambda l: s(k - l) * exp(-(h - l)), [0, k]), [0, h])
        r_2 = 2 * quad(lambda l: s(l) * quad(lambda k: s(l - k) * exp(-k), [0, l]), [0, h])
        yield ",".join([repr(x)] + [nstr(v, 17, min_fixed=0, max_fixed=0) for v in (t_1, r_1, t_2a, t_2b, r_2)])


def main():
    folder = Path(sys.argv[1])
    tables = {"fluxes.csv": flux_table, "e3.csv": e3_table, "orders-by-quadrature.csv": order_table}
    for name, table in tables.items():
        (folder / name).write_text("\n".join(table()) + "\n")


main()
