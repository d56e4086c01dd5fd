"""Domains: what is meshed."""
from __future__ import annotations

import json
from typing import Any, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._arguments import refuse_unknown, warn_of
from ._core import Fault
from ._files import source_of

Names = Union[None, str, int, Sequence[Union[str, int]]]


class Domain(_core.DomainBase):
    """A planar domain: outlines, holes, lines and points that the mesh keeps, regions, names.

    Without hole markers, a loop inside another loop is a hole, and a loop in a hole is an island. After
    :meth:`hole`, only faces with a marker are holes, as in Triangle's .poly files.

    A boundary part is named by a string, or by its tag, an integer from 1 on. Parts without a name have the tag 1. New
    names get the next free tag.
    """

    def __init__(self, other: Optional[_core.DomainBase] = None) -> None:
        """Makes an empty domain, or a copy."""
        if other is None:
            super().__init__()
        else:
            super().__init__(other)

    @property
    def notes(self) -> List[Fault]:
        """What the reader did not use or warns of, and what repairs changed; the notes of meshes begin with them."""
        return self._notes

    def add_loop(self, points: Any, names: Names = None) -> None:
        """Adds a closed polygon.

        points: shape (n, 2), the corners in any orientation. names: one for all segments, or n of them; segment k
        leads from corner k to the next.
        """
        super().add_loop(points, names)

    def add_line(self, points: Any, names: Names = None, closed: bool = False) -> None:
        """Adds a polyline inside the domain, which becomes edges of the mesh; it may divide regions or end freely.

        points: shape (n, 2). names: one for all n - 1 segments (n if closed), or one for each.
        """
        super().add_line(points, names, closed)

    def add_circle(self, centre: Any, radius: float, name: Union[None, str, int] = None, line: bool = False) -> None:
        """Adds a circle, on which all its nodes lie exactly. line: it is no boundary but a line inside the domain."""
        super().add_circle(centre, radius, name, line)

    def add_point(self, at: Any, name: Union[None, str, int] = None, size: Optional[float] = None,
                  growth: float = 0.2) -> None:
        """Adds a point that becomes a node.

        size: of the elements there, which grows by ``growth`` per unit of distance; None: no own size.
        """
        super().add_point(at, name, size, growth)

    def add_segments(self, points: Any, segments: Any, tags: Any = None) -> None:
        """Adds nodes, and boundary segments between them.

        points: shape (n, 2). segments: shape (k, 2), indices into ``points``. tags: shape (k,), from 1 on.
        """
        super().add_segments(points, segments, tags)

    def region(self, at: Any, name: Union[str, int], size: Optional[float] = None,
               max_area: Optional[float] = None, growth: float = 0.2) -> None:
        """Names the face that contains a point.

        size: of its elements, which grows by ``growth`` per unit of distance outside it. max_area: of its elements; the
        mean is about half of it, and single elements may exceed it by up to an eighth.
        """
        super().region(at, name, size, max_area, growth)

    def hole(self, at: Any) -> None:
        """Makes the face that contains a point a hole. Faces without a marker are then inside the domain."""
        super().hole(at)

    def add_layers(self, part: Union[str, int], first: float, growth: float = 1.2, count: Optional[int] = None,
                   thickness: Optional[float] = None, elements: str = "quads") -> None:
        """Adds boundary layers on a part: rows of thin elements, each higher than the one below by the factor growth.

        first: height of the first layer. count, or thickness of all layers; neither: until their elements are
        isotropic. elements: "quads" or "triangles".
        """
        super().add_layers(part, first, growth, count, thickness, elements)

    def add_crack(self, line: Union[str, int]) -> None:
        """Makes a crack of an inner line: the elements on its two sides get nodes of their own."""
        super().add_crack(line)

    def add_periodic(self, first: Union[str, int], second: Union[str, int]) -> None:
        """Divides two boundary parts alike, the second of which is the first one moved or turned."""
        super().add_periodic(first, second)

    def add_mapped(self, region: Union[str, int], corners: Any = None) -> None:
        """Fills the faces of a region by rows of elements. corners: shape (n, 2), 3 or 4 nodes of each face."""
        super().add_mapped(region, corners)

    def add_strip(self, line: Union[str, int], width: float, rows: int, elements: str = "quads",
                  region: Union[None, str, int] = None) -> None:
        """Gives an inner line a width, and fills the strip along it by rows of elements.

        elements: "quads" or "triangles". region: of the strip; None: one of its own, with the name of the line.
        """
        super().add_strip(line, width, rows, elements, region)

    def set_elements(self, region: Union[str, int], elements: str) -> None:
        """Sets the shapes of the elements of a region: "triangles", "quads" or "mixed"."""
        super().set_elements(region, elements)

    def name_part(self, name: str, start: Any, end: Any = None) -> None:
        """Names the part of the boundary from the node nearest to ``start`` to the node nearest to ``end``.

        The domain is on the left. end: None: the whole loop through the node. ``notes`` tells the length of the part.
        """
        super().name_part(name, start, end)

    def validate(self, limit: int = 200) -> List[Fault]:
        """Returns the faults of the domain, with places, at most ``limit``; empty if it can be meshed."""
        return super().validate(limit)

    def repair(self, tolerance: float = 0.0) -> Tuple["Domain", List[Fault]]:
        """Returns a repaired domain, and notes on what was changed, with places.

        Crossings, contacts and overlaps become nodes; what is closer than the tolerance is joined, and nothing moves
        farther than that.
        """
        domain, changes = self._repair(tolerance)
        return Domain(domain), changes

    def copy(self) -> "Domain":
        """Returns an independent copy."""
        return Domain(self)

    @classmethod
    def read(cls, file: Any, format: Optional[str] = None, **options: Any) -> "Domain":
        """Reads a domain with its sizes from a path, an open file or bytes.

        Projects, DXF, SVG, GeoJSON, TopoJSON, well-known text, .poly, CSV, airfoils, FEMM and the outlines of
        meshes. format: an id of :func:`formats`; None: by content, then by extension. Options, as of the batch program:
        curve_tolerance, weld (a length: ends closer than that are joined), layer (a name, or a list of names), names, sizes, projection, overlap ("later" or "smaller": the polygon of a map that
        wins where two overlap), strict, beyond_page, drop_lines, stroke_areas, shape_regions, white_holes, degrees
        ("warn", "keep" or "local"), parameters (a dict of expressions), parts ({name: (start, end)}, as :meth:`name_part`
        takes them, with places in the coordinates of the file). Raises ValueError for an option that the format lacks.
        ``notes`` of the domain lists what the reader did not use. Its warnings, such as of an outline that does not
        close, are Python's warnings, too.
        """
        refuse_unknown("Domain.read", options, _core.reading_options())
        source, identifier = source_of(file, format)
        domain = cls(_core.read_domain(source, identifier, options))
        warn_of(domain.notes)
        return domain

    @classmethod
    def from_geojson(cls, geojson: Union[str, bytes, Mapping[str, Any]], **options: Any) -> "Domain":
        """Reads GeoJSON as text or as a dict. Options: as for :meth:`read`; names: the property with the names."""
        text = json.dumps(geojson) if isinstance(geojson, Mapping) else geojson
        return cls.read(text.encode() if isinstance(text, str) else text, "geojson", **options)

    @classmethod
    def from_shapely(cls, geometry: Any, **options: Any) -> "Domain":
        """Reads a shapely geometry, a GeoDataFrame, or any other object with ``__geo_interface__``."""
        return cls.from_geojson(geometry.__geo_interface__, **options)

    def __repr__(self) -> str:
        return f"<forefront.Domain: {len(self.nodes)} nodes, {len(self.segments)} segments>"


