#!/usr/bin/env python3
"""Draws a measurement over time: plot_history.py pressure picture.png results/prony_step ...

Needs python3-h5py and python3-matplotlib. Columns of a case's reference.csv are drawn as dots, those
whose names start with the measurement's.
"""
import argparse
import csv
import pathlib

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("measurement")
    parser.add_argument("picture")
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--reference", help="a reference.csv, its first column the time")
    arguments = parser.parse_args()
    figure, axis = plt.subplots(figsize=(7, 3.6), layout="constrained")
    for folder in arguments.folders:
        with h5py.File(folder / "result.h5", "r") as file:
            history = file["measurements"][arguments.measurement]
            axis.plot(history["time"][:], history["value"][:], label=folder.name)
            unit = history["value"].attrs["unit"]
            unit = unit.decode() if isinstance(unit, bytes) else unit
    if arguments.reference:
        with open(arguments.reference, newline="") as file:
            rows = list(csv.DictReader(file))
        time, *columns = rows[0]
        for column in (name for name in columns if name.startswith(arguments.measurement)):
            axis.plot([float(row[time]) for row in rows], [float(row[column]) for row in rows],
                      "k.", markersize=4, label=f"reference: {column}")
    axis.set(xlabel="time [s]", ylabel=f"{arguments.measurement} [{unit}]")
    axis.legend()
    figure.savefig(arguments.picture, dpi=80)


if __name__ == "__main__":
    main()
