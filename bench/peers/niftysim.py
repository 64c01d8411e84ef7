"""NiftySim (BSD) on the cantilever: explicit total Lagrangian finite elements, hexahedra with one stress point,
neo-Hookean, in single precision.

The beam moves to rest under the damping that pliant has. Loads have a few shapes; the one that stays grows over the
first tenth of the run, where pliant takes a quarter. The constant of the hourglass forces has no default; that of
the examples is 0.075.
"""
import math
import re

import beam

END, DAMPING = 80.0, 0.4  # [s], [1/s]
STEP = 0.9  # of the time in which a pressure wave crosses an element


def constraint(kind, axis, nodes, attributes="", more=""):
    words = " ".join(str(node) for node in nodes)
    return (f'<Constraint Type="{kind}" DOF="{axis}" NumNodes="{len(nodes)}"{attributes}>'
            f"<Nodes>{words}</Nodes>{more}</Constraint>")


def rows(numbers):
    return "\n".join(" ".join(f"{number:.9g}" for number in row) for row in numbers)


def model(mesh, hourglass):
    """The input, in which nodes have numbers from 0."""
    shear = beam.YOUNGS_MODULUS / (2 + 2 * beam.POISSONS_RATIO)
    bulk = beam.YOUNGS_MODULUS / (3 - 6 * beam.POISSONS_RATIO)
    step = STEP * mesh.spacing / math.sqrt((bulk + 4 / 3 * shear) / beam.DENSITY)
    forces = " ".join(f"{force:.9g}" for force in mesh.loads.values())
    clamp = "\n".join(constraint("Fix", axis, mesh.clamped) for axis in range(3))
    load = constraint("Force", 2, list(mesh.loads), ' LoadShape="RAMPHOLD"',
                      f'<Magnitudes Type="DIFFORM">{forces}</Magnitudes>')
    return f"""<?xml version="1.0" encoding="utf-8"?>
<Model>
<Nodes DOF="3" NumNodes="{len(mesh.numbers)}">
{rows(mesh.points())}
</Nodes>
<Elements NumEls="{len(mesh.elements)}" Type="H8">
{rows(mesh.elements)}
</Elements>
<ElementSet Size="{len(mesh.elements)}">
<Material Type="NH"><ElasticParams NumParams="2">{shear:.9g} {bulk:.9g}</ElasticParams></Material>
{" ".join(str(number) for number in range(len(mesh.elements)))}
</ElementSet>
{clamp}
{load}
<SystemParams>
<TimeStep>{step:.9g}</TimeStep>
<TotalTime>{END}</TotalTime>
<DampingCoeff>{DAMPING}</DampingCoeff>
<HGKappa>{hourglass}</HGKappa>
<Density>{beam.DENSITY}</Density>
</SystemParams>
</Model>
""", round(END / step)


def displacement(text, node):
    """Along z [m] of a node, from what `-print ND` prints, where nodes have numbers from 1."""
    found = re.search(rf"^{node + 1}\t\S+\t\S+\t(\S+)$", text, re.MULTILINE)
    return float(found[1]) if found else math.nan
