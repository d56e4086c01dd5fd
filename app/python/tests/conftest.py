import numpy as np
import pytest

import forefront as ff

RECTANGLE = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (0.0, 2.0)]


@pytest.fixture
def rectangle():
    return list(RECTANGLE)


@pytest.fixture
def plate():
    """A rectangle with names and a round hole."""
    domain = ff.Domain()
    domain.add_loop(RECTANGLE, names=["bottom", "right", "top", "left"])
    domain.add_circle((1, 1), 0.4, name="hole")
    return domain


@pytest.fixture
def areas():
    def of(mesh):
        corner = mesh.nodes[mesh.triangles()[0]]
        u, v = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
        return 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])

    return of


@pytest.fixture
def bow_tie():
    return np.array([(0, 0), (1, 1), (1, 0), (0, 1)], float)
