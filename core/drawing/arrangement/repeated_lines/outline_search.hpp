#pragma once

#include "core/drawing/arrangement/repeated_lines/beside_outlines.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace forefront {

/// The edges with the curves that they follow.
class EdgeShapes {
  public:
    EdgeShapes(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges, std::span<const BesideEdge> about,
               std::span<const Curve> curves)
        : nodes_(nodes), edges_(edges), about_(about), curves_(curves) {}

    Vec2 a(std::uint32_t edge) const { return nodes_[edges_[edge].a]; }
    Vec2 b(std::uint32_t edge) const { return nodes_[edges_[edge].b]; }

    /// Returns the point at a fraction of the way along an edge from one of its ends. Rounding depends on the direction
    /// of travel, not on the orientation of the edge.
    Vec2 at(std::uint32_t edge, double fraction, bool fromA = true) const {
        if (!follows(edge) || fraction == 0.0 || fraction == 1.0) {
            const Vec2 from = fromA ? a(edge) : b(edge), to = fromA ? b(edge) : a(edge);
            return fraction == 1.0 ? to : lerp(from, to, fraction);
        }
        const CurveStretch &stretch = about_[edge].stretch;
        return curves_[stretch.curve].point(
            std::lerp(fromA ? stretch.t0 : stretch.t1, fromA ? stretch.t1 : stretch.t0, fraction));
    }
    /// Returns the place on an edge nearest to p.
    Vec2 nearest(std::uint32_t edge, Vec2 p) const {
        if (!follows(edge)) {
            const Vec2 from = a(edge), along = b(edge) - from;
            return from + std::clamp(dot(p - from, along) / lengthSquared(along), 0.0, 1.0) * along;
        }
        const CurveStretch &stretch = about_[edge].stretch;
        const Curve &curve = curves_[stretch.curve];
        return curve.point(curve.nearest(p, std::min(stretch.t0, stretch.t1), std::max(stretch.t0, stretch.t1)));
    }
    /// Returns the maximum distance of an edge from its curve.
    double deviation(std::uint32_t edge) const {
        const CurveStretch &stretch = about_[edge].stretch;
        return follows(edge) ? curves_[stretch.curve].deviation(stretch.t0, stretch.t1) : 0.0;
    }

  private:
    bool follows(std::uint32_t edge) const { return about_[edge].stretch.curve < curves_.size(); }

    std::span<const Vec2> nodes_;
    std::span<const PlaneEdge> edges_;
    std::span<const BesideEdge> about_;
    std::span<const Curve> curves_;
};

/// Finds the outlines near segments and points.
class OutlineSearch {
  public:
    OutlineSearch(const EdgeShapes &shapes, std::span<const BesideEdge> about) : shapes_(shapes) {
        std::vector<Box2> boxes;
        for (std::uint32_t e = 0; e < about.size(); ++e) {
            if (about[e].role == BesideRole::Outline) {
                edges_.push_back(e);
                deviations_.push_back(shapes.deviation(e));
                boxes.push_back(boxOf(shapes.a(e), shapes.b(e)));
                maxDeviation_ = std::max(maxDeviation_, deviations_.back());
            }
        }
        tree_ = BoxTree(boxes);
    }

    /// Returns true if all points of the segment are within `reach` (positive) of the chords of outlines, apart from
    /// the deviation of these.
    bool accompanies(Vec2 p, Vec2 q, double reach) const {
        const Vec2 middle = midpoint(p, q);
        for (const Vec2 place : {q, p, middle}) { // at corners, several outlines are equally near
            const std::uint32_t nearest = nearestTo(place, reach);
            if (nearest == kNoIndex) {
                return false;
            }
            // The distance from a segment is a convex function: it is greatest at an end.
            if (std::max(distanceTo(nearest, p), distanceTo(nearest, q)) <= reach + deviations_[nearest]) {
                return true;
            }
        }
        return distance(p, q) >= kShortest * reach && middle != p && middle != q && accompanies(q, middle, reach) &&
               accompanies(p, middle, reach);
    }

    /// Returns the place on outlines near a point, whose chord must be within `reach` apart from its deviation.
    std::optional<Vec2> placeNear(Vec2 p, double reach) const {
        const std::uint32_t nearest = nearestTo(p, reach);
        return nearest == kNoIndex ? std::nullopt : std::optional(shapes_.nearest(edges_[nearest], p));
    }

    /// Returns the place on outlines where a line near a point may begin: a node if there is one about as near as the
    /// outline, since a short edge between them would need tiny elements.
    std::optional<Vec2> anchorNear(Vec2 p, double reach) const {
        const std::uint32_t nearest = nearestTo(p, reach);
        if (nearest == kNoIndex) {
            return std::nullopt;
        }
        const Vec2 place = shapes_.nearest(edges_[nearest], p);
        const Vec2 a = shapes_.a(edges_[nearest]), b = shapes_.b(edges_[nearest]);
        const Vec2 node = distance(a, p) < distance(b, p) ? a : b;
        return distance(node, p) <= std::min(kNode * distance(place, p), reach) ? node : place;
    }

  private:
    static constexpr double kNode = 2.0; ///< distance of a node from which the outline counts as nearer
    /// Fraction of the reach. Shorter parts that no single outline accompanies are too far away.
    static constexpr double kShortest = 1.0 / 16.0;

    std::uint32_t nearestTo(Vec2 p, double reach) const {
        double limit = reach + maxDeviation_;
        return tree_.nearest(p, limit, [&](std::uint32_t outline) { return distanceTo(outline, p); });
    }
    double distanceTo(std::uint32_t outline, Vec2 p) const {
        return distanceToSegment(shapes_.a(edges_[outline]), shapes_.b(edges_[outline]), p);
    }

    const EdgeShapes &shapes_;
    std::vector<std::uint32_t> edges_; // the outlines
    std::vector<double> deviations_;   // likewise
    double maxDeviation_ = 0.0;
    BoxTree tree_;
};

} // namespace forefront
