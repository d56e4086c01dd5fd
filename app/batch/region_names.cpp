#include "app/batch/region_names.hpp"

#include "core/files/common/names.hpp"

#include <vector>

namespace forefront {

RegionNames::RegionNames(const Domain &domain) : regions_{{1, regionName(domain.regionNames, 1)}} {
    for (const RegionMarker &marker : domain.regionMarkers) {
        regions_.try_emplace(marker.tag, regionName(domain.regionNames, marker.tag));
    }
}

std::optional<std::int32_t> RegionNames::find(std::string_view name) const {
    for (const auto &[tag, own] : regions_) {
        if (own == name) {
            return tag;
        }
    }
    for (const auto &[tag, own] : regions_) {
        if (regionName({}, tag) == name) {
            return tag;
        }
    }
    return std::nullopt;
}

Diagnostics RegionNames::unknown(const char *option, const std::string &name) const {
    constexpr std::size_t kListed = 20;
    std::vector<std::string> names;
    for (const auto &[tag, own] : regions_) {
        names.push_back(own);
    }
    return error("unknown-region", std::string(option) + ": unknown region " + name,
                 "expected one of " + listed(names, kListed));
}

} // namespace forefront
