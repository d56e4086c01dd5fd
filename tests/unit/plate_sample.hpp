#pragma once

#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <utility>

namespace forefront::edit_test {

/// A plate of width 4r with a circle of radius r in it, and a source of that size.
inline Document plate() {
    Result<Document> drawn = setParameters({}, {{"gap", "2*r"}, {"r", "0.5"}});
    REQUIRE(drawn.ok());
    drawn = addShapes(
        *drawn, {makeShape(ShapeKind::Rectangle, {{0, 0}, {2, 3}}), makeShape(ShapeKind::Circle, {{1, 1}, {1.5, 1}})});
    REQUIRE(drawn.ok());
    SizeSource source;
    source.a = {1, 1};
    source.radius = 1.0;
    source.size = 0.25;
    drawn = addSource(*drawn, source);
    REQUIRE(drawn.ok());
    drawn->formulas = {{"shape/1/width"_number, "2*gap"},
                       {"shape/2/radius"_number, "r"},
                       {"source/0/size"_number, "r/2"},
                       {"source/0/radius"_number, "gap"}};
    pruneFormulas(*drawn);
    REQUIRE(drawn->formulas.size() == 4);
    return *std::move(drawn);
}

} // namespace forefront::edit_test
