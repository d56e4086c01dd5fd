#pragma once

#include "core/engine/spacing/sites/size_site.hpp"
#include "core/engine/spacing/spec/spacing_sample.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace forefront {

/// The reason for a site, for the inspector.
enum class SiteReason : std::uint8_t {
    Source,         ///< index: of the size source
    PaintEdge,      ///< reach of a painted patch
    BackgroundEdge, ///< reach of a background mesh
    ExpressionEdge, ///< reach of an expression steeper than the gradation
    FunctionEdge,   ///< reach of a function steeper than the gradation
    RegionEdge,     ///< reach of a region with a maximum area; index into PlacedSizes::regions
    RegionSize,     ///< size of a region; index into PlacedSizes::regions
    PartSize,       ///< size of a boundary part; index: its tag
    SegmentSize,    ///< size along a segment; index: of the domain segment
    NodeSize,       ///< size of a node; index into PlacedSizes::nodes
    SegmentLength,  ///< index: of the domain segment
    Bend,           ///< curvature; index: of the domain segment
    Tolerance,      ///< distance of a curve from its edges; index: of the domain segment
    KeptSegment,    ///< long undivided segment; index: of the domain segment
    Channel,        ///< narrow gap across from the domain segment
    Corner,         ///< beside a sharp corner of the domain segment
    LonePoint,      ///< index: of the domain node
    AutomaticEdge   ///< edge of faces with automatic spacing beside a face with a size of its own
};

/// The part of the specification that a site comes from, and the reason for it.
struct SiteLabel {
    SpacingOrigin origin = SpacingOrigin::Source;
    SiteReason reason = SiteReason::Source;
    std::uint32_t index = 0;
};

/// Sites and their labels, in parallel arrays.
struct SiteSet {
    std::vector<SizeSite> sites;
    std::vector<SiteLabel> labels;

    void add(const SizeSite &site, const SiteLabel &label) {
        sites.push_back(site);
        labels.push_back(label);
    }
    /// Drops sites that prescribe a larger size than another site everywhere; of equal ones the first stays. If there
    /// are more than kManySites, also drops sites that prescribe only slightly smaller sizes than a remaining one.
    /// Sites must have no radius.
    void dropDominated();
};

} // namespace forefront
