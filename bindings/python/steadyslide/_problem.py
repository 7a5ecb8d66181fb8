"""The class Problem."""

import re
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from os import PathLike, fspath
from typing import Any

import numpy as np

from . import _core, _document
from ._core import InvalidData
from ._results import BothDirections, Exact, PossiblePoint, number_of
from ._solution import Solution


class Problem:
    """An exact contact problem. It cannot be changed.

    Parameters
    ----------
    load : number
        The load P > 0.
    poisson, young : number
        The material of the half-plane. Without `young` it is 1.
    plane : {"strain", "stress"}
        The state of the half-plane, by default "strain".
    gamma : number
        The coupling constant, instead of the material.
    sliding : {"+x", "-x"}
        The direction in which the indenter slides, by default "+x".
    load_at : number
        The place of the load, for an indenter that may tilt.
    friction : list of numbers, or (edges, values)
        One value more than there are jumps. As two arrays, values and the places between them; the two ends of the
        indenter may be edges, too.
    jumps : list of numbers
        The places at which the friction jumps.
    profile : text
        A polynomial of x, "x^2/2".
    pieces : list of (to, profile)
        The profile, piece by piece.
    samples : (x, heights), path or dict
        A measured profile: two arrays, or the name of a file, or {"file": ..., "x_unit": ..., ...}, where the file may be
        two arrays, too.
    support : [left, right]
        The ends of the indenter, by default [-1, 1].
    elastic : dict
        The material of the indenter, {"poisson": ..., "young": ...}.
    units : dict
        Names of units for the axes of pictures, {"length": "mm", "force": "N"}.
    layers : list of dict
        Layers from the surface down, {"thickness": ..., "young": ..., "poisson": ..., "below": "bonded" or "slip"}.
    base : {"elastic", "rigid"}
        What lies under the layers: the material of `poisson` and `young`, or a rigid body, which has none.
    symbol : text or path
        A table of symbols, rows k, W, gamma V, or the name of its file.
    period : number
        Contact repeats with this period.
    harmonics : list of dict
        A profile with the period, {"n": 1, "cos": ..., "sin": ...}.
    wear : dict
        Archard's coefficients, {"coefficients": one for each friction value or one for all, "body": ...}; see wear().

    Raises
    ------
    InvalidData
        If the data break a rule. For an array the message gives the index of the number.

    Notes
    -----
    All data are exact. Numbers are integers, fractions.Fraction, decimal.Decimal, texts such as "1/3" and floats; a float
    is the shortest decimal that gives it back. A number of mpmath has the digits of mpmath.mp.dps, a result of this module
    all its digits. A problem has one of profile, pieces, samples and harmonics.

    Examples
    --------
    >>> import steadyslide as ss
    >>> p = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0")
    >>> p.friction
    [Fraction(1, 10), Fraction(1, 2)]
    >>> layer = {"thickness": "0.2", "young": 1200, "poisson": "0.4"}
    >>> ss.Problem(load=1, base="rigid", layers=[layer], friction=["0.3"], profile="x^2/2").solve().contact[0].left.kind
    'free'
    >>> ss.Problem(load=3, poisson="0.48", young=1200, friction=([0], [0.1, 0.5]), samples=([-1, 0, 1], [0.1, 0, 0.1])).support
    (Fraction(-1, 1), Fraction(1, 1))
    """

    __slots__ = ("_core",)

    def __init__(self, load: Exact | None = None, poisson: Exact | None = None, young: Exact | None = None,
                 plane: str | None = None, gamma: Exact | None = None, sliding: str | None = None,
                 load_at: Exact | None = None, friction: Sequence[Any] | np.ndarray | None = None,
                 jumps: Sequence[Exact] | np.ndarray | None = None, profile: Exact | None = None,
                 pieces: Sequence[tuple[Exact, Exact]] | None = None,
                 samples: str | PathLike[str] | Sequence[Any] | np.ndarray | Mapping[str, Any] | None = None,
                 support: Sequence[Exact] | np.ndarray | None = None, elastic: Mapping[str, Exact] | None = None,
                 units: Mapping[str, str] | None = None, wear: Mapping[str, Any] | None = None,
                 layers: Sequence[Mapping[str, Any]] | None = None, base: str | None = None,
                 symbol: str | PathLike[str] | None = None, period: Exact | None = None,
                 harmonics: Sequence[Mapping[str, Any]] | None = None) -> None:
        if _document.is_pair(friction):
            if jumps is not None:
                raise InvalidData("friction.jumps: conflicting key; edges and values leave it out; present")
        else:
            friction = {"values": friction, "jumps": jumps}
        self._set({
            "load": load, "load_at": load_at, "sliding": sliding, "units": units,
            "half_space": {"poisson": poisson, "young": young, "plane": plane, "gamma": gamma, "layers": layers, "base": base,
                           "symbol": symbol, "period": period},
            "friction": friction,
            "indenter": {"support": support, "profile": profile, "pieces": pieces, "samples": samples,
                         "harmonics": harmonics, "elastic": elastic},
            "wear": wear})

    def _set(self, document, name=""):
        document, ends = _document.without_arrays(document)
        self._core = _core.Problem.from_text(_document.text_of(document), name)
        if ends and tuple(Fraction(_document.exact(end, "friction")) for end in ends) != self.support:
            left, right = self._core.support
            raise InvalidData(f"friction: edges are not the ends of the indenter; they lie between them, or reach from {left} "
                              f"to {right}; {ends[0]} to {ends[1]}")

    @classmethod
    def _of(cls, core):
        problem = object.__new__(cls)
        problem._core = core
        return problem

    @classmethod
    def from_toml(cls, path: str | PathLike[str]) -> "Problem":
        """Returns the problem of a problem file.

        Parameters
        ----------
        path : path
            The name of the file.

        Raises
        ------
        InvalidData
            "FILE:LINE: what is wrong; the rule; the value".
            It is raised, too, if a profile or a table of symbols that the problem names cannot be read.
        OSError
            If the problem file cannot be read: FileNotFoundError, with errno and filename, as of open().
        """
        return cls._of(_core.Problem.read(fspath(path)))

    @classmethod
    def from_string(cls, text: str, name: str = "") -> "Problem":
        """Returns the problem of the text of a problem file.

        Parameters
        ----------
        text : str
            The text.
        name : str
            The name of the file in messages. A measured profile is searched in its folder.

        Raises
        ------
        InvalidData
            If the text breaks a rule.
        """
        return cls._of(_core.Problem.from_text(_document.text(text, "text"), str(name)))

    @property
    def text(self) -> str:
        """The problem file of this problem. It contains the arrays, too."""
        return self._core.text

    @property
    def name(self) -> str:
        """The name of the file that the problem was read from; empty without a file."""
        return self._core.name

    @property
    def load(self) -> Fraction:
        """The load, exact."""
        return Fraction(self._core.load)

    @property
    def friction(self) -> list[Fraction]:
        """The friction values from left to right, exact."""
        return [Fraction(value) for value in self._core.friction]

    @property
    def jumps(self) -> list[Fraction]:
        """The places at which the friction jumps, exact."""
        return [Fraction(place) for place in self._core.jumps]

    @property
    def support(self) -> tuple[Fraction, Fraction]:
        """The left and the right end of the indenter, exact."""
        left, right = self._core.support
        return Fraction(left), Fraction(right)

    def with_(self, **changes: Any) -> "Problem":
        """Returns a problem with some data changed.

        Parameters
        ----------
        **changes
            New data. The keywords are their paths in a problem file. None removes a datum, and does nothing if the datum
            is absent. Samples and friction may be pairs of arrays, pieces pairs (to, profile), as in Problem.

        Raises
        ------
        InvalidData
            If a path names no datum, or if the new data break a rule.

        Examples
        --------
        >>> import steadyslide as ss
        >>> p = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0")
        >>> p.with_(load=2, **{"friction.values[1]": "0.3"}).friction
        [Fraction(1, 10), Fraction(3, 10)]
        """
        document = tomllib.loads(self.text, parse_float=str)
        for path, value in changes.items():
            _document.changed(document, path, value)
        problem = object.__new__(Problem)
        try:
            problem._set(document, self.name)
        except InvalidData as invalid:  # its line would be one of the new text
            raise InvalidData(re.sub(rf"^{re.escape(self.name)}:\d+: ", "", str(invalid)) if self.name else str(invalid)) from None
        return problem

    def solve(self, digits: int = 16, method: str = "auto", cells: int | None = None, iterations: int | None = None,
              accuracy: float | None = None, over: Exact | None = None, start: Solution | None = None) -> Solution:
        """Solves the problem. A solve that does not converge raises nothing: see Solution.solved.

        Parameters
        ----------
        digits : int
            1 to 100. More than 16 give mpmath numbers.
        method : {"auto", "closed-form", "riemann-hilbert", "variational"}
            The method.
        cells, iterations : int
            The number of cells of the variational method, and the largest number of its steps on each mesh.
        accuracy : float
            The wanted relative error of ends and resultants: more and more cells on the contact, until it is reached.
            A measured profile on cells has 1e-3 unless cells or accuracy is given.
        over : number
            The length of a window: the solution has the largest mean pressure over such a window, largest_average.
        start : Solution
            The solution of a neighbouring problem. The Riemann-Hilbert method starts from it, and is then faster. It is not
            used if it is not solved, or if its precision is another one.

        Returns
        -------
        Solution
            The solution, or the best state that was reached.

        Raises
        ------
        InvalidData
            If an option is out of range, or if the chosen method does not apply.

        Examples
        --------
        >>> import steadyslide as ss
        >>> s = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0").solve()
        >>> round(s.effective_friction, 6), s.effective_friction.error < 1e-12
        (0.282808, True)
        """
        if start is not None and not isinstance(start, Solution):
            raise InvalidData(f"start: wrong type; it is a Solution; {type(start).__name__}")
        options = {"digits": _document.whole(digits, "digits"), "method": _document.text(method, "method"),
                   "cells": _document.optional(_document.whole, cells, "cells"),
                   "iterations": _document.optional(_document.whole, iterations, "iterations"),
                   "accuracy": _document.optional(_document.real, accuracy, "accuracy"),
                   "over": _document.optional(_document.exact, over, "over")}
        return Solution(self, options, start)

    def solve_both_directions(self, **options: Any) -> BothDirections:
        """Solves the problem as it is, and with the indenter sliding the other way.

        Parameters
        ----------
        **options
            Those of solve().

        Returns
        -------
        BothDirections
            as_given and opposite, two solutions.

        Examples
        --------
        >>> import steadyslide as ss
        >>> p = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0")
        >>> [round(s.effective_friction, 5) for s in p.solve_both_directions()]
        [0.28281, 0.31593]
        """
        given = tomllib.loads(self.text).get("sliding", "+x")
        turned = self.with_(sliding="-x" if given == "+x" else "+x")
        return BothDirections(*(problem.solve(**options) for problem in (self, turned)))

    def load_steps(self, loads: Iterable[Exact], **options: Any) -> list[Solution]:
        """Solves the problem for one load after the other. Each solve starts from the one before.

        Parameters
        ----------
        loads : list of numbers
            The loads.
        **options
            Those of solve() but start.

        Returns
        -------
        list of Solution
            One for each load.

        Raises
        ------
        InvalidData
            If a load is not positive, if the loads are a text, and as solve() does.

        Examples
        --------
        >>> import steadyslide as ss
        >>> p = ss.Problem(load=1, poisson="0.2", friction=["0.3"], pieces=[(0, "-x"), (1, "x")])
        >>> [len(s.contact) for s in p.load_steps(["0.1", "0.2"])]
        [1, 1]
        """
        if isinstance(loads, str):
            raise InvalidData(f"loads: wrong type; they are a list of numbers; {loads!r}")
        if "start" in options:
            raise InvalidData("start: conflicting option; each solve starts from the one before; start")
        steps: list[Solution] = []
        for load in loads:
            steps.append(self.with_(load=load).solve(**options, start=steps[-1] if steps else None))
        return steps

    def exponents(self, digits: int = 16) -> list[PossiblePoint]:
        """Returns the places where the traction can be singular, with the exponents.

        Parameters
        ----------
        digits : int
            1 to 100.

        Returns
        -------
        list of PossiblePoint
            From left to right.

        Raises
        ------
        InvalidData
            If digits is out of range.
        """
        digits = _document.whole(digits, "digits")
        return [PossiblePoint(x, kind, side, number_of(exponent, digits), symbolic)
                for x, kind, side, exponent, symbolic in _core.exponents(self._core, digits)]

    def derivation(self) -> str:
        """Returns the derivation of the exponents, step by step, and of the closed form if there is one."""
        return _core.derivation(self._core)

    def __repr__(self):
        text = self.name or ", ".join(self.text.split(chr(10))[:-1])
        return f"<steadyslide.Problem {text if len(text) <= 500 else text[:500] + '...'}>"

    def __eq__(self, other):
        return isinstance(other, Problem) and (self.text, self.name) == (other.text, other.name)

    def __hash__(self):
        return hash((self.text, self.name))

    def __reduce__(self):
        return Problem.from_string, (self.text, self.name)
