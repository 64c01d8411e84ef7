#!/usr/bin/env python3
"""Writes reference.csv: two equal elastic spheres that collide, by the theory of Hertz with the
correction of Tatara (1989) for their size, as one degree of freedom: m/2 d''= -F(d)."""
import math

radius, young, poisson, density, speed = 0.5, 100.0, 0.3, 1.0, 0.1
mass = 4 / 3 * math.pi * radius**3 * density


def contact_radius(force):
    return (3 * force * radius / 2 * (1 - poisson**2) / (2 * young)) ** (1 / 3)


def approach(force):
    """Of the middles; what the far side of each sphere takes of it is subtracted."""
    a = contact_radius(force)
    across = math.hypot(a, 2 * radius)
    far = 2 * (1 + poisson) * radius**2 / across**3 + (1 - poisson**2) / across
    return 2 * (3 * (1 - poisson**2) * force / (4 * a * young) - force / (math.pi * young) * far)


def force(distance):
    """Inverse of the approach, by bisection."""
    low, high = 1e-12, 2.0
    if distance <= approach(low):
        return 0.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if approach(middle) < distance else (low, middle)
    return low


step, every, end = 1e-3, 10, 800
distance, closing = 0.0, 2 * speed
with open(__file__.replace("make_reference.py", "reference.csv"), "w") as table:
    table.write("t,force,momentum,approach,contact_radius\n")
    for time in range(end + 1):
        push = force(distance)
        if time % every == 0:
            radius_now = contact_radius(push) if push > 0 else 0
            table.write(f"{time * step:.2f},{push / 4:.6f},{closing / (2 * speed):.6f},"
                        f"{max(distance, 0):.6f},{radius_now:.6f}\n")
        # Velocity Verlet.
        closing -= push / mass * step
        distance += closing * step
        closing -= force(distance) / mass * step
