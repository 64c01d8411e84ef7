#!/usr/bin/env python3
"""Reruns the figures and tables of Hieber & Koumoutsakos (2008) and writes their pages beside this file.

    docs/validation/report.py [--program ./pliant] [--quick | --largest] [SECTION ...]

Each section is a page of its own, which README.md lists; without a name all are rerun. `--quick` leaves
out the finest sizes, `--largest` adds the 131 072 particles of tables 1 and 2 (an hour). Needs python3-h5py and python3-matplotlib.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent
sys.path.insert(0, str(here.parent))
import dispersion  # noqa: E402 (beside this file)
import plot_frames  # noqa: E402 (found beside this folder)

# Largest displacements in tables 1 and 2 of the paper, by its particles and finite elements.
paper = {
    "linear": ([0.138, 0.192, 0.228, 0.233, 0.235], 0.232),
    "hyperelastic": ([0.143, 0.200, 0.237, 0.250, 0.254], 0.250),
}
# Largest displacement of the flank from our converged finite elements, docs/validation.md.
converged = {"linear": 0.2440, "hyperelastic": 0.2508}
compression_cells = [16, 32, 64, 128, 256]
# docs/paper-scheme.md, with the time step of each case.
paper_scheme = ["discretisation.kernel=quartic_spline", "discretisation.dissipation=0",
                "remeshing.every=1", "remeshing.volume=conserved", "ghosts.treatment=averaged",
                "remeshed.gradient=normalised", "remeshed.reinitialisation=first_order",
                "remeshed.determinant=remeshed", "remeshed.free_motion=remeshed"]
paper_compression = [*paper_scheme, "time.step=5e-5"]
paper_cylinder = [*paper_scheme, "time.step=1e-3", "output.every=0", "output.measure_every=0.001"]


class Runs:
    def __init__(self, program, folder, largest=False):
        self.program, self.folder, self.count = program, pathlib.Path(folder), 0
        self.largest = largest

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


def orders(values):
    """Those of the paper's tables: log2 of the ratios of the errors against the finest value."""
    known = [v for v in values if v is not None]
    errors = [None if v is None else abs(v - known[-1]) for v in values]
    pairs = zip(errors, errors[1:])
    found = [f"{np.log2(a / b):.2f}" if a and b else "" for a, b in pairs]
    return [""] + found if len(values) > 1 else [""]


def write_csv(name, head, rows):
    with (here / name).open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([head, *rows])


def draw(axis, curves, x, y, log=False):
    for label, (xs, ys), style in curves:
        (axis.loglog if log else axis.plot)(xs, ys, style, label=label)
    axis.set(xlabel=x, ylabel=y)


def plot(name, curves, x, y, log=False):
    many = len(curves) > 5
    figure, axis = plt.subplots(figsize=(7.4 if many else 5, 3.4), layout="constrained")
    draw(axis, curves, x, y, log)
    axis.legend(fontsize=8, **({"loc": "upper left", "bbox_to_anchor": (1.02, 1)} if many else {}))
    figure.savefig(here / name, dpi=80)
    plt.close(figure)


def panel(out, time, field, title, across="z"):
    """One frame of a run, the one nearest to a time: title, points in the plane, values."""
    with h5py.File(out / "result.h5") as file:
        times = file["VTKHDF/Steps/Values"][:]
        frame = plot_frames.frame(file, int(np.argmin(np.abs(times - time))), field)
    _, points, values = plot_frames.middle_layer(*frame, "xyz".index(across))
    return title, points, values


def pictures(name, panels, label, columns=4, limits=None):
    """Particles of some frames side by side, over one scale of colours."""
    lowest = min(values.min() for *_, values in panels) if limits is None else limits[0]
    highest = max(values.max() for *_, values in panels) if limits is None else limits[1]
    rows = -(-len(panels) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(2.6 * columns, 2.4 * rows), squeeze=False,
                                layout="constrained")
    for axis in axes.flat[len(panels):]:
        axis.remove()
    for axis, (title, points, values) in zip(axes.flat, panels):
        extent = points.max(axis=0) - points.min(axis=0)
        dot = 120 * np.sqrt(extent[0] * extent[1] / len(points)) / max(extent)
        drawn = axis.scatter(*points.T, c=values, s=0.7 * dot**2, cmap="viridis", vmin=lowest,
                             vmax=highest, linewidths=0)
        axis.set_title(title, fontsize=8)
        axis.set_aspect("equal")
        axis.tick_params(labelsize=6)
    figure.colorbar(drawn, ax=axes, label=label, shrink=0.8)
    figure.savefig(here / name, dpi=80)
    plt.close(figure)


