"""Holds the arrows between folders, and between files: what each may include.

    kernels/    the standard library, xsimd and the intrinsics that it lacks
    scheduler/  the standard library, oneTBB, fmt and JSON, and the control register of SSE
    engine/     kernels, scheduler, and any library; inside it, the folders of the table below
    bench/      all of these, and fixtures of tests/
    tests/      all but bench/, which nothing includes

A file and its header are one unit here: no unit may include itself by way of others, neither in
its header nor in its source.
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
# Folders of engine/ from bottom to top, and the other folders that each may include.
DATA = {"case", "geometry", "storage", "lattice", "blocks", "boundaries"}
METHOD = DATA | {"output", "method"}
ENGINE = {
    "storage": set(),
    "blocks": {"storage"},
    "lattice": {"storage", "blocks"},
    "case": {"geometry"},
    "geometry": {"storage", "blocks", "lattice"},
    "boundaries": {"case", "geometry", "lattice"},
    "output": {"storage"},
    "method": DATA | {"output"},
    "remeshed": METHOD,
    "undeformed": METHOD,
    "total_lagrangian": METHOD | {"undeformed"},
    "point_based": METHOD | {"undeformed"},
    "finite_elements": METHOD | {"undeformed", "point_based"},
    "sph": METHOD | {"remeshed"},
    "simulation": METHOD | {"remeshed", "total_lagrangian", "point_based", "finite_elements", "sph"},
    "api": METHOD | {"simulation"},
    "bench": METHOD | {"simulation", "remeshed", "point_based"},  # bytes of stages and of nodes
    "profile": METHOD | {"simulation", "bench"},
    "batch": METHOD | {"simulation"},
    "accuracy": METHOD | {"simulation", "batch", "bench"},
    "calibrate": METHOD | {"simulation", "batch"},
    "report": METHOD | {"batch", "simulation"},
    "cli": METHOD | {"simulation", "bench", "profile", "batch", "accuracy", "calibrate", "report"},
}
# First component of <...>; the standard library needs no entry. Folders not listed may use any.
LIBRARIES = {
    "kernels": {"xsimd", "immintrin.h"},
    "scheduler": {"tbb", "oneapi", "fmt", "nlohmann", "xmmintrin.h"},
}
UNITS = {"kernels", "scheduler", "engine"}
INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def is_standard(header):
    return re.fullmatch(r"[a-z0-9_]+", header) is not None


def subfolder(parts):
    """The folder of engine/ that a path lies in; None for files of engine/ itself."""
    return parts[1] if len(parts) > 2 else None


def problem_inside_engine(own, other):
    """What is wrong with an include of a file in engine/`other` in one of engine/`own`."""
    if own == other or other is None or own is None:
        return None
    if own not in ENGINE:
        return f"engine/{own}/ is not in the table of folders in cmake/checks/include_arrows.py"
    if other not in ENGINE[own]:
        allowed = ", ".join(sorted(ENGINE[own])) or "no other folder"
        return f"of engine/, engine/{own}/ may include {allowed} only"
    return None


def problem(root, path, bracket, header):
    """What is wrong with this include in the file `path`; None when nothing is."""
    folder = path.parts[0]
    parts = header.split("/")
    if bracket == "<":
        allowed = LIBRARIES.get(folder)
        if allowed is None or parts[0] in allowed or is_standard(header):
            return None
        return f"{folder}/ may include <...> of {', '.join(sorted(allowed))} and the standard library only"
    if not any((root / name).is_file() for name in (header, header + ".in")):  # .in: generated
        return "no such file from the repository root; give project headers their full path"
    if parts[0] not in FOLDERS[folder]:
        return f"{folder}/ may include {', '.join(sorted(FOLDERS[folder]))} only"
    if folder == "engine" and parts[0] == "engine":
        return problem_inside_engine(subfolder(path.parts), subfolder(parts))
    return None


def cycles(arrows):
    """The sets of nodes that reach each other, as sorted lists; `arrows` is {node: [node]}."""
    order, reached = [], set()

    def visit(start, follow, found):
        stack = [(start, iter(follow.get(start, ())))]
        reached.add(start)
        while stack:
            node, rest = stack[-1]
            for other in rest:
                if other not in reached:
                    reached.add(other)
                    stack.append((other, iter(follow.get(other, ()))))
                    break
            else:
                found.append(stack.pop()[0])

    for node in sorted(arrows):
        if node not in reached:
            visit(node, arrows, order)
    backwards = {}
    for node, others in arrows.items():
        for other in others:
            backwards.setdefault(other, []).append(node)
    reached.clear()
    sets = []
    for node in reversed(order):
        if node not in reached:
            sets.append([])
            visit(node, backwards, sets[-1])
    return sorted(sorted(nodes) for nodes in sets if len(nodes) > 1)


def check(root):
    units = {}
    for path in tracked.files(root):
        folder = path.parts[0]
        if folder not in FOLDERS or path.suffix not in {".hpp", ".cpp"}:
            continue
        unit = str(path.with_suffix(""))
        for number, line in tracked.lines(root, path):
            if match := INCLUDE.match(line):
                if what := problem(root, path, *match.groups()):
                    yield f"{path}:{number}: {match[2]}: {what}"
                other = re.sub(r"\.[ch]pp$", "", match[2])
                if folder in UNITS and match[1] == '"' and other != unit:
                    units.setdefault(unit, []).append(other)
    for names in cycles(units):
        yield f"{names[0]}: includes itself by way of {', '.join(names[1:])}; take out what they share"


def check_table():
    for names in cycles(ENGINE):
        yield f"the table of folders has a cycle: {', '.join(names)}"


def check_all(root):
    yield from check_table()
    yield from check(root)


if __name__ == "__main__":
    tracked.main(check_all)
