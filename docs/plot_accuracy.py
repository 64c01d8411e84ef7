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


def draw(axis, problem, rows, key):
    for number, row in enumerate(rows):
        times, errors, envelope = points_of(row, key)
        colour, style = f"C{number}", "--" if "program" in row else "-"
        axis.loglog(times, [max(e, LEAST) for e in envelope], style, color=colour, label=name_of(row))
        axis.loglog(times, [max(e, LEAST) for e in errors], ".", color=colour, markersize=5)
    for error in ERRORS:
        axis.axhline(error, color="0.8", linewidth=0.8, zorder=0)
    axis.set_title(problem, fontsize=9)
    axis.tick_params(labelsize=7)
    axis.legend(fontsize=6 if len(rows) < 8 else 5, framealpha=0.6)


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
    for axis, (problem, rows) in zip(axes.flat, problems.items()):
        draw(axis, problem, rows, key)
    figure.supxlabel(f"{time} of the run [s], {record['threads']} threads", fontsize=9)
    figure.supylabel("error [%]", fontsize=9)
    figure.savefig(arguments.picture, dpi=80)


if __name__ == "__main__":
    main()
