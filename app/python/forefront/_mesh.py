"""The mesh."""
from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core, _packages
from ._arguments import names_of, refuse_unknown
from ._core import Fault
from ._domain import Domain
from ._writing import form_of


class Mesh(_core.MeshBase):
    """An immutable mesh.

    ``nodes`` (n, 2) float64 · ``elements`` (m, 3) uint32, counter-clockwise · ``regions`` (m,) int32 · ``edges`` (k, 2)
    uint32 and ``edge_tags`` (k,) int32, the boundary and the lines · ``boundary_names`` and ``region_names`` by tag. All
    are read-only views of the mesh, in the order in which it was made; they stay valid after the mesh is gone.

    A mesh of quadrilaterals alone has ``elements`` of shape (m, 4). One of several kinds has ``blocks``, a dict from
    the kind, such as 'triangle3', to its elements; ``regions`` runs through all blocks in turn.

    Elements of order 2 have 6 nodes, or 8 or 9: first the corners, counter-clockwise, then the middles of the edges from
    each corner to the next, beginning with that from corner 0 to corner 1, and last the centre of quadrilaterals of 9.
    """

    node_values: Dict[str, np.ndarray]
    element_values: Dict[str, np.ndarray]

    def __init__(self, nodes: Any, elements: Any = None, regions: Any = None, edges: Any = None,
                 edge_tags: Any = None, boundary_names: Optional[Mapping[int, str]] = None,
                 region_names: Optional[Mapping[int, str]] = None, points: Any = None, point_tags: Any = None) -> None:
        """Makes a mesh from arrays, which are copied, or a second object for a mesh.

        nodes: (n, 2). elements: (m, 3), or (m, 4, 6, 8 or 9) for other kinds, or a list of such arrays. regions: (m,)
        tags from 1 on; None: all 1. edges: (k, 2), and their tags (k,); None: all 1. points: (p,) nodes at points of
        the domain, and their tags (p,); None: all 1.
        """
        if isinstance(nodes, _core.MeshBase):
            super().__init__(nodes)
        else:
            blocks = elements if isinstance(elements, (list, tuple)) and np.ndim(elements[0]) == 2 else [elements]
            super().__init__(_core.mesh_from_arrays(nodes, list(blocks), regions, edges, edge_tags,
                                                    dict(boundary_names or {}), dict(region_names or {}), points,
                                                    point_tags))
        self.node_values = dict(getattr(nodes, "node_values", {}))
        self.element_values = dict(getattr(nodes, "element_values", {}))

    def edges_of(self, name: Union[str, int]) -> np.ndarray:
        """Returns the edges of a boundary part or line, by name or tag: shape (k, 2)."""
        return self.edges[self.edge_tags == self._tag(name, self.boundary_names, "boundary part")]

    def nodes_of(self, name: Union[str, int]) -> np.ndarray:
        """Returns the nodes of a boundary part, a line or points, by name or tag: ascending indices."""
        tag = self._tag(name, self.boundary_names, "boundary part")
        nodes, tags = self._points
        return np.union1d(self.edges[self.edge_tags == tag].ravel(), nodes[tags == tag])

    def elements_of(self, name: Union[str, int]) -> np.ndarray:
        """Returns the elements of a region, by name or tag: ascending indices."""
        return np.flatnonzero(self.regions == self._tag(name, self.region_names, "region"))

    @staticmethod
    def _tag(name: Union[str, int], names: Mapping[int, str], what: str) -> int:
        if not isinstance(name, str):
            return int(name)
        tags = [tag for tag, known in names.items() if known == name]
        if not tags:
            raise KeyError(f"unknown {what} '{name}'; expected {', '.join(sorted(names.values())) or 'a tag'}")
        return tags[0]

    @property
    def points(self) -> Tuple[np.ndarray, np.ndarray]:
        """The nodes at points of the domain, and their tags."""
        return self._points

    def triangles(self) -> Tuple[np.ndarray, np.ndarray]:
        """Returns triangles (t, 3) that cover the elements, and the element of each; nodes stay."""
        return self._triangles()

    def triangulated(self) -> "Mesh":
        """Returns the mesh with all elements split into triangles of 3 nodes, on the same nodes."""
        return Mesh(self._triangulated())

    def recombine(self, improve: str = "default", progress: Any = None) -> "Mesh":
        """Returns a mesh of quadrilaterals made of the triangles; nodes inside move.

        The boundary, interfaces of regions, tagged edges and points stay. improve: 'none', 'default' or 'best'. Where a
        face has an odd number of edges one triangle is left, which ``notes`` reports. Values of nodes are dropped.
        """
        return Mesh(self._recombined(improve, progress))

    def raise_order(self, quad_nodes: int = 8, progress: Any = None) -> "Mesh":
        """Returns the mesh with nodes in the middles of edges: elements of 6 nodes, and of 8 or 9.

        Corners keep their indices. Edges of a mesh that was made here follow the curves of its domain; the others stay
        straight. quad_nodes: 9 adds a node in the centre of each quadrilateral. Values of nodes are dropped.
        """
        return Mesh(self._raised(quad_nodes, progress))

    def with_size(self, size: Any, **options: Any) -> "Mesh":
        """Returns the mesh with a node spacing, for 'delta' and 'size' of :meth:`quality` and min_delta of :meth:`check`.

        size and options: as for :func:`forefront.mesh`, such as the file that :func:`read_sizes` reads, gradation or
        sizes. The domain is the outline of the mesh.
        """
        from ._sizes import job_of

        refuse_unknown("with_size", options, names_of(job_of))
        job = job_of(Domain(_core.outline(self)), size, **options)
        return self._with_values(self._with_spacing(*job.arguments))

    def _with_values(self, other: _core.MeshBase) -> "Mesh":
        result = Mesh(other)
        result.node_values, result.element_values = dict(self.node_values), dict(self.element_values)
        return result

    def quality(self, measure: str = "alpha") -> np.ndarray:
        """Returns the values of a measure of each element, edge or node.

        Of elements: 'alpha' (shape factor, 1 for an equilateral triangle), 'scaled-jacobian', 'min-angle' and
        'max-angle' (degrees), 'aspect' (length over height), 'area', 'area-ratio', 'region', 'birth'. Of edges: 'length', 'size' and 'delta' (length
        compared with the node spacing, which a mesh that was read gets from :meth:`with_size`). Also 'across',
        'island-area' and 'valence'.
        """
        return super().quality(measure)

    def summary(self) -> Dict[str, Any]:
        """Returns the figures of ``forefront mesh --stats`` and ``check --stats`` as a dict."""
        return json.loads(self._summary())

    def check(self, domain: Optional[Domain] = None, **limits: float) -> List[Fault]:
        """Checks that the mesh is valid and, if it is given, fits its domain; returns all faults and notes.

        limits: such as min_angle=25, max_angle, min_alpha, min_scaled_jacobian, max_aspect, max_layer_aspect,
        max_growth, min_length, max_length, min_delta, min_across, max_valence. Each place that violates one is a fault.
        With max_layer_aspect, max_aspect is one of the elements outside boundary layers. min_delta needs a node spacing:
        a mesh that was read gets it from :meth:`with_size`.
        """
        return self._check(domain, limits_of(limits))

    def write(self, file: Any, format: Optional[str] = None, inner_edges: Optional[bool] = None,
              progress: Any = None, **form: Any) -> List[Fault]:
        """Writes the mesh to a path or an open file, and returns notes on what the format changes.

        format: an id of :func:`formats`; None: by extension. inner_edges: whether tagged edges inside the domain are
        written; None: as programs that read the format accept them. A file is replaced as a whole or not at all.

        form, each refused by formats that have no place for it: numbering, 'creation' or 'rcm' for a small bandwidth ·
        elevation of the nodes: an array (n,), a function of arrays x and y, an expression, or a raster (.asc, .tif) ·
        extrude, a height or (height, layers): prisms and hexahedra · open, names or tags of boundary parts through
        which water flows; all others are land · tags, 'keep': the same numbers and names for boundary parts and regions
        as in the mesh, 'apart': different ones · unit, 'mm', 'cm', 'm', 'km', 'in', 'ft' or 'none': of the coordinates,
        which do not change; None: that of the domain.
        """
        refuse_unknown("write", form, names_of(form_of))
        options, notes = form_of(self, inner_edges=inner_edges, **form)
        notes = notes + self._dropped_values()
        if not hasattr(file, "write"):
            return notes + self._write(os.fspath(file), format or "", options, progress)
        if format is None:
            raise ValueError("format: an open file needs one, such as 'msh2'")
        content, more = self._to_bytes(format, options)
        file.write(content.decode() if _takes_text(file) else content)
        return notes + more

    def _dropped_values(self) -> List[Fault]:
        names = sorted({*self.node_values, *self.element_values})
        if not names:
            return []
        return [_core.fault("dropped-fields", f"the values {', '.join(names)} are not written: files hold the mesh alone",
                            "write them with to_meshio() or to_pyvista()", note=True)]

    def to_bytes(self, format: str, inner_edges: Optional[bool] = None, **form: Any) -> bytes:
        """Returns the file of a format that has one file. form: as for :meth:`write`."""
        refuse_unknown("to_bytes", form, names_of(form_of))
        return self._to_bytes(format, form_of(self, inner_edges=inner_edges, **form)[0])[0]

    def numbered(self, order: Union[str, Sequence[int]] = "rcm") -> "Mesh":
        """Returns the mesh with its nodes in another order, for a small bandwidth of the matrices of solvers.

        order: 'rcm', the reverse of E. Cuthill and J. McKee's order (1969), or the old index of each new node. Elements
        of a kind are ordered by their least node.
        """
        rows = np.arange(len(self.nodes))
        if isinstance(order, str) and order == "rcm":
            new = self._small_bandwidth().astype(np.int64)
            old = np.argsort(new)
        else:
            old = np.asarray(order)
            if old.shape != rows.shape or not np.array_equal(np.sort(old), rows):
                raise ValueError("order: expected 'rcm' or each index of a node once")
            new = np.empty(len(rows), np.int64)
            new[old] = rows
        result = Mesh(self._renumbered(new))
        result.node_values = {name: values[old] for name, values in self.node_values.items()}
        if self.element_values:
            moved = self._elements_by_least_node(new)
            result.element_values = {name: values[moved] for name, values in self.element_values.items()}
        return result

    def _elements_by_least_node(self, new: np.ndarray) -> np.ndarray:
        """Returns the old index of each element once the nodes have new indices."""
        parts, first = [], 0
        for block in self.blocks.values():
            parts.append(first + np.argsort(new[block].min(axis=1), kind="stable"))
            first += len(block)
        return np.concatenate(parts)

    def to_matplotlib(self) -> Any:
        """Returns a matplotlib.tri.Triangulation."""
        return _packages.to_matplotlib(self)

    def to_meshio(self) -> Any:
        """Returns a meshio.Mesh, with tags as 'gmsh:physical' and names in field_data."""
        return _packages.to_meshio(self)

    def to_pyvista(self) -> Any:
        """Returns a pyvista.UnstructuredGrid of the elements, z = 0.

        cell_data has 'region', the tags, and element_values; point_data has node_values.
        """
        return _packages.to_pyvista(self)

    def to_skfem(self) -> Any:
        """Returns a skfem.MeshTri or MeshQuad with boundaries and subdomains by name.

        Parts and regions without a name are called 'boundary_TAG' and 'region_TAG'. ValueError for elements of second
        order or of several kinds.
        """
        return _packages.to_skfem(self)

    def to_dolfinx(self, comm: Any = None) -> Tuple[Any, Any, Any]:
        """Returns a dolfinx.mesh.Mesh, and MeshTags of its cells (regions) and of its facets (edges).

        comm: of mpi4py, with the mesh on rank 0, which is divided; None: COMM_WORLD. ValueError for elements of second
        order or of several kinds.
        """
        return _packages.to_dolfinx(self, comm)

    def _repr_svg_(self) -> str:
        return self.to_bytes("svg").decode()

    def __reduce__(self):
        return Mesh, (np.array(self.nodes), [np.array(block) for block in self.blocks.values()],
                      np.array(self.regions), np.array(self.edges), np.array(self.edge_tags), self.boundary_names,
                      self.region_names, *map(np.array, self.points)), {"node_values": self.node_values,
                                                                        "element_values": self.element_values}

    def __setstate__(self, state: Dict[str, Dict[str, np.ndarray]]) -> None:
        self.node_values, self.element_values = state["node_values"], state["element_values"]

    def __repr__(self) -> str:
        return f"<forefront.Mesh: {len(self.nodes)} nodes, {self.element_count} elements>"


def limits_of(limits: Optional[Mapping[str, float]]) -> Dict[str, float]:
    """Returns limits by the words of the core, which have hyphens."""
    return {name.replace("_", "-"): float(value) for name, value in (limits or {}).items()}


def _takes_text(file: Any) -> bool:
    return hasattr(file, "encoding")

