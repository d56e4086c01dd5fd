#include "core/io/svg/svg_stroke_areas.hpp"

#include "core/base/ids.hpp"
#include "core/io/svg/svg_stroke.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace forefront {

namespace {

constexpr std::size_t kFewParts = 8; ///< more are united first
/// Tolerance of that union, as a fraction of the drawing size and of the width of the stroke.
constexpr double kUnionTolerance = 1e-9, kUnionOfWidth = 1e-6;

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
    if (inBackground(areas)) {
        addAreas(areas, kNoIndex);
    } else if (shapeRegions_) {
        addAreas(united(std::move(areas)), kNoIndex);
    } else {
        std::move(areas.begin(), areas.end(), std::back_inserter(kept_[path.limit]));
    }
    return true;
}

void StrokeAreas::finish(std::uint32_t feature) {
    constexpr double kTolerance = 1e-4; // of the width: where strokes nearly meet, their sides leave tiny pieces
    for (auto &[limit, areas] : kept_) {
        const bool many = areas.size() > kFewParts;
        addAreas(united(std::move(areas)), many ? builder_.addShape(feature, {}, limit) : kNoIndex);
    }
    kept_.clear();
    if (std::isfinite(thinnest_)) {
        builder_.preferTolerance(kTolerance * thinnest_);
    }
}

OutlinedArea StrokeAreas::areaOf(const BandPart &part, std::uint32_t stroke) const {
    OutlinedArea area;
    OutlineRing &ring = area.rings.emplace_back();
    ring.label = stroke;
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

/// Adds areas: unions to the shape `common`, unless that is kNoIndex, and all others to the shapes of their strokes.
void StrokeAreas::addAreas(const std::vector<OutlinedArea> &areas, std::uint32_t common) {
    for (const OutlinedArea &area : areas) {
        const OutlineRing &first = area.rings.front();
        const bool toCommon = common != kNoIndex && !first.labels.empty();
        builder_.addMadeArea(toCommon ? common : strokes_[first.labelAt(0)].shape, area, strokes_);
    }
}

} // namespace forefront
