#!/usr/bin/env python3
"""Draws frames of a run: plot_frames.py results/rotating_cylinder picture.png --field pressure

Needs python3-h5py and python3-matplotlib. The particles are read from /VTKHDF of result.h5.
"""
import argparse

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np


def frame(file, index, field):
    steps = file["VTKHDF/Steps"]
    first = steps["PointOffsets"][index]
    part = slice(first, first + file["VTKHDF/NumberOfPoints"][index])
    values = file["VTKHDF/PointData"][field][part]
    if values.ndim == 2:
        values = np.linalg.norm(values, axis=1)
    return steps["Values"][index], file["VTKHDF/Points"][part], values


def middle_layer(time, points, values, axis):
    """The particles of the layer across an axis nearest to the middle of a body in space, with the
    two other coordinates; all particles of a plane body."""
    heights = points[:, axis]
    kept = [a for a in range(3) if a != axis]
    if np.ptp(heights) == 0:
        return time, points[:, kept], values
    middle = (heights.min() + heights.max()) / 2
    layers = np.ptp(heights) / len(points) ** (1 / 3)
    near = np.abs(heights - middle) < 0.6 * layers
    return time, points[near][:, kept], values[near]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder")
    parser.add_argument("picture")
    parser.add_argument("--field", default="pressure")
    parser.add_argument("--across", choices="xyz", default="z", help="in space: normal of the layer")
    parser.add_argument("--frames", type=int, default=4, help="how many, spread over the run")
    arguments = parser.parse_args()
    with h5py.File(f"{arguments.folder}/result.h5", "r") as file:
        count = len(file["VTKHDF/Steps/Values"])
        indices = np.linspace(0, count - 1, min(arguments.frames, count)).round().astype(int)
        axis = "xyz".index(arguments.across)
        frames = [middle_layer(*frame(file, i, arguments.field), axis) for i in indices]
    lowest = min(values.min() for *_, values in frames)
    highest = max(values.max() for *_, values in frames)
    points = np.concatenate([points for _, points, _ in frames])
    low, high = points.min(axis=0), points.max(axis=0)
    low, high = low - 0.05 * max(high - low), high + 0.05 * max(high - low)
    wide = high[0] - low[0] > 3 * (high[1] - low[1])
    shape = (len(frames), 1) if wide else (1, len(frames))
    size = (9, 1.6 * len(frames)) if wide else (3 * len(frames), 3.4)
    figure, axes = plt.subplots(*shape, figsize=size, squeeze=False, layout="constrained")
    for axis, (time, points, values) in zip(axes.flat, frames):
        spacing = np.sqrt((high[0] - low[0]) * (high[1] - low[1]) / len(points))
        dot = (72 * spacing * size[0] / shape[1] / (high[0] - low[0])) ** 2 * 0.5
        drawn = axis.scatter(points[:, 0], points[:, 1], c=values, s=min(dot, 30), cmap="viridis",
                             vmin=lowest, vmax=highest, linewidths=0)
        axis.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), title=f"t = {time:.4g} s")
        axis.set_aspect("equal")
    figure.colorbar(drawn, ax=axes, label=arguments.field, shrink=0.8)
    figure.savefig(arguments.picture, dpi=80)


if __name__ == "__main__":
    main()
