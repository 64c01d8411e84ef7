"""Fails when object files of two instruction sets define the same weak function.

The folder of an object file names its instruction set. A function that two of them define would be kept
once, and perhaps compiled for a processor that this one is not.
"""

import itertools
import re
import subprocess
import sys


def weak_functions(path):
    lines = subprocess.run(["nm", path], check=True, capture_output=True, text=True).stdout
    return {line.split()[-1] for line in lines.splitlines() if " W " in line}


def instruction_set(path):
    return re.search(r"pliant_kernels_(\w+)", path)[1]


def main(paths):
    functions = {}
    for path in paths:
        functions.setdefault(instruction_set(path), set()).update(weak_functions(path))
    if len(functions) < 2 or not all(functions.values()):
        return "nothing to compare: give objects of several instruction sets that define weak functions"
    for first, second in itertools.combinations(functions, 2):
        shared = functions[first] & functions[second]
        if shared:
            return "\n".join([f"{first} and {second} both define", *sorted(shared)])
    return None


sys.exit(main(sys.argv[1:]))
