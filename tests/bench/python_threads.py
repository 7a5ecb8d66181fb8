#!/usr/bin/python3
"""Compares the time of two Python threads with that of one, for the same solves. A solve releases the interpreter's lock.

    PYTHONPATH=build/release/python tests/bench/python_threads.py [DIGITS] [SOLVES]
"""

import sys
import time
from concurrent.futures import ThreadPoolExecutor

import steadyslide as ss

digits = int(sys.argv[1]) if len(sys.argv) > 1 else 16
solves = int(sys.argv[2]) if len(sys.argv) > 2 else 400
problems = [ss.Problem(load=f"0.{k + 1:04}", poisson="0.3", friction=["0.1", "0.5"], jumps=["0.1"], profile="x^2/2+x^4")
            for k in range(solves)]


def seconds(threads):
    start = time.perf_counter()
    with ThreadPoolExecutor(threads) as pool:
        solutions = list(pool.map(lambda problem: problem.solve(digits=digits), problems))
    assert all(solution.solved for solution in solutions)
    return time.perf_counter() - start


problems[0].solve(digits=digits)  # computes the data that is made at first use
one, two = seconds(1), seconds(2)
print(f"{solves} solves with {digits} digits: one thread {one:.2f} s, two {two:.2f} s, {one / two:.2f} times as fast")
