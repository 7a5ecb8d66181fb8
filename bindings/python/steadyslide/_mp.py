"""Numbers beyond double, for which mpmath is needed."""

import mpmath
from mpmath import libmp


class Number(mpmath.mpf):
    """An mpmath number with its estimated absolute error; what is calculated with it has none."""

    def __new__(cls, digits, error):
        number = object.__new__(cls)
        # All digits, for any current precision of mpmath.
        precision = 16 + int(3.33 * max(len(digits), 16))
        number._mpf_ = libmp.from_str(digits or "nan", precision, libmp.round_nearest)
        number.digits = digits
        number.error = error
        return number

    def __reduce__(self):
        return Number, (self.digits, self.error)
