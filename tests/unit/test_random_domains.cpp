#include "core/engine/domain/domain_graph.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace forefront;
using namespace forefront::testing;

TEST_CASE("random domains: closed, simple, with all their parts inside") {
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        CAPTURE(seed);
        const Domain domain = randomDomain(seed);
        const DomainGraph graph = graphOf(domain);
        REQUIRE(graph.node.size() == domain.nodes.size()); // all finite and referenced
        REQUIRE(graph.edges.size() == domain.segments.size());
        const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
        REQUIRE(sweep.droppedCount == 0);
        std::vector<int> degree(domain.nodes.size(), 0);
        for (const DomainSegment &segment : domain.segments) {
            REQUIRE(segment.tag >= 1);
            degree[segment.a] += segment.role == SegmentRole::Boundary ? 1 : 0;
            degree[segment.b] += segment.role == SegmentRole::Boundary ? 1 : 0;
        }
        REQUIRE(std::none_of(degree.begin(), degree.end(), [](int d) { return d % 2 != 0; }));
        const Faces faces = findFaces(graph.points, graph.edges, sweep);
        const FaceLabels labels = labelFaces(domain, graph, faces);
        for (std::size_t e = 0; e < graph.edges.size(); ++e) {
            const bool left = labels.inside[faces.left[e]] != 0, right = labels.inside[faces.right[e]] != 0;
            const bool boundary = domain.segments[graph.segment[e]].role == SegmentRole::Boundary;
            REQUIRE((boundary ? left != right : left && right));
        }
        for (const ConstraintPoint &point : domain.points) {
            REQUIRE(labels.inside[faces.ofPoint[graph.pointOfNode[point.node]]] == 1);
        }
        for (const std::uint32_t marker : graph.regionMarker) {
            REQUIRE(labels.inside[faces.ofPoint[marker]] == 1);
        }
    }
}

TEST_CASE("random domains: the same seed gives the same domain, another seed another domain") {
    for (int family = 0; family < kDomainFamilies; ++family) {
        const auto kind = static_cast<DomainFamily>(family);
        CAPTURE(nameOf(kind));
        CHECK(randomDomain(kind, 7).nodes == randomDomain(kind, 7).nodes);
        CHECK(randomDomain(kind, 7).nodes != randomDomain(kind, 8).nodes);
        CHECK(randomDomain(kind, 7).nodes == randomDomain(7 * kDomainFamilies + static_cast<unsigned>(family)).nodes);
    }
}
