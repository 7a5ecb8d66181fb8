"""Stresses and displacements by other routes, and methods that the command line has as options."""

import json
import os
import subprocess

import numpy as np
import pytest
import steadyslide as ss
from scipy.integrate import quad
from test_bad_data import refused
from test_solution import COATINGS, EXAMPLES, TILTING, command_line

POISSON, FRICTION = 0.3, [0.1, 0.5]
KOLOSOV, MU = 3 - 4 * POISSON, 1 / (2 * (1 + POISSON))


@pytest.fixture(scope="module")
def solution():
    return ss.Problem(**TILTING).solve()


def integral(solution, kernel, cut=()):
    """Returns the integral of kernel(x', t, t_t) over the contact, by QUADPACK between singular points and cuts."""
    (contact,) = solution.contact
    ends = sorted({float(contact.left.x), 0.1, float(contact.right.x), *cut})
    return sum(quad(lambda x: kernel(x, solution.traction(x), solution.shear(x)), a, b, limit=400, epsabs=1e-11)[0]
               for a, b in zip(ends, ends[1:]))


def unscaled(x, z, shear=1):
    """Returns the kernels of 2 pi mu u_x and 2 pi mu u_z, [Joh85, chapter 2] with the constants left out."""
    def along(at, t, tt):
        d2, tt = (x - at) ** 2 + z * z, shear * tt
        return (t * (-(x - at) * z / d2 + (KOLOSOV - 1) / 2 * np.arctan2(x - at, z))
                - tt * ((KOLOSOV + 1) / 4 * np.log(d2) + z * z / d2))

    def down(at, t, tt):
        d2, tt = (x - at) ** 2 + z * z, shear * tt
        return (t * ((KOLOSOV + 1) / 4 * np.log(d2) - z * z / d2)
                + tt * ((x - at) * z / d2 + (KOLOSOV - 1) / 2 * np.arctan2(x - at, z)))
    return along, down


@pytest.mark.parametrize("x, z", [(0.2, 0.3), (-0.6, 0.05), (0.05, 0), (3, 2)])
def test_displacements_are_integrals_of_the_kernel(solution, x, z):
    values, errors = solution.displacement(x, z, errors=True)
    for part in (0, 1):
        for shear, agree in ((1, True), (-1, False), (1.01, False)):  # controls: the shear reversed, and one percent more
            there, origin = (integral(solution, unscaled(*point, shear)[part], {point[0]} if abs(point[0]) < 0.2 else ())
                             for point in ((x, z), (0, 0)))
            assert (abs((there - origin) / (2 * np.pi * MU) - values[part]) < 2e-8) == agree
    assert 0 < max(errors) < 1e-11


def test_displacements_belong_to_the_surface_and_to_the_gradient(solution):
    x = np.array([-0.7, -0.1, 0.1, 0.15, 1.5])
    assert np.allclose(-solution.displacement(x, 0).z, solution.at(x).displacement, rtol=0, atol=1e-12)
    assert solution.displacement(0, 0) == (0, 0)
    step, z = 1e-4, np.array([0.02, 0.3])
    stress = solution.stress(0.04, z)
    beside, before = solution.displacement(0.04 + step, z), solution.displacement(0.04 - step, z)
    below, above = solution.displacement(0.04, z + step), solution.displacement(0.04, z - step)
    assert np.allclose((beside.x - before.x) / (2 * step), stress.ux_x, atol=1e-4)
    assert np.allclose((below.z - above.z) / (2 * step), stress.uz_z, atol=1e-4)
    exact = ss.Problem(**TILTING).solve(digits=50).displacement("0.2", "0.3")
    assert all(abs(float(a) - b) < 1e-13 for a, b in zip(exact, solution.displacement("0.2", "0.3")))


