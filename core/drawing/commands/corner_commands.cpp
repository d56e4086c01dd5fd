#include "core/drawing/commands/corner_commands.hpp"

#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/geometry/curve_part.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace forefront {
namespace {

constexpr double kSmooth = 1e-3; ///< maximum turn, in radians, of a path at a node that is not a corner
constexpr double kCornerRounding = 1e-9;

/// A corner cut off: the side before it up to a parameter, the joining curve, the side after it from a parameter on.
struct Cut {
    double s = 1.0, t = 0.0;
    Curve joint;
};

using Corners = std::set<std::uint32_t>;
using ChangeCorners = std::function<Status(Shape &, const Corners &chosen)>;

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
    return t >= -kCornerRounding && t <= 1.0 + kCornerRounding;
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
    const bool meets = distance(a.point(s), b.point(t)) <= kCornerRounding * size && inRange(s) && inRange(t);
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
    if (before.length() < (1.0 - kCornerRounding) * reach || after.length() < (1.0 - kCornerRounding) * reach) {
        return std::nullopt;
    }
    const double s = 1.0 - std::min(1.0, parameterAt(before.part(1.0, 0.0), reach));
    const double t = std::min(1.0, parameterAt(after, reach));
    return Cut{s, t, Curve()};
}

Diagnostics noRoom(const std::string &where) {
    return error("not-possible", where + " has no room for a cut of this size", "enter a smaller number");
}

/// A node of a path with the segment that starts there.
struct Element {
    Vec2 node;
    Curve curve; ///< as a path stores it: a straight segment is defined by its nodes
    std::int32_t tag = 1;
    std::optional<PartSize> size; ///< at the node
};

/// Returns the size of a node that takes the place of two: the smaller one.
std::optional<PartSize> smaller(const std::optional<PartSize> &a, const std::optional<PartSize> &b) {
    return !b || (a && a->size <= b->size) ? a : b;
}

/// Cuts corners of a path in one pass, from its last node to its first. With `all`, smooth nodes and ends are skipped.
class CornerPass {
  public:
    CornerPass(const Shape &shape, bool all) : closed_(shape.isPolygon()), all_(all) {
        const std::vector<Curve> &curves = shape.path().curves;
        for (std::uint32_t k = 0; k < shape.nodes.size(); ++k) {
            const auto size = shape.nodeSizes.find(k);
            ahead_.push_back({shape.nodes[k], k < curves.size() ? curves[k] : Curve(), segmentTag(shape, k),
                              size != shape.nodeSizes.end() ? std::optional(size->second) : std::nullopt});
        }
    }

    Status run(const std::set<std::uint32_t> &nodes, const CutCorner &cutCorner) {
        while (!ahead_.empty()) {
            const auto node = static_cast<std::uint32_t>(ahead_.size() - 1);
            const Element element = ahead_.back();
            ahead_.pop_back();
            const bool isEnd = !closed_ && (ahead_.empty() || done_.empty());
            if (!nodes.contains(node) || (isEnd && all_)) {
                done_.push_back(element);
            } else if (isEnd) {
                return error("not-possible",
                             "the end of an open path at " + placeText(element.node) + " is not a corner",
                             "select nodes between its ends");
            } else if (Status status = cut(element, cutCorner); !status.empty()) {
                return status;
            }
        }
        return {};
    }

    /// Writes the result to the path.
    void finish(Shape &shape) {
        std::vector<Curve> &curves = shape.path().curves;
        std::reverse(done_.begin(), done_.end());
        shape.nodes.clear();
        curves.clear();
        shape.segmentTags.clear();
        shape.nodeSizes.clear();
        shape.segmentSizes.clear(); // see carrySegmentSizes()
        for (const Element &element : done_) {
            if (element.size) {
                shape.nodeSizes[static_cast<std::uint32_t>(shape.nodes.size())] = *element.size;
            }
            shape.nodes.push_back(element.node);
            curves.push_back(element.curve);
            shape.segmentTags.push_back(element.tag);
        }
        if (!closed_) {
            curves.pop_back();
            shape.segmentTags.pop_back();
        }
        shape.cuts.clear();
    }

  private:
    static Curve curveOf(const Element &element, Vec2 end) {
        return element.curve.kind() == CurveKind::Line ? Curve::line(element.node, end) : element.curve;
    }
    static Curve part(const Curve &curve, double t0, double t1) {
        return curve.kind() == CurveKind::Line ? Curve() : curve.part(t0, t1);
    }

    Status cut(Element element, const CutCorner &cutCorner) {
        const bool alone = ahead_.empty() && done_.empty(); // a loop with one node
        Element &before = !ahead_.empty() ? ahead_.back() : alone ? element : done_.front();
        const Vec2 end = !done_.empty() ? done_.back().node : alone ? element.node : ahead_.front().node;
        const Curve first = curveOf(before, element.node), second = curveOf(element, end);
        if (std::fabs(turnAt(first, second)) < kSmooth) {
            done_.push_back(element);
            return all_ ? Status()
                        : error("not-possible", "the node at " + placeText(element.node) + " is smooth, not a corner",
                                "select corners");
        }
        const std::optional<Cut> found = cutCorner(first, second);
        if (!found) {
            return noRoom("the corner at " + placeText(element.node));
        }
        const bool noBefore = found->s <= kCornerRounding, noAfter = found->t >= 1.0 - kCornerRounding;
        const Element joint{noBefore ? first.point(0.0) : first.point(found->s), found->joint, before.tag,
                            element.size};
        before.curve = part(first, 0.0, found->s);
        element.curve = part(second, found->t, alone ? found->s : 1.0);
        element.node = second.point(found->t);
        replace(element, joint, noBefore, noAfter);
        return {};
    }

