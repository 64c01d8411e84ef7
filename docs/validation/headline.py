#!/usr/bin/env python3
"""Asserts the headline figures of pliant and writes their page.

    docs/validation/headline.py [--program ./pliant] [SECTION ...]      runs, asserts, writes headline.md
    docs/validation/headline.py --check SECTION ...                     runs and asserts only

Status 1 when a figure misses its bar. `./pliant test --nightly` runs every section with --check.
"""
import argparse
import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent


@dataclasses.dataclass
class Headline:
    """A figure of a run that must lie within `bar` of `right`, over `right` where that is not 0."""
    measurement: str
    right: float
    bar: float
    asked: float | None = None
    """The bar that is wanted, where the present one is wider."""


@dataclasses.dataclass
class Run:
    case: str
    what: str
    settings: list
    figures: list
    measurements: str = ""
    """Tables [[measurement]] that are added to those of the case."""


def compression(kind, particles, law, right, bar, asked=None):
    cells = {512: 16, 2048: 32, 8192: 64, 32768: 128}[particles]
    settings = [f"discretisation.spacing=1/{cells}", "output.every=0", "output.measure_every=0.01"]
    if law == "logarithmic":
        settings.append("material.block.equation_of_state=logarithmic")
    # The surface is singular at the ends of the pistons: there it may exceed the flank by 3 %.
    return Run(f"compression_{kind}", f"{law}, {particles} particles", settings,
               [Headline("flank_max_displacement", right, bar, asked),
                Headline("surface_max_displacement", right, 0.03)])


def plate(name, settings, amplitude, energy):
    return Run("oscillating_plate", name, [*settings, "output.every=0", "output.measure_every=0.05"],
               [Headline("flexural_period", 5.94, 0.01),
                Headline("amplitude_ratio_per_period", 1, amplitude),
                Headline("total_energy", 1, energy)])


def square(across):
    """A square of 1 m that turns four times; the measurements of the cylinder are those of any body."""
    settings = [f"discretisation.spacing=1/{across}", "time.end=16*pi", "output.every=0",
                "body.cylinder.geometry={ shape = \"box\", lower = [-0.5, -0.5], upper = [0.5, 0.5] }",
                "body.cylinder.material.youngs_modulus=10",
                "body.cylinder.rotation={ centre = [0, 0], angular_velocity = 0.5 }",
                "output.measure_every=5"]
    return Run("rotating_cylinder", f"square, {across} across, four turns", settings,
               [Headline("mass_ratio", 1, 0.01), Headline("angular_momentum_ratio", 1, 0.01)],
               '[[measurement]]\nname = "mass_ratio"\nkind = "mass"\nrelative = true\n')


def liver(cells, bar):
    # The suction is 30 kPa (t/15 s)^2.
    tips = "".join(f'[[measurement]]\nname = "tip_at_{suction}_kPa"\nkind = "value_at_time"\n'
                   f'of = "tip"\ntime = {15 * (suction / 30) ** 0.5}\n' for suction in (10, 20))
    return Run("liver_aspiration", f"{cells} cells high", [f"discretisation.spacing=0.025/{cells}"],
               [Headline("tip_at_10_kPa", 1.6579e-3, bar), Headline("tip_at_20_kPa", 2.1221e-3, bar),
                Headline("tip", 2.3717e-3, bar)], tips)


# References: finite elements, beam theory, laws of conservation, closed forms (cases/*/README.md).
sections = {
    "compression": [compression(kind, particles, law, right, *bars)
                    for kind, law, right in (("linear", "linear", 0.2440),
                                             ("linear", "logarithmic", 0.2326),
                                             ("hyperelastic", "hyperelastic", 0.2508))
                    for particles, *bars in ((512, 0.01), (2048, 0.004), (8192, 0.002),
                                             (32768, 0.002, 0.001))],
    "cylinder": [Run("rotating_cylinder", "812 particles, t = 5 s",
                     ["time.end=5", "output.every=0", "output.measure_every=1"],
                     [Headline("angular_momentum_ratio", 1, 0.002),
                      Headline("energy_ratio", 1, 0.01)])],
    "square": [square(across) for across in (10, 20)],
    "plate": [plate("10 across", [], 0.02, 0.1)],
    "ball": [Run("bouncing_ball", f"8000 particles, {wall}",
                 [f"boundary.wall.friction={wall}", "output.every=0", "output.ghosts=false"],
                 [Headline("largest_force", force, 0.02),
                  Headline("momentum_ratio", -0.987, 0.01)])
             for wall, force in (("frictionless", 1.829), ("no_slip", 1.830))],
    "liver": [liver(16, 0.06), liver(20, 0.04)],
    "cube": [Run("periodic_cube_hyperelastic", "32 in a wavelength", ["output.every=0"],
                 [Headline("velocity_error_linf", 0, 0.001)])],
    "rings": [Run("two_rings", "10 across", ["output.every=0", "output.measure_every=0.004"],
                  [Headline("energy_of_left", 0.975, 0.12, 0.04)])],
}


