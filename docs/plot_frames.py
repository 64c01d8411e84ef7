#!/usr/bin/env python3
"""Draws frames of a run: plot_frames.py results/rotating_cylinder picture.png --field pressure

The pressure of a contact wall is drawn as a map of the wall, from runs with output.ghosts = true:

    plot_frames.py results/bouncing_ball map.png --field wall_pressure --times 0.03 0.07 0.14 \\
        --levels 2 4 6 8

Needs python3-h5py and python3-matplotlib. The particles are read from /VTKHDF of result.h5.
"""
import argparse

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator


PARTICLE = 1  # of the field `kind`; the rest are ghosts


def frame(file, index, field, ghosts=False):
    steps = file["VTKHDF/Steps"]
    first = steps["PointOffsets"][index]
    part = slice(first, first + file["VTKHDF/NumberOfPoints"][index])
    chosen = (file["VTKHDF/PointData/kind"][part] == PARTICLE) != ghosts
    values = file["VTKHDF/PointData"][field][part][chosen]
    if values.ndim == 2:
        values = np.linalg.norm(values, axis=1)
    return steps["Values"][index], file["VTKHDF/Points"][part][chosen], values


def wall_layer(time, points, values):
    """The ghosts of the layer nearest to the wall, across the direction in which they vary least."""
    pressed = values != 0
    if not pressed.any():
        return time, points[:0, :2], values[:0]
    across = np.ptp(points[pressed], axis=0).argmin()
    heights = points[pressed, across]
    margin = 0.02 * np.ptp(points, axis=0).max()
    layer = (points[:, across] > heights.min() - margin) & (
        points[:, across] < heights.max() + margin)
    # Where bodies bulge, several layers may be that near: the compressed ghosts decide.
    plane = np.delete(points, across, axis=1)
    grid = {}
    for place, value in zip(plane[layer], values[layer]):
        key = tuple((place / (0.5 * margin)).round().astype(int))
        if key not in grid or value != 0:
            grid[key] = (place, value)
    places, pressures = zip(*grid.values())
    return time, np.array(places), np.array(pressures)


def middle_layer(time, points, values, axis):
    """The particles of the layer across an axis nearest to the middle of a body in 3D, with the
    two other coordinates; all particles in 2D."""
    heights = points[:, axis]
    kept = [a for a in range(3) if a != axis]
    if np.ptp(heights) == 0:
        return time, points[:, kept], values
    middle = (heights.min() + heights.max()) / 2
    layers = np.ptp(heights) / len(points) ** (1 / 3)
    near = np.abs(heights - middle) < 0.6 * layers
    return time, points[near][:, kept], values[near]


def indices_of(times, wanted, count):
    """Those nearest to the wanted times, or as many as wanted spread over the run."""
    if wanted:
        return [int(np.abs(times - time).argmin()) for time in wanted]
    return np.linspace(0, len(times) - 1, min(count, len(times))).round().astype(int)


def draw_map(axis, points, values, levels, highest):
    """Isolines over filled ones; a wall without contact stays blank."""
    if len(points) < 3:
        return None
    fill = MaxNLocator(40).tick_values(0, highest)
    drawn = axis.tricontourf(points[:, 0], points[:, 1], values, fill, cmap="viridis",
                             extend="min")
    lines = axis.tricontour(points[:, 0], points[:, 1], values, levels, colors="w", linewidths=0.8)
    axis.clabel(lines, fontsize=7)
    return drawn


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder")
    parser.add_argument("picture")
    parser.add_argument("--field", default="pressure")
    parser.add_argument("--across", choices="xyz", default="z", help="in 3D: normal of the layer")
    parser.add_argument("--frames", type=int, default=4, help="how many, spread over the run")
    parser.add_argument("--times", type=float, nargs="+", help="frames nearest to these times, s")
    parser.add_argument("--levels", type=float, nargs="+", help="isolines of wall_pressure")
    arguments = parser.parse_args()
    with h5py.File(f"{arguments.folder}/result.h5", "r") as file:
        indices = indices_of(file["VTKHDF/Steps/Values"][:], arguments.times, arguments.frames)
        is_map = arguments.field == "wall_pressure"
        across = "xyz".index(arguments.across)
        frames = [frame(file, i, arguments.field, is_map) for i in indices]
    frames = [wall_layer(*f) if is_map else middle_layer(*f, across) for f in frames]
    lowest = min(values.min(initial=np.inf) for *_, values in frames)
    highest = max(values.max(initial=-np.inf) for *_, values in frames)
    points = np.concatenate([points for _, points, _ in frames])
    low, high = points.min(axis=0), points.max(axis=0)
    low, high = low - 0.05 * max(high - low), high + 0.05 * max(high - low)
    wide = high[0] - low[0] > 3 * (high[1] - low[1])
    shape = (len(frames), 1) if wide else (1, len(frames))
    size = (9, 1.6 * len(frames)) if wide else (3 * len(frames), 3.4)
    drawn = None
    figure, axes = plt.subplots(*shape, figsize=size, squeeze=False, layout="constrained")
    for axis, (time, points, values) in zip(axes.flat, frames):
        axis.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), title=f"t = {time:.4g} s")
        axis.set_aspect("equal")
        if is_map:
            drawn = draw_map(axis, points, values, arguments.levels, highest) or drawn
            continue
        spacing = np.sqrt((high[0] - low[0]) * (high[1] - low[1]) / len(points))
        dot = (72 * spacing * size[0] / shape[1] / (high[0] - low[0])) ** 2 * 0.5
        drawn = axis.scatter(points[:, 0], points[:, 1], c=values, s=min(dot, 30), cmap="viridis",
                             vmin=lowest, vmax=highest, linewidths=0)
    if drawn is None:
        raise SystemExit("no body is in contact with a wall at these times")
    figure.colorbar(drawn, ax=axes, label=arguments.field, shrink=0.8)
    figure.savefig(arguments.picture, dpi=80)


if __name__ == "__main__":
    main()
