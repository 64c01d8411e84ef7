"""Holds the arrows between folders: what each may include.

    kernels/    the standard library, xsimd and the intrinsics that it lacks
    scheduler/  the standard library, oneTBB, fmt and JSON
    engine/     kernels, scheduler, and any library
    bench/      all of these, and fixtures of tests/
    tests/      all but bench/, which nothing includes
"""

import re

import tracked

FOLDERS = {
    "kernels": {"kernels"},
    "scheduler": {"scheduler"},
    "engine": {"kernels", "scheduler", "engine"},
    "bench": {"kernels", "scheduler", "engine", "tests", "bench"},
    "tests": {"kernels", "scheduler", "engine", "tests"},
}
# First component of <...>; the standard library needs no entry. Folders not named may use any.
LIBRARIES = {
    "kernels": {"xsimd", "immintrin.h"},
    "scheduler": {"tbb", "oneapi", "fmt", "nlohmann"},
}
INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def is_standard(header):
    return re.fullmatch(r"[a-z0-9_]+", header) is not None


def problem(root, folder, bracket, header):
    """What is wrong with this include in a file of `folder`; None when nothing is."""
    first = header.split("/")[0]
    if bracket == "<":
        allowed = LIBRARIES.get(folder)
        if allowed is None or first in allowed or is_standard(header):
            return None
        return f"{folder}/ may include <...> of {', '.join(sorted(allowed))} and the standard library only"
    if not any((root / name).is_file() for name in (header, header + ".in")):  # .in: generated
        return "no such file from the repository root; give project headers their full path"
    if first not in FOLDERS[folder]:
        return f"{folder}/ may include {', '.join(sorted(FOLDERS[folder]))} only"
    return None


def check(root):
    for path in tracked.files(root):
        folder = path.parts[0]
        if folder not in FOLDERS or path.suffix not in {".hpp", ".cpp"}:
            continue
        for number, line in tracked.lines(root, path):
            if match := INCLUDE.match(line):
                if what := problem(root, folder, *match.groups()):
                    yield f"{path}:{number}: {match[2]}: {what}"


if __name__ == "__main__":
    tracked.main(check)
