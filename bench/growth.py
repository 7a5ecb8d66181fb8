#!/usr/bin/env python3
"""Growth of whole solves with the number of jumps, pieces or contact zones: user times, and exponents fitted over the upper octaves.

    bench/growth.py PROGRAM KIND FIRST LAST [OPTION ...]

KIND: jumps (a flat punch), parabola-jumps (x^2), pieces (a polygon in a parabola, half of its wedges in contact), zones
(parabolas side by side, contact under each). Numbers of them run from 2^FIRST to 2^LAST. Each solve prints 101 samples a component and its residuals.
"""

import math
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction


def friction(n):
    rng = random.Random(7)
    jumps = ",".join(f'"{-1 + 2 * (i + 1) / (n + 1):.15g}"' for i in range(n))
    values = ",".join(f'"{0.1 + 0.4 * rng.random():.6g}"' for _ in range(n + 1))
    return f"[friction]\njumps = [{jumps}]\nvalues = [{values}]\n"


def signed(number):
    return f"+{number}" if number >= 0 else str(number)


def problem(kind, n):
    body = '[half_space]\npoisson = "0.2"\n'
    if kind == "jumps":
        return 'load = "1"\n' + body + friction(n) + '[indenter]\nprofile = "0"\n'
    if kind == "parabola-jumps":
        return 'load = "1"\n' + body + friction(n) + '[indenter]\nprofile = "x^2"\n'
    if kind == "zones":
        bumps = [f'{{to = "{i + 1}", profile = "{Fraction((2 * i + 1)**2, 4)} - {2 * i + 1}*x + x^2"}}' for i in range(n)]
        return (f'load = "{Fraction(n, 40)}"\n' + body + '[friction]\nvalues = ["0.3"]\n[indenter]\n' +
                f'support = ["0", "{n}"]\npieces = [\n ' + ",\n ".join(bumps) + "]\n")
    # Exact fractions: rounded ones would have steps between the pieces.
    places = [Fraction(2 * i, n) - 1 for i in range(n + 1)]
    pieces = [f'{{to = "{b}", profile = "{(a + b) / 2}*x{signed(-a * b / 2)}"}}' for a, b in zip(places, places[1:])]
    return ('load = "0.3"\n' + body + '[friction]\nvalues = ["0.3"]\n[indenter]\npieces = [\n ' + ",\n ".join(pieces) +
            "]\n")


def user_time(program, text, options):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "problem.toml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        before = os.times().children_user
        subprocess.run([program, "solve", path, "--samples", "101", *options], check=True, stdout=subprocess.DEVNULL)
        return os.times().children_user - before


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    program, kind, first, last = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    times = []
    for octave in range(first, last + 1):
        seconds = user_time(program, problem(kind, 2**octave), sys.argv[5:])
        times.append((octave, seconds))
        print(f"{kind} 2^{octave}: {seconds:.2f} s", flush=True)
    upper = times[-4:]
    mean = sum(o for o, _ in upper) / len(upper)
    slope = sum((o - mean) * math.log2(t) for o, t in upper) / sum((o - mean) ** 2 for o, _ in upper)
    print(f"exponent over the upper three octaves: {slope:.2f}")


if __name__ == "__main__":
    main()
