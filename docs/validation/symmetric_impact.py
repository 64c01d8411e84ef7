#!/usr/bin/env python3
"""Finite-element references of the cases in which two like bodies meet head-on.

    docs/validation/symmetric_impact.py two_discs  > cases/two_discs/reference.csv
    docs/validation/symmetric_impact.py two_rings  > cases/two_rings/reference.csv
    docs/validation/symmetric_impact.py two_discs --refine 0.5      half as many elements along each side

By symmetry the left body meets a frictionless rigid plane at x = 0. Its plane-strain motion is integrated by explicit central
differences on bilinear quadrilaterals with four stress points each, in the present configuration: the stress rate of Jaumann
for the deviator, p = c0^2 (rho - rho0) with rho = rho0/J. A node that would cross the plane in a step stops on it and leaves
it when it is pulled back: contact by a Lagrange multiplier at each node. Independent of pliant; needs numpy. SI units.
"""
import argparse
import sys

import numpy as np

POINTS = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])


class Material:
    def __init__(self, density, youngs_modulus, poissons_ratio):
        self.density = density
        self.shear = youngs_modulus / (2 * (1 + poissons_ratio))
        self.bulk = youngs_modulus / (3 * (1 - 2 * poissons_ratio))
        self.wave_speed = np.sqrt((self.bulk + 4 * self.shear / 3) / density)


def patch(corner_rows, columns):
    """Nodes (rows, columns + 1, 2) between two curves with as many points each, straight across."""
    inner, outer = corner_rows
    s = np.linspace(0, 1, columns + 1)[None, :, None]
    return inner[:, None] * (1 - s) + outer[:, None] * s


def ring_mesh(centre, inner, outer, across):
    around = 24 * across
    angle = 2 * np.pi * np.arange(around + 1) / around
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return merged([centre + patch((inner * circle, outer * circle), across)])


def disc_mesh(centre, radius, sides):
    """A core of sides x sides quadrilaterals and four patches around it."""
    u = np.linspace(-1, 1, sides + 1)
    grid = np.stack(np.meshgrid(u, u, indexing="ij"), axis=-1)
    # The sides of the core bulge, so that all quadrilaterals are nearly square.
    core = 0.5 * radius * grid * (1 - 0.15 * grid[..., ::-1] ** 2)
    patches = [core]
    for edge in (core[:, 0], core[-1, :], core[::-1, -1], core[0, ::-1]):
        angle = np.linspace(np.arctan2(*edge[0][::-1]), np.arctan2(*edge[0][::-1]) + np.pi / 2, sides + 1)
        rim = radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        patches.append(patch((edge, rim), 3 * sides // 4))
    return merged([centre + p for p in patches])


def merged(patches):
    """Nodes and quadrilaterals, counter-clockwise, of structured patches that share their edges."""
    places, quadrilaterals, first = [], [], 0
    for nodes in patches:
        rows, columns = nodes.shape[:2]
        number = first + np.arange(rows * columns).reshape(rows, columns)
        quadrilaterals.append(np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1).reshape(-1, 4))
        places.append(nodes.reshape(-1, 2))
        first += rows * columns
    places, quadrilaterals = np.concatenate(places), np.concatenate(quadrilaterals)
    _, kept, same = np.unique(np.round(places, 9), axis=0, return_index=True, return_inverse=True)
    places, quadrilaterals = places[kept], same.reshape(-1)[quadrilaterals]
    x = places[quadrilaterals]
    d1, d2 = x[:, 2] - x[:, 0], x[:, 3] - x[:, 1]
    clockwise = d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0] < 0
    quadrilaterals[clockwise] = quadrilaterals[clockwise][:, ::-1]
    return places, quadrilaterals


