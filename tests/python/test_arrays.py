"""Arrays give the problems of files and lists, exactly, and their errors with the index of the number."""

from fractions import Fraction

import numpy as np
import pytest
import steadyslide as ss
from test_bad_data import NUMBER, refused

X = np.linspace(-1, 1, 9)
HEIGHTS = X * X / 3
SLIDER = {"load": 3, "poisson": "0.48", "young": 1200}


def test_two_arrays_are_the_trace_of_a_file(tmp_path):
    file = tmp_path / "trace.csv"
    file.write_text("".join(f"{x!r},{h!r}\n" for x, h in zip(X.tolist(), HEIGHTS.tolist())))
    units = {"x_unit": "mm", "height_unit": "um", "detrend": "line"}
    for of_file, of_arrays in [(file, (X, HEIGHTS)), (str(file), [X.tolist(), HEIGHTS.tolist()]), (file, np.array([X, HEIGHTS])),
                               ({"file": str(file)} | units, {"file": (X, HEIGHTS)} | units)]:
        one, other = (ss.Problem(friction=["0.2"], samples=samples, **SLIDER) for samples in (of_file, of_arrays))
        assert one.support == other.support == (-1, 1)
        assert one.solve().resultants == other.solve().resultants
    # The text of the problem has the arrays, too.
    assert ss.Problem.from_string(other.text) == other and ss.Problem.from_string(other.text).solve().solved
    assert len(repr(other)) < 600


def test_edges_and_values_are_jumps_and_values():
    listed = ss.Problem(friction=["0.1", "0.5", 0.25], jumps=["-1/2", 0.25], profile=0, **SLIDER)
    for edges in ([-0.5, 0.25], np.array([-1, -0.5, 0.25, 1])):
        problem = ss.Problem(friction=(edges, np.array([0.1, 0.5, 0.25])), profile=0, **SLIDER)
        assert problem.friction == listed.friction == [Fraction(1, 10), Fraction(1, 2), Fraction(1, 4)]
        assert problem.jumps == listed.jumps == [Fraction(-1, 2), Fraction(1, 4)]
        assert problem.solve().effective_friction == listed.solve().effective_friction
    assert listed.load == 3 and listed.support == (-1, 1)
    assert listed.with_(friction=([0], [0.1, 0.2])).jumps == [0]
    assert listed.with_(load="1/3").load == Fraction(1, 3)


def test_changed_arrays():
    problem = ss.Problem(friction=["0.2"], samples=(X, HEIGHTS), **SLIDER)
    lower = problem.with_(**{"indenter.samples": (X, 2 * HEIGHTS)})
    assert lower.solve().contact_width < problem.solve().contact_width
    assert problem.with_(**{"indenter.samples": None, "indenter.profile": "x^2/3"}).solve().solved


@pytest.mark.parametrize("data, message", [
    ({"samples": (X, HEIGHTS[1:])}, "indenter.samples: columns of different lengths; each x has one value; 9 and 8"),
    ({"samples": ([0, -1], [0, 0])}, "indenter.samples[1]: x: not increasing; x increases from line to line; -1 after 0"),
    ({"samples": ([0, 1], [0, float("nan")])}, f"indenter.samples[1]: psi: not a number; {NUMBER}; 'nan'"),
    ({"samples": {"file": ([0, 1], [0, "one"])}}, f"indenter.samples.file[1]: psi: not a number; {NUMBER}; 'one'"),
    ({"samples": ([], [])}, "indenter.samples[0]: too few points; a trace has at least 2; 0 points"),
    ({"samples": ([0, None], [0, 0])}, "indenter.samples[1]: wrong type; a number is a string, an integer or a decimal; NoneType"),
    ({"profile": 0, "friction": ([0, 0], [1, 2, 3])}, "friction.jumps[1]: jumps not in order; jumps increase from left to right; 0 after 0"),
    ({"profile": 0, "friction": ([0, 0.5], [1, 2])},
     "friction.jumps: wrong number of jumps; there is one jump fewer than friction values; 2 values, 2 jumps"),
    ({"profile": 0, "friction": ([-1, 0, 2], [1, 2])},
     "friction: edges are not the ends of the indenter; they lie between them, or reach from -1 to 1; -1 to 2"),
    ({"profile": 0, "friction": ([0], [1, 2]), "jumps": [0]},
     "friction.jumps: conflicting key; edges and values leave it out; present"),
])
def test_bad_arrays(data, message):
    assert refused(lambda: ss.Problem(**({"friction": ["0.2"]} | SLIDER | data))) == message


@pytest.mark.parametrize("digits", [16, 50])
def test_no_places_have_no_values(digits):
    solution = ss.Problem(load=1, poisson="0.2", friction=["0.2"], profile="0").solve(digits=digits)
    assert solution.at([]).gap.shape == solution.at([]).traction[1].shape == solution.traction([]).shape == (0,)
    assert solution.stress([], 1).xx.shape == solution.displacement([], 1).z.shape == (0,)
    assert solution.traction(np.array(0.5)) == solution.traction("0.5") == solution.at(np.array(0.5)).traction[0]


def test_all_quantities_at_many_places():
    solution = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0").solve()
    places = [[-0.5, 0], [0.5, 2]]
    sample = solution.at(places)
    for k, x in enumerate(np.ravel(places)):
        single = solution.at(x)
        assert sample.traction[0].ravel()[k] == single.traction[0] and sample.shear[1].ravel()[k] == single.shear[1]
        assert sample.cumulative_load.ravel()[k] == single.cumulative_load
    assert sample.gap.shape == (2, 2) and np.isnan(sample.gap[1, 1]) and solution.at(2).gap is None
