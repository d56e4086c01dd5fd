#include "core/engine/quads/even_boundary.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/boundary/changed_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace forefront {

namespace {

/// Disjoint sets of nodes with the parity of the path from each node to the root of its set.
class ParitySets {
  public:
    explicit ParitySets(std::size_t count) : parent_(count), parity_(count, 0), rank_(count, 0) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    struct Root {
        std::uint32_t node;
        std::uint8_t parity; ///< of the path from the node to it
    };
    Root find(std::uint32_t node) const {
        std::uint8_t parity = 0;
        while (parent_[node] != node) {
            parity ^= parity_[node];
            node = parent_[node];
        }
        return {node, parity};
    }
    /// Gives the ends of an edge different colours. Returns false if they have the same one already.
    bool join(std::uint32_t a, std::uint32_t b) {
        Root p = find(a), q = find(b);
        if (p.node == q.node) {
            return p.parity != q.parity;
        }
        if (rank_[p.node] < rank_[q.node]) {
            std::swap(p, q);
        }
        parent_[q.node] = p.node;
        parity_[q.node] = static_cast<std::uint8_t>(p.parity ^ q.parity ^ 1U);
        rank_[p.node] = static_cast<std::uint8_t>(rank_[p.node] + (rank_[p.node] == rank_[q.node] ? 1 : 0));
        return true;
    }

  private:
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint8_t> parity_, rank_;
};

bool mayDivide(const DiscreteSegment &segment, const EvenRules &rules) {
    return rules.divide && rules.elements[segment.source] == 0;
}

/// Returns the segments that close odd cycles, and colours the nodes.
std::vector<std::uint32_t> colour(const DiscreteDomain &domain, const SpacingField &spacing, const EvenRules &rules,
                                  std::vector<std::uint8_t> &colours) {
    const std::size_t count = domain.segments.size();
    std::vector<std::pair<bool, double>> key(count); // those that stay come first, so that others close the cycles
    for (std::size_t s = 0; s < count; ++s) {
        const Vec2 a = domain.nodes[domain.segments[s].a], b = domain.nodes[domain.segments[s].b];
        key[s] = {mayDivide(domain.segments[s], rules), distance(a, b) / spacing.at(midpoint(a, b))};
    }
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t p, std::uint32_t q) { return key[p] < key[q]; });
    ParitySets sets(domain.nodes.size());
    std::vector<std::uint32_t> odd;
    for (const std::uint32_t s : order) {
        if (!sets.join(domain.segments[s].a, domain.segments[s].b)) {
            odd.push_back(s);
        }
    }
    colours.resize(domain.nodes.size());
    for (std::uint32_t n = 0; n < colours.size(); ++n) {
        colours[n] = sets.find(n).parity;
    }
    std::sort(odd.begin(), odd.end());
    return odd;
}

