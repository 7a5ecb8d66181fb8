"""Wear of the indenter over a sliding distance."""

from typing import NamedTuple

import numpy as np

from . import _core, _document

NAMES = ("distance", "left", "right", "zones", "effective_friction", "centre_of_pressure", "tilt", "largest_pressure",
         "wear_rate", "wear_volume", "from_run_in", "step_error")
ROW = np.dtype([(name, int if name == "zones" else float) for name in NAMES])


class WearHistory(NamedTuple):
    """The history of a contact that wears.

    Attributes
    ----------
    rows : numpy.ndarray
        A structured array, first the contact before any wear, then one row for each step: distance, left, right, zones,
        effective_friction, centre_of_pressure, tilt, largest_pressure, wear_rate, wear_volume, from_run_in, step_error.
        tilt is nan if the attitude is given, from_run_in if the run-in pressure is not known.
    x : numpy.ndarray
        The middles of the cells.
    pressure : numpy.ndarray
        The pressure on the cells at the end.
    depth : numpy.ndarray
        The worn depth on the cells at the end.
    run_in_pressure : numpy.ndarray
        The pressure with which nothing changes any more; empty if it is not known.
    failed_condition : str
        The reason why the run ended early; empty if no step failed.
    """

    rows: np.ndarray
    x: np.ndarray
    pressure: np.ndarray
    depth: np.ndarray
    run_in_pressure: np.ndarray
    failed_condition: str

    @property
    def solved(self) -> bool:
        """True if no step failed."""
        return not self.failed_condition


def row_of(values):
    return np.array(tuple(np.nan if value is None else value for value in values), dtype=ROW)[()]


def wear(problem, distance, steps, accuracy, until, cells, callback):
    told = None if callback is None else lambda row, pressure, depth: callback(row_of(row), pressure, depth)
    rows, edges, *rest = _core.wear(problem._core, _document.exact(distance, "distance"), steps, accuracy, until, cells, told)
    return WearHistory(np.array([row_of(row) for row in rows], dtype=ROW), (edges[1:] + edges[:-1]) / 2, *rest)
