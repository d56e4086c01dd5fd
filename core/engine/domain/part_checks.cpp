#include "core/engine/domain/part_checks.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/coordinate_range.hpp"

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

class PartChecker {
  public:
    PartChecker(const Domain &domain, DomainFaultList &faults) : domain_(domain), faults_(faults) {}

    bool run() {
        checkNodes();
        checkMagnitude();
        checkSegments();
        checkPointsAndMarkers();
        checkReferences();
        return !incomplete_;
    }

  private:
    void add(const char *code, std::string message, std::string advice, std::optional<Vec2> at,
             std::initializer_list<DomainPart> parts = {}) {
        faults_.add(code, std::move(message), std::move(advice), at, parts);
    }

    void checkNodes() {
        for (std::uint32_t n = 0; n < domain_.nodes.size(); ++n) {
            if (!isFinite(domain_.nodes[n])) {
                incomplete_ = true;
                add("non-finite", "a node has a coordinate that is not a finite number", "correct its coordinates",
                    finitePart(domain_.nodes[n]), {aNode(n)});
            }
        }
    }
    /// Squares of lengths and products of areas must neither overflow nor underflow.
    void checkMagnitude() {
        const Box2 box = domain_.bounds();
        for (std::uint32_t n = 0; n < domain_.nodes.size(); ++n) {
            const Vec2 p = domain_.nodes[n];
            if (isFinite(p) && tooLarge(p)) {
                incomplete_ = true;
                add("out-of-range", "a node has a coordinate beyond 1e60 in magnitude", "scale the domain down", p,
                    {aNode(n)});
            }
        }
        if (tooSmall(box)) {
            add("out-of-range", "the domain is smaller than 1e-60; expected at least 1e-60", "scale the domain up",
                box.min);
        } else if (tooFarAway(box)) {
            add("out-of-range", "the domain is too far from the origin; its coordinates keep fewer than 4 digits",
                "move it closer to the origin", box.min);
        }
    }

    /// Returns a place that the view can zoom to: coordinates that are not finite become 0.
    static Vec2 finitePart(Vec2 p) { return {std::isfinite(p.x) ? p.x : 0.0, std::isfinite(p.y) ? p.y : 0.0}; }

