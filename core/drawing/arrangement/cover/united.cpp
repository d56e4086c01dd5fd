#include "core/drawing/arrangement/cover/united.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/base/rows.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

namespace forefront {

namespace {

ArrangementInput inputOf(std::span<const OutlinedArea> areas, double tolerance) {
    ArrangementInput input;
    input.tolerance = tolerance;
    const std::uint32_t shape = input.addShape(input.addFeature(1));
    for (const OutlinedArea &area : areas) {
        addArea(input, shape, area);
    }
    return input;
}

/// Follows the boundary of a domain. Where loops touch, any continuation is right, because the rule is even-odd.
class RingTracer {
  public:
    explicit RingTracer(const Domain &domain) : domain_(domain), newCurves_(domain.curves.size(), kNoIndex) {
        incident_ = Rows<std::uint32_t>(domain.nodes.size(), [&](const auto &add) {
            for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
                add(domain.segments[s].a, s);
                add(domain.segments[s].b, s);
            }
        });
        next_.assign(domain.nodes.size(), 0);
        used_.assign(domain.segments.size(), 0);
    }

    OutlinedArea run() {
        area_.rule = FillRule::EvenOdd;
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            if (used_[s] == 0) {
                follow(s);
            }
        }
        return std::move(area_);
    }

  private:
    void follow(std::uint32_t segment) {
        OutlineRing &ring = area_.rings.emplace_back();
        const std::uint32_t start = domain_.segments[segment].a;
        std::uint32_t node = start;
        do {
            const DomainSegment &way = domain_.segments[segment];
            used_[segment] = 1;
            ring.nodes.push_back(domain_.nodes[node]);
            ring.labels.push_back(static_cast<std::uint32_t>(way.tag - 1));
            ring.stretches.push_back(ownStretch(node == way.a ? way.stretch : way.stretch.reversed()));
            node = node == way.a ? way.b : way.a;
            segment = unusedAt(node);
        } while (node != start && segment != kNoIndex);
    }

    std::uint32_t unusedAt(std::uint32_t node) {
        const std::span<const std::uint32_t> here = incident_[node];
        for (std::uint32_t &next = next_[node]; next < here.size(); ++next) {
            if (used_[here[next]] == 0) {
                return here[next];
            }
        }
        return kNoIndex;
    }

    CurveStretch ownStretch(CurveStretch stretch) {
        if (stretch.follows()) {
            std::uint32_t &own = newCurves_[stretch.curve];
            if (own == kNoIndex) {
                own = static_cast<std::uint32_t>(area_.curves.size());
                area_.curves.push_back(domain_.curves[stretch.curve]);
            }
            stretch.curve = own;
        }
        return stretch;
    }

    const Domain &domain_;
    Rows<std::uint32_t> incident_;    ///< per node: its segments
    std::vector<std::uint32_t> next_; ///< per node: the first of them that may be unused
    std::vector<std::uint8_t> used_;
    std::vector<std::uint32_t> newCurves_; ///< per curve: its index in the area
    OutlinedArea area_;
};

} // namespace

std::size_t OutlinedArea::nodeCount() const {
    return std::accumulate(rings.begin(), rings.end(), std::size_t{0},
                           [](std::size_t sum, const OutlineRing &ring) { return sum + ring.nodes.size(); });
}

std::uint32_t addArea(ArrangementInput &input, std::uint32_t shape, const OutlinedArea &area) {
    const std::uint32_t contour = input.addContour(shape, area.rule);
    const auto firstCurve = static_cast<std::uint32_t>(input.curves.size());
    input.curves.insert(input.curves.end(), area.curves.begin(), area.curves.end());
    for (const OutlineRing &ring : area.rings) {
        for (std::size_t k = 0; k < ring.nodes.size(); ++k) {
            const Vec2 a = ring.nodes[k], b = ring.nodes[(k + 1) % ring.nodes.size()];
            CurveStretch stretch = ring.stretches[k];
            stretch.curve += stretch.follows() ? firstCurve : 0;
            if (a != b) {
                const auto tag = static_cast<std::int32_t>(ring.labels[k] + 1);
                input.pieces.push_back({a, b, contour, tag, PieceRole::Outline, stretch});
            }
        }
    }
    return contour;
}

std::vector<OutlinedArea> uniteAreas(std::vector<OutlinedArea> areas, double tolerance) {
    constexpr std::size_t kGroup = 8;
    std::vector<OutlinedArea> rest;
    while (areas.size() > 1) {
        std::vector<OutlinedArea> unions;
        for (std::size_t first = 0; first < areas.size(); first += kGroup) {
            const auto group = std::span(areas).subspan(first, std::min(kGroup, areas.size() - first));
            const Result<Arrangement> united = arrange(inputOf(group, tolerance));
            if (united && !united->domain.segments.empty()) {
                unions.push_back(RingTracer(united->domain).run());
            } else {
                std::move(group.begin(), group.end(), std::back_inserter(rest));
            }
        }
        areas = std::move(unions);
    }
    areas.insert(areas.end(), std::make_move_iterator(rest.begin()), std::make_move_iterator(rest.end()));
    return areas;
}

} // namespace forefront