def values_of(program, run, folder):
    """The measurements of a run; raises where it fails."""
    file = pathlib.Path(folder) / "case.toml"
    file.write_text((root / "cases" / run.case / "case.toml").read_text() + "\n" + run.measurements)
    command = [program, "run", file, "--quiet", "--threads", "1", "--out", pathlib.Path(folder) / "run"]
    for setting in run.settings:
        command += ["--set", setting]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    summary = json.loads((pathlib.Path(folder) / "run" / "summary.json").read_text())
    return {name: one["value"] for name, one in summary["measurements"].items()}


def judge(run, values):
    """A row of the page for each figure, and whether it keeps its bar."""
    rows = []
    for figure in run.figures:
        value = values[figure.measurement]
        if value is None:
            rows.append(([run.case, run.what, figure.measurement, f"{figure.right:g}", "none", "", ""], False))
            continue
        off = (value - figure.right) / (abs(figure.right) or 1)
        kept = abs(off) <= figure.bar
        share = f"{100 * off:+.2f} %" if figure.right else f"{off:.2g}"
        bar = f"{100 * figure.bar:g} %" if figure.right else f"{figure.bar:g}"
        if figure.asked is not None and figure.asked < figure.bar:
            wanted = f"{100 * figure.asked:g} %" if figure.right else f"{figure.asked:g}"
            bar += f" (wanted: {wanted})"
        rows.append(([run.case, run.what, figure.measurement, f"{figure.right:g}", f"{value:.6g}", share,
                      bar if kept else f"**{bar}**"], kept))
    return rows


def commit():
    git = ["git", "-C", str(root)]
    name = subprocess.run([*git, "rev-parse", "--short", "HEAD"], check=False, capture_output=True,
                          text=True).stdout.strip()
    changed = subprocess.run([*git, "status", "--porcelain", "engine", "kernels", "cases"], check=False,
                             capture_output=True, text=True).stdout.strip()
    return (name or "unknown") + (" and changes" if changed else "")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--program", default=str(root / "pliant"))
    parser.add_argument("--check", action="store_true")
    parser.add_argument("sections", nargs="*", metavar="SECTION")
    arguments = parser.parse_args()
    unknown = set(arguments.sections) - set(sections)
    if unknown:
        parser.error(f"no section {', '.join(sorted(unknown))}; there are {', '.join(sections)}")
    store = here / "headline.json"
    known = json.loads(store.read_text()) if store.exists() else {}
    all_kept = True
    for name in arguments.sections or sections:
        found = []
        for run in sections[name]:
            with tempfile.TemporaryDirectory() as folder:
                found += judge(run, values_of(arguments.program, run, folder))
            for row, kept in found[-len(run.figures):]:
                print(("ok      " if kept else "MISSED  ") + "  ".join(row), flush=True)
        all_kept &= all(kept for _, kept in found)
        known[name] = {"commit": commit(), "rows": [row for row, _ in found]}
    if not arguments.check:
        store.write_text(json.dumps(known, indent=1) + "\n")
        write_page(known)
    return 0 if all_kept else 1


def write_page(known):
    lines = ["# Headline figures", "",
             "Written by [headline.py](headline.py), which also asserts them: `./pliant test --nightly` runs the",
             "same code. All settings are the defaults. A bar in bold is missed.", "",
             "| case | run | figure | reference | found | deviation | bar | commit |",
             "|" + " --- |" * 8]
    for name in sections:
        if name in known:
            lines += ["| " + " | ".join([*row, known[name]["commit"]]) + " |" for row in known[name]["rows"]]
    (here / "headline.md").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    sys.exit(main())
