#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/constraints/sketch_state.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/source/import_notes.hpp"
#include "core/files/source/source.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace forefront::constraint_test {

using namespace edit_test;
using Kind = ConstraintKind;

TEST_CASE("Dimensions: a value that a formula or a lock sets is refused with its name") {
    Document document =
        documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {8, 0}}), makeShape(ShapeKind::Circle, {{30, 0}, {34, 0}})});
    document.parameters = {{"d", "16"}};
    document.spacing.names = {{"d", 16.0}};
    document = setFormula(document, {NumberOwner::ofShape(1), Quantity::Radius, 0}, "d/2");
    Result<Document> refused = addConstraint(document, Kind::Diameter, {segment(1)});
    CHECK(codeOf(refused) == "constraint-redundant");
    CHECK(messageOf(refused) == "Diameter 1 is set by the formula radius of circle 1 = d/2");
    CHECK(refused.faults().front().advice == "leave it out, or enter a number in place of the formula first");
    Result<Document> locked = setLocked(document, {2}, true);
    REQUIRE(locked.ok());
    refused = addConstraint(*locked, Kind::Radius, {segment(2)});
    CHECK(messageOf(refused) == "Radius 1 always holds: circle 2 is locked");
    const Document plate = documentOf({makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 3}})});
    refused = addConstraint(plate, Kind::Horizontal, {segment(1, 0)});
    CHECK(messageOf(refused) == "Horizontal 1 always holds here: the form of the shapes implies it");
    CHECK(refused.faults().front().advice == "leave it out");
}

} // namespace forefront::constraint_test