/// Adds edges to the parts of lines and curves that close odd cycles.
class Divider {
  public:
    Divider(DiscreteDomain &domain, const EvenRules &rules) : domain_(domain), rules_(rules) {
        offsets_.assign(domain.nodes.size() + 1, 0);
        for (const DiscreteSegment &segment : domain.segments) {
            ++offsets_[segment.a + 1];
            ++offsets_[segment.b + 1];
        }
        std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
        at_.resize(offsets_.back());
        std::vector<std::uint32_t> next(offsets_.begin(), offsets_.end() - 1);
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            at_[next[domain.segments[s].a]++] = s;
            at_[next[domain.segments[s].b]++] = s;
        }
        given_ = rules.domain->nodes;
        std::sort(given_.begin(), given_.end(), comesBefore);
    }

    /// Gives the part with this segment one more edge. `whole`: respace its nodes; else only the segment is halved.
    void divide(std::uint32_t segment, bool whole) {
        const std::vector<std::uint32_t> side = whole ? sideOf(segment) : std::vector<std::uint32_t>{segment};
        const std::size_t count = side.size();
        std::vector<Vec2> places;
        std::vector<double> parameters;
        for (const std::uint32_t s : side) {
            places.push_back(domain_.nodes[domain_.segments[s].a]);
            parameters.push_back(stretch(s).t0);
        }
        places.push_back(domain_.nodes[domain_.segments[side.back()].b]);
        parameters.push_back(stretch(side.back()).t1);
        const DiscreteSegment last = domain_.segments[side.back()];
        const auto added = static_cast<std::uint32_t>(domain_.nodes.size());
        domain_.nodes.emplace_back();
        domain_.segments[side.back()].b = added;
        DiscreteSegment end = last;
        end.a = added;
        domain_.segments.push_back(end);
        if (!domain_.stretches.empty()) {
            domain_.stretches.push_back(domain_.stretches[side.back()]);
        }
        for (std::size_t i = 1; i <= count; ++i) {
            const double at = static_cast<double>(i * count) / static_cast<double>(count + 1);
            const auto k = std::min(static_cast<std::size_t>(at), count - 1);
            const double f = at - static_cast<double>(k), t = std::lerp(parameters[k], parameters[k + 1], f);
            const CurveStretch along = stretch(segment);
            domain_.nodes[domain_.segments[side[i - 1]].b] =
                along.follows() ? domain_.curves[along.curve].point(t) : lerp(places[k], places[k + 1], f);
            if (along.follows()) {
                domain_.stretches[side[i - 1]].t1 = t;
                domain_.stretches[i < count ? side[i] : domain_.stretches.size() - 1].t0 = t;
            }
        }
    }

  private:
    CurveStretch stretch(std::uint32_t s) const {
        return domain_.stretches.empty() ? CurveStretch{} : domain_.stretches[s];
    }
    /// Returns the segment that continues another one of the same line or curve through a node that was inserted, or
    /// kNoIndex. `forward`: beyond its end.
    std::uint32_t continuation(std::uint32_t s, bool forward) const {
        const DiscreteSegment &segment = domain_.segments[s];
        const std::uint32_t node = forward ? segment.b : segment.a;
        if (node + 1 >= offsets_.size() || offsets_[node + 1] - offsets_[node] != 2 ||
            std::binary_search(given_.begin(), given_.end(), domain_.nodes[node], comesBefore)) {
            return kNoIndex;
        }
        const std::uint32_t other = at_[offsets_[node]] == s ? at_[offsets_[node] + 1] : at_[offsets_[node]];
        const DiscreteSegment &o = domain_.segments[other];
        const CurveStretch p = stretch(s), q = stretch(other);
        const bool joined = forward ? o.a == node : o.b == node;
        const bool same = p.follows() ? q.curve == p.curve && (forward ? q.t0 == p.t1 : q.t1 == p.t0)
                                      : !q.follows() && o.source == segment.source;
        return joined && same && o.tag == segment.tag && mayDivide(o, rules_) ? other : kNoIndex;
    }
    /// Returns the segments between two nodes that must stay, in order.
    std::vector<std::uint32_t> sideOf(std::uint32_t segment) const {
        std::uint32_t first = segment;
        for (std::uint32_t s = segment; (s = continuation(s, false)) != kNoIndex && s != segment;) {
            first = s;
        }
        std::vector<std::uint32_t> side{first};
        for (std::uint32_t s = first; (s = continuation(s, true)) != kNoIndex && s != first;) {
            side.push_back(s);
        }
        return side;
    }

    DiscreteDomain &domain_;
    const EvenRules &rules_;
    std::vector<std::uint32_t> offsets_, at_; ///< per node that was there before: its segments
    std::vector<Vec2> given_;                 ///< nodes of the domain, sorted
};

} // namespace

ColouredBoundary colourBoundary(const DiscreteDomain &boundary, const SpacingField &spacing, const EvenRules &rules) {
    ColouredBoundary result;
    result.domain = boundary;
    const std::vector<std::uint32_t> odd = colour(boundary, spacing, rules, result.colours);
    result.oneColoured = odd;
    for (const bool whole : {true, false}) {
        if (std::none_of(odd.begin(), odd.end(), [&](auto s) { return mayDivide(boundary.segments[s], rules); })) {
            break;
        }
        ColouredBoundary even;
        even.domain = boundary;
        Divider divider(even.domain, rules);
        for (const std::uint32_t s : odd) {
            if (mayDivide(boundary.segments[s], rules)) {
                divider.divide(s, whole);
                ++even.added;
            }
        }
        if (isProper(even.domain)) {
            sumAreas(even.domain); // the new nodes lie on curves
            even.oneColoured = colour(even.domain, spacing, rules, even.colours);
            return even;
        }
    }
    return result;
}

} // namespace forefront
