"""The runs of robustness.py: families of runs, each around a shipped case.

A family varies one case along axes (spacing, load, shape, remeshing, kernel). The first label of an
axis is its default. `settings` turns one label of each axis into keys of the case; all runs of a
family set the same keys.
"""
import csv
import dataclasses
import json
import math
import pathlib
from typing import Callable

root = pathlib.Path(__file__).resolve().parent.parent.parent


@dataclasses.dataclass
class Figure:
    """A number that says whether a run is right."""
    measurement: str
    tolerance: float
    """Deviation from the reference up to which a run is right, over `scale` or the reference."""
    reference: Callable | None = None
    """From the labels of a run; None for the finest run of the same load and shape."""
    scale: Callable | None = None


@dataclasses.dataclass
class Family:
    name: str
    case: str
    axes: dict
    settings: Callable
    figures: list
    measurements: str = ""
    """Tables [[measurement]] in the place of those of the case; "" keeps them."""
    base: tuple = ()
    hours: float = 0.5
    """Time limit of a run."""

    def finest(self):
        return self.axes["spacing"][-1]


remeshing = {"adaptive": "adaptive", "every 5": 5, "every 20": 20}
kernels = ["compact", "quartic_spline_fit", "fourth_order"]
meshless = {"remeshing": list(remeshing), "kernel": kernels}


def scheme(run):
    return {"remeshing.every": remeshing[run["remeshing"]], "discretisation.kernel": run["kernel"]}


def with_method(family, method, name, base=(), **changes):
    """The same runs by another method, which has no remeshing and no kernels."""
    axes = {axis: labels for axis, labels in family.axes.items() if axis not in meshless}
    settings = family.settings

    def own(run):
        everything = settings({**run, "remeshing": "adaptive", "kernel": "compact"})
        return {key: value for key, value in everything.items()
                if key not in ("remeshing.every", "discretisation.kernel")}

    return dataclasses.replace(family, name=name, axes=axes, settings=own,
                               base=(*family.base, f"method={method}", *base), **changes)


def column(case, x, name):
    """A column of reference.csv at the value x of its first column, linear between its rows."""
    with (root / "cases" / case / "reference.csv").open() as file:
        rows = list(csv.DictReader(file))
    first = next(iter(rows[0]))
    points = [(float(row[first]), float(row[name])) for row in rows if row[name] not in ("", None)]
    for (a, fa), (b, fb) in zip(points, points[1:]):
        if a <= x <= b * (1 + 1e-9):
            return fa + (fb - fa) * (x - a) / (b - a)
    raise ValueError(f"{case}: no {name} at {x}")


def measurement(name, kind, **keys):
    lines = ["[[measurement]]", f'name = "{name}"', f'kind = "{kind}"']
    for key, value in keys.items():
        lines.append(f"{key} = {json.dumps(value)}")
    return "\n".join(lines) + "\n"


energy_kept = measurement("energy_kept", "total_energy", relative=True)

# Compression: the flank at mid height, along the path of the pistons and for other widths.
widths = {"1 x 2": 0.5, "0.5 x 2": 0.25, "2 x 2": 1.0}


def compression(kind):
    case = f"compression_{kind}"

    def reference(run):
        if run["shape"] != "1 x 2":
            return None
        return column(case, float(run["load"]), "u_x_flank_mid_height")

    return Family(
        case, case,
        {"spacing": ["1/16", "1/12", "1/21", "1/32", "1/45"], "load": ["0.02", "0.01", "0.015"],
         "shape": list(widths), **meshless},
        lambda run: {
            "discretisation.spacing": run["spacing"], "time.end": run["load"],
            "body.block.geometry": f'{{shape="box", lower=[{-widths[run["shape"]]}, -1], '
                                   f'upper=[{widths[run["shape"]]}, 1]}}',
            "measurement.bulge.point": f'[{widths[run["shape"]]}, 0]', **scheme(run)},
        [Figure("bulge", 0.05, reference)],
        measurement("bulge", "point_displacement", point=[0.5, 0], axis="x"),
        ("output.every=0", "output.measure_every=0.005"))


# A free body that turns by half a turn or more.
solids = {"disc": '{shape="disc", centre=[0, 0], radius=1}',
          "bar 2 x 1": '{shape="box", lower=[-1, -0.5], upper=[1, 0.5]}',
          "ring": '{shape="difference", of=[{shape="disc", centre=[0, 0], radius=1}, '
                  '{shape="disc", centre=[0, 0], radius=0.6}]}'}

