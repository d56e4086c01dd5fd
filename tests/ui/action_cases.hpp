#pragma once

#include "tests/ui/edit_driver.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace forefront::test {

/// The state before an action ran.
struct StateBefore {
    explicit StateBefore(Draughtsman &driver)
        : document(driver.document()), selection(driver.context().selection), camera(driver.context().view.camera),
          settings(driver.context().settings), snapping(driver.context().snapping), advance(driver.run().advance),
          sequence(driver.run().sequence), run(driver.run().run), logged(driver.context().log.entries().size()) {}
    Document document;
    Selection selection;
    Camera camera;
    Settings settings;
    Snapping snapping;
    std::uint64_t advance, sequence, run;
    std::size_t logged;
};

// Short names for tables of cases.
using D = Draughtsman;
using B = StateBefore;

/// A situation in which an action can run, and what it must change there.
struct ActionCase {
    std::string id;
    void (*prepare)(Draughtsman &);
    bool (*done)(Draughtsman &, const StateBefore &);
};

/// Draws shapes without their tools.
void drawShapes(Draughtsman &driver, std::vector<Shape> shapes);
/// Draws three rectangles beside each other, at different heights, and selects them.
void drawThree(Draughtsman &driver);
/// Draws a triangle with a right angle at (2, 2), 4 wide and 2 high, and selects it.
void drawTriangle(Draughtsman &driver);
/// Draws a square and meshes it.
void drawMesh(Draughtsman &driver);
/// Returns true if the dialog on top has this id.
bool dialogIs(Draughtsman &driver, const std::string &id);

std::vector<ActionCase> documentActionCases(); ///< of the menus File and Edit
std::vector<ActionCase> shapeActionCases();    ///< of the menu Shape, and of paths
std::vector<ActionCase> viewActionCases();     ///< of the other menus, tools and snapping

} // namespace forefront::test
