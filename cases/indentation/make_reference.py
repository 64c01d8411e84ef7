#!/usr/bin/env python3
"""Writes reference.csv: a frictionless paraboloid pressed into an elastic layer on a rigid base, by
linear elasticity without further approximation.

In Hankel space the layer yields to a pressure p(k) by 2 (1 - nu^2)/E p(k) yielding(k)/k. With
k p(k) = E/(2 (1 - nu^2)) k int_0^a phi(t) cos(k t) dt, no pressure acts outside the contact radius
a, and the shape of the paraboloid below it becomes an integral equation of the second kind,

    phi(t) - int_0^a K(s, t) phi(s) ds = 2/pi (depth - t^2/radius),
    K(s, t) = 2/pi int_0^inf (1 - yielding(k)) cos(k s) cos(k t) dk.

The pressure has no peak at the edge of the contact if phi(a) = 0, which gives the depth for a."""
import math

import numpy as np

young, poisson, thickness, radius, depth = 10e3, 0.3, 0.01, 0.0333, 3.3e-4
stiffness = young / (2 * (1 - poisson**2))
order = 40  # of the rule in t


def yielding(k):
    """Of a layer on a rigid base to which it sticks; that of a half-space is 1."""
    m, e = 3 - 4 * poisson, np.exp(-2 * k * thickness)
    x = 2 * k * thickness
    return (m * (1 - e**2) - 2 * x * e) / (m * (1 + e**2) + (1 + m**2 + x**2) * e)


def pressed(contact_radius):
    """Depth [m], force [N] and its first moment about the axis y [N m], both on a quarter."""
    nodes, weights = np.polynomial.legendre.leggauss(order)
    t, weights = (nodes + 1) * contact_radius / 2, weights * contact_radius / 2
    k, dk = np.linspace(0, 40 / thickness, 8001, retstep=True)
    rule = np.full(k.shape, dk)
    rule[0] = dk / 2
    waves = np.cos(np.outer(k, np.append(t, contact_radius)))
    kernel = 2 / math.pi * waves.T @ (waves * (rule * (1 - yielding(k)))[:, None])
    inner, edge = np.eye(order) - kernel[:order, :order] * weights, kernel[order, :order] * weights

    def solution(right):
        phi = np.linalg.solve(inner, right(t))
        return phi, right(contact_radius) + edge @ phi

    flat, at_edge_of_flat = solution(lambda t: 2 / math.pi * np.ones_like(t))
    curved, at_edge_of_curved = solution(lambda t: -2 / math.pi * t**2 / radius)
    needed = -at_edge_of_curved / at_edge_of_flat
    phi = needed * flat + curved
    force = 2 * math.pi * stiffness * weights @ phi
    return needed, force / 4, math.pi / 2 * stiffness * weights @ (phi * t)


low, high = 1e-3, 1e-2
for _ in range(50):
    middle = (low + high) / 2
    low, high = (middle, high) if pressed(middle)[0] < depth else (low, middle)
_, force, moment = pressed(low)
with open(__file__.replace("make_reference.py", "reference.csv"), "w") as table:
    table.write("time,force,moment,contact_radius\n")
    table.write(f"0.4,{-force:.5g},{moment:.5g},{low:.4g}\n")