def cube(run, quick):
    """Figure 1: error against 1/h in the periodic cube."""
    cells = [16, 32] if quick else [16, 32, 64]
    kinds = {"linear": ("periodic_cube", 0.049761, 0.093095),
             "hyperelastic": ("periodic_cube_hyperelastic", 0.107833, 0.129099)}
    curves, rows = [], []
    for kernel in dispersion.kernels:
        columns = []
        for kind, (case, p_period, s_period) in kinds.items():
            measured = [value(run(case, f"discretisation.spacing=1/{n}",
                                  f"discretisation.kernel={kernel}"), "velocity_error_linf")
                        for n in cells]
            orders = [""] + [f"{order:.2f}" for order in np.log2(measured[:-1] / np.array(measured[1:]))]
            alone = [dispersion.cube_error(kernel, n, p_period, s_period) for n in cells]
            columns += [[f"{e:.5f}" for e in measured], orders, [f"{e:.5f}" for e in alone]]
            curves.append((f"{kind}, {kernel}", (cells, measured), "o-" if kind == "linear" else "s--"))
        rows += [[kernel, f"{n}^3", *row] for n, row in zip(cells, zip(*columns))]
    second = [curves[0][1][1][0] * (cells[0] / n) ** 2 for n in cells]
    plot("cube.png", curves + [("second order", (cells, second), "k:")], "1/h",
         "L-infinity error over the amplitude", log=True)
    return ("## Periodic cube (section 5, figure 1)\n\n"
            + table(["kernel", "particles", "linear", "order", "gradient alone", "hyperelastic", "order",
                     "gradient alone"], rows)
            + "\n\"Gradient alone\" is what the dispersion of (RP.20) makes of the waves when all else is exact "
            "([dispersion.py](dispersion.py)): with the first two kernels hardly anything else contributes. Where "
            "this error is large it is no longer proportional to that of the wave speed, so that the orders "
            "between coarse sizes lie on either side of two. With fourth_order the dissipation (RP.23), of third "
            "order, is what is left.\n\n![Error against 1/h](cube.png)\n")


def compression_rows(run, kind, cells):
    """Largest displacements of the surface and of the flank, and the mass, by scheme and size."""
    names = ["surface_max_displacement", "flank_max_displacement", "mass_ratio"]
    found = {}
    for scheme, settings in (("paper", paper_compression), ("default", [])):
        for n in cells:
            out = run(f"compression_{kind}", f"discretisation.spacing=1/{n}", "output.every=0",
                      "output.measure_every=0.001", *settings)
            found[scheme, n] = [value(out, name) for name in names]
    return found


def compression(run, quick):
    """Tables 1 and 2: the largest horizontal displacement under compression."""
    cells = compression_cells[:3 if quick else 5 if run.largest else 4]
    part, lines, curves = compression_head, [], []
    for number, (kind, (printed, elements)) in enumerate(paper.items(), 1):
        found = compression_rows(run, kind, cells)
        schemes = {scheme: [found[scheme, n][0] for n in cells] for scheme in ("paper", "default")}
        flank = [found["default", n][1] for n in cells]
        columns = [[str(2 * n * n) for n in cells],
                   [f"{p:.3f}" for p in printed[:len(cells)]], orders(printed)[:len(cells)],
                   [text(v, "{:.3f}") for v in schemes["paper"]], orders(schemes["paper"]),
                   [text(found["paper", n][2], "{:.3f}") for n in cells],
                   [text(v) for v in schemes["default"]], [text(v) for v in flank],
                   [f"{100 * (v / converged[kind] - 1):+.2f} %" for v in flank]]
        part += (f"## Table {number}: {kind}\n\nThe paper's finite elements: {elements:.3f}. "
                 + compression_references[kind] + "\n\n"
                 + table(["particles", "paper", "order", "its scheme here", "order", "mass",
                          "default", "default, flank", "error"], list(zip(*columns))) + "\n")
        lines += [[kind, scheme, 2 * n * n, *found[scheme, n]] for scheme, n in found]
        style = "-" if kind == "linear" else "--"
        counts = [2 * n * n for n in cells]
        curves += [(f"{kind}, paper", (counts, printed[:len(cells)]), "ks" + style),
                   (f"{kind}, its scheme here", (counts, schemes["paper"]), "C0o" + style),
                   (f"{kind}, default", (counts, flank), "C1^" + style)]
    write_csv("compression.csv", ["material", "scheme", "particles", "surface_m", "flank_m",
                                  "mass_ratio"], lines)
    plot("compression.png", [(label, (np.log2(x), y), style) for label, (x, y), style in curves
                             if None not in y], "log2 of the number of particles",
         "largest displacement [m]")
    return part + "![Largest displacement by size](compression.png)\n"


