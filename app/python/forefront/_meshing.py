"""Meshing, adapting and reading meshes."""
from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Tuple, Union

import numpy as np

from . import _core
from ._arguments import names_of, refuse_unknown
from ._core import Fault
from ._domain import Domain, domain_of
from ._files import source_of
from ._mesh import Mesh, limits_of
from ._sampling import TOLERANCE
from ._sizes import job_of

Progress = Callable[[str, float], Any]


def mesh(domain: Any, size: Any = None, *, limits: Optional[Mapping[str, float]] = None, fix: bool = False,
         progress: Optional[Progress] = None, **options: Any) -> Mesh:
    """Meshes a domain.

    domain: a :class:`Domain`, a loop of shape (n, 2), a list of loops, the path of a file, GeoJSON as a dict, or an object with
    ``__geo_interface__``. How a file is read is up to :meth:`Domain.read`, which takes weld, layer and other options of
    readers: ``mesh(Domain.read("part.dxf", weld=0.01), 3)``.

    size: the length of the edges: a number; an expression in x and y; a function of arrays x and y, both of shape (k,),
    that returns k sizes, or one; a :class:`Grid`; a :class:`Background`; what :func:`read_sizes` returned; for features, the name of a
    property. None: what the domain brings along, or automatic. A function is called for many points at once, on the
    thread that called mesh(), and must give the same size for the same point. It is interpolated on a grid that is
    refined until it deviates by less than 2 %; where no grid is fine enough, and with exact=True, the function itself is
    called for each place, which takes ten times as long and uses one thread.

    Options: sources, a list of :class:`Source` · sizes, {boundary part: size} · regions, {region: size}; a size may be
    (size, growth per unit of distance) · max_area, a number or {region: area} · minimum, maximum · gradation, the
    maximum change of size per unit of distance · elements_across narrow places · segments_per_turn of curved
    boundaries · keep_automatic: sources only refine automatic sizes · from_boundary: given segments set the size ·
    parameters, {name: value} of the expression · curve_tolerance, a length · names, the property of features that
    holds the names of regions · elements: 'triangles', 'quads' or 'mixed' · order: 2 for nodes in the middles of edges,
    on the curves of the domain, in the order that :class:`Mesh` tells · quad_nodes: 8 or 9, of quadrilaterals of order 2 · method: 'fast' or 'classic' · rules of
    the classic method, a dict such as {'base': 'oldest', 'radius': 2} or a JSON file · grid: 'none', 'uniform',
    'uniform:COLSxROWS' or 'hierarchical' · improve: 'none', 'default' or 'best' · threads · keep_boundary: do not divide the given
    segments · target_elements: scale all sizes until the mesh has about so many elements, within 5 % · rasters,
    {name: file or Grid} that the expression calls as name(x, y), with its slopes name_x and name_y · size_presets, rules
    for coastal meshes such as 'wavelength:depth=sea,period=44714,elements=30' in place of size, of which the smallest
    counts · min_angle: no triangle has a smaller angle, in degrees up to 33, except at sharp corners of the domain and
    beside segments that may not be divided, which the notes name · repair: join what crosses or touches first · max_elements · verify: check the mesh against the domain.

    limits: of the mesh, such as {'max_growth': 2}, besides those of a project; their names are those of :meth:`Mesh.check`.
    ``notes`` warns where the mesh violates one. fix: change the settings until the mesh meets its limits, as far as that
    is possible; ``notes`` has each change.

    progress: called as progress(stage, fraction) on the same thread, at most every 20 ms. An exception that it or the
    size function raises ends the run and arrives unchanged, as does Ctrl-C.

    ``notes`` of the mesh has what the reader of a file did not use or warns of, what a repair changed, and the notes of
    the run. Warnings of readers are Python's warnings, too. Raises MeshError, with places, if the domain or a size is invalid.
    """
    refuse_unknown("mesh", options, [*names_of(mesh), *names_of(job_of)])
    job = job_of(domain, size, progress=progress, **options)
    result = Mesh(_core.mesh(*job.arguments, limits_of(limits), fix, progress))
    if job.sampled is not None and job.sampled.error(result.nodes) > TOLERANCE:
        # The function has details that the grid does not show.
        return mesh(domain, size, limits=limits, fix=fix, progress=progress, **{**options, "exact": True})
    return result


