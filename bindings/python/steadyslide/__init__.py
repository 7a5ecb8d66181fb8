"""Steady sliding contact of an indenter on an elastic half-plane whose friction coefficient jumps.

    import steadyslide as ss
    p = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0")
    s = p.solve()                       # digits=50 gives mpmath numbers
    s.effective_friction, s.traction([-0.5, 0.5])

Data are exact: integers, fractions.Fraction, decimal.Decimal, strings ("0.1", "1/3"); a float is the decimal that it
prints. Bad data raise InvalidData, a ValueError, with the command line's text. A solve that does not converge raises
nothing: Solution.solved, Solution.failed_condition. Signs and units are those of the command line: traction <= 0, stresses
positive in tension, z > 0 the depth. Objects may be shared by threads, which run side by side while they solve.
"""

import tomllib
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import Executor
from decimal import Decimal
from fractions import Fraction
from os import PathLike
from typing import Any, NamedTuple

import numpy as np

from . import _core, _document
from ._core import InvalidData, __version__

__all__ = ["Contact", "ContactEnd", "Interval", "InvalidData", "LargestPressure", "NodalForces", "Number", "PossiblePoint", "Problem",
           "Proof", "Resultants", "Sample", "SingularPoint", "Solution", "Stress", "UnresolvedGap", "__version__",
           "sweep"]

Exact = str | int | float | Fraction | Decimal
Places = Exact | Sequence[Any] | np.ndarray
Values = Any  # a Number for a number, an array for an array

InvalidData.__module__ = __name__
InvalidData.__doc__ = "Data that break a rule: what is wrong; the rule; the value."


class Number(float):
    """A float with its estimated absolute error; what is calculated with it has none."""

    error: float

    def __new__(cls, value: float, error: float) -> "Number":
        number = float.__new__(cls, value)
        number.error = error
        return number

    def __reduce__(self):
        return Number, (float(self), self.error)


ContactEnd = NamedTuple("ContactEnd", [("x", Number), ("kind", str), ("exponent", Number), ("intensity", Number)])
Contact = NamedTuple("Contact", [("left", ContactEnd), ("right", ContactEnd), ("width", Number), ("load", Number)])


class SingularPoint(NamedTuple):
    """Where the traction is singular; exponent None: a logarithm. p ~ stress_intensity (2 pi d)^exponent."""

    x: Number
    kind: str
    exponent: Number | None
    symbolic: str
    intensity: Number
    constant: Number
    stress_intensity_left: Number | None
    stress_intensity_right: Number | None


class UnresolvedGap(NamedTuple):
    """A gap over a notch that is too short for any place in it to have a number: a solution has contact there."""

    x: Number
    log10_length: float


class PossiblePoint(NamedTuple):
    """Where the traction can be singular; x empty: anywhere."""

    x: str
    kind: str
    side: str
    exponent: Number | None
    symbolic: str


class LargestPressure(NamedTuple):
    """inf where it is singular, with the exponent that it has there."""

    value: Number
    x: Number
    exponent: Number | None


class Interval(NamedTuple):
    """From left to right."""

    left: Number
    right: Number


class Resultants(NamedTuple):
    """The numbers of the whole contact; None: the solution has no such number."""

    normal: Number
    friction_force: Number
    centre_of_pressure: Number
    effective_friction: Number
    load_share: list[Number]
    contact_width: Number
    real_contact_length: Number
    mean_pressure: Number
    largest_pressure: LargestPressure
    components: int
    tilt: Number | None
    core: Interval | None


for _key, (_, _, _unit, _meaning) in zip(Resultants._fields, _core.quantities):
    getattr(Resultants, _key).__doc__ = f"{_meaning} ({_unit})"


class Sample(NamedTuple):
    """All that is known of a place of the surface; pairs are the limits from left and right."""

    traction: tuple[Number, Number]
    shear: tuple[Number, Number]
    gap: Number | None
    slope: tuple[Number, Number]
    displacement: Number
    shear_slope: tuple[Number, Number]
    cumulative_load: Number


class Stress(NamedTuple):
    """Stresses and the displacement's gradient; None without Poisson's ratio. errors: a Stress of errors, or None."""

    xx: Values
    zz: Values
    xz: Values
    yy: Values | None
    mean: Values | None
    von_mises: Values | None
    largest_shear: Values
    ux_x: Values | None
    ux_z: Values | None
    uz_x: Values | None
    uz_z: Values | None


class NodalForces(NamedTuple):
    """Of each node: normal along +z, into the body, tangential along +x."""

    normal: np.ndarray
    tangential: np.ndarray
    normal_error: np.ndarray
    tangential_error: np.ndarray


