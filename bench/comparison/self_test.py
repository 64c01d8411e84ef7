"""self_test.py BUILD [TIMES]: shows that `pliant bench --against` finds a build that is 5 % slower, and does not
report two equal builds, each 20 times out of 20. Takes some twenty minutes.
"""

import re
import subprocess
import sys
from pathlib import Path

ROW = "rotating_cylinder/compact/0.03963/1"


def compare(program, other):
    """Exit status, and the line of the table."""
    done = subprocess.run([program, "bench", "--against", other, "--rows", ROW, "--threads", "1"],
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return done.returncode, re.sub(" +", " ", done.stdout.strip().splitlines()[1])


def main():
    build, times = Path(sys.argv[1]).resolve(), int((sys.argv[2:] or [20])[0])
    subprocess.run(["ninja", "-C", build, "pliant_program", "pliant_slower"], check=True)
    program, slower = build / "engine/cli/pliant", build / "bench/comparison/pliant_slower"
    right = {"slower": 0, "equal": 0}
    for turn in range(1, times + 1):
        for name, tested, status in (("slower", slower, 1), ("equal", program, 0)):
            found, line = compare(tested, program)
            right[name] += found == status
            print(f"{turn}/{times} {name}: status {found}, {line}", flush=True)
    print(f"5 % slower: found {right['slower']} times of {times}; equal: not reported {right['equal']} times of {times}")
    sys.exit(0 if min(right.values()) == times else 1)


if __name__ == "__main__":
    main()
