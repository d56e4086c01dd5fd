"""The mesh."""
from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._core import Fault
from ._domain import Domain


class Mesh(_core.MeshBase):
    """An immutable mesh.

    ``nodes`` (n, 2) float64 · ``elements`` (m, 3) uint32, counter-clockwise · ``regions`` (m,) int32 · ``edges`` (k, 2)
    uint32 and ``edge_tags`` (k,) int32, the boundary and the lines · ``boundary_names`` and ``region_names`` by tag. All
    are read-only views of the mesh, in the order in which it was made; they stay valid after the mesh is gone.

    A mesh of quadrilaterals alone has ``elements`` of shape (m, 4). One of several kinds has ``blocks``, a dict from
    the kind, such as 'triangle3', to its elements; ``regions`` runs through all blocks in turn.
    """

    node_values: Dict[str, np.ndarray]
    element_values: Dict[str, np.ndarray]

    def __init__(self, nodes: Any, elements: Any = None, regions: Any = None, edges: Any = None,
                 edge_tags: Any = None, boundary_names: Optional[Mapping[int, str]] = None,
                 region_names: Optional[Mapping[int, str]] = None) -> None:
        """Makes a mesh from arrays, which are copied, or a second object for a mesh.

        nodes: (n, 2). elements: (m, 3), or (m, 4, 6, 8 or 9) for other kinds, or a list of such arrays. regions: (m,)
        tags from 1 on; None: all 1. edges: (k, 2), and their tags (k,); None: all 1.
        """
        if isinstance(nodes, _core.MeshBase):
            super().__init__(nodes)
        else:
            blocks = elements if isinstance(elements, (list, tuple)) and np.ndim(elements[0]) == 2 else [elements]
            super().__init__(_core.mesh_from_arrays(nodes, list(blocks), regions, edges, edge_tags,
                                                    dict(boundary_names or {}), dict(region_names or {})))
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

    def quality(self, measure: str = "alpha") -> np.ndarray:
        """Returns the values of a measure of each element, edge or node.

        Of elements: 'alpha' (shape factor, 1 for an equilateral triangle), 'scaled-jacobian', 'min-angle' and
        'max-angle' (degrees), 'area', 'area-ratio', 'region', 'birth'. Of edges: 'length', 'size' and 'delta' (length
        compared with the node spacing). Also 'across', 'island-area' and 'valence'.
        """
        return super().quality(measure)

    def summary(self) -> Dict[str, Any]:
        """Returns the figures of ``forefront mesh --stats`` and ``check --stats`` as a dict."""
        return json.loads(self._summary())

    def check(self, domain: Optional[Domain] = None, **limits: float) -> List[Fault]:
        """Checks that the mesh is valid and, if it is given, fits its domain; returns all faults and notes.

        limits: such as min_angle=25, max_angle, min_alpha, min_scaled_jacobian, max_growth, min_length, max_length,
        min_delta, min_across, max_valence. Each place that violates one is a fault.
        """
        return self._check(domain, {name.replace("_", "-"): value for name, value in limits.items()})

    def write(self, file: Any, format: Optional[str] = None, inner_edges: Optional[bool] = None,
              progress: Any = None) -> List[Fault]:
        """Writes the mesh to a path or an open file, and returns notes on what the format changes.

        format: an id of :func:`formats`; None: by extension. inner_edges: whether tagged edges inside the domain are
        written; None: as programs that read the format accept them. A file is replaced as a whole or not at all.
        """
        if not hasattr(file, "write"):
            return self._write(os.fspath(file), format or "", inner_edges, progress)
        if format is None:
            raise ValueError("format: an open file needs one, such as 'msh2'")
        content = self.to_bytes(format, inner_edges)
        file.write(content.decode() if _takes_text(file) else content)
        return []

    def to_bytes(self, format: str, inner_edges: Optional[bool] = None) -> bytes:
        """Returns the file of a format that has one file."""
        return super().to_bytes(format, inner_edges)

    def numbered(self, order: Union[str, Sequence[int]] = "rcm") -> "Mesh":
        """Returns the mesh with its nodes in another order, for a small bandwidth of the matrices of solvers.

        order: 'rcm', the reverse of E. Cuthill and J. McKee's order (1969), or the old index of each new node.
        """
        rows = np.arange(len(self.nodes))
        old = np.asarray(_reverse_cuthill_mckee(self) if isinstance(order, str) and order == "rcm" else order)
        if old.shape != rows.shape or not np.array_equal(np.sort(old), rows):
            raise ValueError("order: expected 'rcm' or each index of a node once")
        new = np.empty(len(rows), np.int64)
        new[old] = rows
        if len(self.points[0]):
            raise ValueError("order: a mesh with points keeps its numbers; write it as it is")
        return Mesh(self.nodes[old], [new[block] for block in self.blocks.values()], self.regions, new[self.edges],
                    self.edge_tags, self.boundary_names, self.region_names)

    def to_matplotlib(self) -> Any:
        """Returns a matplotlib.tri.Triangulation."""
        from matplotlib.tri import Triangulation

        return Triangulation(self.nodes[:, 0], self.nodes[:, 1], self.triangles()[0])

    def to_meshio(self) -> Any:
        """Returns a meshio.Mesh, with tags as 'gmsh:physical' and names in field_data."""
        import meshio

        words = {"triangle3": "triangle", "triangle6": "triangle6", "quadrilateral4": "quad",
                 "quadrilateral8": "quad8", "quadrilateral9": "quad9"}
        cells = [("line", self.edges)]
        tags = [self.edge_tags]
        first = 0
        for kind, block in self.blocks.items():
            cells.append((words[kind], block))
            tags.append(self.regions[first:first + len(block)])
            first += len(block)
        names = {name: np.array([tag, 1]) for tag, name in self.boundary_names.items()}
        names.update({name: np.array([tag, 2]) for tag, name in self.region_names.items()})
        return meshio.Mesh(self.nodes, cells, cell_data={"gmsh:physical": tags}, field_data=names)

    def _repr_svg_(self) -> str:
        return self.to_bytes("svg").decode()

    def __reduce__(self):
        return Mesh, (np.array(self.nodes), [np.array(block) for block in self.blocks.values()],
                      np.array(self.regions), np.array(self.edges), np.array(self.edge_tags), self.boundary_names,
                      self.region_names)

    def __repr__(self) -> str:
        return f"<forefront.Mesh: {len(self.nodes)} nodes, {self.element_count} elements>"


def _takes_text(file: Any) -> bool:
    return hasattr(file, "encoding")


def _reverse_cuthill_mckee(mesh: Mesh) -> np.ndarray:
    count = len(mesh.nodes)
    pairs = []
    for block in mesh.blocks.values():
        wide = block.astype(np.int64)
        pairs += [wide[:, [i, j]] for i in range(wide.shape[1]) for j in range(wide.shape[1]) if i != j]
    both = np.unique(np.concatenate(pairs), axis=0) if pairs else np.empty((0, 2), np.int64)
    first = np.searchsorted(both[:, 0], np.arange(count + 1))
    degree = np.diff(first)
    seen = np.zeros(count, bool)
    order: List[int] = []
    for start in np.argsort(degree, kind="stable"):
        if seen[start]:
            continue
        seen[start] = True
        place = len(order)
        order.append(int(start))
        while place < len(order):
            node = order[place]
            place += 1
            near = both[first[node]:first[node + 1], 1]
            near = near[~seen[near]]
            seen[near] = True
            order.extend(near[np.argsort(degree[near], kind="stable")].tolist())
    return np.array(order[::-1], np.int64)
