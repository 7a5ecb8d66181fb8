#!/usr/bin/env python3
"""Solves the parabola of parabola.toml by finite elements, with GetFEM (python3-getfem).

    finite_element.py ELEMENTS [THICKNESS]

A block of half-width and depth 10^4 with fixed sides and bottom replaces the half-plane. The elements are quadratic: ELEMENTS
equal ones over [-1, 1], with a node at the friction jump; beyond, each is longer by half than the one before. The pressure
is a continuous, piecewise linear multiplier. Contact is the complementarity of the augmented Lagrangian (Alart, Curnier 1991, as
in GetFEM's own contact bricks). The shear f p of steady sliding is a traction. One more unknown, the approach, fixes the load.
Prints the load share under the first coating, CPU seconds, unknowns and steps as JSON.
With a THICKNESS the block is a layer of this thickness on a rigid base, to which it is bonded.
"""

import json
import sys
import time

import getfem as gf
import numpy as np

LOAD, POISSON, YOUNG, FRICTION, JUMP, REACH = 0.35, 0.2, 1.0, (0.3, 0.9), 0.1, 1e4


def graded(first):
    """Returns distances from the end of equal elements; each is longer by half than the one before."""
    places, step = [], first
    while not places or places[-1] < REACH:
        step *= 1.5
        places.append((places[-1] if places else 0) + step)
    return np.array(places)


def block(elements, thickness):
    h = 2.0 / elements
    x = np.linspace(-1, 1, elements + 1)
    x[np.argmin(np.abs(x - JUMP))] = JUMP
    x = np.concatenate([-1 - graded(h)[::-1], x, 1 + graded(h)])
    y = np.concatenate([[0], np.cumsum(np.full(4, h)), 4 * h + graded(h)])
    if thickness:
        y = np.linspace(0, thickness, int(np.ceil(thickness / h)) + 1)
    y = -y[::-1]
    return gf.Mesh("cartesian", x, y)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    gf.util_trace_level(0)
    start = time.process_time()
    mesh = block(int(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else None)
    points = mesh.pts()
    depth = points[1].min()
    faces = mesh.outer_faces()

    def region(number, test):
        chosen = [k for k in range(faces.shape[1])
                  if all(test(p) for p in points[:, mesh.pid_in_faces(faces[:, [k]])].T)]
        mesh.set_region(number, faces[:, chosen])

    top, left, right, fixed = 1, 2, 3, 4
    region(left, lambda p: p[1] == 0 and -1 - 1e-9 <= p[0] <= JUMP + 1e-9)
    region(right, lambda p: p[1] == 0 and JUMP - 1e-9 <= p[0] <= 1 + 1e-9)
    mesh.region_merge(top, left)
    mesh.region_merge(top, right)
    width = points[0].max()
    region(fixed, lambda p: p[1] == depth or abs(p[0]) == width)

    displacement = gf.MeshFem(mesh, 2)
    displacement.set_fem(gf.Fem("FEM_QK(2,2)"))
    pressure = gf.MeshFem(mesh, 1)
    pressure.set_fem(gf.Fem("FEM_QK(2,1)"))
    rule = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,6)"))
    model = gf.Model("real")
    model.add_fem_variable("u", displacement)
    model.add_filtered_fem_variable("p", pressure, top)
    model.add_variable("approach", 1)
    model.add_initialized_data("lambda", [YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))])
    model.add_initialized_data("mu", [YOUNG / (2 * (1 + POISSON))])
    model.add_initialized_data("r", [float(sys.argv[1])])
    model.add_initialized_data("mean", [LOAD / 2])
    model.add_isotropic_linearized_elasticity_brick(rule, "u", "lambda", "mu")
    model.add_Dirichlet_condition_with_simplification("u", fixed)
    # Tractions on the body are (f p, -p); p >= 0 where the indenter x^2/2 - approach touches the surface.
    for where, f in ((left, FRICTION[0]), (right, FRICTION[1])):
        model.add_nonlinear_term(rule, f"p*Test_u(2) - {f}*p*Test_u(1)", where)
    overlap = "(approach + u(2) - X(1)*X(1)/2)"
    model.add_nonlinear_term(rule, f"(p - pos_part(p + r*{overlap}))*Test_p/r", top)
    model.add_nonlinear_term(rule, "(mean - p)*Test_approach", top)
    model.set_variable("approach", [0.3])
    steps, _ = model.solve("max_res", 1e-8, "max_iter", 60)
    loads = [gf.asm("generic", rule, 0, "p", where, model) for where in (left, right)]
    seconds = time.process_time() - start
    print(json.dumps({"share": float(loads[0] / sum(loads)), "approach": float(model.variable("approach")[0]), "load": float(sum(loads)), "seconds": seconds,
                      "unknowns": model.nbdof(), "steps": steps}))


if __name__ == "__main__":
    main()
