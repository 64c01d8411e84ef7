"""Cases as files or dictionaries, and simulations of them."""

import math
import os

import numpy

from pliant import _pliant


def _toml(value):
    """A value of TOML: numbers, words, lists and dictionaries, from Python's or numpy's."""
    if isinstance(value, (bool, numpy.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, numpy.integer)):
        return str(int(value))
    if isinstance(value, (float, numpy.floating)):
        if not math.isfinite(value):
            return str(float(value))
        return repr(float(value))
    if isinstance(value, (str, os.PathLike)):
        escapes = {'"': '\\"', "\\": "\\\\"}
        letters = (escapes.get(c, c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}") for c in os.fspath(value))
        return '"' + "".join(letters) + '"'
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_toml(str(key))} = {_toml(one)}" for key, one in value.items()) + " }"
    if isinstance(value, (list, tuple, numpy.ndarray)):
        return "[" + ", ".join(_toml(one) for one in value) + "]"
    raise _pliant.InputError(f"{value!r}: a case holds numbers, words, lists and dictionaries")


def read_case(case, settings=(), folder="."):
    """A case from a file, a folder that holds a case.toml, or a dictionary with the keys of case files.

    `settings`: a dictionary of further keys, as {"discretisation.spacing": 0.01}. Names of files in a dictionary
    are relative to `folder`.
    """
    if isinstance(case, dict):
        text = "".join(f"{_toml(str(key))} = {_toml(value)}\n" for key, value in case.items())
        made = _pliant.CaseFile.parse(text, folder)
    else:
        made = _pliant.CaseFile.read(case)
    for key, value in dict(settings).items():
        made.set(key, _toml(value))
    return made


class Simulation(_pliant.Simulation):
    """A case that is being simulated, step by step.

    `case`, `settings` and `folder` are those of `read_case`. `threads`: 0 takes one for each processor; `isa`:
    "sse2", "avx2", "avx512", or "" for the widest.
    """

    def __init__(self, case, settings=(), *, folder=".", threads=0, isa=""):
        super().__init__(read_case(case, settings, folder), threads, isa)

    def field(self, name, body=0):
        """A field of the particles of a body, [particle] or [particle][component], in the order of `positions`: a
        copy. `components` gives the arrays themselves."""
        slots = self.slots(body)
        columns = [component[slots] for component in self.components(body, name)]
        return columns[0] if len(columns) == 1 else numpy.stack(columns, axis=1)
