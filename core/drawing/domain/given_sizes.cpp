#include "core/drawing/domain/given_sizes.hpp"

#include "core/drawing/shapes/segment_sizes.hpp"

#include <cstddef>

namespace forefront {
namespace {

/// Returns one property of each segment; an empty list if no segment has it.
template <class Value>
std::vector<Value> listOf(const DrawnDomain &drawn, Value SegmentSource::*property, const Value &none) {
    std::vector<Value> list;
    for (std::size_t s = 0; drawn.sources != nullptr && s < drawn.sources->segments.size(); ++s) {
        if (const Value &value = drawn.sources->segments[s].*property; !(value == none)) {
            list.resize(drawn.sources->segments.size(), none);
            list[s] = value;
        }
    }
    return list;
}

} // namespace

GivenSizes::GivenSizes(const Document &document)
    : document_(document), counted_(countedParts(document)),
      needsSources_(!counted_.empty() || hasSegmentSizes(document) || !document.layers.empty() ||
                    !document.periodic.empty() || !document.cracks.empty() || !document.strips.empty()) {}

std::vector<SegmentSource> GivenSizes::sourcesOf(const Shape &shape, std::uint32_t number,
                                                 const Outline &outline) const {
    const std::vector<PartSize> sizes = sizesOfParts(shape);
    const std::vector<std::uint32_t> elements = elementsOfParts(document_, shape, counted_);
    std::vector<SegmentSource> sources;
    for (std::uint32_t segment = 0; segment < outline.segmentCount(); ++segment) {
        SegmentSource source{.shape = number, .node = segment};
        const auto part = static_cast<std::uint32_t>(outline.part(segment));
        if (part < sizes.size() && sizes[part].size > 0.0) {
            source.size = sizes[part];
        }
        source.elements = part < elements.size() ? elements[part] : 0;
        const auto own = shape.segmentSizes.find(part);
        if (source.elements > 0 && own != shape.segmentSizes.end()) {
            source.bias = own->second.bias;
        }
        sources.push_back(source);
    }
    return sources;
}

std::vector<std::uint32_t> elementsAlong(const DrawnDomain &drawn) {
    return listOf<std::uint32_t>(drawn, &SegmentSource::elements, 0);
}

std::vector<ElementBias> biasesAlong(const DrawnDomain &drawn) {
    return listOf<ElementBias>(drawn, &SegmentSource::bias, {});
}

std::vector<PartSize> sizesAlong(const DrawnDomain &drawn) {
    return listOf<PartSize>(drawn, &SegmentSource::size, SegmentSource{}.size);
}

} // namespace forefront
