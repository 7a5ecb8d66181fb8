"""Wear of the indenter over a sliding distance."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from . import _core, _document
from ._problem import Problem

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
        tilt is nan if the attitude is given, from_run_in if the run-in pressure is not known. left and right are the ends of
        the contact, zones is the number of its zones. largest_pressure is the largest mean over a cell. from_run_in is the
        integral of the difference from the run-in pressure, without sign, over the load. step_error is the estimated error
        of the step, a part of the wear volume. If a step fails, the last row stands twice.
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


def wear(problem: Problem, distance: Any, steps: int | None = None, accuracy: float | None = None, until: float | None = None,
         cells: int | None = None, callback: Callable[[np.void, np.ndarray, np.ndarray], Any] | None = None) -> WearHistory:
    """Wears the indenter by its pressure over a sliding distance. A step that is not solved raises nothing.

    Parameters
    ----------
    problem : Problem
        A problem with wear.
    distance : number
        The sliding distance.
    steps : int
        So many equal steps. By default steps are automatic, and grow as the contact runs in.
    accuracy : float
        The largest error of an automatic step, a part of the wear volume: 1e-6 to 1, by default 1e-3.
    until : float
        The run ends earlier if so small a part of the load differs from the run-in pressure.
    cells : int
        The number of equal cells on the support, by default 4096.
    callback : function
        Called with the row, the pressures and the worn depths first of the contact before any wear, then after each step. What
        it raises ends the run.

    Returns
    -------
    WearHistory
        Rows, profiles, the run-in pressure.

    Raises
    ------
    InvalidData
        If the problem has no wear, if an option is out of range, if steps and accuracy are given together, or if `until` is
        given and the run-in pressure is not known.

    Examples
    --------
    >>> import steadyslide as ss
    >>> p = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0",
    ...                wear={"coefficients": ["3", "1"]})
    >>> history = ss.wear(p, distance=1000, until=1e-6)
    >>> history.rows["effective_friction"][[0, -1]].round(4)
    array([0.2828, 0.4   ])
    """
    told = None if callback is None else lambda row, pressure, depth: callback(row_of(row), pressure, depth)
    options = [_document.optional(convert, value, name)
               for convert, value, name in ((_document.whole, steps, "steps"), (_document.real, accuracy, "accuracy"),
                                            (_document.real, until, "until"), (_document.whole, cells, "cells"))]
    rows, edges, *rest = _core.wear(problem._core, _document.exact(distance, "distance"), *options, told)
    return WearHistory(np.array([row_of(row) for row in rows], dtype=ROW), (edges[1:] + edges[:-1]) / 2, *rest)
