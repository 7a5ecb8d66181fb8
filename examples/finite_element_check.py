# Applies exact nodal forces to a graded mesh of quadratic elements (GetFEM), and compares the slopes of its surface
# with the exact ones, at distances of a tenth and more from singular points. Run it in the folder above this one;
# docs/finite-elements.md has the table. It prints standard deviations, because forces do not determine a rotation.
import getfem as gf, numpy as np, steadyslide as ss

exact, errors = ss.Problem.from_toml("examples/reference/parabola_over_jump/problem.toml").solve(), []
form = "0.3/0.52*Div_u*Div_Test_u + Sym(Grad_u):Grad_Test_u/1.3 + 1e-5*u.Test_u"  # E = 1, nu = 0.3; weak springs hold it
for n in (4, 8, 16):
    mesh = gf.Mesh("cartesian", grid := np.sinh(np.linspace(-7, 7, 14 * n + 1)) / 4, grid[7 * n:])  # it ends far away
    fem = gf.MeshFem(mesh, 2)
    fem.set_classical_fem(2)
    stiffness = gf.asm_generic(gf.MeshIm(mesh, 4), 2, form, -1, "u", 1, fem, np.zeros(fem.nbdof()))
    (x, z), forces = fem.basic_dof_nodes(), np.zeros(fem.nbdof())
    top = np.array(sorted(np.flatnonzero(z == 0)[1::2], key=lambda i: x[i]))  # vertical displacements of the surface
    forces[top], forces[top - 1] = exact.nodal_forces(x[top], order=2)[:2]
    u = gf.linsolve_mumps(stiffness, forces).ravel()[top[::2]]
    wrong = -np.diff(u) / np.diff(x[top[::2]]) - exact.slope(at := x[top[1::2]])
    errors.append(np.std(wrong[(abs(at) < 1) & (np.min([abs(at - p.x) for p in exact.singular_points], axis=0) > 0.1)]))
print("errors", np.round(errors, 6), "orders", np.log2(np.divide(errors[:-1], errors[1:])).round(2))
