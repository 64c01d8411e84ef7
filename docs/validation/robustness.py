#!/usr/bin/env python3
"""Runs shipped cases off their settings, and says which results are right.

    docs/validation/robustness.py [--hours H] [--cases NAME ...] [--out FOLDER] [--program ./pliant]
    docs/validation/robustness.py --pages        only judges what there is and writes the pages

Each family of robustness_families.py varies spacing, load, shape, remeshing and kernel of a case. Its
runs are a batch of `pliant batch`, in FOLDER/NAME (default results/robustness), so that a sweep that
was stopped goes on where it was. Runs that differ from the default in one axis come first, then those
that differ in two, so that any number of hours gives a spread of the whole. Writes robustness.csv,
robustness.md and robustness.png beside this file; runs that are not made again keep their rows, which
name the commit they were made at. Needs python3-matplotlib.
"""
import argparse
import csv
import itertools
import json
import pathlib
import random
import signal
import sqlite3
import subprocess
import time

import headline
import robustness_page
from robustness_families import families, root

here = pathlib.Path(__file__).resolve().parent
slice_size = 6  # runs of a family before the next family has its turn


def runs_of(family):
    """The runs of a family in order: those that others are compared with, then by how many labels
    are not the default ones."""
    names = list(family.axes)
    all_runs = [dict(zip(names, labels)) for labels in itertools.product(*family.axes.values())]
    random.Random(1).shuffle(all_runs)

    def rank(run):
        other = [axis for axis in names if run[axis] != family.axes[axis][0]]
        if run == reference_run(family, run):
            return len([axis for axis in other if axis != "spacing"])
        return len(other)

    return sorted(all_runs, key=rank)


def reference_run(family, run):
    """The run that stands for the right answer where there is no reference: the finest one of the
    same load and shape, with the defaults of the other axes."""
    own = {axis: labels[0] for axis, labels in family.axes.items()}
    return {**own, "load": run["load"], "shape": run["shape"], "spacing": family.finest()}


class Batch:
    """Runs of a family in a folder."""

    def __init__(self, family, folder, program, runs=None):
        self.family, self.folder, self.program = family, folder / family.name, program
        self.runs = runs_of(family) if runs is None else runs
        self.asked = 0

    def write_sweep(self, count):
        self.folder.mkdir(parents=True, exist_ok=True)
        source = root / "cases" / self.family.case
        text = (source / "case.toml").read_text().replace('file = "', f'file = "{source}/')
        if self.family.measurements:
            text = text[:text.index("[[measurement]]")] + self.family.measurements
        (self.folder / "case.toml").write_text(text)
        rows = [self.family.settings(run) for run in self.runs[:count]]
        with (self.folder / "runs.csv").open("w", newline="") as file:
            table = csv.DictWriter(file, list(rows[0]))
            table.writeheader()
            table.writerows(rows)
        (self.folder / "sweep.toml").write_text(
            f'case = "case.toml"\nset = {json.dumps(list(self.family.base))}\n'
            f"time_limit = {3600 * self.family.hours:.0f}\n\n"
            '[[design]]\nkind = "table"\nfile = "runs.csv"\n')

    def advance(self, seconds):
        """Makes a slice of runs within a time; whether there is more to do."""
        self.asked = min(self.asked + slice_size, len(self.runs))
        self.write_sweep(self.asked)
        command = [self.program, "batch", self.folder / "sweep.toml", "--out", self.folder / "batch",
                   "--resume", "--quiet", "--workers", "1"]
        with subprocess.Popen(command, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL) as batch:
            try:
                batch.wait(timeout=seconds)
            except subprocess.TimeoutExpired:
                batch.send_signal(signal.SIGINT)
        if batch.returncode == 2:
            raise SystemExit(f"{' '.join(map(str, command))}: wrong input")
        return self.asked < len(self.runs)

    def outcomes(self):
        """What each run that has ended gave, in the order of the runs."""
        ledger = self.folder / "batch" / "batch.sqlite"
        if not ledger.exists():
            return []
        with sqlite3.connect(ledger) as connection:
            ended = connection.execute("select name, status, exit_status, message from run "
                                       "where status in ('done', 'failed')").fetchall()
            parameters = {}
            for name, key, value in connection.execute("select run, key, value from parameter"):
                parameters.setdefault(name, {})[key] = value
        status = {frozenset(parameters[name].items()): (name, *rest) for name, *rest in ended}
        found = []
        for run in self.runs:
            key = frozenset((k, text_of(v)) for k, v in self.family.settings(run).items())
            if key in status:
                found.append((run, self.outcome(*status[key])))
        return found

    def outcome(self, name, status, exit_status, message):
        folder = self.folder / "batch" / "runs"
        log = (folder / f"{name}.log").read_text() if (folder / f"{name}.log").exists() else ""
        warnings = [line for line in log.splitlines() if "warning:" in line]
        if status != "done":
            return {"stopped": message or f"exit status {exit_status}", "warnings": warnings}
        summary = json.loads((folder / name / "summary.json").read_text())
        energy = summary["checks"]["energy"]
        scale = energy.get("largest_energy_or_work") or 0
        return {"values": {n: m["value"] for n, m in summary["measurements"].items()},
                "created": energy["created"] / scale if scale else 0.0, "warnings": warnings,
                "seconds": summary["wall_time"]}


