# Computes loads for a finite element mesh of the body under two coatings, and stresses at some of its points for
# comparison.
import numpy as np
import steadyslide as ss

problem = ss.Problem(load=1, poisson="0.2", friction=["0.1", "0.5"], jumps=[0], profile="0")
solution = problem.solve()
nodes = np.linspace(-2, 2, 81)  # quadratic elements of the surface: every second node is a midside one
forces = solution.nodal_forces(nodes, order=2)
stress = solution.stress(x=[0, 0.5, 1], z=[0.1, 0.5, 1])
print("load", round(forces.normal.sum(), 12), "friction force", round(forces.tangential.sum(), 12))
print("von Mises", stress.von_mises.round(6))
