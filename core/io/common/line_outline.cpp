#include "core/io/common/line_outline.hpp"

#include "core/base/ids.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace forefront {

namespace {

/// The segments of a domain as a graph: pieces of it that lie on loops, and the side of each that faces outwards.
class LineGraph {
  public:
    explicit LineGraph(Domain &domain) : domain_(domain), degree_(domain.nodes.size(), 0), starts_(1, 0) {
        const std::vector<DomainSegment> &segments = domain.segments;
        for (const DomainSegment &segment : segments) {
            ++degree_[segment.a];
            ++degree_[segment.b];
        }
        starts_.resize(degree_.size() + 1);
        std::partial_sum(degree_.begin(), degree_.end(), starts_.begin() + 1);
        around_.resize(starts_.back());
        std::vector<std::uint32_t> filled(starts_.begin(), starts_.end() - 1);
        for (std::uint32_t s = 0; s < segments.size(); ++s) {
            around_[filled[segments[s].a]++] = s;
            around_[filled[segments[s].b]++] = s;
        }
        dropped_.assign(segments.size(), false);
    }

    std::size_t run() {
        dropOpenChains();
        std::size_t count = 0;
        std::vector<bool> seen(degree_.size(), false);
        for (std::uint32_t start = 0; start < degree_.size(); ++start) {
            if (degree_[start] > 0 && !seen[start]) {
                count += bound(component(start, seen));
            }
        }
        return count;
    }

  private:
    /// Removes chains with a free end, segment by segment.
    void dropOpenChains() {
        for (std::uint32_t start = 0; start < degree_.size(); ++start) {
            for (std::uint32_t node = start; degree_[node] == 1;) {
                std::uint32_t k = starts_[node];
                while (dropped_[around_[k]]) {
                    ++k;
                }
                const std::uint32_t s = around_[k];
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

    std::size_t bound(const std::vector<std::uint32_t> &nodes) {
        const bool loops = std::all_of(nodes.begin(), nodes.end(), [&](auto node) { return degree_[node] % 2 == 0; });
        std::vector<std::uint32_t> outline;
        if (loops) {
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
        for (const std::uint32_t s : outline) {
            domain_.segments[s].role = SegmentRole::Boundary;
        }
        return outline.size();
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
        for (std::uint32_t k = starts_[node]; k < starts_[node + 1]; ++k) {
            if (!dropped_[around_[k]]) {
                visit(around_[k]);
            }
        }
    }
    std::uint32_t other(std::uint32_t s, std::uint32_t node) const {
        const DomainSegment &segment = domain_.segments[s];
        return segment.a == node ? segment.b : segment.a;
    }

    Domain &domain_;
    std::vector<std::uint32_t> degree_; ///< per node, without dropped segments
    std::vector<std::uint32_t> starts_; ///< per node, into around_
    std::vector<std::uint32_t> around_; ///< segments by node
    std::vector<bool> dropped_;
};

} // namespace

std::size_t takeLinesAsOutline(Domain &domain) {
    const bool bounded = std::any_of(domain.segments.begin(), domain.segments.end(),
                                     [](const DomainSegment &s) { return s.role == SegmentRole::Boundary; });
    const auto sound = [&](const DomainSegment &s) {
        return s.a < domain.nodes.size() && s.b < domain.nodes.size() && s.a != s.b;
    };
    if (bounded || !std::all_of(domain.segments.begin(), domain.segments.end(), sound)) {
        return 0;
    }
    return LineGraph(domain).run();
}

} // namespace forefront
