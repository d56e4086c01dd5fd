#include "core/engine/quads/polygon_fill.hpp"

#include "core/engine/geometry/flat.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace forefront {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kMaxShapeCost = 100.0; ///< of an element, however narrow
constexpr double kFlatCost = 1e7;       ///< of a triangle whose nodes lie on a line within rounding

/// Finds the best fill of each part of a polygon that one diagonal cuts off, the small parts first.
class PolygonFiller {
  public:
    PolygonFiller(std::span<const Vec2> nodes, const FillRules &rules)
        : nodes_(nodes), rules_(rules), count_(nodes.size()), parts_(count_ * count_), joins_(count_ * count_, 0) {}

    std::optional<PolygonFill> fill() {
        if (count_ < 3 || count_ > kMaxFillNodes || !isSimple()) {
            return std::nullopt;
        }
        findDiagonals();
        for (std::size_t length = 2; length < count_; ++length) {
            for (std::size_t i = 0; i + length < count_; ++i) {
                if (joins(i, i + length)) {
                    fillPart(i, i + length);
                }
            }
        }
        if (part(0, count_ - 1).cost == kInfinite) {
            return std::nullopt;
        }
        PolygonFill result;
        collect(0, count_ - 1, result);
        return result;
    }

  private:
    /// The fill of the nodes from `i` to `j`: the element at the side that joins them, and what it leaves.
    struct Part {
        double cost = kInfinite;
        std::size_t a = 0, b = 0; ///< the other corners of the element; the same one for a triangle
    };

    Part &part(std::size_t i, std::size_t j) { return parts_[i * count_ + j]; }
    bool joins(std::size_t i, std::size_t j) const { return joins_[i * count_ + j] != 0; }
    double costOf(std::size_t i, std::size_t j) const { return j == i + 1 ? 0.0 : parts_[i * count_ + j].cost; }
    Vec2 at(std::size_t i) const { return nodes_[i % count_]; }

    bool isSimple() const {
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t j = i + 1; j < count_; ++j) {
                const bool share = j == i + 1 || (i == 0 && j == count_ - 1);
                if (meet(at(i), at(i + 1), at(j), at(j + 1)) !=
                    (share ? SegmentMeeting::SharedEnd : SegmentMeeting::Apart)) {
                    return false;
                }
            }
        }
        const auto lowest = static_cast<std::size_t>(std::min_element(nodes_.begin(), nodes_.end(), comesBefore) -
                                                     nodes_.begin()); // its angle is below 180 degrees
        return orientation(at(lowest + count_ - 1), at(lowest), at(lowest + 1)) > 0;
    }

    /// Returns true if the way from the node `i` to the node `j` begins inside the polygon.
    bool leadsInside(std::size_t i, std::size_t j) const {
        const Vec2 before = at(i + count_ - 1), here = at(i), after = at(i + 1), there = at(j);
        if (orientation(before, here, after) >= 0) {
            return orientation(here, there, before) > 0 && orientation(there, here, after) > 0;
        }
        return orientation(here, there, after) < 0 || orientation(there, here, before) < 0;
    }

    bool isDiagonal(std::size_t i, std::size_t j) const {
        if (!leadsInside(i, j) || !leadsInside(j, i) || rules_.forbids(i, j)) {
            return false;
        }
        for (std::size_t k = 0; k < count_; ++k) {
            const std::size_t next = (k + 1) % count_;
            const bool own = k == i || k == j || next == i || next == j;
            if (meet(at(i), at(j), at(k), at(next)) != (own ? SegmentMeeting::SharedEnd : SegmentMeeting::Apart)) {
                return false;
            }
        }
        return true;
    }

    void findDiagonals() {
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t j = i + 1; j < count_; ++j) {
                const bool side = j == i + 1 || (i == 0 && j == count_ - 1);
                joins_[i * count_ + j] = side || isDiagonal(i, j) ? 1 : 0;
            }
        }
    }

    void fillPart(std::size_t i, std::size_t j) {
        Part best;
        const auto offer = [&](double cost, std::size_t a, std::size_t b) {
            if (cost < best.cost) {
                best = {cost, a, b};
            }
        };
        for (std::size_t a = i + 1; a < j; ++a) {
            if (!joins(i, a)) {
                continue;
            }
            if (joins(a, j)) {
                offer(triangleCost(i, a, j) + costOf(i, a) + costOf(a, j), a, a);
            }
            for (std::size_t b = a + 1; b < j; ++b) {
                const double rest = costOf(i, a) + costOf(a, b) + costOf(b, j);
                if (joins(a, b) && joins(b, j) && rest < best.cost) {
                    offer(rest + quadCost(i, a, b, j), a, b);
                }
            }
        }
        part(i, j) = best;
    }

    static double shapeCost(double shape) {
        return shape > 0.0 ? std::min(1.0 / shape - 1.0, kMaxShapeCost) : kMaxShapeCost;
    }

    double triangleCost(std::size_t i, std::size_t a, std::size_t j) const {
        const std::array corners{at(i), at(a), at(j)};
        if (orientation(corners[0], corners[1], corners[2]) <= 0) {
            return kInfinite;
        }
        return rules_.triangleCost + shapeCost(scaledJacobian({0, 1, 2, kNoIndex}, corners)) +
               (isFlat(corners[0], corners[1], corners[2]) ? kFlatCost : 0.0);
    }

    double quadCost(std::size_t i, std::size_t a, std::size_t b, std::size_t j) const {
        const std::array corners{at(i), at(a), at(b), at(j)};
        return isClearlyConvex({0, 1, 2, 3}, corners) ? shapeCost(scaledJacobian({0, 1, 2, 3}, corners)) : kInfinite;
    }

    void collect(std::size_t i, std::size_t j, PolygonFill &result) {
        if (j == i + 1) {
            return;
        }
        const auto [cost, a, b] = part(i, j);
        const auto number = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
        const QuadCell cell = {number(i), number(a), number(a == b ? j : b), a == b ? kNoIndex : number(j)};
        result.cells.push_back(cell);
        result.triangles += a == b ? 1U : 0U;
        result.leastShape = std::min(result.leastShape, scaledJacobian(cell, nodes_));
        collect(i, a, result);
        collect(a, b == a ? a + 1 : b, result);
        collect(b, j, result);
    }

    std::span<const Vec2> nodes_;
    const FillRules &rules_;
    std::size_t count_;
    std::vector<Part> parts_;         ///< per pair of nodes
    std::vector<std::uint8_t> joins_; ///< per pair of nodes: a side or a diagonal inside joins them
};

} // namespace

bool isClearlyConvex(const QuadCell &cell, std::span<const Vec2> nodes) {
    constexpr double kMinSine = 1e-9;
    const unsigned n = cornersOf(cell);
    for (unsigned k = 0; k < n; ++k) {
        const Vec2 before = nodes[previousCorner(cell, k)], at = nodes[cell[k]], after = nodes[nextCorner(cell, k)];
        const double area = cross(after - at, before - at);
        if (isFlat(before, at, after) ||
            (n == 4 && area < kMinSine * std::sqrt(lengthSquared(after - at) * lengthSquared(before - at)))) {
            return false;
        }
    }
    return true;
}

std::optional<PolygonFill> fillPolygon(std::span<const Vec2> nodes, const FillRules &rules) {
    return PolygonFiller(nodes, rules).fill();
}

} // namespace forefront
