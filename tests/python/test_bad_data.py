"""Bad data raise InvalidData, a ValueError, with the message of the command line."""

import json
import os
import pathlib
import re
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import steadyslide as ss

GOOD = {"load": 1, "poisson": "0.2", "friction": ["0.1", "0.5"], "jumps": [0], "profile": "0"}
NUMBER = "a number is written like 2, -0.25, 1e-3 or 1/3"
TYPE = "wrong type; a number is a string, an integer or a decimal"

LISTED = json.loads((pathlib.Path(__file__).parent / "bad_data.json").read_text(encoding="utf-8"))
BAD_PYTHON_DATA = [
    ({"load": float("nan")}, f"load: not a number; {NUMBER}; 'nan'"),
    ({"load": float("inf")}, f"load: not a number; {NUMBER}; 'inf'"),
    ({"load": 1j}, f"load: {TYPE}; complex"),
    ({"load": object}, f"load: {TYPE}; type"),
    ({"poisson": Fraction(1, 2)}, "half_space.poisson: Poisson's ratio out of range; it lies in ]-1, 1/2[; 0.5"),
]


def refused(call):
    with pytest.raises(ss.InvalidData) as caught:
        call()
    assert isinstance(caught.value, ValueError)
    return str(caught.value)


@pytest.mark.parametrize("change, message", LISTED["keywords"] + BAD_PYTHON_DATA)
def test_keywords(change, message):
    assert refused(lambda: ss.Problem(**(GOOD | change))) == message


@pytest.mark.parametrize("options, message", LISTED["options"])
def test_options(options, message):
    assert refused(lambda: ss.Problem(**GOOD).solve(**options)) == message


def test_a_method_that_does_not_apply():
    problem = ss.Problem(**(GOOD | {"profile": "x^4"}))
    assert refused(lambda: problem.solve(method="closed-form")).startswith("method closed-form: no closed form applies; ")


def test_problems_from_others():
    problem = ss.Problem.from_string("load = 1\nhalf_space = {poisson = \"0.2\"}\nfriction = {values = [\"0.1\"]}\n"
                                     "indenter = {profile = \"x^2\"}\n", "file.toml")
    assert refused(lambda: problem.with_(load=-1)) == "load: load out of range; the load is positive; -1"
    assert refused(lambda: problem.load_steps("12")) == "loads: wrong type; they are a list of numbers; '12'"
    assert refused(lambda: problem.load_steps([1], start=None)).startswith("start: conflicting option; ")
    pieces = problem.with_(**{"indenter.profile": None, "indenter.pieces": [(0, "-x"), (1, "x")]})
    assert pieces.solve().solved
    with pytest.raises(TypeError):
        ss.Problem.from_toml(None)


def test_places_and_meshes():
    solution = ss.Problem(**GOOD).solve()
    assert refused(lambda: solution.traction("here")) == f"x: not a number; {NUMBER}; 'here'"
    assert refused(lambda: solution.at(None)) == f"x: {TYPE}; NoneType"
    assert refused(lambda: solution.gap([0.5, float("nan")])) == f"x[1]: not a number; {NUMBER}; 'nan'"
    assert refused(lambda: solution.shear([1j])) == f"x: {TYPE}; complex"
    for call in (solution.stress, solution.displacement):
        assert refused(lambda: call(0, -1)).endswith(": above the surface; a depth is at least 0; -1")
    assert refused(lambda: solution.stress([0, 0], [1, -0.5])) == "z[1]: above the surface; a depth is at least 0; -0.5"
    assert refused(lambda: solution.max_stress(-1)) == "depth: above the surface; a depth is at least 0; -1"
    assert refused(lambda: solution.stress(0, "deep")) == f"z: not a number; {NUMBER}; 'deep'"
    assert refused(lambda: solution.stress(["1/2", "a"], 1)) == f"x[1]: not a number; {NUMBER}; 'a'"
    assert refused(lambda: solution.stress("1/0", 1)) == f"x: not a number; {NUMBER}; '1/0'"
    assert refused(lambda: solution.nodal_forces([-1, "a"])) == f"nodes[1]: not a number; {NUMBER}; 'a'"
    assert refused(lambda: solution.nodal_forces([-1, 1], order=3)) == "order: wrong order; elements are of order 1 or 2; 3"
    assert refused(lambda: solution.nodal_forces([-1, 0, 2, 3, 4], order=2)).startswith("nodes[1]: node off the middle; ")
    assert refused(lambda: solution.nodal_forces([-1, 1, 0])).startswith("nodes[2]: not increasing; ")
    assert refused(lambda: solution.nodal_forces([-1, 0.5])).startswith("nodes[1]: contact outside the mesh; ")


