#pragma once

#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"

namespace forefront::test {

/// Draws a rectangle, and another one in it that is a constraint.
inline void drawTwoFaces(Draughtsman &driver) {
    driver.rectangle({1, 1}, {9, 8});
    Shape inner;
    inner.form = RectangleForm{};
    inner.use = ShapeUse::Constraint;
    inner.nodes = {{2, 3}, {5, 7}};
    inner.tag = 2;
    driver.context().document.apply(*addShape(driver.document(), inner), "Inner");
}

} // namespace forefront::test
