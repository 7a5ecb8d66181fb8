#!/usr/bin/env python3
"""Computes the load under the first coating of punch.toml: mpmath.quad (python3-mpmath) integrates the formula of the pressure.

    power_integrals.py DIGITS

The pressure is p = P/(pi sqrt(1+s^2)) prod |x-e_j|^p_j [Bal16, (4)-(7)], s = gamma f. The rule is tanh-sinh between the singular
points, as in the manual of mpmath for singularities at ends. The whole load must be 1.
Prints the load share, CPU seconds and the difference of the load from 1 as JSON.
"""

import json
import sys
import time

from mpmath import atan, mp, mpf, pi, quad, sqrt


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    mp.dps = int(sys.argv[1])
    start = time.process_time()
    gamma = mpf(3) / 8
    s = [gamma * mpf(f) for f in ("0.1", "0.9", "0.3", "0.6")]
    places = [mpf(x) for x in ("-1", "-0.4", "0.1", "0.5", "1")]
    a = [atan(value) / pi for value in s]
    half = mpf(1) / 2
    powers = [-half - a[0]] + [left - right for left, right in zip(a, a[1:])] + [-half + a[-1]]

    def load(k):
        def pressure(x):
            product = 1 / (pi * sqrt(1 + s[k] ** 2))
            for place, power in zip(places, powers):
                product *= abs(x - place) ** power
            return product

        return quad(pressure, [places[k], places[k + 1]])

    loads = [load(k) for k in range(4)]
    seconds = time.process_time() - start
    print(json.dumps({"share": str(loads[0] / sum(loads)), "seconds": seconds, "missing": float(abs(sum(loads) - 1))}))


if __name__ == "__main__":
    main()
