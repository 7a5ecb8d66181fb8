#!/usr/bin/env python3
"""Solves the parabola of parabola.toml by a boundary-element method that is common in the field.

    boundary_element.py CELLS

Pressures are constant on equal cells, with collocation at the midpoints. The logarithmic kernel is applied by fast Fourier
transforms on twice the cells (Liu, Wang, Liu, Wear 243 (2000) 101-111). Projected conjugate gradients find pressures >= 0 with the
given load (Polonsky, Keer, Wear 231 (1999) 206-219). Their kernel is symmetric, that of sliding friction is not. So the effect of
the shear tractions on the normal displacement, c int s p, is a change of the profile, and an outer iteration updates it.
Prints the load share under the first coating, the ends of contact, CPU seconds and steps as JSON.
"""

import json
import math
import sys
import time

import numpy as np

LOAD, POISSON, YOUNG, FRICTION, JUMP, LEFT, RIGHT = 0.35, 0.2, 1.0, (0.3, 0.9), 0.1, -2.0, 2.0


class Contact:
    def __init__(self, cells):
        self.h = (RIGHT - LEFT) / cells
        self.x = LEFT + self.h * (np.arange(cells) + 0.5)
        self.compliance = 2 * (1 - POISSON**2) / YOUNG
        self.coupling = (1 - 2 * POISSON) / (2 * (1 - POISSON))
        # The kernel -int log|x| dx / pi over a cell at every distance, as a circulant on twice the cells.
        d = np.concatenate([np.arange(cells + 1), np.arange(-cells + 1, 0)]) * self.h

        def primitive(y):
            return y * np.log(np.abs(y)) - y

        kernel = -(primitive(d + self.h / 2) - primitive(d - self.h / 2)) / math.pi
        self.transform = np.fft.rfft(self.compliance * kernel)
        left_part = np.clip((JUMP - (self.x - self.h / 2)) / self.h, 0, 1)
        self.left_part = left_part
        self.s = self.coupling * (FRICTION[0] * left_part + FRICTION[1] * (1 - left_part))

    def displacement(self, p):
        n = len(p)
        return np.fft.irfft(np.fft.rfft(p, 2 * n) * self.transform, 2 * n)[:n]

    def friction_term(self, p):
        burden = self.s * p * self.h
        return self.compliance * (np.cumsum(burden) - burden / 2)

    def frictionless(self, p, profile, tolerance):
        """Solves for a profile by the iteration of Polonsky and Keer, starting from p."""
        direction = np.zeros_like(p)
        old, steepest, steps = 1.0, True, 0
        while True:
            steps += 1
            gap = self.displacement(p) + profile
            contact = p > 0
            gap -= gap[contact].mean()
            size = float(np.sum(gap[contact] ** 2))
            direction = np.where(contact, gap + (0 if steepest else size / old) * direction, 0)
            old = size
            r = self.displacement(direction)
            r -= r[contact].mean()
            step = np.sum(gap[contact] * direction[contact]) / np.sum(r[contact] * direction[contact])
            before = p
            p = np.maximum(np.where(contact, p - step * direction, p), 0)
            overlap = (p == 0) & (gap < 0) & ~contact
            steepest = bool(overlap.any())
            p = np.where(overlap, p - step * gap, p)
            p *= LOAD / (self.h * p.sum())
            if self.h * np.abs(p - before).sum() < tolerance * LOAD or steps == 1000:
                return p, steps

    def solve(self, tolerance):
        p = np.where(np.abs(self.x) < 1, 1.0, 0.0)
        p *= LOAD / (self.h * p.sum())
        steps, rounds = 0, 0
        while True:
            rounds += 1
            before = p
            p, taken = self.frictionless(p, self.x**2 / 2 + self.friction_term(p), tolerance)
            steps += taken
            if self.h * np.abs(p - before).sum() < 10 * tolerance * LOAD or rounds == 200:
                return p, steps, rounds


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    start = time.process_time()
    contact = Contact(int(sys.argv[1]))
    p, steps, rounds = contact.solve(tolerance=1e-9)
    seconds = time.process_time() - start
    pressed = np.nonzero(p)[0]
    ends = [contact.x[pressed[0]] - contact.h / 2, contact.x[pressed[-1]] + contact.h / 2]
    share = float(np.sum(p * contact.left_part) * contact.h / LOAD)
    print(json.dumps({"share": share, "ends": ends, "seconds": seconds, "steps": steps, "rounds": rounds}))


if __name__ == "__main__":
    main()
