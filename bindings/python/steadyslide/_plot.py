"""Draws a solution with matplotlib."""

import numpy as np


def plot(solution, ax=None):
    import matplotlib.pyplot as plt

    if ax is None:
        ax = plt.figure().add_subplot()
    angles = np.linspace(0, np.pi, 403)[1:-1]
    for left, right, _, _ in solution.contact:
        # The points are denser towards the ends, where the traction may be singular.
        x = (float(left.x) + float(right.x)) / 2 - np.cos(angles) * (float(right.x) - float(left.x)) / 2
        ax.plot(x, -np.asarray(solution.traction(x), dtype=float), color="C0")
        ax.plot(x, np.asarray(solution.shear(x), dtype=float), color="C1")
    for point in solution.singular_points:
        ax.axvline(float(point.x), color="0.7", linewidth=0.8, zorder=0)
    ax.plot([], [], color="C0", label="pressure")
    ax.plot([], [], color="C1", label="shear")
    mean = float(solution.resultants.mean_pressure)
    ax.set_ylim(top=min(ax.get_ylim()[1], 5 * mean))
    ax.set_xlabel("x")
    ax.legend()
    return ax
