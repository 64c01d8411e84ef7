#!/usr/bin/env python3
"""Reruns the figures and tables of Hieber & Koumoutsakos (2008) and writes them beside this file.

    docs/validation/report.py [--program ./pliant] [--quick] [SECTION ...]

Sections: cube, compression, cylinder. `--quick` leaves out the finest sizes. Needs python3-h5py and
python3-matplotlib. README.md and the pictures in this folder are what it writes.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent

# Largest displacements of the paper's particles and of its finite elements, tables 1 and 2.
paper = {
    "linear": ([0.138, 0.192, 0.228, 0.233, 0.235], 0.232),
    "hyperelastic": ([0.143, 0.200, 0.237, 0.250, 0.254], 0.250),
}
compression_cells = [16, 32, 64, 128, 256]
paper_ghosts = ["ghosts.treatment=averaged", "remeshing.every=1", "remeshing.filter=0",
                "discretisation.dissipation=0", "discretisation.weight=quartic_polynomial"]


class Runs:
    def __init__(self, program, folder):
        self.program, self.folder, self.count = program, pathlib.Path(folder), 0

    def __call__(self, case, *settings):
        """Runs a case; its folder, or None when the run failed."""
        self.count += 1
        out = self.folder / str(self.count)
        command = [self.program, "run", root / "cases" / case, "--quiet", "--out", out]
        for setting in settings:
            command += ["--set", setting]
        print(" ".join(map(str, [case, *settings])), flush=True)
        return out if subprocess.run(command, check=False).returncode == 0 else None


def value(out, name):
    if out is None:
        return None
    summary = json.loads((out / "summary.json").read_text())
    return summary["measurements"][name]["value"]


def history(out, name):
    with h5py.File(out / "result.h5") as file:
        group = file["measurements"][name]
        return group["time"][:], group["value"][:]


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def text(number, form="{:.4f}"):
    return "failed" if number is None else form.format(number)


def plot(name, curves, x, y, log=False):
    figure, axis = plt.subplots(figsize=(5, 3.4), layout="constrained")
    for label, (xs, ys), style in curves:
        (axis.loglog if log else axis.plot)(xs, ys, style, label=label)
    axis.set(xlabel=x, ylabel=y)
    axis.legend(fontsize=8)
    figure.savefig(here / name, dpi=80)
    plt.close(figure)


def cube(run, quick):
    """Figure 1: error against 1/h, linear; the paper finds second order."""
    cells = [16, 32] if quick else [16, 32, 64]
    errors = [value(run("periodic_cube", f"discretisation.spacing=1/{n}"), "velocity_error_linf")
              for n in cells]
    plot("cube.png", [("ours", (cells, errors), "o-"),
                      ("second order", (cells, [errors[0] * (cells[0] / n) ** 2 for n in cells]), "k:")],
         "1/h", "L-infinity error over the amplitude", log=True)
    return ("## Periodic cube (section 5, figure 1)\n\n"
            + table(["particles", "error"], [[f"{n}^3", text(e)] for n, e in zip(cells, errors)])
            + "\n![Error against 1/h](cube.png)\n")


def compression(run, quick):
    """Tables 1 and 2: the largest horizontal displacement at t = 0.02."""
    cells = compression_cells[:3] if quick else compression_cells
    part = "## Plane strain compression (section 6, tables 1 and 2)\n\n"
    for kind, (particles, elements) in paper.items():
        rows = []
        for i, n in enumerate(cells):
            size = f"discretisation.spacing=1/{n}"
            averaged = run(f"compression_{kind}", size, *paper_ghosts)
            linear = run(f"compression_{kind}", size)
            rows.append([str(2 * n * n), f"{particles[i]:.3f}",
                         text(value(averaged, "surface_max_displacement"), "{:.3f}"),
                         text(value(linear, "surface_max_displacement")),
                         text(value(linear, "flank_max_displacement"))])
        part += (f"{kind.capitalize()}; the paper's finite elements: {elements:.3f}.\n\n"
                 + table(["particles", "paper", "ours, its ghosts", "ours", "ours, flank"], rows) + "\n")
    return part


def cylinder(run, quick):
    """Figures 12 and 13: angular momentum by size, remeshing and ghosts."""
    name = "angular_momentum_ratio"
    sizes = [800, 3200] if quick else [800, 3200, 12800]
    by_size = [(f"{n} particles",
                history(run("rotating_cylinder", f"discretisation.spacing=sqrt(pi/{n})"), name), "-")
               for n in sizes]
    plot("cylinder_sizes.png", by_size, "t [s]", "L/L0")
    ways = ["1", "10", "never"]
    by_remeshing = [(f"remeshed every {way}" if way != "never" else "never remeshed",
                     history(run("rotating_cylinder", f"remeshing.every={way}"), name), "-")
                    for way in ways]
    plot("cylinder_remeshing.png", by_remeshing, "t [s]", "L/L0")
    treatments = ["averaged", "linear", "rigid"]
    by_ghosts = [(ghosts, history(run("rotating_cylinder", f"ghosts.treatment={ghosts}"), name), "-")
                 for ghosts in treatments]
    plot("cylinder_ghosts.png", by_ghosts, "t [s]", "L/L0")
    rows = [[label, text(values[-1], "{:.5f}")]
            for label, (_, values), _ in by_size + by_remeshing + by_ghosts]
    return ("## Rotating cylinder (section 8, figures 12 and 13)\n\n" + table(["run", "L/L0 at t = 0.5"], rows)
            + "\n![Angular momentum by size](cylinder_sizes.png)"
            + "\n![by remeshing](cylinder_remeshing.png)\n![by ghosts](cylinder_ghosts.png)\n")


def main():
    sections = {"cube": cube, "compression": compression, "cylinder": cylinder}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--program", default=str(root / "pliant"))
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("sections", nargs="*", metavar="SECTION")
    arguments = parser.parse_args()
    unknown = set(arguments.sections) - set(sections)
    if unknown:
        parser.error(f"no section {', '.join(sorted(unknown))}; there are {', '.join(sections)}")
    with tempfile.TemporaryDirectory() as folder:
        run = Runs(arguments.program, folder)
        parts = [sections[name](run, arguments.quick) for name in arguments.sections or sections]
    page = "# The paper's figures and tables, rerun\n\n    docs/validation/report.py\n\n" + "\n".join(parts)
    (here / "README.md").write_text(page)


if __name__ == "__main__":
    main()
