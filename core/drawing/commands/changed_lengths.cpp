#include "core/drawing/commands/changed_lengths.hpp"

#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace forefront {
namespace {

bool isAboutLength(ConstraintKind kind) {
    return kind == ConstraintKind::Equal || kind == ConstraintKind::Midpoint || kind == ConstraintKind::Length;
}

/// Returns true if a shape has a segment between two places.
bool hasSegment(const Outline &outline, Vec2 from, Vec2 to) {
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        const Vec2 a = outline.from(k), b = outline.to(k);
        if ((a == from && b == to) || (a == to && b == from)) {
            return true;
        }
    }
    return false;
}

} // namespace

void dropChangedLengths(const Document &before, Document &next, std::uint32_t shape) {
    const Shape *const old = findShape(before, shape);
    if (next.constraints.empty() || old == nullptr) {
        return;
    }
    const Outline was = outlineOf(*old);
    std::vector<Outline> now;
    for (const auto &each : next.shapes) {
        const bool isNew = findShape(before, each->id) == nullptr; // as is the second part that trimming may leave
        if (each->id == shape || isNew) {
            now.push_back(outlineOf(*each));
        }
    }
    std::erase_if(next.constraints, [&](const auto &constraint) {
        return isAboutLength(constraint->kind) &&
               std::any_of(constraint->parts.begin(), constraint->parts.end(), [&](const SketchPart &part) {
                   return part.shape == shape && part.kind == SketchPartKind::Segment &&
                          part.index < was.segmentCount() && !was.isCurved(part.index) &&
                          std::none_of(now.begin(), now.end(), [&](const Outline &outline) {
                              return hasSegment(outline, was.from(part.index), was.to(part.index));
                          });
               });
    });
}

} // namespace forefront