class Proof:
    """What is proved of a solution in ball arithmetic."""

    def __init__(self, proved: bool, reason: str, certificate: str, unresolved_gaps: list[UnresolvedGap]) -> None:
        self.proved = proved
        self.reason = reason
        self.certificate = certificate
        self.unresolved_gaps = unresolved_gaps

    def __repr__(self):
        return "<steadyslide.Proof: proved>" if self.proved else f"<steadyslide.Proof: not proved: {self.reason}>"

    def save(self, path: str | PathLike[str]) -> None:
        """Writes the certificate, for steadyslide-check; raises RuntimeError if nothing is proved."""
        if not self.certificate:
            raise RuntimeError(f"{path}: no certificate; {self.reason}")
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.certificate)


class Problem:
    """A contact problem, exact; it cannot be changed.

    The keywords are a problem file's data: load; poisson, young and plane ("strain" or "stress"), or gamma; sliding ("+x"
    or "-x"); load_at, where the load acts on an indenter that may tilt; friction, one value more than jumps; one of profile
    ("x^2/2"), pieces ([(to, profile), ...]) and samples (a trace's file); support ([left, right]); elastic
    ({"poisson": ..., "young": ...}), the indenter's material.
    """

    __slots__ = ("_core",)

    def __init__(self, load: Exact | None = None, poisson: Exact | None = None, young: Exact | None = None,
                 plane: str | None = None, gamma: Exact | None = None, sliding: str | None = None,
                 load_at: Exact | None = None, friction: Sequence[Exact] | None = None, jumps: Sequence[Exact] | None = None,
                 profile: Exact | None = None, pieces: Sequence[tuple[Exact, Exact]] | None = None,
                 samples: str | Mapping[str, Any] | None = None, support: Sequence[Exact] | None = None,
                 elastic: Mapping[str, Exact] | None = None) -> None:
        if isinstance(pieces, (list, tuple)):
            pieces = [dict(zip(("to", "profile"), piece)) if isinstance(piece, (list, tuple)) else piece for piece in pieces]
        self._set({
            "load": load, "load_at": load_at, "sliding": sliding,
            "half_space": {"poisson": poisson, "young": young, "plane": plane, "gamma": gamma},
            "friction": {"values": friction, "jumps": jumps},
            "indenter": {"support": support, "profile": profile, "pieces": pieces, "samples": samples, "elastic": elastic}})

    def _set(self, document, name=""):
        self._core = _core.Problem.from_text(_document.text_of(document), name)

    @classmethod
    def _of(cls, core):
        problem = object.__new__(cls)
        problem._core = core
        return problem

    @classmethod
    def from_toml(cls, path: str | PathLike[str]) -> "Problem":
        """Reads a problem file. Raises InvalidData "FILE:LINE: what is wrong; the rule; the value", OSError."""
        return cls._of(_core.Problem.read(str(path)))

    @classmethod
    def from_string(cls, text: str, name: str = "") -> "Problem":
        """The text of a problem file; samples are looked for beside `name`."""
        return cls._of(_core.Problem.from_text(text, str(name)))

    @property
    def text(self) -> str:
        """The problem file that says the same."""
        return self._core.text

    @property
    def name(self) -> str:
        """The file that it was read from; empty without one."""
        return self._core.name

    def with_(self, **changes: Any) -> "Problem":
        """The problem with some data changed, by their paths in a problem file: with_(**{"friction.values[1]": "0.3"})."""
        document = tomllib.loads(self.text, parse_float=str)
        for path, value in changes.items():
            _document.changed(document, path, value)
        problem = object.__new__(Problem)
        problem._set(document, self.name)
        return problem

    def solve(self, digits: int = 16, method: str = "auto", cells: int | None = None) -> "Solution":
        """Solves it: digits from 1 to 100; method auto, closed-form, riemann-hilbert or variational, the last on so many
        cells. Raises InvalidData for options out of range and for a method that does not apply."""
        return Solution(self, digits, method, cells)

    def exponents(self, digits: int = 16) -> list[PossiblePoint]:
        """Where the traction can be singular, and with which exponent: a list of PossiblePoint."""
        return [PossiblePoint(x, kind, side, _number(exponent, digits), symbolic)
                for x, kind, side, exponent, symbolic in _core.exponents(self._core, digits)]

    def derivation(self) -> str:
        """How the exponents come about, step by step, and the closed form where there is one."""
        return _core.derivation(self._core)

    def __repr__(self):
        return f"<steadyslide.Problem {self.name or ', '.join(self.text.split(chr(10))[:-1])}>"

    def __eq__(self, other):
        return isinstance(other, Problem) and (self.text, self.name) == (other.text, other.name)

    def __hash__(self):
        return hash((self.text, self.name))

    def __reduce__(self):
        return Problem.from_string, (self.text, self.name)


