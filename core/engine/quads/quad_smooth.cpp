#include "core/engine/quads/quad_smooth.hpp"

#include "core/engine/geometry/compass.hpp"

#include <cmath>
#include <numbers>

namespace forefront {

namespace {

constexpr double kTiny = 1e-300; ///< keeps quotients finite where lengths are zero

bool isFree(const QuadWorkspace &mesh, std::uint32_t node) {
    return !mesh.isFixed(node) && mesh.valence(node) > 0;
}

} // namespace

Vec2 squaringPlace(const QuadWorkspace &mesh, std::uint32_t node, double spring) {
    const Vec2 p = mesh.nodes[node];
    Vec2 sum;
    double weight = 0.0;
    for (const std::uint32_t cell : mesh.around[node]) {
        const QuadCell &q = mesh.cells[cell];
        const unsigned k = cornerAt(q, node);
        if (isTriangle(q)) {
            const Vec2 a = mesh.nodes[nextCorner(q, k)], b = mesh.nodes[previousCorner(q, k)];
            const double w = 1.0 / (distanceSquared(a, b) + kTiny);
            sum += w * (midpoint(a, b) + 0.5 * std::numbers::sqrt3 * leftNormal(b - a));
            weight += w;
            continue;
        }
        const std::uint32_t first = q[(k + 1) & 3];
        const Vec2 a = mesh.nodes[first], c = mesh.nodes[q[(k + 2) & 3]], b = mesh.nodes[q[(k + 3) & 3]];
        // The place of the node that squares the corner at a, the one at b, and, twice, the one at the node itself.
        const Vec2 atA = a + leftNormal(c - a), atB = b - leftNormal(c - b);
        const Vec2 own = midpoint(a, b) + 0.5 * leftNormal(b - a);
        const double side2 =
            0.25 * (distanceSquared(a, c) + distanceSquared(c, b) + distanceSquared(b, p) + distanceSquared(p, a));
        const double w = 1.0 / (side2 + kTiny);
        sum += w * (atA + atB + 2.0 * own);
        weight += 4.0 * w;
        const Vec2 d = p - a;
        const double l = length(d) + kTiny, rho = 0.5 * (double{mesh.rho[node]} + double{mesh.rho[first]});
        const double s = 4.0 * spring / (rho * rho);
        sum += s * (a + (rho / l) * d);
        weight += s;
    }
    return weight > 0.0 ? (1.0 / weight) * sum : p;
}

void smoothFreely(QuadWorkspace &mesh, unsigned sweeps, double spring) {
    for (unsigned s = 0; s < sweeps; ++s) {
        for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
            if (isFree(mesh, n)) {
                mesh.nodes[n] = squaringPlace(mesh, n, spring);
            }
        }
    }
}

void smoothGuarded(QuadWorkspace &mesh, unsigned sweeps, double spring, double limit) {
    for (unsigned s = 0; s < sweeps; ++s) {
        for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
            if (!isFree(mesh, n)) {
                continue;
            }
            const Vec2 old = mesh.nodes[n];
            const double before = mesh.leastAround(n);
            mesh.nodes[n] = squaringPlace(mesh, n, spring);
            const double after = mesh.leastAround(n);
            if (after < before && after < limit) {
                mesh.nodes[n] = old;
            }
        }
    }
}

bool polishNode(QuadWorkspace &mesh, std::uint32_t node, double limit) {
    constexpr unsigned kSteps = 12;
    constexpr double kFirstStep = 0.1; // in ρ
    constexpr double kGain = 1e-6;
    bool moved = false;
    double best = isFree(mesh, node) ? mesh.leastAround(node) : limit;
    double step = kFirstStep * double{mesh.rho[node]};
    for (unsigned t = 0; t < kSteps && best < limit; ++t) {
        const Vec2 start = mesh.nodes[node];
        Vec2 place = start;
        for (const Vec2 d : kCompass) {
            mesh.nodes[node] = start + step * d;
            const double least = mesh.leastAround(node);
            if (least > best + kGain) {
                best = least;
                place = mesh.nodes[node];
            }
        }
        mesh.nodes[node] = place;
        moved = moved || !(place == start);
        step *= place == start ? 0.5 : 1.0;
    }
    return moved;
}

void polishShapes(QuadWorkspace &mesh, double limit, unsigned rounds) {
    bool moved = true;
    for (unsigned round = 0; round < rounds && moved; ++round) {
        moved = false;
        for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
            moved = polishNode(mesh, n, limit) || moved;
        }
    }
}

} // namespace forefront
