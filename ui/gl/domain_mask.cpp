#include "ui/gl/domain_mask.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

/// A crossing of a row with a segment; sorted by row, then along x.
struct Crossing {
    int row = 0;
    double x = 0.0;
    friend bool operator<(const Crossing &a, const Crossing &b) { return a.row != b.row ? a.row < b.row : a.x < b.x; }
};

void fillSpan(std::uint8_t *row, int width, double from, double to) {
    from = std::clamp(from, 0.0, static_cast<double>(width));
    to = std::clamp(to, 0.0, static_cast<double>(width));
    if (!(from < to)) {
        return;
    }
    const int first = static_cast<int>(from), last = std::min(static_cast<int>(to), width - 1);
    if (first == last) {
        row[first] = static_cast<std::uint8_t>(std::min(255.0, row[first] + 255.0 * (to - from)));
        return;
    }
    row[first] = static_cast<std::uint8_t>(std::min(255.0, row[first] + 255.0 * (first + 1 - from)));
    std::fill(row + first + 1, row + last, std::uint8_t{255});
    row[last] = static_cast<std::uint8_t>(std::min(255.0, row[last] + 255.0 * std::min(1.0, to - last)));
}

} // namespace

std::vector<std::uint8_t> rasteriseDomain(const Domain &domain, const Camera &camera, int width, int height) {
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    std::vector<Crossing> crossings;
    const auto toLocal = [&](Vec2 p) {
        return Vec2{(p.x - camera.centre.x) * camera.zoom + 0.5 * width,
                    (p.y - camera.centre.y) * camera.zoom + 0.5 * height};
    };
    for (const DomainSegment &segment : domain.segments) {
        if (segment.role != SegmentRole::Boundary || segment.a >= domain.nodes.size() ||
            segment.b >= domain.nodes.size()) {
            continue;
        }
        Vec2 p = toLocal(domain.nodes[segment.a]), q = toLocal(domain.nodes[segment.b]);
        if (!isFinite(p) || !isFinite(q)) {
            continue;
        }
        if (p.y > q.y) {
            std::swap(p, q);
        }
        // Rows whose middle y + 0.5 lies in [p.y, q.y).
        const double from = std::max(0.0, std::ceil(p.y - 0.5)),
                     to = std::min(static_cast<double>(height), std::ceil(q.y - 0.5));
        for (double row = from; row < to; row += 1.0) {
            const double x = p.x + (row + 0.5 - p.y) / (q.y - p.y) * (q.x - p.x);
            crossings.push_back({static_cast<int>(row), x});
        }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size();) {
        if (crossings[i].row != crossings[i + 1].row) {
            ++i; // an open chain: the fault is reported elsewhere
            continue;
        }
        fillSpan(&mask[static_cast<std::size_t>(crossings[i].row) * static_cast<std::size_t>(width)], width,
                 crossings[i].x, crossings[i + 1].x);
        i += 2;
    }
    return mask;
}

} // namespace forefront