cylinder = Family(
    "rotating_cylinder", "rotating_cylinder",
    {"spacing": ["sqrt(pi/800)", "sqrt(pi/200)", "sqrt(pi/450)", "sqrt(pi/1800)"],
     "load": ["2*pi", "pi", "3*pi"], "shape": list(solids), **meshless},
    lambda run: {"discretisation.spacing": run["spacing"],
                 "body.cylinder.rotation.angular_velocity": run["load"],
                 "body.cylinder.geometry": solids[run["shape"]], **scheme(run)},
    [Figure("spin", 0.02, lambda run: 1), Figure("energy_kept", 0.05, lambda run: 1)],
    measurement("spin", "angular_momentum", point=[0, 0], relative=True) + energy_kept,
    ("time.end=1", "output.every=0", "output.measure_every=0.5"))

# Periods of a clamped plate, from Timoshenko's beam in plane strain.
thicknesses = {"H/L 0.1": (0.1, 5.956), "H/L 0.05": (0.05, 11.84), "H/L 0.2": (0.2, 3.05)}
mode = ("3.0377857*(cosh(1.8751041*x) - cos(1.8751041*x)) - "
        "2.2300249*(sinh(1.8751041*x) - sin(1.8751041*x))")


def plate_settings(run):
    thickness, period = thicknesses[run["shape"]]
    return {"discretisation.spacing": f'{thickness}/{run["spacing"].split()[0]}',
            "body.plate.velocity": f'[0, "{float(run["load"]) * 0.00751263}*({mode})"]',
            "body.plate.geometry": f'{{shape="box", lower=[0, {-thickness / 2}], '
                                   f'upper=[1, {thickness / 2}]}}',
            "time.end": 1.6 * period, "output.measure_every": period / 50, **scheme(run)}


plate = Family(
    "oscillating_plate", "oscillating_plate",
    {"spacing": ["8 across", "5 across", "7 across", "10 across"], "load": ["1", "2", "4"],
     "shape": list(thicknesses), **meshless},
    plate_settings,
    [Figure("period", 0.03, lambda run: thicknesses[run["shape"]][1]),
     Figure("energy_kept", 0.15, lambda run: 1)],
    measurement("tip", "point_displacement", point=[1, 0], axis="y")
    + measurement("period", "period", of="tip") + energy_kept,
    ("output.every=0",))

# Contact between bodies: energy and transferred momentum.
partners = {"equal": 0.5, "half as large": 0.25, "a third larger": 2 / 3}


def disc_settings(run):
    radius, speed = partners[run["shape"]], float(run["load"])
    return {"discretisation.spacing": run["spacing"], "body.left.velocity": f"[{speed}, 0]",
            "body.right.velocity": f"[{-speed}, 0]", "time.end": 0.35 + 0.05 / speed,
            "body.right.geometry": f'{{shape="disc", centre=[{0.025 + radius}, 0], radius={radius}}}',
            **scheme(run)}


def energy_of_discs(run):
    return 0.5 * math.pi * (0.25 + partners[run["shape"]] ** 2) * float(run["load"]) ** 2


discs = Family(
    "two_discs", "two_discs",
    {"spacing": ["0.05", "0.1", "0.07", "0.025"], "load": ["0.5", "0.25", "1"],
     "shape": list(partners), **meshless},
    disc_settings,
    [Figure("energy", 0.05, energy_of_discs),
     Figure("momentum_of_left", 0.05, None, lambda run: 2 * math.pi * 0.25 * float(run["load"]))],
    measurement("momentum_of_left", "momentum", body="left", axis="x")
    + measurement("left", "total_energy", body="left")
    + measurement("right", "total_energy", body="right")
    + measurement("energy", "weighted_sum", terms=["left", "right"]),
    ("output.every=0", "output.measure_every=0.05"))

walls_of_rings = {"10 mm": 0.03, "6 mm": 0.034, "15 mm": 0.025}


def ring(x, hole):
    disc = '{{shape="disc", centre=[{}, 0], radius={}}}'
    return f'{{shape="difference", of=[{disc.format(x, 0.04)}, {disc.format(x, hole)}]}}'


def ring_settings(run):
    hole, speed = walls_of_rings[run["shape"]], float(run["load"])
    return {"discretisation.spacing": run["spacing"], "body.left.velocity": f"[{speed}, 0]",
            "body.right.velocity": f"[{-speed}, 0]",
            "body.left.geometry": ring(-0.041, hole), "body.right.geometry": ring(0.041, hole),
            **scheme(run)}


