#include "tests/support/discrete_checks.hpp"

#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace forefront::testing {

void checkRegions(const Domain &domain, const DiscreteDomain &discrete) {
    Domain cut = domain; // the discrete segments as a domain
    cut.nodes = discrete.nodes;
    cut.points = discrete.points;
    cut.segments.clear();
    for (const DiscreteSegment &piece : discrete.segments) {
        cut.segments.push_back({piece.a, piece.b, piece.tag, domain.segments[piece.source].role});
    }
    const DomainGraph graph = graphOf(cut);
    REQUIRE(graph.edges.size() == cut.segments.size());
    const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
    REQUIRE(sweep.droppedCount == 0);
    const Faces faces = findFaces(graph.points, graph.edges, sweep);
    const FaceLabels labels = labelFaces(cut, graph, faces);
    std::map<std::uint32_t, std::uint32_t> regionOfFace;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        for (const auto &[face, region] : {std::pair{faces.left[e], discrete.segments[e].leftRegion},
                                           std::pair{faces.right[e], discrete.segments[e].rightRegion}}) {
            REQUIRE((labels.inside[face] != 0) == (region != kOutside));
            if (region != kOutside) {
                REQUIRE(region < discrete.regions.size());
                REQUIRE(regionOfFace.emplace(face, region).first->second == region);
                REQUIRE(discrete.regions[region].tag == labels.tag[face]);
            }
        }
    }
    REQUIRE(regionOfFace.size() == discrete.regions.size());
    for (const ConstraintPoint &point : discrete.points) {
        REQUIRE(labels.inside[faces.ofPoint[graph.pointOfNode[point.node]]] == 1);
    }
}

void checkAreas(const DiscreteDomain &discrete) {
    const Vec2 origin = discrete.bounds().centre();
    std::vector<CompensatedSum> twice(discrete.regions.size());
    double minimum = std::numeric_limits<double>::infinity();
    for (const DiscreteSegment &piece : discrete.segments) {
        const double part = cross(discrete.nodes[piece.a] - origin, discrete.nodes[piece.b] - origin);
        if (piece.leftRegion != kOutside) {
            twice[piece.leftRegion].add(part);
        }
        if (piece.rightRegion != kOutside) {
            twice[piece.rightRegion].add(-part);
        }
    }
    const double size = discrete.bounds().diagonal();
    double total = 0.0;
    for (std::size_t region = 0; region < twice.size(); ++region) {
        const double area = discrete.regions[region].area;
        REQUIRE(area > 0.0);
        REQUIRE(std::fabs(area - 0.5 * twice[region].value()) <= 1e-12 * size * size);
        minimum = std::min(minimum, area);
        total += area;
    }
    REQUIRE(discrete.area() == doctest::Approx(total).epsilon(1e-14));
}

} // namespace forefront::testing
