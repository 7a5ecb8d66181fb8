"""Compares other programs with steadyslide at equal accuracy: the error against the certified value, and both times.

The scripts print the load share under the first coating. Each is compared with the smallest number of cells of steadyslide that
has no larger error, and with the formula. The benchmark programs compare libraries: GSL for a traction, PARI and Arb for the
integral over a panel.
"""

import json
import os
import subprocess
from fractions import Fraction

from growth import run
from layouts import Times, power_of_ten, short

HERE = os.path.dirname(os.path.abspath(__file__))
PYTHON = "/usr/bin/python3"  # Debian's, which finds Debian's modules

PEERS = (
    ("boundary elements, FFT and projected CG (numpy)", "boundary_element.py", "cells", (256, 1024, 4096, 16384), "parabola.toml"),
    ("finite elements, GetFEM", "finite_element.py", "elements under [-1, 1]", (10, 20, 40, 80), "parabola.toml"),
    ("the formula by mpmath.quad", "power_integrals.py", "digits", (15, 30, 50), "punch.toml"),
)
OCTAVES = range(4, 19)


def share(program, problem, *options):
    """Returns the first load share with all its digits, and the least user time of three runs of the whole program."""
    runs = [run(program, os.path.join(HERE, problem), ["--format", "json", *options]) for _ in range(3)]
    return Fraction(json.loads(runs[0][0], parse_float=str)["resultants"]["load_share"][0]["value"]), min(seconds for _, seconds in runs)


def error(share, truth):
    return abs(float(share - truth))


def libraries(build):
    """Returns the rows of GSL, PARI and Arb beside ours, measured in one run."""
    rows = []

    def add(peer, times, name, ours, counter):
        if name in times.of:
            off = "certified" if "acb" in name else times.counter(name, counter)
            rows.append([peer, off, seconds(times.of[name]), "", "", "", times.counter(ours, counter), seconds(times.of[ours])])

    def seconds(nanoseconds):
        return short(nanoseconds / 1e6, 2) + " ms"

    program = os.path.join(build, "bin", "bench_riemann_hilbert")
    if os.path.exists(program):
        times = Times(program, ["--benchmark_filter=^traction(_by_gsl)?/"])
        for profile in ("quartic", "wedge"):
            add(f"GSL, QAWS and QAWC: one traction, {profile}", times, f"traction_by_gsl/{profile}", f"traction/{profile}",
                "traction")
    program = os.path.join(build, "bin", "bench_precision")
    if os.path.exists(program):
        times = Times(program, ["--benchmark_filter=panel", "--benchmark_min_time=0.05"])
        for digits in (50, 100):
            for peer, name in (("PARI, intnum", "PARI's intnum"), ("Arb, acb_calc_integrate", "acb_calc_integrate")):
                add(f"{peer}: one panel, {digits} digits", times, f"panel, {name}, {digits} digits",
                    f"panel, Gauss-Jacobi, rule known, {digits} digits", "error")
    return rows


def compare(build, quick):
    """Returns the rows of the table."""
    program = os.path.join(build, "bin", "steadyslide")
    truths, by_formula, by_cells = {}, {}, {}
    for problem in ("parabola.toml", "punch.toml"):
        truths[problem] = share(program, problem, "--certify", "--digits", "60")[0]
        for digits in ("16", "50"):
            found, seconds = share(program, problem, "--digits", digits)
            by_formula[problem, digits] = error(found, truths[problem]), seconds

    def on_cells(octave):
        if octave not in by_cells:
            found, seconds = share(program, "parabola.toml", "--method", "variational", "--cells", str(2**octave))
            by_cells[octave] = error(found, truths["parabola.toml"]), seconds
        return by_cells[octave]

    rows = []
    for name, script, unit, sizes, problem in PEERS:
        for size in sizes[:2] if quick else sizes:
            out = subprocess.run([PYTHON, os.path.join(HERE, script), str(size)], capture_output=True, text=True)
            if out.returncode != 0:
                print(f"{script} {size}: not run: {out.stderr.strip().splitlines()[-1:]}")
                break
            peer = json.loads(out.stdout)
            off = error(Fraction(peer["share"]), truths[problem])
            digits = "16" if off > 1e-14 else "50"
            formula_off, formula_seconds = by_formula[problem, digits]
            cells = ["", "", ""]
            if problem == "parabola.toml":
                # The next finer mesh must not be worse, because the position of an end in its cell varies.
                octave = next((o for o in OCTAVES if all(on_cells(p)[0] <= off for p in (o, o + 1))), None)
                if octave:
                    cells = [f"2^{octave}", power_of_ten(on_cells(octave)[0]), f"{on_cells(octave)[1]:.3f} s"]
            rows.append([f"{name}, {size} {unit}", power_of_ten(off), f"{peer['seconds']:.2f} s", *cells,
                         power_of_ten(formula_off), f"{formula_seconds:.3f} s"])
            print(" | ".join(rows[-1]), flush=True)
    return rows if quick else rows + libraries(build)


HEAD = ["peer", "its error", "its time", "our cells", "error", "time", "our formula or solver: error", "time"]
