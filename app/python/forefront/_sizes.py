"""Element sizes and meshing options, as the core takes them."""
from __future__ import annotations

import json
import os
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._core import Fault
from ._domain import Domain, domain_of, is_geojson, sized_domain
from ._files import source_of
from ._sampling import Sampled, sampled

Point = Tuple[float, float]


@dataclass(frozen=True)
class Grid:
    """Element sizes on a regular grid, linear between its values.

    values: shape (rows, columns), the lowest row first; NaN: no size there. origin: place of values[0, 0].
    pitch: distance between columns and between rows, one number or two.
    """

    values: Any
    origin: Point = (0.0, 0.0)
    pitch: Union[float, Point] = 1.0


@dataclass(frozen=True)
class Background:
    """Element sizes at the nodes of a triangle mesh, linear on its elements.

    nodes: shape (n, 2). elements: shape (m, 3). values: shape (n,), > 0.
    """

    nodes: Any
    elements: Any
    values: Any


@dataclass(frozen=True)
class Source:
    """A size source: the size is ``size`` on its shape and grows by ``growth`` per unit of distance.

    Make one with :meth:`point`, :meth:`line`, :meth:`disc`, :meth:`box` or :meth:`gradient`.
    """

    shape: str
    a: Point
    b: Point
    size: float
    growth: float = 0.2
    radius: float = 0.0
    end_size: Optional[float] = None
    angle: float = 0.0
    is_gradient: bool = False
    geometric: bool = False
    name: str = ""

    @classmethod
    def point(cls, at: Point, size: float, growth: float = 0.2, radius: float = 0.0) -> "Source":
        """A point; the size is constant within ``radius``."""
        return cls("point", at, at, size, growth, radius)

    @classmethod
    def line(cls, start: Point, end: Point, size: float, end_size: Optional[float] = None, growth: float = 0.2,
             radius: float = 0.0) -> "Source":
        """A line; the size changes linearly to ``end_size`` at its end, if that is given."""
        return cls("line", start, end, size, growth, radius, end_size)

    @classmethod
    def disc(cls, centre: Point, radius: float, size: float, growth: float = 0.2) -> "Source":
        """A disc."""
        return cls("circle", centre, centre, size, growth, radius)

    @classmethod
    def box(cls, corner: Point, opposite: Point, size: float, growth: float = 0.2, angle: float = 0.0) -> "Source":
        """A box whose sides are turned by ``angle`` degrees from the axes."""
        return cls("box", corner, opposite, size, growth, angle=angle)

    @classmethod
    def gradient(cls, start: Point, end: Point, size: float, end_size: float, geometric: bool = False) -> "Source":
        """A gradient over the whole plane, constant beyond its ends. geometric: by equal factors, not steps."""
        return cls("line", start, end, size, 0.0, end_size=end_size, is_gradient=True, geometric=geometric)

    def _add_to(self, sizes: _core.Sizes) -> None:
        sizes.add_source(self.shape, self.a, self.b, self.size, self.growth, self.radius, self.name, self.end_size,
                         self.angle, self.is_gradient, self.geometric)


def read_sizes(file: Any, format: Optional[str] = None, *, black: Optional[float] = None,
               white: Optional[float] = None, box: Optional[Tuple[float, float, float, float]] = None) -> _core.Sizes:
    """Reads element sizes: a mesh with nodal values, an ESRI ASCII grid, the rules of a project, or a picture.

    For a picture (PNG), black and white are the sizes that these colours mean, and box is its rectangle
    (x0, y0, x1, y1). Pass the result as ``size``.
    """
    source, identifier = source_of(file, format)
    picture = None
    if black is not None or white is not None or box is not None:
        if black is None or white is None or box is None:
            raise ValueError("a picture needs black, white and box")
        picture = [black, white, *box]
    return _core.read_sizes(source, identifier, picture)


def _tag_of(name: Union[str, int], names: Mapping[int, str], what: str) -> int:
    if not isinstance(name, str):
        return int(name)
    for tag, known in names.items():
        if known == name:
            return tag
    expected = ", ".join(sorted(names.values())) or "a tag, since nothing has a name"
    raise ValueError(f"unknown {what} '{name}'; expected {expected}")


def _pair(value: Any) -> Tuple[float, float]:
    """Returns (size, growth) of a size, or of both."""
    return (float(value[0]), float(value[1])) if isinstance(value, (tuple, list)) else (float(value), 0.2)


def _is_function(size: Any) -> bool:
    return callable(size) and not isinstance(size, (_core.Sizes, Grid, Background))


