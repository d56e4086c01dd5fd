// Whatever a command makes of the parts of constraints, the drawing can be saved and read again.
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/constraints/carry_constraints.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace forefront::constraint_test {

using namespace edit_test;

namespace {

/// Completes a command and checks that its constraints fit their parts and that a project with them is read.
Document keptThrough(const Document &before, const Result<Document> &command) {
    REQUIRE(command.ok());
    const Result<Document> settled = settleCommand(before, *command);
    REQUIRE_MESSAGE(settled.ok(), messageOf(settled));
    for (const auto &constraint : settled->constraints) {
        CHECK_MESSAGE(constraintFault(*settled, *constraint).empty(), constraint->name);
    }
    const Result<Document> read = parseProject(projectText(*settled), "kept");
    REQUIRE_MESSAGE(read.ok(), messageOf(read));
    CHECK(sameContent(*read, *settled));
    return *settled;
}

bool loses(const Document &before, const Document &after, const std::string &name) {
    const std::vector<std::string> lost = lostConstraints(before, after);
    return std::find(lost.begin(), lost.end(), name) != lost.end();
}

/// A slot-like path: two straight sides and two half circles, tangent, with a radius and a length.
Document tangentPath() {
    Shape shape = makeShape(ShapeKind::Polygon, {{0, 0}, {6, 0}, {6, 2}, {0, 2}});
    std::vector<Curve> curves(4, Curve::line({}, {}));
    curves[1] = Curve::arc({6, 1}, {0, -1}, {1, 0}, 0.0, 3.141592653589793);
    curves[3] = Curve::arc({0, 1}, {0, 1}, {-1, 0}, 0.0, 3.141592653589793);
    std::get<PathForm>(shape.form).curves = curves;
    Document document = documentOf({shape});
    constrain(document, ConstraintKind::Tangent, {segment(1, 0), segment(1, 1)});
    constrain(document, ConstraintKind::Equal, {segment(1, 1), segment(1, 3)});
    constrain(document, ConstraintKind::Radius, {segment(1, 1)});
    constrain(document, ConstraintKind::Length, {segment(1, 0)});
    return document;
}

} // namespace

TEST_CASE("Constraints kept: a line that becomes a curve loses what only a line can have") {
    const Document plate = drivenPlate();
    for (std::uint32_t side = 0; side < 4; ++side) {
        const Document curved = keptThrough(plate, setCurved(plate, {{1, side}}, true));
        for (const auto &constraint : plate.constraints) {
            const bool level =
                constraint->kind == ConstraintKind::Horizontal || constraint->kind == ConstraintKind::Vertical;
            const bool ofSide = constraint->parts.front() == segment(1, side);
            CHECK(loses(plate, curved, constraint->name) == (level && ofSide));
        }
    }
}

TEST_CASE("Constraints kept: a slot that is stretched along itself keeps its tangents and radii") {
    const Document path = tangentPath();
    const Document stretched =
        keptThrough(path, transformSelection(path, selected({1}), PlaneMap::scaling({1.25, 1.0}, {-1, 0})));
    CHECK(lostConstraints(path, stretched).empty());
    checkAllHold(stretched);
    const Box2 box = boundsOf(*stretched.shapes[0]);
    CHECK(box.min == Vec2{-1, 0});
    CHECK(box.max.x == doctest::Approx(9.0)); // 1.25 of 8, as was asked for
    CHECK(box.max.y == doctest::Approx(2.0));
    CHECK(findConstraint(stretched, 4)->value == doctest::Approx(1.0)); // the radius
    CHECK(findConstraint(stretched, 5)->value == doctest::Approx(8.0)); // the length takes all of the stretch
}

TEST_CASE("Constraints kept: an outline with rounded corners keeps its tangents when it is stretched along the axes") {
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    Shape shape = makeShape(ShapeKind::Polygon, {{1, 0}, {9, 0}, {10, 1}, {10, 5}, {9, 6}, {1, 6}, {0, 5}, {0, 1}});
    std::vector<Curve> curves(8, Curve::line({}, {}));
    const Vec2 centres[] = {{9, 1}, {9, 5}, {1, 5}, {1, 1}};
    for (std::size_t k = 0; k < 4; ++k) {
        curves[2 * k + 1] = Curve::arc(centres[k], {1, 0}, {0, 1}, kQuarter * (static_cast<double>(k) - 1.0), kQuarter);
    }
    std::get<PathForm>(shape.form).curves = curves;
    Document path = documentOf({shape});
    for (std::uint32_t k = 0; k < 8; ++k) {
        constrain(path, ConstraintKind::Tangent, {segment(1, k), segment(1, (k + 1) % 8)});
    }
    constrain(path, ConstraintKind::Radius, {segment(1, 1)});
    constrain(path, ConstraintKind::Horizontal, {segment(1, 0)});
    for (const Vec2 factors : {Vec2{1.5, 1.0}, Vec2{1.0, 0.5}, Vec2{1.5, 0.75}}) {
        const Document stretched =
            keptThrough(path, transformSelection(path, selected({1}), PlaneMap::scaling(factors, {0, 0})));
        CHECK(lostConstraints(path, stretched).empty());
        checkAllHold(stretched);
        CHECK(boundsOf(*stretched.shapes[0]).size().x == doctest::Approx(10.0 * factors.x));
        CHECK(boundsOf(*stretched.shapes[0]).size().y == doctest::Approx(6.0 * factors.y));
    }
}

TEST_CASE("Constraints kept: arcs that must become ellipses lose tangents and radii, and keep them when only scaled") {
    const Document path = tangentPath();
    const Document stretched =
        keptThrough(path, transformSelection(path, selected({1}), PlaneMap::scaling({1.25, 0.8}, {0, 0})));
    CHECK(stretched.constraints.size() == 1); // the length
    CHECK(lostConstraints(path, stretched).size() == path.constraints.size() - 1);
    const Document scaled =
        keptThrough(path, transformSelection(path, selected({1}), PlaneMap::scaling({1.25, 1.25}, {0, 0})));
    CHECK(scaled.constraints.size() == path.constraints.size());
}

TEST_CASE("Constraints kept: shapes of every kind with what can be constrained about them, stretched, turned, curved") {
    const Document shapes = everyShape();
    const std::vector<SketchPart> parts = partsOf(shapes);
    std::size_t made = 0, lost = 0;
    for (std::size_t kind = 0; kind < wordsOf<ConstraintKind>().size(); ++kind) {
        for (std::size_t k = 0; k < parts.size(); ++k) {
            for (const std::size_t other : {k, (k + 7) % parts.size(), (k + 20) % parts.size()}) {
                const std::vector<SketchPart> of =
                    other == k ? std::vector<SketchPart>{parts[k]} : std::vector<SketchPart>{parts[k], parts[other]};
                const Result<Document> bound = addConstraint(shapes, static_cast<ConstraintKind>(kind), of);
                if (!bound.ok()) {
                    continue;
                }
                ++made;
                for (const PlaneMap &map : {PlaneMap::scaling({1.5, 0.75}, {0, 0}), PlaneMap::rotation(35.0, {1, 1})}) {
                    const Result<Document> mapped = transformSelection(*bound, selected({parts[k].shape}), map);
                    if (mapped.ok() && settleCommand(*bound, *mapped).ok()) {
                        lost += keptThrough(*bound, mapped).constraints.empty() ? 1 : 0;
                    }
                }
                if (parts[k].kind == SketchPartKind::Segment) {
                    const Result<Document> curved = setCurved(*bound, {{parts[k].shape, parts[k].index}}, true);
                    if (curved.ok() && settleCommand(*bound, *curved).ok()) {
                        lost += keptThrough(*bound, curved).constraints.empty() ? 1 : 0;
                    }
                }
            }
        }
    }
    CHECK(made > 200);
    CHECK(lost > 20);
    CHECK(lost < made);
}

} // namespace forefront::constraint_test
