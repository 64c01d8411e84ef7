#!/usr/bin/env python3
"""Draws errors over wall times: plot_accuracy.py accuracy.json picture.png

The file is one that `pliant bench --accuracy --save` or bench/peers wrote. Dots are runs; lines are the
largest error from a run on to finer ones, as costs are read from. Needs python3-matplotlib.
"""
import argparse
import json
import math
import statistics

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

ERRORS = (3, 1, 0.3)  # [%]
LEAST = 0.01  # [%] below which nothing is drawn


def points_of(row):
    """Wall times, errors [%] and their envelope, of the runs that gave an answer, coarse first."""
    answers = [rung for rung in row["rungs"] if rung["error"] is not None and rung["seconds"]]
    times = [statistics.median(rung["seconds"]) for rung in answers]
    errors = [100 * rung["error"] for rung in answers]
    return times, errors, [max(errors[i:]) for i in range(len(errors))]


def draw(axis, problem, rows):
    for number, row in enumerate(rows):
        times, errors, envelope = points_of(row)
        colour = f"C{number}"
        axis.loglog(times, [max(e, LEAST) for e in envelope], "-", color=colour, label=row["series"])
        axis.loglog(times, [max(e, LEAST) for e in errors], ".", color=colour, markersize=5)
    for error in ERRORS:
        axis.axhline(error, color="0.8", linewidth=0.8, zorder=0)
    axis.set_title(problem, fontsize=9)
    axis.tick_params(labelsize=7)
    axis.legend(fontsize=6)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("record")
    parser.add_argument("picture")
    arguments = parser.parse_args()
    with open(arguments.record) as file:
        record = json.load(file)
    problems = {}
    for row in record["rows"]:
        if not points_of(row)[0]:
            continue
        problems.setdefault(row["problem"], []).append(row)
    columns = min(len(problems), 3)
    lines = math.ceil(len(problems) / columns)
    figure, axes = plt.subplots(lines, columns, figsize=(4 * columns, 3 * lines), layout="constrained",
                                squeeze=False)
    for axis in axes.flat[len(problems):]:
        axis.axis("off")
    for axis, (problem, rows) in zip(axes.flat, problems.items()):
        draw(axis, problem, rows)
    figure.supxlabel(f"wall time of the run [s], {record['threads']} threads", fontsize=9)
    figure.supylabel("error [%]", fontsize=9)
    figure.savefig(arguments.picture, dpi=80)


if __name__ == "__main__":
    main()
