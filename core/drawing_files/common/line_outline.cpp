#include "core/drawing_files/common/line_outline.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/base/rows.hpp"
#include "core/engine/domain/free_ends.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Decides whether places are inside the boundary of a domain, by the even-odd rule.
class BoundaryInside {
  public:
    explicit BoundaryInside(const Domain &domain) : BoundaryInside(sidesOf(domain)) {}

    bool contains(Vec2 p) const {
        bool inside = false;
        tree_.query({p, {std::numeric_limits<double>::infinity(), p.y}}, [&](std::uint32_t k) {
            const auto [a, b] = ends_[k];
            const bool upward = a.y <= p.y && b.y > p.y, downward = b.y <= p.y && a.y > p.y;
            if ((upward || downward) && (orientation(a, b, p) > 0) == upward) { // the ray to the right meets it
                inside = !inside;
            }
        });
        return inside;
    }

    /// Returns true if a part of the boundary lies within a loop of segments that the boundary neither touches nor
    /// crosses.
    bool entersLoop(const Domain &domain, const std::vector<std::uint32_t> &loop) const {
        Box2 box;
        std::vector<std::pair<Vec2, Vec2>> sides;
        for (const std::uint32_t s : loop) {
            sides.push_back({domain.nodes[domain.segments[s].a], domain.nodes[domain.segments[s].b]});
            box.add(boxOf(sides.back().first, sides.back().second));
        }
        bool enters = false;
        const BoundaryInside inside(std::move(sides));
        tree_.search(box, [&](std::uint32_t k) {
            enters = inside.contains(ends_[k].first);
            return !enters;
        });
        return enters;
    }

  private:
    explicit BoundaryInside(std::vector<std::pair<Vec2, Vec2>> ends) : ends_(std::move(ends)) {
        std::vector<Box2> boxes;
        std::transform(ends_.begin(), ends_.end(), std::back_inserter(boxes),
                       [](const auto &side) { return boxOf(side.first, side.second); });
        tree_ = BoxTree(boxes);
    }

    /// Returns the ends of the boundary segments.
    static std::vector<std::pair<Vec2, Vec2>> sidesOf(const Domain &domain) {
        std::vector<std::pair<Vec2, Vec2>> sides;
        for (const DomainSegment &segment : domain.segments) {
            if (segment.role == SegmentRole::Boundary) {
                sides.push_back({domain.nodes[segment.a], domain.nodes[segment.b]});
            }
        }
        return sides;
    }

    std::vector<std::pair<Vec2, Vec2>> ends_; ///< of segments of the boundary
    BoxTree tree_;
};

/// The lines of a domain as a graph: pieces of it that lie on loops, and the side of each that faces outwards.
class LineGraph {
  public:
    explicit LineGraph(Domain &domain)
        : domain_(domain), boundary_(domain), degree_(domain.nodes.size(), 0), touching_(domain.nodes.size(), false) {
        const std::vector<DomainSegment> &segments = domain.segments;
        dropped_.assign(segments.size(), false);
        for (std::uint32_t s = 0; s < segments.size(); ++s) {
            if (segments[s].role == SegmentRole::Boundary) {
                dropped_[s] = true;
                bounded_ = true;
                touching_[segments[s].a] = touching_[segments[s].b] = true;
            } else {
                ++degree_[segments[s].a];
                ++degree_[segments[s].b];
            }
        }
        given_ = degree_;
        around_ = Rows<std::uint32_t>(degree_.size(), [&](const auto &add) {
            for (std::uint32_t s = 0; s < segments.size(); ++s) {
                if (!dropped_[s]) {
                    add(segments[s].a, s);
                    add(segments[s].b, s);
                }
            }
        });
    }

    LineLoops run() {
        dropOpenChains();
        LineLoops loops;
        std::vector<bool> seen(degree_.size(), false);
        for (std::uint32_t start = 0; start < degree_.size(); ++start) {
            if (degree_[start] > 0 && !seen[start]) {
                bound(component(start, seen), loops);
            }
        }
        return loops;
    }

  private:
    /// Removes chains with a free end, segment by segment.
    void dropOpenChains() {
        for (std::uint32_t start = 0; start < degree_.size(); ++start) {
            for (std::uint32_t node = start; degree_[node] == 1;) {
                const std::span<const std::uint32_t> here = around_[node];
                const std::uint32_t s =
                    *std::find_if(here.begin(), here.end(), [this](std::uint32_t line) { return !dropped_[line]; });
                dropped_[s] = true;
                --degree_[node];
                node = other(s, node);
                --degree_[node];
            }
        }
    }