compression_head = (
    "## Plane strain compression (section 6, tables 1 and 2)\n\nThe largest horizontal displacement "
    "of the surface at t = 0.02 s. *Its scheme here* is [the paper's own scheme](../paper-scheme.md) "
    "with its time step of 5e-5 s; *mass* is the mass at the end over that at the start with it. *Flank* "
    "leaves the singular corners out. Orders are those of the paper's tables: log2 of the ratio of "
    "the differences from the value of the finest size. *Error* is that of the flank by default.\n\n")
compression_references = {
    "linear": ("They integrate dp = -K tr(eps) dt, the *logarithmic* equation of state; the particles "
               "have the *linear* one, for which [independent finite elements](../validation.md) give "
               "0.2440 on the flank (logarithmic: 0.2326). The 0.232 is thus no reference for either "
               "column of ours."),
    "hyperelastic": "[Independent finite elements](../validation.md): 0.2508 on the flank.",
}


def cylinder_runs(run, sizes):
    """Histories of the angular momentum, by figure and label."""
    name = "angular_momentum_ratio"

    def of(*settings):
        out = run("rotating_cylinder", *settings)
        return (np.array([]), np.array([])) if out is None else history(out, name)

    dense = ["output.every=0", "output.measure_every=0.001"]
    runs = {}
    for n in sizes:
        size = f"discretisation.spacing=sqrt(pi/{n})"
        runs["12", "paper", str(n)] = of(size, *paper_cylinder)
        runs["12", "default", str(n)] = of(size, *dense)
    for way in ("1", "10", "never"):
        often = f"remeshing.every={way}"
        runs["13 left", "paper", way] = of(*paper_cylinder, often)
        runs["13 left", "default", way] = of(*dense, "time.step=1e-3", often)
    for ghosts in ("averaged", "linear", "rigid"):
        short = [f"ghosts.treatment={ghosts}", "time.end=0.05"]
        runs["13 right", "paper", ghosts] = of(*paper_cylinder, *short)
        runs["13 right", "default", ghosts] = of(*dense, "time.step=1e-3", *short)
    return runs


def cylinder(run, quick):
    """Figures 12 and 13: angular momentum by size, remeshing and ghosts."""
    runs = cylinder_runs(run, [800, 3200] if quick else [800, 3200, 12800])
    write_csv("cylinder.csv", ["figure", "scheme", "run", "time_s", "L_over_L0"],
              [[*key, f"{t:.4g}", f"{ratio:.7f}"] for key, (times, ratios) in runs.items()
               for t, ratio in zip(times, ratios)])
    what = {"12": "{} particles", "13 left": "remeshed every {}", "13 right": "{} ghosts"}
    for figure, name in (("12", "sizes"), ("13 left", "remeshing"), ("13 right", "ghosts")):
        drawn = [(what[of].format(label).replace("every never", "never") + f", {scheme}", curve,
                  "-" if scheme == "paper" else "--")
                 for (of, scheme, label), curve in runs.items() if of == figure]
        plot_twice(f"cylinder_{name}.png", drawn, "t [s]", "L/L0")
    rows = [[figure, what[figure].format(label).replace("every never", "never"), scheme,
             text(None if len(times) == 0 else times[-1], "{:g}"),
             text(None if len(times) == 0 else ratios[-1], "{:.5f}")]
            for (figure, scheme, label), (times, ratios) in runs.items()]
    return (cylinder_head + table(["figure", "run", "scheme", "t [s]", "L/L0"], rows)
            + "\n### Figure 12\n\n![Angular momentum by size](cylinder_sizes.png)\n"
            "\n### Figure 13, left\n\n![by remeshing](cylinder_remeshing.png)\n"
            "\n### Figure 13, right\n\n![by ghosts](cylinder_ghosts.png)\n")


def plot_twice(name, curves, x, y):
    """All curves, and those that stay near 1 once more beside them, closer."""
    figure, axes = plt.subplots(1, 2, figsize=(9.4, 3.6), layout="constrained")
    curves = [curve for curve in curves if len(curve[1][0]) > 0]
    draw(axes[0], curves, x, y)
    near = [abs(ys - 1).max() < 0.01 for _, (_, ys), _ in curves]
    for (label, (xs, ys), style), close, line in zip(curves, near, axes[0].lines):
        if close:
            axes[1].plot(xs, ys, style, color=line.get_color())
    axes[1].set(xlabel=x, ylabel=y)
    axes[1].ticklabel_format(useOffset=False)
    axes[1].legend(axes[0].lines, [line.get_label() for line in axes[0].lines], fontsize=8,
                   loc="upper left", bbox_to_anchor=(1.02, 1))
    figure.savefig(here / name, dpi=80)
    plt.close(figure)


