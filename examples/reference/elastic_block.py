#!/usr/bin/env python3
"""Elastic blocks under the exact tractions of reference problems, with GetFEM: usage: examples/reference/elastic_block.py

A developer can test a finite element code with these data. The block [-2, 2] x [0, 2] is cut out of the half-plane. Its surface
carries the consistent nodal forces that `solve --loads-on` gives for the same mesh. Its other three sides carry the stresses that
`solve --stress-at` gives there. The solution on the block is then that of the half-plane, for any size of the block.
A mesh has equal squares with quadratic elements; their side is half of that in the mesh before. The script compares

  slope   of the surface under the indenter with that of the profile, at a distance of at least 0.1 from singular points
  stress  at the points of grid.csv
  energy  the stress within 0.25 of the strongest singular point, at Gauss points: root mean square

A singular traction is like a power lambda of the distance. The displacement is then in the Sobolev space of order 2 + lambda
and in no higher one. So the third error is of order 1 + lambda in h: 0.95 at the jump under the parabola, 0.49 at the edge of a
flat punch. Away from the singular points the singularity has no effect, because the body is smooth and the forces are exact: the
errors of slope and stress have the order of the elements, 2, or a higher one. The errors of stresses are relative to the largest
stress; the error of the slope is absolute.
The script runs the program `steadyslide` in the PATH, or the program in the environment variable STEADYSLIDE. The exit code is 1
if the orders are not as expected, and 77 without GetFEM."""
import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib

try:
    import getfem as gf
    import numpy as np
except ImportError as error:
    print(error)
    sys.exit(77)

HERE = pathlib.Path(__file__).resolve().parent
PROFILE_SLOPE = {"parabola_over_jump": lambda x: x, "two_coatings": lambda x: 0 * x}
gf.util("trace level", 1)
PROGRAM = os.environ.get("STEADYSLIDE", "steadyslide")
YOUNG = 1.0
WIDTH, DEPTH = 4.0, 2.0
SURFACE, CUT = 1, 2
MESHES = (4, 8, 16, 32)


def columns(lines):
    rows = list(csv.DictReader(lines))
    return {name: np.array([float(row[name]) for row in rows]) for name in ("x", *rows[0]) if "kind" not in name}


class Reference:
    """A reference problem, and the results of `steadyslide solve` for it."""

    def __init__(self, name):
        self.folder, self.slope = HERE / name, PROFILE_SLOPE[name]
        self.poisson = float(tomllib.loads((self.folder / "problem.toml").read_text())["half_space"]["poisson"])
        with open(self.folder / "intensities.csv", newline="") as file:
            points = list(csv.DictReader(file))
        self.singular = [float(point["x"]) for point in points]
        powers = {float(point["x"]): float(point["exponent"]) for point in points if point["exponent"] != "log"}
        self.strongest = min(powers, key=powers.get)
        self.energy_order = min(2.0, 1 + powers[self.strongest])
        with open(self.folder / "stress.csv", newline="") as file:
            grid = columns(file)
        inside = (grid["z"] >= 0.25) & (grid["z"] < DEPTH) & (np.abs(grid["x"]) < WIDTH / 2)
        self.grid = {name: values[inside] for name, values in grid.items()}

    def solve(self, option, *table):
        """Writes a file with these columns, gives it to `option`, and returns the resulting table."""
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            for row in zip(*table):
                file.write(",".join(map(repr, row)) + "\n")
            file.flush()
            command = [PROGRAM, "solve", self.folder / "problem.toml", option, file.name, "--format", "csv"]
            return columns(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines())

    def stresses(self, x, z):
        """Returns the exact stresses [[sxx, sxz], [sxz, szz]] at depths z > 0."""
        found = self.solve("--stress-at", x.tolist(), z.tolist())
        return np.array([[found["sxx"], found["sxz"]], [found["sxz"], found["szz"]]])

    def places(self):
        """Returns places under the indenter, more than 0.1 away from singular points, and not at nodes of a mesh."""
        x = np.linspace(self.singular[0], self.singular[-1], 202)
        return np.array([place for place in x if min(abs(place - at) for at in self.singular) > 0.1])