def _pitch_of(grid: Grid) -> Point:
    return (grid.pitch, grid.pitch) if np.ndim(grid.pitch) == 0 else grid.pitch


def _set_size(sizes: _core.Sizes, size: Any) -> None:
    if isinstance(size, str):
        sizes.expression = size
    elif isinstance(size, Grid):
        sizes.set_grid(size.values, size.origin, _pitch_of(size))
    elif isinstance(size, Background):
        sizes.set_background(size.nodes, size.elements, size.values)
    elif isinstance(size, Sampled):
        sizes.set_grid(size.values, size.origin, size.pitch)
    elif callable(size):
        sizes.set_function(size)
    else:
        try:
            sizes.size = float(size)
        except TypeError:
            raise TypeError("size: expected a number, an expression, a function of (x, y), a Grid or a Background, "
                            f"got {type(size).__name__}") from None


def _region_places(domain: Domain, name: Union[str, int]) -> list:
    tag = _tag_of(name, domain.region_names, "region")
    places = [at for at, marker in domain.regions if marker == tag]
    if not places:
        raise ValueError(f"no region has the tag {tag}; add it with Domain.region()")
    return places


def _set_areas(sizes: _core.Sizes, domain: Domain, max_area: Any) -> None:
    if isinstance(max_area, Mapping):
        for name, area in max_area.items():
            for at in _region_places(domain, name):
                sizes.add_region(at, 0.0, float(area), 0.2)
    elif max_area is not None:
        for at in face_places(domain):
            sizes.add_region(at, 0.0, float(max_area), 0.2)


def face_places(domain: Domain) -> np.ndarray:
    """Returns a place well inside each face of a domain, found in a coarse mesh of it: shape (f, 2)."""
    plain = Domain(domain)
    options = _core.Options()
    options.set_improve("none")
    coarse = _core.mesh(plain, _core.Sizes(), True, options, {}, False, None)
    faces, areas = _core.mesh_faces(coarse), coarse.quality("area")
    best = np.lexsort((-areas, faces))
    first = best[np.searchsorted(faces[best], np.arange(faces.max() + 1))]
    return coarse.nodes[coarse.elements[first]].mean(axis=1)


@dataclass
class Job:
    """The arguments of a run, as the core takes them."""

    domain: Domain
    sizes: _core.Sizes
    replaces: bool
    options: _core.Options
    sampled: Optional[Sampled] = None  #: the size function, if a grid stands for it
    arguments: tuple = field(init=False)

    def __post_init__(self) -> None:
        self.arguments = (self.domain, self.sizes, self.replaces, self.options)