def _number(number, digits):
    """What the library's (value, error, digits) is in Python."""
    if number is None:
        return None
    value, error, text = number
    if digits <= 16:
        return Number(value, error)
    from ._mp import Number as MpNumber
    return MpNumber(text, error)


class Solution:
    """A solved problem, or the best state that was reached. Numbers have their error: s.effective_friction.error.

    Where functions of x have different limits on both sides, the larger one is told; at(x) has both.
    """

    # Each resultant is also a property; they are set below the class.
    normal: Number
    friction_force: Number
    centre_of_pressure: Number
    effective_friction: Number
    load_share: list[Number]
    contact_width: Number
    real_contact_length: Number
    mean_pressure: Number
    largest_pressure: LargestPressure
    components: int
    tilt: Number | None
    core: Interval | None

    def __init__(self, problem: Problem, digits: int = 16, method: str = "auto", cells: int | None = None) -> None:
        try:
            self._core = _core.solve(problem._core, digits, method, cells)
        except TypeError:
            raise InvalidData("digits and cells are whole numbers, the method is a string; "
                              f"digits = {digits!r}, method = {method!r}, cells = {cells!r}") from None
        self._options = (digits, method, cells)
        #: the Problem
        self.problem = problem

    def _numbers(self, value):
        """All (value, error, digits) inside as numbers."""
        if isinstance(value, tuple) and len(value) == 3 and isinstance(value[2], str) and isinstance(value[0], float):
            return _number(value, self.digits)
        if isinstance(value, (tuple, list)):
            return type(value)(self._numbers(one) for one in value)
        return value

    @property
    def digits(self) -> int:
        """The digits that were asked for."""
        return self._options[0]

    @property
    def method(self) -> str:
        """closed-form, riemann-hilbert or variational."""
        return self._core.method

    @property
    def solved(self) -> bool:
        """Do all conditions hold?"""
        return not self.failed_condition

    @property
    def failed_condition(self) -> str:
        """What is violated, in words; empty where solved."""
        return self._core.failed_condition

    @property
    def warnings(self) -> list[str]:
        """What a person should know before it is used: the warnings of the command solve, a list of lines."""
        return self._core.warnings()

    @property
    def contact(self) -> list[Contact]:
        """The contact's components, left to right: a list of Contact."""
        return [Contact(ContactEnd(*left), ContactEnd(*right), width, load)
                for left, right, width, load in self._numbers(self._core.contact())]

    @property
    def singular_points(self) -> list[SingularPoint]:
        """A list of SingularPoint, left to right."""
        return [SingularPoint(*point) for point in self._numbers(self._core.singular_points())]

    @property
    def unresolved_gaps(self) -> list[UnresolvedGap]:
        """A list of UnresolvedGap, left to right; log10_length is an order of magnitude."""
        return self._gaps(self._core.unresolved_gaps())

    def _gaps(self, gaps):
        return [UnresolvedGap(*gap) for gap in self._numbers(gaps)]

    @property
    def resultants(self) -> Resultants:
        """Forces, widths, the largest pressure, shares of the load: Resultants. Each of them is an attribute, too."""
        made = {"Largest": LargestPressure, "Interval": Interval}
        values = self._numbers(self._core.resultants())
        return Resultants(*(made[kind](*value) if kind in made and value is not None else value
                            for (kind, _, _, _), value in zip(_core.quantities, values)))

    def at(self, x: Exact) -> Sample:
        """All that is known of one place: a Sample."""
        return Sample(*self._numbers(self._core.at(_document.exact(x, "x"))))

    def traction(self, x: Places, errors: bool = False) -> Values:
        """t <= 0 at x, a number or an array of them; with errors: (values, errors)."""
        return self._at_places("traction", x, errors)

    def shear(self, x: Places, errors: bool = False) -> Values:
        """The tangential traction along +x, as traction()."""
        return self._at_places("shear", x, errors)

    def gap(self, x: Places, errors: bool = False) -> Values:
        """The gap, nan outside the support, as traction()."""
        return self._at_places("gap", x, errors)

    def slope(self, x: Places, errors: bool = False) -> Values:
        """u', as traction()."""
        return self._at_places("slope", x, errors)

    def _at_places(self, what, x, errors):
        places = np.asarray(x)
        if self.digits <= 16 and places.ndim > 0 and places.dtype.kind in "fiu" and not errors:
            return getattr(self._core, what)(places.ravel()).reshape(places.shape)
        texts = [_document.exact(one, "x") for one in places.ravel().tolist()] if places.ndim > 0 else [_document.exact(x, "x")]
        numbers = self._numbers(getattr(self._core, "each_" + what)(texts))
        values = self._array(numbers, places.shape)
        return (values, np.array([float(n.error) for n in numbers]).reshape(places.shape)[()]) if errors else values

    def _array(self, numbers, shape):
        if not shape:
            return numbers[0]
        array = np.empty(len(numbers), dtype=float if self.digits <= 16 else object)
        array[:] = numbers
        return array.reshape(shape)

    def stress(self, x: Places, z: Places, errors: bool = False) -> Any:
        """At points of the body, z > 0, numbers or arrays: a Stress; with errors: (values, errors)."""
        if self.digits <= 16:
            points, depths = np.broadcast_arrays(_floats(x, "x"), _floats(z, "z"))
            parts = self._core.stresses(points.ravel(), depths.ravel())
            values, wrong = ([None if part is None else part[k].reshape(points.shape)[()] for part in parts] for k in (0, 1))
        else:
            points, depths = np.broadcast_arrays(np.asarray(x, dtype=object), np.asarray(z, dtype=object))
            states = [self._numbers(self._core.stress(_document.exact(a, "x"), _document.exact(b, "z")))
                      for a, b in zip(points.ravel(), depths.ravel())]
            parts = list(zip(*states))
            values = [None if part[0] is None else self._array(list(part), points.shape) for part in parts]
            wrong = [None if part[0] is None else np.array([n.error for n in part]).reshape(points.shape)[()] for part in parts]
        return (Stress(*values), Stress(*wrong)) if errors else Stress(*values)

    def nodal_forces(self, nodes: Places, order: int = 1) -> NodalForces:
        """Consistent nodal forces of the tractions on a mesh of the surface: NodalForces. order=2: quadratic elements, every
        second node in the middle of one. Raises InvalidData where contact reaches beyond the mesh."""
        texts = [_document.exact(node, f"nodes[{k}]") for k, node in enumerate(np.asarray(nodes).ravel().tolist())]
        normal, tangential = zip(*self._numbers(self._core.nodal_forces(texts, order)))
        return NodalForces(*(self._array(list(forces), (len(texts),)) for forces in (normal, tangential)),
                           *(np.array([n.error for n in forces]) for forces in (normal, tangential)))

    def certify(self) -> Proof:
        """Proves it in ball arithmetic, with a certificate for steadyslide-check: a Proof. Ten times a solve."""
        proved, reason, certificate, gaps = self._core.certify()
        return Proof(proved, reason, certificate, self._gaps(gaps))

    def plot(self, ax: Any = None) -> Any:
        """Pressure and shear over x, with singular points marked, on matplotlib's axes, which are returned."""
        from . import _plot
        return _plot.plot(self, ax)

    def __repr__(self):
        state = f"effective friction {float(self.effective_friction):.6g}" if self.solved else self.failed_condition
        return f"<steadyslide.Solution by {self.method}: {state}>"

    def __reduce__(self):
        # Solving again gives the same solution.
        return Solution, (self.problem, *self._options)


