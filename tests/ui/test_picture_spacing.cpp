#include "core/drawing/document/equality.hpp"
#include "core/files/png/png.hpp"
#include "tests/support/png_sample.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

/// Writes a picture of 4 x 2 pixels that is black on the left and white on the right.
std::filesystem::path writeHalves(const std::filesystem::path &file) {
    std::ofstream(file, std::ios::binary) << testing::greyPng(4, 2, {0, 0, 255, 255, 0, 0, 255, 255});
    return file;
}

void chooseSpacing(Draughtsman &driver, const std::filesystem::path &file) {
    driver.context().actions.run("file.importSpacing", driver.context());
    driver.frames(5);
    driver.click("dialog/importspacing/name");
    driver.key('A', {Modifiers::kControl});
    driver.type(file.string());
    driver.click("dialog/importspacing/ok");
    driver.settle();
}

Box2 backgroundBox(Draughtsman &driver) {
    Box2 box;
    for (const Vec2 node : driver.document().spacing.background->nodes) {
        box.add(node);
    }
    return box;
}

double spacingAt(Draughtsman &driver, Vec2 place) {
    REQUIRE(driver.context().preview->spacing != nullptr);
    return driver.context().preview->spacing->at(place);
}

} // namespace

TEST_CASE("Picture as spacing: two sizes, around the drawing, one undo step") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 5});
    const Document before = driver.document();
    chooseSpacing(driver, writeHalves(place.path / "sizes.png"));
    REQUIRE(driver.has("dialog/picturespacing/ok"));
    driver.fill("dialog/picturespacing/black", "0.1+0.15");
    driver.fill("dialog/picturespacing/white", "0.5");
    CHECK(sameContent(driver.document(), before));
    driver.click("dialog/picturespacing/ok");
    driver.settle();
    CHECK_FALSE(driver.context().dialogs.any());
    CHECK(driver.undoLabel() == "Import spacing");
    CHECK(backgroundBox(driver) == Box2{{1, 1}, {9, 5}});
    CHECK(spacingAt(driver, {2, 3}) == doctest::Approx(0.25));
    CHECK(spacingAt(driver, {8, 3}) == doctest::Approx(0.5));
    CHECK(spacingAt(driver, {5, 3}) == doctest::Approx(0.375));
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(sameContent(driver.document(), before));
}

TEST_CASE("Picture as spacing: it takes the place of the size, and leaves sources and limits") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 5});
    Document next = driver.document();
    next.spacing.size = 0.1;
    next.spacing.sources.push_back({.a = {3, 3}, .size = 0.05, .growth = 0.3});
    next.spacing.minimum = 0.02;
    driver.context().document.apply(next, "Spacing");
    chooseSpacing(driver, writeHalves(place.path / "sizes.png"));
    driver.fill("dialog/picturespacing/black", "0.25");
    driver.fill("dialog/picturespacing/white", "0.5");
    driver.click("dialog/picturespacing/ok");
    driver.settle();
    CHECK_FALSE(driver.document().spacing.size);
    CHECK(driver.document().spacing.minimum == 0.02);
    CHECK(driver.document().spacing.sources == next.spacing.sources);
    CHECK(spacingAt(driver, {3, 3}) == doctest::Approx(0.05));
    CHECK(spacingAt(driver, {8, 3}) == doctest::Approx(0.5));
}

TEST_CASE("Picture as spacing: Enter accepts a number in its field, and imports elsewhere") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 5});
    chooseSpacing(driver, writeHalves(place.path / "sizes.png"));
    driver.fill("dialog/picturespacing/black", "0.25");
    driver.fill("dialog/picturespacing/white", "0.5");
    REQUIRE(driver.has("dialog/picturespacing/ok"));
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.context().dialogs.any());
    CHECK(spacingAt(driver, {8, 3}) == doctest::Approx(0.5));
}

