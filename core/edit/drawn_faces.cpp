#include "core/edit/drawn_faces.hpp"

#include "core/geometry/predicates.hpp"

#include <numeric>

namespace forefront {
namespace {

/// Farther to the right; of equal ones, the upper.
bool beyond(Vec2 p, Vec2 q) {
    return p.x != q.x ? p.x > q.x : p.y > q.y;
}

} // namespace

DrawnFaces::Sets::Sets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), 0U);
}

std::uint32_t DrawnFaces::Sets::root(std::uint32_t k) {
    while (parent_[k] != k) {
        k = parent_[k] = parent_[parent_[k]];
    }
    return k;
}

DrawnFaces::DrawnFaces(const Domain &domain)
    : nodes_(domain.nodes), segments_(domain.segments), components_(domain.nodes.size()) {
    sortAroundNodes();
    traceCycles();
    std::vector<Box2> boxes;
    boxes.reserve(segments_.size());
    for (const DomainSegment &segment : segments_) {
        boxes.push_back(boxOf(nodes_[segment.a], nodes_[segment.b]));
        components_.join(segment.a, segment.b);
    }
    tree_ = BoxTree(boxes);
    joinComponents();
}

/// Counter-clockwise from the direction of +x, exact.
bool DrawnFaces::turnsBefore(std::uint32_t g, std::uint32_t h) const {
    const Vec2 o = at(origin(g)), p = at(target(g)), q = at(target(h));
    const bool lowerP = p.y < o.y || (p.y == o.y && p.x < o.x), lowerQ = q.y < o.y || (q.y == o.y && q.x < o.x);
    return lowerP != lowerQ ? lowerQ : orientation(o, p, q) > 0;
}

void DrawnFaces::sortAroundNodes() {
    std::vector<std::uint32_t> order(2 * segments_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t g, std::uint32_t h) {
        return origin(g) != origin(h) ? origin(g) < origin(h) : turnsBefore(g, h);
    });
    clockwise_.resize(order.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first;
        while (last < order.size() && origin(order[last]) == origin(order[first])) {
            ++last;
        }
        for (std::size_t k = first; k < last; ++k) {
            clockwise_[order[k]] = order[k == first ? last - 1 : k - 1];
        }
        first = last;
    }
}

/// Cycle 0 is reserved for what lies beyond all segments.
void DrawnFaces::traceCycles() {
    cycle_.assign(2 * segments_.size(), kNoIndex);
    std::uint32_t count = 1;
    for (std::uint32_t start = 0; start < cycle_.size(); ++start) {
        if (cycle_[start] != kNoIndex) {
            continue;
        }
        for (std::uint32_t h = start; cycle_[h] == kNoIndex; h = clockwise_[h ^ 1U]) {
            cycle_[h] = count;
        }
        ++count;
    }
    faces_ = Sets(count);
}

/// The face beyond the rightmost node of each connected component is the one around the component.
void DrawnFaces::joinComponents() {
    std::vector<std::uint32_t> rightmost(nodes_.size(), kNoIndex);
    for (std::uint32_t h = 0; h < cycle_.size(); ++h) {
        std::uint32_t &best = rightmost[components_.root(origin(h))];
        if (best == kNoIndex || beyond(at(origin(h)), at(origin(best)))) {
            best = h;
        }
    }
    for (const std::uint32_t h : rightmost) {
        if (h != kNoIndex) {
            faces_.join(cycle_[outermost(h)], cycleBelow(at(origin(h)), components_.root(origin(h))));
        }
    }
}

/// Of the half-edges that leave the rightmost node, the one whose left side holds the direction of +x: all point
/// into the left half-plane (none straight up), so it is the last one counter-clockwise.
std::uint32_t DrawnFaces::outermost(std::uint32_t h) const {
    std::uint32_t best = h;
    for (std::uint32_t g = clockwise_[h]; g != h; g = clockwise_[g]) {
        if (orientation(at(origin(h)), at(target(best)), at(target(g))) > 0) {
            best = g;
        }
    }
    return best;
}

/// Cycle on the upper side of the first segment below p, an instant to the right of p; 0 if there is none. Segments
/// of the component `except` do not count.
std::uint32_t DrawnFaces::cycleBelow(Vec2 p, std::uint32_t except) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::uint32_t best = kNoIndex;
    tree_.query({{p.x, -kInfinity}, p}, [&](std::uint32_t s) {
        std::uint32_t h = 2 * s;
        if (at(origin(h)).x > at(target(h)).x) {
            ++h;
        }
        const Vec2 a = at(origin(h)), b = at(target(h));
        if (!(a.x <= p.x && p.x < b.x) || components_.root(origin(h)) == except || orientation(a, b, p) <= 0) {
            return;
        }
        if (best == kNoIndex || liesAbove(h, best)) {
            best = h;
        }
    });
    return best == kNoIndex ? 0 : cycle_[best];
}

/// True if h lies above g where their extents along x overlap; they do not cross and both run to the right.
bool DrawnFaces::liesAbove(std::uint32_t h, std::uint32_t g) const {
    const Vec2 a = at(origin(g)), b = at(target(g)), c = at(origin(h)), d = at(target(h));
    if (c.x >= a.x) {
        const int side = orientation(a, b, c);
        return side != 0 ? side > 0 : orientation(a, b, d) > 0;
    }
    const int side = orientation(c, d, a);
    return side != 0 ? side < 0 : orientation(c, d, b) < 0;
}

bool isTraceable(const Domain &domain, const DomainSegment &s) {
    return s.a < domain.nodes.size() && s.b < domain.nodes.size() && isFinite(domain.nodes[s.a]) &&
           isFinite(domain.nodes[s.b]) && domain.nodes[s.a] != domain.nodes[s.b];
}

Domain traceable(const Domain &domain) {
    Domain result = domain;
    std::erase_if(result.segments, [&](const DomainSegment &s) { return !isTraceable(domain, s); });
    return result;
}

} // namespace forefront
