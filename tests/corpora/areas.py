"""Computes the true area of a drawing or map, without Forefront: by a renderer or by GEOS."""

import collections
import io
import json
import pathlib
import re
import subprocess
import xml.etree.ElementTree as xml

PIXELS = 800  # along the longer side of a rendered drawing


# How sources.py writes the edges of a graph.
DRAWING_OF_LINES = '<svg xmlns="http://www.w3.org/2000/svg"><g fill="none" stroke="black">\n'
FILLS_ALONE = "* { stroke: none !important; filter: none !important }"
OPACITY = re.compile(r"""(opacity\s*[:=]\s*["']?\s*)([0-9.eE+-]+%?)""")


def opaque(found):
    """Returns an opacity of 1 instead of any other but 0."""
    return found[1] + ("1" if re.search("[1-9]", found[2].split("e")[0]) else found[2])


def area_of(path):
    """Returns the area of a file of a corpus, or None if no reference is defined for it."""
    path = pathlib.Path(path)
    if path.suffix in (".geojson", ".json"):
        return area_of_map(json.loads(path.read_text(encoding="utf-8-sig")))
    text = path.read_text(encoding="utf-8")
    return area_of_lines(text) if text.startswith(DRAWING_OF_LINES) else area_painted(text)


def area_painted(text):
    """Returns the area that librsvg paints without strokes, in units of the drawing: the coverage of all pixels.

    What lies outside of the view box is not painted. Half-transparent shapes count as a whole. Returns None for a
    drawing without a view box, or if nothing is filled.
    """
    from PIL import Image, ImageStat  # pylint: disable=import-outside-toplevel

    root = xml.fromstring(OPACITY.sub(opaque, text))
    if "viewBox" not in root.attrib:
        return None
    xml.SubElement(root, "{http://www.w3.org/2000/svg}style").text = FILLS_ALONE
    x, y, width, height = (float(word) for word in re.split(r"[\s,]+", root.attrib["viewBox"].strip()))
    root.set("viewBox", f"{x} {y} {width} {height}")
    for name in ("width", "height"):
        root.attrib.pop(name, None)
    scale = PIXELS / max(width, height)
    columns, rows = round(width * scale), round(height * scale)
    png = subprocess.run(["rsvg-convert", f"--width={columns}", f"--height={rows}", "--format=png"],
                         input=xml.tostring(root), check=True, capture_output=True).stdout
    coverage = Image.open(io.BytesIO(png)).convert("RGBA").getchannel("A")
    return ImageStat.Stat(coverage).mean[0] / 255.0 * width * height or None


def winding(lines, place):
    """Returns how often directed lines run around a place: those that cross the ray to the right, by direction."""
    turns = 0
    for (ax, ay), (bx, by) in lines:
        if (ay > place.y) != (by > place.y) and place.x < ax + (place.y - ay) / (by - ay) * (bx - ax):
            turns += 1 if by > ay else -1
    return turns


def faces_of(lines):
    """Returns the faces that lines enclose as polygons."""
    from shapely.geometry import LineString  # pylint: disable=import-outside-toplevel
    from shapely.ops import polygonize, unary_union  # pylint: disable=import-outside-toplevel

    return list(polygonize(unary_union([LineString(line) for line in lines if line[0] != line[1]])))


def without_free_ends(edges):
    """Returns the edges of a graph that are left when chains with a free end are taken away."""
    while True:
        degree = collections.Counter(end for edge in edges for end in edge)
        kept = {edge for edge in edges if all(degree[end] > 1 for end in edge)}
        if len(kept) == len(edges):
            return kept
        edges = kept


def components_of(edges):
    """Yields the connected parts of a graph as lists of edges."""
    around = collections.defaultdict(list)
    for edge in edges:
        for end in edge:
            around[end].append(edge)
    while edges:
        part, open_edges = set(), [next(iter(edges))]
        while open_edges:
            edge = open_edges.pop()
            if edge not in part:
                part.add(edge)
                open_edges += around[edge[0]] + around[edge[1]]
        edges = edges - part
        yield part


