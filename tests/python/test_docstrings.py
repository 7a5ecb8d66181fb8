"""Docstrings follow numpydoc, and their examples are right."""

import doctest
import inspect

import pytest
import steadyslide as ss

PUBLIC = [ss.Problem, ss.Solution, ss.sweep] + [
    method for kind in (ss.Problem, ss.Solution) for name, method in inspect.getmembers(kind, callable) if not name.startswith("_")]


@pytest.mark.parametrize("one", PUBLIC, ids=lambda one: one.__qualname__)
def test_parameters_are_described(one):
    names = [name for name in inspect.signature(one).parameters if name not in ("self", "cls")]
    if one.__doc__.rstrip(".").endswith("in the form of traction()"):
        return
    section = one.__doc__.partition("Parameters\n")[2].partition("\n\n")[0]
    described = [name.strip(" *") for line in section.splitlines() if line and not line.startswith(" " * 12)
                 for name in line.partition(" : ")[0].split(",")]
    if one is ss.Solution:  # Problem.solve() makes solutions
        return
    assert [name for name in names if name not in described] == []


def test_examples():
    runner, finder = doctest.DocTestRunner(), doctest.DocTestFinder(exclude_empty=True)
    found = [test for kind in (ss.Problem, ss.Solution, ss.sweep) for test in finder.find(kind, kind.__name__)]
    for test in found:
        runner.run(test)
    assert runner.failures == 0 and runner.tries > 20
