#!/usr/bin/env python3
"""The tip of the aspirated liver on lattices of 16 to 44 cells over the height, and its page.

    docs/validation/liver.py [--hours H] [--out FOLDER] [--program ./pliant]
    docs/validation/liver.py --pages

The runs are a batch in FOLDER (default results/liver), so that a part of them can be made at a time;
coarse ones come first. Writes liver.csv and liver.md beside this file.
"""
import argparse
import csv
import pathlib
import time

from robustness import Batch, longest_wait
from robustness_families import Family, column, measurement, root

here = pathlib.Path(__file__).resolve().parent
coefficients = (2230, 7020, 5030, 6190, 7500)
suctions = (10, 20, 30)  # [kPa]
viscous = "{ ratios = [0.3, 0.2], times = [0.5, 3] }"


def settings(run):
    cells, softness = run["cells"], float(run["softness"])
    prony = f", prony = {viscous}" if run["viscosity"] == "viscous" else ""
    return {"discretisation.spacing": f"0.025/{cells}", "time.step": f"1e-3*20/{cells}",
            "body.tissue.material": '{ model = "reduced_polynomial", density = 1060, compressibility = '
                                    f"5e-8, coefficients = {[softness * c for c in coefficients]}{prony} }}"}


# The suction is 30 kPa (t/15 s)^2.
tips = measurement("tip", "extent", axis="z", reference=0.025)
tips += measurement("energy_ratio", "energy_ratio")
for kPa in suctions[:-1]:
    tips += measurement(f"tip_{kPa}", "value_at_time", of="tip", time=15 * (kPa / 30) ** 0.5)


def runs():
    """All lattices of the elastic liver, coarse ones of others."""
    plain = [("1", "elastic")]
    others = [("0.5", "elastic"), ("2", "elastic"), ("5", "elastic"), ("1", "viscous")]
    return [{"cells": cells, "softness": softness, "viscosity": viscosity}
            for sizes, kinds in (((16, 20, 24, 28), plain), ((16, 20), others), ((32, 36), plain),
                                 ((24, 28), others), ((44,), plain))
            for cells in sizes for softness, viscosity in kinds]


family = Family("liver", "liver_aspiration", {}, settings, [], tips,
                ("output.every=0", "output.measure_every=0.05"), hours=6)


def rows_of(batch):
    rows = []
    for run, outcome in batch.outcomes():
        row = {**run}
        if "stopped" in outcome:
            rows.append({**row, "stopped": outcome["stopped"]})
            continue
        values = outcome["values"]
        for kPa in suctions:
            # Almost incompressible: only suction over stiffness matters.
            alike = kPa / float(run["softness"])
            tip = 1e3 * values["tip" if kPa == 30 else f"tip_{kPa}"]
            row[f"tip at {kPa} kPa [mm]"] = f"{tip:.4f}"
            if alike <= 30:
                right = column("liver_aspiration", alike, "tip_mm")
                row[f"off at {kPa} kPa [%]"] = f"{100 * (tip / right - 1):+.2f}"
        row["kinetic over strain energy"] = f"{values['energy_ratio']:.5f}"
        row["warnings"] = len(outcome["warnings"])
        rows.append(row)
    return rows


def write(rows):
    columns = list(dict.fromkeys(key for row in rows for key in row))
    with (here / "liver.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, columns, restval="")
        writer.writeheader()
        writer.writerows(rows)
    rows.sort(key=lambda r: (r["viscosity"], float(r["softness"]) != 1, float(r["softness"]), r["cells"]))
    head = ["cells over the height", "coefficients times", "", *(f"tip at {p} kPa [mm]" for p in suctions),
            *(f"off at {p} kPa [%]" for p in suctions)]
    lines = ["# Aspirated liver, by lattice", "",
             "Written by [liver.py](liver.py). The deviation is that of the tip of the surface from mixed finite",
             "elements. The step is 1 ms times 20 over the number of cells; all other settings are those of the case.",
             "Nearly incompressible tissue with other coefficients is compared at the suction over that factor,",
             "where the finite elements reach it. The viscous tissue has Prony terms of 0.3 and 0.2 of the bulk",
             "modulus with 0.5 and 3 s.", "",
             "| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    for row in rows:
        lines.append("| " + " | ".join(str(row.get(k, "")) for k in (
            "cells", "softness", "viscosity", *(f"tip at {p} kPa [mm]" for p in suctions),
            *(f"off at {p} kPa [%]" for p in suctions))) + " |")
    (here / "liver.md").write_text("\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--hours", type=float, default=float("inf"))
    parser.add_argument("--out", type=pathlib.Path, default=root / "results")
    parser.add_argument("--program", default=str(root / "pliant"))
    parser.add_argument("--pages", action="store_true")
    arguments = parser.parse_args()
    batch = Batch(family, arguments.out, arguments.program, runs())
    end = time.monotonic() + 3600 * arguments.hours
    while not arguments.pages and time.monotonic() < end:
        if not batch.advance(min(end - time.monotonic(), longest_wait)):
            break
    write(rows_of(batch))


if __name__ == "__main__":
    main()
