#!/usr/bin/env python3
"""Measures CalculiX and pliant in turns on the cantilever of bench/accuracy.toml.

    apt-get install calculix-ccx
    bench/peers/calculix.py --save cantilever.json [--rounds 3] [--threads 2] [--quick]

CalculiX (GPL, a Debian package, called as a program) solves the same static problem implicitly, with
geometric nonlinearity: beam, material, load, and the displacement of the same point. A round runs all its
meshes once, and then all spacings of pliant. Wall times are those of whole processes. FILE has the format
of `pliant bench --accuracy --save`, which docs/plot_accuracy.py draws.
"""
import argparse
import itertools
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

root = pathlib.Path(__file__).resolve().parents[2]
REFERENCE = -2.543e-3  # [m] as in bench/accuracy.toml
LENGTH, WIDTH = 10.0, 2.0  # [m]
LOAD = -1.0  # [N] along z, spread over the end
MATERIAL = "*MATERIAL, NAME=RUBBER\n*ELASTIC\n1e5, 0.3\n*SOLID SECTION, ELSET=BEAM, MATERIAL=RUBBER\n"
# Elements across the beam, even ones so that the middle of its end is a node.
MESHES = {"C3D8": (2, 4, 6, 8, 12), "C3D8I": (2, 4, 6, 8, 12), "C3D20R": (2, 4, 6, 8)}

# Corners and edge middles of a hexahedron, in units of half its edges and in the order of CalculiX.
CORNERS = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
EDGES = [(1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
         (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]


def elements_of(across, kind):
    """Nodes of each element, as places in units of half an element."""
    corners = CORNERS + (EDGES if kind == "C3D20R" else [])
    for i, j, k in itertools.product(range(5 * across), range(across), range(across)):
        yield [(2 * i + a, 2 * j + b, 2 * k + c) for a, b, c in corners]


def loads_of(elements, across):
    """Force [N] on each node of the end: consistent with a uniform traction."""
    end, share = 10 * across, LOAD / across**2
    loads = {}
    for element in elements:
        face = [place for place in element if place[0] == end]
        for place in face:
            is_middle = place[1] % 2 + place[2] % 2 == 1
            weight = 1 / 4 if len(face) == 4 else 1 / 3 if is_middle else -1 / 12
            loads[place] = loads.get(place, 0) + share * weight
    return loads


def deck(across, kind):
    """The input of CalculiX, and the number of nodes."""
    elements = list(elements_of(across, kind))
    numbers = {}
    for place in itertools.chain(*elements):
        numbers.setdefault(place, len(numbers) + 1)
    half = WIDTH / across / 2
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{n}, {x * half:.12g}, {y * half - WIDTH / 2:.12g}, {z * half - WIDTH / 2:.12g}"
              for (x, y, z), n in numbers.items()]
    lines.append(f"*ELEMENT, TYPE={kind}, ELSET=BEAM")
    for number, element in enumerate(elements, 1):
        nodes = [str(numbers[place]) for place in element]
        parts = [", ".join([str(number), *nodes[:15]])] + ([", ".join(nodes[15:])] if nodes[15:] else [])
        lines.append(",\n".join(parts))
    lines += ["*BOUNDARY"] + [f"{n}, 1, 3" for place, n in numbers.items() if place[0] == 0]
    lines += ["*NSET, NSET=TIP", str(numbers[10 * across, across, across])]
    lines += [MATERIAL + "*STEP, NLGEOM", "*STATIC", "1, 1", "*CLOAD"]
    lines += [f"{numbers[place]}, 3, {force:.12g}" for place, force in loads_of(elements, across).items()]
    return "\n".join(lines + ["*NODE PRINT, NSET=TIP", "U", "*END STEP", ""]), len(numbers)


def solve(across, kind, threads, folder):
    """Nodes, wall time [s] and displacement of the tip [m]."""
    text, nodes = deck(across, kind)
    (folder / "beam.inp").write_text(text)
    environment = {**os.environ, "OMP_NUM_THREADS": str(threads), "CCX_NPROC_EQUATION_SOLVER": str(threads)}
    start = time.monotonic()
    done = subprocess.run(["ccx", "beam"], cwd=folder, env=environment, capture_output=True, text=True)
    seconds = time.monotonic() - start
    values = re.findall(r"^ +\d+ +(\S+) +(\S+) +(\S+)$", (folder / "beam.dat").read_text(), re.MULTILINE)
    if done.returncode != 0 or not values:
        raise SystemExit(f"ccx gave no displacement:\n{done.stdout[-2000:]}")
    return nodes, seconds, float(values[-1][2])


def rows_of_calculix(arguments):
    rows = []
    for kind, meshes in MESHES.items():
        row = {"problem": "cantilever", "series": f"CalculiX {kind}, static", "rungs": []}
        for across in meshes[:3] if arguments.quick else meshes:
            with tempfile.TemporaryDirectory() as folder:
                nodes, seconds, tip = solve(across, kind, arguments.threads, pathlib.Path(folder))
            error = abs(tip / REFERENCE - 1)
            print(f"CalculiX {kind} {across}: {nodes} nodes, {seconds:.2f} s, error {100 * error:.3g} %",
                  file=sys.stderr)
            row["rungs"].append({"settings": [f"across={across}"], "particles": nodes, "seconds": [seconds],
                                 "error": error, "values": {"tip_displacement": tip}, "message": ""})
        rows.append(row)
    return rows


def record_of_pliant(arguments):
    with tempfile.TemporaryDirectory() as folder:
        command = [arguments.program, "bench", "--accuracy", "--rows", "cantilever", "--json", "--out", folder,
                   "--ladders", root / "bench/accuracy.toml", "--threads", str(arguments.threads)]
        done = subprocess.run(command + ["--quick"] * arguments.quick, check=True, stdout=subprocess.PIPE)
    return json.loads(done.stdout)


def add_times(rows, more):
    """Adds the wall times of another round."""
    for row, again in zip(rows, more):
        for rung, repeated in zip(row["rungs"], again["rungs"]):
            rung["seconds"] += repeated["seconds"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--save", type=pathlib.Path, required=True)
    parser.add_argument("--program", default=root / "pliant")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--quick", action="store_true", help="coarse meshes only")
    arguments = parser.parse_args()
    record = None
    for _ in range(arguments.rounds):
        rows = rows_of_calculix(arguments)
        found = record_of_pliant(arguments)
        rows += found["rows"]
        if record is None:
            record = {**found, "rows": rows}
        else:
            add_times(record["rows"], rows)
    arguments.save.write_text(json.dumps(record, indent=1) + "\n")


if __name__ == "__main__":
    main()
