"""The results of a solution."""

from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from os import PathLike
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _core

if TYPE_CHECKING:
    from ._solution import Solution

Exact = str | int | float | Fraction | Decimal
Places = Exact | Sequence[Any] | np.ndarray
Values = Any  # a Number for a number, an array for an array


class Number(float):
    """A float with its estimated absolute error. The result of arithmetic with it is a float without an error."""

    error: float

    def __new__(cls, value: float, error: float) -> "Number":
        number = float.__new__(cls, value)
        number.error = error
        return number

    def __reduce__(self):
        return Number, (float(self), self.error)


class ContactEnd(NamedTuple):
    """An end of a contact zone: its place, its kind, and p ~ intensity d^exponent at the distance d from it."""

    x: Number
    kind: str
    exponent: Number
    intensity: Number


class Contact(NamedTuple):
    """A contact zone: its ends, its width, and the part of the load that it carries."""

    left: ContactEnd
    right: ContactEnd
    width: Number
    load: Number


class SingularPoint(NamedTuple):
    """A place where the traction t is singular: -t ~ stress_intensity (2 pi d)^exponent - constant, d the distance from it.

    At a logarithm t ~ intensity log(d)/pi + constant; its exponent and stress intensities are None. A stress intensity is
    None, too, if there is no contact on its side. constant is 0 unless the indenter has a wedge at the place.
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
    approach: Number | None
    core: Interval | None


for _key, (_, _, _unit, _meaning) in zip(Resultants._fields, _core.quantities):
    getattr(Resultants, _key).__doc__ = f"{_meaning} ({_unit})"


class Sample(NamedTuple):
    """All quantities at one place of the surface. Pairs are the limits from the left and from the right.

    displacement is u, positive out of the body; slope is u', shear_slope u_t', the slope of the tangential displacement;
    cumulative_load is the load left of the place.
    """

    traction: tuple[Number, Number]
    shear: tuple[Number, Number]
    gap: Number | None
    slope: tuple[Number, Number]
    displacement: Number
    shear_slope: tuple[Number, Number]
    cumulative_load: Number


class Stress(NamedTuple):
    """Stresses at points of the body, and the gradient of the displacement.

    xx, zz, xz and yy are stresses, positive in tension. mean is a third of the trace, largest_shear half the difference of
    the principal stresses in the plane. ux_z is the derivative of u_x with respect to z. If the problem gives gamma instead
    of materials, yy, mean, von_mises and the gradient are None.
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


class Displacement(NamedTuple):
    """Displacements of points of the body: x along the surface, z into the body."""

    x: Values
    z: Values


class InterfaceStress(NamedTuple):
    """The largest |sxz| and the largest tension szz along an interface of layers, and their places.

    Without tension it is 0, at nan.
    """

    depth: Number
    shear: Number
    shear_x: Number
    tension: Number
    tension_x: Number


class LargestStress(NamedTuple):
    """The largest von Mises stress at depths of at least `depth`, and its place.

    unbounded_at lists the places of the surface next to which stresses have no bound.
    """

    depth: Number
    von_mises: Number
    x: Number
    z: Number
    unbounded_at: list[Number]


class Residuals(NamedTuple):
    """The relative residuals of the solution, measured by a rule that is independent of the one that found it."""

    equation: float
    load: float
    penetration: float
    tension: float


class EstimatedError(NamedTuple):
    """The largest relative errors, as the method estimates them."""

    ends: float
    traction: float
    resultants: float


class BothDirections(NamedTuple):
    """The solution of a problem, and that of the indenter sliding the other way."""

    as_given: "Solution"
    opposite: "Solution"


class Picture(str):
    """A drawing as the text of an SVG file. Notebooks show it."""

    def _repr_svg_(self):
        return str(self)

    def __repr__(self):
        return f"<steadyslide.Picture: {len(self)} characters of SVG>"


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

    reason says why nothing is proved, and is empty if the solution is proved. certificate is JSON, and empty if there is none.
    In periodic contact proved is False, and steadyslide-check proves the certificate. On cells only load shares, effective
    friction and friction force are proved. unresolved_gaps are those of the certified solution.
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


def number_of(number, digits):
    """Converts the library's (value, error, digits) to a Number, or to an mpmath number beyond 16 digits."""
    if number is None:
        return None
    value, error, text = number
    if digits <= 16:
        return Number(value, error)
    from ._mp import Number as MpNumber
    return MpNumber(text, error)
