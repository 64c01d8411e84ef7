#!/usr/bin/env python3
"""Runs the cases of the documentation and draws their pictures again.

    docs/pictures.py [--program ./pliant] [--results results/pictures] [NAME ...]

NAME is a picture without its ending, or the beginning of one, as in `cases/organ` or `boundaries`.
Without a name all are drawn, which takes about half an hour on two cores. Runs that are in the
results folder already are not repeated. Pictures come from the view of reports (docs/picture.py), which
needs the packages of the section `browser` of cmake/debian-packages.txt.
"""
import argparse
import pathlib
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
root = here.parent
mm = ["--scale", "1000", "--label", "displacement [mm]"]

# The plate of cases/edge_cut under 300 times its load, so that the opening shows.
strong_pull = ["boundary.top.traction=[0, '0.03*min(max(t - 2, 0)/20, 1)']",
               "boundary.bottom.traction=[0, '-0.03*min(max(t - 2, 0)/20, 1)']"]

# The picture: its case, its settings, and how it is rendered.
rendered = {
    "cases/liver_aspiration/result": (
        "cases/liver_aspiration", ["discretisation.spacing=0.025/28", "time.step=8e-4", "output.every=5"],
        ["--cut", "y", "--walls", "--view", "-65", "35", "--times", "0", "15",
         "--zoom", "1.05", "--size", "1500", "760", *mm]),
    "cases/bouncing_ball/result": (
        "cases/bouncing_ball", [],
        ["--cut", "x", "--walls", "--up", "y", "--view", "-50", "20", 
         "--field", "pressure", "--label", "pressure [Pa]", "--times", "0.02", "0.08", "0.2",
         "--zoom", "1.3", "--size", "1500", "540"]),
    "cases/ball_on_block/result": (
        "cases/ball_on_block", ["discretisation.spacing=0.05"],
        ["--cut", "z", "--up", "y", "--view", "28", "20", "--field", "velocity_y",
         "--label", "upward velocity [m/s]", "--times", "0", "0.16", "0.5", "--zoom", "1.5", "--size", "1500", "560"]),
    "cases/block_cut/result": (
        "cases/block_cut", [],
        ["--times", "0.08", "0.14", "0.24", "--view", "-70", "45", "--zoom", "1.2",
         "--size", "1500", "500", *mm]),
    "cases/cantilever/result": (
        "cases/cantilever", [],
        ["--times", "80", "--view", "-60", "20", "--zoom", "2", "--size", "900", "500", *mm]),
    "cases/indentation/result": (
        "cases/indentation", [],
        ["--times", "0.15", "--view", "-120", "35", "--zoom", "1.2", "--size", "900", "600", *mm]),
    "cases/bimaterial_bar/result": (
        "cases/bimaterial_bar", [],
        ["--stack", "--times", "0", "0.024", "0.044", "0.0646", "--field", "pressure", "--size", "1100", "420"]),
    "cases/compression_hyperelastic/result": (
        "cases/compression_hyperelastic", ["time.end=0.03"],
        ["--walls", "--times", "0", "0.01", "0.02", "0.03", "--field", "pressure", "--size", "1500", "480"]),
    "cases/compression_linear/result": (
        "cases/compression_linear", ["time.end=0.03"],
        ["--walls", "--times", "0", "0.01", "0.02", "0.03", "--field", "pressure", "--size", "1500", "480"]),
    "cases/edge_cut/result": (
        "cases/edge_cut", [*strong_pull, "time.end=50"],
        ["--times", "50", "--field", "pressure", "--size", "700", "640"]),
    "cases/edge_cut/stretched": (
        "cases/edge_cut", [*strong_pull, "time.end=60", "output.every=10", "cut.0.start=30", "cut.0.end=60",
                           "cut.0.path=['0.55*(t - 30)/30', 0]"],
        ["--times", "30", "40", "50", "60", "--field", "pressure", "--size", "1500", "640"]),
    "cases/oscillating_plate/result": (
        "cases/oscillating_plate", ["time.end=6"],
        ["--walls", "--stack", "--times", "0", "2", "4", "6", "--field", "velocity", "--label", "speed [m/s]",
         "--size", "900", "760"]),
    "cases/swinging_beam/result": (
        "cases/swinging_beam", ["time.end=0.5", "output.every=0.05"],
        ["--walls", "--times", "0", "0.15", "0.25", "0.45", "--field", "displacement", "--size", "1500", "420"]),
    **{f"cases/{case}/result": (
        f"cases/{case}", [],
        ["--cut", "y", "--place", "0.25", "--times", *times, "--field", "velocity_x", "--scale", "1000",
         "--label", "velocity along x [mm/s]", "--zoom", "1.1", "--size", "1500", "440"])
       for case, times in {"periodic_cube": ["0", "0.03", "0.06", "0.0931"],
                           "periodic_cube_hyperelastic": ["0", "0.04", "0.09", "0.1291"]}.items()},
    "cases/periodic_square/result": (
        "cases/periodic_square", [],
        ["--times", "0", "0.038", "0.078", "0.114", "--field", "pressure", "--size", "1500", "440"]),
    "cases/rotating_cylinder/result": (
        "cases/rotating_cylinder", [],
        ["--times", "0", "0.17", "0.33", "0.5", "--field", "pressure", "--size", "1500", "440"]),
    "cases/tensile_instability/result": (
        "cases/tensile_instability", ["output.surface=false"],
        ["--particles", "--times", "0", "0.15", "0.35", "0.5", "--field", "pressure", "--size", "1500", "440"]),
    "cases/tensile_instability/artificial_stress": (
        "cases/tensile_instability", ["output.surface=false", "sph.artificial_stress=0.3"],
        ["--particles", "--times", "0", "0.15", "0.35", "0.5", "--field", "pressure", "--size", "1500", "440"]),
    "cases/two_discs/result": (
        "cases/two_discs", [],
        ["--times", "0", "0.2", "0.4", "0.6", "--field", "pressure", "--size", "1500", "400"]),
    "cases/two_rings/result": (
        "cases/two_rings", [],
        ["--times", "0", "0.004", "0.008", "0.012", "--field", "pressure", "--size", "1500", "440"]),
    "cases/two_spheres/result": (
        "cases/two_spheres", [],
        ["--times", "0.1", "0.3", "0.6", "--up", "z", "--view", "-90", "0", "--field", "pressure",
         "--label", "pressure [Pa]", "--zoom", "1.4", "--size", "1500", "480"]),
    "cases/organ/result": (
        "cases/organ", [],
        ["--field", "velocity", "--label", "speed [m/s]", "--times", "0", "0.08", "0.16", "--zoom", "1.4",
         "--size", "1500", "480"]),
    "cases/organ_cut/result": (
        "cases/organ_cut", [],
        ["--times", "0.45", "1.2", "--view", "-70", "-15", "--zoom", "1.8", "--size", "1500", "600", *mm]),
    "docs/tutorial/jelly": (
        "docs/tutorial", [],
        ["--cut", "y", "--walls", "--field", "velocity_z", "--label", "upward velocity [m/s]",
         "--times", "0", "0.015", "0.06", "--zoom", "1.5", "--size", "1500", "600"]),
    "docs/tutorial/hollow": (
        "docs/tutorial",
        ["body.ball.geometry={ shape = 'difference', of = ["
         "{ shape = 'ball', centre = [0, 0, 0.031], radius = 0.03 }, "
         "{ shape = 'ball', centre = [0, 0, 0.031], radius = 0.016 }] }"],
        ["--cut", "y", "--walls", "--field", "velocity_z", "--label", "upward velocity [m/s]",
         "--times", "0", "0.015", "0.06", "--zoom", "1.5", "--size", "1500", "600"]),
    "docs/tutorial/organ": (
        "docs/tutorial/organ.toml", [],
        ["--times", "0", "0.4", "0.8", "--view", "-70", "-15", "--size", "1500", "500", *mm]),
    "docs/boundaries/free": (
        "docs/boundaries/free.toml", [],
        ["--times", "0", "0.01", "0.02", "--zoom", "1.4", "--size", "1500", "480", "--field", "velocity", "--label",
         "speed [m/s]"]),
    "docs/boundaries/fixed": (
        "docs/boundaries/fixed.toml", [],
        ["--walls", "--view", "-70", "20", "--zoom", "1.4", "--size", "900", "560", *mm]),
    "docs/boundaries/moving_wall": (
        "docs/boundaries/moving_wall.toml", ["discretisation.spacing=0.00125", "time.step=5e-4"],
        ["--cut", "y", "--walls", "--times", "0", "2", "--zoom", "1.5", "--size", "1200", "480", *mm]),
    "docs/boundaries/slip_wall": (
        "docs/boundaries/slip_wall.toml", ["discretisation.spacing=0.00125", "time.step=5e-4"],
        ["--cut", "y", "--walls", "--times", "0", "2", "--zoom", "1.5", "--size", "1200", "480", *mm]),
    "docs/boundaries/pressure": (
        "docs/boundaries/pressure.toml", ["discretisation.spacing=0.00125", "time.step=5e-4"],
        ["--cut", "y", "--walls", "--zoom", "1.5", "--size", "800", "520", *mm]),
    "docs/contacts/frictionless": (
        "docs/contacts/two_balls.toml", [],
        ["--times", "0", "0.02", "0.05", "--view", "-80", "12", "--zoom", "1.4", "--size", "1500", "500",
         "--field", "velocity", "--label", "speed [m/s]"]),
    "docs/contacts/no_slip": (
        "docs/contacts/two_balls.toml", ["contact.0.kind=no_slip"],
        ["--times", "0", "0.02", "0.05", "--view", "-80", "12", "--zoom", "1.4", "--size", "1500", "500",
         "--field", "velocity", "--label", "speed [m/s]"]),
    "docs/materials/linear": (
        "docs/materials/linear.toml", [],
        ["--cut", "y", "--walls", "--field", "pressure", "--label", "pressure [Pa]", "--times", "0",
         "0.015", "0.06", "--size", "1500", "600"]),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=root / "pliant")
    parser.add_argument("--results", type=pathlib.Path, default=root / "results/pictures")
    parser.add_argument("names", nargs="*", metavar="NAME")
    arguments = parser.parse_args()
    wanted = [name for name in rendered
              if not arguments.names
              or any(name.removeprefix("docs/").startswith(given) for given in arguments.names)]
    if not wanted:
        raise SystemExit("no such picture; there are " + ", ".join(rendered))
    for name in wanted:
        case, settings, look = rendered[name]
        folder = arguments.results / name
        print(name, flush=True)
        if not (folder / "summary.json").exists():
            sets = [part for s in ["output.surface=true", *settings] for part in ("--set", s)]
            subprocess.run([arguments.program, "run", root / case, "--quiet", "--out", folder, *sets],
                           check=True)
        draw = [sys.executable, here / "picture.py", "--program", arguments.program]
        subprocess.run([*draw, folder, root / f"{name}.png", *look], check=True)


if __name__ == "__main__":
    main()
