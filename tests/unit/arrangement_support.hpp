#pragma once

#include "core/drawing/arrangement/arrangement.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/validate.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront::testing {

/// Returns the corners of a rectangle, counter-clockwise.
inline std::vector<Vec2> rectangle(double x, double y, double width, double height) {
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// Adds a feature of one polygon.
inline void addPolygon(ArrangementInput &input, std::int32_t tag, const std::vector<std::vector<Vec2>> &rings,
                       const std::string &name = {}) {
    const std::uint32_t shape = input.addShape(input.addFeature(tag, name));
    for (const std::vector<Vec2> &ring : rings) {
        input.addRing(input.addContour(shape, FillRule::NonZero, &ring != &rings.front()), ring, tag);
    }
}

/// Adds a painted path as one feature.
inline void addPath(ArrangementInput &input, FillRule rule, const std::vector<std::vector<Vec2>> &subpaths) {
    if (input.features.empty()) {
        input.addFeature(1);
    }
    const std::uint32_t contour = input.addContour(input.addShape(0), rule);
    for (const std::vector<Vec2> &subpath : subpaths) {
        input.addRing(contour, subpath, 1);
    }
}

/// The faces of a valid domain.
struct FacesOf {
    DomainGraph graph;
    Faces faces;
    FaceLabels labels;
    explicit FacesOf(const Domain &domain) : graph(graphOf(domain)) {
        const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
        REQUIRE(sweep.droppedCount == 0);
        faces = findFaces(graph.points, graph.edges, sweep);
        labels = labelFaces(domain, graph, faces);
    }
};

/// Returns the area inside by region tag.
inline std::map<std::int32_t, double> areas(const Domain &domain) {
    const FacesOf of(domain);
    std::map<std::int32_t, double> result;
    for (std::size_t e = 0; e < of.graph.edges.size(); ++e) {
        const double area = 0.5 * cross(of.graph.points[of.graph.edges[e].a], of.graph.points[of.graph.edges[e].b]);
        for (const auto &[face, sign] : {std::pair{of.faces.left[e], 1.0}, {of.faces.right[e], -1.0}}) {
            if (of.labels.inside[face] != 0) {
                result[of.labels.tag[face]] += sign * area;
            }
        }
    }
    return result;
}

/// Returns the area inside, summed about the centre, so that it is accurate far from the origin too.
inline double insideArea(const Domain &domain) {
    const FacesOf of(domain);
    const Vec2 centre = domain.bounds().centre();
    double twice = 0.0;
    for (std::size_t e = 0; e < of.graph.edges.size(); ++e) {
        const PlaneEdge &edge = of.graph.edges[e];
        const double part = cross(of.graph.points[edge.a] - centre, of.graph.points[edge.b] - centre);
        twice += of.labels.inside[of.faces.left[e]] * part - of.labels.inside[of.faces.right[e]] * part;
    }
    return 0.5 * twice;
}

/// Returns the segments by their coordinates, smaller end first.
inline std::set<std::array<double, 4>> segmentSet(const Domain &domain) {
    std::set<std::array<double, 4>> set;
    for (const DomainSegment &segment : domain.segments) {
        Vec2 a = domain.nodes[segment.a], b = domain.nodes[segment.b];
        if (comesBefore(b, a)) {
            std::swap(a, b);
        }
        set.insert({a.x, a.y, b.x, b.y});
    }
    return set;
}

/// Returns the arrangement and requires that its domain is valid.
inline Arrangement arranged(ArrangementInput input) {
    input.markRegions = true;
    Result<Arrangement> result = arrange(input);
    REQUIRE(result.ok());
    const Diagnostics faults = validate(result->domain);
    for (const Diagnostic &fault : faults) {
        FAIL_CHECK(toString(fault));
    }
    REQUIRE(result->stretches.size() == result->domain.segments.size());
    REQUIRE(result->nodePiece.size() == result->domain.nodes.size());
    return std::move(*result);
}

/// Returns the change of a kind, or null.
inline const ArrangementChange *find(const Arrangement &arrangement, ChangeKind kind) {
    const auto found = std::find_if(arrangement.changes.begin(), arrangement.changes.end(),
                                    [&](const ArrangementChange &change) { return change.kind == kind; });
    return found != arrangement.changes.end() ? &*found : nullptr;
}

using Areas = std::map<std::int32_t, double>;

} // namespace forefront::testing