    std::vector<std::uint32_t> component(std::uint32_t start, std::vector<bool> &seen) const {
        std::vector<std::uint32_t> nodes{start};
        seen[start] = true;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            forEach(nodes[k], [&](std::uint32_t s) {
                const std::uint32_t next = other(s, nodes[k]);
                if (!seen[next]) {
                    seen[next] = true;
                    nodes.push_back(next);
                }
            });
        }
        return nodes;
    }

    void bound(const std::vector<std::uint32_t> &nodes, LineLoops &loops) {
        const bool even = std::all_of(nodes.begin(), nodes.end(), [&](auto node) { return degree_[node] % 2 == 0; });
        std::vector<std::uint32_t> outline;
        if (even) {
            for (const std::uint32_t node : nodes) {
                forEach(node, [&](std::uint32_t s) {
                    if (domain_.segments[s].a == node) {
                        outline.push_back(s);
                    }
                });
            }
        } else {
            outline = outerSegments(nodes);
        }
        if (outline.empty()) {
            return;
        }
        if (bounded_ && !isAlone(nodes) && !isAround(nodes, outline)) {
            if (loops.left++ == 0) {
                loops.firstLeft = outline.front();
            }
            return;
        }
        for (const std::uint32_t s : outline) {
            domain_.segments[s].role = SegmentRole::Boundary;
        }
        loops.segments += outline.size();
    }

    /// Returns true for a loop that touches and crosses nothing.
    bool isAlone(const std::vector<std::uint32_t> &nodes) const {
        return std::all_of(nodes.begin(), nodes.end(), [&](auto n) { return given_[n] == 2 && !touching_[n]; });
    }

    /// Returns true for lines around an outline that touch none. Lines cross in a node of four: centre lines, grids and
    /// dimension lines do so, outlines do not.
    bool isAround(const std::vector<std::uint32_t> &nodes, const std::vector<std::uint32_t> &outline) const {
        const auto apart = [&](std::uint32_t s) {
            return given_[domain_.segments[s].a] <= 3 && given_[domain_.segments[s].b] <= 3 &&
                   !boundary_.contains(middleOf(s));
        };
        return std::none_of(nodes.begin(), nodes.end(), [&](auto n) { return touching_[n]; }) &&
               std::all_of(outline.begin(), outline.end(), apart) && boundary_.entersLoop(domain_, outline);
    }

    /// Walks around the component with the outside on the left. A segment passed on both sides encloses nothing.
    std::vector<std::uint32_t> outerSegments(const std::vector<std::uint32_t> &nodes) const {
        const std::uint32_t first = *std::min_element(nodes.begin(), nodes.end(), [&](auto m, auto n) {
            return comesBefore(domain_.nodes[m], domain_.nodes[n]);
        });
        const std::uint32_t start = nextAround(first, {-1.0, 0.0}, kNoIndex);
        std::vector<std::uint32_t> passed;
        std::uint32_t node = first, s = start;
        do {
            passed.push_back(s);
            const std::uint32_t next = other(s, node);
            s = nextAround(next, domain_.nodes[node] - domain_.nodes[next], s);
            node = next;
        } while ((node != first || s != start) && passed.size() <= 2 * domain_.segments.size());
        std::sort(passed.begin(), passed.end());
        std::vector<std::uint32_t> once;
        for (std::size_t k = 0; k < passed.size();) {
            const auto end = std::upper_bound(passed.begin(), passed.end(), passed[k]);
            if (end - (passed.begin() + static_cast<std::ptrdiff_t>(k)) == 1) {
                once.push_back(passed[k]);
            }
            k = static_cast<std::size_t>(end - passed.begin());
        }
        return once;
    }

    /// Returns the segment at a node that follows `from` clockwise; `back`, which lies along `from`, comes last.
    std::uint32_t nextAround(std::uint32_t node, Vec2 from, std::uint32_t back) const {
        std::uint32_t best = back;
        double bestTurn = 7.0;
        forEach(node, [&](std::uint32_t s) {
            const Vec2 along = domain_.nodes[other(s, node)] - domain_.nodes[node];
            double turn = std::atan2(cross(along, from), dot(along, from)); // clockwise from `from`
            turn += turn > 0.0 ? 0.0 : 6.283185307179586;
            if (s != back && turn < bestTurn) {
                bestTurn = turn;
                best = s;
            }
        });
        return best;
    }

    template <class Visit>
    void forEach(std::uint32_t node, Visit visit) const {
        for (const std::uint32_t line : around_[node]) {
            if (!dropped_[line]) {
                visit(line);
            }
        }
    }
    Vec2 middleOf(std::uint32_t s) const {
        return midpoint(domain_.nodes[domain_.segments[s].a], domain_.nodes[domain_.segments[s].b]);
    }
    std::uint32_t other(std::uint32_t s, std::uint32_t node) const {
        const DomainSegment &segment = domain_.segments[s];
        return segment.a == node ? segment.b : segment.a;
    }

    Domain &domain_;
    BoundaryInside boundary_;           ///< as it was given
    bool bounded_ = false;              ///< there is a boundary
    std::vector<std::uint32_t> degree_; ///< per node, without dropped segments
    std::vector<std::uint32_t> given_;  ///< per node: number of lines, with dropped ones
    std::vector<bool> touching_;        ///< per node: the boundary passes through it
    Rows<std::uint32_t> around_;        ///< lines by node
    std::vector<bool> dropped_;         ///< segments of the boundary, and lines with a free end
};

} // namespace

LineLoops takeLinesAsOutline(Domain &domain) {
    const auto sound = [&](const DomainSegment &s) {
        return s.a < domain.nodes.size() && s.b < domain.nodes.size() && s.a != s.b;
    };
    if (!std::all_of(domain.segments.begin(), domain.segments.end(), sound)) {
        return {};
    }
    return LineGraph(domain).run();
}

LineGaps findLineGaps(const Domain &domain, double limit) {
    std::vector<std::uint32_t> count(domain.nodes.size(), 0), segmentOf(domain.nodes.size(), kNoIndex);
    for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
        for (const std::uint32_t node : {domain.segments[s].a, domain.segments[s].b}) {
            ++count[node];
            segmentOf[node] = s;
        }
    }
    std::vector<Vec2> places;
    std::vector<std::uint32_t> segments;
    for (std::uint32_t n = 0; n < domain.nodes.size(); ++n) {
        if (count[n] == 1) {
            places.push_back(domain.nodes[n]);
            segments.push_back(segmentOf[n]);
        }
    }
    LineGaps gaps;
    const FreeEnds ends(places);
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (const double gap = ends.gap(k); gap <= limit) {
            ++gaps.count;
            gaps.ends.push_back({places[k], gap, segments[k]});
            gaps.widest = std::max(gaps.widest, gap);
        }
    }
    return gaps;
}

} // namespace forefront
