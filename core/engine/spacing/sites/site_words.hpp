#pragma once

#include "core/engine/spacing/sites/site_set.hpp"
#include "core/engine/spacing/spec/spacing_sample.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace forefront {

/// Names that descriptions of sites refer to.
struct SiteWords {
    std::vector<std::string> sources;                  ///< by index into SpacingSpec::sources; may be empty strings
    std::vector<std::string> regions;                  ///< names, by index into PlacedSizes::regions
    std::vector<std::string> nodes;                    ///< names, by index into PlacedSizes::nodes
    std::map<std::uint32_t, std::string> parts;        ///< names of boundary parts with a size, by tag
    std::vector<std::int32_t> segmentTags;             ///< by index into Domain::segments
    std::map<std::int32_t, std::string> boundaryNames; ///< as in Domain
};

/// Describes a size source: "source 'pier head'".
std::string sourceWords(const SiteWords &words, std::uint32_t source);

/// Returns the spacing at p as set by one site.
SpacingSample sampleSite(const SizeSite &site, const SiteLabel &label, const SiteWords &words, Vec2 p);

} // namespace forefront
