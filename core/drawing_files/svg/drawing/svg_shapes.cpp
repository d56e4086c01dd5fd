#include "core/drawing_files/svg/drawing/svg_drawer.hpp"
#include "core/drawing_files/svg/style/svg_notes.hpp"
#include "core/drawing_files/svg/xml/svg_elements.hpp"
#include "core/engine/domain/coordinate_range.hpp"
#include "core/files/common/names.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace forefront {

namespace {

/// Returns true for an arc that a transformation has pressed into a line, which the chords along it follow exactly.
bool isFlat(const Curve &curve) {
    const std::array<double, 8> n = curve.numbers();
    return curve.kind() == CurveKind::Arc && cross({n[2], n[3]}, {n[4], n[5]}) == 0.0;
}

/// Returns the path data of an element: an attribute, or a property of CSS such as path("M 0 0 h 1").
std::string pathData(const pugi::xml_node &node, const SvgStyles &styles) {
    const std::string styled = styles.valueAsWritten(node, "d");
    if (!styled.starts_with("path(")) {
        return styled == "none" ? std::string() : node.attribute("d").value();
    }
    const std::size_t open = styled.find_first_of("\"'"), close = styled.find_last_of("\"'");
    return open < close && close != styled.npos ? styled.substr(open + 1, close - open - 1) : std::string();
}

/// Returns the factor from lengths that the author measures, as the attribute `pathLength` has them, to user units.
double dashScaleOf(const pugi::xml_node &node, std::span<const SvgSubpath> subpaths) {
    const double stated = node.attribute("pathLength").as_double();
    double length = 0.0;
    for (const SvgSubpath &subpath : subpaths) {
        if (!(stated > 0.0)) {
            break;
        }
        for (std::size_t k = 0; k + (subpath.closed ? 0 : 1) < subpath.nodes.size(); ++k) {
            const CurveStretch stretch = k < subpath.stretches.size() ? subpath.stretches[k] : CurveStretch{};
            length += stretch.follows() ? subpath.curves[stretch.curve].length(stretch.t0, stretch.t1)
                                        : distance(subpath.nodes[k], subpath.nodes[(k + 1) % subpath.nodes.size()]);
        }
    }
    return length > 0.0 ? length / stated : 1.0;
}

} // namespace

void SvgDrawer::shape(const Visit &visit, std::string_view name) {
    const pugi::xml_node &node = visit.node;
    if (reports_ && visit.partOf == kNoClip) { // what masks and clip paths make of a paint has a note of its own
        notePaint(source_, visit.paint, node);
    }
    const double stretch = visit.map.stretch();
    SvgPen pen(tolerance_ && stretch > 0.0 ? std::optional(*tolerance_ / stretch) : std::nullopt);
    std::optional<SvgFault> fault;
    const char *attribute = "";
    if (name == "path") {
        attribute = "d";
        fault = drawPath(pathData(node, styles_), pen);
    } else if (name == "polygon" || name == "polyline") {
        attribute = "points";
        std::vector<Vec2> points;
        fault = readPoints(node.attribute("points").value(), points);
        for (const Vec2 p : points) {
            pen.down() ? pen.lineTo(p) : pen.moveTo(p);
        }
        if (name == "polygon") {
            pen.close();
        }
    } else if (name == "line") {
        pen.moveTo({length(visit, "x1", SvgExtent::Width), length(visit, "y1", SvgExtent::Height)});
        pen.lineTo({length(visit, "x2", SvgExtent::Width), length(visit, "y2", SvgExtent::Height)});
    } else {
        roundShape(visit, name, pen);
    }
    if (fault) {
        leaveOut(node, attribute, fault->offset, "bad-path", fault->message, {}, "the rest of the path");
    }
    std::vector<SvgSubpath> subpaths = pen.take();
    const double dashScale = dashScaleOf(node, subpaths);
    for (SvgSubpath &subpath : subpaths) {
        keep(visit, name, std::move(subpath), dashScale);
    }
    ++elementCount_;
}

