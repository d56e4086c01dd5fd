#include "core/drawing_files/svg/areas/svg_stroke_areas.hpp"

#include "core/drawing_files/svg/areas/svg_stroke.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace forefront {

namespace {

constexpr std::size_t kFewParts = 8; ///< more are united first
/// Tolerance of that union, as a fraction of the drawing size and of the width of the stroke.
constexpr double kUnionTolerance = 1e-9, kUnionOfWidth = 1e-6;

/// Returns the label of all pieces; std::nullopt if they differ.
std::optional<std::uint32_t> onlyLabel(const OutlinedArea &area) {
    const std::uint32_t label = area.rings.front().labels.front();
    const bool single = std::all_of(area.rings.begin(), area.rings.end(), [&](const OutlineRing &ring) {
        return std::all_of(ring.labels.begin(), ring.labels.end(), [&](std::uint32_t other) { return other == label; });
    });
    return single ? std::optional(label) : std::nullopt;
}

} // namespace

bool StrokeAreas::add(const SvgPath &path, std::uint32_t shape, std::int32_t tag) {
    constexpr std::size_t kMaxNodes = 2'000'000;
    std::vector<OutlinedArea> areas;
    for (const BandPart &part : strokeParts(path)) {
        areas.push_back(areaOf(part, static_cast<std::uint32_t>(strokes_.size())));
        nodes_ += areas.back().nodeCount();
    }
    if (nodes_ > kMaxNodes) {
        return false;
    }
    if (areas.empty()) {
        return true;
    }
    strokes_.push_back({tag, path.offset, shape});
    thinnest_ = std::min(thinnest_, path.strokeWidth);
    const bool hidden = inBackground(areas);
    if (!hidden && !shapeRegions_) {
        std::move(areas.begin(), areas.end(), std::back_inserter(kept_[path.limit]));
        return true;
    }
    for (const OutlinedArea &area : hidden ? areas : united(std::move(areas))) {
        builder_.addMadeArea(shape, area, strokes_);
    }
    return true;
}

void StrokeAreas::finish(std::uint32_t feature) {
    constexpr double kTolerance = 1e-4; // fraction of the width; strokes that nearly meet would leave tiny pieces
    for (auto &[limit, areas] : kept_) {
        std::optional<std::uint32_t> common;
        for (const OutlinedArea &area : united(std::move(areas))) {
            const std::optional<std::uint32_t> stroke = onlyLabel(area);
            if (!stroke && !common) {
                common = builder_.addShape(feature, {}, limit);
            }
            builder_.addMadeArea(stroke ? strokes_[*stroke].shape : *common, area, strokes_);
        }
    }
    kept_.clear();
    if (std::isfinite(thinnest_)) {
        builder_.preferTolerance(kTolerance * thinnest_);
    }
}

OutlinedArea StrokeAreas::areaOf(const BandPart &part, std::uint32_t stroke) const {
    OutlinedArea area;
    OutlineRing &ring = area.rings.emplace_back();
    for (std::size_t k = 0; k < part.nodes.size(); ++k) {
        ring.nodes.push_back(part.nodes[k]);
        if (part.curves[k].kind() == CurveKind::Line) {
            ring.stretches.emplace_back();
            continue;
        }
        double from = 0.0;
        for (const double to : part.curves[k].flatten(tolerance_)) {
            ring.stretches.push_back({static_cast<std::uint32_t>(area.curves.size()), from, to});
            if (to < 1.0) {
                ring.nodes.push_back(part.curves[k].point(to));
            }
            from = to;
        }
        area.curves.push_back(part.curves[k]);
    }
    ring.labels.assign(ring.nodes.size(), stroke);
    return area;
}

bool StrokeAreas::inBackground(const std::vector<OutlinedArea> &areas) const {
    Box2 box;
    for (const OutlinedArea &area : areas) {
        for (const Vec2 node : area.rings.front().nodes) {
            box.add(node);
        }
    }
    return background_.contains(box.min) && background_.contains(box.max);
}

std::vector<OutlinedArea> StrokeAreas::united(std::vector<OutlinedArea> areas) const {
    if (areas.size() <= kFewParts) {
        return areas;
    }
    return uniteAreas(std::move(areas), std::min(kUnionTolerance * size_, kUnionOfWidth * thinnest_));
}

} // namespace forefront
