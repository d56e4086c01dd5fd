#pragma once

#include "core/engine/domain/domain.hpp"
#include "tests/support/random_domains.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace forefront::testing {

/// A disc known to lie inside of some outline.
struct Disc {
    Vec2 centre;
    double radius = 0.0;
};

inline Vec2 polar(Vec2 centre, double radius, double angle) {
    return {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
}

/// Builds a domain from loops and chains.
class DomainBuilder {
  public:
    std::uint32_t node(Vec2 at) {
        domain.nodes.push_back(at);
        return static_cast<std::uint32_t>(domain.nodes.size() - 1);
    }
    void segment(std::uint32_t a, std::uint32_t b, std::int32_t tag, SegmentRole role = SegmentRole::Boundary) {
        domain.segments.push_back({a, b, tag, role});
    }
    /// Joins the given nodes in turn, and the last to the first if `closed`.
    void join(const std::vector<std::uint32_t> &nodes, bool closed, std::int32_t tag,
              SegmentRole role = SegmentRole::Boundary) {
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            segment(nodes[i], nodes[i + 1], tag, role);
        }
        if (closed) {
            segment(nodes.back(), nodes.front(), tag, role);
        }
    }
    std::vector<std::uint32_t> loop(const std::vector<Vec2> &polygon, std::int32_t tag,
                                    SegmentRole role = SegmentRole::Boundary) {
        std::vector<std::uint32_t> nodes;
        for (const Vec2 p : polygon) {
            nodes.push_back(node(p));
        }
        join(nodes, true, tag, role);
        return nodes;
    }

    Domain domain;
};

/// Returns a square with a corner at the origin, of one segment a side.
inline Domain squareDomain(double side) {
    Domain domain;
    domain.nodes = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    domain.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    return domain;
}

/// Returns a star-shaped polygon about the centre with radii in [low, high]·radius.
inline std::vector<Vec2> star(RandomSource &random, Vec2 centre, double radius, double low, double high, int count) {
    const double phase = random.between(0.0, 6.28);
    std::vector<Vec2> polygon;
    for (int i = 0; i < count; ++i) {
        const double angle = phase + 2.0 * std::numbers::pi * (i + random.between(-0.3, 0.3)) / count;
        polygon.push_back(polar(centre, radius * random.between(low, high), angle));
    }
    return polygon;
}

/// Returns the radius of a disc that lies inside every such star (angles between neighbours up to 1.6/count of a turn).
inline double innerRadius(double radius, double low, int count) {
    return 0.98 * radius * low * std::cos(1.6 * std::numbers::pi / count);
}

/// Returns up to `count` discs inside the given one, well apart, their radii in [low, high]·its radius.
inline std::vector<Disc> scatter(RandomSource &random, Disc within, int count, double low, double high) {
    std::vector<Disc> discs;
    for (int attempt = 0; attempt < 20 * count && static_cast<int>(discs.size()) < count; ++attempt) {
        Disc disc;
        disc.radius = within.radius * random.between(low, high);
        const double reach = std::sqrt(random.unit()) * (0.97 * within.radius - disc.radius);
        disc.centre = polar(within.centre, reach, random.between(0.0, 6.28));
        bool free = reach >= 0.0;
        for (const Disc &other : discs) {
            free = free && distance(disc.centre, other.centre) > 1.03 * (disc.radius + other.radius);
        }
        if (free) {
            discs.push_back(disc);
        }
    }
    return discs;
}

} // namespace forefront::testing
