#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

namespace forefront::test {

TEST_CASE("Menu keys: an open menu owns the keyboard") {
    Draughtsman driver;
    driver.key('V');
    driver.click("menu/File");
    REQUIRE(driver.has("menu/file.open"));
    for (const char letter : {'r', 'c', 'p'}) {
        driver.keys(std::string(1, letter));
    }
    driver.key(key::kDelete);
    driver.key(key::kSpace);
    CHECK(driver.context().tools.current().id() == std::string("select"));
    CHECK(driver.context().run.now().state == RunState::Empty);
    driver.key(key::kEscape);
    driver.settle();
    CHECK_FALSE(driver.has("menu/file.open"));
    driver.key('R');
    CHECK(driver.context().tools.current().id() == std::string("rectangle"));
}

TEST_CASE("Menu keys: Alt and a letter open a menu, arrows move through it and to its neighbours, Enter runs an item") {
    Draughtsman driver;
    driver.key('E', kAlt);
    driver.settle();
    REQUIRE(driver.has("menu/edit.undo"));
    driver.key(key::kRight);
    driver.settle();
    CHECK_FALSE(driver.has("menu/edit.undo"));
    CHECK(driver.has("menu/shape.mirrorX"));
    driver.key(key::kLeft);
    driver.settle();
    CHECK(driver.has("menu/edit.undo"));
    driver.key(key::kEscape);
    driver.settle();
    CHECK_FALSE(driver.has("menu/edit.undo"));
    driver.key('F', kAlt); // its first item is chosen
    driver.key(key::kDown);
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.context().dialogs.any());
    CHECK(driver.context().dialogs.top()->id() == std::string("open"));
}

TEST_CASE("Menu keys: a letter goes to the next item that begins with it") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    const std::size_t before = driver.document().shapes.size();
    driver.click("menu/Edit");
    driver.key('D'); // Delete or Duplicate, in the order of the menu
    driver.key('D');
    driver.key('D');
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.has("menu/edit.undo"));
    CHECK(driver.document().shapes.size() != before);
    CHECK(driver.context().tools.current().id() == std::string("select")); // D alone is the gradient tool
}

TEST_CASE("Menu keys: a field keeps its text when a menu is opened by a key") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.click("inspector/name");
    driver.type("plate");
    driver.key('E', kAlt);
    driver.settle();
    CHECK(driver.document().shapes[0]->name == "plate");
    CHECK(driver.has("menu/edit.undo"));
    driver.key(key::kEscape);
    driver.settle();
    driver.fill("inspector/cornerradius", "x+");
    driver.key('E', kAlt);
    driver.settle();
    CHECK_FALSE(driver.has("menu/edit.undo"));
    CHECK(driver.has("inspector/cornerradius/fault"));
}

} // namespace forefront::test
