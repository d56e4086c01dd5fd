#include "app/batch/mapped_option.hpp"

#include "app/batch/region_names.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace forefront {

namespace {

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
    const RegionNames regions(job.domain);
    for (const std::string &text : texts) {
        MappedSpec spec;
        std::optional<std::int32_t> tag = regions.find(text);
        if (const std::size_t colon = text.rfind(':'); !tag && colon != std::string::npos) {
            const auto corners = places(std::string_view(text).substr(colon + 1));
            if (!corners || corners->empty()) {
                return error("bad-option", "--mapped " + text +
                                               ": expected places of corners after the colon, such as "
                                               "plate:0,0;4,0;4,1;0,1");
            }
            spec.corners = *corners;
            tag = regions.find(std::string_view(text).substr(0, colon));
        }
        if (!tag) {
            return regions.unknown("--mapped", text);
        }
        spec.region = *tag;
        std::erase_if(job.mapped, [&](const MappedSpec &own) { return own.region == spec.region; });
        job.mapped.push_back(std::move(spec));
    }
    return {};
}

} // namespace forefront
