#include "core/edit/part_lengths.hpp"

#include "core/edit/shape_geometry.hpp"

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

std::vector<double> meanGaps(const Document &document, const Shape &shape) {
    const Outline outline = outlineOf(shape);
    const Chords chords = chordsOf(shape, outline, document.circleTolerance);
    std::vector<double> gaps(taggedSegments(shape)), totals(gaps.size());
    for (std::size_t k = 0; k < chords.size(); ++k) {
        const std::uint32_t segment = chords.segments[k], part = outline.part(segment);
        if (part >= gaps.size()) {
            continue;
        }
        const double span = distance(chords.from(k), chords.to(k));
        totals[part] += span;
        if (outline.isCurved(segment)) {
            constexpr double kMean = 2.0 / 3.0; // mean height of a parabola over its chord, in units of its height
            const CurveStretch &stretch = chords.stretches[k];
            const Vec2 middle = outline.curve(segment).point(0.5 * (stretch.t0 + stretch.t1));
            gaps[part] += kMean * span * distance(middle, midpoint(chords.from(k), chords.to(k)));
        }
    }
    for (std::size_t part = 0; part < gaps.size(); ++part) {
        gaps[part] = totals[part] > 0.0 ? gaps[part] / totals[part] : 0.0;
    }
    return gaps;
}

} // namespace forefront
