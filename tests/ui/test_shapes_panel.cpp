#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <utility>

namespace forefront::test {

namespace {

/// Two squares, of which the second has a bottom of its own, and a region.
Document twoSquares() {
    Document document;
    for (int k = 0; k < 2; ++k) {
        Shape square;
        square.form = RectangleForm{};
        square.nodes = {{1.0 + 4.0 * k, 1}, {4.0 + 4.0 * k, 4}};
        document = *addShape(document, square);
    }
    document = *setSegmentTag(document, {{2, 0}}, 3);
    document = *setBoundaryName(document, 3, "inlet");
    return *addRegionMarker(document, {{2.5, 2.5}, 2, 0.0});
}

Document nineSquares() {
    Document document;
    for (int k = 0; k < 9; ++k) {
        Shape square;
        square.form = RectangleForm{};
        square.nodes = {{2.0 * k, 0}, {2.0 * k + 1.0, 1}};
        document = *addShape(document, square);
    }
    return document;
}

/// Returns the number of rows of nine shapes that are seen whole.
int rowsInSight(Driver &driver) {
    int rows = 0;
    for (int k = 1; k <= 9; ++k) {
        const auto *row = driver.context().widgets.find("shapes/" + std::to_string(k));
        const bool whole = row != nullptr && row->clip && row->rect.y >= row->clip->y &&
                           row->rect.y + row->rect.height <= row->clip->y + row->clip->height + 1.0;
        rows += whole ? 1 : 0;
    }
    return rows;
}

/// A driver with the Shapes panel open.
struct Tree : Draughtsman {
    explicit Tree(Document document = twoSquares()) {
        context().document.apply(std::move(document), "Draw");
        key('V');
        showPanel("shapes");
    }
    void rightClick(std::string_view widget) {
        const auto *found = context().widgets.find(widget);
        REQUIRE(found != nullptr);
        const Pixel at = found->rect.centre();
        press(at, MouseButton::Right);
        release(at, MouseButton::Right);
        settle();
    }
    void doubleClick(std::string_view widget) {
        click(widget);
        click(widget);
        settle();
    }
    const Selection &selection() { return context().selection; }
};

} // namespace

TEST_CASE("Shapes panel: shapes, boundary parts and regions are groups that fold") {
    Tree tree;
    for (const char *row : {"shapes/group/shapes", "shapes/1", "shapes/2", "shapes/group/parts", "shapes/part/1",
                            "shapes/part/3", "shapes/group/regions", "shapes/region/0"}) {
        CHECK_MESSAGE(tree.has(row), row);
    }
    CHECK_FALSE(tree.has("shapes/1/fold")); // it has one boundary part
    CHECK_FALSE(tree.has("shapes/2/part/3"));
    tree.click("shapes/2/fold");
    tree.settle();
    CHECK(tree.has("shapes/2/part/3"));
    tree.click("shapes/group/shapes");
    tree.settle();
    CHECK_FALSE(tree.has("shapes/2"));
    CHECK(tree.has("shapes/part/3"));
    tree.rightClick("shapes/group/shapes");
    tree.click("contextmenu/fold");
    tree.settle();
    CHECK_FALSE(tree.has("shapes/part/3"));
    CHECK(tree.has("shapes/group/regions"));
}

TEST_CASE(
    "Shapes panel: a click selects the shape, the boundary part or the region; Ctrl adds, Shift selects a range") {
    Tree tree;
    tree.click("shapes/1");
    CHECK(tree.selection().shapes == std::set<std::uint32_t>{1});
    tree.key(key::kEscape);
    tree.click("shapes/2/fold");
    tree.settle();
    tree.click("shapes/2/part/3");
    CHECK(tree.selection().segments == std::set<SegmentRef>{{2, 0}});
    CHECK(tree.selection().size() == 1);
    tree.click("shapes/part/1");
    CHECK(tree.selection().shapes == std::set<std::uint32_t>{1});
    CHECK(tree.selection().segments == std::set<SegmentRef>{{2, 1}, {2, 2}, {2, 3}});
    tree.click("shapes/region/0");
    CHECK(tree.selection().markers == std::set<std::uint32_t>{0});
    CHECK(tree.selection().size() == 1);
}

TEST_CASE("Shapes panel: hides and locks shapes, and its menu shows and unlocks them again") {
    Tree tree;
    tree.click("shapes/1");
    tree.click("shapes/1/eye");
    tree.settle();
    CHECK(tree.document().shapes[0]->hidden);
    CHECK(tree.selection().empty());
    tree.rightClick("shapes/1");
    tree.click("contextmenu/show");
    tree.settle();
    CHECK_FALSE(tree.document().shapes[0]->hidden);
    tree.click("shapes/2/lock");
    tree.settle();
    CHECK(tree.document().shapes[1]->locked);
    CHECK(tree.undoLabel() == "Lock shape");
    tree.rightClick("shapes/2");
    tree.click("contextmenu/unlock");
    tree.settle();
    CHECK_FALSE(tree.document().shapes[1]->locked);
    tree.rightClick("shapes/2");
    tree.click("contextmenu/shape.isolate");
    tree.settle();
    CHECK(tree.document().shapes[0]->hidden);
}

TEST_CASE("Shapes panel: F2 and a double-click rename a row in place; Esc keeps the name") {
    Tree tree;
    tree.doubleClick("shapes/1");
    REQUIRE(tree.has("shapes/rename"));
    tree.type("plate");
    tree.key(key::kEnter);
    tree.settle();
    CHECK_FALSE(tree.has("shapes/rename"));
    CHECK(tree.document().shapes[0]->name == "plate");
    CHECK(tree.undoLabel() == "Name shape");
    tree.click("shapes/part/3");
    tree.key(key::kF1 + 1);
    tree.settle();
    REQUIRE(tree.has("shapes/rename"));
    tree.type("outlet");
    tree.key(key::kEscape);
    tree.settle();
    CHECK_FALSE(tree.has("shapes/rename"));
    CHECK(tree.document().boundaryNames.at(3) == "inlet");
    tree.key(key::kF1 + 1);
    tree.settle();
    tree.type("outlet");
    tree.key(key::kEnter);
    tree.settle();
    CHECK(tree.document().boundaryNames.at(3) == "outlet");
    tree.rightClick("shapes/region/0");
    tree.click("contextmenu/edit.rename");
    tree.settle();
    tree.type("steel");
    tree.key(key::kEnter);
    tree.settle();
    CHECK(tree.document().regionNames.at(2) == "steel");
    CHECK_FALSE(tree.has("naming")); // not on the canvas
}

TEST_CASE("Shapes panel: a tag that gets the name of another one becomes that one") {
    Tree tree;
    tree.doubleClick("shapes/part/1");
    tree.type("inlet");
    tree.key(key::kEnter);
    tree.settle();
    CHECK(tree.document().shapes[0]->tag == 3);
    CHECK_FALSE(tree.has("shapes/part/1"));
}

TEST_CASE(
    "Shapes panel: a selection on the canvas reveals its row in a long list, of which only what is seen is drawn") {
    Document many;
    std::vector<Shape> squares;
    for (int k = 0; k < 10'000; ++k) {
        Shape square;
        square.form = RectangleForm{};
        const double x = 2.0 * (k % 100), y = 2.0 * (k / 100);
        square.nodes = {{x, y}, {x + 1.0, y + 1.0}};
        squares.push_back(square);
    }
    Tree tree(*addShapes(many, std::move(squares)));
    std::size_t rows = 0;
    for (const auto &[name, widget] : tree.context().widgets.all()) {
        rows += name.starts_with("shapes/") ? 1 : 0;
    }
    CHECK(rows < 100);
    CHECK(tree.has("shapes/1"));
    tree.context().selection.shapes = {7000};
    tree.frames(3);
    CHECK(tree.has("shapes/7000"));
    CHECK_FALSE(tree.has("shapes/1"));
    tree.context().selection = {.segments = {{1, 2}}};
    tree.frames(3);
    CHECK(tree.has("shapes/1"));
}

TEST_CASE("Shapes panel: at 1280x800 at least eight rows are in sight") {
    Tree tree(nineSquares());
    CHECK(rowsInSight(tree) >= 8);
}

TEST_CASE("Shapes panel: at scale 2, the headings of the tabs leave room for some rows") {
    EditorSetup setup;
    setup.sample = false;
    Driver driver(std::move(setup), {1280, 800}, 2.0);
    driver.context().document.apply(nineSquares(), "Draw");
    driver.showPanel("shapes");
    driver.settle();
    CHECK(rowsInSight(driver) >= 3); // below the heading of their group
}

TEST_CASE("Shapes panel: F2 renames a row again after it got another tag, and one that is folded away") {
    constexpr int kRename = key::kF1 + 1;
    Tree tree;
    tree.click("shapes/2/fold");
    tree.settle();
    tree.click("shapes/2/part/1");
    tree.key(kRename);
    tree.settle();
    REQUIRE(tree.has("shapes/rename"));
    tree.type("side"); // the first shape keeps tag 1, so these segments get another one
    tree.key(key::kEnter);
    tree.settle();
    CHECK_FALSE(tree.has("shapes/2/part/1"));
    tree.key(kRename);
    tree.settle();
    REQUIRE(tree.has("shapes/rename"));
    tree.key(key::kEscape);
    tree.settle();
    tree.click("shapes/group/shapes");
    tree.settle();
    tree.key(kRename);
    tree.settle();
    CHECK(tree.has("shapes/rename"));
}

TEST_CASE("Shapes panel: F2 does not rename what was deleted, nor what has its number now") {
    constexpr int kRename = key::kF1 + 1;
    Document document = twoSquares();
    document = *addRegionMarker(document, {{6.5, 2.5}, 3, 0.0});
    Tree tree(document);
    tree.click("shapes/1");
    tree.key(key::kDelete);
    tree.settle();
    REQUIRE(tree.document().shapes.size() == 1);
    tree.key(kRename);
    tree.settle();
    CHECK_FALSE(tree.context().naming.thing.has_value());
    tree.key('Z', kControl);
    tree.settle();
    CHECK_FALSE(tree.has("shapes/rename"));
    tree.click("shapes/region/0");
    tree.key(key::kDelete);
    tree.settle();
    REQUIRE(tree.document().regionMarkers.size() == 1);
    tree.key(kRename);
    tree.settle();
    CHECK_FALSE(tree.has("shapes/rename"));
}

TEST_CASE("Shapes panel: Shift selects all rows from the one clicked last, also boundary parts and after folding") {
    Tree tree;
    const auto shiftClick = [&](std::string_view widget) {
        const Pixel at = tree.context().widgets.find(widget)->rect.centre();
        tree.drag(at, at, 1, kShift);
        tree.settle();
    };
    tree.click("shapes/part/1");
    shiftClick("shapes/part/3");
    CHECK(tree.selection().shapes == std::set<std::uint32_t>{1});
    CHECK(tree.selection().segments == std::set<SegmentRef>{{2, 0}, {2, 1}, {2, 2}, {2, 3}});
    tree.click("shapes/region/0");
    tree.click("shapes/2/fold");
    tree.settle();
    shiftClick("shapes/part/3");
    CHECK(tree.selection().segments == std::set<SegmentRef>{{2, 0}});
    CHECK(tree.selection().markers == std::set<std::uint32_t>{0});
}

} // namespace forefront::test
