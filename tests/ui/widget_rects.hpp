#pragma once

#include "tests/ui/driver.hpp"
#include "ui/parts/shell.hpp"

#include <doctest/doctest.h>

#include <string>

namespace forefront::test {

/// Returns the rectangle of a widget, which must be drawn.
inline PixelRect rectOf(Driver &driver, const std::string &widget) {
    const WidgetRegistry::Widget *const found = driver.context().widgets.find(widget);
    REQUIRE_MESSAGE(found != nullptr, widget);
    return found->rect;
}

/// Returns true if a rectangle is wholly in another.
inline bool within(const PixelRect &inner, const PixelRect &outer) {
    return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
           inner.y + inner.height <= outer.y + outer.height;
}

} // namespace forefront::test
