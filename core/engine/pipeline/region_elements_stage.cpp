#include "core/engine/boundary/estimate.hpp"
#include "core/engine/domain/faces.hpp"
#include "core/engine/geometry/plane_sweep.hpp"
#include "core/engine/mapped/mapped_rows.hpp"
#include "core/engine/pipeline/element_limit.hpp"
#include "core/engine/pipeline/even_counts.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/quads/even_boundary.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns the shapes of the elements of each face that is left to the front; nothing for the others.
std::vector<Elements> elementsOfFaces(const MeshingJob &job, const DiscreteDomain &boundary) {
    std::map<std::int32_t, Elements> given;
    for (const RegionElements &region : job.regionElements) {
        given.emplace(region.region, region.elements);
    }
    std::vector<Elements> elements;
    for (const DiscreteRegion &region : boundary.regions) {
        const auto own = given.find(region.tag);
        elements.push_back(own == given.end() ? job.options.elements : own->second);
    }
    return elements;
}

/// Returns the shapes that the faces beside the segments of a front have.
std::set<Elements> shapesOf(const DiscreteDomain &front, const std::vector<Elements> &elements) {
    std::set<Elements> shapes;
    for (const DiscreteSegment &s : front.segments) {
        for (const std::uint32_t region : {s.leftRegion, s.rightRegion}) {
            if (region != kOutside) {
                shapes.insert(elements[region]);
            }
        }
    }
    return shapes;
}

/// Returns the region of each point of a front; kOutside for those on segments.
std::vector<std::uint32_t> regionsOfPoints(const DiscreteDomain &front) {
    std::vector<PlaneEdge> edges;
    for (const DiscreteSegment &s : front.segments) {
        edges.push_back({s.a, s.b});
    }
    const Faces faces = findFaces(front.nodes, edges, sweepPlane(front.nodes, edges));
    std::vector<std::uint32_t> ofFace(faces.count, kOutside), regions;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        ofFace[faces.left[i]] = front.segments[i].leftRegion;
        ofFace[faces.right[i]] = front.segments[i].rightRegion;
    }
    for (const ConstraintPoint &point : front.points) {
        const std::uint32_t face = faces.ofPoint[point.node];
        regions.push_back(face == kNoIndex ? kOutside : ofFace[face]);
    }
    return regions;
}

/// Returns the boundary of the faces with one shape of elements, with the points in them. `points`: their regions.
DiscreteDomain partWith(const DiscreteDomain &front, const std::vector<std::uint32_t> &points,
                        const std::vector<Elements> &elements, Elements shape) {
    DiscreteDomain part = front;
    part.points.clear();
    part.gradedNodes = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (points[k] == kOutside || elements[points[k]] == shape) {
            part.points.push_back(front.points[k]);
            part.gradedNodes += k < front.taggedPoints().size() ? 0 : 1;
        }
    }
    part.segments.clear();
    part.stretches.clear();
    for (std::size_t i = 0; i < front.segments.size(); ++i) {
        DiscreteSegment s = front.segments[i];
        for (std::uint32_t *const region : {&s.leftRegion, &s.rightRegion}) {
            *region = *region != kOutside && elements[*region] == shape ? *region : kOutside;
        }
        if (s.leftRegion == kOutside && s.rightRegion == kOutside) {
            continue;
        }
        part.segments.push_back(s);
        if (!front.stretches.empty()) {
            part.stretches.push_back(front.stretches[i]);
        }
    }
    return part;
}

