#include "core/engine/boundary/clearly_apart.hpp"

#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace forefront {
namespace {

/// Distances that count as clear, as a fraction of the largest coordinate: hundreds of units in its last place, of
/// which rounding takes a few.
constexpr double kClear = 1e-13;
constexpr std::size_t kPairsPerSegment = 16; ///< beyond which the exact check is faster

class ApartChecker {
  public:
    ApartChecker(const Domain &domain, const DiscreteDomain &discrete) : domain_(domain), discrete_(discrete) {
        double largest = 0.0;
        for (const Vec2 node : domain.nodes) {
            largest = std::max({largest, std::fabs(node.x), std::fabs(node.y)});
        }
        clear_ = kClear * largest;
    }

    bool run() {
        if (!takeCuts()) {
            return false;
        }
        std::vector<Box2> boxes;
        boxes.reserve(divided_.size());
        for (const std::uint32_t segment : divided_) {
            boxes.push_back(boxOf(segment));
        }
        const BoxTree tree(boxes);
        std::size_t left = kPairsPerSegment * domain_.segments.size();
        if (!tree.joinSelf(clear_, [&](std::uint32_t i, std::uint32_t j) {
                return left-- > 0 && areApart(divided_[i], divided_[j]);
            })) {
            return false;
        }
        for (std::uint32_t other = 0; other < domain_.segments.size(); ++other) {
            if (!isDivided(other) && !tree.search(boxOf(other).grown(clear_), [&](std::uint32_t i) {
                    return left-- > 0 && areApart(divided_[i], other);
                })) {
                return false;
            }
        }
        return std::all_of(domain_.points.begin(), domain_.points.end(), [&](const ConstraintPoint &point) {
            return tree.search(boxAround(domain_.nodes[point.node], clear_),
                               [&](std::uint32_t i) { return left-- > 0 && isClear(point.node, divided_[i]); });
        });
    }

  private:
    /// The nodes of a divided segment that are nearest to its ends.
    struct Cuts {
        std::uint32_t nearA = kNoIndex, nearB = kNoIndex;
    };

    /// Finds the divided segments and their cuts. Returns false if two nodes of one segment are too close.
    bool takeCuts() {
        cuts_.resize(domain_.segments.size());
        for (const DiscreteSegment &piece : discrete_.segments) {
            const DomainSegment &whole = domain_.segments[piece.source];
            if (piece.a == whole.a && piece.b == whole.b) {
                continue;
            }
            if (!(distance(discrete_.nodes[piece.a], discrete_.nodes[piece.b]) > clear_)) {
                return false;
            }
            Cuts &cuts = cuts_[piece.source];
            if (piece.a == whole.a) {
                divided_.push_back(piece.source);
                cuts.nearA = piece.b;
            }
            cuts.nearB = piece.b == whole.b ? piece.a : cuts.nearB;
        }
        return true;
    }

    bool isDivided(std::uint32_t segment) const { return cuts_[segment].nearA != kNoIndex; }
    Box2 boxOf(std::uint32_t segment) const {
        return forefront::boxOf(domain_.nodes[domain_.segments[segment].a], domain_.nodes[domain_.segments[segment].b]);
    }
    bool isClear(Vec2 p, std::uint32_t segment) const {
        const DomainSegment &ends = domain_.segments[segment];
        return distanceToSegment(domain_.nodes[ends.a], domain_.nodes[ends.b], p) > clear_;
    }
    /// Returns true if a node is an end of a segment, or clear of it.
    bool isClear(std::uint32_t node, std::uint32_t segment) const {
        const DomainSegment &ends = domain_.segments[segment];
        return node == ends.a || node == ends.b || isClear(domain_.nodes[node], segment);
    }

    /// Returns true if the pieces of two segments meet at most at an end that the segments share.
    bool areApart(std::uint32_t first, std::uint32_t second) const {
        const DomainSegment &mine = domain_.segments[first], &other = domain_.segments[second];
        for (const std::uint32_t node : {mine.a, mine.b}) {
            if (node == other.a || node == other.b) {
                return leaves(first, node, second) && leaves(second, node, first);
            }
        }
        // The segments do not cross, so an end of one of them is nearest to the other.
        return isClear(mine.a, second) && isClear(mine.b, second) && isClear(other.a, first) && isClear(other.b, first);
    }

    /// Returns true if a segment is clear of another from its first cut after their common node on, or, if it is not
    /// divided, at its other end.
    bool leaves(std::uint32_t segment, std::uint32_t common, std::uint32_t other) const {
        const DomainSegment &ends = domain_.segments[segment];
        const bool fromA = ends.a == common;
        if (!isDivided(segment)) {
            return isClear(domain_.nodes[fromA ? ends.b : ends.a], other);
        }
        return isClear(discrete_.nodes[fromA ? cuts_[segment].nearA : cuts_[segment].nearB], other);
    }

    const Domain &domain_;
    const DiscreteDomain &discrete_;
    double clear_ = 0.0;
    std::vector<Cuts> cuts_; ///< per segment
    std::vector<std::uint32_t> divided_;
};

} // namespace

bool areClearlyApart(const Domain &domain, const DiscreteDomain &discrete) {
    return ApartChecker(domain, discrete).run();
}

} // namespace forefront
