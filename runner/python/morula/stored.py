"""Results on the disk: run.db and study.db."""
from __future__ import annotations

import io
import os
import shutil
import sqlite3
import subprocess
import sys
import sysconfig
from pathlib import Path
from typing import Any, NamedTuple, Sequence
from urllib.parse import quote

import numpy as np

from . import _morula


class Surface(NamedTuple):
    """The surfaces of cells: vertices (V, 3) [length]; triangles (T, 3), numbers of vertices; cell (V,), the number of
    each vertex's cell, by path; start (cells + 1,), the first vertex of each cell."""
    vertices: np.ndarray
    triangles: np.ndarray
    cell: np.ndarray
    start: np.ndarray


def frame(columns: dict[str, Any], units: dict[str, str]) -> Any:
    """Returns a DataFrame, or the columns themselves where pandas is missing."""
    try:
        import pandas
    except ImportError:
        return columns
    table = pandas.DataFrame(columns)
    table.attrs["units"] = {name: unit for name, unit in units.items() if name in columns}
    return table


def _checked(name: str, value: Any, kinds: Any = str) -> Any:
    """Returns an argument of one of these types. Raises TypeError, and InputError for half of a surrogate pair."""
    if not isinstance(value, kinds):
        kinds = kinds if isinstance(kinds, tuple) else (kinds,)
        raise TypeError(f"{name}: {value!r} is not a {' or '.join(kind.__name__ for kind in kinds)}")
    if kinds is str and value.encode(errors="replace").decode() != value:
        raise _morula.InputError(f"{name}: {value!r} is not Unicode")
    return value


