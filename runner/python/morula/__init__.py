"""Morula grows organisms out of one cell, the same bits every time.

    import morula
    run = morula.run("unique-four.yaml", seed=1, set={"physics.drag": 5})
    run.hash; run.cells; run.lineage; run.measures("energy"); run.surface

A run gives the bits, tables and names of the program `morula`. Tables are pandas.DataFrames, or dicts of NumPy arrays
where pandas is missing; units are in DataFrame.attrs["units"]. Everything returned is a copy. InputError (a
ValueError): the scenario or a question is wrong. NumericalError (an ArithmeticError): the physics cannot go on.
FileError (an OSError): a file cannot be read or written. Texts are those of the program.
"""
from __future__ import annotations

import json
import operator
import os
import warnings
from pathlib import Path
from typing import Any, Mapping

import numpy as np

from . import _morula
from ._morula import BugError, FileError, InputError, NumericalError, __version__
from .stored import Stored, Surface, _checked, _real, frame, open, program

__all__ = ["BugError", "FileError", "InputError", "NumericalError", "Simulator", "Stored", "Surface", "measures",
           "open", "program", "run"]
for _error in (BugError, FileError, InputError, NumericalError):
    _error.__module__ = "morula"


def _as_typed(key: str, value: Any) -> str:
    """Spells a value as a scenario file would; a str stands as it is."""
    if isinstance(value, str):
        return value
    plain = lambda x: x.tolist() if isinstance(x, (np.ndarray, np.generic)) else os.fspath(x)
    try:
        return json.dumps(value, default=plain)
    except (TypeError, ValueError):
        raise TypeError(f"set {key}: {value!r} is not a number, text, list or dict") from None


def _whole(name: str, value: Any, least: int, most: int) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: {value!r} is not a whole number") from None
    if not least <= number <= most:
        raise InputError(f"{name}: {number} is out of range; needs {least} to {most}")
    return number


def _restored(source: tuple, threads: int, state: bytes) -> Simulator:
    simulator = Simulator.__new__(Simulator)
    simulator._organism = _morula.Organism.from_source(*source, threads)
    simulator._organism.restore(state)
    return simulator


