#include "core/drawing/commands/repair_drawing.hpp"
#include "core/drawing/domain/chain_shape.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "core/engine/domain/chains/chain_order.hpp"
#include "core/engine/domain/validate.hpp"
#include "tests/support/curved_area.hpp"
#include "tests/unit/arrangement_support.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Joining moves the given end of a shape onto the corner of a triangle to its left, `kOff` beside it.
constexpr double kOff = 6e-6;

Domain besideTriangle(const std::string &shape, Vec2 end, const std::string &others = "L 12 6.5 L 12 5.5") {
    const std::string corner = std::to_string(end.x - kOff) + " " + std::to_string(end.y);
    const std::string text = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 13 12'>" + shape + "<path d='M " +
                             corner + " " + others + " Z'/></svg>";
    const Result<Domain> domain = readSvg(sourceOf(text));
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    CHECK(ChainPaths(*domain).anyLooseEnd());
    return *domain;
}

double areaOf(const Domain &domain) {
    double area = 0.0;
    for (const auto &[tag, own] : curvedAreas(domain)) {
        area += own;
    }
    return area;
}

/// Checks that every node of a domain lies at its place in another one.
void checkPlaces(const Domain &domain, const Domain &expected, double tolerance) {
    REQUIRE(domain.nodes.size() == expected.nodes.size());
    for (const Vec2 node : domain.nodes) {
        const bool found = std::any_of(expected.nodes.begin(), expected.nodes.end(),
                                       [&](Vec2 p) { return distance(p, node) <= tolerance; });
        CHECK(found);
    }
}

} // namespace

TEST_CASE("Loose ends: an arc that is nearly closed keeps its size when joining has moved an end") {
    for (const double gap : {3e-4, 1e-3, 1e-2, 0.1, 1.0}) {
        CAPTURE(gap);
        const std::string path = "<path d='M 11 6 A 5 5 0 1 1 11 " + std::to_string(6.0 - gap) + " Z'/>";
        const Domain given = besideTriangle(path, {11, 6}), drawn = toDomain(fromDomain(given));
        CHECK(validate(drawn).empty());
        CHECK(inChainOrder(given).nodes == drawn.nodes);
        CHECK(inChainOrder(given).curves == drawn.curves);
        checkPlaces(drawn, given, 4.0 * kOff);
        const double half = std::asin(gap / 10.0); // half the angle that the gap spans at the centre
        const double circle = 25.0 * (std::numbers::pi - half) + 25.0 * std::sin(half) * std::cos(half);
        CHECK(std::fabs(areaOf(drawn) - (circle + 0.5)) <= 2e-4);
    }
}

TEST_CASE("Loose ends: a quarter of a flat ellipse does not move farther than its end") {
    const Domain given = besideTriangle("<path d='M 7.0710678 5.2928932 A 10 0.1 0 0 1 7.0710678 5.4343146 Z'/>",
                                        {7.0710678, 5.2928932}, "L 6 1 L 8 1");
    const Domain drawn = toDomain(fromDomain(given));
    CHECK(validate(drawn).empty());
    checkPlaces(drawn, given, 4.0 * kOff);
}

TEST_CASE("Loose ends: a circle whose node was moved stays a circle") {
    const Domain given = besideTriangle("<circle cx='6' cy='6' r='5'/>", {11, 6});
    const Document document = fromDomain(given);
    REQUIRE(document.shapes.size() == 2);
    CHECK(std::any_of(document.shapes.begin(), document.shapes.end(),
                      [](const auto &shape) { return shape->kind() == ShapeKind::Circle; }));
    checkPlaces(toDomain(document), given, 1.001 * kOff);
    CHECK(inChainOrder(given).nodes == toDomain(document).nodes);
}

