#include "core/boundary/discretise.hpp"
#include "core/edit/element_counts.hpp"
#include "core/edit/path_curve.hpp"
#include "core/edit/shape_geometry.hpp"
#include "core/spacing/spacing_field.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

/// Returns the number of boundary edges with a tag, as meshed.
std::ptrdiff_t edges(const Document &document, std::int32_t tag) {
    const Domain domain = toDomain(document);
    const auto field = SpacingField::build(document.spacing, domain);
    REQUIRE(field.ok());
    const Result<DiscreteDomain> discrete = discretise(domain, **field, false);
    REQUIRE(discrete.ok());
    return std::count_if(discrete->segments.begin(), discrete->segments.end(),
                         [&](const auto &segment) { return segment.tag == tag; });
}

} // namespace

TEST_CASE("setElementCount: a straight segment, a circle and an arc get exactly that many elements") {
    Shape circle = makeShape(ShapeKind::Circle, {{0, 0}, {0.7, 0.1}});
    Document document = *addShapes({}, {square({-4, -3}, 7.3), circle});
    document.spacing.size = 1e3;
    for (const std::uint32_t count : {1U, 2U, 3U, 7U, 10U, 33U, 49U, 1000U}) {
        CAPTURE(count);
        const Document next = *setElementCount(document, {{1, 1}}, count);
        CHECK(segmentTag(*next.shapes[0], 1) == 2);
        CHECK(segmentTag(*next.shapes[0], 0) == 1);
        CHECK(next.shapes[1]->tag == 1);
        CHECK(elementCount(next, {1, 1}) == count);
        CHECK(edges(next, 2) == count);
    }
    for (const std::uint32_t count : {32U, 47U, 200U, 500U}) {
        CAPTURE(count);
        const Document next = *setElementCount(document, {{2, 0}}, count);
        CHECK(next.shapes[1]->segmentTags.empty());
        CHECK(elementCount(next, {2, 0}) == count);
        CHECK(edges(next, 2) == count);
    }
    Shape arc = makeShape(ShapeKind::Polyline, {{2, 0}, {2.5, 1}}, ShapeUse::Constraint);
    arc.curves = {arcThrough({2, 0}, {2.6, 0.4}, {2.5, 1})};
    const Shape ellipse = makeShape(ShapeKind::Ellipse, {{-2, 2}, {-1, 2}, {-2, 2.5}});
    document = *addShapes(document, {arc, ellipse});
    for (const std::uint32_t id : {3U, 4U}) {
        CAPTURE(id);
        CHECK(edges(*setElementCount(document, {{id, 0}}, 60U), 2) == 60);
        CHECK(edges(*setElementCount(document, {{id, 0}}, 300U), 2) == 300);
    }
}

TEST_CASE("setElementCount: segments of one length share a tag, others get their own; names and growth are kept") {
    const Shape bar = makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 1}, {0, 1}});
    Document document = *addShapes({}, {bar});
    document.boundaryNames = {{1, "wall"}};
    document.spacing.size = 1e3;
    document.spacing.partSizes[1] = {50.0, 0.4};
    const Document next = *setElementCount(document, {{1, 0}, {1, 1}, {1, 2}}, 8);
    CHECK(segmentTag(*next.shapes[0], 0) == segmentTag(*next.shapes[0], 2));
    CHECK(next.boundaryNames == std::map<std::int32_t, std::string>{{1, "wall"}, {2, "wall 2"}, {3, "wall 3"}});
    CHECK(next.spacing.partSizes.at(2) == PartSize{0.5, 0.4});
    CHECK(next.spacing.partSizes.at(3) == PartSize{0.125, 0.4});
    CHECK(edges(next, segmentTag(*next.shapes[0], 1)) == 8);
    CHECK(edges(next, segmentTag(*next.shapes[0], 0)) > 8); // finer beside the short side
    // A segment that has its own tag keeps it; without a count, only the size is removed.
    const Document again = *setElementCount(next, {{1, 1}}, 5);
    CHECK(segmentTag(*again.shapes[0], 1) == segmentTag(*next.shapes[0], 1));
    CHECK(elementCount(again, {1, 1}) == 5U);
    const Document none = *setElementCount(again, {{1, 1}}, std::nullopt);
    CHECK_FALSE(none.spacing.partSizes.contains(segmentTag(*none.shapes[0], 1)));
}

TEST_CASE("setElementCount: without a count, other segments of the tag keep their size") {
    Document document = *addShapes({}, {square({0, 0}, 2)});
    document.boundaryNames = {{1, "wall"}};
    document.spacing.partSizes[1] = {0.25, 0.2};
    REQUIRE(elementCount(document, {1, 0}) == 8U);
    const Document next = *setElementCount(document, {{1, 0}}, std::nullopt);
    CHECK_FALSE(elementCount(next, {1, 0}).has_value());
    CHECK(elementCount(next, {1, 1}) == 8U);
    CHECK(next.boundaryNames.at(segmentTag(*next.shapes[0], 0)) == "wall 2");
    const Document same = *setElementCount(next, {{1, 0}}, std::nullopt); // has none
    CHECK(same.spacing.partSizes == next.spacing.partSizes);
    CHECK(segmentTag(*same.shapes[0], 0) == segmentTag(*next.shapes[0], 0));
}

TEST_CASE("setElementCount: a steep growth is lowered where a curve would not get its number") {
    const Shape circle = makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}});
    Document document = *addShapes({}, {circle});
    document.spacing.size = 1e3;
    document.spacing.partSizes[1] = {50.0, 2.0};
    const Document next = *setElementCount(document, {{1, 0}}, 2000);
    CHECK(elementCount(next, {1, 0}) == 2000U);
    CHECK(edges(next, 1) == 2000);
}

TEST_CASE("setElementCount: refuses what cannot be counted; a size that does not divide the length is no count") {
    Shape rounded = makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 3}});
    rounded.radius = 0.5;
    Document document = *addShapes({}, {rounded, square({6, 0}, 2)});
    CHECK(codeOf(setElementCount(document, {{1, 0}}, 4)) == "not-possible");
    CHECK(codeOf(setElementCount(document, {{2, 9}}, 4)) == "no-such-segment");
    CHECK(codeOf(setElementCount(document, {{2, 0}}, 0)) == "bad-number");
    CHECK(codeOf(setElementCount(document, {{2, 0}}, kMaxElementCount + 1)) == "bad-number");
    CHECK_FALSE(elementCount(document, {2, 0}).has_value());
    document.spacing.partSizes[1] = {0.3, 0.2};
    CHECK_FALSE(elementCount(document, {2, 0}).has_value());
    document.spacing.partSizes[1] = {0.25, 0.2};
    CHECK(elementCount(document, {2, 0}) == 8U);
}
