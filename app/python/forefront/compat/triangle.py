"""The interface of the Python package ``triangle``, for programs that call Triangle.

``triangulate(tri, opts)`` takes and returns dicts of arrays with the same keys. Change one line::

    import forefront.compat.triangle as tr      # was: import triangle as tr

Switches: p (segments; without it the convex hull is meshed), q and q20 (least angle; the default is 20 degrees), a and
a0.1 (greatest area: of the regions, or of all elements), A (regional attributes), z (indices count from 0, as always here),
n (neighbours), e (edges), Q and V (no effect: nothing is printed). Other switches are refused. Input vertices come first,
in their order.

Differences, since this is an advancing front and not a refined Delaunay triangulation: vertices are added without q and a,
too, so that elements are well shaped. With q, there are about as many elements as Triangle makes, and seldom more than
1.2 times as many. Where two input segments meet at less than the least angle, the elements at their
common vertex have smaller angles, as in Triangle; the least angle is otherwise a promise, up to 33 degrees. Points of
holes and regions outside the domain are refused, not ignored.
"""
from __future__ import annotations

import re
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from .. import _core
from .._domain import Domain
from .._errors import MeshError
from .._mesh import Mesh
from .._meshing import mesh as make_mesh
from .._sizes import Source, face_places

#: Rounds in which area limits are tightened until every element meets them.
_ROUNDS = 8
#: Elements above a limit that get smaller sizes at their places, in the first rounds: this number, or part of all in the
#: face.
_LOCAL_ROUNDS, _FEW_ELEMENTS, _FEW = 4, 8, 0.01
_DEFAULT_ANGLE = 20.0
#: Growth of edges per unit of distance. With more, sizes differ so much that refinement to the least angle adds more
#: elements than the growth saves; with 0.25, the usual one, there are 1.7 times as many elements.
_GRADATION = 0.7


class _Switches:
    """The switches of a call."""

    def __init__(self, text: str) -> None:
        rest = text
        self.angle: Optional[float] = None
        self.area: Optional[float] = None
        self.region_areas = False
        number = r"(\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+(?:[eE][-+]?\d+)?)?"
        for value in re.findall("q" + number, rest):
            self.angle = float(value) if value else _DEFAULT_ANGLE
        rest = re.sub("q" + number, "", rest)
        for value in re.findall("a" + number, rest):
            self.area = float(value) if value else self.area
            self.region_areas = self.region_areas or not value
        rest = re.sub("a" + number, "", rest)
        unknown = sorted(set(rest) - set("pAzneQV"))
        if unknown:
            raise ValueError(f"opts: unknown switches {''.join(unknown)}; expected p, q, a, A, z, n, e, Q or V")
        if self.area is not None and not self.area > 0.0:
            raise ValueError(f"opts: expected a positive area after a, got {self.area}")
        if self.angle is not None and not 0.0 <= self.angle <= 33.0:
            raise ValueError(f"opts: expected an angle from 0 to 33 degrees after q, got {self.angle}")
        self.segments = "p" in rest
        self.attributes = "A" in rest
        self.neighbors = "n" in rest
        self.edges = "e" in rest


def triangulate(tri: Dict[str, Any], opts: str = "") -> Dict[str, np.ndarray]:
    """Meshes a planar straight-line graph.

    tri: 'vertices' (n, 2); with the switch p 'segments' (k, 2), and optionally 'segment_markers' (k,) or (k, 1), 'holes'
    (h, 2), 'regions' (r, 4): x, y, attribute, greatest area (-1: no limit); 'vertex_markers' (n,).

    Returns 'vertices', 'vertex_markers', 'triangles', with p 'segments' and 'segment_markers', with A
    'triangle_attributes', with n 'neighbors' (-1: none; neighbor k is opposite to corner k), with e 'edges' and
    'edge_markers'. With 'holes' or 'regions', these are returned as well. As in Triangle, segments without a marker have 0
    inside and 1 on the boundary.

    Raises MeshError, with places, for invalid input, and where the angle of q or an area of a cannot be had.
    """
    switches = _Switches(opts)
    if "vertex_attributes" in tri:
        raise ValueError("vertex_attributes: they are not carried to the mesh; leave them out and interpolate them")
    vertices = _vertices_of(tri)
    if switches.segments and "segments" not in tri:
        raise ValueError("segments: the switch p needs them, an array of shape (k, 2); leave out p to mesh the convex hull")
    segments = np.asarray(tri["segments"], dtype=np.int64).reshape(-1, 2) if switches.segments else _hull(vertices)
    markers = np.asarray(tri.get("segment_markers", np.zeros(len(segments))), dtype=np.int64).ravel()
    if not switches.segments:
        markers = np.ones(len(segments), np.int64)
    holes = np.asarray(tri.get("holes", ()), dtype=float).reshape(-1, 2) if switches.segments else np.empty((0, 2))
    regions = np.asarray(tri.get("regions", ()), dtype=float).reshape(-1, 4) if switches.segments else np.empty((0, 4))
    domain, tags = _domain(vertices, segments, markers, holes, regions)
    limits = _area_limits(domain, regions, tri, switches)
    result = _meshed(domain, limits, switches)
    return _dict(result, tri, vertices, tags, regions, switches)


