"""How each program is called for a run, and how its answer is read."""
import dataclasses
import json
import pathlib
import typing

import beam
import calculix
import niftysim


@dataclasses.dataclass
class Answer:
    particles: int  # or nodes
    steps: int
    values: dict  # by name of the measurement


@dataclasses.dataclass
class Run:
    """A command, and what reads the answer from its standard output and the folder in which it ran."""
    command: list
    read: typing.Callable[[str], Answer]
    environment: dict = dataclasses.field(default_factory=dict)


@dataclasses.dataclass
class Settings:
    pliant: pathlib.Path  # the program
    peers: pathlib.Path  # built by bench/peers/build
    threads: int


def pliant(settings, folder, case, changes):
    command = [settings.pliant, "run", case, "--quiet", "--threads", str(settings.threads), "--out", folder / "out"]
    for change in changes:
        command += ["--set", change]

    def read(_):
        summary = json.loads((folder / "out/summary.json").read_text())
        values = {name: one["value"] for name, one in summary["measurements"].items()}
        return Answer(summary["particles"]["start"], summary["steps"], values)

    return Run(command, read)


def sphinxsys(settings, folder, problem, across, method):
    """Its drivers print JSON after what the library prints."""
    if problem == "cantilever":
        command = [settings.peers / "sphinxsys/beam"]
    else:
        command = [settings.peers / "sphinxsys/plane", problem, method]
    command += [str(across), str(settings.threads)]
    return Run(command, lambda text: Answer(**json.loads(text.splitlines()[-1])))


def niftysim_beam(settings, folder, problem, across, hourglass):
    """Takes all processors, where it has more than 1024 elements."""
    mesh = beam.Mesh(across)
    text, steps = niftysim.model(mesh, hourglass)
    (folder / "beam.xml").write_text(text)
    command = [settings.peers / "niftysim/source/niftysim", "-x", "beam.xml", "-print", "ND"]

    def read(text):
        return Answer(len(mesh.numbers), steps, {"tip_displacement": niftysim.displacement(text, mesh.tip)})

    return Run(command, read)


def calculix_beam(settings, folder, problem, across, element):
    mesh = beam.Mesh(across, is_quadratic=element == "C3D20R")
    (folder / "beam.inp").write_text(calculix.deck(mesh, element))
    threads = str(settings.threads)

    def read(_):
        tip = calculix.tip_displacement((folder / "beam.dat").read_text())
        return Answer(len(mesh.numbers), 1, {"tip_displacement": tip})

    return Run(["ccx", "beam"], read, {"OMP_NUM_THREADS": threads, "CCX_NPROC_EQUATION_SOLVER": threads})


PEERS = {"SPHinXsys": sphinxsys, "NiftySim": niftysim_beam, "CalculiX": calculix_beam}
