#include "app/batch/named_tags.hpp"

#include "app/batch/suggestion.hpp"
#include "core/files/common/names.hpp"

namespace forefront {

namespace {

std::vector<std::int32_t> tagsNamed(const std::map<std::int32_t, std::string> &names, std::string_view name) {
    std::vector<std::int32_t> found;
    for (const auto &[tag, own] : names) {
        if (own == name) {
            found.push_back(tag);
        }
    }
    return found;
}

} // namespace

NamedTags NamedTags::ofParts(const Domain &domain) {
    NamedTags parts;
    for (const DomainSegment &segment : domain.segments) {
        if (parts.names_.try_emplace(segment.tag, boundaryName(domain.boundaryNames, segment.tag)).second) {
            parts.defaults_.emplace(segment.tag, boundaryName({}, segment.tag));
        }
    }
    return parts;
}

NamedTags NamedTags::ofRegions(const Domain &domain) {
    NamedTags regions;
    regions.kind_ = "region";
    regions.code_ = "unknown-region";
    const auto add = [&](std::int32_t tag) {
        regions.names_.try_emplace(tag, regionName(domain.regionNames, tag));
        regions.defaults_.try_emplace(tag, regionName({}, tag));
    };
    add(1);
    for (const RegionMarker &marker : domain.regionMarkers) {
        add(marker.tag);
    }
    return regions;
}

std::vector<std::int32_t> NamedTags::all(std::string_view name) const {
    std::vector<std::int32_t> found = tagsNamed(names_, name);
    return found.empty() ? tagsNamed(defaults_, name) : found;
}

std::optional<std::int32_t> NamedTags::find(std::string_view name) const {
    const std::vector<std::int32_t> found = all(name);
    return found.empty() ? std::nullopt : std::optional(found.front());
}

Diagnostics NamedTags::unknown(const char *option, std::string_view name) const {
    constexpr std::size_t kListed = 20;
    std::vector<std::string> names;
    for (const auto &[tag, own] : names_) {
        names.push_back(own);
    }
    const std::vector<std::string_view> words(names.begin(), names.end());
    return error(code_, std::string(option) + ": unknown " + kind_ + ' ' + std::string(name) + suggestion(name, words),
                 "expected one of " + listed(names, kListed));
}

} // namespace forefront