    void checkSegments() {
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            const DomainSegment &segment = domain_.segments[s];
            const std::size_t nodeCount = domain_.nodes.size();
            if (segment.a >= nodeCount || segment.b >= nodeCount) {
                incomplete_ = true;
                const std::uint32_t bad = segment.a >= nodeCount ? segment.a : segment.b;
                const std::uint32_t good = segment.a >= nodeCount ? segment.b : segment.a;
                add("bad-index",
                    "a segment refers to node " + std::to_string(bad) + "; expected an index below " +
                        std::to_string(nodeCount),
                    "correct the node's index", good < nodeCount ? domain_.nodes[good] : domain_.bounds().min,
                    {aSegment(s)});
                continue;
            }
            checkCurve(s);
            const Vec2 a = domain_.nodes[segment.a], b = domain_.nodes[segment.b];
            checkTag("a segment", aSegment(s), segment.tag, midpoint(a, b));
            if (a == b) {
                add("zero-length", "a segment has zero length", "remove it, or repair the domain", a, {aSegment(s)});
            }
        }
    }

    static constexpr double kMaxTurns = 1.0 + 1e-9; // for rounding

    /// Returns the full turns of an arc; 0 for other curves.
    static double turnsOf(const Curve &curve) {
        return curve.kind() == CurveKind::Arc ? std::fabs(curve.numbers()[7]) / (2.0 * std::numbers::pi) : 0.0;
    }

    /// The nodes at the ends decide where a segment is; how far they are from its curve is not a fault.
    void checkCurve(std::uint32_t s) {
        const CurveStretch &stretch = domain_.segments[s].stretch;
        if (!stretch.follows()) {
            return;
        }
        const Vec2 at = domain_.nodes[domain_.segments[s].a];
        const auto inRange = [](double t) { return t >= 0.0 && t <= 1.0; };
        if (stretch.curve >= domain_.curves.size()) {
            add("bad-index",
                "a segment refers to curve " + std::to_string(stretch.curve) + "; expected an index below " +
                    std::to_string(domain_.curves.size()),
                "correct the curve's index, or make the segment straight", at, {aSegment(s)});
        } else if (!domain_.curves[stretch.curve].finite()) {
            add("non-finite", "a segment follows a curve with a number that is not finite", "correct the curve", at,
                {aSegment(s)});
        } else if (turnsOf(domain_.curves[stretch.curve]) > kMaxTurns) {
            add("bad-curve",
                "a segment follows an arc of " + numberText(turnsOf(domain_.curves[stretch.curve]), 6) +
                    " turns; expected at most one",
                "shorten the arc to one turn", at, {aSegment(s)});
        } else if (!inRange(stretch.t0) || !inRange(stretch.t1)) {
            add("bad-parameter",
                "a segment follows its curve from " + numberText(stretch.t0, 6) + " to " + numberText(stretch.t1, 6) +
                    "; expected parameters between 0 and 1",
                "correct the parameters, or make the segment straight", at, {aSegment(s)});
        }
    }

    void checkTag(const char *what, const DomainPart &part, std::int32_t tag, Vec2 at) {
        if (tag < 1) {
            add("bad-tag", std::string(what) + " has the tag " + std::to_string(tag) + "; expected at least 1",
                "give it a tag of 1 or more", at, {part});
        }
    }

    void checkPointsAndMarkers() {
        for (std::uint32_t i = 0; i < domain_.points.size(); ++i) {
            const ConstraintPoint &point = domain_.points[i];
            const DomainPart part{DomainPartKind::ConstraintPoint, i};
            if (point.node >= domain_.nodes.size()) {
                add("bad-index",
                    "an inner point refers to node " + std::to_string(point.node) + "; expected an index below " +
                        std::to_string(domain_.nodes.size()),
                    "correct the node's index", domain_.bounds().min, {part});
            } else {
                checkTag("an inner point", part, point.tag, domain_.nodes[point.node]);
            }
        }
        for (std::uint32_t i = 0; i < domain_.holeMarkers.size(); ++i) {
            checkMarker("a hole marker", {DomainPartKind::HoleMarker, i}, domain_.holeMarkers[i]);
        }
        for (std::uint32_t i = 0; i < domain_.regionMarkers.size(); ++i) {
            const DomainPart part{DomainPartKind::RegionMarker, i};
            checkMarker("a region marker", part, domain_.regionMarkers[i].at);
            checkTag("a region marker", part, domain_.regionMarkers[i].tag, domain_.regionMarkers[i].at);
        }
    }
    void checkMarker(const char *what, const DomainPart &part, Vec2 at) {
        if (!isFinite(at)) {
            add("non-finite", std::string(what) + " has a coordinate that is not a finite number",
                "correct its coordinates", finitePart(at), {part});
        }
    }

    void checkReferences() {
        std::vector<std::uint8_t> used(domain_.nodes.size(), 0);
        const auto use = [&](std::uint32_t node) {
            if (node < used.size()) {
                used[node] = 1;
            }
        };
        for (const DomainSegment &segment : domain_.segments) {
            use(segment.a);
            use(segment.b);
        }
        for (const ConstraintPoint &point : domain_.points) {
            use(point.node);
        }
        for (std::uint32_t n = 0; n < used.size(); ++n) {
            if (used[n] == 0 && isFinite(domain_.nodes[n])) {
                add("unreferenced-node", "a node belongs to no segment and is not an inner point",
                    "remove it, make it an inner point, or repair the domain", domain_.nodes[n], {aNode(n)});
            }
        }
    }

    const Domain &domain_;
    DomainFaultList &faults_;
    bool incomplete_ = false; ///< a segment is missing from the geometry because it is faulty
};

} // namespace

bool checkParts(const Domain &domain, DomainFaultList &faults) {
    return PartChecker(domain, faults).run();
}

} // namespace forefront
