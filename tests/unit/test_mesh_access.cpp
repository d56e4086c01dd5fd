#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/mesh_access.hpp"
#include "core/engine/pipeline/pipeline.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace forefront {

namespace {

/// A square of side 4 whose part around a square hole at (1, 1) is region 7, and the rest region 5.
MeshingJob dividedJob() {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 1);
    addLoop(job.domain, {{1, 1}, {1.5, 1}, {1.5, 1.5}, {1, 1.5}}, 2);
    const auto first = static_cast<std::uint32_t>(job.domain.nodes.size());
    job.domain.nodes.insert(job.domain.nodes.end(), {{2, 0}, {2, 4}});
    job.domain.segments[0].b = first;
    job.domain.segments[2].b = first + 1;
    job.domain.segments.push_back({first, 1, 1});
    job.domain.segments.push_back({first + 1, 3, 1});
    job.domain.segments.push_back({first, first + 1, 9, SegmentRole::Constraint});
    job.domain.regionMarkers = {{{0.5, 0.5}, 7}, {{3, 3}, 5}};
    job.spacing.size = 0.25;
    return job;
}

} // namespace

TEST_CASE("Mesh access: the arrays are the nodes and elements, one after the other") {
    const Result<MeshingOutcome> outcome = meshDomain(dividedJob());
    REQUIRE(outcome);
    const TriMesh mesh = takeTriMesh(outcome->mesh);
    const std::span<const double> xy = coordinates(mesh);
    const std::span<const std::uint32_t> corners = connectivity(outcome->mesh.blocks.front());
    REQUIRE(xy.size() == 2 * mesh.nodes.size());
    REQUIRE(corners.size() == 3 * mesh.elements.size());
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        REQUIRE(Vec2{xy[2 * n], xy[2 * n + 1]} == mesh.nodes[n]);
    }
    for (std::size_t k = 0; k < corners.size(); ++k) {
        REQUIRE(corners[k] == index(mesh.elements[k / 3][k % 3]));
    }
    CHECK(coordinates(TriMesh()).empty());
    CHECK(connectivity(CellBlock()).empty());
}

TEST_CASE("Mesh access: edges by tag, and the regions on either side of each") {
    const Result<MeshingOutcome> outcome = meshDomain(dividedJob());
    REQUIRE(outcome);
    const TriMesh mesh = takeTriMesh(outcome->mesh);
    const std::vector<EdgeSides> sides = edgeSides(mesh);
    REQUIRE(sides.size() == mesh.edges.size());
    std::size_t counted = 0;
    for (const auto &[tag, isOn] : std::vector<std::pair<std::int32_t, bool (*)(Vec2)>>{
             {1, [](Vec2 p) { return p.x == 0.0 || p.x == 4.0 || p.y == 0.0 || p.y == 4.0; }},
             {2, [](Vec2 p) { return std::max(std::abs(p.x - 1.25), std::abs(p.y - 1.25)) == 0.25; }},
             {9, [](Vec2 p) { return p.x == 2.0; }}}) {
        CAPTURE(tag);
        const std::vector<std::uint32_t> edges = edgesWithTag(mesh, tag);
        CHECK_FALSE(edges.empty());
        counted += edges.size();
        for (const std::uint32_t e : edges) {
            const Vec2 a = mesh.nodes[index(mesh.edges[e].a)], b = mesh.nodes[index(mesh.edges[e].b)];
            REQUIRE(isOn(midpoint(a, b)));
            REQUIRE(sides[e].isInterface() == (tag == 9));
            REQUIRE(sides[e].left != kNoElement);
            REQUIRE((sides[e].right == kNoElement) == (tag != 9));
            REQUIRE((sides[e].rightRegion == 0) == (tag != 9));
            const auto expected = [&](double offset) { // region of the place beside the middle
                const Vec2 place = midpoint(a, b) + offset * leftNormal(b - a);
                return place.x < 2.0 ? 7 : 5;
            };
            REQUIRE(sides[e].leftRegion == expected(0.1));
            REQUIRE((tag != 9 || sides[e].rightRegion == expected(-0.1)));
            REQUIRE(mesh.region(index(sides[e].left)) == sides[e].leftRegion);
        }
    }
    CHECK(counted == mesh.edges.size());
    CHECK(edgesWithTag(mesh, 3).empty());
}

TEST_CASE("Mesh access: an edge that is in no element has no sides") {
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.elements = {{NodeId{0}, NodeId{1}, NodeId{2}}, {NodeId{0}, NodeId{2}, NodeId{3}}};
    mesh.edges = {{NodeId{2}, NodeId{0}, 1}, {NodeId{1}, NodeId{3}, 1}, {NodeId{1}, NodeId{0}, 4}};
    const std::vector<EdgeSides> sides = edgeSides(mesh);
    CHECK(sides[0] == EdgeSides{ElementId{0}, ElementId{1}, 1, 1});
    CHECK_FALSE(sides[0].isInterface());
    CHECK(sides[1] == EdgeSides{});
    CHECK(sides[2] == EdgeSides{kNoElement, ElementId{0}, 0, 1});
}

TEST_CASE("Mesh access: the region of every element is filled in, for a single region too") {
    for (const std::int32_t tag : {1, 6}) {
        MeshingJob job;
        addLoop(job.domain, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
        job.spacing.size = 0.5;
        job.domain.regionMarkers = {{{1, 1}, tag}};
        for (const ImproveLevel level : {ImproveLevel::None, ImproveLevel::Default, ImproveLevel::Best}) {
            job.options.improve = level;
            const Result<MeshingOutcome> outcome = meshDomain(job);
            REQUIRE(outcome);
            REQUIRE(outcome->mesh.blocks.size() == 1);
            CHECK(outcome->mesh.blocks.front().regions == std::vector<std::int32_t>(outcome->mesh.elementCount(), tag));
        }
    }
}

TEST_CASE("Domains: addLoop returns where the loop is, and takes a list in braces") {
    Domain domain;
    const LoopRange outer = addLoop(domain, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    const std::vector<Vec2> corners{{1, 1}, {2, 1}, {2, 2}};
    const LoopRange hole = addLoop(domain, corners, 5);
    CHECK(outer.firstNode == 0);
    CHECK(outer.count == 4);
    CHECK(outer.tag == 1);
    CHECK(hole.firstNode == 4);
    CHECK(hole.firstSegment == 4);
    CHECK(hole.count == 3);
    for (std::uint32_t k = 0; k < hole.count; ++k) {
        const DomainSegment &segment = domain.segments[hole.firstSegment + k];
        CHECK(segment.a == hole.firstNode + k);
        CHECK(segment.b == hole.firstNode + (k + 1) % 3);
        CHECK(segment.tag == 5);
    }
    CHECK(addLoop(domain, {}).count == 0);
    CHECK(addLoop(domain, {{9, 9}}).count == 1);
}

TEST_CASE("Result: value_or returns the value or the fallback") {
    const Result<int> good(3), bad(error("code", "message"));
    CHECK(good.value_or(7) == 3);
    CHECK(bad.value_or(7) == 7);
    CHECK(Result<std::string>(std::string("text")).value_or("fallback") == "text");
    CHECK(Result<std::string>(error("code", "message")).value_or("fallback") == "fallback");
}

} // namespace forefront
