#!/usr/bin/env python3
"""Measures other programs and pliant in turns on problems of bench/accuracy.toml.

    bench/peers/build
    bench/peers/run.py --save peers.json [--quick] [--rows TEXT]

One rung of each series runs, then the next of each, and all of it several times. A series ends with the first run
that takes too long or gives no answer. The file has the format of `pliant bench --accuracy --save`, and the program
of each row that is not pliant's; docs/plot_accuracy.py draws it. It is written after each run, and runs that it has
are not repeated: the same command continues an interrupted one. ladders.toml says what runs.
"""
import argparse
import json
import math
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time
import tomllib

import programs

here = pathlib.Path(__file__).resolve().parent
root = here.parents[1]


class Series:
    """A method of a program on a problem, its rungs, and its row of the record."""

    def __init__(self, problem, name, rungs, prepare, program=None):
        self.targets = problem["target"]
        self.rungs = rungs
        self.prepare = prepare  # run(settings, folder, rung)
        self.row = {"problem": problem["name"], "program": program, "series": name, "rungs": []}
        if program is None:  # pliant
            del self.row["program"]
        self.name = "/".join(filter(None, (problem["name"], program, name)))

    def error_of(self, values):
        return max(abs(values[one["measurement"]] - one["reference"]) / one.get("scale", abs(one["reference"]))
                   for one in self.targets)


def series_of_pliant(problem, series):
    rungs = series.get("rungs", problem["rungs"])
    rungs = [[rung] if isinstance(rung, str) else rung for rung in rungs]
    changes = problem.get("set", []) + series.get("set", [])
    case = (root / "bench" / problem["case"]).resolve() / "case.toml"

    def prepare(settings, folder, rung):
        return programs.pliant(settings, folder, case, changes + rung)

    return Series(problem, series["name"], rungs, prepare), series.get("quick", problem["quick"])


def series_of_peer(problem, peer):
    program, options = programs.PEERS[peer["program"]], peer.get("options", {})

    def prepare(settings, folder, rung):
        return program(settings, folder, problem["name"], int(rung[0].partition("=")[2]), **options)

    rungs = [[f"across={across}"] for across in peer["rungs"]]
    return Series(problem, peer["name"], rungs, prepare, peer["program"]), peer["quick"]


def series_by_problem(ladders, is_quick):
    """In the order in which they take turns."""
    all_problems = tomllib.loads((root / "bench/accuracy.toml").read_text())["problem"]
    problems = {problem["name"]: problem for problem in all_problems}
    for entry in ladders["problem"]:
        problem = problems[entry["name"]]
        own = {series["name"]: series for series in problem["series"]}
        found = [series_of_pliant(problem, own[name]) for name in entry["pliant"]]
        found += [series_of_peer(problem, peer) for peer in entry["peer"]]
        for series, quick in found:
            series.rungs = series.rungs[:quick] if is_quick else series.rungs
        yield [series for series, _ in found]


def end_of(run, folder, limit):
    """Exit status, standard output, wall time and processor time of a run."""

    def bound():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))

    with open(folder / "stdout", "w+") as output:
        start = time.monotonic()
        process = subprocess.Popen(run.command, cwd=folder, env={**os.environ, **run.environment}, stdout=output,
                                   stderr=subprocess.STDOUT, preexec_fn=bound)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.monotonic() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        return process.returncode, output.read(), seconds, usage.ru_utime + usage.ru_stime


def measure(series, number, settings, limit):
    """Adds a run to the row of its series."""
    row = series.row["rungs"]
    if len(row) == number:
        row.append({"settings": series.rungs[number], "particles": 0, "steps": 0, "seconds": [],
                    "processor_seconds": [], "error": None, "values": {}, "message": ""})
    rung = row[number]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run = series.prepare(settings, folder, series.rungs[number])
        status, output, seconds, processor_seconds = end_of(run, folder, limit)
        if status != 0:
            last = (output.strip().splitlines() or [""])[-1]
            rung["message"] = "took too long" if processor_seconds > limit - 1 else f"status {status}: {last}"
        else:
            answer = run.read(output)
            error = series.error_of(answer.values)
            wanted = {one["measurement"] for one in series.targets}
            rung.update(particles=answer.particles, steps=answer.steps, error=None if math.isnan(error) else error,
                        values={name: value for name, value in answer.values.items() if name in wanted})
            rung["seconds"].append(seconds)
            rung["processor_seconds"].append(processor_seconds)
    percent = math.nan if rung["error"] is None else 100 * rung["error"]
    found = f"{rung['particles']} particles, {processor_seconds:.3g} s, error {percent:.3g} %"
    print(f"{series.name} {' '.join(rung['settings'])}: {rung['message'] or found}", file=sys.stderr)


def is_needed(series, number, turn, once):
    """Whether this turn still has to run this rung."""
    row = series.row["rungs"]
    if number >= len(series.rungs) or any(rung["message"] for rung in row[:number + 1]):
        return False
    if len(row) <= number:
        return True
    times = row[number]["processor_seconds"]
    return len(times) <= turn and min(times, default=0) < once


def machine_of(settings):
    """As `pliant bench --accuracy` describes it."""
    with tempfile.TemporaryDirectory() as folder:
        command = [settings.pliant, "bench", "--accuracy", "--quick", "--rows", "compression/total_lagrangian",
                   "--json", "--out", folder, "--ladders", root / "bench/accuracy.toml",
                   "--threads", str(settings.threads)]
        done = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return json.loads(done.stdout)["machine"]


def keep(rows, before):
    """Takes the runs of rows of the same names."""
    for row in rows:
        for other in before:
            if all(row.get(key) == other.get(key) for key in ("problem", "program", "series")):
                row["rungs"] = other["rungs"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--save", type=pathlib.Path, required=True, metavar="FILE")
    parser.add_argument("--rows", default="", metavar="TEXT", help="series by name, as in cantilever/NiftySim")
    parser.add_argument("--quick", action="store_true", help="coarse rungs only")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--program", type=pathlib.Path, default=root / "build/release/engine/cli/pliant")
    parser.add_argument("--peers", type=pathlib.Path, default=root / "build/peers",
                        help="folder that bench/peers/build filled")
    arguments = parser.parse_args()
    settings = programs.Settings(arguments.program.resolve(), arguments.peers.resolve(), arguments.threads)
    ladders = tomllib.loads((here / "ladders.toml").read_text())
    problems = list(series_by_problem(ladders, arguments.quick))
    record = {"format": "pliant accuracy 1", "machine": machine_of(settings),
              "programs": json.loads((settings.peers / "programs.json").read_text()),
              "threads": arguments.threads}
    rows = [series.row for problem in problems for series in problem]
    if arguments.save.exists():
        keep(rows, json.loads(arguments.save.read_text())["rows"])
    for turn in range(arguments.rounds):
        for problem in problems:
            for number in range(max(len(series.rungs) for series in problem)):
                for series in problem:
                    if arguments.rows in series.name and is_needed(series, number, turn, ladders["once"]):
                        measure(series, number, settings, ladders["time_limit"])
                        record["rows"] = [row for row in rows if row["rungs"]]
                        arguments.save.write_text(json.dumps(record, indent=1) + "\n")


if __name__ == "__main__":
    main()