def energy_of_rings(run):
    area = math.pi * (0.04**2 - walls_of_rings[run["shape"]] ** 2)
    return 1000 * area * float(run["load"]) ** 2


# Part of the energy goes into waves within the rings: in the reference 2.5 % are lost too.
rings = Family(
    "two_rings", "two_rings",
    {"spacing": ["0.0015", "0.002", "0.00125", "0.001"], "load": ["7.52", "3.76", "11.28"],
     "shape": list(walls_of_rings), **meshless},
    ring_settings, [Figure("energy", 0.1, energy_of_rings)],
    measurement("left", "total_energy", body="left")
    + measurement("right", "total_energy", body="right")
    + measurement("energy", "weighted_sum", terms=["left", "right"]),
    ("time.end=0.008", "output.every=0", "output.measure_every=0.002"))

# The error of a wave grows with its path: in all 1.87 turns of the pressure wave.
waves = Family(
    "periodic_square", "periodic_square",
    {"spacing": ["1/32", "1/16", "1/21", "1/48"], "load": ["1e-3", "1e-2", "1e-1"], "shape": ["square"],
     **meshless},
    lambda run: {"discretisation.spacing": run["spacing"],
                 "body.medium.velocity": '["{0}*sin(2*pi*x)*sin(2*pi*y)", '
                                         '"{0}*sin(2*pi*x)*sin(2*pi*y)"]'.format(run["load"]),
                 "measurement.error.reference": run["load"],
                 "measurement.error.exact": '["{0}", "{0}"]'.format(
                     f'0.5*{run["load"]}*(cos(2*pi*(x - y))*cos(55.1071806045*t) - '
                     'cos(2*pi*(x + y))*cos(103.0960946866*t))'),
                 **scheme(run)},
    [Figure("error", 0.05 * 2 * math.pi * 1.87, lambda run: 0, lambda run: 1)],
    measurement("error", "velocity_error", reference=1, exact=["0", "0"]),
    ("output.every=0", "output.measure_every=0.05"))

sph = Family(
    "tensile_instability", "tensile_instability",
    {"spacing": ["sqrt(pi/800)", "sqrt(pi/200)", "sqrt(pi/450)", "sqrt(pi/1800)"],
     "load": ["pi", "pi/2", "2*pi"], "shape": list(solids), "artificial stress": ["0.3", "0"]},
    lambda run: {"discretisation.spacing": run["spacing"],
                 "sph.artificial_stress": run["artificial stress"],
                 "body.disc.rotation.angular_velocity": run["load"],
                 "body.disc.geometry": solids[run["shape"]]},
    [Figure("spin", 0.02, lambda run: 1), Figure("energy_kept", 0.05, lambda run: 1)],
    measurement("spin", "angular_momentum", point=[0, 0], relative=True) + energy_kept,
    ("time.step=cfl", "output.every=0", "output.measure_every=0.1"))

neo_hookean = 'body.plate.material={model="reduced_polynomial", coefficients=[19.2307692], ' \
              "compressibility=0.024, density=1}"

plate_lagrangian = with_method(plate, "total_lagrangian", "oscillating_plate_total_lagrangian")
plate_points = with_method(plate, "point_based", "oscillating_plate_point_based", (neo_hookean,))
cylinder_lagrangian = with_method(cylinder, "total_lagrangian", "rotating_cylinder_total_lagrangian")
cylinder_points = with_method(
    cylinder, "point_based", "rotating_cylinder_point_based",
    (neo_hookean.replace("plate", "cylinder"),))
compression_lagrangian = with_method(compression("hyperelastic"), "total_lagrangian",
                                     "compression_total_lagrangian")
compression_points = with_method(compression("hyperelastic"), "point_based",
                                 "compression_point_based")

def spacing_of(run):
    return 1 / float(run["spacing"][2:])


