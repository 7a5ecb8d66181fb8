#!/usr/bin/env python3
"""budgets.py CTEST BUILD: checks that each slow test states its budget, a quarter of its time limit. Together the tests of ./check --all have
at most 75 minutes on two cores, of which the build and the other tests need 17; a test of a full set has at most 40 minutes."""

import json
import subprocess
import sys

tests = json.loads(subprocess.run([sys.argv[1], "--test-dir", sys.argv[2], "--show-only=json-v1"], capture_output=True, check=True).stdout)["tests"]
minutes = {"slow": 0.0, "full": 0.0}
wrong = []
for test in tests:
    properties = {entry["name"]: entry["value"] for entry in test["properties"]}
    for label in minutes.keys() & set(properties.get("LABELS", [])):
        budget = properties.get("TIMEOUT", float("inf")) / 240
        minutes[label] += budget * (2 if properties.get("RUN_SERIAL") else properties.get("PROCESSORS", 1)) / 2
        if budget > (40 if label == "full" else 30):
            wrong.append(f"{test['name']}: {budget:g} minutes")
if minutes["slow"] > 75 - 17:
    wrong.append(f"the tests labelled slow have {minutes['slow']:g} minutes on two cores, more than 58")
print("\n".join(wrong) if wrong else f"minutes on two cores: {minutes['slow']:g} for tests labelled slow, {minutes['full']:g} for full sets")
sys.exit(len(wrong) > 0)