TEST_CASE("Loose ends: a curve with moved ends does not cross what it was apart from") {
    Domain domain;
    domain.curves = {Curve::cubic({0, 0}, {3, 1}, {7, 1}, {10, 0})};
    const Vec2 below{0.0, -0.009};
    // Its ends are below the curve by that; a line ends just under its highest point.
    domain.nodes = {below,
                    domain.curves[0].point(0.25),
                    domain.curves[0].point(0.5),
                    domain.curves[0].point(0.75),
                    Vec2{10.0, 0.0} + below,
                    {10.0, -5.0},
                    {0.0, -5.0}};
    const auto add = [&](std::uint32_t a, std::uint32_t b, SegmentRole role, CurveStretch stretch = {}) {
        domain.segments.push_back({a, b, 1, role, stretch});
    };
    add(4, 3, SegmentRole::Boundary, {0, 1.0, 0.75});
    add(3, 2, SegmentRole::Boundary, {0, 0.75, 0.5});
    add(2, 1, SegmentRole::Boundary, {0, 0.5, 0.25});
    add(1, 0, SegmentRole::Boundary, {0, 0.25, 0.0});
    add(0, 6, SegmentRole::Boundary);
    add(6, 5, SegmentRole::Boundary);
    add(5, 4, SegmentRole::Boundary);
    REQUIRE(validate(domain).empty());
    SUBCASE("nothing nearby: the whole curve is moved") {
        const Document document = fromDomain(domain);
        REQUIRE(document.shapes.size() == 1);
        CHECK(document.shapes[0]->nodes.size() == 4);
        CHECK(validate(toDomain(document)).empty());
    }
    SUBCASE("a line nearby: the outer chords are moved") {
        domain.nodes.insert(domain.nodes.end(), {{5.0, 0.745}, {5.0, 0.5}});
        add(7, 8, SegmentRole::Constraint);
        REQUIRE(validate(domain).empty());
        const Document document = fromDomain(domain);
        REQUIRE(document.shapes.size() == 2);
        CHECK(document.shapes[0]->nodes.size() == 6);
        const Domain drawn = toDomain(document);
        CHECK(validate(drawn).empty());
        CHECK(drawn.segments.size() == domain.segments.size());
        CHECK(validate(toDomain(fromDomain(drawn))).empty());
    }
    const Domain ordered = inChainOrder(domain), drawn = toDomain(fromDomain(domain));
    CHECK(ordered.nodes == drawn.nodes);
    CHECK(ordered.curves == drawn.curves);
}

TEST_CASE("Loose ends: repairing a drawing does not move a curve across its neighbour") {
    // A constraint curve runs just below the upper side of an area. Ends of other shapes come first by x, so that the
    // ends of the upper curve move down onto them, and those of the lower one up.
    Document document;
    const auto add = [&](ShapeKind kind, std::vector<Vec2> nodes, std::vector<Curve> curves = {}) {
        Shape shape;
        shape.id = document.nextId++;
        shape.form = formOf(kind);
        shape.use = kind == ShapeKind::Polygon ? ShapeUse::Boundary : ShapeUse::Constraint;
        shape.nodes = std::move(nodes);
        shape.path().curves = std::move(curves);
        shape.cuts.resize(shape.path().curves.size());
        for (std::size_t k = 0; k < shape.path().curves.size(); ++k) {
            shape.cuts[k] = shape.path().curves[k].kind() == CurveKind::Cubic ? std::vector{0.25, 0.5, 0.75}
                                                                              : std::vector<double>{};
        }
        document.shapes.push_back(std::make_shared<const Shape>(std::move(shape)));
    };
    add(ShapeKind::Polygon, {{10, 0}, {0, 0}, {0, -5}, {10, -5}},
        {Curve::cubic({10, 0}, {7, 1}, {3, 1}, {0, 0}), {}, {}, {}});
    add(ShapeKind::Polygon, {{-0.001, -0.009}, {-3, 3}, {-3, -3}});
    add(ShapeKind::Polygon, {{9.999, -0.009}, {13, -3}, {13, 3}});
    add(ShapeKind::Polyline, {{3, 0.5}, {7, 0.5}}, {Curve::cubic({3, 0.5}, {4.33, 0.8194}, {5.67, 0.8194}, {7, 0.5})});
    add(ShapeKind::Polyline, {{2.999, 0.509}, {2.5, 0.4}});
    add(ShapeKind::Polyline, {{6.999, 0.509}, {7.2, 0.3}});
    const Result<RepairedDrawing> repaired = repairDrawing(document, 0.0095);
    REQUIRE(repaired.ok());
    CHECK(!repaired->changes.empty());
    CHECK(repaired->left.empty());
    CHECK(validate(toDomain(repaired->document)).empty());
}
