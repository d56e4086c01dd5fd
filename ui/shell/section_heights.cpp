#include "ui/shell/section_heights.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace forefront::shell {

namespace {

float leastOf(const Section &section, const SectionMeasures &measures) {
    return section.content > 0.0F ? std::min(section.content, measures.lowest) : measures.lowest;
}

/// Returns the height that is left for contents, and below zero if even the least heights do not fit.
float spareOf(const std::vector<Section> &sections, const SectionMeasures &measures, float height) {
    for (const Section &section : sections) {
        height -= measures.heading + (section.open ? measures.gap + leastOf(section, measures) : 0.0F);
    }
    return height;
}

/// Returns how much more than their least heights the sections that come first need to be whole.
float neededByFirst(const std::vector<Section> &sections, const SectionMeasures &measures) {
    float needed = 0.0F;
    for (const Section &section : sections) {
        needed += section.open && section.first ? std::max(0.0F, section.content - leastOf(section, measures)) : 0.0F;
    }
    return needed;
}

/// Raises contents together until they are whole or the spare height is used up.
void growTogether(const std::vector<Section> &sections, std::vector<std::size_t> &growing, std::vector<float> &heights,
                  float &spare) {
    while (spare > 0.5F && !growing.empty()) {
        const float share = spare / static_cast<float>(growing.size());
        for (const std::size_t k : growing) {
            const float added = std::min(share, sections[k].content - heights[k]);
            heights[k] += added;
            spare -= added;
        }
        std::erase_if(growing, [&](std::size_t k) { return heights[k] >= sections[k].content - 0.5F; });
    }
}

} // namespace

std::vector<float> sectionHeights(std::vector<Section> &sections, const SectionMeasures &measures, float height) {
    float spare = spareOf(sections, measures, height);
    const float needed = measures.wholeFirst ? neededByFirst(sections, measures) : 0.0F;
    auto open = std::count_if(sections.begin(), sections.end(), [](const Section &section) { return section.open; });
    for (auto section = sections.rbegin(); spare < needed && section != sections.rend() && open > 1; ++section) {
        if (section->open && !section->keepsOpen) {
            --open;
            section->open = false;
            spare = spareOf(sections, measures, height);
        }
    }
    std::vector<float> heights;
    std::transform(sections.begin(), sections.end(), std::back_inserter(heights),
                   [&](const Section &section) { return section.open ? leastOf(section, measures) : 0.0F; });
    if (spare < 0.0F && open == 1) { // a low column shows less of a single section rather than all of it out of sight
        constexpr float kShare = 0.5F;
        for (float &each : heights) {
            each = std::min(each, std::max(each + spare, kShare * measures.lowest));
        }
    }
    for (const bool first : {true, false}) {
        std::vector<std::size_t> growing;
        for (std::size_t k = 0; k < sections.size(); ++k) {
            if (sections[k].open && sections[k].first == first && sections[k].content > heights[k]) {
                growing.push_back(k);
            }
        }
        growTogether(sections, growing, heights, spare);
    }
    return heights;
}

} // namespace forefront::shell