cylinder_head = (
    "## Rotating cylinder (section 8, figures 12 and 13)\n\nAngular momentum over its start. *paper* "
    "is [the paper's own scheme](../paper-scheme.md) with its time step of 1e-3 s, *default* the "
    "default settings, in figure 13 with the same step. Figure 13, right, ends at t = 0.05 s as in the "
    "paper. The steps in the curves of the paper's scheme are its reinitialisations, one in 20 time "
    "steps. Without remeshing, its averaged ghosts do not stay around the body, and the run fails. "
    "The pictures show the curves that stay near 1 once more, on the right.\n\n")


def compression_pictures(run, quick):
    """Figures 3 to 5: pressure under compression."""
    sizes = [16, 32] if quick else [16, 32, 64]
    frames = ["time.end=0.03", "output.every=0.0025"]
    part = "## Pressure under compression (section 6, figures 3 to 5)\n\n"
    linear = {n: run("compression_linear", f"discretisation.spacing=1/{n}", *frames) for n in sizes}
    pictures("compression_linear_times.png",
             [panel(linear[32], t, "pressure", f"t = {t} s") for t in (0, 0.02, 0.025, 0.03)],
             "p [Pa]")
    pictures("compression_linear_sizes.png",
             [panel(linear[n], 0.03, "pressure", f"{2 * n * n} particles") for n in sizes], "p [Pa]",
             columns=len(sizes))
    pictures("compression_hyperelastic_sizes.png",
             [panel(run("compression_hyperelastic", f"discretisation.spacing=1/{n}", *frames), 0.025,
                    "pressure", f"{2 * n * n} particles") for n in sizes], "p [Pa]",
             columns=len(sizes))
    return (part + "Linear, 2048 particles.\n\n![Figure 3](compression_linear_times.png)\n\n"
            "Linear, t = 0.03 s.\n\n![Figure 4](compression_linear_sizes.png)\n\n"
            "Hyperelastic, t = 0.025 s.\n\n![Figure 5](compression_hyperelastic_sizes.png)\n")


def cylinder_pictures(run, quick):
    """Figures 10 and 11: pressure in the rotating cylinder."""
    sizes = [800, 3200] if quick else [800, 3200, 12800]
    runs = {n: run("rotating_cylinder", f"discretisation.spacing=sqrt(pi/{n})", "output.every=0.05")
            for n in sizes}
    times = [0.05 * i for i in range(12)]
    longer = run("rotating_cylinder", "discretisation.spacing=sqrt(pi/3200)", "output.every=0.05",
                 "time.end=0.55")
    pictures("cylinder_times.png",
             [panel(longer, t, "pressure", f"t = {t:.2f} s") for t in times], "p [Pa]")
    pictures("cylinder_pressure_sizes.png",
             [panel(runs[n], 0.5, "pressure", f"{n} particles") for n in sizes], "p [Pa]",
             columns=len(sizes))
    return ("## Pressure in the rotating cylinder (section 8, figures 10 and 11)\n\n3200 particles.\n\n"
            "![Figure 10](cylinder_times.png)\n\nt = 0.5 s.\n\n"
            "![Figure 11](cylinder_pressure_sizes.png)\n")


