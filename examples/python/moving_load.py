#!/usr/bin/env python3
"""A load rolls over a block of rubber, as in examples/moving_load, but in Python.

    python3 examples/python/moving_load.py

Each part between the lines `# %%` is a cell for editors that run such files as notebooks.
"""
# %% The case, with the keys of docs/case-reference.md
import numpy as np

import pliant

STRIPS, LENGTH, HEIGHT = 8, 0.4, 0.1  # [m]
edges = np.linspace(0, LENGTH, STRIPS + 1)
ground = {"name": "ground", "kind": "fixed", "geometry": {"shape": "half_space", "point": [0, 0], "normal": [0, 1]}}
strips = [{"name": f"strip{i}", "kind": "pressure", "pressure": 0,
           "geometry": {"shape": "box", "lower": [edges[i], 0.05], "upper": [edges[i + 1], 0.2]}} for i in range(STRIPS)]
case = {
    "method": "total_lagrangian",
    "discretisation": {"spacing": HEIGHT / 16},
    "time": {"end": 1},
    "total_lagrangian": {"damping": 20},
    "body": [{"name": "block", "geometry": {"shape": "box", "lower": [0, 0], "upper": [LENGTH, HEIGHT]},
              "material": {"model": "reduced_polynomial", "density": 1000, "coefficients": [5000], "compressibility": 2e-5}}],
    "boundary": [ground, *strips],
    "measurement": [{"name": "middle", "kind": "point_displacement", "point": [LENGTH / 2, HEIGHT], "axis": "y"}],
}
simulation = pliant.Simulation(case)

# %% The time loop: the load moves on, and its pressure with it
SPEED, WEIGHT = 0.8, 2000  # [m/s], [Pa]
for frame in range(1, 31):
    place = SPEED * simulation.time * STRIPS / LENGTH
    for i in range(STRIPS):
        simulation.set_pressure(f"strip{i}", WEIGHT * max(0, 1 - abs(place - (i + 0.5))))
    simulation.advance(frame / 60)
    print(f"t = {simulation.time:.3f} s: the middle of the top has moved by {simulation.measurement('middle'):+.5f} m")

# %% Fields are numpy arrays
displacement = simulation.field("displacement")
deepest = displacement[:, 1].argmin()
print(f"deepest: {displacement[deepest, 1]:.5f} m, at x = {simulation.positions()[deepest, 0]:.3f} m")