def with_changes(good, changes):
    """Returns the text of a file that differs from the good one. bad_files.txt describes the notation of changes."""
    tables = {}
    for line in (good + "\n" + changes).splitlines():
        table, key, value = re.fullmatch(r"~ (?:(\[\S+\]) ?)?([^=]*?)( = .*)?", line).groups()
        tables.setdefault(table, {})[key] = key + value if value else None
    return "\n".join(line for table, entries in tables.items() for line in [table, *entries.values()] if line)


def test_files_as_the_command_line_refuses_them(tmp_path, monkeypatch):
    listed = pathlib.Path(__file__).parents[1] / "app" / "problem_file" / "bad_files.txt"
    (tmp_path / "trace.csv").write_text("-1,1/4\n0,0\n1,1/2\n")
    bad = tmp_path / "bad.toml"
    monkeypatch.chdir(tmp_path)  # messages on traces name the path beside the problem file
    sections, good = listed.read_text(encoding="utf-8").split("\n=== ")[1:], ""
    for section in sections:
        message, _, text = section.rstrip("\n").partition("\n")
        if message.startswith("good"):
            good = text
            continue
        if text.startswith("~ "):
            text = with_changes(good, text)
        bad.write_text(text + "\n", encoding="utf-8")
        assert refused(lambda: ss.Problem.from_toml("bad.toml")) == "bad.toml:" + message
    assert len(sections) >= 70


@pytest.mark.parametrize("name", ["/no/such/file", ".", "locked.toml"])
def test_files_that_cannot_be_read_as_python_says_it(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "locked.toml").symlink_to("locked.toml")  # a link to itself: root cannot read it either
    with pytest.raises(OSError) as told:
        ss.Problem.from_toml(name)
    with pytest.raises(OSError) as expected:
        open(name, encoding="utf-8")
    one, other = told.value, expected.value
    assert type(one) is type(other) and str(one) == str(other)
    assert (one.errno, one.strerror, one.filename) == (other.errno, other.strerror, other.filename)


def test_pipes_are_refused(tmp_path):
    pipe = str(tmp_path / "pipe")
    os.mkfifo(pipe)
    assert (refused(lambda: ss.Problem.from_toml(pipe))
            == f"{pipe}:1: no regular file; a problem file is one, or comes from the standard input; a pipe")


def test_keys_that_are_none():
    problem = ss.Problem(**GOOD)
    for key in ("x y", "a = 1\nb", "ä", '"'):
        assert refused(lambda: problem.with_(**{key: 1})).startswith("unknown key; the keys of a problem file are load, ")
    assert refused(lambda: problem.with_(**{"x y": 1})).endswith("; 'x y'")
    assert refused(lambda: problem.with_(**{"half_space.x y": 1})).endswith("; 'x y'")
    for path in ("", "friction[0", "friction..values", "[0]"):
        assert refused(lambda: problem.with_(**{path: 1})) == f"{path}: no such datum; it names one of the problem's; absent"


def test_depths_that_double_has_not():
    problem = ss.Problem(**GOOD)
    solution = problem.solve()
    rule = "z: depth too small for 16 digits; its square is a number of that precision; ask for 50 digits; "
    assert np.isfinite(solution.stress(0, 1e-153).von_mises)
    assert refused(lambda: solution.stress(0, 1e-154)) == rule + "1e-154"
    assert refused(lambda: solution.stress([0, 0], [1, 1e-320])) == rule + "1e-320"
    assert mpmath.isfinite(problem.solve(digits=50).stress(0, "1e-320").von_mises)


def test_sweeps():
    problem = ss.Problem(**GOOD)
    assert refused(lambda: ss.sweep(problem, {})) == "vary: no data; a sweep varies at least one; none"
    assert refused(lambda: ss.sweep(problem, {"load": []})) == "vary: no values; each datum has at least one; none"
    for values in ("1:2:1", b"12", {"random": 2, "from": 1, "to": 2, "seed": 3}, 5):
        assert (refused(lambda: ss.sweep(problem, {"load": values}))
                == f"vary: no list of values for load; each datum takes a list of them, like ['1', '2']; {values!r}")
    assert len(ss.sweep(problem, {"load": (load for load in (1, 2))})) == 2
    assert (refused(lambda: ss.sweep(problem, {"load": [1]}, columns=["mood"]))
            == "columns: unknown column; it names a result, like contact[0].left.x; 'mood'")
    assert (refused(lambda: problem.with_(**{"friction.values[2]": 1}))
            == "friction.values[2]: no such datum; it names one of the problem's; absent")
    failed = ss.sweep(problem, {"load": [1, -1]})["failed_condition"]
    assert list(failed) == ["", "load: load out of range; the load is positive; -1"]