def is_geojson(value: Any) -> bool:
    return hasattr(value, "__geo_interface__") or (isinstance(value, Mapping) and "type" in value)


def domain_of(value: Any) -> Domain:
    """Returns the domain that a value stands for: a domain, a path, GeoJSON, one loop or a list of loops."""
    if isinstance(value, Domain):
        return value
    if isinstance(value, _core.DomainBase):
        return Domain(value)
    if is_geojson(value):
        return Domain.from_shapely(value) if hasattr(value, "__geo_interface__") else Domain.from_geojson(value)
    if isinstance(value, (str, bytes)) or hasattr(value, "__fspath__"):
        return Domain.read(value)
    domain = Domain()
    if isinstance(value, (list, tuple)) and len(value) > 0 and np.ndim(value[0]) == 2:
        for loop in value:
            domain.add_loop(loop)
    else:
        domain.add_loop(value)
    return domain


def sized_domain(value: Any, column: str, names: Optional[str]) -> Domain:
    """Returns the domain of features with an element size in a property of each; the smallest counts in a region."""
    geojson = value.__geo_interface__ if hasattr(value, "__geo_interface__") else value
    features = []
    sizes: dict[str, float] = {}
    for number, feature in enumerate(geojson.get("features", [])):
        properties = dict(feature.get("properties") or {})
        if column not in properties:
            raise ValueError(f"size: feature {number} has no property '{column}'")
        name = str(properties[names]) if names else f"feature_{number}"
        size = float(properties[column])
        sizes[name] = min(size, sizes.get(name, size))
        features.append({**feature, "properties": {**properties, "forefront_name": name}})
    domain = Domain.from_geojson({**geojson, "features": features}, names="forefront_name")
    regions = Domain(domain)
    for at, tag in domain.regions:
        name = domain.region_names.get(tag)
        if name in sizes:
            regions.region(at, tag, size=sizes[name])
    return regions
