"""Solves many variants of a problem, one row each."""

import itertools
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import Executor, ThreadPoolExecutor
from fractions import Fraction
from typing import Any

import numpy as np

from ._core import InvalidData
from ._problem import Problem


def result(solution, column):
    """Returns the result that a column names, nan if the solution has no such number.

    Names are those of the command line: "contact[0].left.x", "load_share_error[0]", "singular_points.size".
    """
    of_error = re.fullmatch(r"(.+)_error((?:\[\d+\])*)", column)
    if of_error and column != "estimated_error":
        return getattr(result(solution, of_error[1] + of_error[2]), "error", np.nan)
    value = solution
    for name, index in re.findall(r"([^.\[\]]+)|\[(\d+)\]", column):
        try:
            value = value[int(index)] if index else _named(value, name)
        except IndexError:
            return np.nan
        if value is None:
            return np.nan
    value = getattr(value, "value", value)
    return np.nan if value is None else value


def _named(value, name):
    if name == "size" and isinstance(value, list):
        return len(value)
    for owner in (value, getattr(value, "resultants", None)):
        if hasattr(owner, name):
            return getattr(owner, name)
    raise InvalidData(f"columns: unknown column; it names a result, like contact[0].left.x; '{name}'")


def row(task):
    """Returns the results of one problem, and its failed condition or the reason why it is no problem.

    This is a function of the module, so that other processes can run it.
    """
    base, changes, columns, options = task
    try:
        solution = base.with_(**changes).solve(**options)
    except InvalidData as invalid:
        return [np.nan] * len(columns), str(invalid)
    return [result(solution, column) for column in columns], solution.failed_condition


def column_of(values):
    """Returns an array of floats if all values are numbers, and of objects otherwise."""
    try:
        return np.array([value if isinstance(value, float) else float(Fraction(str(value))) for value in values])
    except (ValueError, ZeroDivisionError):
        array = np.empty(len(values), dtype=object)
        array[:] = values
        return array


def values_of(path, values):
    """Returns the values as a list. Raises InvalidData for a number, a text or a table.

    Python iterates over texts and tables, too, but they are no lists of values.
    """
    if isinstance(values, (str, bytes, Mapping)) or not isinstance(values, Iterable):
        raise InvalidData(f"vary: no list of values for {path}; each datum takes a list of them, like ['1', '2']; {values!r}")
    return list(values)


def changes_of(path, values):
    """Returns one dict of changed data for each value. Data that change together have a tuple of paths and of values."""
    paths = path if isinstance(path, tuple) else (path,)
    changes = []
    for value in values_of(path, values):
        row = value if isinstance(path, tuple) else (value,)
        if not isinstance(row, (tuple, list)) or len(row) != len(paths):
            raise InvalidData(f"vary: wrong number of values for {path}; data that change together have one value each; {row!r}")
        changes.append(dict(zip(paths, row)))
    return changes


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
        "singular_points.size", "method". The uniqueness and the largest stress are no columns here.
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
        If vary has no lists of values, or if a solved problem has no such column. A wrong path or a wrong option of solve()
        raises nothing: failed_condition has the reason in each row.

    Examples
    --------
    >>> import steadyslide as ss
    >>> p = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0")
    >>> ss.sweep(p, {"friction.values[1]": ["0.1", "0.5"]})["effective_friction"].round(4)
    array([0.1   , 0.2828])
    """
    columns = list(columns)
    if not vary:
        raise InvalidData("vary: no data; a sweep varies at least one; none")
    combinations = itertools.product(*(changes_of(path, values) for path, values in vary.items()))
    tasks = [(base, {path: value for change in changes for path, value in change.items()}, columns, options)
             for changes in combinations]
    if not tasks:
        raise InvalidData("vary: no values; each datum has at least one; none")
    if executor is None:
        with ThreadPoolExecutor(os.cpu_count()) as threads:
            rows = list(threads.map(row, tasks))
    else:
        rows = list(executor.map(row, tasks))
    data = {path: column_of([changes[path] for _, changes, _, _ in tasks]) for path in tasks[0][1]}
    digits = options.get("digits", 16)
    for k, column in enumerate(columns):
        values = [results[k] for results, _ in rows]
        numbers = not any(isinstance(value, str) for value in values) and not (isinstance(digits, int) and digits > 16)
        data[column] = np.array(values, dtype=float if numbers else object)
    data["failed_condition"] = np.array([failed for _, failed in rows], dtype=object)
    table = np.empty(len(rows), dtype=[(name, array.dtype) for name, array in data.items()])
    for name, array in data.items():
        table[name] = array
    return table
