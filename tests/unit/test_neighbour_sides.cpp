// Closed shapes that have each drawn their common border share it as one line in the domain.
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/shared_sides.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

bool isRefused(const Document &document) {
    const Diagnostics faults = validate(toDomain(document));
    return std::any_of(faults.begin(), faults.end(),
                       [](const Diagnostic &fault) { return fault.code == "duplicate-segment"; });
}

} // namespace

TEST_CASE("Neighbour sides: a side that two shapes have drawn is one inner line, whichever way they turn") {
    for (const bool turned : {false, true}) {
        CAPTURE(turned);
        Shape right = square({4, 0}, 4);
        if (turned) {
            std::reverse(right.nodes.begin(), right.nodes.end());
        }
        const Document document = documentOf({square({0, 0}, 4), right, square({4, 4}, 4)});
        DomainSources sources;
        const Domain domain = toDomain(document, sources);
        CHECK(validate(domain).empty());
        CHECK(domain.segments.size() == 10);
        CHECK(innerLines(domain) == 2);
        REQUIRE(sources.segments.size() == domain.segments.size());
        for (std::size_t s = 0; s < domain.segments.size(); ++s) {
            const Shape &shape = *document.shapes[sources.segments[s].shape];
            CHECK(domain.nodes[domain.segments[s].a] == shape.nodes[sources.segments[s].node]);
        }
        CHECK(meshedArea(document) == doctest::Approx(48.0));
    }
}

TEST_CASE("Neighbour sides: what lies on one side of both, is traced thrice or differs in size is refused") {
    CHECK(isRefused(documentOf({square({0, 0}, 4), square({0, 0}, 4)})));
    CHECK(isRefused(documentOf({square({0, 0}, 4), makeShape(ShapeKind::Polygon, {{4, 0}, {4, 4}, {2, 2}})})));
    CHECK(isRefused(documentOf({square({0, 0}, 4), square({4, 0}, 4), square({4, 0}, 4)})));
    Document sized = documentOf({square({0, 0}, 4), square({4, 0}, 4)});
    CHECK_FALSE(isRefused(sized));
    Shape fine = *sized.shapes[1];
    fine.segmentSizes[3].size = 0.1;
    sized.shapes[1] = std::make_shared<const Shape>(fine);
    CHECK(isRefused(sized));
}

TEST_CASE("Neighbour sides: outlines of regions share sides with each other and with the boundary") {
    const auto region = [](Vec2 low, double side) { return square(low, side, ShapeUse::Constraint); };
    const Document document =
        documentOf({square({0, 0}, 10), region({0, 2}, 4), region({4, 2}, 4), region({4, 2}, 2), region({2, 2}, 2)});
    const Domain domain = toDomain(document);
    CHECK(validate(domain).empty());
    double boundary = 0.0, within = 0.0;
    for (const DomainSegment &segment : domain.segments) {
        const double length = distance(domain.nodes[segment.a], domain.nodes[segment.b]);
        (segment.role == SegmentRole::Boundary ? boundary : within) += length;
    }
    CHECK(boundary == doctest::Approx(40.0));
    CHECK(within == doctest::Approx(12.0 + 12.0 + 4.0 + 4.0));
    CHECK(meshedArea(document) == doctest::Approx(100.0));
}

TEST_CASE("Neighbour sides: a line with a crack, a strip or layers is not taken for another one") {
    Shape region = square({0, 2}, 4, ShapeUse::Constraint);
    region.tag = 7;
    Document document = documentOf({square({0, 0}, 10), region});
    CHECK_FALSE(isRefused(document));
    document.cracks = {7};
    CHECK(isRefused(document));
    document.cracks = {1};
    CHECK_FALSE(isRefused(document));
    document.layers = {{.tag = 7}};
    CHECK(isRefused(document));
}

TEST_CASE("Neighbour sides: arcs and Bezier curves that two shapes have drawn are one line, also in part") {
    const auto withCurve = [](std::vector<Vec2> nodes, std::size_t segment, const Curve &curve) {
        Shape shape = makeShape(ShapeKind::Polygon, nodes);
        std::vector<Curve> curves(nodes.size(), Curve::line({}, {}));
        curves[segment] = curve;
        std::get<PathForm>(shape.form).curves = curves;
        return shape;
    };
    const Curve cubic = Curve::cubic({4, 0}, {5, 1.5}, {3, 2.5}, {4, 4});
    const Curve back = Curve::cubic({4, 4}, {3, 2.5}, {5, 1.5}, {4, 0});
    const Document beside = documentOf(
        {withCurve({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 1, cubic), withCurve({{4, 4}, {4, 0}, {9, 0}, {9, 4}}, 0, back)});
    CHECK(validate(toDomain(beside)).empty());
    CHECK(meshedArea(beside) == doctest::Approx(36.0));
    // Another curve between the same nodes is no common side.
    const Document lens = documentOf(
        {withCurve({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 1, cubic),
         withCurve({{4, 4}, {4, 0}, {9, 0}, {9, 4}}, 0, Curve::cubic({4, 4}, {5.5, 2.5}, {5.5, 1.5}, {4, 0}))});
    CHECK(toDomain(lens).segments.size() > toDomain(beside).segments.size());
    // A disc in three parts, in two of which the arc is whole and in one a part of it is shared.
    const auto onCircle = [](double degrees) {
        const double a = degrees * std::numbers::pi / 180.0;
        return Vec2{2.0 * std::cos(a), 2.0 * std::sin(a)};
    };
    const Shape half =
        withCurve({onCircle(0), onCircle(180)}, 0, Curve::arc({0, 0}, {2, 0}, {0, 2}, 0.0, std::numbers::pi));
    const Shape ring =
        withCurve({onCircle(120), onCircle(60), 2.0 * onCircle(60), 2.0 * onCircle(120)}, 0,
                  Curve::arc({0, 0}, {2, 0}, {0, 2}, std::numbers::pi * 2.0 / 3.0, -std::numbers::pi / 3.0));
    const Document part = documentOf({half, ring});
    const Domain domain = toDomain(part);
    const Diagnostics faults = validate(domain);
    CHECK_MESSAGE(faults.empty(), faults.front().code, " ", faults.front().at->x, " ", faults.front().at->y);
    CHECK(innerLines(domain) > 0);
    for (const DomainSegment &segment : domain.segments) {
        if (segment.role == SegmentRole::Constraint) {
            CHECK(std::min(domain.nodes[segment.a].y, domain.nodes[segment.b].y) > 1.7);
        }
    }
}
