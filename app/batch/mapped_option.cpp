#include "app/batch/mapped_option.hpp"

#include "core/files/common/names.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>

namespace forefront {

namespace {

/// Returns the names of the regions of a domain; faces without a marker have the tag 1.
std::map<std::int32_t, std::string> regionsOf(const Domain &domain) {
    std::map<std::int32_t, std::string> names{{1, regionName(domain.regionNames, 1)}};
    for (const RegionMarker &marker : domain.regionMarkers) {
        names.try_emplace(marker.tag, regionName(domain.regionNames, marker.tag));
    }
    return names;
}

std::optional<std::int32_t> findRegion(const std::map<std::int32_t, std::string> &regions, std::string_view name) {
    for (const auto &[tag, own] : regions) {
        if (own == name) {
            return tag;
        }
    }
    for (const auto &[tag, own] : regions) {
        if (regionName({}, tag) == name) {
            return tag;
        }
    }
    return std::nullopt;
}

std::optional<double> coordinate(std::string_view text) {
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Parses places such as "0,0;4,0;4,1". Returns nothing if the text is none.
std::optional<std::vector<Vec2>> places(std::string_view text) {
    std::vector<Vec2> found;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view one = text.substr(0, end);
        const std::size_t comma = one.find(',');
        if (comma == std::string_view::npos) {
            return std::nullopt;
        }
        const auto x = coordinate(one.substr(0, comma)), y = coordinate(one.substr(comma + 1));
        if (!x || !y) {
            return std::nullopt;
        }
        found.push_back({*x, *y});
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return found;
}

} // namespace

void addMappedOption(CLI::App &app, std::vector<std::string> &texts) {
    app.add_option("--mapped", texts,
                   "fill each face of the region NAME by rows of elements between opposite sides, which get equal "
                   "numbers of elements; its 3 or 4 corners are the sharpest nodes, or those given, as in "
                   "plate:0,0;4,0;4,1;0,1; can be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME[:X,Y;...]");
}

Diagnostics applyMapped(const std::vector<std::string> &texts, MeshingJob &job) {
    const std::map<std::int32_t, std::string> regions = regionsOf(job.domain);
    for (const std::string &text : texts) {
        MappedSpec spec;
        std::optional<std::int32_t> tag = findRegion(regions, text);
        if (const std::size_t colon = text.rfind(':'); !tag && colon != std::string::npos) {
            const auto corners = places(std::string_view(text).substr(colon + 1));
            if (!corners || corners->empty()) {
                return error("bad-option", "--mapped " + text +
                                               ": expected places of corners after the colon, such as "
                                               "plate:0,0;4,0;4,1;0,1");
            }
            spec.corners = *corners;
            tag = findRegion(regions, std::string_view(text).substr(0, colon));
        }
        if (!tag) {
            constexpr std::size_t kListed = 20;
            std::vector<std::string> names;
            for (const auto &[region, name] : regions) {
                names.push_back(name);
            }
            return error("unknown-region", "--mapped: unknown region " + text,
                         "expected one of " + listed(names, kListed));
        }
        spec.region = *tag;
        std::erase_if(job.mapped, [&](const MappedSpec &own) { return own.region == spec.region; });
        job.mapped.push_back(std::move(spec));
    }
    return {};
}

} // namespace forefront