    /// Puts a joint before a node; both have the size of the corner. A side that is used up is removed with its first
    /// node.
    void replace(const Element &element, Element joint, bool noBefore, bool noAfter) {
        if (!noAfter) {
            done_.push_back(element);
        } else if (Element *const next = !done_.empty()    ? &done_.back()
                                         : !ahead_.empty() ? &ahead_.front() // over the seam of a closed path
                                                           : nullptr) {
            next->size = smaller(next->size, element.size);
        }
        if (noBefore && !ahead_.empty()) {
            joint.size = smaller(joint.size, ahead_.back().size);
            ahead_.back() = joint; // the next corner
            return;
        }
        if (noBefore && !done_.empty()) {
            joint.size = smaller(joint.size, done_.front().size);
            done_.erase(done_.begin());
        }
        done_.push_back(joint);
    }

    bool closed_, all_;
    std::vector<Element> ahead_; ///< nodes not yet seen, in order
    std::vector<Element> done_;  ///< the result so far, from its last node to its first
};

bool isSharpRectangle(const Shape &shape) {
    return shape.is<RectangleForm>() && shape.as<RectangleForm>().radius == 0.0;
}

/// Makes a rectangle a path, if its corners are sharp.
Status openShape(Shape &shape) {
    if (isSharpRectangle(shape)) {
        becomePath(shape);
    }
    if (shape.is<RectangleForm>()) {
        return error("not-possible", displayName(shape) + " already has rounded corners",
                     "set its radius to 0, or convert it to a path");
    }
    if (!isPath(shape)) {
        return error("not-possible", displayName(shape) + " has no corners", "select paths or rectangles");
    }
    return {};
}

/// Rounds the corners of a rectangle, which keeps its kind and its formulas.
Status roundRectangle(Shape &shape, double radius) {
    double &cornerRadius = shape.as<RectangleForm>().radius;
    if (cornerRadius != 0.0) {
        return openShape(shape); // says why not
    }
    const double limit = largestRounding(shape);
    if (radius > (1.0 + kCornerRounding) * limit) {
        return noRoom("a corner of " + displayName(shape));
    }
    cornerRadius = std::min(radius, limit);
    shape.cuts.clear();
    return {};
}

/// Cuts the given corners of a shape; an empty set means all of them.
Status changeShape(Shape &shape, const std::set<std::uint32_t> &chosen, const CutCorner &cutCorner) {
    if (Status status = openShape(shape); !status.empty()) {
        return status;
    }
    const bool all = chosen.empty();
    std::set<std::uint32_t> corners = chosen;
    for (std::uint32_t k = 0; all && k < shape.nodes.size(); ++k) {
        corners.insert(corners.end(), k);
    }
    if (*corners.rbegin() >= shape.nodes.size()) {
        return error("no-such-node", "node not found");
    }
    CornerPass pass(shape, all);
    if (Status status = pass.run(corners, cutCorner); !status.empty()) {
        return status;
    }
    pass.finish(shape);
    return {};
}

Result<Document> changeCorners(const Document &document, const Selection &selection, double size,
                               const ChangeCorners &change) {
    if (!(size > 0.0) || !std::isfinite(size)) {
        return error("bad-number", "invalid corner size " + numberText(size, 6) + "; expected a finite number above 0",
                     "enter a number such as 0.5");
    }
    std::map<std::uint32_t, std::set<std::uint32_t>> nodes;
    for (const NodeRef node : selection.nodes) {
        nodes[node.shape].insert(node.node);
    }
    for (const std::uint32_t id : selection.shapes) {
        nodes[id].clear();
    }
    std::vector<Shape> changed;
    for (const auto &pointer : document.shapes) {
        const auto chosen = nodes.find(pointer->id);
        if (chosen != nodes.end()) {
            changed.push_back(*pointer);
            if (Status status = change(changed.back(), chosen->second); !status.empty()) {
                return status;
            }
        }
    }
    if (changed.size() < nodes.size()) {
        return error("no-such-shape", "shape not found");
    }
    return replaceShapes(document, std::move(changed));
}

} // namespace

Result<Document> filletCorners(const Document &document, const Selection &selection, double radius) {
    const CutCorner cutCorner = [radius](const Curve &before, const Curve &after) {
        return fillet(before, after, radius);
    };
    return changeCorners(document, selection, radius, [&](Shape &shape, const Corners &chosen) {
        const bool all = shape.is<RectangleForm>() && (chosen.empty() || chosen == Corners{0, 1, 2, 3});
        return all ? roundRectangle(shape, radius) : changeShape(shape, chosen, cutCorner);
    });
}

Result<Document> chamferCorners(const Document &document, const Selection &selection, double distance) {
    const CutCorner cutCorner = [distance](const Curve &before, const Curve &after) {
        return chamfer(before, after, distance);
    };
    return changeCorners(document, selection, distance,
                         [&](Shape &shape, const Corners &chosen) { return changeShape(shape, chosen, cutCorner); });
}

bool hasCorners(const Document &document, const Selection &selection) {
    // Takes one pass over the document, since menus call it in every frame.
    return std::any_of(document.shapes.begin(), document.shapes.end(), [&](const auto &shape) {
        const auto node = selection.nodes.lower_bound({shape->id, 0});
        const bool chosen =
            selection.shapes.contains(shape->id) || (node != selection.nodes.end() && node->shape == shape->id);
        return chosen && (isPath(*shape) || isSharpRectangle(*shape));
    });
}

} // namespace forefront