def _quantity(key):
    return property(lambda self: getattr(self.resultants, key), doc=getattr(Resultants, key).__doc__)


for _key in Resultants._fields:
    setattr(Solution, _key, _quantity(_key))


def _floats(values, field):
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        array = np.asarray(values, dtype=object)
        texts = [_document.exact(one, field) for one in array.ravel()]
        try:
            return np.array([float(Fraction(text)) for text in texts]).reshape(array.shape)
        except ValueError:
            raise InvalidData(f"{field}: not a number; a number is written like 2, -0.25, 1e-3 or 1/3; {texts[0]!r}") from None


def sweep(base: Problem, vary: Mapping[str, Sequence[Any]], columns: Iterable[str] = ("effective_friction",),
          executor: Executor | None = None, digits: int = 16, method: str = "auto", cells: int | None = None) -> np.ndarray:
    """Solves every combination of varied data: a numpy structured array with one row each, the first varied datum slowest.

    vary: {"friction.values[1]": ["0.1", "0.2"], ...}, paths as in a problem file. columns: names of results,
    "load_share[0]", "contact[0].left.x", "largest_pressure.value". The last column, failed_condition, is empty where
    solved. executor: any of concurrent.futures; by default threads, one a core.
    """
    from ._sweep import sweep as run
    return run(base, vary, columns, executor, digits, method, cells)
