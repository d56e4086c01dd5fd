#include "core/drawing/shapes/tag_runs.hpp"

namespace forefront {

std::vector<TagRun> tagRuns(const Shape &shape, const Outline &outline) {
    const std::size_t segments = outline.segmentCount();
    const auto tagOf = [&](std::size_t k) { return segmentTag(shape, outline.part(k % segments)); };
    std::size_t begin = 0;
    while (outline.closed && begin < segments && tagOf(begin) == tagOf(begin + segments - 1)) {
        ++begin;
    }
    begin = begin < segments ? begin : 0; // a single run begins at the first node
    std::vector<TagRun> runs;
    for (std::size_t k = 0; k < segments; ++k) {
        const std::int32_t tag = tagOf(begin + k);
        if (runs.empty() || runs.back().tag != tag) {
            runs.push_back({tag, (begin + k) % segments, 0});
        }
        ++runs.back().count;
    }
    return runs;
}

} // namespace forefront
