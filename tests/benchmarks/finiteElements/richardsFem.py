"""Richards' equation by linear (P1 Galerkin) finite elements, with dolfinx.

The method of the paper that the project follows, as a yardstick for its finite
volumes: mixed form (storage as a function of state), backward Euler with the
local error control of 1e-3 of the paper, Newton's method with a line search,
direct linear solver. The mass matrix is consistent or lumped.

Usage: richardsFem.py <case.json> <mesh.msh> consistent|lumped

The case says soil, initial state, boundary conditions and times (see the files
beside this one). The mesh is gmsh's version 2 in ascii: the triangles of the
physical surface "back" are solved in the plane x, y, with y up. Writes
<mesh>.fem.csv (x, y, theta of each triangle's mean at the end) and prints one
line: name=value pairs.

slideFoam | from rain to runout
Copyright (C) 2026 the slideFoam authors, GPL-3.0-or-later
"""

import json
import sys
import time

import dolfinx
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem import petsc as fem_petsc
from mpi4py import MPI
from petsc4py import PETSc


def read_mesh(path):
    """Points and triangles of the physical surface "back"."""
    with open(path, encoding="ascii") as text:
        lines = text.read().split("\n")

    def section(name):
        start = lines.index("$" + name)
        count = int(lines[start + 1])
        return lines[start + 2 : start + 2 + count]

    physical = {}
    for line in section("PhysicalNames"):
        dimension, tag, name = line.split()
        physical[name.strip('"')] = (int(dimension), int(tag))

    points = {}
    for line in section("Nodes"):
        words = line.split()
        points[int(words[0])] = (float(words[1]), float(words[2]))

    wanted = physical["back"][1]
    triangles = []
    for line in section("Elements"):
        words = [int(word) for word in line.split()]
        if words[1] == 2 and words[3] == wanted:
            triangles.append(words[3 + words[2] :])

    used = sorted({label for triangle in triangles for label in triangle})
    number = {label: i for i, label in enumerate(used)}
    return (
        np.array([points[label] for label in used]),
        np.array([[number[n] for n in t] for t in triangles], dtype=np.int64),
    )


class Soil:
    """Van Genuchten and Mualem (Zhu2022 Eqs. 9, 10, 12), for ufl and numpy."""

    def __init__(self, values):
        self.theta_r = values["thetaR"]
        self.theta_s = values["thetaS"]
        self.alpha = values["alpha"]
        self.n = values["n"]
        self.m = 1 - 1 / self.n
        self.k_s = values["Ks"]
        self.l = values.get("l", 0.5)

    def theta_ufl(self, h):
        """Water content of a head, as a form."""
        suction = ufl.max_value(-h, 1e-10)
        saturation = (1 + (self.alpha * suction) ** self.n) ** (-self.m)
        wet = self.theta_r + saturation * (self.theta_s - self.theta_r)
        return ufl.conditional(ufl.lt(h, 0), wet, self.theta_s)

    def conductivity_ufl(self, h):
        """Hydraulic conductivity of a head, as a form."""
        suction = ufl.max_value(-h, 1e-10)
        power = (self.alpha * suction) ** self.n
        saturation = (1 + power) ** (-self.m)
        inner = 1 - (power / (1 + power)) ** self.m
        wet = self.k_s * saturation**self.l * inner**2
        return ufl.conditional(ufl.lt(h, 0), wet, self.k_s)

    def theta(self, h):
        """Water content, of an array."""
        suction = np.maximum(-h, 0)
        saturation = (1 + (self.alpha * suction) ** self.n) ** (-self.m)
        return self.theta_r + saturation * (self.theta_s - self.theta_r)

    def conductivity(self, h):
        """Hydraulic conductivity, of an array."""
        power = (self.alpha * np.maximum(-h, 1e-10)) ** self.n
        saturation = (1 + power) ** (-self.m)
        inner = 1 - (power / (1 + power)) ** self.m
        return np.where(h < 0, self.k_s * saturation**self.l * inner**2, self.k_s)


