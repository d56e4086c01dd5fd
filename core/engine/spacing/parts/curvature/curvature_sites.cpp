#include "core/engine/spacing/parts/curvature/curvature_sites.hpp"

#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace forefront {
namespace {

constexpr double kVisible = 1.0 / 5000.0; ///< smallest visible distance from a curve, as a fraction of the diagonal
constexpr double kAreaError = 0.002;      ///< fraction of the area that all edges together may cut off
constexpr double kEven = 0.3;             ///< turning of a part, in radians, that is not worth dividing
constexpr double kUneven = 2.0;           ///< ratio of the radii of the halves of a part that bends unevenly
constexpr double kGrown = 0.02;           ///< growth of the size, relative to it, between a chord and its curve
constexpr double kCorner = 3.0;           ///< bends with a smaller radius, in visible distances, are corners

/// Returns the area inside, from the chords; std::nullopt if segments cross, or after a stop request.
std::optional<double> areaInside(const Domain &domain, const LazyFaces &lazy, const Progress &progress) {
    progress("measuring the domain", 0.0);
    const DomainFaces *const found = lazy.get();
    if (found == nullptr) {
        return std::nullopt;
    }
    const auto &[graph, sweep, faces, labels] = *found;
    const Vec2 origin = domain.bounds().centre();
    CompensatedSum twice;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        const bool left = labels.inside[faces.left[e]] != 0, right = labels.inside[faces.right[e]] != 0;
        if (left != right) {
            const Vec2 a = graph.points[graph.edges[e].a] - origin, b = graph.points[graph.edges[e].b] - origin;
            twice.add(left ? cross(a, b) : cross(b, a));
        }
    }
    return 0.5 * twice.value();
}

/// Returns the distance between edges and curves that is too small to see. An edge of length c cuts off c³κ/12; with c²
/// = 8 δ / κ that is 2δ/3 for each unit of length.
double invisibleDistance(const Domain &domain, const LazyFaces &faces, const CurveChains &chains,
                         const Progress &progress) {
    double along = 0.0;
    for (const CurveChain &chain : chains.list) {
        along += domain.curves[chain.curve].length(chain.t0, chain.t1);
    }
    const double distance = kVisible * domain.bounds().diagonal();
    const std::optional<double> area = areaInside(domain, faces, progress);
    return area && *area > 0.0 ? std::min(distance, 1.5 * kAreaError * *area / along) : distance;
}

/// Visits the parts of a stretch of a curve along which it bends about evenly, with their mean radii: at a point, the
/// radius may be zero. Parts no longer than `shortest` are not divided. `maxTurning`: of a part, in radians.
template <class Visit>
void forEachBend(const Curve &curve, CurveStretch stretch, double shortest, double maxTurning, const Visit &visit) {
    struct Part {
        double t0, t1, length, turning;
        double radius() const { return length / turning; }
    };
    const auto part = [&](double t0, double t1) { return Part{t0, t1, curve.length(t0, t1), curve.turning(t0, t1)}; };
    std::vector<Part> open = {part(stretch.t0, stretch.t1)};
    while (!open.empty()) {
        const Part whole = open.back();
        open.pop_back();
        if (whole.turning > std::min(kEven, maxTurning) && whole.length > shortest) {
            const double middle = 0.5 * (whole.t0 + whole.t1);
            const Part first = part(whole.t0, middle), second = part(middle, whole.t1);
            const double a = first.radius(), b = second.radius();
            if (std::max(a, b) > kUneven * std::min(a, b) || whole.turning > maxTurning) {
                open.insert(open.end(), {second, first});
                continue;
            }
        }
        visit(whole.t0, whole.t1, whole.radius());
    }
}

} // namespace

void addCurvatureSites(const Domain &domain, const LazyFaces &faces, const CurveChains &chains,
                       SegmentElements elements, double segmentsPerTurn, double minimum, double gradation,
                       SpacingOrigin origin, bool visibleOnly, const Progress &progress, SiteSet &sites) {
    if (chains.list.empty()) {
        return;
    }
    const double shortest = kVisible * domain.bounds().diagonal();
    // Sizes grow from the chords of the parts, to which the curve keeps a distance of about radius * turning² / 8.
    const double maxTurning = visibleOnly ? std::numeric_limits<double>::infinity()
                                          : std::sqrt(kGrown * 16.0 * std::numbers::pi / (segmentsPerTurn * gradation));
    const double invisible = visibleOnly ? invisibleDistance(domain, faces, chains, progress) : 0.0;
    for (const CurveChain &chain : chains.list) {
        if (progress.cancelled()) {
            return;
        }
        if (elements[chain.segments.front()] > 0) {
            continue; // their size is given
        }
        const Curve &curve = domain.curves[chain.curve];
        for (const std::uint32_t s : chain.segments) {
            const DomainSegment &segment = domain.segments[s];
            const Vec2 ends[] = {domain.nodes[segment.a], domain.nodes[segment.b]};
            forEachBend(curve, segment.stretch, shortest, maxTurning, [&](double t0, double t1, double radius) {
                if (!(radius > kCorner * invisible) || !std::isfinite(radius)) {
                    return;
                }
                const double size =
                    std::max(2.0 * std::numbers::pi * radius / segmentsPerTurn, std::sqrt(8.0 * invisible * radius));
                const Vec2 a = t0 == segment.stretch.t0 ? ends[0] : curve.point(t0);
                const Vec2 b = t1 == segment.stretch.t1 ? ends[1] : curve.point(t1);
                sites.add(limited(SizeSite::segment(a, b, size, gradation), minimum, gradation),
                          {origin, SiteReason::Bend, s});
            });
        }
    }
}

} // namespace forefront
