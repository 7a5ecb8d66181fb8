from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import Executor
from decimal import Decimal
from fractions import Fraction
from os import PathLike
from typing import Any, NamedTuple

import numpy as np

Exact = str | int | float | Fraction | Decimal
Places = Exact | Sequence[Any] | np.ndarray
Values = Any  # a Number for a number, an array for an array

__version__: str

class InvalidData(ValueError): ...

class Number(float):
    error: float
    def __new__(cls, value: float, error: float) -> Number: ...

class ContactEnd(NamedTuple):
    x: Number
    kind: str
    exponent: Number
    intensity: Number

class Contact(NamedTuple):
    left: ContactEnd
    right: ContactEnd
    width: Number
    load: Number

class SingularPoint(NamedTuple):
    x: Number
    kind: str
    exponent: Number | None
    symbolic: str
    intensity: Number
    constant: Number
    stress_intensity_left: Number | None
    stress_intensity_right: Number | None

class UnresolvedGap(NamedTuple):
    x: Number
    log10_length: float

class PossiblePoint(NamedTuple):
    x: str
    kind: str
    side: str
    exponent: Number | None
    symbolic: str

class LargestPressure(NamedTuple):
    value: Number
    x: Number
    exponent: Number | None

class Interval(NamedTuple):
    left: Number
    right: Number

class Resultants(NamedTuple):
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

class Sample(NamedTuple):
    traction: tuple[Number, Number]
    shear: tuple[Number, Number]
    gap: Number | None
    slope: tuple[Number, Number]
    displacement: Number
    shear_slope: tuple[Number, Number]
    cumulative_load: Number

class Stress(NamedTuple):
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
    normal: np.ndarray
    tangential: np.ndarray
    normal_error: np.ndarray
    tangential_error: np.ndarray

class Proof:
    proved: bool
    reason: str
    certificate: str
    unresolved_gaps: list[UnresolvedGap]
    def save(self, path: str | PathLike[str]) -> None: ...

class Problem:
    def __init__(self, load: Exact | None = ..., poisson: Exact | None = ..., young: Exact | None = ...,
                 plane: str | None = ..., gamma: Exact | None = ..., sliding: str | None = ..., load_at: Exact | None = ...,
                 friction: Sequence[Exact] | None = ..., jumps: Sequence[Exact] | None = ..., profile: Exact | None = ...,
                 pieces: Sequence[tuple[Exact, Exact]] | None = ..., samples: str | Mapping[str, Any] | None = ...,
                 support: Sequence[Exact] | None = ..., elastic: Mapping[str, Exact] | None = ...) -> None: ...
    @classmethod
    def from_toml(cls, path: str | PathLike[str]) -> Problem: ...
    @classmethod
    def from_string(cls, text: str, name: str = ...) -> Problem: ...
    @property
    def text(self) -> str: ...
    @property
    def name(self) -> str: ...
    def with_(self, **changes: Any) -> Problem: ...
    def solve(self, digits: int = ..., method: str = ..., cells: int | None = ...) -> Solution: ...
    def exponents(self, digits: int = ...) -> list[PossiblePoint]: ...
    def derivation(self) -> str: ...

class Solution:
    problem: Problem
    def __init__(self, problem: Problem, digits: int = ..., method: str = ..., cells: int | None = ...) -> None: ...
    @property
    def digits(self) -> int: ...
    @property
    def method(self) -> str: ...
    @property
    def solved(self) -> bool: ...
    @property
    def failed_condition(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def contact(self) -> list[Contact]: ...
    @property
    def singular_points(self) -> list[SingularPoint]: ...
    @property
    def unresolved_gaps(self) -> list[UnresolvedGap]: ...
    @property
    def resultants(self) -> Resultants: ...
    @property
    def normal(self) -> Number: ...
    @property
    def friction_force(self) -> Number: ...
    @property
    def centre_of_pressure(self) -> Number: ...
    @property
    def effective_friction(self) -> Number: ...
    @property
    def load_share(self) -> list[Number]: ...
    @property
    def contact_width(self) -> Number: ...
    @property
    def real_contact_length(self) -> Number: ...
    @property
    def mean_pressure(self) -> Number: ...
    @property
    def largest_pressure(self) -> LargestPressure: ...
    @property
    def components(self) -> int: ...
    @property
    def tilt(self) -> Number | None: ...
    @property
    def core(self) -> Interval | None: ...
    def at(self, x: Exact) -> Sample: ...
    def traction(self, x: Places, errors: bool = ...) -> Values: ...
    def shear(self, x: Places, errors: bool = ...) -> Values: ...
    def gap(self, x: Places, errors: bool = ...) -> Values: ...
    def slope(self, x: Places, errors: bool = ...) -> Values: ...
    def stress(self, x: Places, z: Places, errors: bool = ...) -> Any: ...
    def nodal_forces(self, nodes: Places, order: int = ...) -> NodalForces: ...
    def certify(self) -> Proof: ...
    def plot(self, ax: Any = ...) -> Any: ...

def sweep(base: Problem, vary: Mapping[str, Sequence[Any]], columns: Iterable[str] = ..., executor: Executor | None = ...,
          digits: int = ..., method: str = ..., cells: int | None = ...) -> np.ndarray: ...
