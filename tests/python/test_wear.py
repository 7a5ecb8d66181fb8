"""Wear by an unrelated route: dense matrices, logarithms integrated by hand, and pivots by Lemke, in numpy; and explicit steps."""

import unittest

import numpy as np

import steadyslide as ss

CELLS, K, S = 32, (1.0, 3.0, 0.5), (0.1, 0.5, 0.2)
EDGES = np.linspace(-1, 1, CELLS + 1)
X, H = (EDGES[1:] + EDGES[:-1]) / 2, EDGES[1] - EDGES[0]


def problem(**more):
    """c = 1, gamma = 1/2, f = 2 s; the coatings end at ends of cells."""
    return ss.Problem(load=2, gamma="0.5", friction=["0.2", "1", "0.4"], jumps=["-0.25", "0.5"], profile="x^2/2",
                      wear={"coefficients": ["1", "3", "0.5"]}, **more)


def of_coatings(values):
    return np.where(X < -0.25, values[0], np.where(X < 0.5, values[1], values[2]))


def matrix():
    """Mean displacements of cells under forces on cells: -(1/pi) log|x - x'| and the friction before x."""
    def twice(x):
        return np.where(x == 0, 0, x * x / 2 * np.log(np.abs(x) + (x == 0)) - 3 * x * x / 4)
    d = X[:, None] - X[None, :]
    log = (twice(d + H) - 2 * twice(d) + twice(d - H)) / H**2
    friction = np.tril(np.ones((CELLS, CELLS)), -1) + np.eye(CELLS) / 2
    return -log / np.pi + friction * of_coatings(S)[None, :]


def contact(influence, gap, load):
    """Forces q >= 0, sum q = load, gap + influence q - C >= 0, complementary: all sets of one growing load, by pivots."""
    active = [int(np.argmin(gap))]
    for _ in range(1000):
        n = len(active)
        system = np.block([[influence[np.ix_(active, active)], -np.ones((n, 1))], [np.ones((1, n)), np.zeros((1, 1))]])
        q, c = np.split(np.linalg.solve(system, np.append(-gap[active], load)), [n])
        forces = np.zeros(CELLS)
        forces[active] = q
        open_ = gap + influence @ forces - c
        worst = min(range(CELLS), key=lambda i: forces[i] if i in active else open_[i])
        value = forces[worst] if worst in active else open_[worst]
        if value > -1e-13:
            return forces
        active = sorted(set(active) ^ {worst})
    raise AssertionError("not solved")


class Wear(unittest.TestCase):
    def test_implicit_steps_are_those_of_a_dense_solve(self):
        steps, distance = 25, 2.0
        k, means = of_coatings(K), H * (np.arange(CELLS) * 0 + 1)
        depth = np.zeros(CELLS)
        profile = X * X / 2 + H * H / 24
        volumes = []
        for _ in range(steps):
            influence = matrix() + np.diag(k * distance / steps / means)
            forces = contact(influence, profile + depth, 2)
            depth += k * distance / steps * forces / H
            volumes.append(H * depth.sum())
        seen = []
        history = ss.wear(problem(), distance=distance, steps=steps, cells=CELLS,
                          callback=lambda row, p, w: seen.append((row["distance"], p.sum(), w.sum())))
        self.assertTrue(history.solved)
        np.testing.assert_allclose(history.x, X, atol=1e-15)
        np.testing.assert_allclose(history.depth, depth, rtol=1e-9)
        np.testing.assert_allclose(history.pressure, forces / H, rtol=1e-8)
        np.testing.assert_allclose(history.rows["wear_volume"][1:], volumes, rtol=1e-9)
        np.testing.assert_allclose(history.rows["effective_friction"][-1], 2 * (forces @ of_coatings(S)) / 2, rtol=1e-9)
        np.testing.assert_allclose([s for s, _, _ in seen], history.rows["distance"])
        np.testing.assert_allclose([p * H for _, p, _ in seen], 2)
        # Control: the same friction under the other order of coatings.
        turned = problem().with_(**{"wear.coefficients": ["0.5", "3", "1"]})
        self.assertGreater(np.abs(ss.wear(turned, distance=distance, steps=steps, cells=CELLS).depth - depth).max(), 0.1)

    def test_explicit_steps_tend_to_the_same_history(self):
        k, depth, influence, steps = of_coatings(K), np.zeros(CELLS), matrix(), 2000
        for _ in range(steps):
            depth += k * 0.5 / steps * contact(influence, X * X / 2 + H * H / 24 + depth, 2) / H
        errors = [np.abs(ss.wear(problem(), distance="0.5", steps=n, cells=CELLS).depth - depth).max() for n in (50, 100, 200)]
        self.assertLess(errors[2], 0.01 * depth.max())
        self.assertAlmostEqual(errors[0] / errors[1], 2, delta=0.2)

    def test_run_in_pressure(self):
        history = ss.wear(problem(), distance=1e6, until=1e-8, cells=CELLS)
        np.testing.assert_allclose(history.pressure * of_coatings(K), 2 / (0.75 / 1 + 0.75 / 3 + 0.5 / 0.5), rtol=1e-6)
        np.testing.assert_allclose(history.run_in_pressure, history.pressure, rtol=1e-6)
        self.assertTrue(np.isnan(history.rows["tilt"]).all())

    def test_a_callback_may_end_the_run(self):
        def stop(row, pressure, depth):
            if row["distance"] > 0.1:
                raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            ss.wear(problem(), distance=1e6, cells=CELLS, callback=stop)

    def test_bad_options(self):
        for options, message in (
                ({"distance": 0}, "distance: out of range; a sliding distance is positive, at most 1e300; 0"),
                ({"distance": "far"}, "distance: not a number; a number is written like 2, -0.25, 1e-3 or 1/3; 'far'"),
                ({"distance": 1, "steps": 0}, "steps: out of range; it is a whole number from 1 to 1000000; '0'"),
                ({"distance": 1, "steps": -2}, "steps: out of range; it is a whole number from 1 to 1000000; '-2'"),
                ({"distance": 1, "cells": 2}, "cells: out of range; it is a whole number from 16 to 4194304; '2'"),
                ({"distance": 1, "cells": -1}, "cells: out of range; it is a whole number from 16 to 4194304; '-1'"),
                ({"distance": 1, "accuracy": 0.0}, "accuracy: out of range; the error of a step is 1e-6 to 1; 0"),
                ({"distance": 1, "steps": 3, "accuracy": 0.1}, "steps: conflicting option; the accuracy chooses the steps; accuracy"),
                ({"distance": 1, "until": 1.5}, "until: out of range; a part of the load is in [0, 1[; 1.5")):
            with self.subTest(options), self.assertRaises(ss.InvalidData) as raised:
                ss.wear(problem(), **options)
            self.assertEqual(str(raised.exception), message)
        with self.assertRaisesRegex(ss.InvalidData, "^wear: missing; the problem has coefficients of wear; absent$"):
            ss.wear(problem().with_(wear=None), distance=1)


if __name__ == "__main__":
    unittest.main()