TEST_CASE("Picture as spacing: a text that is no number is refused at its field, and nothing is imported") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 5});
    const Document before = driver.document();
    chooseSpacing(driver, writeHalves(place.path / "sizes.png"));
    REQUIRE(driver.has("dialog/picturespacing/ok"));
    driver.click("dialog/picturespacing/black");
    driver.key('A', {Modifiers::kControl});
    driver.type("abc");
    driver.click("dialog/picturespacing/ok");
    driver.settle();
    CHECK(driver.has("dialog/picturespacing/black/fault"));
    CHECK(driver.has("dialog/picturespacing/ok"));
    CHECK(sameContent(driver.document(), before));
}

TEST_CASE("Picture as spacing: a size of 0 is reported beside its field, and the old one stays") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 5});
    chooseSpacing(driver, writeHalves(place.path / "sizes.png"));
    driver.fill("dialog/picturespacing/black", "0.25");
    driver.fill("dialog/picturespacing/black", "0");
    CHECK(driver.has("dialog/picturespacing/black/fault"));
    driver.fill("dialog/picturespacing/width", "-3");
    CHECK(driver.has("dialog/picturespacing/width/fault"));
    driver.click("dialog/picturespacing/ok"); // not while a field shows what was refused
    driver.settle();
    REQUIRE(driver.context().dialogs.any());
    driver.click("dialog/picturespacing/width");
    driver.key(key::kEscape); // brings the old number back, and does not close the dialog
    REQUIRE(driver.context().dialogs.any());
    driver.click("dialog/picturespacing/ok");
    driver.settle();
    CHECK(spacingAt(driver, {2, 3}) == doctest::Approx(0.25));
    CHECK(backgroundBox(driver) == Box2{{1, 1}, {9, 5}});
}

TEST_CASE("Picture as spacing: it lies where the background picture does, or where it is put") {
    const TemporaryFolder place;
    Draughtsman driver;
    const std::filesystem::path file = writeHalves(place.path / "sizes.png");
    driver.rectangle({1, 1}, {9, 5});
    Document next = driver.document();
    next.picture = BackgroundPicture{.file = file.string(), .corner = {0, 0}, .size = {12, 6}};
    driver.context().document.apply(next, "Add background picture");
    driver.settle();
    chooseSpacing(driver, file);
    driver.click("dialog/picturespacing/ok");
    driver.settle();
    CHECK(backgroundBox(driver) == Box2{{0, 0}, {12, 6}});

    chooseSpacing(driver, writeHalves(place.path / "other.png"));
    driver.click("dialog/picturespacing/ok");
    driver.settle();
    CHECK(backgroundBox(driver) == Box2{{1, 1}, {9, 5}});

    chooseSpacing(driver, place.path / "other.png");
    driver.click("dialog/picturespacing/background");
    driver.fill("dialog/picturespacing/corner/x", "-1, 2");
    driver.fill("dialog/picturespacing/width", "6");
    driver.click("dialog/picturespacing/ok");
    driver.settle();
    CHECK(backgroundBox(driver) == Box2{{-1, 2}, {5, 5}});
}

TEST_CASE("Picture as spacing: a damaged file is reported in the file dialog; Cancel changes nothing") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 5});
    const Document before = driver.document();
    const std::string good = testing::greyPng(4, 2, {0, 0, 255, 255, 0, 0, 255, 255});
    std::ofstream(place.path / "cut.png", std::ios::binary) << good.substr(0, 70);
    chooseSpacing(driver, place.path / "cut.png");
    CHECK(driver.has("dialog/importspacing/ok"));
    CHECK(driver.logHas("bad-picture"));
    driver.context().dialogs.closeAll();
    driver.settle();

    chooseSpacing(driver, writeHalves(place.path / "sizes.png"));
    driver.click("dialog/picturespacing/cancel");
    driver.settle();
    CHECK_FALSE(driver.context().dialogs.any());
    CHECK(sameContent(driver.document(), before));
}

TEST_CASE("Picture as spacing: transparent pictures are refused in the dialog") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 5});
    std::ofstream(place.path / "clear.png", std::ios::binary)
        << testing::pngFile({.columns = 2, .colour = 4, .bytes = {0, 1, 0, 1, 0}});
    chooseSpacing(driver, place.path / "clear.png");
    driver.click("dialog/picturespacing/ok");
    driver.settle();
    CHECK(driver.has("dialog/picturespacing/fault"));
}

} // namespace forefront::test
