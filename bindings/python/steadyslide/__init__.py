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
InvalidData.__doc__ = "Data that break a rule. The message says what is wrong, the rule, and the value."


class Number(float):
    """A float with its estimated absolute error. The result of arithmetic with it is a float without an error."""

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
    """A place where the traction is singular: p ~ stress_intensity (2 pi d)^exponent, d the distance from it.

    The exponent of a logarithm is None. A stress intensity is None if there is no contact on its side.
    """

    x: Number
    kind: str
    exponent: Number | None
    symbolic: str
    intensity: Number
    constant: Number
    stress_intensity_left: Number | None
    stress_intensity_right: Number | None


class UnresolvedGap(NamedTuple):
    """A gap over a notch of the profile. It is too short to contain a number of the precision.

    The solution shows contact there. log10_length is the decimal logarithm of its length, an order of magnitude.
    """

    x: Number
    log10_length: float


class PossiblePoint(NamedTuple):
    """A place where the traction can be singular, for any contact set. x is empty if it can be any place."""

    x: str
    kind: str
    side: str
    exponent: Number | None
    symbolic: str


class LargestPressure(NamedTuple):
    """The largest pressure and its place. If the pressure is infinite there, value is inf, and exponent is its power."""

    value: Number
    x: Number
    exponent: Number | None


class Interval(NamedTuple):
    """An interval of x, from its left end to its right end."""

    left: Number
    right: Number


class Resultants(NamedTuple):
    """The quantities of the whole contact. A quantity is None if the solution has no such number."""

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
    largest_average: Number | None
    largest_average_at: Number | None
    core: Interval | None


for _key, (_, _, _unit, _meaning) in zip(Resultants._fields, _core.quantities):
    getattr(Resultants, _key).__doc__ = f"{_meaning} ({_unit})"


class Sample(NamedTuple):
    """All quantities at one place of the surface. Pairs are the limits from the left and from the right."""

    traction: tuple[Number, Number]
    shear: tuple[Number, Number]
    gap: Number | None
    slope: tuple[Number, Number]
    displacement: Number
    shear_slope: tuple[Number, Number]
    cumulative_load: Number


class Stress(NamedTuple):
    """Stresses at points of the body, and the gradient of the displacement.

    If the problem gives gamma instead of materials, yy, mean, von_mises and the gradient are None.
    """

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
    """Arrays with one force for each node: the normal force along +z, into the body, and the tangential one along +x.

    The other two arrays are their errors.
    """

    normal: np.ndarray
    tangential: np.ndarray
    normal_error: np.ndarray
    tangential_error: np.ndarray


class Proof:
    """The result of a proof in ball arithmetic.

    reason says why nothing is proved, and is empty if the solution is proved. certificate is JSON, and empty if nothing is
    proved. unresolved_gaps are those of the certified solution.
    """

    def __init__(self, proved: bool, reason: str, certificate: str, unresolved_gaps: list[UnresolvedGap]) -> None:
        self.proved = proved
        self.reason = reason
        self.certificate = certificate
        self.unresolved_gaps = unresolved_gaps

    def __repr__(self):
        return "<steadyslide.Proof: proved>" if self.proved else f"<steadyslide.Proof: not proved: {self.reason}>"

    def save(self, path: str | PathLike[str]) -> None:
        """Writes the certificate to a file, for steadyslide-check. Raises RuntimeError if there is no certificate."""
        if not self.certificate:
            raise RuntimeError(f"{path}: no certificate; {self.reason}")
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.certificate)


