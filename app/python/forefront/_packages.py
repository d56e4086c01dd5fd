"""Meshes as other packages have them. Each is imported when it is asked for."""
from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Dict, List, Tuple

import numpy as np

if TYPE_CHECKING:
    from ._mesh import Mesh

_MESHIO_CELLS = {"triangle3": "triangle", "triangle6": "triangle6", "quadrilateral4": "quad", "quadrilateral8": "quad8",
                 "quadrilateral9": "quad9"}
#: VTK_TRIANGLE, VTK_QUADRATIC_TRIANGLE, VTK_QUAD, VTK_QUADRATIC_QUAD, VTK_BIQUADRATIC_QUAD of vtkCellType.h
_VTK_CELLS = {"triangle3": 5, "triangle6": 22, "quadrilateral4": 9, "quadrilateral8": 23, "quadrilateral9": 28}


def package(name: str) -> Any:
    """Returns a package, or raises ImportError that says how to get it."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        root = name.split(".")[0]
        if error.name is not None and error.name.split(".")[0] != root:
            raise  # something that the package needs
        raise ImportError(f"{root} is not installed; install it, for example with 'pip install {_PROJECTS[root]}'",
                          name=root) from error


#: names of the projects by their packages
_PROJECTS = {"matplotlib": "matplotlib", "meshio": "meshio", "pyvista": "pyvista", "skfem": "scikit-fem",
             "dolfinx": "fenics-dolfinx"}


def to_matplotlib(mesh: "Mesh") -> Any:
    x, y = mesh.nodes.T
    return package("matplotlib.tri").Triangulation(x, y, mesh.triangles()[0])


def to_meshio(mesh: "Mesh") -> Any:
    meshio = package("meshio")
    cells, tags, first = [("line", mesh.edges)], [mesh.edge_tags], 0
    for kind, block in mesh.blocks.items():
        cells.append((_MESHIO_CELLS[kind], block))
        tags.append(mesh.regions[first:first + len(block)])
        first += len(block)
    names = {name: np.array([tag, 1]) for tag, name in mesh.boundary_names.items()}
    names.update({name: np.array([tag, 2]) for tag, name in mesh.region_names.items()})
    return meshio.Mesh(mesh.nodes, cells, cell_data={"gmsh:physical": tags}, field_data=names)


def to_pyvista(mesh: "Mesh") -> Any:
    pyvista = package("pyvista")
    rows: List[np.ndarray] = []
    kinds: List[np.ndarray] = []
    for kind, block in mesh.blocks.items():
        sizes = np.full((len(block), 1), block.shape[1], np.int64)
        rows.append(np.hstack([sizes, block.astype(np.int64)]).ravel())
        kinds.append(np.full(len(block), _VTK_CELLS[kind], np.uint8))
    points = np.column_stack([mesh.nodes, np.zeros(len(mesh.nodes))])
    grid = pyvista.UnstructuredGrid(np.concatenate(rows), np.concatenate(kinds), points)
    grid.cell_data["region"] = np.array(mesh.regions)
    for name, values in mesh.node_values.items():
        grid.point_data[name] = np.array(values)
    for name, values in mesh.element_values.items():
        grid.cell_data[name] = np.array(values)
    return grid


def _single_kind(mesh: "Mesh", target: str) -> Tuple[str, np.ndarray]:
    """Returns the kind and the elements of a mesh of triangles or quadrilaterals of first order alone."""
    (kind, block), *others = mesh.blocks.items()
    if others or kind not in ("triangle3", "quadrilateral4"):
        raise ValueError(f"{target}: expected triangles of 3 nodes or quadrilaterals of 4 nodes alone, got "
                         f"{', '.join(mesh.blocks)}; use triangulated()")
    return kind, block


def _parts(mesh: "Mesh") -> Dict[str, int]:
    """Returns the tags of boundary parts and lines that the mesh has, by name; those without one are 'boundary_TAG'."""
    return {mesh.boundary_names.get(tag, f"boundary_{tag}"): tag for tag in np.unique(mesh.edge_tags).tolist()}


def _regions(mesh: "Mesh") -> Dict[str, int]:
    return {mesh.region_names.get(tag, f"region_{tag}"): tag for tag in np.unique(mesh.regions).tolist()}


def _rows_of(pairs: np.ndarray, edges: np.ndarray, nodes: int) -> np.ndarray:
    """Returns the row of each edge in a list of pairs of nodes, in any direction; -1: it is not there."""
    keys = lambda both: both.min(axis=1).astype(np.int64) * nodes + both.max(axis=1)
    order = np.argsort(keys(pairs), kind="stable")
    known, wanted = keys(pairs)[order], keys(edges)
    place = np.minimum(np.searchsorted(known, wanted), max(len(known) - 1, 0))
    return np.where(known[place] == wanted, order[place], -1) if len(known) else np.full(len(edges), -1)


def to_skfem(mesh: "Mesh") -> Any:
    skfem = package("skfem")
    kind, block = _single_kind(mesh, "to_skfem")
    make = skfem.MeshTri if kind == "triangle3" else skfem.MeshQuad
    made = make(np.ascontiguousarray(mesh.nodes.T), np.ascontiguousarray(block.T.astype(np.int64)))
    facets = _rows_of(np.asarray(made.facets).T, np.asarray(mesh.edges), len(mesh.nodes))
    parts = {name: facets[mesh.edge_tags == tag] for name, tag in _parts(mesh).items()}
    regions = {name: np.flatnonzero(mesh.regions == tag) for name, tag in _regions(mesh).items()}
    return made.with_boundaries(parts).with_subdomains(regions)


def to_dolfinx(mesh: "Mesh", comm: Any = None) -> Tuple[Any, Any, Any]:
    dolfinx = package("dolfinx")
    package("dolfinx.mesh")
    kind, block = _single_kind(mesh, "to_dolfinx")
    if comm is None:
        comm = importlib.import_module("mpi4py.MPI").COMM_WORLD
    # Quadrilaterals of dolfinx list their corners row by row, not around.
    cells = np.array(block if kind == "triangle3" else block[:, [0, 1, 3, 2]], np.int64)
    points = np.array(mesh.nodes)
    first = comm.rank == 0
    made = _create_mesh(dolfinx, comm, cells if first else cells[:0], points if first else points[:0],
                        "triangle" if kind == "triangle3" else "quadrilateral")
    topology = made.topology
    own = np.arange(len(topology.original_cell_index), dtype=np.int32)
    regions = np.asarray(mesh.regions, np.int32)[np.asarray(topology.original_cell_index)]
    cell_tags = dolfinx.mesh.meshtags(made, 2, own, regions)
    nodes = np.asarray(made.geometry.input_global_indices)[_facet_nodes(made)]
    rows = _rows_of(np.asarray(mesh.edges), nodes, len(mesh.nodes))
    facets = np.flatnonzero(rows >= 0).astype(np.int32)
    facet_tags = dolfinx.mesh.meshtags(made, 1, facets, np.asarray(mesh.edge_tags, np.int32)[rows[facets]])
    return made, cell_tags, facet_tags


def _create_mesh(dolfinx: Any, comm: Any, cells: np.ndarray, points: np.ndarray, cell: str) -> Any:
    """Calls create_mesh() of dolfinx; since 0.7 its elements are those of Basix, since 0.10 they come before the points."""
    ufl = importlib.import_module("ufl")
    if hasattr(ufl, "VectorElement"):
        element = ufl.Mesh(ufl.VectorElement("Lagrange", ufl.Cell(cell, geometric_dimension=2), 1))
    else:
        element = ufl.Mesh(importlib.import_module("basix.ufl").element("Lagrange", cell, 1, shape=(2,)))
    version = tuple(int(part) for part in dolfinx.__version__.split(".")[:2])
    last = (element, points) if version >= (0, 10) else (points, element)
    return dolfinx.mesh.create_mesh(comm, cells, *last)


def _facet_nodes(made: Any) -> np.ndarray:
    """Returns the places of the ends of facets in the geometry: shape (k, 2)."""
    topology, links = made.topology, made.geometry.dofmap
    for dimensions in ((2, 0), (1, 0), (1, 2)):
        topology.create_connectivity(*dimensions)
    vertices = np.asarray(topology.connectivity(2, 0).array)
    # The nodes of a cell of first order are in the order of its vertices.
    node_of = np.zeros(vertices.max(initial=-1) + 1, np.int64)
    node_of[vertices] = np.asarray(getattr(links, "array", links)).ravel()
    return node_of[np.asarray(topology.connectivity(1, 0).array)].reshape(-1, 2)