class Estimate(NamedTuple):
    """The result of :func:`estimate`."""

    elements: float
    nodes: float  #: with those in the middles of edges
    boundary_edges: int
    bytes: float  #: memory that the run adds
    seconds: float  #: CPU time of the run
    notes: List[Fault]  #: of the reader of the domain, and what a repair changed


def estimate(domain: Any, size: Any = None, *, progress: Optional[Progress] = None, **options: Any) -> Estimate:
    """Estimates what :func:`mesh` would need, without meshing. Arguments: as for :func:`mesh`.

    Numbers of triangles are within 15 %. Numbers of quadrilaterals differ by up to a half where sizes change fast, and
    elements that min_angle adds are not counted.
    """
    refuse_unknown("estimate", options, names_of(job_of))
    job = job_of(domain, size, progress=progress, **options)
    return Estimate(*_core.estimate(*job.arguments, progress))


class Adapted(NamedTuple):
    """The result of :func:`adapt`."""

    mesh: Mesh
    rounds: List[Tuple[int, int, float]]  #: of the given mesh and each new one: nodes, elements, relative error
    met: bool  #: the last error is within the requested one
    stalled: bool  #: finer meshes no longer lower the error


def adapt(mesh: Mesh, values: Union[str, Any, Callable[[Mesh], Any]], error: float, *, domain: Any = None,
          rounds: int = 8, size_min: Optional[float] = None, size_max: Optional[float] = None,
          gradation: float = 0.3, max_elements: Optional[int] = None, threads: Optional[int] = None,
          improve: Optional[str] = None, progress: Optional[Progress] = None) -> Adapted:
    """Remeshes until the gradient of a field is accurate to ``error``, relative to its norm (0.05: 5 %).

    values: an expression in x and y; a function of a :class:`Mesh` that returns the values at its nodes, such as a
    solver; or the values themselves, shape (n,), which are known on this mesh only, so that a single new mesh is
    made. domain: what to mesh; None: the area of the mesh, with its tags. size_min, size_max: bounds of the edge
    lengths. gradation: their maximum change per unit of distance. rounds: maximum number of new meshes.
    """
    target = {"error": float(error), "gradation": float(gradation)}
    if size_min is not None:
        target["size_min"] = float(size_min)
    if size_max is not None:
        target["size_max"] = float(size_max)
    if not 0.0 < error <= 1.0:
        raise ValueError(f"error: expected a number between 0 and 1, got {error}")
    given = None if domain is None else domain_of(domain)
    job = job_of(given if given is not None else Domain(), max_elements=max_elements, threads=threads,
                 improve=improve)
    found, figures, met, stalled = _core.adapt(mesh, given, values, job.options, target, rounds, Mesh, progress)
    return Adapted(Mesh(found), figures, met, stalled)


def read_mesh(file: Any, format: Optional[str] = None) -> Mesh:
    """Reads a mesh, with its values of nodes and elements, from a path, an open file or bytes.

    format: an id of :func:`formats`; None: by content, then by extension. ``notes`` of the mesh lists what the reader
    did not use; ``node_values`` and ``element_values`` are dicts of arrays, NaN where the file has no value.
    """
    found, nodes, elements = _core.read_mesh(*source_of(file, format))
    result = Mesh(found)
    result.node_values, result.element_values = nodes, elements
    return result


def read_fields(file: Any, format: Optional[str] = None) -> Tuple[Mesh, Dict[str, np.ndarray], Dict[str, np.ndarray]]:
    """Reads a mesh, and the values of its nodes and elements by name."""
    result = read_mesh(file, format)
    return result, result.node_values, result.element_values


def formats() -> List[Dict[str, Any]]:
    """Returns the file formats: id, name, extension, and what is read and written."""
    return _core.formats()
