#include "core/drawing/domain/divide_joined.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/domain/draw_shapes.hpp"
#include "core/drawing/domain/drawn_domain.hpp"
#include "core/drawing/domain/given_sizes.hpp"
#include "core/drawing/domain/join_neighbours.hpp"
#include "core/drawing/domain/part_settings.hpp"
#include "core/drawing/domain/refine_chords.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/same_place.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/validate.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// The domain of a document while it is made, with what is given for its segments.
struct BuiltDomain {
    /// `wanted` may be null.
    BuiltDomain(const Document &document, DomainSources *wanted) {
        const GivenSizes given(document);
        drawn.sources = wanted != nullptr || !given.needsSources() ? wanted : &own;
        const double samePlace = samePlaceDistance(document);
        build(document, given, samePlace);
        if (drawn.farthest > kRounding * samePlace && !validate(drawn.domain).empty()) {
            keepApart(document, given, kRounding * samePlace);
        }
    }
    BuiltDomain(const BuiltDomain &) = delete;
    BuiltDomain &operator=(const BuiltDomain &) = delete;

    DomainSources own; ///< where nobody else wants the sources
    DrawnDomain drawn;

  private:
    /// What is at the same place up to the rounding of coordinates, as a fraction of samePlaceDistance().
    static constexpr double kRounding = 1e-4;

    void build(const Document &document, const GivenSizes &given, double samePlace) {
        drawn.samePlace = samePlace;
        drawShapes(document, drawn, given);
        for (const MarkedRegion &region : document.regionMarkers) {
            drawn.domain.regionMarkers.push_back({region.at, region.tag});
        }
        drawn.domain.boundaryNames = document.boundaryNames;
        drawn.domain.regionNames = document.regionNames;
        drawn.domain.curveTolerance = document.curveTolerance;
        divideJoined(document, drawn);
        joinNeighbours(document, drawn);
        if (drawn.flattened) {
            refineMeetingChords(drawn.domain, drawn.sources);
        }
    }

    /// Builds a domain anew whose shapes are joined only where they meet up to rounding, and takes it if it is valid:
    /// details as small as the distance within which places are the same cannot all be joined.
    void keepApart(const Document &document, const GivenSizes &given, double samePlace) {
        DomainSources *const sources = drawn.sources;
        DomainSources keptSources = sources != nullptr ? std::exchange(*sources, {}) : DomainSources();
        DrawnDomain kept = std::exchange(drawn, {});
        drawn.sources = sources;
        build(document, given, samePlace);
        if (drawn.farthest > kRounding * samePlace && !validate(drawn.domain).empty()) {
            drawn = std::move(kept);
            if (sources != nullptr) {
                *sources = std::move(keptSources);
            }
        }
    }
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
    placed.elements = elementsAlong(built.drawn);
    placed.biases = biasesAlong(built.drawn);
    placed.segments = sizesAlong(built.drawn);
    MeshingJob job{std::move(built.drawn.domain), rulesOf(document), document.options};
    job.spacing.placed = std::move(placed);
    job.findings = std::move(built.drawn.findings);
    addPartSettings(document, job);
    std::stable_partition(job.findings.begin(), job.findings.end(),
                          [](const Diagnostic &finding) { return finding.severity == Severity::Error; });
    return job;
}

} // namespace forefront
