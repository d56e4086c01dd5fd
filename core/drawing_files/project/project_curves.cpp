#include "core/drawing_files/project/project_curves.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/coordinate_range.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace forefront {
namespace {

/// Returns true for a cubic that has shrunk to a point, as under a transform that presses a drawing into a line.
bool isPoint(Vec2 from, Vec2 control1, Vec2 control2, Vec2 to) {
    return from == to && control1 == from && control2 == from;
}

/// Returns true for curves that are written as null.
bool isNull(const Curve &curve) {
    const std::array<double, 8> n = curve.numbers();
    return curve.kind() == CurveKind::Line ||
           (curve.kind() == CurveKind::Cubic && isPoint({n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}, {n[6], n[7]}));
}

/// Returns true for paths without curves, which need no cuts either.
bool isStraightPath(const Shape &shape) {
    return isPath(shape) && std::all_of(shape.path().curves.begin(), shape.path().curves.end(), isNull);
}

void writeCurve(const Curve &curve, JsonText &out) {
    if (isNull(curve)) {
        out << "null";
        return;
    }
    const std::array<double, 8> n = curve.numbers();
    switch (curve.kind()) {
    case CurveKind::Line:
        break;
    case CurveKind::Cubic:
        out << "{\"cubic\": [";
        out.point({n[2], n[3]});
        out << ", ";
        out.point({n[4], n[5]});
        out << "]}";
        break;
    case CurveKind::Arc:
        out << "{\"arc\": {\"centre\": ";
        out.point({n[0], n[1]});
        out << ", \"u\": ";
        out.point({n[2], n[3]});
        out << ", \"v\": ";
        out.point({n[4], n[5]});
        out << ", \"start\": ";
        out.number(n[6]);
        out << ", \"sweep\": ";
        out.number(n[7]);
        out << "}}";
        break;
    }
}

/// Reads the curves of one path.
class CurveReader {
  public:
    CurveReader(const Outline &outline, JsonCheck &check) : outline_(outline), check_(check) {}

    /// Reads the curve of a segment; returns a line if it is straight or invalid.
    Curve read(const JsonValue &item, std::size_t segment) {
        if (item.is(JsonKind::Null)) {
            return {};
        }
        if (!check_.expect(item, JsonKind::Object, "a curve")) {
            return {};
        }
        if (const auto cubic = item.find("cubic")) {
            return readCubic(*cubic, segment);
        }
        if (const auto arc = item.find("arc")) {
            return readArc(*arc, segment);
        }
        check_.fault(item, "bad-curve", "unknown kind of curve; expected \"cubic\" or \"arc\"",
                     "write null for a straight segment");
        return {};
    }

  private:
    Curve readCubic(const JsonValue &value, std::size_t segment) {
        if (!check_.expect(value, JsonKind::Array, "\"cubic\"")) {
            return {};
        }
        const std::vector<Vec2> controls = check_.points(value, "a control point");
        if (controls.size() != 2) {
            check_.fault(value, "bad-count", "a cubic has 2 control points, found " + std::to_string(controls.size()));
            return {};
        }
        const Vec2 from = outline_.from(segment), to = outline_.to(segment);
        if (tooLarge(controls[0]) || tooLarge(controls[1])) {
            check_.fault(value, "bad-curve", "a control point lies beyond 1e60", "scale the drawing down");
            return {};
        }
        return isPoint(from, controls[0], controls[1], to) ? Curve() : Curve::cubic(from, controls[0], controls[1], to);
    }

    Curve readArc(const JsonValue &value, std::size_t segment) {
        if (!check_.expect(value, JsonKind::Object, "\"arc\"")) {
            return {};
        }
        const std::size_t faults = check_.faults().size();
        std::array<Vec2, 3> points{};
        constexpr std::array kPoints = {"centre", "u", "v"};
        for (std::size_t k = 0; k < kPoints.size(); ++k) {
            if (const auto point = check_.member(value, kPoints[k], "the arc")) {
                points[k] = check_.point(*point, std::string("\"") + kPoints[k] + "\" of an arc");
            }
        }
        std::array<double, 2> angles{};
        constexpr std::array kAngles = {"start", "sweep"};
        for (std::size_t k = 0; k < kAngles.size(); ++k) {
            if (const auto angle = check_.member(value, kAngles[k], "the arc")) {
                angles[k] = check_.number(*angle, std::string("\"") + kAngles[k] + "\" of an arc");
            }
        }
        if (check_.faults().size() > faults) {
            return {};
        }
        return sound(Curve::arc(points[0], points[1], points[2], angles[0], angles[1]), value, segment);
    }

