"""Solutions in Python agree with those of the command line, at 16 and 50 digits, and have the documented types."""

import json
import os
import pathlib
import pickle
import subprocess
import threading
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import steadyslide as ss

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"
COATINGS = {"load": 1, "poisson": "0.2", "friction": ["0.1", "0.5"], "jumps": [0], "profile": "0"}
TILTING = {"load": "0.2", "poisson": "0.3", "friction": ["0.1", "0.5"], "jumps": ["0.1"], "profile": "x^2/2"}


def command_line(file, *arguments):
    done = subprocess.run([os.environ["STEADYSLIDE_EXECUTABLE"], "solve", file, "--format", "json", *arguments],
                          capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


@pytest.mark.parametrize("name, digits", [("two_coatings_forward", 16), ("parabola_rough_rear", 16), ("two_bumps", 16),
                                          ("two_coatings_forward", 50), ("rounded_wedge", 50)])
def test_the_command_line_says_the_same(name, digits):
    file = str(EXAMPLES / f"{name}.toml")
    told = command_line(file, "--digits", str(digits), "--at", "1/7")
    solution = ss.Problem.from_toml(file).solve(digits=digits)

    def same(number, told):
        text = told["value"] if isinstance(told, dict) else told
        assert (number.digits if digits > 16 else float(text)) == (str(text) if digits > 16 else number)

    assert solution.method == told["method"]
    assert solution.solved
    same(solution.effective_friction, told["resultants"]["effective_friction"])
    same(solution.resultants.friction_force, told["resultants"]["friction_force"])
    for share, text in zip(solution.load_share, told["resultants"]["load_share"], strict=True):
        same(share, text)
    for component, ends in zip(solution.contact, told["contact"], strict=True):
        for side in ("left", "right"):
            same(getattr(component, side).x, ends[side]["x"])
            same(getattr(component, side).intensity, ends[side]["intensity"])
    for point, text in zip(solution.singular_points, told["singular_points"], strict=True):
        same(point.x, text["x"])
        assert (point.kind, point.symbolic) == (text["kind"], text["symbolic"])
    sample = told["samples"][0]
    same(solution.traction(Fraction(1, 7)), sample["traction"])
    same(solution.shear("1/7"), sample["shear"])
    same(solution.gap("1/7"), sample["gap"])
    same(solution.slope("1/7"), sample["slope"])


def test_numbers_are_exact_however_they_are_written():
    same = [ss.Problem(**(COATINGS | {"poisson": nu})) for nu in ("0.2", 0.2, Decimal("0.2"), Fraction(1, 5), np.float64(0.2),
                                                                  mpmath.mpf("0.2"))]
    assert len({p.solve(digits=50).effective_friction.digits for p in same}) == 1
    assert same[0] == same[1] == same[2] != same[3]
    assert ss.Problem(**(COATINGS | {"load": np.int32(1), "friction": np.array([0.1, 0.5])})) == same[0]


def test_arrays_have_the_shape_of_their_places():
    solution = ss.Problem(**COATINGS).solve()
    x = np.linspace(-0.9, 0.9, 6).reshape(2, 3) + 0.01
    for what in (solution.traction, solution.shear, solution.gap, solution.slope):
        values, errors = what(x, errors=True)
        assert values.shape == errors.shape == x.shape == what(x).shape
        assert np.all(np.abs(what(x) - values) <= 1e-13)
        assert np.all(errors < 1e-12)
    assert np.allclose(solution.shear([-0.5, 0.5]), [-0.1, -0.5] * solution.traction([-0.5, 0.5]), rtol=1e-15)
    assert np.isnan(solution.gap([2.0]))[0]
    assert solution.traction(0.5) == solution.traction("0.5") and solution.traction(0.5).error < 1e-14


def test_more_digits_are_mpmath_numbers():
    solution = ss.Problem(**COATINGS).solve(digits=50)
    with mpmath.workdps(60):
        found = solution.traction("1/2")
        assert isinstance(found, mpmath.mpf) and found.error < 1e-50
        assert abs(found + mpmath.mpf("0.35655291651384204495378157903613372561292925249359")) < mpmath.mpf("1e-49")
        array = solution.traction(["1/2", 0.25])
        assert array.dtype == object and array[0] == found


def test_results_are_data_with_all_their_digits():
    place = "0.12345678901234567891"
    solution = ss.Problem(**(COATINGS | {"jumps": [place]})).solve(digits=50)
    at = solution.singular_points[1].x
    assert mpmath.mp.dps < 20 and solution.traction(at) == solution.traction(place) == -mpmath.inf
    assert ss.Problem(**(COATINGS | {"load": at})).load == Fraction(place)


def test_the_load_is_the_integral_of_the_pressure():
    solution = ss.Problem(**TILTING).solve()
    (component,) = solution.contact
    x, weights = np.polynomial.chebyshev.chebgauss(2000)
    middle, half = (component.right.x + component.left.x) / 2, (component.right.x - component.left.x) / 2
    load = np.sum(-solution.traction(middle + half * x) * weights * np.sqrt(1 - x * x)) * half
    assert load == pytest.approx(0.2, rel=1e-4)
    assert float(solution.at(component.right.x).cumulative_load) == pytest.approx(0.2, rel=1e-9)


def test_stresses_reach_the_tractions_and_are_in_equilibrium():
    solution = ss.Problem(**TILTING).solve()
    x = np.array([-0.2, 0.05, 0.15])
    near = solution.stress(x, 1e-9)
    assert np.allclose(near.zz, solution.traction(x), rtol=1e-6) and np.allclose(near.xz, -solution.shear(x), rtol=1e-6)
    values, errors = solution.stress(x[:, None], np.array([[0.1, 0.7]]), errors=True)
    assert values.xx.shape == errors.von_mises.shape == (3, 2) and np.all(errors.xx < 1e-10)
    assert np.allclose(values.yy, 0.3 * (values.xx + values.zz), rtol=1e-14)
    step = 1e-4  # d sigma_xx/dx + d sigma_xz/dz = 0
    beside, below = (solution.stress(0.05 + step, 0.3).xx - solution.stress(0.05 - step, 0.3).xx,
                     solution.stress(0.05, 0.3 + step).xz - solution.stress(0.05, 0.3 - step).xz)
    assert beside + below == pytest.approx(0, abs=1e-8)
    exact = ss.Problem(**TILTING).solve(digits=50).stress("0.05", "0.1")
    assert isinstance(exact.von_mises, mpmath.mpf)
    assert float(exact.von_mises) == pytest.approx(solution.stress(0.05, 0.1).von_mises, rel=1e-12)
    assert ss.Problem(load=1, gamma="0.2", friction=["0.1"], profile="0").solve().stress(0, 1).yy is None


@pytest.mark.parametrize("order", [1, 2])
def test_nodal_forces_sum_up_to_load_and_friction_and_keep_the_moment(order):
    solution = ss.Problem(**COATINGS).solve()
    nodes = np.linspace(-1.5, 1.5, 25)
    forces = solution.nodal_forces(nodes, order=order)
    assert forces.normal.sum() == pytest.approx(1, rel=1e-13)
    assert forces.tangential.sum() == pytest.approx(solution.resultants.friction_force, rel=1e-13)
    assert nodes @ forces.normal == pytest.approx(solution.resultants.centre_of_pressure, rel=1e-12)
    assert np.all(forces.normal_error < 1e-12)
    # The shape function of one element times the traction, by another quadrature.
    if order == 1:
        places, weights = np.polynomial.legendre.leggauss(40)
        x = (nodes[17] + nodes[18]) / 2 + (nodes[18] - nodes[17]) / 2 * places
        rising = np.sum(weights * -solution.traction(x) * (1 + places) / 2) * (nodes[18] - nodes[17]) / 2
        x = (nodes[18] + nodes[19]) / 2 + (nodes[19] - nodes[18]) / 2 * places
        falling = np.sum(weights * -solution.traction(x) * (1 - places) / 2) * (nodes[19] - nodes[18]) / 2
        assert forces.normal[18] == pytest.approx(rising + falling, rel=1e-10)


def test_pickled_problems_and_results_are_the_same():
    problem = ss.Problem.from_toml(EXAMPLES / "two_bumps.toml")
    assert pickle.loads(pickle.dumps(problem)) == problem
    for digits in (16, 50):
        solution = problem.solve(digits=digits)
        again = pickle.loads(pickle.dumps(solution))
        assert again.effective_friction == solution.effective_friction
        number = pickle.loads(pickle.dumps(solution.effective_friction))
        assert (number, number.error) == (solution.effective_friction, solution.effective_friction.error)


def test_warnings_are_those_of_the_command_line():
    notch = ss.Problem(load=1000, gamma="0.5", friction=[1], pieces=[("1/4", "x/8"), (1, "1/16 - x/8")])
    told = subprocess.run([os.environ["STEADYSLIDE_EXECUTABLE"], "solve", "-", "--format", "json"], input=notch.text,
                          capture_output=True, text=True, check=True)
    for digits in (16, 50):
        solution = notch.solve(digits=digits)
        (gap,) = solution.unresolved_gaps
        assert float(gap.x) == pytest.approx(0.25, rel=1e-15) and gap.x.error < 1e-15
        assert gap.log10_length < -1000
        (line,) = solution.warnings
        assert line.endswith(f"x = 0.25 (about 1e{gap.log10_length:.0f})")
        assert [line] == json.loads(told.stdout)["warnings"]
    plain = ss.Problem(**COATINGS).solve()
    assert plain.warnings == plain.unresolved_gaps == []


def test_no_convergence_raises_nothing():
    solution = ss.Problem(**(TILTING | {"load": 1000, "friction": [3, 0]})).solve(method="variational", cells=16)
    assert solution.solved == (solution.failed_condition == "")
    assert repr(solution).startswith("<steadyslide.Solution by variational: ")


def test_threads_get_what_one_gets():
    loads = ["0.1", "0.2", "0.3", "0.4"]
    for digits in (16, 50):
        with ThreadPoolExecutor(4) as threads:
            together = list(threads.map(lambda load: ss.Problem(**(TILTING | {"load": load})).solve(digits=digits), loads))
        alone = [ss.Problem(**(TILTING | {"load": load})).solve(digits=digits) for load in loads]
        assert [s.effective_friction for s in together] == [s.effective_friction for s in alone]


def test_the_interpreter_runs_while_a_solve_does():
    solved = threading.Event()
    problem = ss.Problem(**(TILTING | {"profile": "x^4+x^2/7"}))
    thread = threading.Thread(target=lambda: (problem.solve(digits=100), solved.set()))
    thread.start()
    steps = 0
    while not solved.is_set():
        steps += 1
    thread.join()
    assert steps > 1000


@pytest.mark.parametrize("executor", [None, ThreadPoolExecutor, ProcessPoolExecutor])
def test_sweeps_have_the_rows_of_single_solves(executor):
    base = ss.Problem(**COATINGS)
    vary = {"friction.values[1]": ["0.3", "1/2"], "half_space.poisson": [0.1, "0.2", "0.3"]}
    columns = ["effective_friction", "load_share[0]", "contact[0].left.x", "largest_pressure", "contact[3].width"]
    if executor is None:
        table = ss.sweep(base, vary, columns)
    else:
        with executor(2) as workers:
            table = ss.sweep(base, vary, columns, executor=workers)
    assert table.dtype.names == (*vary, *columns, "failed_condition")
    rows = [(f, nu) for f in ("0.3", "1/2") for nu in ("0.1", "0.2", "0.3")]
    for row, (friction, poisson) in zip(table, rows, strict=True):
        solution = ss.Problem(**(COATINGS | {"friction": ["0.1", friction], "poisson": poisson})).solve()
        assert row["friction.values[1]"] == float(Fraction(friction)) and row["half_space.poisson"] == float(poisson)
        assert row["effective_friction"] == solution.effective_friction
        assert row["load_share[0]"] == solution.load_share[0]
        assert (row["contact[0].left.x"], row["largest_pressure"], row["failed_condition"]) == (-1, np.inf, "")
        assert np.isnan(row["contact[3].width"])


def test_data_that_change_together():
    base = ss.Problem(**COATINGS)
    together = ("load", "friction.values[0]")
    table = ss.sweep(base, {together: [(1, "0.1"), (2, "0.2")], "half_space.poisson": ["0.1", "0.2"]}, iterations=50,
                     method="variational", cells=64)
    errors = ss.sweep(base, {"load": [1]}, ["effective_friction_error", "contact.size", "singular_points[0].x_error"])
    solution = base.solve()
    assert tuple(errors[0])[1:] == (solution.effective_friction.error, 1, solution.singular_points[0].x.error, "")
    assert table.dtype.names == (*together, "half_space.poisson", "effective_friction", "failed_condition")
    assert [tuple(row)[:3] for row in table] == [(1, 0.1, 0.1), (1, 0.1, 0.2), (2, 0.2, 0.1), (2, 0.2, 0.2)]
    with pytest.raises(ss.InvalidData, match="vary: wrong number of values for "):
        ss.sweep(base, {together: [(1, "0.1"), 2]})


def test_columns_are_those_of_the_command_line():
    columns = ["method", "contact[0].right.kind", "load_share_error[0]", "load_share[0]_error"]
    table = ss.sweep(ss.Problem(**COATINGS), {"load": [1, 2]}, columns)
    assert list(table["method"]) == ["closed-form"] * 2 and list(table["contact[0].right.kind"]) == ["edge"] * 2
    assert 0 < table["load_share_error[0]"][0] == table["load_share[0]_error"][0] < 1e-12


def test_exponents_and_their_derivation():
    problem = ss.Problem(**COATINGS)
    points = problem.exponents(digits=50)
    assert points[0].symbolic == "-1/2 - arctan(3/80)/pi"
    assert ("0", "friction_jump", "arctan(3/80)/pi - arctan(3/16)/pi") in [(p.x, p.kind, p.symbolic) for p in points]
    with mpmath.workdps(60):
        exact = -mpmath.mpf(1) / 2 - mpmath.atan(mpmath.mpf(3) / 80) / mpmath.pi
        assert abs(points[0].exponent - exact) <= points[0].exponent.error < 1e-49
        assert abs(problem.exponents()[0].exponent - exact) <= problem.exponents()[0].exponent.error < 1e-15
        assert abs(problem.solve().contact[0].left.exponent - exact) <= problem.solve().contact[0].left.exponent.error < 1e-15
    assert "assume" in problem.derivation()


@pytest.mark.parametrize("digits", [7, 16, 17, 34, 50, 61, 100])
def test_errors_include_the_rounding_to_digits(digits):
    problem = ss.Problem(load=1, gamma="3/8", friction=["1/10", "1/2"], jumps=["1/11"], profile="0", support=["-1/7", "1/3"])
    solution = problem.solve(digits=digits)
    (contact,) = solution.contact
    found = {"left": (contact.left.x, Fraction(-1, 7)), "right": (contact.right.x, Fraction(1, 3)),
             "width": (contact.width, Fraction(10, 21)), "jump": (solution.singular_points[1].x, Fraction(1, 11))}
    with mpmath.workdps(150):
        for name, (x, exact) in found.items():
            assert abs(mpmath.mpf(x) - mpmath.mpf(exact.numerator) / exact.denominator) <= x.error < mpmath.mpf(10)**(1 - digits), name
        more = problem.solve(digits=100)
        for one, other in zip(solution.load_share, more.load_share):
            assert abs(mpmath.mpf(one) - other) <= one.error + other.error
        exact = -mpmath.mpf(1) / 2 + mpmath.atan(mpmath.mpf(3) / 16) / mpmath.pi
        exponent = contact.right.exponent
        assert abs(exponent - exact) <= exponent.error


def test_proofs_have_certificates(tmp_path):
    proof = ss.Problem(**COATINGS).solve().certify()
    assert proof.proved
    proof.save(tmp_path / "proof.json")
    assert json.loads((tmp_path / "proof.json").read_text())["claims"]["exists"] is True
    assert proof.unresolved_gaps == []
    notch = ss.Problem(load=1000, gamma="0.5", friction=[1], pieces=[("1/4", "x/8"), (1, "1/16 - x/8")])
    refused = notch.solve().certify()
    assert not refused.proved
    (gap,) = refused.unresolved_gaps
    assert float(gap.x) == pytest.approx(0.25, rel=1e-15) and gap.log10_length < -1000


def test_a_proof_on_cells_needs_the_whole_support():
    problem = ss.Problem(load="0.01", poisson="0.3", friction=["0.3"], profile="x^2/2")
    assert problem.solve(method="variational", cells=512).certify().proved
    refused = problem.solve(method="variational", accuracy=1e-3).certify()
    assert not refused.proved
    assert refused.reason == ("the cells lie on the contact; a proof needs equal cells on the whole support: "
                              "cells = 4096")


def test_the_module_says_what_it_is():
    assert ss.__version__.count(".") == 2
    for name in ss.__all__:
        assert getattr(ss, name).__doc__
