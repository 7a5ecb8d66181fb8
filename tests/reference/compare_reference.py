#!/usr/bin/env python3
"""compare_reference.py SOURCE PROGRAM WORK: computes the reference problems again and compares them with those in the sources.

Also checks sums and formulas that the program does not use. A control changes one digit, and the comparison must notice it.
"""
import csv
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tomllib
from decimal import Decimal, getcontext

getcontext().prec = 60
# Relative to a number's size. Computed numbers have 50 digits; small numbers lose some of them.
TOLERANCE = Decimal("1e-40")
source, program, work = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
complaints = []


def require(holds, what):
    if not holds:
        complaints.append(what)


def rows_of(file):
    return list(csv.reader(file.read_text().splitlines()))


def table(file):
    return list(csv.DictReader(file.read_text().splitlines()))


def is_number(text):
    try:
        return Decimal(text).is_finite()
    except ArithmeticError:
        return False


def differences(one, other):
    """Returns the places where two tables differ by more than the tolerance. Two errors may differ if both are below 1e-30."""
    one, other = rows_of(one), rows_of(other)
    if [len(row) for row in one] != [len(row) for row in other]:
        return ["another shape"]
    found = []
    for number, (ours, theirs) in enumerate(zip(one, other), 1):
        for name, a, b in zip(one[0], ours, theirs):
            if name.endswith("error") and number > 1:
                same = a == b or (is_number(a) and is_number(b) and (Decimal(a) < Decimal("1e-30") > Decimal(b)))
            elif is_number(a) and is_number(b):
                same = abs(Decimal(a) - Decimal(b)) <= TOLERANCE * max(abs(Decimal(a)), 1)
            else:
                same = a == b
            if not same:
                found.append(f"line {number}, {name}: {a} and {b}")
    return found


def load(problem):
    return Decimal(problem["load"])


def fraction(text):
    over = text.partition("/")
    return float(over[0]) / float(over[2] or 1)


def formula(problem):
    """Returns the traction of a flat punch as a function of x, by the product of powers, in double; and the friction jumps."""
    nu = fraction(problem["half_space"]["poisson"])
    gamma = (1 - 2 * nu) / (2 * (1 - nu))
    alpha = [math.atan(gamma * fraction(value)) / math.pi for value in problem["friction"]["values"]]
    jumps = [fraction(jump) for jump in problem["friction"].get("jumps", [])]

    def traction(x):
        here = alpha[sum(jump < x for jump in jumps)]
        powers = math.prod(abs(x - jump) ** (alpha[k] - alpha[k + 1]) for k, jump in enumerate(jumps))
        return (-float(load(problem)) / math.pi * math.cos(math.pi * here) * (1 + x) ** (-0.5 - alpha[0]) * powers *
                (1 - x) ** (-0.5 + alpha[-1]))

    return traction, jumps


def check_laws(folder):
    problem = tomllib.loads((folder / "problem.toml").read_text())
    resultants = {row["name"]: Decimal(row["value"]) for row in table(folder / "resultants.csv")}
    require(abs(resultants["normal"] - load(problem)) < TOLERANCE, f"{folder.name}: the load")
    for kind in ("linear", "quadratic"):
        forces = table(folder / f"{kind}_forces.csv")
        normal, tangential = (sum(Decimal(row[name]) for row in forces) for name in ("normal", "tangential"))
        moment = sum(Decimal(row["x"]) * Decimal(row["normal"]) for row in forces)
        require(abs(normal - load(problem)) < TOLERANCE, f"{folder.name}: the sum of {kind} normal forces")
        require(abs(tangential - resultants["friction_force"]) < TOLERANCE, f"{folder.name}: the sum of {kind} tangential forces")
        require(abs(moment - resultants["centre_of_pressure"] * load(problem)) < TOLERANCE, f"{folder.name}: the moment, {kind}")
    if folder.name in ("flat_punch", "two_coatings", "three_coatings"):
        traction, jumps = formula(problem)
        rows = [(float(row["x"]), float(row["traction"])) for row in table(folder / "tractions.csv")]
        inside = [(x, t) for x, t in rows if abs(x) < 1 and x not in jumps]
        require(len(inside) >= 36, f"{folder.name}: too few places")
        for x, found in inside:
            require(abs(found / traction(x) - 1) < 1e-13, f"{folder.name}: the traction at {x}")
    # In plane strain syy = nu (sxx + szz).
    for row in table(folder / "stress.csv"):
        sxx, szz, syy = (Decimal(row[name]) for name in ("sxx", "szz", "syy"))
        nu = Decimal(fraction(problem["half_space"]["poisson"]))
        require(abs(syy - nu * (sxx + szz)) < Decimal("1e-15"), f"{folder.name}: plane strain at {row['x']}, {row['z']}")


shutil.rmtree(work, ignore_errors=True)
run = subprocess.run([sys.executable, source / "generate", work], env={**os.environ, "STEADYSLIDE": program})
if run.returncode != 0:
    sys.exit("generate failed")
count = 0
for folder in sorted(path.parent for path in source.glob("*/problem.toml")):
    for file in sorted(folder.glob("*.csv")):
        count += 1
        for what in differences(file, work / folder.name / file.name):
            complaints.append(f"{folder.name}/{file.name}: {what}")
    check_laws(folder)
require(count == 36, f"{count} tables instead of 36")

# The control: the 30th digit of one number is changed.
wrong = work / "wrong.csv"
text = (source / "flat_punch" / "linear_forces.csv").read_text()
place = text.index(",0.0") + 30
wrong.write_text(text[:place] + str((int(text[place]) + 5) % 10) + text[place + 1:])
require(len(differences(wrong, source / "flat_punch" / "linear_forces.csv")) == 1, "the control was not caught")
print("\n".join(complaints) or f"{count} tables as they were")
sys.exit(bool(complaints))
