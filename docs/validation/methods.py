#!/usr/bin/env python3
"""Runs the cases in the folder methods/ by every method on the undeformed body, and writes methods.md.

    docs/validation/methods.py [--program ./pliant] [--out FOLDER]

A cube of 1 m has a lattice of particles, or a mesh of tetrahedra whose inner nodes are displaced at
random. Takes about two minutes.
"""
import argparse
import itertools
import json
import pathlib
import random
import subprocess

here = pathlib.Path(__file__).resolve().parent
root = here.parents[1]
cases = {"squeezed": "squeezed by 30 %", "stretched": "stretched by 50 %", "twisted": "twisted by 1 rad",
         "indented": "indented by a sphere, 0.24 m deep", "loaded": "under a pressure of 20 Pa"}
quantities = {"force": "force [N]", "moment": "moment [N m]", "displacement": "displacement [m]",
              "strain_energy": "strain energy [J]"}
variants = [("total Lagrangian, h = 0.1 m", "total_lagrangian", 10, False),
            ("total Lagrangian, h = 0.05 m", "total_lagrangian", 20, False),
            ("point-based, h = 0.1 m", "point_based", 10, False),
            ("point-based, irregular, h = 0.1 m", "point_based", 10, True),
            ("finite elements, 6000 tetrahedra", "finite_elements", 10, True),
            ("finite elements, 24 576 tetrahedra", "finite_elements", 16, True)]


def write_mesh(path, cells, displaced=0.2):
    """The cube [-0.5, 0.5]^2 x [0, 1] in Gmsh's format 2.2: six tetrahedra around a diagonal of each of
    `cells`^3 cubes, inner nodes displaced by up to a fifth of their sides."""
    chance = random.Random(1)
    nodes = []
    for k, j, i in itertools.product(range(cells + 1), repeat=3):
        at = [i, j, k]
        x = [a if a in (0, cells) else a + displaced * chance.uniform(-1, 1) for a in at]
        nodes.append((x[0] / cells - 0.5, x[1] / cells - 0.5, x[2] / cells))

    def number(cube, corner):
        i, j, k = (a + b for a, b in zip(cube, corner))
        return 1 + i + (cells + 1) * (j + (cells + 1) * k)

    tetrahedra = []
    for cube in itertools.product(range(cells), repeat=3):
        for order in itertools.permutations(range(3)):
            corner, path_of_corners = [0, 0, 0], [number(cube, (0, 0, 0))]
            for axis in order:
                corner[axis] = 1
                path_of_corners.append(number(cube, corner))
            if order not in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
                path_of_corners[2:] = reversed(path_of_corners[2:])
            tetrahedra.append(path_of_corners)
    with open(path, "w") as file:
        file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(nodes)}\n")
        for n, x in enumerate(nodes, 1):
            file.write(f"{n} {x[0]:.12g} {x[1]:.12g} {x[2]:.12g}\n")
        file.write(f"$EndNodes\n$Elements\n{len(tetrahedra)}\n")
        for n, corners in enumerate(tetrahedra, 1):
            file.write(f"{n} 4 2 1 1 {' '.join(map(str, corners))}\n")
        file.write("$EndElements\n")


def run(program, case, method, cells, meshed, folder):
    """The final values of the measurements of a run."""
    settings = [f"method={method}", f"discretisation.spacing=1/{cells}", "output.every=0"]
    if meshed:
        mesh = folder.parent / f"cube{cells}.msh"
        if not mesh.exists():
            write_mesh(mesh, cells)
        settings.append(f'body.block.geometry={{ shape = "mesh", file = "{mesh}" }}')
    command = [program, "run", here / "methods" / f"{case}.toml", "--out", folder, "--quiet"]
    for setting in settings:
        command += ["--set", setting]
    subprocess.run(command, check=True)
    values = json.loads((folder / "summary.json").read_text())["measurements"]
    return {name: values[name]["value"] for name in quantities if name in values}


def page(results):
    text = """# The same loads by three methods

    docs/validation/methods.py

A cube of 1 m (shear modulus 38.46 Pa, bulk modulus 83.33 Pa, `reduced_polynomial`), whose bottom is held, is loaded within
1.5 s and kept so until t = 2 s, with a damping of 3 1/s. The cases are in the folder [methods](methods/). The methods share the
material law and the walls, but not the nodes, their neighbours, the gradients or the quadrature, so that none of these explains
what they agree on. The last line of each table is the largest difference between two of its values, over the mean. The remeshed
method is made for fast motion; [decision 62](../decisions/0062-slow-loads-of-remeshed-bodies.md) compares it.
"""
    for case, title in cases.items():
        names = list(results[case][0])
        text += f"\n## [{title[0].upper()}{title[1:]}](methods/{case}.toml)\n\n"
        text += f"| method | {' | '.join(quantities[name] for name in names)} |\n"
        text += f"| --- |{' --- |' * len(names)}\n"
        for (label, *_), values in zip(variants, results[case]):
            text += f"| {label} | {' | '.join(f'{values[name]:.4g}' for name in names)} |\n"
        spreads = []
        for name in names:
            column = [values[name] for values in results[case]]
            spreads.append(f"{100 * (max(column) - min(column)) / abs(sum(column) / len(column)):.1f} %")
        text += f"| difference | {' | '.join(spreads)} |\n"
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=pathlib.Path, default=root / "pliant")
    parser.add_argument("--out", type=pathlib.Path, default=root / "results" / "methods")
    options = parser.parse_args()
    out = options.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    results = {}
    for case in cases:
        results[case] = [run(options.program.resolve(), case, method, cells, meshed, out / f"{case}{i}")
                         for i, (_, method, cells, meshed) in enumerate(variants)]
    (here / "methods.md").write_text(page(results))


if __name__ == "__main__":
    main()