def aspiration(run, quick):
    """Figures 8 and 9: dilatation and tip of the aspirated liver."""
    with (root / "cases/liver_aspiration/reference.csv").open() as file:
        static = [(float(row["suction_kPa"]), float(row["tip_mm"])) for row in csv.DictReader(file)]
    suction, tip = np.array(static).T
    layers = [20] if quick else [20, 28]
    runs = {n: run("liver_aspiration", f"discretisation.spacing=0.025/{n}",
                   "output.every=5") for n in layers}
    wanted = [1, 2, 5, 10, 15, 20, 25, 30]
    curves, rows = [("finite elements", (15 * np.sqrt(suction / 30), tip), "k:")], []
    for n, out in runs.items():
        times, heights = history(out, "tip")
        _, particles = history(out, "tip_particle")
        _, ratio = history(out, "energy_ratio")
        summary = json.loads((out / "summary.json").read_text())
        count = summary["particles"]["start"]
        curves.append((f"{count} particles", (times, 1e3 * heights), "-"))
        for p in wanted:
            i = int(np.argmin(np.abs(30 * (times / 15) ** 2 - p)))
            at = 30 * (times[i] / 15) ** 2
            exact = np.interp(at, suction, tip)
            rows.append([str(count), f"{at:.2f}", f"{1e3 * heights[i]:.4f}",
                         f"{1e3 * particles[i]:.4f}", f"{exact:.4f}",
                         f"{100 * (1e3 * heights[i] / exact - 1):+.1f} %", f"{ratio[i]:.4f}"])
    plot("aspiration_tip.png", curves, "t [s]", "tip [mm]")
    finest = runs[layers[-1]]
    title, points, dilatation = panel(finest, 15, "dilatation", "t = 15 s", across="y")
    pictures("aspiration_dilatation.png", [(title, points, 100 * dilatation)], "dilatation [%]",
             columns=1, limits=np.percentile(100 * dilatation, [1, 99]))
    return ("## Liver aspiration (section 7, figures 8 and 9)\n\nSuction 30 kPa (t/15 s)^2.\n\n"
            + table(["particles", "suction [kPa]", "tip of the surface [mm]", "of the particle [mm]",
                     "finite elements [mm]", "difference", "kinetic over strain energy"], rows)
            + "\n![Displacement of the tip](aspiration_tip.png)\n\nThe middle plane at 30 kPa: at the true "
            "compressibility the tissue changes its volume by parts in ten thousand (the paper's "
            "isolines go to -4 %).\n\n![Dilatation](aspiration_dilatation.png)\n")


def ball(run, quick):
    """Figures 14 and 15: the bouncing ball and the pressure on its wall."""
    sizes = [0.036] if quick else [0.036, 0.0225]
    rows = []
    for spacing in sizes:
        for friction in ("frictionless", "no_slip"):
            out = run("bouncing_ball", f"discretisation.spacing={spacing}",
                      f"boundary.wall.friction={friction}", "output.every=0.01", "output.ghosts=true")
            summary = json.loads((out / "summary.json").read_text())
            m = {name: one["value"] for name, one in summary["measurements"].items()}
            _, energy = history(out, "energy_ratio")
            rows.append([str(summary["particles"]["start"]), friction, text(m["largest_force"]),
                         text(m["separation_time"]), text(-m["momentum_ratio"]),
                         text(float(np.max(energy))), text(float(energy[-1]))])
            if friction == "no_slip":
                chosen = out
    rows.append(["reference", "frictionless", "1.829", "0.185", "0.987", "1", ""])
    rows.append(["reference", "no_slip", "1.830", "0.183", "0.987", "1", ""])
    draw = [sys.executable, here.parent / "plot_frames.py", chosen]
    for name, *options in (["ball_speed.png", "--field", "velocity", "--times", "0", "0.03", "0.07",
                            "0.14", "0.21", "0.25"],
                           ["ball_wall_pressure.png", "--field", "wall_pressure", "--times", "0.03",
                            "0.07", "0.14", "--levels", "2", "4", "6", "8"]):
        subprocess.run(draw[:2] + [chosen, here / name] + options, check=True)
    return ("## Bouncing ball (section 9, figures 14 and 15)\n\n"
            + table(["particles", "wall", "largest force [N]", "separation [s]", "restitution",
                     "largest energy", "energy at the end"], rows)
            + "\nSpeed, no-slip.\n\n![Figure 14](ball_speed.png)\n\nPressure on the wall, no-slip; "
            "isolines 2, 4, 6, 8 Pa.\n\n![Figure 15](ball_wall_pressure.png)\n")


def main():
    sections = {"cube": cube, "compression": compression, "compression_pictures": compression_pictures,
                "aspiration": aspiration, "cylinder": cylinder,
                "cylinder_pictures": cylinder_pictures, "ball": ball}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--program", default=str(root / "pliant"))
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--largest", action="store_true")
    parser.add_argument("sections", nargs="*", metavar="SECTION")
    arguments = parser.parse_args()
    unknown = set(arguments.sections) - set(sections)
    if unknown:
        parser.error(f"no section {', '.join(sorted(unknown))}; there are {', '.join(sections)}")
    for name in arguments.sections or sections:
        with tempfile.TemporaryDirectory() as folder:
            page = sections[name](Runs(arguments.program, folder, arguments.largest), arguments.quick)
        (here / f"{name}.md").write_text(page[1:])


if __name__ == "__main__":
    main()
