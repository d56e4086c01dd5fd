"""The stiffness matrix of Poisson's equation, and the solution for a load of 1 with u = 0 on the boundary of a disc."""
import numpy as np

import forefront as ff


def stiffness(mesh):
    """Returns the dense matrix of linear elements: the integral of grad(u) . grad(v)."""
    corner = mesh.nodes[mesh.elements]
    opposite = np.roll(corner, -1, axis=1) - np.roll(corner, -2, axis=1)  # the edge opposite to each corner
    area = mesh.quality("area")
    local = np.einsum("eik,ejk->eij", opposite, opposite) / (4 * area[:, None, None])
    matrix = np.zeros((len(mesh.nodes), len(mesh.nodes)))
    rows, columns = np.repeat(mesh.elements, 3, axis=1), np.tile(mesh.elements, 3)
    np.add.at(matrix, (rows, columns), local.reshape(len(area), 9))
    return matrix


disc = ff.Domain()
disc.add_circle((0, 0), 1.0, name="rim")
mesh = ff.mesh(disc, 0.08)
load = np.zeros(len(mesh.nodes))
np.add.at(load, mesh.elements, np.repeat(mesh.quality("area")[:, None] / 3, 3, axis=1))
free = np.setdiff1d(np.arange(len(mesh.nodes)), mesh.nodes_of("rim"))
u = np.zeros(len(mesh.nodes))
u[free] = np.linalg.solve(stiffness(mesh)[np.ix_(free, free)], load[free])
exact = (1 - (mesh.nodes**2).sum(axis=1)) / 4
print(f"largest error below 0.001: {bool(np.abs(u - exact).max() < 1e-3)}")
#-> largest error below 0.001: True
