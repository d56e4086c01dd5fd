#include "core/drawing/domain/divide_joined.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/domain/draw_shapes.hpp"
#include "core/drawing/domain/drawn_domain.hpp"
#include "core/drawing/domain/given_sizes.hpp"
#include "core/drawing/domain/join_neighbours.hpp"
#include "core/drawing/domain/refine_chords.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <unordered_set>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// The domain of a document while it is made, with what is given for its segments.
struct BuiltDomain {
    /// `wanted` may be null.
    BuiltDomain(const Document &document, DomainSources *wanted) : given(document) {
        drawn.sources = wanted != nullptr || !given.any() ? wanted : &own;
        drawShapes(document, drawn, given);
        for (const MarkedRegion &region : document.regionMarkers) {
            drawn.domain.regionMarkers.push_back({region.at, region.tag});
        }
        drawn.domain.boundaryNames = document.boundaryNames;
        drawn.domain.regionNames = document.regionNames;
        drawn.domain.curveTolerance = document.curveTolerance;
        divideJoined(drawn, given);
        joinNeighbours(document, drawn, given);
        if (drawn.flattened) {
            refineMeetingChords(drawn.domain, drawn.sources);
        }
    }
    BuiltDomain(const BuiltDomain &) = delete;
    BuiltDomain &operator=(const BuiltDomain &) = delete;

    DomainSources own; ///< where nobody else wants the sources
    GivenSizes given;
    DrawnDomain drawn;
};

/// Returns the sizes of the nodes and regions of a document.
PlacedSizes placedSizes(const Document &document) {
    PlacedSizes placed;
    for (const auto &shape : document.shapes) {
        const bool sized = !shape->nodeSizes.empty() && !shape->construction;
        const std::vector<Vec2> handles = sized ? handlesOf(*shape) : std::vector<Vec2>();
        for (const auto &[node, part] : shape->nodeSizes) {
            if (node < handles.size()) {
                placed.nodes.push_back({handles[node], part.size, part.growth, nodeName(*shape, node)});
            }
        }
    }
    for (const MarkedRegion &region : document.regionMarkers) {
        if (region.maxArea != 0.0 || region.size != 0.0) {
            placed.regions.push_back(region.sizes());
        }
    }
    return placed;
}

/// Adds what the boundary parts and regions of a document are to become, such as layers, to its job. A deleted part may
/// have left its layers, its periodic partner, its crack, its strip or its rows, as it may its size.
void addRoles(const Document &document, MeshingJob &job) {
    std::unordered_set<std::int32_t> tags, regions{1};
    for (const DomainSegment &segment : job.domain.segments) {
        tags.insert(segment.tag);
    }
    for (const MarkedRegion &marker : document.regionMarkers) {
        regions.insert(marker.tag);
    }
    const auto present = [&](std::int32_t tag) { return tags.contains(tag); };
    std::copy_if(document.layers.begin(), document.layers.end(), std::back_inserter(job.layers),
                 [&](const LayerSpec &layer) { return present(layer.tag); });
    std::copy_if(document.periodic.begin(), document.periodic.end(), std::back_inserter(job.periodic),
                 [&](const PeriodicSpec &spec) { return present(spec.from) && present(spec.to); });
    std::copy_if(document.cracks.begin(), document.cracks.end(), std::back_inserter(job.cracks), present);
    std::copy_if(document.strips.begin(), document.strips.end(), std::back_inserter(job.strips),
                 [&](const StripSpec &spec) { return present(spec.tag); });
    std::copy_if(document.mapped.begin(), document.mapped.end(), std::back_inserter(job.mapped),
                 [&](const MappedSpec &spec) { return regions.contains(spec.region); });
    std::copy_if(document.regionElements.begin(), document.regionElements.end(), std::back_inserter(job.regionElements),
                 [&](const RegionElements &own) { return regions.contains(own.region); });
}

} // namespace

Domain toDomain(const Document &document) {
    return std::move(BuiltDomain(document, nullptr).drawn.domain);
}

Domain toDomain(const Document &document, DomainSources &sources) {
    return std::move(BuiltDomain(document, &sources).drawn.domain);
}

SpacingSpec spacingOf(const Document &document) {
    if (!document.elementCounts.empty() || hasSegmentSizes(document)) {
        return jobOf(document).spacing;
    }
    SpacingSpec spacing = rulesOf(document);
    spacing.placed = placedSizes(document);
    return spacing;
}

MeshingJob jobOf(const Document &document) {
    BuiltDomain built(document, nullptr);
    PlacedSizes placed = placedSizes(document);
    placed.elements = built.given.elements(built.drawn);
    placed.biases = built.given.biases(built.drawn);
    placed.segments = built.given.sizes(built.drawn);
    MeshingJob job{std::move(built.drawn.domain), rulesOf(document), document.options};
    job.spacing.placed = std::move(placed);
    addRoles(document, job);
    return job;
}

} // namespace forefront
