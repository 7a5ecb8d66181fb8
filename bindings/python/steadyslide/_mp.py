"""Numbers with more than 16 digits. They need mpmath."""

import mpmath
from mpmath import libmp


class Number(mpmath.mpf):
    """An mpmath number with its estimated absolute error. The result of arithmetic with it has no error."""

    def __new__(cls, digits, error):
        number = object.__new__(cls)
        # Keeps all digits, whatever mpmath's current precision is. The rounding is small against a unit of the last digit.
        precision = 64 + int(3.33 * max(len(digits), 16))
        number._mpf_ = libmp.from_str(digits or "nan", precision, libmp.round_nearest)
        number.digits = digits
        number.error = error
        return number

    def __reduce__(self):
        return Number, (self.digits, self.error)
