#include "core/edit/insert_document.hpp"

#include "core/edit/shape_geometry.hpp"

#include <utility>

namespace forefront {

Document insertDrawing(const Document &document, const Document &other, double scale, Selection *added) {
    Document next = document;
    Selection fresh;
    for (const auto &shape : other.shapes) {
        auto copy = std::make_shared<Shape>(*shape);
        copy->id = next.nextId++;
        scaleShape(*copy, scale);
        fresh.shapes.insert(copy->id);
        next.shapes.push_back(std::move(copy));
    }
    for (const RegionMarker &marker : other.regionMarkers) {
        fresh.markers.insert(static_cast<std::uint32_t>(next.regionMarkers.size()));
        next.regionMarkers.push_back({scale * marker.at, marker.tag, scale * scale * marker.maxArea});
    }
    next.boundaryNames.insert(other.boundaryNames.begin(), other.boundaryNames.end());
    next.regionNames.insert(other.regionNames.begin(), other.regionNames.end());
    if (added != nullptr) {
        *added = std::move(fresh);
    }
    return next;
}

Document insertCopied(const Document &document, const Document &other, Selection *added) {
    Selection fresh;
    Document next = insertDrawing(document, other, 1.0, &fresh);
    for (const SizeSource &source : other.spacing.sources) {
        fresh.sources.insert(static_cast<std::uint32_t>(next.spacing.sources.size()));
        next.spacing.sources.push_back(source);
    }
    if (added != nullptr) {
        *added = std::move(fresh);
    }
    return next;
}

} // namespace forefront
