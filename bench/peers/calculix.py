"""CalculiX (GPL, the Debian package calculix-ccx, called as a program) on the cantilever: one implicit static step
with geometric nonlinearity.
"""
import math
import re

import beam


def lines_of_element(number, nodes):
    """At most 16 numbers on a line, the first of which ends with a comma where there is another."""
    words = [str(number)] + [str(node + 1) for node in nodes]
    return ",\n".join(", ".join(part) for part in (words[:16], words[16:]) if part)


def deck(mesh, element):
    """The input, in which nodes have numbers from 1."""
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{n}, {x:.12g}, {y:.12g}, {z:.12g}" for n, (x, y, z) in enumerate(mesh.points(), 1)]
    lines.append(f"*ELEMENT, TYPE={element}, ELSET=BEAM")
    lines += [lines_of_element(number, nodes) for number, nodes in enumerate(mesh.elements, 1)]
    lines += ["*BOUNDARY"] + [f"{node + 1}, 1, 3" for node in mesh.clamped]
    lines += ["*NSET, NSET=TIP", str(mesh.tip + 1), "*MATERIAL, NAME=RUBBER", "*ELASTIC",
              f"{beam.YOUNGS_MODULUS}, {beam.POISSONS_RATIO}", "*SOLID SECTION, ELSET=BEAM, MATERIAL=RUBBER",
              "*STEP, NLGEOM", "*STATIC", "1, 1", "*CLOAD"]
    lines += [f"{node + 1}, 3, {force:.12g}" for node, force in mesh.loads.items()]
    return "\n".join(lines + ["*NODE PRINT, NSET=TIP", "U", "*END STEP", ""])


def tip_displacement(text):
    """Along z [m], from the file beam.dat."""
    values = re.findall(r"^ +\d+ +(\S+) +(\S+) +(\S+)$", text, re.MULTILINE)
    return float(values[-1][2]) if values else math.nan
