#include "app/batch/part_names.hpp"

#include "core/files/common/names.hpp"

#include <vector>

namespace forefront {

PartNames::PartNames(const Domain &domain) {
    for (const DomainSegment &segment : domain.segments) {
        parts_.try_emplace(segment.tag, boundaryName(domain.boundaryNames, segment.tag));
    }
}

std::optional<std::int32_t> PartNames::find(const std::string &name) const {
    for (const auto &[tag, own] : parts_) {
        if (own == name) {
            return tag;
        }
    }
    for (const auto &[tag, own] : parts_) {
        if (boundaryName({}, tag) == name) {
            return tag;
        }
    }
    return std::nullopt;
}

Diagnostics PartNames::unknown(const char *option, const std::string &name) const {
    constexpr std::size_t kListed = 20;
    std::vector<std::string> names;
    for (const auto &[tag, own] : parts_) {
        names.push_back(own);
    }
    return error("unknown-boundary", std::string(option) + ": unknown boundary part " + name,
                 "expected one of " + listed(names, kListed));
}

} // namespace forefront