def _vertices_of(tri: Dict[str, Any]) -> np.ndarray:
    if "vertices" not in tri:
        raise ValueError("vertices: they are missing; expected an array of shape (n, 2)")
    vertices = np.asarray(tri["vertices"], dtype=float)
    if vertices.ndim != 2 or vertices.shape[1] != 2:
        raise ValueError("vertices: expected an array of shape (n, 2)")
    infinite = np.flatnonzero(~np.isfinite(vertices).all(axis=1))
    if len(infinite):
        x, y = vertices[infinite[0]]
        raise ValueError(f"vertices[{infinite[0]}]: expected finite coordinates, got ({x:g}, {y:g})")
    return vertices


def _hull(points: np.ndarray) -> np.ndarray:
    """Returns the segments around all points, through those on it (A. M. Andrew's monotone chain, 1979)."""
    order = np.lexsort((points[:, 1], points[:, 0]))

    def chain(indices: Any) -> List[int]:
        hull: List[int] = []
        for k in indices:
            while len(hull) > 1:
                a, b = points[hull[-2]], points[hull[-1]]
                if (b[0] - a[0]) * (points[k][1] - a[1]) - (b[1] - a[1]) * (points[k][0] - a[0]) >= 0.0:
                    break
                hull.pop()
            hull.append(int(k))
        return hull

    loop = chain(order)[:-1] + chain(order[::-1])[:-1]
    if len(loop) < 3 or len(set(loop)) < len(loop):
        raise ValueError("vertices: without segments, expected at least three that are not on one line")
    return np.column_stack([loop, np.roll(loop, -1)])


def _domain(vertices: np.ndarray, segments: np.ndarray, markers: np.ndarray, holes: np.ndarray,
            regions: np.ndarray) -> Tuple[Domain, Dict[int, int]]:
    """Returns the domain, and the markers by tag: tags count from 1, markers may be any number."""
    values = [1] + [int(v) for v in np.unique(markers) if v != 1]
    tags = {value: tag for tag, value in enumerate(values, 1)}
    if len(segments) and not (0 <= segments.min() and segments.max() < len(vertices)):
        raise ValueError(f"segments: expected indices from 0 to {len(vertices) - 1}")
    used = np.unique(segments)
    number = np.zeros(len(vertices), np.int64)
    number[used] = np.arange(len(used))
    bare = Domain()
    bare.add_segments(vertices[used], number[segments], [tags[int(marker)] for marker in markers])
    bare.marks_holes = True
    for at in holes:
        bare.hole(at)
    for row, values_of_region in enumerate(regions):
        bare.region(values_of_region[:2], row + 2)
    loose = np.setdiff1d(np.arange(len(vertices)), used)
    return _with_points(bare, vertices[loose]), {tag: value for value, tag in tags.items()}


def _with_points(bare: Domain, points: np.ndarray) -> Domain:
    """Adds vertices that no segment uses, except those outside, which stay without triangles."""
    domain = Domain(bare)
    for at in points:
        domain.add_point(at)
    first = len(bare.nodes)
    outside = {index for fault in domain.validate(limit=len(points) + 200) if fault.code == "point-outside"
               for kind, index in fault.parts if kind in ("point", "node")}
    if not outside:
        return domain
    domain = Domain(bare)
    for k, at in enumerate(points):
        if k not in outside and first + k not in outside:
            domain.add_point(at)
    return domain


def _area_limits(domain: Domain, regions: np.ndarray, tri: Dict[str, Any],
                 switches: _Switches) -> List[Tuple[np.ndarray, float]]:
    """Returns places and the greatest area in the face of each."""
    limits = []
    if "triangle_max_area" in tri:
        raise ValueError("triangle_max_area: refinement of a triangulation (switch r) is not offered; give areas in "
                         "regions")
    if switches.area is not None:
        limits += [(at, switches.area) for at in face_places(domain)]
    if switches.region_areas:
        limits += [(row[:2], float(row[3])) for row in regions if row[3] > 0.0]
    return limits


