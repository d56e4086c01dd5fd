#include "core/drawing/arrangement/arrangement.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/domain/curve_chains.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/curve_drawing.hpp"
#include "tests/support/random_curves.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Four curves that touch at the tips of a star of radius 1.
Domain cuspedStar() {
    const Vec2 tips[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    CurveLoop star;
    for (std::size_t k = 0; k < 4; ++k) {
        star.push_back(Curve::quadratic(tips[k], {0, 0}, tips[(k + 1) % 4]));
    }
    return curvedDomain({star}, 1e-4);
}

MeshingOutcome meshOf(const MeshingJob &job) {
    auto outcome = meshDomain(job);
    REQUIRE(outcome);
    CHECK(verifyAgainst(outcome->mesh, job.domain, job.spacing.placed.elements).empty());
    return std::move(*outcome);
}

double shortestEdgeAt(const TriMesh &mesh, Vec2 tip) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const TaggedEdge &edge : mesh.edges) {
        const Vec2 a = mesh.nodes[index(edge.a)], b = mesh.nodes[index(edge.b)];
        shortest = a == tip || b == tip ? std::min(shortest, distance(a, b)) : shortest;
    }
    REQUIRE(std::isfinite(shortest));
    return shortest;
}

} // namespace

TEST_CASE("Narrow tips: between curves that touch, one long element on the curves, unless a size is given") {
    MeshingJob job;
    job.domain = cuspedStar();
    const MeshingOutcome star = meshOf(job);
    for (const Vec2 tip : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
        CHECK(shortestEdgeAt(takeTriMesh(star.mesh), tip) > 0.02);
    }
    CHECK(measureQuality(star.mesh, nullptr).alphaGeometricMean > 0.92);
    REQUIRE(star.mesh.edgeStretches.size() == star.mesh.edges.size());
    for (std::size_t e = 0; e < star.mesh.edges.size(); ++e) {
        const CurveStretch &stretch = star.mesh.edgeStretches[e];
        REQUIRE(stretch.follows());
        const Curve &curve = star.mesh.curves[stretch.curve];
        CHECK(curve.deviation(stretch.t0, stretch.t1) <= 1.001 * chordTolerance(job.domain));
        CHECK(distance(curve.point(stretch.t0), star.mesh.nodes[index(star.mesh.edges[e].a)]) < 1e-12);
    }
    MeshingJob limited = job;
    limited.spacing.maximum = 0.01;
    CHECK(shortestEdgeAt(takeTriMesh(meshOf(limited).mesh), {1, 0}) < 0.0101);
    MeshingJob asked = job;
    asked.spacing.placed.elements.assign(asked.domain.segments.size(), 40); // along each curve
    CHECK(meshOf(asked).mesh.edges.size() == 160);
}

TEST_CASE("Narrow tips: between a curve and a segment, with the segments in either order") {
    const Vec2 corner{0, 0}, top{4, 0.4}, right{4, 0};
    const CurveLoop shape{Curve::line(corner, right), Curve::line(right, top),
                          Curve::quadratic(top, {2, 0.02}, corner)};
    MeshingJob job;
    job.domain = curvedDomain({shape}, 1e-4);
    const TriMesh mesh = takeTriMesh(meshOf(job).mesh);
    CHECK(shortestEdgeAt(mesh, corner) > 0.05);
    MeshingJob turned = job;
    std::reverse(turned.domain.segments.begin(), turned.domain.segments.end());
    const TriMesh same = takeTriMesh(meshOf(turned).mesh);
    CHECK(shortestEdgeAt(same, corner) == shortestEdgeAt(mesh, corner));
    CHECK(same.edges.size() == mesh.edges.size());
}

TEST_CASE("Narrow tips: with a part of the domain beyond a curve, the tip is divided") {
    const Vec2 corner{0, 0}, top{4, 0.4}, right{4, 0}, left{0, 4};
    const Curve curve = Curve::quadratic(top, {2, 0.02}, corner);
    CurveDrawing drawing(1e-4);
    drawing.feature({Curve::line(corner, right), Curve::line(right, top), curve});
    drawing.feature({curve.part(1.0, 0.0), Curve::line(top, left), Curve::line(left, corner)});
    MeshingJob job;
    job.domain = arrange(drawing.input).value().domain;
    CHECK(shortestEdgeAt(takeTriMesh(meshOf(job).mesh), corner) < 0.05);
}

TEST_CASE("Narrow tips: a lens that is narrow from tip to tip keeps nodes on both of its sides") {
    for (const double height : {0.02, 0.015, 0.01}) { // half of it is the distance of each side from the axis
        CAPTURE(height);
        const Vec2 left{0, 0}, right{4, 0};
        MeshingJob job;
        job.domain = curvedDomain(
            {{Curve::quadratic(left, {2, -height}, right), Curve::quadratic(right, {2, height}, left)}}, 1e-3 * height);
        const TriMesh mesh = takeTriMesh(meshOf(job).mesh);
        std::size_t above = 0, below = 0;
        for (const Vec2 node : mesh.nodes) {
            above += node.y > 0.0 ? 1U : 0U;
            below += node.y < 0.0 ? 1U : 0U;
        }
        CHECK(above > 0);
        CHECK(below > 0);
    }
}
