"""No file holds marks of unfinished work, paths of somebody's machine, or old names of types."""

import re

import tracked

# Split, so that this file passes its own check.
MARKS = "|".join(["TO" "DO", "FIX" "ME", "X" "XX", "HA" "CK"])
UNWANTED = [
    (re.compile(rf"\b({MARKS})\b"), "finish it, or open an issue"),
    (re.compile(r"(?<![\w.})])/(work|root|home)/"), "a path of one machine: make it relative"),
    (re.compile(r"\btype" r"def\b"), "write `using`"),
]


def check(root):
    for path in tracked.files(root):
        for number, line in tracked.lines(root, path):
            for pattern, remedy in UNWANTED:
                if match := pattern.search(line):
                    yield f"{path}:{number}: {match[0]}: {remedy}"


if __name__ == "__main__":
    tracked.main(check)
