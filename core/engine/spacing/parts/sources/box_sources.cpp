#include "core/engine/spacing/parts/sources/box_sources.hpp"

#include <algorithm>
#include <limits>

namespace forefront {

std::optional<BoxSources> BoxSources::build(std::span<const SizeSource> sources, double minimum, double gradation,
                                            const Box2 &box) {
    BoxSources part;
    part.minimum_ = part.maximum_ = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = 0; k < sources.size(); ++k) {
        const SizeSource &source = sources[k];
        if (source.shape != SourceShape::Box) {
            continue;
        }
        // Where the minimum cuts the spacing off, the distance to the box's neighbourhood counts: see limited().
        const bool raised = source.size < minimum && source.growth > 0.0;
        const Entry entry{SourceBox(source), std::max(source.size, minimum), std::min(source.growth, gradation),
                          source.radius + (raised ? (minimum - source.size) / source.growth : 0.0), k};
        part.minimum_ =
            std::min(part.minimum_, std::max(entry.size, entry.at(box.centre()) - entry.growth * 0.5 * box.diagonal()));
        double greatest = entry.size; // at a corner, since the distance to a convex shape is convex
        for (const Vec2 corner : {box.min, box.max, Vec2{box.min.x, box.max.y}, Vec2{box.max.x, box.min.y}}) {
            greatest = std::max(greatest, entry.at(corner));
        }
        part.maximum_ = std::min(part.maximum_, greatest);
        part.entries_.push_back(entry);
    }
    return part.entries_.empty() ? std::nullopt : std::optional(std::move(part));
}

double BoxSources::at(Vec2 p) const {
    double rho = std::numeric_limits<double>::infinity();
    for (const Entry &entry : entries_) {
        rho = std::min(rho, entry.at(p));
    }
    return rho;
}

SpacingSample BoxSources::sample(Vec2 p, const SiteWords &words) const {
    const auto winner = std::min_element(entries_.begin(), entries_.end(),
                                         [p](const Entry &a, const Entry &b) { return a.at(p) < b.at(p); });
    SpacingSample sample{winner->at(p), SpacingOrigin::Source, winner->source, sourceWords(words, winner->source)};
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
        if (entry != winner && (!sample.runnerUp || entry->at(p) < sample.runnerUp->rho)) {
            sample.runnerUp = SpacingRunnerUp{entry->at(p), sourceWords(words, entry->source)};
        }
    }
    return sample;
}

} // namespace forefront