def _meshed(domain: Domain, limits: List[Tuple[np.ndarray, float]], switches: _Switches) -> Mesh:
    """Returns a mesh that meets all limits. The mesher may exceed an area by an eighth; then it gets a smaller one, or if
    few elements do, smaller sizes at these."""
    x0, y0, x1, y1 = domain.bounds
    # The limits and the lengths of the segments set the sizes, as in Triangle.
    options: Dict[str, Any] = {"size": float(np.hypot(x1 - x0, y1 - y0)), "from_boundary": True,
                               "gradation": _GRADATION}
    if switches.angle:
        options["min_angle"] = switches.angle
    factors = np.ones(len(limits))
    sources: List[Source] = []
    for number in range(_ROUNDS):
        sized = Domain(domain)
        for (at, area), factor in zip(limits, factors):
            sized._limit_area(at, factor * area)
        result = make_mesh(sized, sources=sources, **options)
        excess = [_Excess(result, at, area) for at, area in limits]
        if all(len(each.places) == 0 for each in excess):
            return result
        for k, each in enumerate(excess):
            if len(each.places) == 0:
                continue
            if number >= _LOCAL_ROUNDS or len(each.places) > max(_FEW_ELEMENTS, _FEW * each.count):
                factors[k] *= 0.98 / each.ratio
            else:
                side = float(np.sqrt(4.0 / np.sqrt(3.0) * limits[k][1])) * 0.75 ** (number + 1)
                sources += [Source.point(place, side, _GRADATION) for place in each.places]
    raise MeshError([_core.fault("large-elements", f"an element has {each.ratio:.3g} times the greatest area {area:g}",
                                 "ask for smaller areas", (float(at[0]), float(at[1])))
                     for (at, area), each in zip(limits, excess) if len(each.places)])


class _Excess:
    """The elements of a face that are larger than its greatest area."""

    def __init__(self, mesh: Mesh, at: np.ndarray, limit: float) -> None:
        faces, areas = _core.mesh_faces(mesh), mesh.quality("area")
        inside = faces == faces[_element_at(mesh, at)]
        large = np.flatnonzero(inside & (areas > limit))
        self.count = int(np.count_nonzero(inside))
        self.ratio = float(areas[inside].max() / limit)
        self.places = mesh.nodes[mesh.elements[large]].mean(axis=1)


def _element_at(mesh: Mesh, at: np.ndarray) -> int:
    """Returns the element around a place, or the one that is least beside it."""
    a, b, c = (mesh.nodes[mesh.elements[:, k]] - np.asarray(at) for k in range(3))
    cross = [p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0] for p, q in ((a, b), (b, c), (c, a))]
    return int(np.argmax(np.min(cross, axis=0) / np.sum(cross, axis=0)))


def _dict(mesh: Mesh, tri: Dict[str, Any], vertices: np.ndarray, values: Dict[int, int], regions: np.ndarray,
          switches: _Switches) -> Dict[str, np.ndarray]:
    nodes, triangles, edges = _inputs_first(mesh, vertices)
    edge_markers = np.array([values[int(tag)] for tag in mesh.edge_tags], np.int32)
    edge_markers[(edge_markers == 0) & _on_boundary(triangles, edges)] = 1
    vertex_markers = np.zeros(len(nodes), np.int32)
    marked = edge_markers != 0
    vertex_markers[edges[marked].ravel()] = np.repeat(edge_markers[marked], 2)
    if "vertex_markers" in tri:
        given = np.asarray(tri["vertex_markers"], dtype=np.int32).ravel()
        vertex_markers[:len(given)] = np.where(given != 0, given, vertex_markers[:len(given)])
    result: Dict[str, np.ndarray] = {"vertices": nodes, "vertex_markers": vertex_markers.reshape(-1, 1),
                                     "triangles": triangles}
    if switches.segments:
        result["segments"], result["segment_markers"] = edges, edge_markers.reshape(-1, 1)
    if switches.attributes:
        attributes = np.concatenate([[0.0], regions[:, 2]])
        result["triangle_attributes"] = attributes[mesh.regions - 1].reshape(-1, 1)
    if switches.neighbors:
        # Edge k of an element joins its corners k and k + 1, and is opposite to corner k + 2.
        result["neighbors"] = mesh.neighbours[:, [1, 2, 0]]
    if switches.edges:
        result["edges"], result["edge_markers"] = _all_edges(triangles, edges, edge_markers)
    for key in ("holes", "regions"):
        if switches.segments and key in tri:
            result[key] = np.asarray(tri[key], dtype=float)
    return result


def _inputs_first(mesh: Mesh, vertices: np.ndarray) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns nodes, triangles and edges with the input vertices first; vertices in holes have no triangle."""
    place = {(float(x), float(y)): k for k, (x, y) in reversed(list(enumerate(vertices)))}
    new = np.array([place.get((float(x), float(y)), -1) for x, y in mesh.nodes], np.int64)
    added = new < 0
    new[added] = len(vertices) + np.arange(np.count_nonzero(added))
    nodes = np.concatenate([vertices, mesh.nodes[added]])
    return nodes, new[mesh.elements].astype(np.int32), new[mesh.edges].astype(np.int32)


def _on_boundary(triangles: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """Returns whether each edge has a triangle on one side only."""
    sides = np.sort(np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    known, counts = np.unique(sides, axis=0, return_counts=True)
    boundary = {tuple(edge) for edge in known[counts == 1].tolist()}
    return np.array([tuple(sorted(edge)) in boundary for edge in edges.tolist()], bool)


def _all_edges(triangles: np.ndarray, tagged: np.ndarray, markers: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    edges = np.unique(np.sort(np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1), axis=0)
    marker = {tuple(sorted(edge)): int(value) for edge, value in zip(tagged.tolist(), markers)}
    return edges, np.array([marker.get(tuple(edge), 0) for edge in edges.tolist()], np.int32).reshape(-1, 1)
