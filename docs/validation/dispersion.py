"""What the moment-matrix gradient (RP.20) alone makes of the waves of the periodic cube.

On an undisturbed cubic lattice it turns exp(ik.x) into i k' exp(ik.x), along the diagonal with k' = r k, so
that the waves of a medium without any other error run r times as fast as they should.
"""
import itertools

import numpy as np


def _polynomial(factor, *coefficients):
    """(RP.16), (RP.18): factor(t) times a polynomial in t, from the squared distance over h."""
    def omega(squares):
        t = np.maximum(0, 1 - squares / 6.25)
        return factor(t) * np.polynomial.polynomial.polyval(t, coefficients)
    return omega


kernels = {
    "quartic_spline_fit": (2, _polynomial(lambda t: t**3, 0.76443, -2.31468, 2.5554)),
    "compact": (1, lambda squares: np.maximum(0, 1 - squares / 1.75**2)**4),  # (RP.17)
    "fourth_order": (2, _polynomial(lambda t: t**2, 0.6355763142948405, -6.642571385553331,
                                    21.979141703042178, -30.394221495264024, 15.422074863480338)),
}


def speed_ratio(kernel, cells):
    """r of waves along the diagonal with `cells` particles in the period of every axis."""
    reach, omega = kernels[kernel]
    d = np.array(list(itertools.product(range(-reach, reach + 1), repeat=3)), float)
    squares = (d**2).sum(axis=1)
    inside = (squares > 0) & (squares < (reach + 1)**2)
    d, squares = d[inside], squares[inside]
    k = 2 * np.pi / cells
    slope = (omega(squares) * d[:, 0] * np.sin(k * d.sum(axis=1))).sum()
    return slope / (omega(squares) * d[:, 0]**2).sum() / k


def cube_error(kernel, cells, p_period, s_period):
    """The L-infinity error of section 5 at t = T_S, over the amplitude, of such a medium."""
    x = 2 * np.pi * (np.arange(cells) + 0.5) / cells
    s, c = np.sin(x), np.cos(x)

    def product(f, g, h):
        return np.einsum("i,j,k->ijk", f, g, h)
    both = product(s, s, s)
    pressure = (both - product(c, c, s) - product(c, s, c)) / 3

    def velocity(time):
        p, shear = np.cos(2 * np.pi * time / p_period), np.cos(2 * np.pi * time / s_period)
        return both * shear + pressure * (p - shear)
    ratio = speed_ratio(kernel, cells)
    return np.abs(velocity(ratio * s_period) - velocity(s_period)).max()
