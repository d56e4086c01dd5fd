#include "core/engine/domain/inside_test.hpp"
#include "core/engine/domain/lazy_faces.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A square of side 10 with a square hole, a line inside and a slanted side.
Domain plate() {
    DomainBuilder builder;
    builder.loop({{0, 0}, {10, 0}, {8, 10}, {0, 10}}, 1);
    builder.loop({{2, 2}, {2, 4}, {4, 4}, {4, 2}}, 2);
    builder.join({builder.node({5, 5}), builder.node({6, 6})}, false, 3, SegmentRole::Constraint);
    return std::move(builder.domain);
}

} // namespace

TEST_CASE("InsideTest: holes are outside, lines inside do not count, the boundary is inside") {
    const Domain domain = plate();
    const LazyFaces faces(domain);
    REQUIRE(faces.inside() != nullptr);
    const InsideTest &inside = *faces.inside();
    for (const Vec2 p : {Vec2{1, 1}, Vec2{5.5, 5.5}, Vec2{5.5, 5.6}, Vec2{0, 0}, Vec2{8, 10}, Vec2{9, 5}, Vec2{0, 3},
                         Vec2{2, 3}, Vec2{4, 4}, Vec2{3, 4}, Vec2{3, 4.001}, Vec2{10, 0}}) {
        CHECK_MESSAGE(inside.contains(p), p.x << ", " << p.y);
    }
    for (const Vec2 p : {Vec2{3, 3}, Vec2{9.01, 5}, Vec2{-0.01, 3}, Vec2{5, 11}, Vec2{5, -1}, Vec2{3, 3.999}}) {
        CHECK_MESSAGE(!inside.contains(p), p.x << ", " << p.y);
    }
    CHECK(inside.meets({{1, 1}, {3, 3}}));
    CHECK(inside.meets({{7, 7}, {7.1, 7.1}}));
    CHECK_FALSE(inside.meets({{2.5, 2.5}, {3.5, 3.5}}));
    CHECK_FALSE(inside.meets({{9.5, 8}, {10, 10}})); // in the box of the slanted side, but beyond it
    CHECK(inside.boundaryMeets({{1, 1}, {3, 3}}));
    CHECK_FALSE(inside.boundaryMeets({{4.5, 4.5}, {7, 7}}));
    CHECK(inside.boundaryCrosses({3, 3}, {3, 5}));
    CHECK_FALSE(inside.boundaryCrosses({5, 6}, {6, 5})); // only the line inside
}

TEST_CASE("LazyFaces: there are none where segments cross, and no inside where everything is a hole") {
    DomainBuilder crossed;
    crossed.loop({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 1);
    CHECK(LazyFaces(crossed.domain).get() == nullptr);
    CHECK(LazyFaces(crossed.domain).inside() == nullptr);
    Domain hole = squareDomain(1);
    hole.insideRule = InsideRule::HoleMarkers;
    CHECK(LazyFaces(hole).inside() != nullptr);
    hole.holeMarkers = {{0.5, 0.5}};
    CHECK(LazyFaces(hole).get() != nullptr);
    CHECK(LazyFaces(hole).inside() == nullptr);
    std::stop_source stop;
    stop.request_stop();
    const Domain square = squareDomain(1);
    CHECK(LazyFaces(square, stop.get_token()).get() == nullptr);
}
