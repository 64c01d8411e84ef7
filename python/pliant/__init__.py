"""pliant: particles for elastic solids and soft tissue. See docs/python.md."""

from pliant._pliant import Input, InputError, InputKind, Progress, RunError, __version__, read_inputs, write_inputs
from pliant.case import Simulation, read_case
from pliant.results import Result, open_result

__all__ = ["Input", "InputError", "InputKind", "Progress", "Result", "RunError", "Simulation", "__version__", "open_result",
           "read_case", "read_inputs", "write_inputs"]
