#include "core/edit/corner_commands.hpp"

#include "core/base/number_text.hpp"
#include "core/edit/path_curve.hpp"
#include "core/edit/shape_commands.hpp"
#include "core/edit/shape_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace forefront {
namespace {

constexpr double kSmooth = 1e-3; ///< radians by which a path turns at most in a node that is no corner
constexpr double kRounding = 1e-9;

/// A corner cut off: the side before it up to a parameter, what joins them, the side after it from a parameter on.
struct Cut {
    double s = 1.0, t = 0.0;
    Curve joint;
};

using CutCorner = std::function<std::optional<Cut>(const Curve &before, const Curve &after)>;

/// Returns the angle by which a path turns from one curve to the next, positive to the left.
double turnAt(const Curve &before, const Curve &after) {
    const Vec2 a = before.tangent(1.0), b = after.tangent(0.0);
    return std::atan2(cross(a, b), dot(a, b));
}

/// A curve moved to its left by a distance.
struct Parallel {
    const Curve &curve;
    double offset;

    Vec2 point(double t) const { return curve.point(t) + offset * leftNormal(curve.tangent(t)); }
    Vec2 derivative(double t) const { return (1.0 - offset * curvatureOf(curve, t)) * curve.derivative(t); }
};

bool inRange(double t) {
    return t >= -kRounding && t <= 1.0 + kRounding;
}

/// Finds the parameters at which the parallels of two curves meet, near the corner, by Newton's method.
std::optional<std::pair<double, double>> meeting(const Parallel &a, const Parallel &b, double reach) {
    const auto start = [reach](const Curve &curve) { return std::min(0.5, reach / std::max(curve.length(), reach)); };
    double s = 1.0 - start(a.curve), t = start(b.curve);
    constexpr int kSteps = 50;
    for (int step = 0; step < kSteps; ++step) {
        const Vec2 gap = b.point(t) - a.point(s), u = a.derivative(s), v = b.derivative(t);
        const double area = cross(u, v);
        if (!(std::fabs(area) > 1e-14 * length(u) * length(v))) {
            return std::nullopt;
        }
        const double ds = cross(gap, v) / area, dt = cross(gap, u) / area;
        s += std::clamp(ds, -0.5, 0.5);
        t += std::clamp(dt, -0.5, 0.5);
        if (!(std::fabs(s - 0.5) < 2.0 && std::fabs(t - 0.5) < 2.0)) {
            return std::nullopt;
        }
        if (std::fabs(ds) < 1e-14 && std::fabs(dt) < 1e-14) {
            break;
        }
    }
    const double size = std::max(a.curve.length(), b.curve.length());
    const bool meets = distance(a.point(s), b.point(t)) <= kRounding * size && inRange(s) && inRange(t);
    return meets ? std::optional(std::pair(std::clamp(s, 0.0, 1.0), std::clamp(t, 0.0, 1.0))) : std::nullopt;
}

std::optional<Cut> fillet(const Curve &before, const Curve &after, double radius) {
    const double turn = turnAt(before, after);
    const double offset = std::copysign(radius, turn);
    const Parallel a{before, offset}, b{after, offset};
    const auto found = meeting(a, b, radius * std::fabs(std::tan(0.5 * turn)));
    if (!found) {
        return std::nullopt;
    }
    const auto [s, t] = *found;
    const Vec2 centre = midpoint(a.point(s), b.point(t)), u = before.point(s) - centre;
    const Vec2 end = after.point(t) - centre;
    const double angle = std::atan2(cross(u, end), dot(u, end));
    if (angle * turn <= 0.0) {
        return std::nullopt; // the parallels meet beyond the corner
    }
    return Cut{s, t, Curve::arc(centre, u, leftNormal(u), 0.0, angle)};
}

/// Returns the parameter at a length along a curve from t = 0.
double parameterAt(const Curve &curve, double reach) {
    if (curve.kind() == CurveKind::Line) {
        return reach / curve.length();
    }
    double low = 0.0, high = 1.0;
    constexpr int kSteps = 60;
    for (int step = 0; step < kSteps; ++step) {
        const double middle = 0.5 * (low + high);
        (curve.length(0.0, middle) < reach ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

std::optional<Cut> chamfer(const Curve &before, const Curve &after, double reach) {
    if (before.length() < (1.0 - kRounding) * reach || after.length() < (1.0 - kRounding) * reach) {
        return std::nullopt;
    }
    const double s = 1.0 - std::min(1.0, parameterAt(before.part(1.0, 0.0), reach));
    const double t = std::min(1.0, parameterAt(after, reach));
    return Cut{s, t, Curve()};
}

/// The lists of a path, complete: one curve and one tag for each segment.
struct PathLists {
    std::vector<Vec2> nodes;
    std::vector<Curve> curves;
    std::vector<std::int32_t> tags;

    void erase(std::size_t k) {
        const auto at = static_cast<std::ptrdiff_t>(k);
        nodes.erase(nodes.begin() + at);
        curves.erase(curves.begin() + at);
        tags.erase(tags.begin() + at);
    }
};

/// Returns a part of a curve as a path stores it: a straight segment is known by its nodes.
Curve stored(const Curve &curve, double t0, double t1) {
    return curve.kind() == CurveKind::Line ? Curve() : curve.part(t0, t1);
}

/// Replaces a corner by a segment. A side of which nothing is left goes with it.
void replaceCorner(PathLists &path, std::size_t node, const Curve &first, const Curve &second, const Cut &cut) {
    const std::size_t before = (node + path.curves.size() - 1) % path.curves.size();
    const bool noBefore = cut.s <= kRounding, noAfter = cut.t >= 1.0 - kRounding;
    const auto at = static_cast<std::ptrdiff_t>(node);
    path.curves[before] = stored(first, 0.0, cut.s);
    path.curves[node] = before == node ? stored(second, cut.t, cut.s) : stored(second, cut.t, 1.0);
    path.nodes[node] = second.point(cut.t);
    path.nodes.insert(path.nodes.begin() + at, noBefore ? first.point(0.0) : first.point(cut.s));
    path.curves.insert(path.curves.begin() + at, cut.joint);
    path.tags.insert(path.tags.begin() + at, path.tags[before]);
    const std::size_t shifted = before >= node ? before + 1 : before;
    if (noAfter) {
        path.erase(node + 1);
    }
    if (noBefore) {
        path.erase(noAfter && shifted > node ? shifted - 1 : shifted);
    }
}

/// Cuts the given corners of a path. With `all`, smooth nodes and ends are left as they are.
Status cutCorners(Shape &shape, const std::set<std::uint32_t> &nodes, bool all, const CutCorner &cutCorner) {
    const bool closed = shape.kind == ShapeKind::Polygon;
    PathLists path{shape.nodes, shape.curves, shape.segmentTags};
    path.curves.resize(closed ? shape.nodes.size() : shape.nodes.size() - 1);
    path.tags.resize(path.curves.size(), shape.tag);
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
        const Outline outline{path.nodes, closed, path.curves, {}};
        const bool isEnd = !closed && (*node == 0 || *node + 1 == path.nodes.size());
        if (isEnd && !all) {
            return error("not-possible", "the end of an open path is no corner", "select nodes between its ends");
        }
        if (isEnd || *node >= path.nodes.size()) {
            continue;
        }
        const Curve first = outline.curve((*node + path.curves.size() - 1) % path.curves.size());
        const Curve second = outline.curve(*node);
        if (std::fabs(turnAt(first, second)) < kSmooth) {
            if (all) {
                continue;
            }
            return error("not-possible", "the node at " + placeText(path.nodes[*node]) + " is smooth, not a corner",
                         "select corners");
        }
        const std::optional<Cut> cut = cutCorner(first, second);
        if (!cut) {
            return error("not-possible", "no room for this at the corner at " + placeText(path.nodes[*node]),
                         "enter a smaller number");
        }
        replaceCorner(path, *node, first, second, *cut);
    }
    shape.nodes = std::move(path.nodes);
    shape.curves = std::move(path.curves);
    shape.segmentTags = std::move(path.tags);
    shape.cuts.clear();
    return {};
}

/// Makes a rectangle a path, if its corners are sharp.
Status openShape(Shape &shape) {
    if (shape.kind == ShapeKind::Rectangle && shape.radius == 0.0) {
        becomePath(shape);
    }
    if (!isPath(shape)) {
        return error("not-possible", displayName(shape) + " has no corners", "select paths or rectangles");
    }
    return {};
}

Result<Document> changeCorners(const Document &document, const Selection &selection, double size,
                               const CutCorner &cutCorner) {
    if (!(size > 0.0) || !std::isfinite(size)) {
        return error("bad-number", "invalid size of a corner; expected a number above 0");
    }
    std::map<std::uint32_t, std::set<std::uint32_t>> nodes;
    for (const NodeRef node : selection.nodes) {
        nodes[node.shape].insert(node.node);
    }
    for (const std::uint32_t id : selection.shapes) {
        nodes[id].clear();
    }
    Document next = document;
    for (const auto &[id, chosen] : nodes) {
        const Shape *given = findShape(document, id);
        if (given == nullptr) {
            return error("no-such-shape", "shape not found");
        }
        Shape shape = *given;
        if (Status status = openShape(shape); !status.empty()) {
            return status;
        }
        std::set<std::uint32_t> corners = chosen;
        for (std::uint32_t k = 0; chosen.empty() && k < shape.nodes.size(); ++k) {
            corners.insert(k);
        }
        if (*corners.rbegin() >= shape.nodes.size()) {
            return error("no-such-node", "node not found");
        }
        if (Status status = cutCorners(shape, corners, chosen.empty(), cutCorner); !status.empty()) {
            return status;
        }
        Result<Document> changed = replaceShape(next, std::move(shape));
        if (!changed) {
            return changed;
        }
        next = *std::move(changed);
    }
    return next;
}

} // namespace

Result<Document> filletCorners(const Document &document, const Selection &selection, double radius) {
    return changeCorners(document, selection, radius,
                         [radius](const Curve &before, const Curve &after) { return fillet(before, after, radius); });
}

Result<Document> chamferCorners(const Document &document, const Selection &selection, double distance) {
    return changeCorners(document, selection, distance, [distance](const Curve &before, const Curve &after) {
        return chamfer(before, after, distance);
    });
}

bool hasCorners(const Document &document, const Selection &selection) {
    const auto cuttable = [&](std::uint32_t id) {
        const Shape *shape = findShape(document, id);
        return shape != nullptr && (isPath(*shape) || (shape->kind == ShapeKind::Rectangle && shape->radius == 0.0));
    };
    return std::any_of(selection.shapes.begin(), selection.shapes.end(), cuttable) ||
           std::any_of(selection.nodes.begin(), selection.nodes.end(),
                       [&](NodeRef node) { return cuttable(node.shape); });
}

} // namespace forefront
