"""Fails when two of the given object files define the same weak function.

Each holds the kernels of one instruction set. A function that two of them define would be kept once,
and perhaps compiled for a processor that this one is not.
"""

import itertools
import subprocess
import sys


def weak_functions(path):
    lines = subprocess.run(["nm", path], check=True, capture_output=True, text=True).stdout
    return {line.split()[-1] for line in lines.splitlines() if " W " in line}


def main(paths):
    functions = {path: weak_functions(path) for path in paths}
    if sum(map(bool, functions.values())) < 2:
        return "nothing to compare: the objects define no weak functions"
    for first, second in itertools.combinations(paths, 2):
        shared = functions[first] & functions[second]
        if shared:
            return "\n".join([f"{first} and {second} both define", *sorted(shared)])
    return None


sys.exit(main(sys.argv[1:]))
