#include "core/engine/base/paced_progress.hpp"
#include "core/engine/base/rows.hpp"
#include "core/engine/spacing/parts/background/background_part.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace forefront {
namespace {

constexpr SiteLabel kBackgroundLabel{SpacingOrigin::Background, SiteReason::BackgroundEdge, 0};
constexpr double kStep = 0.02; ///< change of spacing along one piece of an edge, relative

double valueAt(const BackgroundMesh &mesh, std::uint32_t node, double minimum) {
    return std::max(mesh.values[node], minimum);
}

/// Adds an edge as sites of nearly equal spacing. If the edge is steeper than the gradation, adds only its end with the
/// smaller spacing, from which the spacing grows more slowly than along the edge.
void addEdge(const BackgroundMesh &mesh, std::uint32_t a, std::uint32_t b, double minimum, double gradation,
             SiteSet &sites) {
    if (valueAt(mesh, a, minimum) > valueAt(mesh, b, minimum)) {
        std::swap(a, b);
    }
    const double low = valueAt(mesh, a, minimum);
    const double high = valueAt(mesh, b, minimum);
    const Vec2 from = mesh.nodes[a];
    const Vec2 to = mesh.nodes[b];
    if (high - low >= gradation * distance(from, to)) {
        sites.add(SizeSite::point(from, low, gradation), kBackgroundLabel);
        return;
    }
    const int pieces = static_cast<int>(std::clamp(std::ceil((high - low) / (kStep * low)), 1.0, 200.0));
    for (int i = 0; i < pieces; ++i) {
        const double s = static_cast<double>(i) / pieces;
        const double t = static_cast<double>(i + 1) / pieces;
        sites.add(
            SizeSite::segment(lerp(from, to, s), lerp(from, to, t), low + 0.5 * (s + t) * (high - low), gradation),
            kBackgroundLabel);
    }
}

struct Edge {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    friend auto operator<=>(const Edge &, const Edge &) = default;
};
Edge edgeOf(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

} // namespace

void BackgroundPart::addBorderSites(const BackgroundMesh &mesh, double minimum, double gradation, SiteSet &sites,
                                    const Progress &progress) {
    // The upper nodes of the edges by their lower node.
    Rows<std::uint32_t> upper(mesh.nodes.size(), [&](const auto &add) {
        for (const auto &[a, b, c] : mesh.elements) {
            for (const Edge edge : {edgeOf(a, b), edgeOf(b, c), edgeOf(c, a)}) {
                add(edge.low, edge.high);
            }
        }
    });
    PacedProgress pace(progress, "finding the border of the background mesh", mesh.nodes.size());
    for (std::uint32_t low = 0; low < mesh.nodes.size() && pace.next(); ++low) {
        const std::span<std::uint32_t> row = upper[low];
        const auto end = row.end();
        std::sort(row.begin(), end);
        for (auto at = row.begin(); at != end;) {
            const auto other = std::find_if(at, end, [at](std::uint32_t high) { return high != *at; });
            if (other == at + 1) {
                addEdge(mesh, low, *at, minimum, gradation, sites);
            }
            at = other;
        }
    }
}

void BackgroundPart::addSteepSites(const BackgroundMesh &mesh, double minimum, double gradation, SiteSet &sites) {
    std::vector<Edge> edges;
    for (const auto &[a, b, c] : mesh.elements) {
        const Vec2 ab = mesh.nodes[b] - mesh.nodes[a];
        const Vec2 ac = mesh.nodes[c] - mesh.nodes[a];
        const double atA = valueAt(mesh, a, minimum);
        const double second = valueAt(mesh, b, minimum) - atA;
        const double third = valueAt(mesh, c, minimum) - atA;
        const Vec2 gradient = (1.0 / cross(ab, ac)) * Vec2{second * ac.y - third * ab.y, third * ab.x - second * ac.x};
        if (length(gradient) > gradation) {
            edges.insert(edges.end(), {edgeOf(a, b), edgeOf(b, c), edgeOf(c, a)});
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const Edge &edge : edges) {
        addEdge(mesh, edge.low, edge.high, minimum, gradation, sites);
    }
}

std::optional<std::uint32_t> BackgroundPart::triangleAt(Vec2 p) const {
    std::optional<std::uint32_t> found;
    double deepest = -1e-9;
    for (std::uint32_t e = 0; e < triangles_.size(); ++e) {
        const Vec2 d = p - triangles_[e].a;
        const double second = dot(triangles_[e].toSecond, d);
        const double third = dot(triangles_[e].toThird, d);
        if (const double depth = std::min({second, third, 1.0 - second - third}); depth > deepest) {
            deepest = depth;
            found = e;
        }
    }
    return found;
}

} // namespace forefront
