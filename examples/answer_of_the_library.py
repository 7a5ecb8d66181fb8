# The problem of answer_of_the_library.cpp in Python, and a sweep: python3 answer_of_the_library.py
import mpmath
import steadyslide as ss

problem = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0")
solution = problem.solve(digits=50)
mpmath.mp.dps = 50
print("effective friction: ", solution.effective_friction)
print("traction at x = 1/2:", solution.traction("1/2"))

# Every combination of two data, on all cores.
table = ss.sweep(problem, {"friction.values[1]": ["0.3", "0.5"], "half_space.poisson": ["0.2", "0.3"]})
for row in table:
    print(row["friction.values[1]"], row["half_space.poisson"], row["effective_friction"])
