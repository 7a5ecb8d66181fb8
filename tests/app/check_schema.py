#!/usr/bin/env python3
"""Tests that the output of `steadyslide solve --format json` fits docs/solve.schema.json, for every example and every kind of
answer, and that the schema refuses documents that do not fit.

usage: check_schema.py PROGRAM SCHEMA EXAMPLES
"""

import copy
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import jsonschema

program, examples = sys.argv[1], Path(sys.argv[3])
schema = json.loads(Path(sys.argv[2]).read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
failures = []

# The schema has the kinds of singular points that the program has.
shown = subprocess.run([program, "exponents", "--help"], capture_output=True, text=True, check=True).stdout
kinds = re.search(r"^ *kind +(.*)$", shown, re.MULTILINE).group(1).split(", ")
if schema["$defs"]["singular_point"]["properties"]["kind"]["enum"] != kinds:
    failures.append(f"kinds of singular points: the program has {', '.join(kinds)}")


def answer(problem, *options):
    command = [program, "solve", problem, "--format", "json", *options]
    result = subprocess.run(command, cwd=examples, capture_output=True, text=True, check=False)
    if result.returncode not in (0, 1):
        failures.append(f"{' '.join(command)}: exit code {result.returncode}: {result.stderr}")
        return {}
    return json.loads(result.stdout)


def leaf_errors(error):
    """Returns the errors of the alternative that failed at the deepest place."""
    if not error.context:
        return [f"{error.json_path}: {error.message[:200]}"]
    deepest = max(error.context, key=lambda e: len(e.absolute_path))
    return leaf_errors(deepest)


def fits(what, document):
    errors = [line for error in validator.iter_errors(document) for line in leaf_errors(error)]
    if errors:
        failures.append(f"{what}: {errors[0]}")


for example in sorted(examples.glob("*.toml")):
    if "sweep" not in example.name:
        fits(example.name, answer(example.name, "--samples", "3", "--at=-2,0,1/3"))

tables = tempfile.TemporaryDirectory()
points, mesh = Path(tables.name) / "points.csv", Path(tables.name) / "mesh.csv"
points.write_text("x,z\n0,0.5\n1,2\n")
mesh.write_text("x\n-2\n-0.5\n0.5\n2\n")

several = {
    "stresses and forces": ("parabola.toml", "--stress-at", str(points), "--loads-on", str(mesh), "--max-stress"),
    "both ways": ("parabola.toml", "--both-directions", "--stress-at", str(points), "--max-stress"),
    "other direction": ("parabola_rough_rear.toml", "--both-directions", "--at", "0"),
    "40 digits": ("wedge.toml", "--digits", "40"),
    "cells": ("parabola.toml", "--method", "variational", "--cells", "256", "--samples", "4"),
    "proof": ("two_coatings_forward.toml", "--certify", "--max-stress", "--at=-1,0,0.5,2"),
    "bound": ("parabola.toml", "--method", "variational", "--cells", "256", "--certify"),
    "no convergence": ("two_bumps.toml", "--method", "variational", "--iterations", "1"),
    "loads": ("two_bumps.toml", "--load-steps", "0.7,0.8"),
    "proved loads": ("parabola.toml", "--load-steps", "400,500", "--certify"),
}
documents = {what: answer(*wanted) for what, wanted in several.items()}
for what, document in documents.items():
    fits(what, document)

# Controls: each of these changes makes a valid document invalid.
document = documents["other direction"]
changes = {
    "a key less": lambda d: d["resultants"].pop("friction_force"),
    "an error less": lambda d: d["samples"][0]["u"].pop("error"),
    "an unknown key": lambda d: d["contact"][0].update(colour="red"),
    "a number that is a list": lambda d: d["resultants"]["normal"].update(value=[1.0]),
    "a text that is no number": lambda d: d["resultants"]["normal"].update(value="one"),
    "an unknown kind": lambda d: d["contact"][0]["left"].update(kind="corner"),
    "another schema": lambda d: d.update(schema=1),
    "an error of another kind": lambda d: d["resultants"]["normal"].update(rad=d["resultants"]["normal"].pop("error")),
    "a number without its error": lambda d: d["resultants"].update(normal="1"),
    "one limit": lambda d: d["samples"][0].update(traction={"left": {"value": "1", "error": "0"}}),
    "no list": lambda d: d.update(contact={}),
    "the other direction without its numbers": lambda d: d["other_direction"].pop("resultants"),
    "two shapes of one indenter": lambda d: d["problem"]["indenter"].update(samples="a.csv", points=3),
}
for what, change in changes.items():
    broken = copy.deepcopy(document)
    change(broken)
    if validator.is_valid(broken):
        failures.append(f"control: {what} is not noticed")
row = copy.deepcopy(documents["loads"])
row[0]["component"] = "one"
if validator.is_valid(row):
    failures.append("control: a component that is no number is not noticed")

print("\n".join(failures) or f"{len(several) + len(changes)} kinds of answers and controls")
sys.exit(1 if failures else 0)
