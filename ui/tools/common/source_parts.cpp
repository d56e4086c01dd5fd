#include "ui/tools/common/source_parts.hpp"

#include "core/engine/spacing/spec/source_box.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace forefront {

std::optional<std::size_t> cornerOfPart(const SizeSource &source, SourcePart part) {
    constexpr std::array kCorners{SourcePart::A, SourcePart::AfterA, SourcePart::B, SourcePart::AfterB};
    const auto found = std::find(kCorners.begin(), kCorners.end(), part);
    return source.shape == SourceShape::Box && found != kCorners.end()
               ? std::optional(static_cast<std::size_t>(found - kCorners.begin()))
               : std::nullopt;
}

Vec2 placeOfPart(const SizeSource &source, SourcePart part, Vec2 place, double reach) {
    if (const auto corner = cornerOfPart(source, part)) {
        return SourceBox(source).corners()[*corner];
    }
    if (source.shape == SourceShape::Box) {
        const Vec2 centre = SourceBox(source).centre();
        return distance(centre, place) <= reach ? centre : place;
    }
    return part == SourcePart::A ? source.a : part == SourcePart::B ? source.b : place;
}

SizeSource withMovedPart(SizeSource source, SourcePart part, Vec2 to) {
    if (part == SourcePart::Rim) {
        source.radius = distance(source.a, to);
    } else if (const auto corner = cornerOfPart(source, part)) {
        moveCorner(source, *corner, to);
    } else if (source.shape == SourceShape::Line) {
        (part == SourcePart::A ? source.a : source.b) = to;
    } else {
        source.a = to;
    }
    return source;
}

std::string freeSourceName(const Document &document, const std::string &kind) {
    const std::vector<SizeSource> &sources = document.spacing.sources;
    for (std::size_t number = sources.size() + 1;; ++number) {
        std::string name = kind + ' ' + std::to_string(number);
        if (std::none_of(sources.begin(), sources.end(), [&](const SizeSource &other) { return other.name == name; })) {
            return name;
        }
    }
}

} // namespace forefront
