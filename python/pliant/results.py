"""Results of runs as numpy arrays."""

import json
import pathlib

import h5py

PARTICLE = 1  # of the field `kind`; others are ghosts


class Frame:
    """The particles at one instant, without ghosts: `time` [s], and arrays by name, as in frame["velocity"]."""

    def __init__(self, file, index):
        steps = file["VTKHDF/Steps"]
        self._data = file["VTKHDF/PointData"]
        first = int(steps["PointOffsets"][index])
        self._rows = slice(first, first + int(file["VTKHDF/NumberOfPoints"][index]))
        self._points = file["VTKHDF/Points"]
        self.time = float(steps["Values"][index])
        self._inside = self._data["kind"][self._rows] == PARTICLE if "kind" in self._data else slice(None)

    def __getitem__(self, name):
        return self._data[name][self._rows][self._inside]

    @property
    def names(self):
        return list(self._data)

    @property
    def positions(self):
        """[particle][3] [m]"""
        return self._points[self._rows][self._inside]

    def unit(self, name):
        unit = self._data[name].attrs["unit"]
        return unit.decode() if isinstance(unit, bytes) else str(unit)


class Surface:
    """The surfaces of all bodies at one instant: `positions` [vertex][3], `pieces` [piece][corner]."""

    def __init__(self, group, index):
        vertices, pieces = group["NumberOfPoints"][:index + 1], group["NumberOfCells"][:index + 1]
        self._rows = slice(int(vertices[:-1].sum()), int(vertices.sum()))
        self._data = group["PointData"]
        self.positions = group["Points"][self._rows]
        self.pieces = group["Connectivity"][int(pieces[:-1].sum()):int(pieces.sum())]

    def __getitem__(self, name):
        return self._data[name][self._rows]


class Result:
    """The folder of a run. Use it in a `with` statement, or close it."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.file = h5py.File(self.folder / "result.h5", "r")
        self.times = self.file["VTKHDF/Steps/Values"][:self.file["VTKHDF/Steps"].attrs["NSteps"]]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.file.close()

    def __len__(self):
        return len(self.times)

    def _index(self, index):
        if not -len(self) <= index < len(self):
            raise IndexError(f"frame {index} of {len(self)}")
        return index % len(self)

    def __getitem__(self, index):
        """Frame `index`; -1 is the last."""
        return Frame(self.file, self._index(index))

    def surface(self, index):
        """The surface of a frame; None where the run has none."""
        return Surface(self.file["surface"], self._index(index)) if "surface" in self.file else None

    @property
    def measurements(self):
        return list(self.file["measurements"])

    def history(self, name):
        """Times [s] and values of a measurement."""
        group = self.file["measurements"][name]
        return group["time"][:], group["value"][:]

    @property
    def settings(self):
        """The case with every default, as TOML."""
        return self.file["run/case.toml"][()].decode()

    @property
    def summary(self):
        """summary.json as a dictionary; None while the run is active."""
        path = self.folder / "summary.json"
        return json.loads(path.read_text()) if path.exists() else None


def open_result(folder):
    """The results in the folder of a run."""
    return Result(folder)
