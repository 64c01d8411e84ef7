"""pliant: particles for elastic solids and soft tissue. See docs/python.md."""

from pliant._pliant import InputError, RunError, __version__
from pliant.case import Simulation, read_case
from pliant.results import Result, open_result

__all__ = ["InputError", "Result", "RunError", "Simulation", "__version__", "open_result", "read_case"]
