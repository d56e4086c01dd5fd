#include "core/drawing/document/equality.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

namespace forefront::test {

namespace {

void startAnew(Draughtsman &driver) {
    driver.key('N', {Modifiers::kControl});
    driver.settle();
    if (driver.has("dialog/unsaved/discard")) {
        driver.click("dialog/unsaved/discard");
        driver.settle();
    }
}

} // namespace

TEST_CASE("New: tags and sizes of the next items are those of a fresh program") {
    Draughtsman driver, fresh;
    driver.key('R');
    driver.fill("options/tag", "7");
    driver.fill("options/cornerradius", "0.5");
    driver.rectangle({1, 1}, {4, 4});
    CHECK(driver.document().shapes[0]->tag == 7);
    driver.key('B');
    driver.fill("options/brush/radius", "3");
    driver.fill("options/brush/spacing", "0.01");
    driver.key('S');
    driver.fill("options/source/size", "0.02");
    driver.fill("options/source/growth", "0.9");
    startAnew(driver);
    for (Draughtsman *each : {&driver, &fresh}) {
        each->rectangle({1, 1}, {4, 4});
        each->settle();
        each->key('B');
        each->settle(); // the spacing is computed on another thread; sizes of brush and source derive from it
        each->dragPlaces({2, 2}, {3, 3});
        each->settle();
        each->key('S');
        each->clickPlace({3, 2});
        each->settle();
    }
    const Document &document = driver.document(), &expected = fresh.document();
    CHECK(document.shapes[0]->tag == 1);
    CHECK(document.shapes[0]->as<RectangleForm>().radius == 0.0);
    CHECK_FALSE(expected.spacing.paint.tiles.empty());
    CHECK(expected.spacing.sources.size() == 1);
    CHECK(sameContent(document, expected));
}

TEST_CASE("New: an unfinished path does not continue in the new drawing") {
    Draughtsman driver;
    driver.key('P');
    driver.clickPlace({1, 1});
    driver.clickPlace({4, 1});
    startAnew(driver);
    driver.clickPlace({4, 4});
    driver.key(key::kEnter);
    CHECK(driver.document().shapes.empty());
}

TEST_CASE("New: a path that could be finished is asked about") {
    Draughtsman driver;
    driver.key('P');
    for (const Vec2 corner : {Vec2{1, 1}, Vec2{5, 1}, Vec2{5, 4}}) {
        driver.clickPlace(corner);
    }
    driver.key('N', {Modifiers::kControl});
    driver.settle();
    REQUIRE(driver.has("dialog/unsaved/cancel"));
    driver.click("dialog/unsaved/cancel");
    CHECK(driver.document().shapes.size() == 1);
}

TEST_CASE("Undo: disabled in a fresh document, enabled for a change and for an unfinished path") {
    Draughtsman driver;
    const auto enabled = [&](const char *action) {
        return driver.context().actions.find(action)->enabled(driver.context());
    };
    const auto title = [&](const char *action) {
        return driver.context().actions.find(action)->dynamic(driver.context());
    };
    CHECK_FALSE(enabled("edit.undo"));
    CHECK_FALSE(enabled("edit.redo"));
    CHECK(title("edit.undo") == "Undo");
    driver.key('P');
    driver.clickPlace({1, 1});
    CHECK(title("edit.undo") == "Undo last point");
    driver.key('Z', {Modifiers::kControl});
    CHECK_FALSE(enabled("edit.undo"));
    CHECK(enabled("edit.redo"));
    driver.key('Z', {Modifiers::kControl | Modifiers::kShift});
    CHECK(enabled("edit.undo"));
    driver.clickPlace({4, 1});
    driver.key(key::kEscape);
    CHECK(title("edit.undo") == "Undo discarding the path");
    driver.rectangle({1, 1}, {4, 4});
    CHECK(title("edit.undo") == "Undo Draw rectangle");
    startAnew(driver);
    CHECK_FALSE(enabled("edit.undo"));
    driver.click("menu/Edit");
    REQUIRE(driver.has("menu/edit.undo"));
    CHECK_FALSE(driver.context().widgets.find("menu/edit.undo")->enabled);
}

} // namespace forefront::test