class Simulator:
    """An organism that is stepped from Python.

    scenario: a scenario file, the text of a scenario (more than one line), or the database of a run.
    seed: replaces the scenario's. set: keys of the scenario and their values, {"physics.drag": 5}; None removes a key.
    threads: their number; it changes no bit of any result.
    Raises InputError with one line per mistake, and FileError. Only one thread at a time may use a simulator; others
    run meanwhile. Ctrl-C stops between two steps, and the simulator may go on.
    """

    def __init__(self, scenario: str | os.PathLike[str], *, seed: int | None = None,
                 set: Mapping[str, Any] | None = None, threads: int = 1) -> None:
        if not isinstance(set, (Mapping, type(None))):
            raise TypeError(f"set: {set!r} is not a dict; needs one, as {{'physics.drag': 5}}")
        changes = [f"{key}={_as_typed(key, value)}" for key, value in (set or {}).items()]
        changes += [] if seed is None else [f"seed={_whole('seed', seed, 0, 2**63 - 1)}"]
        source = _checked("scenario", scenario, (str, bytes, os.PathLike))
        self._organism = _morula.Organism(os.fsencode(source), changes, _whole("threads", threads, 1, 1024))
        for text in self._organism.warnings:
            warnings.warn(text, stacklevel=2)

    def step(self, steps: int = 1) -> Simulator:
        """Takes so many time steps, but not past the end. Raises NumericalError."""
        self._organism.run(most=_whole("steps", steps, 0, 2**63))
        return self

    def run(self, until: float | None = None) -> Simulator:
        """Runs until the clock shows `until` [time] or later, or to the end of the scenario. Raises NumericalError."""
        self._organism.run(*([] if until is None else [_real("until", until)]))
        return self

    @property
    def time(self) -> float:
        """The clock [time]."""
        return self._organism.clock()[0]

    @property
    def steps(self) -> int:
        """The number of steps so far."""
        return self._organism.clock()[1]

    @property
    def finished(self) -> bool:
        """True once the scenario has ended."""
        return self._organism.clock()[3]

    @property
    def threads(self) -> int:
        """The number of threads."""
        return self._organism.threads

    @property
    def hash(self) -> str:
        """32 hexadecimal digits over all bits of the state, as `morula run` prints them."""
        return self._organism.hash()

    def table(self, name: str) -> Any:
        """A table of the database, with the rows so far: cell, sample, cell_sample, contact, measure, division, …
        Also as an attribute: run.cell_sample. Raises InputError for another name."""
        return frame(*self._organism.table(_checked("name", name)))

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(f"a simulator has no '{name}'")
        try:
            return self.table(name)
        except InputError as error:
            raise AttributeError(f"a simulator has no '{name}'; as a table: {error}") from None

    @property
    def lineage(self) -> Any:
        """Every cell that ever was (the table `cell`): path, parent, born and ended [time], fate, state, name."""
        return self.table("cell")

    @property
    def cells(self) -> Any:
        """The living cells now, by path, with their measures (the columns of `cell_sample`). No rows without bodies."""
        return frame(*self._organism.table_now("cell_sample"))

    @property
    def contacts(self) -> Any:
        """The pairs of cells that touch now (the columns of `contact`), areas in length²."""
        return frame(*self._organism.table_now("contact"))

    @property
    def divisions(self) -> Any:
        """Every division of a cell with a body: path of the mother, time, axis, share of daughter A."""
        return self.table("division")

    @property
    def connections(self) -> Any:
        """Every connection that was ever made: a, b, made and released [time], cause."""
        return self.table("connection")

    def measures(self, *names: str) -> Any:
        """Measures of the organism at the scenario's samples (record.every); without names all that samples take.
        Others than these and those of record.measures are taken by running the scenario again, which gives the same
        bits. Raises InputError for a name that is not known or measures cells."""
        columns, units = self._organism.table("sample")
        asked, _ = self._organism.table("measure")
        of = {name: self._organism.measure_info(_checked("name", name)) for name in names if name not in columns}
        missing = [stored for stored, _, _ in of.values() if stored not in asked["name"]]
        for name, (_, scope, _) in of.items():
            if scope != "world":
                raise InputError(f"'{name}' measures a {scope}; needs a measure of the organism. measure() takes it of "
                                 "cells now, and record.measures keeps it in the table 'measure'")
        if missing:
            text, file, changes, files = self._organism.source()
            changes = [c for c in changes if not c.startswith("record.measures=")]
            kept = json.loads(self._organism.resolved)["record"].get("measures", [])  # check.reference may need them
            changes.append("record.measures=" + json.dumps([*kept, *missing]))
            again = _morula.Organism.from_source(text, file, changes, files, self.threads)
            again.run(most=self.steps)
            asked = {key: np.concatenate([values, again.table("measure")[0][key]]) for key, values in asked.items()}
        for name in of:
            rows = asked["name"] == of[name][0]
            columns[name] = np.full(len(columns["time"]), np.nan)
            columns[name][np.searchsorted(columns["time"], asked["time"][rows])] = asked["value"][rows]
            units[name] = of[name][2]
        return frame({name: columns[name] for name in ("time", *names)} if names else columns, units)

    def measure(self, name: str) -> float | np.ndarray:
        """Takes a measure now: a float of the organism ("energy", "count of skin*"), or an array with one value for
        each living cell, by path ("cell.volume", "sphericity of AB*"). NaN: nothing to measure. morula.measures() lists
        names and units. Cells are measured once and kept until the next step. Raises InputError."""
        return self._organism.measure(_checked("name", name))

    @property
    def surface(self) -> Surface:
        """The surfaces of all living cells [Surface]. Empty without bodies."""
        return Surface(*self._organism.surfaces())

    def save(self) -> bytes:
        """The state and all records so far. Raises InputError if the run has failed."""
        return self._organism.save()

    def restore(self, state: bytes) -> Simulator:
        """Goes to a state that a simulator of the same scenario has saved. Raises InputError for another one."""
        self._organism.restore(bytes(_checked("state", state, (bytes, bytearray, memoryview))))
        return self

    def save_scenario(self, file: str | os.PathLike[str]) -> None:
        """Writes the scenario, with `set`, seed and all defaults, so that `morula run FILE` repeats this run anywhere.
        Meshes are written beside it. Raises OSError."""
        scenario = json.loads(self._organism.resolved)
        for role, path, content in self._organism.source()[3]:
            if role in ("mesh", "shell"):
                key = "file" if role == "mesh" else "mesh"
                scenario["physics"][role][key] = Path(path).name
                Path(file).with_name(Path(path).name).write_bytes(content)
        Path(file).write_text(json.dumps(scenario, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")

    def picture(self, file: str | os.PathLike[str] | None = None, *, colour: str = "", size: int = 900) -> bytes | None:
        """The organism as it is now, drawn as `morula render` draws it (without bodies: the lineage), as a PNG picture;
        with `file`, a name that ends in .png, written there instead of returned. colour: substance, clone, generation
        or a measure of cells. size [pixel]. Raises InputError and OSError."""
        name = "" if file is None else os.fspath(_checked("file", file, (str, os.PathLike)))
        if file is not None and not name.lower().endswith(".png"):
            raise InputError(f"picture: '{name}' is no name of a PNG picture; needs a name that ends in .png")
        png = self._organism.picture(_checked("colour", colour), _whole("size", size, 64, 4096))
        if file is None:
            return png
        Path(name).write_bytes(png)
        return None

    def _repr_png_(self) -> bytes:
        return self.picture(size=480)

    def __repr__(self) -> str:
        time, steps, cells, finished = self._organism.clock()
        return (f"<morula {self._organism.name}, seed {self._organism.seed}: time {time:.6g}, {steps} steps, "
                f"{cells} cells{', finished' if finished else ''}>")

    def __reduce__(self) -> tuple:
        return _restored, (self._organism.source(), self._organism.threads, self.save())


def run(scenario: str | os.PathLike[str], *, seed: int | None = None, set: Mapping[str, Any] | None = None,
        threads: int = 1) -> Simulator:
    """Runs a scenario to its end [Simulator]. Raises InputError, FileError and NumericalError."""
    return Simulator(scenario, seed=seed, set=set, threads=threads).run()


def measures() -> Any:
    """All measures: name, unit, of (world: the organism, cell, pair), on_demand (not a column of samples)."""
    names, units, scopes, demand = zip(*_morula.measures())
    return frame({"name": list(names), "unit": list(units), "of": list(scopes), "on_demand": list(demand)}, {})
