"""Makes the parts of documents that list the quantities of an answer, from the table in library/answer/quantities.hpp.

    python3 tests/python/quantity_documents.py      # writes them; set PYTHONPATH to the module of the build
"""

import pathlib
import re

from steadyslide import _core

ROOT = pathlib.Path(__file__).resolve().parents[2]
PYTHON_TYPES = {"One": "Number", "OfEachFriction": "list[Number]", "Largest": "LargestPressure", "Count": "int",
                "IfAny": "Number | None", "Interval": "Interval | None"}
SCHEMA_TYPES = {"One": '{"$ref": "#/$defs/number"}',
                "OfEachFriction": '{"type": "array", "items": {"$ref": "#/$defs/number"}}',
                "Largest": '{"$ref": "#/$defs/largest_pressure"}',
                "Count": '{"type": "integer", "minimum": 0}',
                "IfAny": '{"$ref": "#/$defs/number"}',
                "Interval": '{"$ref": "#/$defs/both_limits"}'}
MAY_BE_ABSENT = ("IfAny", "Interval")


def markdown(rows):
    return "".join(f"| – `{key}` | {meaning} | {unit} |\n" for _, key, unit, meaning in rows)


def schema(rows):
    required = ",\n".join(f'        "{key}"' for kind, key, _, _ in rows if kind not in MAY_BE_ABSENT)
    properties = ",\n".join(f'        "{key}": {SCHEMA_TYPES[kind]}' for kind, key, _, _ in rows)
    return (f'      "type": "object",\n      "additionalProperties": false,\n      "required": [\n{required}\n      ],\n'
            f'      "properties": {{\n{properties}\n      }}\n')


def fields(rows):
    return "".join(f"    {key}: {PYTHON_TYPES[kind]}\n" for kind, key, _, _ in rows)


# Each part: a file, the line before the part, the line behind it, and the part's text.
PARTS = [
    ("docs/results.md", "largest pressure is finite | |\n", "| `samples[]`", markdown),
    ("docs/solve.schema.json", '    "resultants": {\n', '    },\n    "sample": {', schema),
    ("bindings/python/steadyslide/_results.py", "no such number.\"\"\"\n\n", "\n\nfor _key, ", fields),
    ("bindings/python/steadyslide/_solution.py", "they are set below the class.\n", "\n    def __init__(self, problem: ", fields),
]


def found(part):
    """Returns the text of the file before the part, the part, and the text behind it."""
    file, before, behind, _ = part
    match = re.fullmatch(f"(.*{re.escape(before)})(.*?)({re.escape(behind)}.*)", (ROOT / file).read_text("utf-8"), re.DOTALL)
    return match.groups()


def expected(part):
    return part[3](_core.quantities)


if __name__ == "__main__":
    for one in PARTS:
        before, _, behind = found(one)
        (ROOT / one[0]).write_text(before + expected(one) + behind, "utf-8")