def text_of(value):
    """A value as the ledger keeps it: numbers in their shortest form."""
    try:
        number = float(value)
    except ValueError:
        return value
    return repr(int(number)) if number == int(number) and abs(number) < 1e15 else repr(number)


def deviation(figure, run, value, right):
    scale = figure.scale(run) if figure.scale else right
    return abs(value - right) / abs(scale)


def judge(family, run, outcome, by_run):
    """A row of robustness.csv, but for its commit."""
    row = {"family": family.name, **{f"axis {i}": f"{a}: {l}" for i, (a, l) in enumerate(run.items())},
           "warnings": len(outcome["warnings"]), "verdict": "", "figure": "", "value": "", "right": "",
           "deviation": "", "energy created": "", "seconds": ""}
    if "stopped" in outcome:
        return {**row, "verdict": "stopped", "figure": outcome["stopped"]}
    row["energy created"] = f"{outcome['created']:.3f}"
    row["seconds"] = f"{outcome['seconds']:.1f}"
    worst = -1.0
    for figure in family.figures:
        right = figure.reference(run) if figure.reference else None
        if right is None:
            reference = by_run.get(json.dumps(reference_run(family, run)), {})
            right = reference.get("values", {}).get(figure.measurement)
        value = outcome["values"][figure.measurement]
        if value is None:
            return {**row, "verdict": "no value", "figure": figure.measurement}
        if right is None:
            return {**row, "verdict": "not judged", "figure": figure.measurement}
        off = deviation(figure, run, value, right)
        if off / figure.tolerance > worst:
            worst = off / figure.tolerance
            row.update({"figure": figure.measurement, "value": f"{value:.6g}", "right": f"{right:.6g}",
                        "deviation": f"{off:.4f}"})
    is_right = worst <= 1 and outcome["created"] <= 0.05
    row["verdict"] = ("right" if is_right else "wrong") + (", warned" if outcome["warnings"] else "")
    return row


def rows_of(batch, commit):
    outcomes = batch.outcomes()
    by_run = {json.dumps(run): outcome for run, outcome in outcomes}
    return [{**judge(batch.family, run, outcome, by_run), "commit": commit} for run, outcome in outcomes]


def begin(folder):
    """A folder holds the runs of one commit, and its name."""
    file, commit = folder / "commit", headline.commit()
    folder.mkdir(parents=True, exist_ok=True)
    if not file.exists():
        file.write_text(f"{commit}\n")
    earlier = file.read_text().strip()
    if earlier != commit:
        raise SystemExit(f"{folder} holds runs of commit {earlier}, and this is {commit}: give another --out")


def commit_of(folder):
    file = folder / "commit"
    return file.read_text().strip() if file.exists() else headline.commit()


def run_of(row):
    return tuple(row[column] for column in sorted(row) if column.startswith("axis") and row[column])


def write_results(batches, commit):
    file = here / "robustness.csv"
    before = {}
    if file.exists():
        with file.open() as table:
            for row in csv.DictReader(table):
                before.setdefault(row["family"], []).append(row)
    rows = []
    for batch in batches:
        new = rows_of(batch, commit)
        made = {run_of(row) for row in new}
        # A run that is being repeated keeps its row until it ends.
        rows += new + [row for row in before.get(batch.family.name, []) if run_of(row) not in made]
    columns = list(dict.fromkeys(key for row in rows for key in row))
    columns = ["family", "commit", *sorted(c for c in columns if c.startswith("axis")),
               *(c for c in columns if c not in ("family", "commit") and not c.startswith("axis"))]
    with file.open("w", newline="") as table:
        writer = csv.DictWriter(table, columns, restval="")
        writer.writeheader()
        writer.writerows(rows)
    robustness_page.write(rows, {b.family.name: len(b.runs) for b in batches}, here)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--hours", type=float, default=float("inf"))
    parser.add_argument("--cases", nargs="*", metavar="NAME")
    parser.add_argument("--out", type=pathlib.Path, default=root / "results/robustness")
    parser.add_argument("--program", default=str(root / "pliant"))
    parser.add_argument("--pages", action="store_true")
    arguments = parser.parse_args()
    unknown = set(arguments.cases or []) - {family.name for family in families}
    if unknown:
        parser.error(f"no {', '.join(sorted(unknown))}; there are "
                     f"{', '.join(family.name for family in families)}")
    if not arguments.pages:
        begin(arguments.out)
    batches = [Batch(family, arguments.out, arguments.program) for family in families]
    active = [b for b in batches if not arguments.cases or b.family.name in arguments.cases]
    end = time.monotonic() + 3600 * arguments.hours
    while active and not arguments.pages and time.monotonic() < end:
        active = [b for b in active if time.monotonic() >= end
                  or b.advance(min(end - time.monotonic(), longest_wait))]
    write_results(batches, commit_of(arguments.out))


longest_wait = 1e6  # [s], the maximum of subprocess


if __name__ == "__main__":
    main()
