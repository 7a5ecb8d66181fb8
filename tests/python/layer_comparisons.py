"""layer_comparisons.py FIRST COUNT: which comparisons of solutions hold on layers?

On the half-plane these are theorems (docs/theory.md). On layers with friction jumps they are not proved. This script solves
random problems and counts how often each holds:

  load      a larger load lowers the pressure nowhere, and loses no contact
  attitude  a turn of the profile moves the centre of pressure the other way
  friction  more friction at the same gamma moves the centre to the rear and raises the effective friction

It prints a line for every difference that is larger than the errors, and a table. Exit code 1 if a problem has no solution.
"""

import argparse
import sys

import numpy as np
import steadyslide as ss


def random_problem(seed):
    random = np.random.default_rng([37, seed])
    layers = [{"thickness": round(10 ** random.uniform(-1, 1), 3), "young": round(random.uniform(0.3, 5), 3),
               "poisson": round(random.uniform(0, 0.49), 3), "below": "slip" if random.random() < 0.2 else "bonded"}
              for _ in range(random.integers(1, 3))]
    base = {"base": "rigid"} if random.random() < 0.5 else {"poisson": "0.3", "young": round(random.uniform(0.3, 5), 3)}
    a, b = (round(v, 3) for v in random.uniform(0, 1, 2))
    curvature = round(random.uniform(0.3, 1), 3)
    two_bumps = random.random() < 0.4
    profile = f"4*{curvature}*x^4 - {curvature}*x^2" if two_bumps else f"{curvature}*x^2"
    load = round(layers[0]["young"] * random.uniform(0.02, 0.2), 4)
    data = {"layers": layers, **base, "friction": [a, b], "jumps": [round(random.uniform(-0.3, 0.3), 3)], "support": [-1, 1],
            "sliding": "+x" if random.integers(2) else "-x"}
    return data, profile, load, random


def solved(profile, load, data, **changed):
    solution = ss.Problem(load=load, profile=profile, **{**data, **changed}).solve()
    return solution if solution.solved else None


def judged(larger, smaller):
    """Returns +1 if larger > smaller, -1 if it is smaller, 0 if the errors leave it open."""
    difference = float(larger) - float(smaller)
    error = float(larger.error) + float(smaller.error)
    return 0 if abs(difference) <= error else 1 if difference > 0 else -1


def compared(seed):
    """Returns the verdicts by name: 1 holds, 0 open, -1 does not hold. None without a solution."""
    data, profile, load, random = random_problem(seed)
    first = solved(profile, load, data)
    heavier = solved(profile, round(1.3 * load, 4), data)
    turned = solved(f"{profile} + x/50", load, data)
    rougher = solved(profile, load, data, friction=[round(f + d, 3) for f, d in zip(data["friction"], (0.2, 0.1))])
    if None in (first, heavier, turned, rougher):
        return None
    ends = [(c.left.x, c.right.x) for c in first.contact]
    verdicts = {"load": 1}
    for left, right in ends:
        x = np.linspace(float(left), float(right), 203)[1:-1]
        x = x[np.abs(x - float(data["jumps"][0])) > 1e-3]
        p, error = (np.asarray(v) for v in first.traction(x, errors=True))
        more, more_error = (np.asarray(v) for v in heavier.traction(x, errors=True))
        if np.any(more - p > error + more_error):  # t = -p
            verdicts["load"] = -1
    verdicts["attitude"] = -judged(turned.centre_of_pressure, first.centre_of_pressure)
    rear = judged(rougher.centre_of_pressure, first.centre_of_pressure)
    verdicts["friction: centre to the rear"] = -rear if data["sliding"] == "+x" else rear
    verdicts["friction: effective friction"] = judged(rougher.effective_friction, first.effective_friction)
    return verdicts


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("first", type=int)
    parser.add_argument("count", type=int)
    options = parser.parse_args()
    counts, failures = {}, 0
    for seed in range(options.first, options.first + options.count):
        verdicts = compared(seed)
        if verdicts is None:
            failures += 1
            print(f"{seed}: not solved", flush=True)
            continue
        for name, verdict in verdicts.items():
            counts.setdefault(name, {1: 0, 0: 0, -1: 0})[verdict] += 1
            if verdict < 0:
                print(f"{seed}: {name} does not hold", flush=True)
    for name, count in counts.items():
        print(f"{name:30} holds {count[1]}, open {count[0]}, does not hold {count[-1]}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