@pytest.mark.parametrize("method", ["riemann-hilbert", "variational"])
@pytest.mark.parametrize("sliding", ["+x", "-x"])
def test_stresses_at_the_surface(method, sliding):
    solution = ss.Problem(**(TILTING | {"sliding": sliding})).solve(method=method)
    tolerance = 1e-6 if method == "riemann-hilbert" else 0.02
    x = np.array([-1.2, -0.15, 0.05, 0.15, 0.9])
    stress, near = solution.stress(x, 0), solution.stress(x, 1e-9 if method == "riemann-hilbert" else 1e-4)
    for name in ("xx", "zz", "xz", "yy", "von_mises", "ux_x", "uz_x", "ux_z", "uz_z"):
        assert np.allclose(getattr(stress, name), getattr(near, name), rtol=tolerance, atol=tolerance), name
    assert np.allclose(stress.zz, solution.traction(x), rtol=1e-13) and np.allclose(stress.xz, -solution.shear(x), rtol=1e-13)


def test_the_stress_along_the_surface_is_a_cauchy_integral(solution):
    (contact,) = solution.contact
    for x in (0.05, 0.15):
        a, b = x - 0.04, x + 0.04
        principal = quad(lambda at: solution.shear(at), a, b, weight="cauchy", wvar=x)[0]
        rest = integral(solution, lambda at, t, tt: 0 if a < at < b else tt / (at - x), {a, b})
        expected = solution.traction(x) + 2 / np.pi * (principal + rest)
        assert solution.stress(x, 0).xx == pytest.approx(expected, rel=1e-6)
        assert solution.stress(x, 0).xx != pytest.approx(solution.traction(x), rel=1e-2)  # control: no shear


def test_stresses_without_bound_are_unknown(solution):
    punch = ss.Problem(**COATINGS).solve()
    assert punch.stress(1, 0).zz == -np.inf
    assert np.isnan(punch.stress(1, 0).von_mises) and np.isnan(punch.stress([1.0], 0).von_mises[0])
    assert refused(lambda: ss.Problem(load=1, gamma="0.2", friction=[0], profile="0").solve().displacement(0, 1)) == (
        "displacement: no displacement below the surface; it needs the half-space's poisson in place of gamma; gamma")
    assert refused(lambda: ss.Problem(load=1, gamma="0.2", friction=[0], profile="0").solve().max_stress()) == (
        "max_stress: no von Mises stress; it needs the half-space's poisson in place of gamma; gamma")


@pytest.mark.parametrize("name, depth", [("parabola", None), ("two_coatings_forward", "0.1")])
def test_the_largest_stress_is_that_of_the_command_line(name, depth):
    file = str(EXAMPLES / f"{name}.toml")
    told = command_line(file, "--max-stress", *(["--depth", depth] if depth else []))["largest_stress"]
    largest = ss.Problem.from_toml(file).solve().max_stress(depth)
    assert [float(told[key]["value"]) for key in ("von_mises", "x", "z")] == [largest.von_mises, largest.x, largest.z]
    assert len(told["unbounded_at"]) == len(largest.unbounded_at)
    told = command_line(file, "--max-stress", "--over", "0.1")["largest_stress"]["average"]
    average = ss.Problem.from_toml(file).solve().max_stress(over="0.1")
    assert [float(told[key]["value"]) for key in ("von_mises", "x", "z")] == [average.von_mises, average.x, average.z]


