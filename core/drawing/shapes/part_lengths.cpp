#include "core/drawing/shapes/part_lengths.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"

namespace forefront {

std::vector<PartLength> partLengths(const Shape &shape) {
    const Outline outline = outlineOf(shape);
    std::vector<PartLength> parts(taggedSegments(shape));
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        if (outline.part(k) < parts.size()) {
            PartLength &part = parts[outline.part(k)];
            part.length += outline.isCurved(k) ? outline.curve(k).length() : distance(outline.from(k), outline.to(k));
            ++part.pieces;
        }
    }
    return parts;
}

} // namespace forefront