void SvgDrawer::roundShape(const Visit &visit, std::string_view name, SvgPen &pen) {
    const auto across = [&](const char *attribute) { return length(visit, attribute, SvgExtent::Width); };
    const auto down = [&](const char *attribute) { return length(visit, attribute, SvgExtent::Height); };
    const auto radii = [&] { // one that is not given, malformed or negative is the same as the other
        const auto radius = [&](const char *attribute, SvgExtent extent) {
            const auto given = isGiven(visit, attribute) ? givenLength(visit, attribute, extent) : std::nullopt;
            return given && *given >= 0.0 ? given : std::nullopt;
        };
        const auto rx = radius("rx", SvgExtent::Width), ry = radius("ry", SvgExtent::Height);
        return Vec2{rx.value_or(ry.value_or(0.0)), ry.value_or(rx.value_or(0.0))};
    };
    if (name == "rect" || name == "image") {
        const Vec2 size{across("width"), down("height")};
        if (size.x > 0.0 && size.y > 0.0) {
            const Vec2 rounding = radii();
            pen.rectangle({across("x"), down("y")}, size, rounding.x, rounding.y);
        }
    } else if (name == "circle" || name == "ellipse") {
        const double r = name == "circle" ? length(visit, "r", SvgExtent::Diagonal) : 0.0;
        const Vec2 axes = name == "circle" ? Vec2{r, r} : radii();
        if (axes.x > 0.0 && axes.y > 0.0) {
            pen.ellipse({across("cx"), down("cy")}, axes.x, axes.y);
        }
    }
}

/// Returns the name of a shape: the label or id of the <use> that draws it, else its own.
std::string SvgDrawer::nameOf(const Visit &visit) {
    for (const pugi::xml_node &node : {visit.named, visit.node}) {
        for (const char *attribute : {"inkscape:label", "id"}) {
            if (const pugi::xml_attribute name = node.attribute(attribute); *name.value() != '\0') {
                return cleanName(name.value());
            }
        }
    }
    return {};
}

void SvgDrawer::keep(const Visit &visit, std::string_view element, SvgSubpath subpath, double dashScale) {
    SvgPath path;
    path.closed = subpath.closed;
    path.rounding = subpath.rounding * visit.map.stretch();
    path.nodes = std::move(subpath.nodes);
    for (Vec2 &p : path.nodes) {
        p = visit.map(p);
        if (!isFinite(p) || tooLarge(p)) {
            leaveOut(visit.node, "", 0, "out-of-range", "a shape reaches beyond 1e60 in magnitude");
            return;
        }
    }
    for (Curve &curve : subpath.curves) {
        curve = curve.mapped(visit.map);
    }
    for (CurveStretch &stretch : subpath.stretches) {
        if (stretch.follows() && isFlat(subpath.curves[stretch.curve])) {
            stretch = {};
        }
    }
    path.curves = std::move(subpath.curves);
    path.stretches = std::move(subpath.stretches);
    nodeCount_ += path.nodes.size();
    if (nodeCount_ > kSpareNodes + kNodesPerByte * source_.text.size()) {
        fail(visit.node, "", 0, "too-large", "the curves need too many nodes", "give a larger tolerance");
        return;
    }
    path.isLine = element == "line" || element == "polyline";
    path.paint = visit.paint;
    path.paint.filled = visit.paint.fillAlpha() > 0.0;
    path.paint.stroked = visit.paint.strokeAlpha() > 0.0;
    const bool scales =
        styles_.value(visit.node, "vector-effect") != "non-scaling-stroke"; // otherwise the width is unknown
    path.strokeWidth = path.paint.stroked && scales ? visit.paint.line.width * visit.map.minStretch() : 0.0;
    path.strokeArea = source_.options.strokeAreas && path.strokeWidth > 0.0;
    path.frame = visit.map;
    for (double &dash : path.paint.line.dashes) {
        dash *= dashScale;
    }
    path.paint.line.dashOffset *= dashScale;
    path.limit = visit.limit;
    path.element = elementCount_;
    path.name = nameOf(visit);
    path.offset = offsetOf(visit.named ? visit.named : visit.node);
    if (visit.partOf == kNoClip) {
        paths_.push_back(std::move(path));
    } else {
        keepPart(visit, std::move(path));
    }
}

} // namespace forefront