class Problem:
    """An exact contact problem. It cannot be changed.

    The keywords are the data of a problem file:

    load: P > 0.
    load_at: the place of the load, for an indenter that may tilt.
    poisson, young, plane: the material, and "strain" or "stress"; or gamma instead of all three.
    sliding: "+x" or "-x".
    friction: one value more than there are jumps.
    jumps: the places at which the friction jumps.
    profile, pieces or samples: the indenter, "x^2/2", or [(to, profile), ...], or the file of a measured profile, which may
    also be a table {"file": ..., "x_unit": ..., ...}.
    support: [left, right].
    elastic: {"poisson": ..., "young": ...}, the material of the indenter.

    Raises InvalidData.
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
        """Reads a problem file. Raises InvalidData "FILE:LINE: what is wrong; the rule; the value".

        Raises OSError if the file cannot be read.
        """
        return cls._of(_core.Problem.read(str(path)))

    @classmethod
    def from_string(cls, text: str, name: str = "") -> "Problem":
        """Reads the text of a problem file. A measured profile is searched in the folder of `name`. Raises InvalidData."""
        return cls._of(_core.Problem.from_text(text, str(name)))

    @property
    def text(self) -> str:
        """The problem file of this problem."""
        return self._core.text

    @property
    def name(self) -> str:
        """The name of the file that the problem was read from; empty without a file."""
        return self._core.name

    def with_(self, **changes: Any) -> "Problem":
        """Returns a problem with some data changed. The keywords are their paths in a problem file.

        with_(**{"friction.values[1]": "0.3"}) changes the second friction value. Raises InvalidData.
        """
        document = tomllib.loads(self.text, parse_float=str)
        for path, value in changes.items():
            _document.changed(document, path, value)
        problem = object.__new__(Problem)
        problem._set(document, self.name)
        return problem

    def solve(self, digits: int = 16, method: str = "auto", cells: int | None = None) -> "Solution":
        """Solves the problem, and returns a Solution. A solve that does not converge raises nothing: see Solution.solved.

        digits: 1 to 100. method: auto, closed-form, riemann-hilbert or variational. cells: number of cells of the
        variational method. Raises InvalidData if an option is out of range, or if the chosen method does not apply.
        """
        return Solution(self, digits, method, cells)

    def exponents(self, digits: int = 16) -> list[PossiblePoint]:
        """Returns the places where the traction can be singular, with the exponents: a list of PossiblePoint.

        Raises InvalidData unless digits is 1 to 100.
        """
        return [PossiblePoint(x, kind, side, _number(exponent, digits), symbolic)
                for x, kind, side, exponent, symbolic in _core.exponents(self._core, digits)]

    def derivation(self) -> str:
        """Returns the derivation of the exponents, step by step, and of the closed form if there is one."""
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
    """Converts the library's (value, error, digits) to a Number, or to an mpmath number beyond 16 digits."""
    if number is None:
        return None
    value, error, text = number
    if digits <= 16:
        return Number(value, error)
    from ._mp import Number as MpNumber
    return MpNumber(text, error)


