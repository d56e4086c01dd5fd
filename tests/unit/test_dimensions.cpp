#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/dimensions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace forefront {
namespace {

std::vector<Dimension> dimensionsOf(const Shape &shape) {
    Document document;
    document.shapes.push_back(std::make_shared<const Shape>(shape));
    return dimensionsOf(document);
}

std::vector<double> valuesOf(const std::vector<Dimension> &dimensions, DimensionKind kind) {
    std::vector<double> values;
    for (const Dimension &dimension : dimensions) {
        if (dimension.kind == kind) {
            values.push_back(dimension.value);
        }
    }
    return values;
}

} // namespace

TEST_CASE("dimensionsOf: lengths of straight segments, with the outside to the right, in both orientations") {
    std::vector<Vec2> corners{{0, 0}, {4, 0}, {4, 3}};
    for (const bool reversed : {false, true}) {
        CAPTURE(reversed);
        Shape shape;
        shape.id = 7;
        shape.nodes = corners;
        const std::vector<Dimension> found = dimensionsOf(shape);
        std::vector<double> lengths = valuesOf(found, DimensionKind::Length);
        std::sort(lengths.begin(), lengths.end());
        CHECK(lengths == std::vector<double>{3, 4, 5});
        for (const Dimension &dimension : found) {
            CHECK(dimension.shape == 7);
            if (dimension.kind == DimensionKind::Length) {
                CHECK(cross(dimension.to - dimension.from, Vec2{3, 1} - dimension.from) > 0.0); // a place inside
            }
        }
        std::vector<double> angles = valuesOf(found, DimensionKind::Angle); // but none of 90 degrees
        std::sort(angles.begin(), angles.end());
        REQUIRE(angles.size() == 2);
        CHECK(angles[0] == doctest::Approx(36.8698976));
        CHECK(angles[1] == doctest::Approx(53.1301024));
        std::reverse(corners.begin(), corners.end());
    }
}

TEST_CASE("dimensionsOf: the angle inside a closed shape may exceed 180 degrees, that of an open one does not") {
    Shape shape;
    shape.nodes = {{0, 0}, {2, 1}, {4, 0}, {2, 4}}; // an arrow head
    const std::vector<double> closed = valuesOf(dimensionsOf(shape), DimensionKind::Angle);
    CHECK(*std::max_element(closed.begin(), closed.end()) == doctest::Approx(233.130102));
    shape.form = PathForm{.closed = false};
    shape.nodes.resize(3);
    const std::vector<Dimension> open = dimensionsOf(shape);
    const std::vector<double> angles = valuesOf(open, DimensionKind::Angle);
    REQUIRE(angles.size() == 1);
    CHECK(angles[0] == doctest::Approx(126.869898));
    for (const Dimension &dimension : open) {
        if (dimension.kind == DimensionKind::Length) {
            CHECK(dimension.to.x < dimension.from.x); // the right side is the upper one
        }
    }
}

TEST_CASE("dimensionsOf: radii of circles, arcs, ellipses and rounded corners; none of hidden shapes and points") {
    Shape circle;
    circle.form = CircleForm{};
    circle.nodes = {{1, 1}, {1, 9}};
    const std::vector<Dimension> round = dimensionsOf(circle);
    REQUIRE(round.size() == 1);
    CHECK(round[0].kind == DimensionKind::Radius);
    CHECK(round[0].value == doctest::Approx(8));
    CHECK(distance(round[0].to, {1, 1}) == doctest::Approx(8));
    Shape ellipse;
    ellipse.form = EllipseForm{};
    ellipse.nodes = {{0, 0}, {3, 0}, {0, 2}};
    CHECK(valuesOf(dimensionsOf(ellipse), DimensionKind::RadiusX) == std::vector<double>{3});
    CHECK(valuesOf(dimensionsOf(ellipse), DimensionKind::RadiusY) == std::vector<double>{2});
    Shape path;
    path.form = PathForm{.closed = false};
    path.nodes = {{2, 0}, {0, 2}, {0, 5}, {4, 5}};
    path.path().curves = {Curve::arc({0, 0}, {2, 0}, {0, 2}, 0.0, 1.57079632679489662), Curve(),
                          Curve::cubic({0, 5}, {1, 6}, {3, 6}, {4, 5})};
    const std::vector<Dimension> mixed = dimensionsOf(path);
    CHECK(mixed.size() == 2); // nothing for the cubic and the corners beside curves
    CHECK(valuesOf(mixed, DimensionKind::Length) == std::vector<double>{3});
    REQUIRE(valuesOf(mixed, DimensionKind::Radius).size() == 1);
    CHECK(valuesOf(mixed, DimensionKind::Radius)[0] == doctest::Approx(2));
    Shape rounded;
    rounded.form = RectangleForm{};
    rounded.nodes = {{0, 0}, {6, 4}};
    rounded.as<RectangleForm>().radius = 0.5;
    CHECK(valuesOf(dimensionsOf(rounded), DimensionKind::Length).size() == 4);
    CHECK(valuesOf(dimensionsOf(rounded), DimensionKind::Radius).size() == 4);
    CHECK(valuesOf(dimensionsOf(rounded), DimensionKind::Angle).empty());
    rounded.hidden = true;
    CHECK(dimensionsOf(rounded).empty());
    Shape point;
    point.form = PointForm{};
    point.nodes = {{1, 1}};
    CHECK(dimensionsOf(point).empty());
}

} // namespace forefront