def job_of(domain: Any, size: Any = None, *, sources: Iterable[Source] = (),
           sizes: Optional[Mapping[Union[str, int], Any]] = None,
           regions: Optional[Mapping[Union[str, int], Any]] = None, max_area: Any = None,
           minimum: Optional[float] = None, maximum: Optional[float] = None, gradation: Optional[float] = None,
           elements_across: Optional[float] = None, segments_per_turn: Optional[float] = None,
           keep_automatic: Optional[bool] = None, from_boundary: bool = False,
           parameters: Optional[Mapping[str, float]] = None, curve_tolerance: Optional[float] = None,
           names: Optional[str] = None, elements: Optional[str] = None, method: Optional[str] = None,
           grid: Optional[str] = None, improve: Optional[str] = None, threads: Optional[int] = None,
           keep_boundary: Optional[bool] = None, min_angle: Optional[float] = None,
           max_elements: Optional[int] = None, verify: bool = False,
           exact: bool = False, repair: bool = False, order: Optional[int] = None, quad_nodes: Optional[int] = None,
           rules: Any = None, target_elements: Optional[int] = None, rasters: Optional[Mapping[str, Any]] = None,
           size_presets: Union[None, str, Sequence[str]] = None, progress: Any = None) -> Job:
    """Makes the job of :func:`forefront.mesh` and :func:`forefront.run`, which document the arguments."""
    if size_presets is not None:
        if size is not None:
            raise ValueError("size_presets: they are the size; leave out size")
        size = _core.preset_expression([size_presets] if isinstance(size_presets, str) else list(size_presets))
    if isinstance(size, str) and is_geojson(domain) and _has_property(domain, size):
        domain, size = sized_domain(domain, size, names), None
    elif names is not None and is_geojson(domain):
        geojson = domain.__geo_interface__ if hasattr(domain, "__geo_interface__") else domain
        domain = Domain.from_geojson(geojson, names=names)
    elif names is not None and (isinstance(domain, str) or hasattr(domain, "__fspath__")):
        domain = Domain.read(domain, names=names)
    elif names is not None:
        raise ValueError("names: only features have properties; expected a file, GeoJSON or an object with "
                         "__geo_interface__")
    domain = domain_of(domain)
    if repair:
        domain, _ = domain.repair()
    if curve_tolerance is not None:
        domain = domain.copy()
        domain.curve_tolerance = curve_tolerance
    grid_of_size = sampled(size, domain.bounds) if _is_function(size) and not exact else None
    size = size if grid_of_size is None else grid_of_size
    spec = _core.Sizes(size) if isinstance(size, _core.Sizes) else _core.Sizes()
    if size is not None and not isinstance(size, _core.Sizes):
        _set_size(spec, size)
    for source in sources:
        source._add_to(spec)
    for name, value in (sizes or {}).items():
        spec.set_part(_tag_of(name, domain.boundary_names, "boundary part"), *_pair(value))
    for name, value in (regions or {}).items():
        for at in _region_places(domain, name):
            length, growth = _pair(value)
            spec.add_region(at, length, 0.0, growth)
    _set_areas(spec, domain, max_area)
    given = {"minimum": minimum, "maximum": maximum, "gradation": gradation, "elements_across": elements_across,
             "segments_per_turn": segments_per_turn, "keep_automatic": keep_automatic}
    for name, value in given.items():
        if value is not None:
            setattr(spec, name, value)
    spec.from_boundary = spec.from_boundary or from_boundary
    if parameters:
        spec.names = dict(parameters)
    notes = _set_rasters(spec, rasters or {})
    if notes:
        domain = domain.copy()
        domain._add_notes(notes)
    options = _options(domain, elements, method, grid, improve, threads, keep_boundary, min_angle, max_elements, verify)
    _set_form(options, order, quad_nodes, rules)
    if target_elements is None:
        return Job(domain, spec, size is not None, options, grid_of_size)
    if target_elements < 1:
        raise ValueError(f"target_elements: expected a number from 1 on, got {target_elements}")
    scaled = _core.scaled_domain(domain, spec, size is not None, options, int(target_elements), progress)
    return Job(Domain(scaled), _core.Sizes(), False, options)


def _has_property(geojson: Any, name: str) -> bool:
    features = (geojson.__geo_interface__ if hasattr(geojson, "__geo_interface__") else geojson).get("features", [])
    return any(name in (feature.get("properties") or {}) for feature in features)


def _set_rasters(spec: _core.Sizes, rasters: Mapping[str, Any]) -> List[Fault]:
    """Gives the expression its rasters. Returns the notes of their readers."""
    notes: List[Fault] = []
    for name, raster in rasters.items():
        if isinstance(raster, Grid):
            spec.set_raster(name, raster.values, raster.origin, _pitch_of(raster))
        elif isinstance(raster, str) or hasattr(raster, "__fspath__"):
            notes += spec.read_raster(name, os.fspath(raster))
        else:
            raise TypeError(f"rasters: expected a file or a Grid for '{name}', got {type(raster).__name__}")
    return notes


def _set_form(options: _core.Options, order: Optional[int], quad_nodes: Optional[int], rules: Any) -> None:
    if order is not None:
        options.set_order(str(order))
    if quad_nodes is not None:
        options.set_quad_nodes(str(quad_nodes))
    if isinstance(rules, Mapping):
        options.set_rules(json.dumps(rules))
    elif rules is not None:
        options.set_rules(Path(rules).read_text(encoding="utf-8"))


def _options(domain: Domain, elements: Optional[str], method: Optional[str], grid: Optional[str],
             improve: Optional[str], threads: Optional[int], keep_boundary: Optional[bool],
             min_angle: Optional[float], max_elements: Optional[int], verify: bool) -> _core.Options:
    options = _core.Options(domain)
    cells = re.fullmatch(r"uniform:(\d+)x(\d+)", grid or "")
    if cells:
        options.set_uniform_grid(*(min(int(number), 2**31 - 1) for number in cells.groups()))
    for word, setter in ((elements, options.set_elements), (method, options.set_method),
                         (None if cells else grid, options.set_grid),
                         (improve, options.set_improve)):
        if word is not None:
            setter(word)
    if threads is not None:
        if threads < 1:
            raise ValueError(f"threads: expected a number from 1 on, got {threads}")
        options.threads = threads
    if keep_boundary is not None:
        options.keep_boundary = keep_boundary
    if min_angle is not None:
        options.min_angle = float(min_angle)
    if max_elements is not None:
        options.max_elements = int(max_elements)
    options.verify = verify
    return options

