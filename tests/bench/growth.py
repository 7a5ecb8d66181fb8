#!/usr/bin/env python3
"""Measures user times of whole solves, and fits exponents of their growth over the upper octaves.

    tests/bench/growth.py PROGRAM KIND FIRST LAST [OPTION ...]

KIND says what is counted, from 2^FIRST to 2^LAST:

    jumps           friction jumps under a flat punch
    parabola-jumps  friction jumps under x^2
    pieces          pieces of a polygon in a parabola; six tenths of its wedges are in contact
    zones           equal bumps in a row, each in contact
    traces          pieces of a measured profile: a self-affine roughness on a parabola, by the Riemann-Hilbert method
    cells           cells; a parabola over three jumps
    digits          certified digits; the same parabola

Each solve prints its residuals. With jumps, parabola-jumps, pieces and zones it also prints 101 samples for each component.
"""

import math
import os
import random
import resource
import subprocess
import sys
import tempfile
from fractions import Fraction

BODY = '[half_space]\npoisson = "0.2"\n'


def friction(n):
    rng = random.Random(7)
    jumps = ",".join(f'"{-1 + 2 * (i + 1) / (n + 1):.15g}"' for i in range(n))
    values = ",".join(f'"{0.1 + 0.4 * rng.random():.6g}"' for _ in range(n + 1))
    return f"[friction]\njumps = [{jumps}]\nvalues = [{values}]\n"


def signed(number):
    return f"+{number}" if number >= 0 else str(number)


def pieces(n, profile):
    """Returns pieces of equal length over [-1, 1], as exact fractions. Rounded ones would have steps between the pieces."""
    places = [Fraction(2 * i, n) - 1 for i in range(n + 1)]
    rows = [f'{{to = "{b}", profile = "{profile(a, b)}"}}' for a, b in zip(places, places[1:])]
    return "[indenter]\npieces = [\n " + ",\n ".join(rows) + "]\n"


def trace(n):
    """Returns lines "x,height" of waves with random phases. Their heights decrease with the power 1.3 of their numbers, and
    each wave has at least three points."""
    rng = random.Random(1)
    waves = [(math.pi * k, rng.gauss(0, 1) * 0.05 * k**-1.3, rng.random() * 2 * math.pi) for k in range(4, n // 3)]
    places = [2 * i / n - 1 for i in range(n + 1)]
    heights = [x * x / 2 + sum(a * math.sin(k * x + phase) for k, a, phase in waves) for x in places]
    return "".join(f"{x:.9f},{h:.9f}\n" for x, h in zip(places, heights))


def problem(kind, n):
    if kind == "traces":
        two = '[friction]\nvalues = ["0.1", "0.4"]\njumps = ["0"]\n'
        return 'load = "0.1"\n' + BODY + two + '[indenter]\nsamples = "trace.csv"\n'
    if kind == "jumps":
        return 'load = "1"\n' + BODY + friction(n) + '[indenter]\nprofile = "0"\n'
    if kind in ("parabola-jumps", "cells", "digits"):
        jumps = n if kind == "parabola-jumps" else 3
        return 'load = "1"\n' + BODY + friction(jumps) + '[indenter]\nprofile = "x^2"\n'
    one_friction = '[friction]\nvalues = ["0.3"]\n'
    if kind == "pieces":
        return 'load = "0.3"\n' + BODY + one_friction + pieces(
            n, lambda a, b: f"{(a + b) / 2}*x{signed(-a * b / 2)}")
    # The bumps are 2/n wide and x^2 n/2 high. About six tenths of the support are in contact, and the tip of every bump is.
    return 'load = "0.5"\n' + BODY + one_friction + pieces(
        n, lambda a, b: f"{Fraction(n, 2)}*x^2{signed(-n * (a + b) / 2)}*x+{n * ((a + b) / 2) ** 2 / 2}")


def options(kind, n):
    if kind == "cells":
        return ["--method", "variational", "--cells", str(n)]
    if kind == "digits":
        return ["--certify", "--digits", str(n)]
    if kind == "traces":
        return ["--method", "riemann-hilbert"]
    return ["--samples", "101", *(["--method", "riemann-hilbert"] if kind == "zones" else [])]


def run(program, path, arguments):
    """Returns the program's output and its user time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([program, "solve", path, *arguments], check=True, capture_output=True, text=True)
    return done.stdout, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def measure(program, kind, n, more=()):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "problem.toml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(problem(kind, n))
        if kind == "traces":
            with open(os.path.join(folder, "trace.csv"), "w", encoding="utf-8") as file:
                file.write(trace(n))
        return run(program, path, [*options(kind, n), *more])[1]


def exponent(times):
    """Returns the exponent fitted to pairs (octave, seconds), over the upper three octaves."""
    upper = times[-4:]
    mean = sum(o for o, _ in upper) / len(upper)
    return sum((o - mean) * math.log2(t) for o, t in upper) / sum((o - mean) ** 2 for o, _ in upper)


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    program, kind, first, last = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    times = []
    for octave in range(first, last + 1):
        seconds = measure(program, kind, 2**octave, sys.argv[5:])
        times.append((octave, seconds))
        print(f"{kind} 2^{octave}: {seconds:.2f} s", flush=True)
    print(f"exponent over the upper three octaves: {exponent(times):.2f}")


if __name__ == "__main__":
    main()
