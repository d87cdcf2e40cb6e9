"""Columns as people of Python expect them."""
from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np


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
