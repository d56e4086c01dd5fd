#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/chain_shape.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/hole_markers.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/engine/domain/chains/chain_order.hpp"
#include "core/engine/domain/chains/segment_chains.hpp"

#include <algorithm>
#include <utility>

namespace forefront {
namespace {

std::shared_ptr<const Shape> pointShape(Vec2 at, ShapeUse use, std::int32_t tag, std::uint32_t id) {
    auto shape = std::make_shared<Shape>();
    shape->id = id;
    shape->form = PointForm{};
    shape->use = use;
    shape->nodes = {at};
    shape->tag = tag;
    return shape;
}

void addPoints(const Domain &domain, Document &document) {
    std::vector<bool> used(domain.nodes.size(), false);
    for (const DomainSegment &segment : domain.segments) {
        if (segment.a < used.size() && segment.b < used.size()) {
            used[segment.a] = used[segment.b] = true;
        }
    }
    for (const ConstraintPoint &point : domain.points) {
        if (point.node < used.size()) {
            used[point.node] = true;
            document.shapes.push_back(
                pointShape(domain.nodes[point.node], ShapeUse::Constraint, point.tag, document.nextId++));
        }
    }
    // An unreferenced node stays visible, and validation reports it; it is not dropped silently.
    for (std::size_t node = 0; node < used.size(); ++node) {
        if (!used[node]) {
            document.shapes.push_back(pointShape(domain.nodes[node], ShapeUse::Boundary, 1, document.nextId++));
        }
    }
}

void addChains(const Domain &domain, LooseEnds ends, Document &document) {
    const ChainPaths paths(domain, ends);
    for (const SegmentRole role : {SegmentRole::Boundary, SegmentRole::Constraint}) {
        for (const SegmentChain &chain : segmentChains(domain, role)) {
            Shape shape = shapeOf(paths.make(chain.nodes, chain.segments, chain.closed));
            shape.id = document.nextId++;
            shape.use = role == SegmentRole::Boundary ? ShapeUse::Boundary : ShapeUse::Constraint;
            document.shapes.push_back(std::make_shared<const Shape>(std::move(shape)));
        }
    }
}

Document fromEvenOdd(const Domain &domain, LooseEnds ends) {
    Document document;
    addChains(domain, ends, document);
    addPoints(domain, document);
    for (const RegionMarker &marker : domain.regionMarkers) {
        document.regionMarkers.push_back({marker.at, marker.tag});
    }
    document.boundaryNames = domain.boundaryNames;
    document.regionNames = domain.regionNames;
    document.curveTolerance = domain.curveTolerance;
    return document;
}

/// Gives regions their sizes; one without a marker at its place gets one.
void takeRegionSizes(const std::vector<RegionSize> &sizes, std::vector<MarkedRegion> &regions) {
    auto next = regions.begin();
    for (const RegionSize &size : sizes) { // usually in the order of the markers
        auto found =
            std::find_if(next, regions.end(), [&](const MarkedRegion &region) { return region.at == size.at; });
        if (found == regions.end()) {
            found = std::ranges::find(regions, size.at, &MarkedRegion::at);
        }
        const std::int32_t tag = found != regions.end() ? found->tag : 1;
        if (found == regions.end() || found->maxArea != 0.0 || found->size != 0.0) {
            found = regions.insert(regions.end(), MarkedRegion{size.at, tag});
        }
        *found = {size.at, tag, size.maxArea, size.size, size.growth};
        next = found + 1;
    }
}

} // namespace

Document fromDomain(const Domain &domain, LooseEnds ends) {
    return domain.insideRule == InsideRule::HoleMarkers ? fromEvenOdd(withEvenOddRoles(domain), ends)
                                                        : fromEvenOdd(domain, ends);
}

Document fromDomain(const Domain &domain) {
    if (domain.insideRule == InsideRule::HoleMarkers) {
        return fromDomain(withEvenOddRoles(domain));
    }
    return fromEvenOdd(domain, bestLooseEnds(domain));
}

Document fromDomain(const DomainFile &file) {
    Document document = fromDomain(file.domain);
    document.unit = file.unit;
    document.spacing = file.spacing;
    document.spacing.placed = {};
    document.cracks = file.cracks;
    document.periodic = file.periodic;
    takeRegionSizes(file.spacing.placed.regions, document.regionMarkers);
    for (const NodeSize &node : file.spacing.placed.nodes) {
        for (std::shared_ptr<const Shape> &shape : document.shapes) {
            Shape sized = *shape;
            if (giveSize(sized, node.at, {node.size, node.growth}, 0.0)) {
                shape = std::make_shared<const Shape>(std::move(sized));
            }
        }
    }
    return document;
}

} // namespace forefront