class Block:
    """The solution on squares of side 1/n. The second coordinate is z, into the body."""

    def __init__(self, reference, n):
        self.reference, self.n = reference, n
        self.mesh = gf.Mesh("cartesian", np.linspace(-WIDTH / 2, WIDTH / 2, int(WIDTH * n) + 1),
                            np.linspace(0, DEPTH, int(DEPTH * n) + 1))
        faces = self.mesh.outer_faces()
        is_surface = self.mesh.normal_of_faces(faces)[1] < -0.5
        self.mesh.set_region(SURFACE, faces[:, is_surface])
        self.mesh.set_region(CUT, faces[:, ~is_surface])
        self.displacements = self.fem(2)
        mim = gf.MeshIm(self.mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,6)"))
        self.model = model = gf.Model("real")
        model.add_fem_variable("u", self.displacements)
        nu = reference.poisson
        model.add_initialized_data("lambda", nu * YOUNG / ((1 + nu) * (1 - 2 * nu)))
        model.add_initialized_data("mu", YOUNG / (2 * (1 + nu)))
        model.add_isotropic_linearized_elasticity_brick(mim, "u", "lambda", "mu")
        model.add_explicit_rhs("u", self.surface_forces())
        values = self.fem(1)
        model.add_initialized_fem_data("exact", values, self.cut_stresses(values))
        model.add_normal_source_term_brick(mim, "u", "exact", CUT)
        # All forces are in balance. Three displacements at two corners prevent rigid motions.
        model.add_variable("rigid", 3)
        model.add_constraint_with_multipliers("u", "rigid", self.rigid(), np.zeros(3))
        model.solve()

    def fem(self, dimension):
        result = gf.MeshFem(self.mesh, dimension)
        result.set_fem(gf.Fem("FEM_QK(2,2)"))
        return result

    def surface_forces(self):
        dofs = self.displacements.basic_dof_on_region(SURFACE)[::2]
        dofs = dofs[np.argsort(self.displacements.basic_dof_nodes(dofs)[0])]
        nodes = self.displacements.basic_dof_nodes(dofs)[0]
        loads = self.reference.solve("--loads-on", nodes.tolist(), [2] * len(nodes))
        forces = np.zeros(self.displacements.nbdof())
        forces[dofs], forces[dofs + 1] = loads["tangential"], loads["normal"]
        return forces

    def cut_stresses(self, values):
        nodes = values.basic_dof_on_region(CUT)
        x, z = values.basic_dof_nodes(nodes)
        result = np.zeros((2, 2, values.nbdof()))
        result[:, :, nodes] = self.reference.stresses(x, np.maximum(z, 1e-9))  # the two corners of the surface
        return result

    def rigid(self):
        x, z = self.displacements.basic_dof_nodes()
        left, right = (np.flatnonzero(np.isclose(x, side) & np.isclose(z, DEPTH)) for side in (-WIDTH / 2, WIDTH / 2))
        result = gf.Spmat("empty", 3, len(x))
        for row, dof in enumerate((left[0], left[1], right[1])):
            result.add(row, int(dof), 1.0)
        return result

    def at(self, expression, x, z):
        return self.model.interpolation(expression, np.array([x, z]), self.mesh)

    def slope_error(self):
        """Returns the root mean square difference between the slopes of the surface, of height -u_z, and of the profile.

        Subtracts the mean difference, because forces do not determine the rotation of the block.
        """
        x = self.reference.places()
        difference = -self.at("Grad_u(2,1)", x, np.full_like(x, 1e-12)) - self.reference.slope(x)
        return rms(difference - np.mean(difference))

    def stress_error(self, exact):
        """Returns the difference from a table x, z, sxx, sxz, szz: root mean square over points and components."""
        sigma = self.at("lambda*Trace(Grad_u)*Id(2) + mu*(Grad_u + Grad_u')", exact["x"], exact["z"])
        sxx, sxz, _, szz = sigma.reshape(-1, 4).T
        wanted = [exact[name] for name in ("sxx", "sxz", "szz")]
        return rms(np.array([sxx, sxz, szz]) - wanted)

    def errors(self):
        grid = self.reference.grid
        largest = np.max(np.abs([grid[name] for name in ("sxx", "sxz", "szz")]))
        stress = self.stress_error(grid) / largest
        energy = self.stress_error(self.reference.solve("--stress-at", *self.gauss_points())) / largest
        return np.array([self.slope_error(), stress, energy])

    def gauss_points(self):
        """Returns the nine Gauss points of each square that lie near the strongest singular point.

        The mean over them is the mean over the body there, to the order of the rule.
        """
        corners = np.linspace(0, 1, self.n + 1)[:-1]
        cell = [(left + (1 + node) / (2 * self.n)) for left in corners for node in np.polynomial.legendre.leggauss(3)[0]]
        x = np.concatenate([start + np.array(cell) for start in np.arange(-WIDTH / 2, WIDTH / 2)])
        z = np.concatenate([start + np.array(cell) for start in np.arange(0, DEPTH)])
        x, z = np.meshgrid(x, z)
        near = np.hypot(x - self.reference.strongest, z) < 0.25
        return x[near].tolist(), z[near].tolist()


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def main():
    print("problem,h,slope,order,stress,order,energy,order,expected")
    is_as_expected = True
    for name in PROFILE_SLOPE:
        reference, before, orders = Reference(name), None, None
        for n in MESHES:
            errors = Block(reference, n).errors()
            orders = None if before is None else np.log2(before / errors)
            told = ["", "", ""] if before is None else [f"{order:.2f}" for order in orders]
            row = ",".join(f"{error:.2e},{order}" for error, order in zip(errors, told))
            print(f"{name},1/{n},{row},{reference.energy_order:.2f}", flush=True)
            before = errors
        slope, stress, energy = orders
        is_as_expected &= slope > 1.8 and stress > 1.8 and abs(energy - reference.energy_order) < 0.1
    sys.exit(0 if is_as_expected else 1)


if __name__ == "__main__":
    main()