class FluxAudit:
    """Water balance of each triangle by the fluxes a user would take: normal
    Darcy flux of the discontinuous gradient, averaged over the two sides."""

    # Midpoints of the sides: exact for quadratic integrands
    MIDDLES = ((0, 1), (1, 2), (2, 0))

    def __init__(self, points, triangles, soil):
        self.soil = soil
        self.triangles = triangles
        corners = points[triangles]
        edge1 = corners[:, 1] - corners[:, 0]
        edge2 = corners[:, 2] - corners[:, 0]
        double = edge1[:, 0] * edge2[:, 1] - edge1[:, 1] * edge2[:, 0]
        self.area = 0.5 * np.abs(double)
        # Gradients of the three shape functions
        self.gradient = np.empty((len(triangles), 3, 2))
        for i, (j, k) in enumerate(((1, 2), (2, 0), (0, 1))):
            side = corners[:, k] - corners[:, j]
            self.gradient[:, i, 0] = -side[:, 1] / double
            self.gradient[:, i, 1] = side[:, 0] / double
        # Outward normals times length of the sides opposite to each corner
        self.normal = -2 * self.area[:, None, None] * self.gradient
        sides = np.sort(triangles[:, [[1, 2], [2, 0], [0, 1]]].reshape(-1, 2), axis=1)
        _, self.side_of, count = np.unique(
            sides, axis=0, return_inverse=True, return_counts=True
        )
        self.boundary = count[self.side_of] == 1
        self.sign_seen = np.zeros(len(count))
        self.n_sides = len(count)
        self.points = points

    def storage(self, h):
        """Water in each triangle [m3/m], by the middles of its sides."""
        values = h[self.triangles]
        total = sum(self.soil.theta(0.5 * (values[:, i] + values[:, j])) for i, j in self.MIDDLES)
        return self.area * total / 3

    def outflows(self, h):
        """Water that leaves each triangle through each side [m2/s]."""
        values = h[self.triangles]
        head = values + self.points[self.triangles][:, :, 1]
        slope = np.einsum("tij,ti->tj", self.gradient, head)
        result = np.empty((len(self.triangles), 3))
        for i, (j, k) in enumerate(((1, 2), (2, 0), (0, 1))):
            conductivity = self.soil.conductivity(0.5 * (values[:, j] + values[:, k]))
            result[:, i] = -conductivity * np.einsum("tj,tj->t", slope, self.normal[:, i])
        return result

    def shared(self, h):
        """The same with one flux for both sides of a side."""
        own = self.outflows(h).reshape(-1)
        order = np.argsort(self.side_of, kind="stable")
        mean = own.copy()
        inner = order[~self.boundary[order]].reshape(-1, 2)
        difference = 0.5 * (own[inner[:, 0]] - own[inner[:, 1]])
        mean[inner[:, 0]] = difference
        mean[inner[:, 1]] = -difference
        return mean.reshape(-1, 3)