def area_of_lines(text):
    """Returns the area of a drawing of lines alone.

    Connected lines bound by the even-odd rule where all of their nodes are even, else the outermost of them do.
    """
    from shapely.geometry import LineString, Polygon  # pylint: disable=import-outside-toplevel
    from shapely.ops import unary_union  # pylint: disable=import-outside-toplevel

    lines = []
    for found in re.finditer(r'd="M(\S+),(\S+?)L(\S+),(\S+?)"', text):
        lines.append(((float(found[1]), float(found[2])), (float(found[3]), float(found[4]))))
    noded = unary_union([LineString(line) for line in lines if line[0] != line[1]])
    edges = {tuple(sorted(pair)) for line in getattr(noded, "geoms", [noded])
             for pair in zip(line.coords, line.coords[1:])}
    covered = Polygon()
    for part in components_of(without_free_ends(edges)):
        degree = collections.Counter(end for edge in part for end in edge)
        faces = faces_of(part)
        if all(count % 2 == 0 for count in degree.values()):
            inside = [face for face in faces if winding(part, face.representative_point()) % 2 != 0]
        else:
            inside = [Polygon(face.exterior) for face in faces]
        covered = covered.symmetric_difference(unary_union(inside))
    return covered.area


def arcs_of(topology):
    """Returns the arcs of a TopoJSON topology as lists of places."""
    transform = topology.get("transform")
    if not transform:
        return topology["arcs"]
    (sx, sy), (tx, ty) = transform["scale"], transform["translate"]
    arcs = []
    for steps in topology["arcs"]:
        x = y = 0
        arcs.append([])
        for step in steps:
            x, y = x + step[0], y + step[1]
            arcs[-1].append([sx * x + tx, sy * y + ty])
    return arcs


def with_coordinates(geometry, arcs):
    """Returns the GeoJSON geometry of a polygon or a collection of a topology."""
    def ring(numbers):
        parts = [arcs[number] if number >= 0 else arcs[~number][::-1] for number in numbers]
        return parts[0] + [place for part in parts[1:] for place in part[1:]]

    kind = geometry.get("type")
    if kind == "GeometryCollection":
        return {"type": kind, "geometries": [with_coordinates(g, arcs) for g in geometry["geometries"]]}
    if kind == "Polygon":
        return {"type": kind, "coordinates": [ring(numbers) for numbers in geometry["arcs"]]}
    if kind == "MultiPolygon":
        return {"type": kind, "coordinates": [[ring(numbers) for numbers in polygon] for polygon in geometry["arcs"]]}
    return {"type": kind, "coordinates": []}


def geometries_of(data):
    if data is None:
        return []
    kind = data.get("type")
    if kind == "Topology":
        arcs = arcs_of(data)
        return [g for part in data["objects"].values() for g in geometries_of(with_coordinates(part, arcs))]
    if kind == "FeatureCollection":
        return [g for feature in data["features"] for g in geometries_of(feature)]
    if kind == "Feature":
        return geometries_of(data.get("geometry"))
    if kind == "GeometryCollection":
        return [g for part in data["geometries"] for g in geometries_of(part)]
    return [data]


def polygon_of(rings):
    """Returns the area of a polygon from what its rings cover, the outline first."""
    from shapely.ops import unary_union  # pylint: disable=import-outside-toplevel

    outline, holes = rings[0], [hole for hole in rings[1:] if not hole.is_empty]
    if not holes:
        return outline
    if any(outline.intersection(hole).area == 0 or hole.contains(outline) for hole in holes):
        for hole in holes:
            outline = outline.symmetric_difference(hole)
        return outline
    return outline.difference(unary_union(holes))


def area_of_map(data):
    """Returns the area of the union of all polygons: of each, what its outline covers without what its holes cover.

    If a hole lies outside the outline, the rings are parts of the polygon and holes in any order, by the even-odd rule.
    """
    from shapely.geometry import Polygon  # pylint: disable=import-outside-toplevel
    from shapely.ops import unary_union  # pylint: disable=import-outside-toplevel

    def covered(ring):
        """What a ring runs around at least once."""
        ring = [tuple(place[:2]) for place in ring]
        if len(set(ring)) < 3 or Polygon(ring).is_valid:
            return Polygon(ring) if len(set(ring)) > 2 else Polygon()
        lines = list(zip(ring, ring[1:] + ring[:1]))
        return unary_union([face for face in faces_of(lines) if winding(lines, face.representative_point()) != 0])

    shapes = []
    for geometry in geometries_of(data):
        polygons = {"Polygon": lambda c: [c], "MultiPolygon": lambda c: c}.get(geometry["type"], lambda c: [])
        for rings in polygons(geometry["coordinates"]):
            if rings:
                shapes.append(polygon_of([covered(ring) for ring in rings]))
    return unary_union(shapes).area
