#!/usr/bin/env python3
"""Writes the organ, organ.ply (millimetres), and what is known about its flight, reference.csv.

    cases/organ/make_mesh.py [--divisions 4] [--out cases/organ]

The organ is a sphere of triangles, drawn out to a right lobe and a thin left one, hollow below and
notched in front. Integrals over a solid bounded by triangles are sums over tetrahedra that the
triangles span with the origin; the flight conserves those of density, momentum and energy.
"""
import argparse
import csv
import math
import struct
from pathlib import Path

DENSITY = 1060.0  # [kg/m^3]
DRIFT = (0.5, 0.0, 0.2)  # [m/s]
GRADIENT = ((4.0, -5.0, 0.0), (5.0, -2.0, 0.0), (0.0, 0.0, -2.0))  # of the initial velocity [1/s]


def icosahedron():
    g = (1 + math.sqrt(5)) / 2
    corners = []
    for a in (-1, 1):
        for b in (-g, g):
            corners += [(0, a, b), (a, b, 0), (b, 0, a)]
    edge = 4 + 1e-9
    near = [[j for j in range(12) if j != i and square(corners[i], corners[j]) < edge]
            for i in range(12)]
    triangles = []
    for i in range(12):
        for j in near[i]:
            for k in near[i]:
                outwards = determinant(corners[i], corners[j], corners[k]) > 0
                if i < j and i < k and k in near[j] and outwards:
                    triangles.append((i, j, k))
    return [unit(c) for c in corners], triangles


def square(a, b):
    return sum((p - q) ** 2 for p, q in zip(a, b))


def determinant(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]))


def unit(a):
    length = math.sqrt(sum(p * p for p in a))
    return tuple(p / length for p in a)


def divided(corners, triangles):
    """Every triangle in four, with new corners on the sphere."""
    corners, middles, finer = list(corners), {}, []

    def middle(i, j):
        key = (min(i, j), max(i, j))
        if key not in middles:
            middles[key] = len(corners)
            corners.append(unit(tuple((p + q) / 2 for p, q in zip(corners[i], corners[j]))))
        return middles[key]

    for i, j, k in triangles:
        ij, jk, ki = middle(i, j), middle(j, k), middle(k, i)
        finer += [(i, ij, ki), (ij, j, jk), (ki, jk, k), (ij, jk, ki)]
    return corners, finer


def organ(n):
    """Where a point of the unit sphere goes [mm]."""
    x, y, z = n
    notch = 1 - 0.22 * math.exp(-((x - 0.3) / 0.2) ** 2) * max(y, 0) ** 2
    return (105 * x, 72 * y * (1 - 0.3 * x) * notch + 10 * x * x,
            55 * z * (1 - 0.4 * x) - 22 * x * x - 8 * y * y)


def write_ply(path, corners, triangles):
    header = ("ply\nformat binary_little_endian 1.0\ncomment an organ, in millimetres\n"
              f"element vertex {len(corners)}\nproperty float x\nproperty float y\nproperty float z\n"
              f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
    with open(path, "wb") as file:
        file.write(header.encode())
        for corner in corners:
            file.write(struct.pack("<3f", *corner))
        for triangle in triangles:
            file.write(struct.pack("<B3i", 3, *triangle))


def moments(corners, triangles):
    """Integrals of 1, x_i and x_i x_j over the solid."""
    volume, first, second = 0.0, [0.0] * 3, [[0.0] * 3 for _ in range(3)]
    for triangle in triangles:
        spanned = [corners[v] for v in triangle]
        part = determinant(*spanned) / 6
        total = [sum(c[i] for c in spanned) for i in range(3)]
        volume += part
        for i in range(3):
            first[i] += part * total[i] / 4
            for j in range(3):
                products = sum(c[i] * c[j] for c in spanned) + total[i] * total[j]
                second[i][j] += part * products / 20
    return volume, first, second


def surface(corners, triangles):
    area = 0.0
    for i, j, k in triangles:
        a, b = ([q - p for p, q in zip(corners[i], corners[m])] for m in (j, k))
        cross = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
        area += math.sqrt(sum(c * c for c in cross)) / 2
    return area


def conserved(corners, triangles):
    """Names and values of what the flight keeps, and the volume and surface at its start."""
    volume, first, second = moments(corners, triangles)
    # u_i = DRIFT_i + GRADIENT_ij x_j
    momentum = [DENSITY * (DRIFT[i] * volume + sum(GRADIENT[i][j] * first[j] for j in range(3)))
                for i in range(3)]
    moved = [[DENSITY * (DRIFT[i] * first[k] + sum(GRADIENT[i][j] * second[j][k] for j in range(3)))
              for k in range(3)] for i in range(3)]  # integral of rho u_i x_k
    spin = [moved[(i + 2) % 3][(i + 1) % 3] - moved[(i + 1) % 3][(i + 2) % 3] for i in range(3)]
    energy = sum(DRIFT[i] * momentum[i] for i in range(3)) / 2
    energy += sum(GRADIENT[i][k] * moved[i][k] for i in range(3) for k in range(3)) / 2
    return {"volume_at_start": volume, "surface_area_at_start": surface(corners, triangles),
            "mass": DENSITY * volume, "momentum_x": momentum[0], "momentum_y": momentum[1],
            "momentum_z": momentum[2], "angular_momentum_x": spin[0],
            "angular_momentum_y": spin[1], "angular_momentum_z": spin[2], "total_energy": energy}


def single(x):
    """As the file holds it."""
    return struct.unpack("<f", struct.pack("<f", x))[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--divisions", type=int, default=4, help="20 * 4^n triangles")
    parser.add_argument("--out", type=Path, default=Path(__file__).resolve().parent)
    arguments = parser.parse_args()
    corners, triangles = icosahedron()
    for _ in range(arguments.divisions):
        corners, triangles = divided(corners, triangles)
    corners = [tuple(single(x) for x in organ(c)) for c in corners]
    arguments.out.mkdir(parents=True, exist_ok=True)
    write_ply(arguments.out / "organ.ply", corners, triangles)
    kept = conserved([tuple(0.001 * x for x in c) for c in corners], triangles)
    with open(arguments.out / "reference.csv", "w", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["time", *kept])
        for k in range(9):
            rows.writerow([f"{0.02 * k:.2f}", *(f"{value:.9g}" for value in kept.values())])


if __name__ == "__main__":
    main()