edge = Family(
    "edge_cut", "edge_cut",
    {"spacing": ["1/20", "1/11", "1/15", "1/27"], "load": ["1e-4", "2e-5", "5e-4"],
     "shape": ["0.5", "0.4", "0.6"], "cut rule": ["transparency", "visibility"]},
    lambda run: {"discretisation.spacing": run["spacing"], "point_based.cut_rule": run["cut rule"],
                 "cut.blade.path": f'["({run["shape"]} + 0.05)*t/2", 0]',
                 "boundary.top.traction": f'[0, "{run["load"]}*min(max(t - 2, 0)/20, 1)"]',
                 "boundary.bottom.traction": f'[0, "-{run["load"]}*min(max(t - 2, 0)/20, 1)"]',
                 # on both sides of the cut, with the nearest nodes on the same side
                 "measurement.upper_lip.point": f"[0, {0.012 + 0.75 * spacing_of(run)}]",
                 "measurement.lower_lip.point": f"[0, {0.012 - 0.75 * spacing_of(run)}]"},
    # Fracture theory, for a depth of 0.5 and small loads.
    [Figure("opening", 0.06, lambda run: 8.96057 * float(run["load"])
            if run["shape"] == "0.5" and float(run["load"]) < 2e-4 else None)],
    measurement("upper_lip", "point_displacement", point=[0, 0.03], axis="y")
    + measurement("lower_lip", "point_displacement", point=[0, -0.006], axis="y")
    + measurement("opening", "weighted_sum", terms=["upper_lip", "lower_lip"],
                  factors=[1, -1]),
    ("output.every=0",))

# Tips of beams 10 m long and 2 m wide, by height and load: extrapolated from total Lagrangian
# hexahedra of 1/4 and 1/6 m; for 2 x 2 m and small loads, from the quadratic finite elements of the
# case.
tips = {"2 x 2": {"0.25": 2.538e-3, "2.5": 2.538e-2, "25": 0.2540},
        "2 x 1": {"0.25": 9.943e-3, "2.5": 9.943e-2, "25": 0.9846},
        "2 x 4": {"0.25": 6.893e-4, "2.5": 6.893e-3, "25": 0.06893}}


def height_of(run):
    return float(run["shape"][4:])


cantilever = Family(
    "cantilever", "cantilever",
    {"spacing": ["1/2", "2/3", "1", "0.4"], "load": ["0.25", "2.5", "25"],
     "shape": ["2 x 2", "2 x 1", "2 x 4"]},
    lambda run: {"discretisation.spacing": run["spacing"],
                 "boundary.end_load.traction": f'[0, 0, "-{run["load"]}*min(t/20, 1)"]',
                 # flat beams swing at half the frequency, and come to rest later
                 "time.end": 160 if height_of(run) < 2 else 80,
                 "point_based.damping": 0.2 if height_of(run) < 2 else 0.4,
                 "body.beam.geometry": '{{shape="box", lower=[0, -1, {0}], upper=[10, 1, {1}]}}'.format(
                     -height_of(run) / 2, height_of(run) / 2)},
    [Figure("tip_displacement", 0.05, lambda run: -tips[run["shape"]][run["load"]])],
    measurement("tip_displacement", "point_displacement", point=[10, 0, 0], axis="z"),
    ("output.every=0",))

ball = Family(
    "bouncing_ball", "bouncing_ball",
    {"spacing": ["0.045", "0.056", "0.036", "0.03"], "load": ["1", "0.5", "1.5"],
     "shape": ["ball"], "wall": ["frictionless", "no_slip"], **meshless},
    lambda run: {"discretisation.spacing": run["spacing"], "boundary.wall.friction": run["wall"],
                 "body.ball.velocity": f'[0, -{run["load"]}, 0]', **scheme(run)},
    [Figure("momentum_ratio", 0.05, lambda run: -0.987 if run["load"] == "1" else None)],
    measurement("momentum_ratio", "momentum", axis="y", relative=True) + energy_kept,
    ("output.every=0", "output.measure_every=0.05", "output.ghosts=false"), hours=2)

liver = Family(
    "liver_aspiration", "liver_aspiration",
    {"spacing": ["0.025/16", "0.025/12", "0.025/14", "0.025/20"], "load": ["30", "10", "20"],
     "shape": ["as it is"], "softness": ["1", "0.5", "2"]},
    lambda run: {"discretisation.spacing": run["spacing"],
                 "boundary.tube.pressure": f'-{float(run["load"]) * 1e3 * float(run["softness"])}*(t/15)^2',
                 "material.liver.coefficients": str([float(run["softness"]) * c for c in
                                                     (2230, 7020, 5030, 6190, 7500)]),
                 "material.liver.compressibility": 5e-8 / float(run["softness"])},
    [Figure("tip", 0.06, lambda run: 1e-3 * column("liver_aspiration", float(run["load"]), "tip_mm"))],
    measurement("tip", "extent", axis="z", reference=0.025),
    ("output.every=0", "output.measure_every=5", "time.step=2e-3"), hours=3)

families = [compression("linear"), compression("hyperelastic"), compression_lagrangian,
            compression_points, cylinder, cylinder_lagrangian, cylinder_points, waves, sph, edge,
            discs, plate_lagrangian, plate_points, plate, rings, cantilever, ball, liver]