/// Meshes a part of the boundary with one shape of elements, and adds what it has to the rows that are there.
Status addPart(const MeshingState &state, DiscreteDomain part, Elements shape, BoundaryLayers &rows, QuadReport &report,
               const Progress &progress) {
    MeshingJob job = state.meshed();
    job.options.elements = shape;
    MeshingState own{.job = job};
    own.prepared = state.prepared;
    own.prepared.strips = nullptr;
    own.prepared.estimatedElements = part.estimatedElements = estimateElements(part, *state.prepared.spacing);
    BoundaryLayers alone; // its edges stay, as those beside layers do
    alone.outer = std::make_shared<const DiscreteDomain>(std::move(part));
    own.prepared.layers = std::make_shared<const BoundaryLayers>(std::move(alone));
    for (const std::span<const Stage> stages : {stagesOfFront(), stagesOfShapes()}) {
        if (Status faults = runStages(stages, own, progress); !faults.empty()) {
            return faults;
        }
    }
    // Nodes that only lead the front to its size may have moved: they become inner nodes, in place of those that were
    // given.
    const std::vector<Vec2> &given = own.prepared.frontBoundary()->nodes;
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t n = 0; n < own.mesh.nodes.size(); ++n) {
        const bool stays = n < given.size() && own.mesh.nodes[n] == given[n];
        numbers.push_back(stays ? n : static_cast<std::uint32_t>(given.size() + rows.inner.size()));
        if (!stays) {
            rows.inner.push_back(own.mesh.nodes[n]);
        }
    }
    std::map<std::int32_t, std::uint32_t> regions;
    const std::vector<DiscreteRegion> &known = state.prepared.boundary->regions;
    for (std::uint32_t r = 0; r < known.size(); ++r) {
        regions.emplace(known[r].tag, r);
    }
    const MeshView view(own.mesh);
    for (std::size_t e = 0; e < view.elementCount(); ++e) {
        LayerCell &cell = rows.cells.emplace_back();
        cell.nodes.fill(kNoIndex);
        std::size_t k = 0;
        for (const NodeId node : view.nodesOf(e)) {
            cell.nodes[k++] = numbers[index(node)];
        }
        cell.region = regions.at(view.region(e));
    }
    if (shape != Elements::Triangles) {
        addReport(report, own.quadReport);
    }
    return {};
}

/// Makes all cycles of edges even where a region has quadrilaterals alone.
void makeEven(MeshingState &state, const std::set<Elements> &shapes) {
    const MeshingJob &job = state.meshed();
    if (!shapes.contains(Elements::Quads) || job.options.keepBoundary || state.prepared.layers) {
        return; // the edges of layers must stay; mapped faces have made the others even
    }
    const std::vector<std::uint32_t> kept = countsWithPeriodic(job, *state.prepared.boundary);
    const ColouredBoundary even =
        colourBoundary(*state.prepared.boundary, *state.prepared.spacing, {&job.domain, kept, true});
    if (even.added > 0) {
        state.prepared.boundary = std::make_shared<const DiscreteDomain>(even.domain);
    }
}

} // namespace

void addReport(QuadReport &whole, const QuadReport &part) {
    whole.rows += part.rows;
    whole.openings += part.openings;
    whole.closings += part.closings;
    whole.searched += part.searched;
    whole.lattice = whole.lattice || part.lattice;
    whole.addedNodes += part.addedNodes;
    whole.oddEdges += part.oddEdges;
    whole.changes += part.changes;
    whole.triangles += part.triangles;
    whole.quadrilaterals += part.quadrilaterals;
    whole.notConvex += part.notConvex;
    whole.notConvexAt.insert(whole.notConvexAt.end(), part.notConvexAt.begin(), part.notConvexAt.end());
    whole.trianglesAt.insert(whole.trianglesAt.end(), part.trianglesAt.begin(), part.trianglesAt.end());
    whole.irregularNodes += part.irregularNodes;
    whole.innerNodes += part.innerNodes;
}

Status regionElementsStage(MeshingState &state, const Progress &progress) {
    const MeshingJob &job = state.meshed();
    if (job.regionElements.empty()) {
        return {};
    }
    const std::vector<Elements> elements = elementsOfFaces(job, *state.prepared.boundary);
    const std::set<Elements> shapes = shapesOf(*state.prepared.frontBoundary(), elements);
    makeEven(state, shapes);
    const DiscreteDomain front = *state.prepared.frontBoundary();
    const std::vector<std::uint32_t> points = regionsOfPoints(front);
    BoundaryLayers rows = state.prepared.layers ? *state.prepared.layers : BoundaryLayers();
    for (const Elements shape : shapes) {
        if (shape == job.options.elements) {
            continue;
        }
        if (Status faults =
                addPart(state, partWith(front, points, elements, shape), shape, rows, state.prepared.quads, progress);
            !faults.empty()) {
            return faults;
        }
    }
    rows.outer = std::make_shared<const DiscreteDomain>(partWith(front, points, elements, job.options.elements));
    state.prepared.layers = std::make_shared<const BoundaryLayers>(std::move(rows));
    return {};
}

} // namespace forefront
