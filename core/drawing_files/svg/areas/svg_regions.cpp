#include "core/drawing_files/svg/areas/svg_regions.hpp"

namespace forefront {

std::int32_t SvgRegions::tagOf(const std::string &name) {
    if (!name.empty()) {
        return tags_.of(name);
    }
    std::string made;
    do {
        made = "shape_" + std::to_string(++unnamed_);
    } while (reserved_.contains(made));
    return tags_.of(made);
}

std::map<std::int32_t, std::string> SvgRegions::namesIn(const Domain &domain) const {
    std::map<std::int32_t, std::string> names;
    for (const RegionMarker &marker : domain.regionMarkers) {
        if (const auto known = tags_.names().find(marker.tag); known != tags_.names().end()) {
            names.insert(*known);
        }
    }
    return names;
}

} // namespace forefront
