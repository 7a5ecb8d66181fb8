#!/usr/bin/env python3
"""Tests that the output of `steadyslide verify --format json` fits docs/verify.schema.json, and that the schema refuses documents
that do not fit. The HTML of each text must have the words of the text, with every formula typeset.

usage: check_verify_schema.py PROGRAM SCHEMA
"""

import copy
import json
import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

import jsonschema

schema = json.loads(Path(sys.argv[2]).read_text(encoding="utf-8"))
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
failures = []


def answer(*options):
    command = [sys.argv[1], "verify", "--format", "json", *options]
    document = json.loads(subprocess.run(command, capture_output=True, check=True, encoding="utf-8").stdout)
    failures.extend(f"{' '.join(options)}: {error.json_path}: {error.message[:200]}" for error in validator.iter_errors(document))
    return document


class Said(HTMLParser):
    """The words of an HTML text without its formulas, and the numbers of formulas and of <code> elements."""

    def __init__(self, text):
        super().__init__()
        self.words, self.inside, self.formulas, self.code = "", 0, 0, 0
        self.feed(text)

    def handle_starttag(self, tag, _attributes):
        self.inside += tag == "math"
        self.formulas += tag == "math"
        self.code += tag == "code"

    def handle_endtag(self, tag):
        self.inside -= tag == "math"

    def handle_data(self, data):
        self.words += "" if self.inside else data


def faults(document):
    """Returns the texts, in the whole document, whose HTML has other words."""
    if isinstance(document, list):
        return [fault for one in document for fault in faults(one)]
    if not isinstance(document, dict):
        return []
    found = [fault for key, one in document.items() if key != "html" for fault in faults(one)]
    for key, text in document.get("html", {}).items():
        if key == "says":
            continue  # the formulas of this text are plain HTML, not <math>
        said, plain = Said(text), re.sub("`[^`]*`", "", document[key])
        if said.words != plain or bool(said.formulas) != ("`" in document[key]) or said.code:
            found.append(f"{key}: {document[key][:80]}: {said.words[:80]}")
    return found


listed = answer("--list")
document = answer("--quick", "--digits", "16", "--claim", "gamma-*", "--claim", "thm-16", "--claim", "eq-04-*")
failures += faults(listed) + faults(document)
if len(listed["claims"]) < 100 or not document["statements"] or not document["reading_notes"]:
    failures.append("hardly anything is listed")

changes = {
    "a key less": lambda d: d["claims"][0].pop("html"),
    "an unknown key": lambda d: d["statements"][0].update(colour="red"),
    "an unknown verdict": lambda d: d["claims"][0].update(verdict="likely"),
    "a text that is none": lambda d: d["claims"][0]["html"].update(statement=None),
    "an unknown fault": lambda d: d["reading_notes"][0].update(fault="nobody"),
    "a step from nowhere": lambda d: d["claims"][0]["proof"]["steps"][0].update({"from": [-1]}),
    "another schema": lambda d: d.update(schema=2),
}
for what, change in changes.items():
    broken = copy.deepcopy(document)
    change(broken)
    if validator.is_valid(broken):
        failures.append(f"control: {what} is not noticed")
for text in (document["reading_notes"][0]["printed"], "<code>x</code>", document["claims"][0]["html"]["statement"] + " no"):
    broken = copy.deepcopy(document)
    broken["claims"][0]["html"]["statement"] = text
    if not faults(broken):
        failures.append(f"control: not noticed: {text[:80]}")

print("\n".join(failures) or f"{len(listed['claims'])} claims, {len(changes)} controls")
sys.exit(1 if failures else 0)
