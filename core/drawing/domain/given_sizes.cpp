#include "core/drawing/domain/given_sizes.hpp"

#include "core/drawing/shapes/segment_sizes.hpp"

#include <cstddef>

namespace forefront {

GivenSizes::GivenSizes(const Document &document)
    : document_(document), counted_(countedParts(document)), any_(!counted_.empty() || hasSegmentSizes(document)) {}

void GivenSizes::add(const Shape &shape, std::uint32_t number, const Outline &outline) {
    const std::vector<PartSize> parts = sizesOfParts(shape);
    for (std::size_t segment = 0; !parts.empty() && segment < outline.segmentCount(); ++segment) {
        sizes_[number].push_back(parts[outline.part(segment)]);
    }
    addCounts(shape, number, outline);
}

void GivenSizes::addCounts(const Shape &shape, std::uint32_t number, const Outline &outline) {
    const std::vector<std::uint32_t> parts = elementsOfParts(document_, shape, counted_);
    if (parts.empty()) {
        return;
    }
    std::vector<std::uint32_t> &counts = counts_[number];
    for (std::size_t segment = 0; segment < outline.segmentCount(); ++segment) {
        const std::size_t part = outline.part(segment);
        counts.push_back(part < parts.size() ? parts[part] : 0);
        parts_[number].push_back(static_cast<std::uint32_t>(part));
    }
}

std::uint32_t GivenSizes::elementsOf(const DrawnDomain &drawn, std::uint32_t segment) const {
    if (segment < drawn.shares.size() && drawn.shares[segment] != 0) {
        return drawn.shares[segment];
    }
    const auto [shape, part] = drawn.sources->segments[segment];
    const auto found = counts_.find(shape);
    return found != counts_.end() ? found->second[part] : 0;
}

ElementBias GivenSizes::biasOf(const DrawnDomain &drawn, std::uint32_t segment) const {
    const auto [number, part] = drawn.sources->segments[segment];
    const Shape &shape = *document_.shapes[number];
    if (elementsOf(drawn, segment) == 0 || shape.segmentSizes.empty()) {
        return {};
    }
    const auto own = shape.segmentSizes.find(parts_.at(number)[part]);
    return own != shape.segmentSizes.end() ? own->second.bias : ElementBias{};
}

PartSize GivenSizes::sizeOf(const DrawnDomain &drawn, std::uint32_t segment) const {
    const auto [shape, part] = drawn.sources->segments[segment];
    const auto found = sizes_.find(shape);
    return found != sizes_.end() ? found->second[part] : PartSize{0.0, 0.0};
}

std::vector<std::uint32_t> GivenSizes::elements(const DrawnDomain &drawn) const {
    std::vector<std::uint32_t> list;
    for (std::size_t s = 0; drawn.sources != nullptr && s < drawn.sources->segments.size(); ++s) {
        if (const std::uint32_t count = elementsOf(drawn, static_cast<std::uint32_t>(s)); count > 0) {
            list.resize(drawn.sources->segments.size());
            list[s] = count;
        }
    }
    return list;
}

std::vector<ElementBias> GivenSizes::biases(const DrawnDomain &drawn) const {
    std::vector<ElementBias> list;
    for (std::size_t s = 0; drawn.sources != nullptr && s < drawn.sources->segments.size(); ++s) {
        if (const ElementBias bias = biasOf(drawn, static_cast<std::uint32_t>(s)); bias.any()) {
            list.resize(drawn.sources->segments.size());
            list[s] = bias;
        }
    }
    return list;
}

std::vector<PartSize> GivenSizes::sizes(const DrawnDomain &drawn) const {
    std::vector<PartSize> list;
    for (std::size_t s = 0; drawn.sources != nullptr && s < drawn.sources->segments.size(); ++s) {
        if (const PartSize size = sizeOf(drawn, static_cast<std::uint32_t>(s)); size.size > 0.0) {
            list.resize(drawn.sources->segments.size(), PartSize{0.0, 0.0});
            list[s] = size;
        }
    }
    return list;
}

} // namespace forefront
