"""Lengths and bounds of the curves in a DXF file by ezdxf, an independent reader: what Forefront's reader is held
against. Curves are flattened finely; blocks are exploded by ezdxf."""
import math

import ezdxf
from ezdxf import recover
from ezdxf.math import OCS, bulge_to_arc

CURVES = {"LINE", "LWPOLYLINE", "POLYLINE", "CIRCLE", "ARC", "ELLIPSE", "SPLINE"}


def tilted(entity):
    """Returns true for entities in a tilted plane, which Forefront leaves out."""
    if entity.dxftype() in ("LINE", "SPLINE"):
        return False
    z = entity.dxf.get("extrusion", (0, 0, 1))
    return math.hypot(z[0], z[1]) > 1e-9 * abs(z[2])


def points(entity):
    """Returns the plane points of an entity as a polyline; None if it is of a kind that is left out."""
    kind = entity.dxftype()
    if kind == "LINE":
        return [entity.dxf.start, entity.dxf.end]
    if kind in ("CIRCLE", "ARC"):
        radius = entity.dxf.radius
        if radius <= 0:
            return None
        begin, end = (0, 360) if kind == "CIRCLE" else (entity.dxf.start_angle, entity.dxf.end_angle)
        sweep = (end - begin) % 360 or 360
        ocs = OCS(entity.dxf.get("extrusion", (0, 0, 1)))
        count = 1000
        return list(ocs.points_to_wcs(
            entity.dxf.center + (radius * math.cos(math.radians(begin + sweep * k / count)),
                                 radius * math.sin(math.radians(begin + sweep * k / count))) for k in range(count + 1)))
    if kind == "ELLIPSE":
        tool = entity.construction_tool()
        begin, end = tool.start_param, tool.end_param
        sweep = (end - begin) % (2 * math.pi) or 2 * math.pi
        if sweep < 1e-9:
            sweep = 2 * math.pi
        return list(tool.vertices(begin + sweep * k / 1000 for k in range(1001)))
    if kind == "SPLINE":
        if len(entity.control_points) == 0 and len(entity.fit_points) < 2:
            return None
        tool = entity.construction_tool()
        knots = list(tool.knots())[tool.order - 1:tool.count + 1]
        spans = [(a, b) for a, b in zip(knots, knots[1:]) if a < b]  # of very different lengths
        count = max(64, 8192 // max(1, len(spans)))
        return list(tool.points([a + (b - a) * k / count for a, b in spans for k in range(count)] + [knots[-1]]))
    return polyline(entity)


def polyline(entity):
    if entity.dxftype() == "LWPOLYLINE":
        vertices = [((x, y), bulge) for x, y, bulge in entity.get_points("xyb")]
        closed, ocs = entity.closed, entity.ocs()
        elevation = entity.dxf.elevation
    else:
        if entity.is_poly_face_mesh or entity.is_polygon_mesh:
            return None
        # Control points of a splined polyline are not on it.
        vertices = [((v.dxf.location.x, v.dxf.location.y), v.dxf.get("bulge", 0)) for v in entity.vertices
                    if not (entity.dxf.flags & 4 and v.dxf.flags & 16)]
        closed, ocs, elevation = entity.is_closed, entity.ocs(), 0
        if entity.is_3d_polyline:
            ocs = OCS()
    line = []
    for k, (place, bulge) in enumerate(vertices):
        following = vertices[(k + 1) % len(vertices)][0]
        line.append(place)
        if k + 1 == len(vertices) and not closed:
            break
        if abs(bulge) > 1e-7 and math.dist(place, following) > 0:
            centre, begin, end, radius = bulge_to_arc(place, following, bulge)
            sweep = (end - begin) % (2 * math.pi)
            steps = [k / 500 for k in range(1, 500)]
            for t in (steps if bulge > 0 else reversed(steps)):
                angle = begin + t * sweep
                line.append((centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)))
    if closed and vertices:
        line.append(vertices[0][0])
    return list(ocs.points_to_wcs([(x, y, elevation) for x, y in line]))


def visible_frozen(document, entity):
    layer = document.layers.get(entity.dxf.layer) if entity.dxf.layer in document.layers else None
    return layer is not None and layer.is_frozen()


def curves_of(document, entities, layer=None, depth=0):
    """Yields the curves of entities and, with the layers that they take there, of inserted blocks."""
    for entity in entities:
        if entity.dxf.get("invisible", 0) or entity.dxf.get("paperspace", 0):
            continue
        own = layer if layer is not None and entity.dxf.layer == "0" else entity.dxf.layer
        if entity.dxftype() == "INSERT":
            if visible_frozen(document, entity) and depth == 0 or entity.block() is None:
                continue
            for each in (entity.multi_insert() if entity.mcount > 1 else [entity]):
                yield from curves_of(document, each.virtual_entities(), own, depth + 1)
        elif entity.dxftype() in CURVES and not tilted(entity):
            yield own, entity


def lines_of(document):
    """Yields layer and polyline of each curve in the model."""
    for layer, entity in curves_of(document, document.modelspace()):
        line = points(entity)
        if line and len(line) > 1:
            yield layer.strip(), [(p[0], p[1]) for p in line]


def document_in(path):
    try:
        return ezdxf.readfile(path)
    except (ezdxf.DXFError, UnicodeDecodeError):
        return recover.readfile(path)[0]


def measure(path):
    """Returns units and, for each layer, number of paths, length and bounds, as forefront_dxf_paths prints them."""
    document = document_in(path)
    layers = {}
    for layer, line in lines_of(document):
        found = layers.setdefault(layer, {"paths": 0, "length": 0.0, "box": [math.inf, math.inf, -math.inf, -math.inf]})
        found["paths"] += 1
        found["length"] += sum(math.dist(p, q) for p, q in zip(line, line[1:]))
        box = found["box"]
        xs, ys = [p[0] for p in line], [p[1] for p in line]
        found["box"] = [min(box[0], *xs), min(box[1], *ys), max(box[2], *xs), max(box[3], *ys)]
    return {"units": document.header.get("$INSUNITS", 0), "layers": layers}


def differences(ours, theirs, tolerance=2e-6):
    """Returns in words where two measures differ, relative to the size of the drawing."""
    found = []
    lower = {name.lower(): value for name, value in ours["layers"].items()}
    other = {}
    for name, value in theirs["layers"].items():
        other.setdefault(name.lower(), value)
    boxes = [value["box"] for value in theirs["layers"].values()]
    size = max((math.hypot(b[2] - b[0], b[3] - b[1]) for b in boxes), default=1.0) or 1.0
    for name in sorted(lower.keys() | other.keys()):
        if name not in lower or name not in other:
            value = lower.get(name) or other.get(name)
            if value["length"] > tolerance * size:
                found.append(f"layer {name} only {'here' if name in lower else 'there'}")
            continue
        a, b = lower[name], other[name]
        if abs(a["length"] - b["length"]) > 1e-5 * b["length"] + tolerance * size:
            found.append(f"layer {name}: length {a['length']:.9g} instead of {b['length']:.9g}")
        if max(abs(p - q) for p, q in zip(a["box"], b["box"])) > 1e-5 * size:
            found.append(f"layer {name}: bounds {a['box']} instead of {b['box']}")
    return found
