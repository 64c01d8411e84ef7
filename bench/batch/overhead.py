#!/usr/bin/env python3
"""What a batch adds to its runs, and what a second worker gains.

    python3 bench/batch/overhead.py [--program PROGRAM] [--runs 200]

Runs a sweep of a case with about 1000 particles with one worker and with two. The overhead of a run is the time of the
batch with one worker less that of all its processes, from the ledger, over their number. Needs two idle cores.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SWEEP = """case = "{case}"
set = ["discretisation.spacing=0.056", "time.step=0.001", "time.end=0.02", "output.every=0.02"]
[[design]]
parameters."body.cylinder.material.poissons_ratio" = {{ from = 0.1, to = 0.45, count = {runs} }}
"""


def measure(program, sweep, folder, workers):
    """Wall time of a batch, and the rows of its ledger."""
    start = time.monotonic()
    subprocess.run([program, "batch", sweep, "--out", folder, "--workers", str(workers), "--quiet"], check=True)
    taken = time.monotonic() - start
    status = subprocess.run([program, "batch", "status", folder, "--json"], check=True, capture_output=True, text=True)
    return taken, json.loads(status.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/engine/cli/pliant")
    parser.add_argument("--runs", type=int, default=200)
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        sweep = scratch / "sweep.toml"
        sweep.write_text(SWEEP.format(case=ROOT / "cases/rotating_cylinder", runs=arguments.runs))
        one, rows = measure(program, sweep, scratch / "one", 1)
        two, _ = measure(program, sweep, scratch / "two", 2)
        particles = json.loads(next((scratch / "one/runs").glob("*/summary.json")).read_text())["particles"]["end"]
    runs = len(rows)
    inside = sum(row["wall_seconds"] for row in rows)
    print(f"{runs} runs of {particles} particles: {1e3 * inside / runs:.1f} ms each, "
          f"and {1e3 * (one - inside) / runs:.1f} ms of overhead; two workers: {one / two:.2f} times the rate of one")


if __name__ == "__main__":
    main()