    /// Returns the arc, or a line after recording its fault.
    Curve sound(const Curve &arc, const JsonValue &value, std::size_t segment) {
        const std::array<double, 8> n = arc.numbers();
        constexpr double kTurn = 2.0 * std::numbers::pi * (1.0 + 1e-12);
        if (cross({n[2], n[3]}, {n[4], n[5]}) == 0.0) {
            check_.fault(value, "bad-curve", "the arc has no radius: its semi-axes \"u\" and \"v\" enclose no area",
                         "give two semi-axes that are not parallel");
        } else if (n[7] == 0.0 || std::fabs(n[7]) > kTurn) {
            check_.fault(value, "bad-curve",
                         "invalid sweep " + numberText(n[7], 6) +
                             " of an arc; expected an angle from -2π to 2π, not 0");
        } else if (!joins(arc, outline_.from(segment), outline_.to(segment))) {
            check_.fault(value, "bad-curve",
                         "the arc runs from " + placeText(arc.point(0.0)) + " to " + placeText(arc.point(1.0)) +
                             "; expected " + placeText(outline_.from(segment)) + " to " +
                             placeText(outline_.to(segment)) + ", the nodes of its segment");
        } else {
            return arc;
        }
        return {};
    }

    const Outline &outline_;
    JsonCheck &check_;
};

void wrongCount(const JsonValue &value, const char *what, std::size_t expected, std::size_t found, JsonCheck &check) {
    check.fault(value, "bad-count",
                std::string("expected ") + what + " for each of the " + std::to_string(expected) + " segments, found " +
                    std::to_string(found));
}

void readPath(const JsonValue &list, Shape &shape, JsonCheck &check) {
    if (!check.expect(list, JsonKind::Array, "\"curves\"")) {
        return;
    }
    if (!isPath(shape)) {
        check.fault(list, "bad-curve", "only polygons and polylines have \"curves\"");
        return;
    }
    const std::size_t nodes = shape.nodes.size();
    const std::size_t expected = shape.isPolygon() ? nodes : nodes - std::min<std::size_t>(nodes, 1);
    if (list.count() != expected) {
        wrongCount(list, "a curve or null", expected, list.count(), check);
        return;
    }
    std::vector<Curve> &curves = shape.path().curves;
    curves.resize(expected);
    const Outline outline = outlineOf(shape);
    CurveReader reader(outline, check);
    std::size_t k = 0;
    for (const JsonValue item : list) {
        if (check.full()) {
            return;
        }
        curves[k] = reader.read(item, k);
        ++k;
    }
}

std::vector<double> readCutsOf(const JsonValue &item, JsonCheck &check) {
    std::vector<double> cuts;
    if (!check.expect(item, JsonKind::Array, "the cuts of a segment")) {
        return cuts;
    }
    for (const JsonValue value : item) {
        const double cut = check.number(value, "a cut");
        if (!(cut > (cuts.empty() ? 0.0 : cuts.back()) && cut <= 1.0)) {
            check.fault(value, "bad-number", "expected cuts that increase from above 0 to 1 at most");
            return {};
        }
        cuts.push_back(cut);
    }
    return cuts;
}

void readCuts(const JsonValue &list, Shape &shape, JsonCheck &check) {
    if (!check.expect(list, JsonKind::Array, "\"cuts\"")) {
        return;
    }
    for (const JsonValue item : list) {
        if (check.full()) {
            return;
        }
        shape.cuts.push_back(readCutsOf(item, check));
    }
    const std::size_t expected = outlineOf(shape).segmentCount();
    if (shape.cuts.size() != expected) {
        wrongCount(list, "a list of cuts", expected, shape.cuts.size(), check);
        shape.cuts.clear();
    }
}

} // namespace

void writeCurves(const Shape &shape, JsonText &out) {
    if (isStraightPath(shape)) {
        return;
    }
    if (isPath(shape)) {
        out << ", \"curves\": [";
        out.list(shape.path().curves, ", ", [&](const Curve &curve) { writeCurve(curve, out); });
        out << ']';
    }
    if (!shape.cuts.empty()) {
        out << ", \"cuts\": [";
        out.list(shape.cuts, ", ", [&](const std::vector<double> &cuts) {
            out << '[';
            out.list(cuts, ", ", [&](double cut) { out.number(cut); });
            out << ']';
        });
        out << ']';
    }
}

void readCurves(const JsonValue &item, Shape &shape, JsonCheck &check) {
    if (const auto curves = item.find("curves")) {
        readPath(*curves, shape, check);
    }
    if (const auto cuts = item.find("cuts")) {
        readCuts(*cuts, shape, check);
    }
    if (isStraightPath(shape)) {
        shape.path().curves.clear();
        shape.cuts.clear();
    }
}

} // namespace forefront
