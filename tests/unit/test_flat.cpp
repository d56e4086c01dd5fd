#include "core/engine/domain/add_loop.hpp"
#include "core/engine/geometry/flat.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

using namespace forefront;
using samples::Codes;
using samples::codes;
using samples::node;

namespace {

/// Returns the loop with its sides divided into pieces of length 1, turned and moved.
std::vector<Vec2> unitSteps(const std::vector<Vec2> &corners, double turn = 0.0, Vec2 offset = {}) {
    std::vector<Vec2> loop;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
        const auto pieces = static_cast<int>(std::round(distance(a, b)));
        for (int k = 0; k < pieces; ++k) {
            const Vec2 p = lerp(a, b, static_cast<double>(k) / pieces);
            loop.push_back(
                Vec2{p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn)} +
                offset);
        }
    }
    return loop;
}

MeshingJob jobFor(const std::vector<Vec2> &loop, double size, Method method) {
    MeshingJob job;
    addLoop(job.domain, loop);
    job.spacing.size = size;
    job.options.method = method;
    job.options.keepBoundary = true;
    job.options.improve = ImproveLevel::None;
    return job;
}

const std::vector<std::vector<Vec2>> kOutlines = {
    {{0, 0}, {10, 0}, {10, 6}, {0, 6}},
    {{0, 0}, {7, 0}, {7, 3}, {3, 3}, {3, 8}, {0, 8}},
    {{0, 0}, {9, 0}, {9, 4}, {7, 4}, {7, 1}, {5, 1}, {5, 4}, {4, 4}, {4, 1}, {2, 1}, {2, 4}, {0, 4}},
    {{0, 0}, {12, 0}, {12, 1}, {0, 1}},
};

} // namespace

TEST_CASE("Flat: collinear, clockwise and nearly collinear points are flat, others are not") {
    CHECK(isFlat({0, 0}, {1, 1}, {2, 2}));
    CHECK(isFlat({0, 0}, {2, 2}, {1, 1}));
    CHECK(isFlat({0, 0}, {0, 1}, {1, 0})); // clockwise
    CHECK_FALSE(isFlat({0, 0}, {1, 0}, {0, 1}));
    const double step = std::nextafter(0.7, 1.0);
    REQUIRE(orientation({0.1, 0.1}, {0.9, 0.9}, {0.7, step}) == 1);
    CHECK(isFlat({0.1, 0.1}, {0.9, 0.9}, {0.7, step}));
    CHECK_FALSE(isFlat({0.1, 0.1}, {0.9, 0.9}, {0.7, 0.7 + 1e-12}));
    // Far away, the same height is within the rounding.
    CHECK(isFlat({1e6 + 0.1, 0.1}, {1e6 + 0.9, 0.9}, {1e6 + 0.7, 0.7 + 1e-12}));
}

TEST_CASE("Flat: each direction has its own rounding, so a needle along an axis is not flat") {
    CHECK_FALSE(isFlat({4, 1e20}, {0, 0.5e20}, {4, 0.5e20}));
    CHECK_FALSE(isFlat({0, 0}, {1, 0}, {0.5, 1e-300}));
    CHECK(isFlat({0, 1}, {1, 1}, {0.5, std::nextafter(1.0, 2.0)}));
}

TEST_CASE("Flat: a point nearly on a segment lies between its ends") {
    const Vec2 a{0.1, 0.3}, b{0.7, 0.9};
    CHECK(nearlyOnSegment(a, b, midpoint(a, b)));
    CHECK(nearlyOnSegment(a, b, lerp(a, b, 0.3)));
    CHECK(nearlyOnSegment(b, a, lerp(a, b, 0.3)));
    CHECK_FALSE(nearlyOnSegment(a, b, lerp(a, b, 1.1)));
    CHECK_FALSE(nearlyOnSegment(a, b, lerp(a, b, -0.1)));
    CHECK_FALSE(nearlyOnSegment(a, b, lerp(a, b, 0.3) + Vec2{0.0, 1e-12}));
    CHECK(nearlyOnSegment({0, 1}, {1, 1}, {0.5, std::nextafter(1.0, 0.0)})); // outside its box
}

TEST_CASE("verify: warns of flat elements, and of nothing else where their area is positive") {
    TriMesh mesh;
    mesh.nodes = {{0.1, 0.1}, {0.9, 0.9}, {0.7, std::nextafter(0.7, 1.0)}, {0.9, 0.1}, {0.1, 0.9}};
    mesh.elements = {{node(0), node(1), node(2)},
                     {node(0), node(3), node(1)},
                     {node(0), node(2), node(4)},
                     {node(2), node(1), node(4)}};
    const Diagnostics found = verify(mesh);
    CHECK(codes(found) == Codes{"flat-element"});
    CHECK_FALSE(hasErrors(found));
    REQUIRE(found.size() == 1);
    CHECK(found[0].ids == std::vector<std::uint32_t>{0});
    CHECK(measureQuality(mesh, nullptr).flat == 1);
    // Errors come first, and a limit keeps them.
    mesh.nodes.push_back({5, 5});
    mesh.edges.push_back({node(0), node(5), 1});
    const Diagnostics both = verify(mesh, 1);
    REQUIRE(both.size() == 3);
    CHECK(both[0].code == "missing-tagged-edge");
    CHECK(both[1].code == "more");
    CHECK(both[2].code == "unreferenced-node"); // only a note
}

TEST_CASE("Meshing: long kept segments and a small spacing give no flat elements") {
    for (std::size_t k = 0; k < kOutlines.size(); ++k) {
        for (const Method method : {Method::Fast, Method::Classic}) {
            for (const double size : {0.1, 0.3, 0.5, 1.0}) {
                for (const double turn : {0.0, 0.1, 0.25 * std::numbers::pi, 2.0}) {
                    for (const Vec2 offset : {Vec2{}, Vec2{100.1, 33.3}, Vec2{-1e5, 1e4}}) {
                        CAPTURE(k);
                        CAPTURE(size);
                        CAPTURE(turn);
                        CAPTURE(offset.x);
                        CAPTURE(std::string(wordOf(method)));
                        const auto outcome = meshDomain(jobFor(unitSteps(kOutlines[k], turn, offset), size, method));
                        REQUIRE(outcome);
                        const Diagnostics faults = verifyAgainst(outcome->mesh, *outcome->boundary);
                        CHECK_MESSAGE(faults.empty(), samples::list(faults));
                    }
                }
            }
        }
    }
}

TEST_CASE("Meshing: a domain that has no other element gets a flat one, with a warning") {
    // A triangle so thin that it is flat, kept as it is.
    const std::vector<Vec2> thin = {{0.1, 0.1}, {0.9, 0.9}, {0.7, std::nextafter(0.7, 1.0)}};
    for (const Method method : {Method::Fast, Method::Classic}) {
        const auto outcome = meshDomain(jobFor(thin, 1.0, method));
        REQUIRE(outcome);
        CHECK(outcome->mesh.triangles().size() == 1);
        CHECK(codes(verifyAgainst(outcome->mesh, *outcome->boundary)) == Codes{"flat-element"});
    }
}
