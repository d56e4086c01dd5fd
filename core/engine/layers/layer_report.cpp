#include "core/engine/layers/layer_report.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/domain.hpp"

#include <algorithm>
#include <tuple>

namespace forefront {

namespace {

/// Returns the reason, as the end of the sentence "the layers have fewer rows than asked for".
std::string reasonText(LayerStop stop, const std::string &by) {
    switch (stop) {
    case LayerStop::Wall:
        return "too near to " + by;
    case LayerStop::Point:
        return "too near to a constraint point";
    case LayerStop::End:
        return "where they end beside " + by;
    case LayerStop::Fold:
        return "where the wall bends too sharply";
    case LayerStop::Meeting:
        return "where they would meet " + by;
    }
    return {};
}

} // namespace

Diagnostics shortenedLayers(const LayerReport &report, const std::map<std::int32_t, std::string> &names) {
    constexpr std::size_t kShown = 5;
    struct Group {
        std::size_t rays = 0;
        std::uint32_t fewest = 0, asked = 0;
        Vec2 first;
        std::string places;
    };
    std::map<std::tuple<std::int32_t, std::int32_t, LayerStop>, Group> groups;
    for (const ShortenedRay &ray : report.shortened) {
        Group &group = groups[{ray.tag, ray.stoppedBy, ray.stop}];
        if (group.rays == 0) {
            group.first = ray.base;
        }
        if (group.rays == 0 || ray.made < group.fewest) {
            group.fewest = ray.made;
            group.asked = ray.asked;
        }
        if (group.rays++ < kShown) {
            group.places += (group.rays == 1 ? "" : ", ") + placeText(ray.base);
        }
    }
    Diagnostics notes;
    for (const auto &[key, group] : groups) {
        const auto &[tag, by, stop] = key;
        Diagnostic note =
            error("shortened-layers", countText(group.rays, "ray") + " of the boundary layers on " +
                                          boundaryName(names, tag) + " reach fewer layers than asked for, at least " +
                                          std::to_string(group.fewest) + " of " + std::to_string(group.asked) + ", " +
                                          reasonText(stop, boundaryName(names, by)) + ": at " + group.places +
                                          (group.rays > kShown ? " and more; --stats lists all" : ""))
                .front();
        note.severity = Severity::Note;
        note.at = group.first;
        notes.push_back(std::move(note));
    }
    return notes;
}

} // namespace forefront
