#pragma once

#include "core/spacing/sites/size_site.hpp"
#include "core/spacing/spec/spacing_origin.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace forefront {

/// Why a site is there, for the inspector.
enum class SiteReason : std::uint8_t {
    Source,         ///< index: of the size source
    PaintEdge,      ///< reach of a painted patch
    BackgroundEdge, ///< reach of a background mesh
    ExpressionEdge, ///< reach of an expression steeper than the gradation
    SegmentLength,  ///< index: of the domain segment
    Channel,        ///< narrow gap across from the domain segment
    Corner,         ///< beside a sharp corner of the domain segment
    LonePoint       ///< index: of the domain node
};

struct SiteLabel {
    SpacingOrigin origin = SpacingOrigin::Source;
    SiteReason reason = SiteReason::Source;
    std::uint32_t index = 0;
};

/// Sites and, in step with them, their labels.
struct SiteSet {
    std::vector<SizeSite> sites;
    std::vector<SiteLabel> labels;

    void add(const SizeSite &site, const SiteLabel &label) {
        sites.push_back(site);
        labels.push_back(label);
    }
    /// Drops sites that another one undercuts everywhere; of equal ones the first stays. For sites without radius.
    void dropDominated();
};

} // namespace forefront
