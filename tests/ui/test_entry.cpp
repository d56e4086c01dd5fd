#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/tools/common/numeric_entry.hpp"

#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

namespace forefront::test {

namespace {

/// Draws a rectangle by numbers alone.
void typeRectangle(Draughtsman &driver, const char *width, const char *height) {
    driver.key('R');
    driver.keys("0");
    driver.key(key::kTab);
    driver.keys("0");
    driver.key(key::kEnter);
    driver.keys(width);
    driver.key(key::kTab);
    driver.keys(height);
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
}

NumericEntry::Answer type(NumericEntry &entry, std::string_view text, std::span<const EntryField> fields) {
    NumericEntry::Answer answer = NumericEntry::Answer::Unused;
    for (const char c : text) {
        answer = entry.handle({.kind = CanvasEvent::Kind::Text, .character = static_cast<char32_t>(c)}, fields);
    }
    return answer;
}

NumericEntry::Answer press(NumericEntry &entry, int key, std::span<const EntryField> fields, Modifiers modifiers = {}) {
    return entry.handle({.kind = CanvasEvent::Kind::Key, .key = key, .modifiers = modifiers}, fields);
}

} // namespace

TEST_CASE("First shape: one that would be a speck is shown; a small one leaves the view alone") {
    Draughtsman driver;
    typeRectangle(driver, "0.2", "0.1");
    const Box2 box = boundsOf(driver.document());
    CHECK(box.max == Vec2{0.2, 0.1});
    CHECK(box.size().x * driver.context().view.camera.zoom > 0.5 * driver.canvas().width);
    const Camera shown = driver.context().view.camera;
    driver.context().snapping.toGrid = false;
    driver.polygon({{0.05, 0.05}, {0.051, 0.05}, {0.05, 0.051}}); // not the first one
    CHECK(driver.context().view.camera.zoom == shown.zoom);

    Draughtsman other;
    const double zoom = other.context().view.camera.zoom;
    typeRectangle(other, "2.2", "0.41");
    CHECK(other.context().view.camera.zoom == zoom);
}

TEST_CASE("Numbers typed while drawing show all their digits, also after Tab; a formula its value") {
    constexpr std::array kPlace{EntryField::X, EntryField::Y};
    NumericEntry entry;
    type(entry, "687123.25", kPlace);
    press(entry, key::kTab, kPlace);
    type(entry, "5312945.125", kPlace);
    CHECK(entry.label() == "x 687123.25   y 5312945.125_");
    press(entry, key::kTab, kPlace);
    CHECK(entry.label() == "x 687123.25_   y 5312945.125");
    CHECK(entry.value(EntryField::Y) == 5312945.125);
    entry.clear();
    type(entry, "100000/8+0.0625", kPlace);
    press(entry, key::kTab, kPlace);
    CHECK(entry.label() == "x 12500.0625   y _");
}

TEST_CASE("Ctrl+A in a number typed on the canvas selects its text, not the shapes") {
    constexpr std::array kSize{EntryField::Width, EntryField::Height};
    NumericEntry entry;
    type(entry, "12.5", kSize);
    CHECK(press(entry, 'A', kSize, {Modifiers::kControl}) == NumericEntry::Answer::Used);
    CHECK(entry.label() == "width [12.5]   height");
    press(entry, key::k0 + 7, kSize); // the key, then its character
    type(entry, "7", kSize);
    CHECK(entry.value(EntryField::Width) == 7.0);
    press(entry, 'A', kSize, {Modifiers::kControl});
    press(entry, key::kBackspace, kSize);
    CHECK_FALSE(entry.value(EntryField::Width).has_value());
    CHECK(entry.isOpen());

    Draughtsman driver;
    driver.rectangle({1, 1}, {4, 4});
    driver.key('R');
    driver.clickPlace({5, 5});
    driver.context().selection.clear();
    driver.keys("3");
    driver.key('A', {Modifiers::kControl});
    CHECK(driver.context().selection.empty());
    driver.key(key::kBackspace);
    CHECK(driver.document().shapes.size() == 1);
    driver.keys("2");
    driver.key(key::kTab);
    driver.keys("1");
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(boundsOf(*driver.document().shapes[1]).size() == Vec2{2, 1});
}

TEST_CASE("Rename on the canvas: a name that is refused stays in the field with the focus, and the reason once") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    NamedThing gone{.kind = NamedThing::Kind::Region, .marker = 7}; // a region that does not exist
    driver.context().naming.openOnCanvas(gone, driver.pixel({5, 5}), driver.context().document);
    driver.frames(4);
    driver.type("bay");
    driver.key(key::kEnter);
    driver.frames(4);
    REQUIRE(driver.has("naming/name"));
    CHECK(driver.has("naming/fault"));
    CHECK(driver.context().naming.text == "bay");
    CHECK(driver.context().naming.fault == "region marker not found");
    CHECK_FALSE(driver.has("canvas/note")); // no second message
    driver.type("s");                       // the field has the focus
    driver.frames(2);
    CHECK_FALSE(driver.has("naming/fault"));
    driver.key(key::kEscape);
    driver.frames(2);
    CHECK_FALSE(driver.has("naming/name"));
    CHECK(driver.document().shapes.size() == 1);
}

TEST_CASE("Import: white shapes on others are proposed as holes, and can be merged instead") {
    const TemporaryFolder place;
    std::ofstream(place.path / "part.svg") << R"(<svg viewBox="0 0 100 60"><rect width="100" height="60" fill="#888"/>
<circle cx="30" cy="30" r="10" fill="#fff"/><circle cx="70" cy="30" r="10" fill="red"/></svg>)";
    Draughtsman driver;
    driver.context().actions.run("file.import", driver.context());
    driver.settle();
    driver.chooseFile("import", place.path / "part.svg");
    driver.settle();
    REQUIRE(driver.has("dialog/importoptions/white"));
    CHECK(driver.document().shapes.size() == 2); // the plate and one hole
    driver.click("dialog/importoptions/white");
    driver.settle();
    CHECK(driver.document().shapes.size() == 1);
    driver.click("dialog/importoptions/white");
    driver.settle();
    driver.click("dialog/importoptions/ok");
    driver.settle();
    CHECK(driver.document().shapes.size() == 2);
}

} // namespace forefront::test
