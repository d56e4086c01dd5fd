// Places of a drawing that are the same to the editor are one in its mesh.
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/same_place.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/shared_sides.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

Shape box(Vec2 low, Vec2 high) {
    return makeShape(ShapeKind::Rectangle, {low, high});
}

Shape line(Vec2 a, Vec2 b) {
    return makeShape(ShapeKind::Polyline, {a, b}, ShapeUse::Constraint);
}

bool hasCode(const Document &document, const char *code) {
    return forefront::hasCode(jobOf(document).findings, code);
}

} // namespace

TEST_CASE("Same place: corners of neighbours within the tolerance are one, and their side is shared") {
    const std::vector<std::pair<Shape, Shape>> neighbours = {
        {box({0, 0}, {1, 1}), box({1.0000001, 0}, {2, 1})},
        {box({0, 0}, {1, 1}), makeShape(ShapeKind::Polygon, {{1, 0}, {2, 0}, {2, 1}, {1, 1.0000001}})},
        {box({0, 0}, {1, 1}), makeShape(ShapeKind::Polygon, {{1, -0.5}, {2, 0}, {2, 1}, {0.9999999, 1.5}})}};
    for (const auto &[first, second] : neighbours) {
        for (const bool turned : {false, true}) {
            CAPTURE(turned);
            const Document document = turned ? documentOf({second, first}) : documentOf({first, second});
            const Domain domain = toDomain(document);
            CHECK(validate(domain).empty());
            CHECK(innerLines(domain) == 1);
            CHECK(hasCode(document, "joined-places"));
            CHECK_FALSE(hasErrors(jobOf(document).findings));
            CHECK(meshedArea(document) > 1.99);
        }
    }
}

TEST_CASE("Same place: an end beside a side, inside or outside, and one beside a corner are joined with them") {
    for (const Vec2 end : {Vec2{0.5, 1e-7}, Vec2{0.5, -1e-7}, Vec2{0.5, 1e-9}, Vec2{0, 1e-7}, Vec2{1e-7, -1e-7}}) {
        CAPTURE(end.x);
        CAPTURE(end.y);
        const Document document = documentOf({box({0, 0}, {1, 1}), line(end, {0.5, 0.5})});
        const Domain domain = toDomain(document);
        CHECK(validate(domain).empty());
        CHECK(domain.segments.size() == (end.x == 0.5 ? 6U : 5U));
        CHECK(domain.nodes.size() == (end.x == 0.5 ? 6U : 5U));
        const double shortest = [&] {
            double least = 1.0;
            for (const DomainSegment &segment : domain.segments) {
                least = std::min(least, distance(domain.nodes[segment.a], domain.nodes[segment.b]));
            }
            return least;
        }();
        CHECK(shortest > 0.4);
    }
    const Document apart = documentOf({box({0, 0}, {1, 1}), line({0.5, 1e-4}, {0.5, 0.5})});
    CHECK(toDomain(apart).segments.size() == 5);
    CHECK(jobOf(apart).findings.empty());
}

TEST_CASE("Same place: the nodes that the joints of the editor hold together are those that the domain makes one") {
    for (const double gap : {1e-4, 3e-6, 2e-6, 1e-6, 1e-7, 1e-9, 1e-12}) {
        CAPTURE(gap);
        const Document document = documentOf({box({0, 0}, {1, 1}), box({1 + gap, 0}, {2, 1})});
        std::size_t joined = 0;
        JointIndex(document).handlesAt({1, 0}, [&](const JointHandle &) { ++joined; });
        CHECK((joined == 2) == (gap <= samePlaceDistance(document)));
        CHECK(innerLines(toDomain(document)) == joined - 1);
    }
}

TEST_CASE("Same place: details of one shape below the tolerance stay, and a chain of places becomes one") {
    const double d = 1e-7;
    const Document detail =
        documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {1, 0}, {1, d}, {1, 1}, {0, 1}}), box({3, 0}, {4, 1})});
    CHECK(toDomain(detail).nodes.size() == 9);
    CHECK(jobOf(detail).findings.empty());
    const double step = 0.8 * kSamePlace * length(Vec2{7, 4}); // two steps are farther than that
    const Document chain = documentOf(
        {line({0, 0}, {-1, 1}), line({step, 0}, {0, 2}), line({2 * step, 0}, {4, 1}), box({-2, -1}, {5, 3})});
    CHECK(toDomain(chain).nodes.size() == 8);
}

TEST_CASE("Same place: the first shape keeps its nodes, and circles stay where they are") {
    const Document document = documentOf({box({0, 0}, {1, 1}), box({1.0000001, 0}, {2, 1})});
    const Domain domain = toDomain(document);
    CHECK(std::count(domain.nodes.begin(), domain.nodes.end(), Vec2{1, 0}) == 1);
    CHECK(std::count(domain.nodes.begin(), domain.nodes.end(), Vec2{1.0000001, 0}) == 0);
    const Document round = documentOf({line({1.0000001, 0}, {0.2, 0}), makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}})});
    const Domain disc = toDomain(round);
    CHECK(std::count(disc.nodes.begin(), disc.nodes.end(), Vec2{1, 0}) == 1);
    CHECK(std::count(disc.nodes.begin(), disc.nodes.end(), Vec2{1.0000001, 0}) == 0);
    CHECK(validate(disc).empty());
}

TEST_CASE("Same place: a node beside a curve and a line along a side are reported, since they are not joined") {
    const Document beside =
        documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}}), line({0, 0.9999999}, {0.1, 0})});
    CHECK(hasCode(beside, "beside-curve"));
    const Document along = documentOf(
        {square({0, 0}, 4), makeShape(ShapeKind::Polyline, {{0, 0}, {2, 1e-7}, {4, 0}}, ShapeUse::Constraint)});
    CHECK(hasCode(along, "line-along-side"));
}

TEST_CASE("Same place: Bezier curves that neighbours drew with a small difference are one line") {
    const double d = 1e-6;
    const Document document = documentOf(
        {withCurve({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 1, Curve::cubic({4, 0}, {5, 1.5}, {3, 2.5}, {4, 4})),
         withCurve({{4 + d, 4}, {4, d}, {9, 0}, {9, 4}}, 0, Curve::cubic({4 + d, 4}, {3, 2.5}, {5, 1.5}, {4, d}))});
    CHECK(validate(toDomain(document)).empty());
    CHECK(meshedArea(document) == doctest::Approx(36.0).epsilon(1e-5));
}
