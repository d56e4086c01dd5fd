"""Planar meshes by the advancing front technique.

>>> import forefront as ff
>>> mesh = ff.mesh([(0, 0), (4, 0), (4, 2), (0, 2)], size=0.5)
>>> mesh.nodes.shape[1], mesh.elements.shape[1]
(2, 3)

Lengths are in the units of the domain, areas in their square, angles in degrees. Indices count from 0. The same input
gives the same mesh bit for bit, for any number of threads. Nothing is global: any thread may mesh at any time, and the
interpreter's lock is free while it does.
"""
from ._core import Fault, __version__
from ._domain import Domain
from ._errors import MeshError
from ._mesh import Mesh
from ._meshing import Adapted, Estimate, adapt, estimate, formats, mesh, read_fields, read_mesh
from ._run import Moment, Run, run
from ._sizes import Background, Grid, Source, read_sizes

__all__ = [
    "Adapted", "Background", "Domain", "Estimate", "Fault", "Grid", "Mesh", "MeshError", "Moment", "Run", "Source",
    "__version__", "adapt", "estimate", "formats", "mesh", "read_fields", "read_mesh", "read_sizes", "run",
]
