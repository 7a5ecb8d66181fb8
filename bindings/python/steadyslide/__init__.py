"""Steady sliding contact of an indenter on an elastic half-plane whose friction coefficient jumps.

    import steadyslide as ss
    p = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0")
    s = p.solve()                       # digits=50 gives mpmath numbers
    s.effective_friction, s.traction([-0.5, 0.5])

Data are exact: integers, fractions.Fraction, decimal.Decimal, strings ("0.1", "1/3"). A float stands for the decimal that
it prints. Bad data raise InvalidData, a ValueError, with the message of the command line. A solve that does not converge
raises nothing: check Solution.solved and Solution.failed_condition. Signs and units are those of the command line: the
traction is <= 0, stresses are positive in tension, z > 0 is the depth. Threads may share objects, and solve at the same
time.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import Executor
from typing import Any

import numpy as np

from ._core import InvalidData, __version__
from ._problem import Problem
from ._results import (BothDirections, Contact, ContactEnd, Displacement, EstimatedError, InterfaceStress, Interval, LargestPressure, LargestStress,
                       NodalForces, Number, Picture, PossiblePoint, Proof, Residuals, Resultants, Sample, SingularPoint, Stress,
                       UnresolvedGap)
from ._solution import Solution
from ._wear import WearHistory

__all__ = ["BothDirections", "Contact", "ContactEnd", "Displacement", "EstimatedError", "Interval", "InvalidData",
           "InterfaceStress", "LargestPressure", "LargestStress", "NodalForces", "Number", "Picture", "PossiblePoint", "Problem", "Proof", "Residuals",
           "Resultants", "Sample", "SingularPoint", "Solution", "Stress", "UnresolvedGap", "WearHistory", "__version__", "sweep", "wear"]

InvalidData.__module__ = __name__
InvalidData.__doc__ = "Data that break a rule. The message says what is wrong, the rule, and the value."


def sweep(base: Problem, vary: Mapping[str | tuple[str, ...], Sequence[Any]], columns: Iterable[str] = ("effective_friction",),
          executor: Executor | None = None, **options: Any) -> np.ndarray:
    """Solves every combination of varied data. The first varied datum changes slowest.

    Parameters
    ----------
    base : Problem
        The problem with all other data.
    vary : dict
        Lists of values for paths in a problem file, {"friction.values[1]": ["0.1", "0.2"], ...}. Data that change together
        have a tuple of paths, and tuples of values.
    columns : list of str
        Names of results: "load_share[0]", "contact[0].left.x", "largest_pressure.value", "effective_friction_error",
        "singular_points.size".
    executor : concurrent.futures.Executor
        By default threads, one for each core.
    **options
        Those of Problem.solve().

    Returns
    -------
    numpy.ndarray
        A structured array with one row for each combination: the varied data, the results, and failed_condition, which
        is empty if the problem was solved, and else the reason, also of a combination that is no valid problem.

    Raises
    ------
    InvalidData
        If vary or columns is wrong.

    Examples
    --------
    >>> import steadyslide as ss
    >>> p = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0")
    >>> ss.sweep(p, {"friction.values[1]": ["0.1", "0.5"]})["effective_friction"].round(4)
    array([0.1   , 0.2828])
    """
    from ._sweep import sweep as run
    return run(base, vary, columns, executor, options)


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
        If the problem has no wear, or an option is out of range.

    Examples
    --------
    >>> import steadyslide as ss
    >>> p = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0",
    ...                wear={"coefficients": ["3", "1"]})
    >>> history = ss.wear(p, distance=1000, until=1e-6)
    >>> history.rows["effective_friction"][[0, -1]].round(4)
    array([0.2828, 0.4   ])
    """
    from ._wear import wear as run
    return run(problem, distance, steps, accuracy, until, cells, callback)
