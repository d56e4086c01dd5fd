#include "tests/unit/constraint_samples.hpp"

#include "core/drawing/constraints/orient.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <utility>

namespace forefront::constraint_test {

using namespace edit_test;
using Kind = ConstraintKind;

namespace {

/// A path of two lines, an arc of a circle, a line and a Bézier curve.
Shape mixedPath() {
    Shape path = makeShape(ShapeKind::Polygon, {{0, 0}, {10, 1}, {12, 3}, {11, 12}, {1, 9}});
    path.path().curves = {Curve(), Curve::arc({10, 3}, {2, 0}, {0, 2}, -0.5 * std::numbers::pi, 0.5 * std::numbers::pi),
                          Curve(), Curve::cubic({11, 12}, {8, 15}, {4, 13}, {1, 9}), Curve()};
    path.nodes[1] = {10, 1};
    return path;
}

} // namespace

SketchPart node(std::uint32_t shape, std::uint32_t k) {
    return {shape, SketchPartKind::Node, k};
}
SketchPart segment(std::uint32_t shape, std::uint32_t k) {
    return {shape, SketchPartKind::Segment, k};
}

std::string messageOf(const Result<Document> &result) {
    return result ? std::string() : result.faults().front().message;
}

void constrain(Document &document, Kind kind, std::vector<SketchPart> parts) {
    Result<Document> next = addConstraint(document, kind, std::move(parts));
    CAPTURE(std::string(wordOf(kind)));
    REQUIRE_MESSAGE(next.ok(), messageOf(next));
    document = *std::move(next);
}

void checkAllHold(const Document &document) {
    for (const auto &constraint : document.constraints) {
        CAPTURE(constraint->name);
        CHECK(partsFault(document, constraint->kind, constraint->parts).empty());
        CHECK(holdsIn(document, *constraint));
    }
}

Document drivenPlate() {
    Document document = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {40, 0}, {40, 30}, {0, 30}})});
    constrain(document, Kind::Horizontal, {segment(1, 0)});
    constrain(document, Kind::Horizontal, {segment(1, 2)});
    constrain(document, Kind::Vertical, {segment(1, 1)});
    constrain(document, Kind::Vertical, {segment(1, 3)});
    constrain(document, Kind::Fixed, {node(1, 0)});
    constrain(document, Kind::Length, {segment(1, 0)});
    constrain(document, Kind::Length, {segment(1, 1)});
    return document;
}

Document everyShape() {
    Shape slot = makeShape(ShapeKind::Slot, {{30, 2}, {38, 5}});
    slot.form = SlotForm{2.0};
    Shape rounded = makeShape(ShapeKind::Rectangle, {{60, 0}, {72, 9}});
    rounded.form = RectangleForm{1.5};
    return documentOf({mixedPath(), makeShape(ShapeKind::Polyline, {{15, 1}, {21, 2}, {22, 9}}),
                       makeShape(ShapeKind::Rectangle, {{0, 20}, {9, 26}}),
                       makeShape(ShapeKind::Circle, {{20, 24}, {23, 24}}), makeShape(ShapeKind::Point, {{28, 20}}),
                       makeShape(ShapeKind::Ellipse, {{40, 22}, {46, 23}, {39.5, 25}}), slot,
                       makeShape(ShapeKind::Circle, {{50, 8}, {54, 9}}), rounded});
}

std::vector<SketchPart> partsOf(const Document &document) {
    std::vector<SketchPart> parts = {{0, SketchPartKind::Origin, 0}, {0, SketchPartKind::YAxis, 0}};
    for (const auto &shape : document.shapes) {
        for (std::uint32_t k = 0; k < 8; ++k) {
            for (const SketchPartKind kind : {SketchPartKind::Node, SketchPartKind::Segment, SketchPartKind::Centre,
                                              SketchPartKind::StartControl, SketchPartKind::EndControl}) {
                if (formOfPart(document, {shape->id, kind, k}) != PartForm::None) {
                    parts.push_back({shape->id, kind, k});
                }
            }
        }
    }
    return parts;
}

} // namespace forefront::constraint_test