def solve(case, points, triangles, lumped):
    """Run the case; the figures by name, and water content of the triangles."""
    soil = Soil(case["soil"])
    element = ufl.Mesh(ufl.VectorElement("Lagrange", ufl.triangle, 1))
    mesh = dolfinx.mesh.create_mesh(MPI.COMM_SELF, triangles, points, element)
    space = fem.FunctionSpace(mesh, ("Lagrange", 1))
    x = space.tabulate_dof_coordinates()

    h = fem.Function(space)
    old = fem.Function(space)
    step = fem.Constant(mesh, PETSc.ScalarType(1))
    test = ufl.TestFunction(space)
    z = ufl.SpatialCoordinate(mesh)[1]
    rule = {"quadrature_rule": "vertex"} if lumped else {"quadrature_degree": 4}
    dx_storage = ufl.dx(metadata=rule)
    dx_flux = ufl.dx(metadata={"quadrature_degree": 4})

    residual = (soil.theta_ufl(h) - soil.theta_ufl(old)) / step * test * dx_storage
    residual += soil.conductivity_ufl(h) * ufl.dot(ufl.grad(h + z), ufl.grad(test)) * dx_flux

    # Sides of the boundary: where the condition's expression holds
    conditions = []
    rain = 0
    for condition in case["boundary"]:
        def where(place, text=condition["where"]):
            return eval(text, {"x": place[0], "y": place[1], "np": np})

        facets = dolfinx.mesh.locate_entities_boundary(mesh, 1, where)
        if "head" in condition:
            dofs = fem.locate_dofs_topological(space, 1, facets)
            conditions.append(
                fem.dirichletbc(PETSc.ScalarType(condition["head"]), dofs, space)
            )
        else:
            tags = dolfinx.mesh.meshtags(
                mesh, 1, np.sort(facets), np.full(len(facets), 1, dtype=np.int32)
            )
            ds = ufl.Measure("ds", domain=mesh, subdomain_data=tags)
            # Rain is per plan area
            plan = abs(ufl.FacetNormal(mesh)[1])
            residual -= condition["rain"] * plan * test * ds(1)
            rain += fem.assemble_scalar(
                fem.form(fem.Constant(mesh, condition["rain"]) * plan * ds(1))
            )

    form = fem.form(residual)
    jacobian = fem.form(ufl.derivative(residual, h))
    initial = eval(case["initial"], {"x": x[:, 0], "y": x[:, 1], "np": np})
    h.x.array[:] = initial
    fem_petsc.set_bc(h.vector, conditions)

    # Numbering of the audit: that of the function space
    cells = space.dofmap.list.array.reshape(-1, 3)
    audit = FluxAudit(x[:, :2], cells, soil)

    matrix = fem_petsc.create_matrix(jacobian)
    vector = fem_petsc.create_vector(form)
    update = vector.duplicate()
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setOperators(matrix)
    solver.setType("preonly")
    solver.getPC().setType("lu")

    def assemble():
        with vector.localForm() as local:
            local.set(0)
        fem_petsc.assemble_vector(vector, form)
        fem_petsc.apply_lifting(
            vector, [jacobian], bcs=[conditions], x0=[h.vector], scale=-1.0
        )
        fem_petsc.set_bc(vector, conditions, h.vector, -1.0)
        return vector.norm()

    def flux_into():
        """Water that enters [m2/s]: rain, and by the residual's reaction."""
        whole = fem_petsc.assemble_vector(form)
        dofs = np.unique(np.concatenate([c.dof_indices()[0] for c in conditions])) \
            if conditions else []
        return rain + whole.array[dofs].sum()

    assemble()
    fem_petsc.assemble_matrix(matrix, jacobian, bcs=conditions).assemble()

    end = case["endTime"]
    most = case["maxDeltaT"]
    t = 0.0
    length = case["deltaT"]
    iterations = steps = rejected = 0
    rate = np.zeros_like(h.x.array)
    water_start = audit.storage(h.x.array)
    water = water_start.copy()
    entered = by_gradient = 0.0
    kept = np.zeros(len(cells))
    area_of = fem.form(test * ufl.dx)
    weight = fem_petsc.assemble_vector(area_of).array

    begin = time.process_time()
    old.x.array[:] = h.x.array
    while t < end * (1 - 1e-12):
        length = min(length, most, end - t)
        step.value = length
        norm = assemble()
        limit = 1e-10 * np.sqrt(len(x)) * weight.max() / length
        count = 0
        while norm > limit and count < 30:
            matrix.zeroEntries()
            fem_petsc.assemble_matrix(matrix, jacobian, bcs=conditions)
            matrix.assemble()
            solver.solve(vector, update)
            start = h.x.array.copy()
            fraction = 1.0
            for _ in range(8):
                h.x.array[:] = start - fraction * update.array
                new = assemble()
                if new < norm:
                    break
                fraction *= 0.5
            count += 1
            if new >= 0.999 * norm and count > 3 and norm < 100 * limit:
                norm = min(new, norm)
                break
            norm = new
        iterations += count
        theta_old = soil.theta(old.x.array)
        theta = soil.theta(h.x.array)
        error = 0
        if steps > 0:
            off = np.abs(theta - theta_old - length * rate)
            error = 0.5 * (weight * off).sum() / (weight * theta).sum() / 1e-3
        if norm > 100 * limit or not np.isfinite(norm) or error > 4:
            h.x.array[:] = old.x.array
            length *= 0.3
            rejected += 1
            if length < 1e-6:
                raise SystemExit(f"no solution at t = {t} s")
            continue
        # The balances, outside the timing
        pause = time.process_time()
        new_water = audit.storage(h.x.array)
        entered += length * flux_into()
        outflow = length * audit.shared(h.x.array)
        by_gradient -= outflow.reshape(-1)[audit.boundary].sum()
        if rain:
            # The rain itself is the flux through its sides
            own = outflow.reshape(-1)
            own[audit.boundary] = 0
        kept += outflow.sum(axis=1)
        water = new_water
        begin += time.process_time() - pause
        rate = (theta - theta_old) / length
        t += length
        steps += 1
        old.x.array[:] = h.x.array
        factor = min(2.0, 0.9 / np.sqrt(error)) if error > 0 else 2.0
        if count > 8:
            factor = min(factor, 0.7 if count > 16 else 1.0)
        length *= factor
    cpu = time.process_time() - begin

    # Storage as the scheme itself has it
    theta_form = fem.form(soil.theta_ufl(h) * dx_storage)
    scheme_end = fem.assemble_scalar(theta_form)
    final = h.x.array.copy()
    h.x.array[:] = initial
    fem_petsc.set_bc(h.vector, conditions)
    scheme_start = fem.assemble_scalar(theta_form)
    h.x.array[:] = final

    gained = scheme_end - scheme_start
    change = water - water_start
    inner = np.ones(len(cells), dtype=bool)
    inner[np.unique(np.nonzero(audit.boundary.reshape(-1, 3))[0])] = False
    return {
        "nodes": len(x),
        "triangles": len(cells),
        "steps": steps,
        "rejectedSteps": rejected,
        "nonlinearIterations": iterations,
        "cpu_s": cpu,
        "gained": gained,
        "massErrorReaction": abs(gained - entered) / abs(gained),
        "massErrorGradient": abs(gained - by_gradient) / abs(gained) if not rain else "",
        "massErrorLocal": np.abs(change + kept)[inner].sum() / np.abs(change).sum(),
        "psiMin": h.x.array.min(),
        "psiMax": h.x.array.max(),
        "undershoot": max(0.0, initial.min() - h.x.array.min()),
    }, np.column_stack(
        (x[cells].mean(axis=1)[:, :2], audit.area, water / audit.area, h.x.array[cells].mean(axis=1))
    )


def main(case_file, mesh_file, mass):
    """Run and write."""
    if mass not in ("consistent", "lumped"):
        raise SystemExit(f"mass matrix {mass}: consistent or lumped")
    with open(case_file, encoding="utf-8") as text:
        case = json.load(text)
    points, triangles = read_mesh(mesh_file)
    figures, cells = solve(case, points, triangles, mass == "lumped")
    np.savetxt(mesh_file + ".fem.csv", cells, delimiter=",", header="x,y,area,theta,psi", comments="")
    print(" ".join(f"{name}={value}" for name, value in figures.items()))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        raise SystemExit(__doc__)
    main(*sys.argv[1:])