class Body:
    """State of one body; arrays [element, stress point, ...]."""

    def __init__(self, mesh, material, speed):
        self.x, self.quadrilaterals = mesh
        self.material = material
        self.v = np.zeros_like(self.x)
        self.v[:, 0] = speed
        self.slopes, self.area = self.shape_gradients(self.x)
        self.area0 = self.area
        shape = (1 + POINTS[:, None, 0] * POINTS[None, :, 0] / np.sqrt(3)) * (1 + POINTS[:, None, 1] * POINTS[None, :, 1] / np.sqrt(3)) / 4
        shares = material.density * np.einsum("ep,pn->en", self.area, shape)
        self.mass = np.bincount(self.quadrilaterals.ravel(), shares.ravel())
        self.deviator = np.zeros(self.area.shape + (3,))  # xx, yy, xy; zz = -(xx + yy)

    def shape_gradients(self, x):
        """dN/dx [element, point, node, 2] and the area of each point."""
        at = POINTS / np.sqrt(3)
        dn = np.empty((4, 4, 2))  # [point, node, direction]
        dn[..., 0] = POINTS[None, :, 0] * (1 + at[:, None, 1] * POINTS[None, :, 1]) / 4
        dn[..., 1] = POINTS[None, :, 1] * (1 + at[:, None, 0] * POINTS[None, :, 0]) / 4
        jacobian = np.einsum("pnd,enc->epdc", dn, x[self.quadrilaterals])
        inverse = np.linalg.inv(jacobian)
        return np.einsum("epcd,pnd->epnc", inverse, dn), np.linalg.det(jacobian)

    def strain_by(self, dt):
        """The deviator after a step of the present velocities, at mid step."""
        slopes, _ = self.shape_gradients(self.x + dt / 2 * self.v)
        l = np.einsum("epnj,eni->epij", slopes, self.v[self.quadrilaterals])
        spin = dt / 2 * (l[..., 1, 0] - l[..., 0, 1])
        c, s = np.cos(2 * spin), np.sin(2 * spin)  # of twice the angle, as for rotating a tensor
        xx, yy, xy = np.moveaxis(self.deviator, -1, 0)
        mean, half = (xx + yy) / 2, (xx - yy) / 2
        turned = [mean + half * c - xy * s, mean - half * c + xy * s, half * s + xy * c]
        trace = (l[..., 0, 0] + l[..., 1, 1]) / 3
        rate = [l[..., 0, 0] - trace, l[..., 1, 1] - trace, (l[..., 0, 1] + l[..., 1, 0]) / 2]
        self.deviator = np.stack(turned, axis=-1) + 2 * self.material.shear * dt * np.stack(rate, axis=-1)

    def forces(self):
        self.slopes, self.area = self.shape_gradients(self.x)
        p = self.material.bulk * (self.area0 / self.area - 1)
        xx, yy, xy = np.moveaxis(self.deviator, -1, 0)
        sigma = np.stack([np.stack([xx - p, xy], -1), np.stack([xy, yy - p], -1)], -2)
        f = -np.einsum("ep,epij,epnj->eni", self.area, sigma, self.slopes)
        n = len(self.x)
        return np.stack([np.bincount(self.quadrilaterals.ravel(), f[..., a].ravel(), n) for a in (0, 1)], axis=-1)

    def step(self, dt):
        """Velocities are half a step behind places. Nodes stop on the plane."""
        acceleration = self.forces() / self.mass[:, None]
        before = self.v
        self.v = before + dt * acceleration
        self.v[:, 0] = np.minimum(self.v[:, 0], -self.x[:, 0] / dt)
        self.present_velocity = (before + self.v) / 2
        energies = self.energies()
        self.strain_by(dt)
        self.x = self.x + dt * self.v
        return energies

    def energies(self):
        """Momentum along x, kinetic and strain energy, (RP.62), at the time of the places."""
        u = self.present_velocity
        j = self.area / self.area0
        xx, yy, xy = np.moveaxis(self.deviator, -1, 0)
        squares = xx**2 + yy**2 + (xx + yy) ** 2 + 2 * xy**2
        strain = self.area0 * self.material.bulk * (j - 1 - np.log(j)) + self.area * squares / (4 * self.material.shear)
        return self.mass @ u[:, 0], self.mass @ (u**2).sum(1) / 2, strain.sum()


def two_discs(refine):
    mesh = disc_mesh(np.array([-0.525, 0]), 0.5, round(32 * refine))
    return Body(mesh, Material(1, 100, 0.3), 0.5), 0.6


def two_rings(refine):
    mesh = ring_mesh(np.array([-0.041, 0]), 0.03, 0.04, round(9 * refine))
    return Body(mesh, Material(1000, 1e7, 0.3975), 7.52), 0.012


def shortest_side(body):
    corners = body.x[body.quadrilaterals]
    return np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).min()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", choices=["two_discs", "two_rings"])
    parser.add_argument("--refine", type=float, default=1, help="elements along each side, over those of the reference")
    options = parser.parse_args()
    body, end = {"two_discs": two_discs, "two_rings": two_rings}[options.case](options.refine)
    samples = 60
    steps_between = int(np.ceil(end / samples / (0.4 * shortest_side(body) / body.material.wave_speed)))
    dt = end / samples / steps_between
    print(f"{len(body.quadrilaterals)} quadrilaterals, {samples * steps_between} steps", file=sys.stderr)
    print("t,momentum,kinetic_energy,strain_energy")
    for step in range(samples * steps_between + 1):
        row = body.step(dt)
        if step % steps_between == 0:
            print("{:.6g},{:.6g},{:.6g},{:.6g}".format(step * dt, *row), flush=True)


main()