def test_stresses_of_layers_are_those_of_the_command_line_and_pass_the_interface():
    layer = {"thickness": "0.2", "young": "1200", "poisson": "0.4"}
    solution = ss.Problem(load=5, base="rigid", layers=[layer, layer | {"young": "3000"}], friction=["0.1", "0.4"], jumps=[0],
                          profile="x^2/20").solve()
    upper, lower = solution.interface_stress()
    x = np.linspace(-1, 1, 4001)
    at, below = solution.stress(x, 0.2), solution.stress(x, 0.2 + 1e-9)
    for part in ("zz", "xz", "ux_x", "uz_x"):
        np.testing.assert_allclose(getattr(at, part), getattr(below, part), atol=1e-5 * np.abs(getattr(at, part)).max())
    assert upper.shear == pytest.approx(np.abs(at.xz).max(), rel=1e-4) and upper.tension == pytest.approx(at.zz.max(), rel=1e-3)
    assert abs(solution.stress(lower.shear_x, 0.4).xz) == pytest.approx(lower.shear, rel=1e-10)
    # The shear on the base carries the friction.
    wide = np.linspace(-8, 8, 8001)
    assert np.trapz(solution.stress(wide, 0.4).xz, wide) == pytest.approx(-solution.friction_force, rel=1e-6)
    # Springs under a deformed layer: the approach is between those of the two layers.
    assert solution.approach > 0 and solution.approach.error < 1e-8
    assert refused(lambda: solution.stress(0, "0.41")) == "z: in the rigid base; z is at most 0.4; 0.41"
    assert refused(lambda: solution.max_stress(over=1)).startswith("max_stress: body without a field; ")
    assert refused(lambda: solution.displacement(0, 0.1)).startswith("displacement: body without a field; ")


def test_load_steps_and_both_directions_are_those_of_the_command_line():
    file = str(EXAMPLES / "two_bumps.toml")
    problem = ss.Problem.from_toml(file)
    told = command_line(file, "--load-steps", "0.76:0.79:0.01")
    steps = problem.load_steps(["0.76", "0.77", "0.78", "0.79"])
    rows = [(float(s.problem.load), float(c.left.x), float(c.right.x)) for s in steps for c in s.contact]
    assert rows == [tuple(float(row[key]["value"] if isinstance(row[key], dict) else row[key]) for key in ("load", "left", "right"))
                    for row in told]
    both = problem.solve_both_directions()
    other = command_line(file, "--both-directions")["other_direction"]["resultants"]
    assert both.opposite.effective_friction == float(other["effective_friction"]["value"])
    assert both.as_given.effective_friction == problem.solve().effective_friction
    assert refused(lambda: ss.Problem(**COATINGS).load_steps([1, 0])) == "load: load out of range; the load is positive; 0"


def test_a_start_changes_nothing_beyond_the_errors():
    problem = ss.Problem(**TILTING)
    before = problem.with_(load="0.19").solve()
    cold, warm = problem.solve(), problem.solve(start=before)
    assert abs(cold.effective_friction - warm.effective_friction) <= cold.effective_friction.error + warm.effective_friction.error
    assert warm.residuals.equation < 1e-10 and 0 < warm.estimated_error.resultants < 1e-8


def test_pictures_are_those_of_the_command_line(tmp_path):
    for name in ("two_coatings_forward", "rough_surface"):
        file = str(EXAMPLES / f"{name}.toml")
        drawn = tmp_path / "drawn.svg"
        subprocess.run([os.environ["STEADYSLIDE_EXECUTABLE"], "solve", file, "--plot", drawn], check=True, capture_output=True)
        solution = ss.Problem.from_toml(file).solve()
        picture = solution.plot()
        assert picture == picture._repr_svg_() == drawn.read_text("utf-8")
        assert repr(picture).startswith("<steadyslide.Picture: ")
    solution.plot(tmp_path / "mine.pdf")
    assert (tmp_path / "mine.pdf").read_bytes().startswith(b"%PDF")
    assert refused(lambda: solution.plot(tmp_path / "mine.jpg")) == (
        "path: unknown kind of picture; its name ends in .svg, .pdf or .png; 'jpg'")


def test_notebooks_show_the_resultants():
    table = ss.Problem(**COATINGS).solve()._repr_html_()
    assert "<td>effective friction</td><td>0.282808</td>" in table and "<td>0.542981, 0.457019</td>" in table
    assert table.startswith("<table><caption>closed-form</caption>")


def test_a_missing_file_is_named():
    with pytest.raises(FileNotFoundError) as missing:
        ss.Problem.from_toml("no/such.toml")
    assert missing.value.errno == 2 and missing.value.filename == "no/such.toml"
