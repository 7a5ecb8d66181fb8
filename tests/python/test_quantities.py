"""Every output format has the quantities of one table, library/answer/quantities.hpp."""

import inspect
import json
import os
import subprocess

import pytest

import quantity_documents
import steadyslide as ss
from steadyslide import _core

ALL_KEYS = [key for _, key, _, _ in _core.quantities]
# The punch is rigid, flat and free to tilt, so that its solution has all quantities of the half-plane.
KEYS = [key for key in ALL_KEYS if key != "approach"]
TILTING_PUNCH = ss.Problem(load=1, load_at=0, poisson="0.3", friction=["0.1", "0.2"], jumps=[0], profile=0)


def printed(tmp_path, *arguments, command="solve", text=TILTING_PUNCH.text, code=0):
    file = tmp_path / "problem.toml"
    file.write_text(text, "utf-8")
    done = subprocess.run([os.environ["STEADYSLIDE_EXECUTABLE"], command, str(file), *arguments], capture_output=True, text=True)
    assert done.returncode == code
    return done.stdout + done.stderr


def lines_of(text, heading):
    """Returns the names in the block of lines below a heading."""
    block = text.split(heading)[1].split("\n\n")[0].split("\n")[1:]
    return [line[2:24].split("  ")[0].strip() for line in block]


def test_the_table_has_what_it_should():
    assert ALL_KEYS == ["normal", "friction_force", "centre_of_pressure", "effective_friction", "load_share", "contact_width",
                    "real_contact_length", "mean_pressure", "largest_pressure", "components", "tilt", "largest_average",
                    "largest_average_at", "approach", "core"]


@pytest.mark.parametrize("part", quantity_documents.PARTS, ids=lambda part: f"{part[0]}, {part[3].__name__}")
def test_documents_list_the_quantities(part):
    assert quantity_documents.found(part)[1] == quantity_documents.expected(part)


def test_every_rendering_has_the_same_keys(tmp_path):
    solution = TILTING_PUNCH.solve(over="1/10")
    assert list(solution.resultants._fields) == ALL_KEYS
    assert [key for key, value in solution.resultants._asdict().items() if value is None] == ["approach"]
    assert all(getattr(solution, key) == value for key, value in zip(ALL_KEYS, solution.resultants, strict=True))
    assert all(isinstance(inspect.getattr_static(ss.Solution, key), property) for key in KEYS)
    proved = [key for key in KEYS if not key.startswith("largest_average")]  # averages have estimates
    for arguments, keys in ((["--over", "1/10"], KEYS), (["--certify"], proved)):
        assert list(json.loads(printed(tmp_path, "--format", "json", *arguments))["resultants"]) == keys
        names = lines_of(printed(tmp_path, *arguments), "\nresultants ")
        assert sorted(name for name in names if name) == sorted(key.replace("_", " ") for key in keys)
    both = lines_of(printed(tmp_path, "--both-directions", "--over", "1/10"), "\nboth directions")
    assert {key for key in KEYS if not any(name.startswith(key.replace("_", " ")) for name in both)} == set()


def test_a_sweep_knows_the_same_keys(tmp_path):
    (tmp_path / "punch.toml").write_text(TILTING_PUNCH.text, "utf-8")
    sweep = 'problem = "punch.toml"\n[vary]\nload = [1]\n[output]\ncolumns = ["{}"]\n'
    refusal = printed(tmp_path, command="sweep", text=sweep.format("mood"), code=2)
    assert refusal.split("keys here are ")[1].split("; ")[0].split(", ")[-len(ALL_KEYS):] == ALL_KEYS
