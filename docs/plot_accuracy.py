#!/usr/bin/env python3
"""Draws errors over times: plot_accuracy.py accuracy.json picture.png [--processor-time]

The file is one that `pliant bench --accuracy --save` or bench/peers wrote, or performance/peers.json. Dots
are runs; lines are the largest error from a run on to finer ones, as costs are read from. Those of other
programs are dashed. Needs python3-matplotlib.
"""
import argparse
import json
import math
import statistics

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

ERRORS = (3, 1, 0.3)  # [%]
LEAST = 0.01  # [%] nothing below this is drawn


def points_of(row, key):
    """Median times, errors [%] and their envelope, of the runs that gave an answer, coarse first."""
    answers = [rung for rung in row["rungs"] if rung["error"] is not None and rung.get(key)]
    times = [statistics.median(rung[key]) for rung in answers]
    errors = [100 * rung["error"] for rung in answers]
    return times, errors, [max(errors[i:]) for i in range(len(errors))]


def name_of(row):
    return f"{row['program']}, {row['series']}" if "program" in row else row["series"]


def colours_of(rows):
    """One colour for each method, the same in every panel."""
    names = list(dict.fromkeys(name_of(row) for row in rows))
    return {name: plt.colormaps["tab20" if len(names) > 10 else "tab10"](i) for i, name in enumerate(names)}


def label_ticks(axis):
    for scale in (axis.xaxis, axis.yaxis):
        scale.set_major_locator(LogLocator(subs=(1, 3)))
        scale.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        scale.set_minor_locator(NullLocator())
    axis.tick_params(labelsize=9)


def draw(axis, problem, rows, key, colours):
    for row in rows:
        times, errors, envelope = points_of(row, key)
        style = "--" if "program" in row else "-"
        axis.loglog(times, [max(e, LEAST) for e in envelope], style, color=colours[name_of(row)], label=name_of(row))
        axis.loglog(times, [max(e, LEAST) for e in errors], ".", color=colours[name_of(row)], markersize=6)
    for error in ERRORS:
        axis.axhline(error, color="0.85", linewidth=0.8, zorder=0)
    axis.set_title(problem.replace("_", " "), fontsize=11)
    label_ticks(axis)


def add_legend(figure, axes, time):
    """One for all panels, below them and the name of their common axis."""
    entries = {}
    for axis in axes.flat:
        entries.update(zip(*reversed(axis.get_legend_handles_labels())))
    columns = 3 if any(len(name) > 30 for name in entries) else 4
    line = 0.22 / figure.get_figheight()
    height = line * (math.ceil(len(entries) / columns) + 1)
    figure.get_layout_engine().set(rect=(0, height + 1.5 * line, 1, 1 - height - 1.5 * line))
    figure.supxlabel(time, fontsize=11, y=height)
    figure.legend(entries.values(), entries.keys(), loc="lower center", ncol=columns, fontsize=9, frameon=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("record")
    parser.add_argument("picture")
    parser.add_argument("--processor-time", action="store_true", help="of all threads, instead of wall time")
    arguments = parser.parse_args()
    with open(arguments.record) as file:
        record = json.load(file)
    key, time = ("processor_seconds", "processor time") if arguments.processor_time else ("seconds", "wall time")
    problems = {}
    for row in record["rows"]:
        if not points_of(row, key)[0]:
            continue
        problems.setdefault(row["problem"], []).append(row)
    columns = 2 if len(problems) == 4 else min(len(problems), 3)
    lines = math.ceil(len(problems) / columns)
    width = 10 if columns == 2 else 4 * columns
    figure, axes = plt.subplots(lines, columns, figsize=(width, 3 / 4 * width * lines / columns), layout="constrained",
                                squeeze=False)
    for axis in axes.flat[len(problems):]:
        axis.axis("off")
    colours = colours_of([row for rows in problems.values() for row in rows])
    for axis, (problem, rows) in zip(axes.flat, problems.items()):
        draw(axis, problem, rows, key, colours)
    figure.supylabel("error [%]", fontsize=11)
    add_legend(figure, axes, f"{time} of the run [s], {record['threads']} threads")
    figure.savefig(arguments.picture, dpi=90)


if __name__ == "__main__":
    main()
