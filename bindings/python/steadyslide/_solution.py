"""The class Solution."""

import html
from fractions import Fraction
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core, _document
from ._core import InvalidData
from ._results import (Contact, ContactEnd, Displacement, EstimatedError, Exact, InterfaceStress, Interval, LargestPressure, LargestStress, NodalForces,
                       Number, Picture, Places, Proof, Residuals, Resultants, Sample, SingularPoint, Stress, UnresolvedGap, Values,
                       number_of)

if TYPE_CHECKING:
    from ._problem import Problem


class Solution:
    """A solved problem, or the best state that the method reached. Numbers have errors: s.effective_friction.error.

    If a function of x has two different limits at a place, traction(x), shear(x), gap(x) and slope(x) return the one of
    larger size; at(x) returns both.

    Problem.solve() makes solutions; do not call the class.
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
    approach: Number | None
    core: Interval | None

    def __init__(self, problem: "Problem", options: dict[str, Any], start: "Solution | None" = None) -> None:
        self._core = _core.solve(problem._core, *options.values(), start and start._core)
        self._options = options
        #: the Problem
        self.problem = problem

    def _numbers(self, value):
        """Converts each (value, error, digits) inside `value` to a number."""
        if isinstance(value, tuple) and len(value) == 3 and isinstance(value[2], str) and isinstance(value[0], float):
            return number_of(value, self.digits)
        if isinstance(value, (tuple, list)):
            return type(value)(self._numbers(one) for one in value)
        return value

    @property
    def digits(self) -> int:
        """The digits that solve() was called with."""
        return self._options["digits"]

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
    def residuals(self) -> Residuals:
        """The relative residuals."""
        return Residuals(*self._core.residuals())

    @property
    def estimated_error(self) -> EstimatedError:
        """The largest relative errors."""
        return EstimatedError(*self._core.estimated_error())

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

    def at(self, x: Places) -> Sample:
        """Returns all quantities at places of the surface.

        Parameters
        ----------
        x : number or array
            The places.

        Returns
        -------
        Sample
            Numbers, or arrays if x is one. A gap outside the support is None, in an array nan.

        Raises
        ------
        InvalidData
            If a place is not a number.

        Examples
        --------
        >>> import steadyslide as ss
        >>> s = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0").solve()
        >>> s.at("1/2").shear[0] == -0.5 * s.at("1/2").traction[0]
        True
        """
        if np.ndim(x) == 0:
            return Sample(*self._numbers(self._core.at(_document.exact(x, "x"))))
        places = np.asarray(x)
        samples = [self.at(place) for place in places.ravel().tolist()]
        if not samples:
            none = self._array([], places.shape)
            return Sample(*((none, none) if name in ("traction", "shear", "slope", "shear_slope") else none for name in Sample._fields))

        def array(numbers):
            return self._array([number_of((np.nan, np.inf, ""), self.digits) if n is None else n for n in numbers], places.shape)

        return Sample(*(tuple(array(side) for side in zip(*column)) if isinstance(column[0], tuple) else array(column)
                        for column in zip(*samples)))

    def traction(self, x: Places, errors: bool = False) -> Values:
        """Returns the normal traction t <= 0.

        Parameters
        ----------
        x : number or array
            The places. With 16 digits and without errors, an array of floats is evaluated at the doubles themselves, not at
            the decimals that they print. At a jump or an end whose place is no double give a text, or errors=True.
        errors : bool
            True to return the errors, too.

        Returns
        -------
        number or array
            The traction; with errors=True (values, errors).

        Raises
        ------
        InvalidData
            If a place is not a number.

        Examples
        --------
        >>> import steadyslide as ss
        >>> s = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0").solve()
        >>> s.traction([-0.5, 0.5]).round(6)
        array([-0.391889, -0.356553])
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
        values, wrong = self._with_errors(numbers, places.shape)
        return (values, wrong) if errors else values

    def _array(self, numbers, shape):
        if not shape:
            return numbers[0]
        array = np.empty(len(numbers), dtype=float if self.digits <= 16 else object)
        array[:] = numbers
        return array.reshape(shape)

    def _with_errors(self, numbers, shape):
        return self._array(numbers, shape), np.array([float(n.error) for n in numbers]).reshape(shape)[()]

    def stress(self, x: Places, z: Places, errors: bool = False) -> Any:
        """Returns the stresses at points of the body.

        Parameters
        ----------
        x, z : number or array
            The places and the depths z >= 0. With 16 digits they are rounded to doubles. At z = 0 it is the stress on the
            side of the larger pressure; there xz = -shear. Where the pressure is infinite, zz is -inf, xz is infinite or 0,
            and the others are nan.
        errors : bool
            True to return the errors, too.

        Returns
        -------
        Stress
            Numbers, or arrays if x or z is one; with errors=True (values, errors).

        Raises
        ------
        InvalidData
            If x or z is not a number, if z < 0, if z > 0 is too small for 16 digits, if the point lies in a rigid base, or
            if the body is given by symbols.

        Examples
        --------
        >>> import steadyslide as ss
        >>> s = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0").solve()
        >>> s.stress([0, 0.5], 0.1).von_mises.shape
        (2,)
        >>> s.stress(0.5, 0).zz == s.traction(0.5)
        True
        """
        if self.digits <= 16 or np.size(x) == 0 or np.size(z) == 0:
            points, depths = np.broadcast_arrays(_floats(x, "x"), _floats(z, "z"))
            parts = self._core.stresses(points.ravel(), depths.ravel())
            values, wrong = ([None if part is None else part[k].reshape(points.shape)[()] for part in parts] for k in (0, 1))
        else:
            states, shape = self._at_points(self._core.stress, x, z)
            columns = [None if part[0] is None else self._with_errors(list(part), shape) for part in zip(*states)]
            values, wrong = ([None if column is None else column[k] for column in columns] for k in (0, 1))
        return (Stress(*values), Stress(*wrong)) if errors else Stress(*values)

    def _at_points(self, ask, x, z):
        """Returns what `ask` returns at each point, as numbers, and the shape of the points."""
        points, depths = np.broadcast_arrays(np.asarray(x, dtype=object), np.asarray(z, dtype=object))
        return [self._numbers(ask(_document.exact(a, "x"), _document.exact(b, "z")))
                for a, b in zip(points.ravel(), depths.ravel())], points.shape

    def displacement(self, x: Places, z: Places, errors: bool = False) -> Any:
        """Returns the displacement of points of the body, u_x along the surface and u_z into the body.

        Parameters
        ----------
        x, z : number or array
            The places and the depths z >= 0.
        errors : bool
            True to return the errors, too.

        Returns
        -------
        Displacement
            Numbers, or arrays if x or z is one; with errors=True (values, errors).

        Raises
        ------
        InvalidData
            If x or z is not a number, if z < 0, if the problem gives gamma instead of a material, or if the body has layers,
            a period or symbols.

        Notes
        -----
        No load determines the two constants of a half-plane. Here both parts are 0 at the point of the surface at x = 0,
        or at the left end of the support if x = 0 lies outside of it. Under a rigid indenter u_z is -at(x).displacement
        at z = 0. The time grows like the number of points times that of cells.

        Examples
        --------
        >>> import steadyslide as ss
        >>> s = ss.Problem(load=1, poisson="0.3", friction=["0.2"], profile="0").solve()
        >>> s.displacement(0, 0) == (0, 0), s.displacement(3, 0).z < 0
        (True, True)
        """
        found, shape = self._at_points(self._core.displacement, x, z)
        columns = [self._with_errors(list(part), shape) for part in zip(*found)] or [(np.empty(shape), np.empty(shape))] * 2
        values, wrong = (Displacement(*(column[k] for column in columns)) for k in (0, 1))
        return (values, wrong) if errors else values

    def max_stress(self, depth: Exact | None = None, over: Exact | None = None) -> LargestStress:
        """Searches the largest von Mises stress in the body. A search proves nothing.

        Parameters
        ----------
        depth : number
            The smallest depth. By default all depths, or those from a hundredth of the contact's width on if stresses
            have no bound or friction jumps in the contact.
        over : number
            A length. The stresses are averaged over a window of this length along x. They have a bound at all depths.

        Returns
        -------
        LargestStress
            The stress, its place, and the places of the surface next to which stresses have no bound.

        Raises
        ------
        InvalidData
            If the depth is not a number or negative, if the length is not positive, if the problem gives gamma instead of a
            material, or if it has a length and more than 16 digits, layers or a period.

        Examples
        --------
        >>> import steadyslide as ss
        >>> largest = ss.Problem(load=1, poisson="0.3", friction=["0"], profile="20*x^2").solve().max_stress()
        >>> abs(largest.x) < 1e-6, largest.z > 0, largest.unbounded_at
        (True, True, [])
        """
        wanted = [_document.optional(_document.exact, value, name) for name, value in (("depth", depth), ("over", over))]
        return LargestStress(*self._numbers(self._core.max_stress(*wanted)))

    def interface_stress(self) -> list[InterfaceStress]:
        """Returns the largest shear and tension along each interface of layers, from the surface down.

        Returns
        -------
        list of InterfaceStress
            Empty on the half-plane.

        Raises
        ------
        InvalidData
            If the body has given symbols.

        Examples
        --------
        >>> import steadyslide as ss
        >>> layer = {"thickness": "1", "young": "2", "poisson": "0.3"}
        >>> s = ss.Problem(load=1, base="rigid", layers=[layer], friction=["0.2"], profile="x^2").solve()
        >>> [one.depth for one in s.interface_stress()]
        [1.0]
        """
        return [InterfaceStress(*self._numbers(one)) for one in self._core.interface_stress()]

    def nodal_forces(self, nodes: Places, order: int = 1) -> NodalForces:
        """Returns the consistent nodal forces of the tractions on a mesh of the surface.

        Parameters
        ----------
        nodes : array
            The places of the nodes, increasing.
        order : int
            1 for linear elements between the nodes, 2 for quadratic elements; then every second node is in the middle of
            its element.

        Returns
        -------
        NodalForces
            Arrays with one force for each node, and with their errors.

        Raises
        ------
        InvalidData
            If the mesh is invalid, or if the contact reaches beyond the mesh.
        """
        texts = [_document.exact(node, f"nodes[{k}]") for k, node in enumerate(np.asarray(nodes).ravel().tolist())]
        found = self._core.nodal_forces(texts, _document.whole(order, "order"))
        columns = [self._with_errors(list(forces), (len(texts),)) for forces in zip(*self._numbers(found))]
        return NodalForces(*(values for values, _ in columns), *(wrong for _, wrong in columns))

    def certify(self) -> Proof:
        """Tries to prove the solution in ball arithmetic. This takes about ten times as long as a solve.

        Returns
        -------
        Proof
            With a certificate for steadyslide-check, if the solution is proved. With a period proved is False, and the
            certificate holds what steadyslide-check has yet to prove. On cells only the load shares, the effective friction
            and the friction force are proved.
        """
        proved, reason, certificate, gaps = self._core.certify()
        return Proof(proved, reason, certificate, self._gaps(gaps))

    def plot(self, path: str | PathLike[str] | None = None) -> Picture | None:
        """Draws indenter, surface and tractions as the command line's --plot does. gnuplot draws.

        Parameters
        ----------
        path : path
            The file, which ends in .svg, .pdf or .png.

        Returns
        -------
        Picture or None
            Without a path, the text of an SVG, which notebooks show.

        Raises
        ------
        InvalidData
            If the name of the file has another ending.
        RuntimeError
            If gnuplot is absent or does not draw the picture.
        """
        if path is None:
            return Picture(self._core.picture("svg").decode())
        picture = self._core.picture(fspath(path).rpartition(".")[2])
        with open(path, "wb") as file:
            file.write(picture)
        return None

    def __repr__(self):
        state = f"effective friction {float(self.effective_friction):.6g}" if self.solved else self.failed_condition
        return f"<steadyslide.Solution by {self.method}: {state}>"

    def _repr_html_(self):
        """Returns the resultants as a table."""
        def shown(value):
            if isinstance(value, LargestPressure):
                return f"{shown(value.value)} at x = {shown(value.x)}"
            if isinstance(value, Interval):
                return f"{shown(value.left)} to {shown(value.right)}"
            return ", ".join(map(shown, value)) if isinstance(value, list) else f"{float(value):.6g}"

        rows = [(key.replace("_", " "), shown(value), unit)
                for (_, key, unit, _), value in zip(_core.quantities, self.resultants) if value is not None]
        head = f"<caption>{html.escape(self.failed_condition or self.method)}</caption>"
        return "<table>" + head + "".join("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>"
                                          for row in rows) + "</table>"

    def __reduce__(self):
        # Solving again gives the same solution.
        return Solution, (self.problem, self._options)


def _quantity(key):
    return property(lambda self: getattr(self.resultants, key), doc=getattr(Resultants, key).__doc__)


for _key in Resultants._fields:
    setattr(Solution, _key, _quantity(_key))


def _floats(values, field):
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        array = np.asarray(values, dtype=object)
        return np.array([_float(_document.exact(one, field), f"{field}[{k}]" if array.ndim > 0 else field)
                         for k, one in enumerate(array.ravel())]).reshape(array.shape)


def _float(text, field):
    try:
        return float(Fraction(text))
    except (ValueError, ZeroDivisionError):
        raise InvalidData(f"{field}: not a number; a number is written like 2, -0.25, 1e-3 or 1/3; {text!r}") from None