class Solution:
    """A solved problem, or the best state that the method reached. Numbers have errors: s.effective_friction.error.

    If a function of x has two different limits at a place, traction(x), shear(x), gap(x) and slope(x) return the one of
    larger size; at(x) returns both.
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
    largest_average: Number | None
    largest_average_at: Number | None
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
        """Converts each (value, error, digits) inside `value` to a number."""
        if isinstance(value, tuple) and len(value) == 3 and isinstance(value[2], str) and isinstance(value[0], float):
            return _number(value, self.digits)
        if isinstance(value, (tuple, list)):
            return type(value)(self._numbers(one) for one in value)
        return value

    @property
    def digits(self) -> int:
        """The digits that solve() was called with."""
        return self._options[0]

    @property
    def method(self) -> str:
        """closed-form, riemann-hilbert or variational."""
        return self._core.method

    @property
    def solved(self) -> bool:
        """True if all conditions of the problem hold."""
        return not self.failed_condition

    @property
    def failed_condition(self) -> str:
        """The violated condition in words; empty if solved."""
        return self._core.failed_condition

    @property
    def warnings(self) -> list[str]:
        """The warnings of the command solve, a list of lines. Read them before you use the solution."""
        return self._core.warnings()

    @property
    def contact(self) -> list[Contact]:
        """The contact components from left to right, a list of Contact."""
        return [Contact(ContactEnd(*left), ContactEnd(*right), width, load)
                for left, right, width, load in self._numbers(self._core.contact())]

    @property
    def singular_points(self) -> list[SingularPoint]:
        """The places where the traction is singular, from left to right, a list of SingularPoint."""
        return [SingularPoint(*point) for point in self._numbers(self._core.singular_points())]

    @property
    def unresolved_gaps(self) -> list[UnresolvedGap]:
        """The gaps that are too short for the precision, from left to right, a list of UnresolvedGap."""
        return self._gaps(self._core.unresolved_gaps())

    def _gaps(self, gaps):
        return [UnresolvedGap(*gap) for gap in self._numbers(gaps)]

    @property
    def resultants(self) -> Resultants:
        """All quantities of the whole contact: Resultants. Each of them is also an attribute of the solution.

        Each attribute computes all of them. If you need several, read resultants once.
        """
        made = {"Largest": LargestPressure, "Interval": Interval}
        values = self._numbers(self._core.resultants())
        return Resultants(*(made[kind](*value) if kind in made and value is not None else value
                            for (kind, _, _, _), value in zip(_core.quantities, values)))

    def at(self, x: Exact) -> Sample:
        """Returns all quantities at one place: a Sample. Raises InvalidData if x is not a number."""
        return Sample(*self._numbers(self._core.at(_document.exact(x, "x"))))

    def traction(self, x: Places, errors: bool = False) -> Values:
        """Returns the normal traction t <= 0 at x: a number, or an array if x is one. With errors=True: (values, errors).

        Raises InvalidData if a place is not a number.
        """
        return self._at_places("traction", x, errors)

    def shear(self, x: Places, errors: bool = False) -> Values:
        """Returns the tangential traction along +x, in the form of traction()."""
        return self._at_places("shear", x, errors)

    def gap(self, x: Places, errors: bool = False) -> Values:
        """Returns the gap, nan outside the support, in the form of traction()."""
        return self._at_places("gap", x, errors)

    def slope(self, x: Places, errors: bool = False) -> Values:
        """Returns the slope u' of the surface, in the form of traction()."""
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
        """Returns a Stress at points of the body: numbers, or arrays if x or z is one. With errors=True: (values, errors).

        z > 0 is the depth. The errors are a Stress, too. Raises InvalidData if x or z is not a number, if z <= 0, or if z
        is too small for 16 digits.
        """
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
        """Returns the consistent nodal forces of the tractions on a mesh of the surface: NodalForces.

        order=1: linear elements between the nodes. order=2: quadratic elements; every second node is in the middle of its
        element. Raises InvalidData if the mesh is invalid, or if the contact reaches beyond the mesh.
        """
        texts = [_document.exact(node, f"nodes[{k}]") for k, node in enumerate(np.asarray(nodes).ravel().tolist())]
        normal, tangential = zip(*self._numbers(self._core.nodal_forces(texts, order)))
        return NodalForces(*(self._array(list(forces), (len(texts),)) for forces in (normal, tangential)),
                           *(np.array([n.error for n in forces]) for forces in (normal, tangential)))

    def certify(self) -> Proof:
        """Tries to prove the solution in ball arithmetic, and returns a Proof with a certificate for steadyslide-check.

        This takes about ten times as long as a solve.
        """
        proved, reason, certificate, gaps = self._core.certify()
        return Proof(proved, reason, certificate, self._gaps(gaps))

    def plot(self, ax: Any = None) -> Any:
        """Draws pressure and shear over x, and marks the singular points. Returns matplotlib's axes.

        ax: the axes to draw on; new ones by default.
        """
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
    """Solves every combination of varied data. Returns a numpy structured array with one row for each combination.

    The first varied datum changes slowest. The columns are the varied data, the results in `columns`, and
    failed_condition, which is empty if the problem was solved.

    vary: {"friction.values[1]": ["0.1", "0.2"], ...}, paths in a problem file.
    columns: names of results, "load_share[0]", "contact[0].left.x", "largest_pressure.value".
    executor: one of concurrent.futures; by default threads, one for each core.

    Raises InvalidData if vary or columns is wrong. A combination that is no valid problem is a row with the reason in
    failed_condition.
    """
    from ._sweep import sweep as run
    return run(base, vary, columns, executor, digits, method, cells)