def _real(name: str, value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: {value!r} is not a number") from None
    if number != number:
        raise _morula.InputError(f"{name}: NaN is not a time")
    return number


def program() -> str:
    """The path of the program morula. Raises FileError if there is none."""
    here = Path(__file__).resolve()
    for folder in (here.parents[2], Path(sysconfig.get_path("scripts")), Path(sys.executable).parent):
        if os.access(folder / "morula", os.X_OK) and (folder / "morula").is_file():
            return str(folder / "morula")
    found = shutil.which("morula")
    if not found:
        raise _morula.FileError("the program morula is not found; install it, or add its folder to PATH")
    return found


def _array(values: list, declared: str) -> np.ndarray:
    kinds = {type(v) for v in values}
    if declared == "INTEGER" and kinds <= {int} or kinds == {int} and declared != "REAL":
        return np.array(values, dtype=np.int64)
    if declared in ("REAL", "INTEGER") or kinds <= {int, float, type(None)} and kinds - {type(None)}:
        return np.array([np.nan if v is None else v for v in values], dtype=float)
    texts = np.empty(len(values), dtype=object)
    texts[:] = values
    return texts


class Stored:
    """A database of results, to read from. Its tables are attributes: results.run, results.cell_sample, …"""

    def __init__(self, file: str | os.PathLike[str], check: bool = True) -> None:
        self.file = os.fspath(_checked("file", file, (str, os.PathLike)))
        if check:
            _morula.check_database(self.file)
        uri = f"file:{quote(os.path.abspath(self.file))}?mode=ro"
        self._db = sqlite3.connect(uri, uri=True, check_same_thread=False)

    def close(self) -> None:
        """Closes the file. Later questions raise FileError."""
        self._db.close()

    def _rows(self, query: str, values: Sequence[Any] = ()) -> tuple[list[str], list]:
        try:
            cursor = self._db.execute(_checked("query", query), values)
            return [c[0] for c in cursor.description or ()], cursor.fetchall()
        except sqlite3.Error as error:
            raise _morula.FileError(f"{self.file}: {error}") from None

    def sql(self, query: str, values: Sequence[Any] = (), *, _declared: dict[str, str] = {}) -> Any:
        """The rows of a query, whose question marks stand for `values`. Raises FileError with SQLite's words."""
        names, rows = self._rows(query, values)
        columns = list(zip(*rows)) if rows else [()] * len(names)
        return frame({n: _array(list(c), _declared.get(n, "")) for n, c in zip(names, columns)}, {})

    @property
    def tables(self) -> list[str]:
        """The names of all tables."""
        query = "SELECT name FROM sqlite_schema WHERE type IN ('table', 'view') ORDER BY rowid"
        return [row[0] for row in self._rows(query)[1]]

    def table(self, name: str) -> Any:
        """All rows of a table, of all runs; with every label of the study's axes in `condition`. Raises InputError."""
        if name not in self.tables:
            raise _morula.InputError(f"{self.file} has no table '{name}'; it has {', '.join(self.tables)}")
        declared = {r[1]: r[2] for r in self._rows(f'PRAGMA table_info("{name}")')[1]}
        order = f"ORDER BY {_morula.orders[name]}" if name in _morula.orders else ""
        return self.sql(f'SELECT * FROM "{name}" {order}', _declared=declared)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or hasattr(type(self), name):
            raise AttributeError(f"results have no '{name}'")
        try:
            return self.table(name)
        except _morula.InputError as error:
            raise AttributeError(str(error)) from None

    def surfaces(self, time: float | None = None, run: str = "") -> Surface:
        """The surfaces at the last time with surfaces not after `time` [time], by default the end (record.meshes in the
        scenario keeps them). run: the beginning of a run_id; by default the last run. Raises InputError without any."""
        rows = self._rows("SELECT run_id FROM run ORDER BY started, rowid")[1]
        ids = [r[0] for r in rows if r[0].startswith(_checked("run", run))]
        if not ids:
            raise _morula.InputError(f"{self.file} has no run whose id begins with '{run}'")
        where = (ids[-1], np.inf if time is None else _real("time", time))
        rows = self._rows(
            "SELECT path, mesh, low_x, low_y, low_z, step_x, step_y, step_z, vertices FROM mesh_sample "
            "WHERE run_id = ?1 AND time = (SELECT max(time) FROM mesh_sample WHERE run_id = ?1 AND time <= ?2) ORDER BY path", where)[1]
        if not rows:
            raise _morula.InputError(f"{self.file}: run {ids[-1]} keeps no surfaces up to time {where[1]}; "
                                     f"record.meshes keeps them, and morula.run('{self.file}') runs it again")
        faces = dict(self._rows("SELECT path, content FROM run_document JOIN document USING (hash) "
                                "WHERE run_id = ? AND role = 'faces'", where[:1])[1])
        vertices, triangles, start = [], [], [0]
        for row in rows:
            numbers = np.frombuffer(row[8], dtype="<u2").reshape(-1, 3)
            vertices.append(np.array(row[2:5]) + numbers * np.array(row[5:8]))
            corners = np.frombuffer(faces[str(row[1])], dtype="<u2" if len(numbers) <= 65536 else "<u4")
            triangles.append(corners.reshape(-1, 3).astype(np.int32) + start[-1])
            start.append(start[-1] + len(numbers))
        return Surface(np.concatenate(vertices), np.concatenate(triangles).astype(np.int32),
                       np.repeat(np.arange(len(rows)), np.diff(start)), np.array(start))

    def tidy(self, rows: str = "runs") -> Any:
        """The tidy table of a study, as `morula compare --tidy` writes it: a row per run, sample or cell, with the
        labels of its condition. Raises InputError with the program's words."""
        words = [program(), "compare", self.file, "--tidy", _checked("rows", rows)]
        told = subprocess.run(words, capture_output=True, text=True)
        if told.returncode:
            raise _morula.InputError(told.stderr.strip())
        table = np.genfromtxt(io.StringIO(told.stdout), delimiter=",", names=True, dtype=None, encoding="utf-8",
                              deletechars="", replace_space=" ")
        return frame({name: np.atleast_1d(table[name]) for name in table.dtype.names}, {})

    def __repr__(self) -> str:
        try:
            return f"<morula results {self.file}: {len(self._rows('SELECT 1 FROM run')[1])} runs>"
        except _morula.FileError as error:
            return f"<morula results {error}>"


def open(file: str | os.PathLike[str], check: bool = True) -> Stored:
    """Opens a database of runs or of a study to read from. check: first finds out whether its rows are those that were
    stored. Raises FileError with the program's text."""
    return Stored(file, check)
