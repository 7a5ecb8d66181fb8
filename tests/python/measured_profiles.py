"""measured_profiles.py FIRST COUNT [--digits50]: are the errors of measured profiles honest, and not much too large?

It solves COUNT random measured profiles, from number FIRST on, as `solve` does, and compares them with a solution that has ten
times the accuracy: ends of contact, friction, averaged pressures and stresses, stresses below the surface. With --digits50
solutions on cells, of 30 to 100 points, are compared with the Riemann-Hilbert method at 50 digits, but for averages. It prints a
line for every error that is smaller than the difference, and for every problem without a solution, then a table. Exit code 1 if
there is such a line.

A profile is a parabola with self-affine roughness (Hurst exponent 0.8, random phases), 200 to 10,000 points, joined by lines or
by a spline. The roughness is 0.1 to 10 % of the depth of the contact under the smooth parabola. One to three coatings; the seed
is the number.
"""

import argparse
import math
import sys

import numpy as np
import steadyslide as ss


def problem_of(seed, points=None, roughness=None, spline=None):
    """Returns a random problem, and its data in words. The contact of the smooth parabola has the half width a < 1."""
    random = np.random.default_rng([2016, seed])
    n = points or int(round(10 ** random.uniform(math.log10(200), 4)))
    r = roughness or 10 ** random.uniform(-3, -1)
    spline = bool(random.integers(2)) if spline is None else spline
    a = random.uniform(0.2, 0.8)
    x = np.linspace(-1, 1, n)
    waves = np.arange(1, max(2, n // 8))
    heights = waves ** -1.3 * random.standard_normal(len(waves))
    phases = random.uniform(0, 2 * math.pi, len(waves))
    rough = sum(h * np.cos(math.pi * k * x + phase) for h, k, phase in zip(heights, waves, phases))
    rough *= r * a * a / 2 / np.std(rough)
    coatings = int(random.integers(1, 4))
    edges = sorted(random.uniform(-0.9 * a, 0.9 * a, coatings - 1))
    friction = random.uniform(0, 0.8, coatings)
    # The compliance is 1 and the profile x^2/2, so a parabola needs the load pi a^2/2.
    problem = ss.Problem(load=math.pi * a * a / 2, poisson="0.3", young="1.82", friction=([*edges], [*friction]) if edges else [friction[0]],
                         samples={"file": (x, x * x / 2 + rough), "interpolate": "spline" if spline else "linear"},
                         sliding="+x" if random.integers(2) else "-x")
    words = f"{n} points, roughness {100 * r:.2g} %, {'spline' if spline else 'linear'}, {coatings} coatings"
    return problem, words, a, random


def quantities(solution, a, places):
    """Returns the compared numbers by name: value and error."""
    contact = solution.contact
    numbers = {("end", 0): contact[0].left.x, ("end", 1): contact[-1].right.x,
               ("friction", 0): solution.effective_friction, ("centre", 0): solution.centre_of_pressure}
    if solution.digits <= 16:
        numbers["averaged pressure", 0] = solution.largest_average
        numbers["averaged stress", 0] = solution.max_stress(over=a / 25).von_mises
    numbers = {name: (float(number), float(number.error)) for name, number in numbers.items()}
    values, errors = solution.stress([x for x, _ in places], [z for _, z in places], errors=True)
    for k in range(len(places)):
        numbers["stress below", k] = float(values.von_mises[k]), float(errors.von_mises[k])
    return numbers


def audit(seed, digits50):
    """Compares one problem. Returns the ratios of error and difference by kind, and the lines that say what is wrong."""
    problem, words, a, random = problem_of(seed, *((random_size(seed), None, None) if digits50 else ()))
    places = [(random.uniform(-1.2 * a, 1.2 * a), a * 10 ** random.uniform(-2, 0.3)) for _ in range(2 if digits50 else 10)]
    found = problem.solve(method="variational" if digits50 else "auto", over=a / 25)
    if not found.solved:
        return {}, [f"{seed}: not solved: {found.failed_condition} ({words})"]
    if digits50:
        truth = problem.solve(digits=50, method="riemann-hilbert")
    else:
        truth = problem.solve(method="variational", accuracy=1e-4, over=a / 25)
    if not truth.solved:
        return {}, [f"{seed}: no reference: {truth.failed_condition} ({words})"]
    ratios, lines = {}, []
    exact = quantities(truth, a, places)
    for (kind, k), (value, error) in quantities(found, a, places).items():
        if (kind, k) not in exact:
            continue
        reference, its_error = exact[kind, k]
        off = abs(value - reference)
        if not off <= error + its_error + 1e-13 * abs(value):
            lines.append(f"{seed}: {kind} {k}: {value!r} +- {error:.2g}, off by {off:.2g} ({words}, {found.method})")
        if found.method == "variational" and off > 0:
            ratios.setdefault(kind, []).append(error / off)
    return ratios, lines


def random_size(seed):
    """Returns a number of points with which 50 digits take seconds to minutes."""
    return 30 + 5 * (seed % 15)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("first", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("--digits50", action="store_true")
    options = parser.parse_args()
    wrong, all_ratios = [], {}
    for seed in range(options.first, options.first + options.count):
        ratios, lines = audit(seed, options.digits50)
        wrong += lines
        for line in lines:
            print(line, flush=True)
        for kind, values in ratios.items():
            all_ratios.setdefault(kind, []).extend(values)
    all_ratios["all"] = [value for values in all_ratios.values() for value in values]
    for kind, values in all_ratios.items():
        if values:
            print(f"{kind:18} {len(values):6}  error/difference: smallest {min(values):.2g}, median {np.median(values):.3g}, "
                  f"95 % {np.percentile(values, 95):.3g}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
