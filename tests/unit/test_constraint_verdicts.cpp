// What is said of constraints without a solution is true: a named set cannot hold together, or no solution was found.
#include "core/drawing/constraints/conflict.hpp"
#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/sketch/solve_sketch.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront::constraint_test {

using namespace edit_test;
using Kind = ConstraintKind;

namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

/// An angle bracket whose two arms are both as wide as the parameter d, which is 32, with rounded corners and a fillet.
Document bracket() {
    Shape shape =
        makeShape(ShapeKind::Polygon,
                  {{0, 0}, {120, 0}, {120, 24}, {112, 32}, {44, 32}, {32, 44}, {32, 92}, {24, 100}, {0, 100}});
    shape.path().curves.assign(9, Curve());
    shape.path().curves[2] = Curve::arc({112, 24}, {8, 0}, {0, 8}, 0.0, kQuarter);
    shape.path().curves[4] = Curve::arc({44, 44}, {12, 0}, {0, 12}, 3.0 * kQuarter, -kQuarter);
    shape.path().curves[6] = Curve::arc({24, 92}, {8, 0}, {0, 8}, 0.0, kQuarter);
    Document document = documentOf({shape});
    constrain(document, Kind::Coincident, {node(1, 0), {0, SketchPartKind::Origin, 0}});
    for (const std::uint32_t side : {0U, 3U, 7U}) {
        constrain(document, Kind::Horizontal, {segment(1, side)});
    }
    for (const std::uint32_t side : {1U, 5U, 8U}) {
        constrain(document, Kind::Vertical, {segment(1, side)});
    }
    constexpr std::array<std::array<std::uint32_t, 3>, 6> kTangents = {
        {{1, 2, 2}, {3, 2, 3}, {3, 4, 4}, {5, 4, 5}, {5, 6, 6}, {7, 6, 7}}}; // a side, an arc and their node
    for (const auto &[side, arc, at] : kTangents) {
        constrain(document, Kind::Tangent, {segment(1, side), segment(1, arc), node(1, at), node(1, at)});
    }
    constrain(document, Kind::Equal, {segment(1, 2), segment(1, 6)});
    constrain(document, Kind::Radius, {segment(1, 2)});
    constrain(document, Kind::Radius, {segment(1, 4)});
    constrain(document, Kind::Length, {segment(1, 0)});
    constrain(document, Kind::Length, {segment(1, 8)});
    document.parameters = {{"d", "32"}};
    document.spacing.names = {{"d", 32.0}};
    constexpr std::array<std::array<std::uint32_t, 2>, 2> kArms = {{{0, 3}, {8, 5}}};
    for (const auto &[side, other] : kArms) {
        constrain(document, Kind::Distance, {segment(1, side), segment(1, other)});
        const std::uint32_t id = document.constraints.back()->id;
        document = setFormula(document, {NumberOwner::ofConstraint(id), Quantity::Value, 0}, "d");
    }
    return document;
}

/// Returns the bracket with other arms, not solved, and the constraints that changed.
std::pair<Document, std::set<std::uint32_t>> withArms(Document document, double d) {
    std::set<std::uint32_t> changed;
    for (auto &constraint : document.constraints) {
        if (constraint->kind == Kind::Distance) {
            SketchConstraint wider = *constraint;
            wider.value = d;
            constraint = std::make_shared<const SketchConstraint>(wider);
            changed.insert(wider.id);
        }
    }
    return {document, changed};
}

} // namespace

TEST_CASE("Constraints: a named conflict cannot hold together, and each part of it is needed") {
    const Document document = bracket();
    std::size_t certain = 0;
    for (const double d : {95.0, 100.0, 150.0, 200.0, 1000.0}) {
        CAPTURE(d);
        const auto [wider, changed] = withArms(document, d);
        const DocumentSketch sketch = sketchOf(wider, wider, {.places = &wider});
        const std::vector<double> nearest = nearestValues(sketch.system);
        const Clash clash = smallestClash(sketch.system, changed);
        REQUIRE(!clash.ids.empty());
        CHECK(cannotHold(sketch.system, clash.ids, nearest) == clash.certain);
        certain += clash.certain ? 1 : 0;
        for (const std::uint32_t id : clash.ids) {
            std::set<std::uint32_t> others = clash.ids;
            others.erase(id);
            CHECK(!cannotHold(sketch.system, others, nearest));
        }
    }
    CHECK(certain > 1);
}

TEST_CASE("Constraints: where a solution exists far away, the refusal says that none was found near by") {
    const Result<Document> wide = overrideParameters(bracket(), {{"d", "300"}}); // its sides would cross
    REQUIRE_FALSE(wide.ok());
    CHECK(codeOf(wide) == "constraint-conflict");
    INFO(messageOf(wide));
    CHECK(messageOf(wide).find("no solution was found near by for constraints ") != std::string::npos);
    CHECK(messageOf(wide).find("cannot hold") == std::string::npos);
    CHECK(wide.faults().front().advice.find("smaller steps") != std::string::npos);

    const auto [arms, changed] = withArms(bracket(), 300.0);
    const DocumentSketch sketch = sketchOf(arms, arms, {.places = &arms});
    std::set<std::uint32_t> all;
    for (const auto &constraint : arms.constraints) {
        all.insert(constraint->id);
    }
    CHECK(!cannotHold(sketch.system, all, nearestValues(sketch.system)));
}

} // namespace forefront::constraint_test
