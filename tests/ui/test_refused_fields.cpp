#include "core/drawing_files/project/project.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <string>

namespace forefront::test {

namespace {

/// Types a text into a field and expects it to be refused there, until the field is edited again.
void expectRefused(Draughtsman &driver, const std::string &field, const std::string &text) {
    CAPTURE(field);
    CAPTURE(text);
    const std::uint64_t revision = driver.context().document.revision();
    driver.fill(field, text);
    CHECK(driver.has(field + "/fault"));
    CHECK(driver.context().document.revision() == revision);
    driver.click(field);
    driver.key(key::kEscape);
    driver.frames(2);
    CHECK_FALSE(driver.has(field + "/fault"));
}

} // namespace

TEST_CASE("Refused fields: what a command refuses is told at the field of a panel") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    expectRefused(driver, "inspector/cornerradius", "-1");
    expectRefused(driver, "inspector/size/y", "0");
    expectRefused(driver, "inspector/partsize", "-1");
    driver.showPanel("spacing");
    expectRefused(driver, "spacing/size", "-1");
    CHECK(driver.logHas("bad-size"));
    expectRefused(driver, "spacing/maximum", "0");
    driver.showPanel("checks");
    driver.settle();
    expectRefused(driver, "checks/min-angle", "91");
    CHECK(driver.logHas("bad-limit"));
}

TEST_CASE("Refused fields: a command that fails after a field was committed is not told at the field") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.showPanel("spacing");
    driver.click("spacing/size");
    driver.type("0.5");
    driver.key('D', {Modifiers::kControl}); // commits the field, then runs
    driver.settle();
    CHECK(driver.document().spacing.size == 0.5);
    CHECK_FALSE(driver.has("spacing/size/fault"));
}

TEST_CASE("Refused fields: radii of ellipses and boundary tags") {
    Draughtsman driver;
    driver.key('K');
    driver.dragPlaces({1, 1}, {9, 8});
    driver.key('V');
    expectRefused(driver, "inspector/radii/x", "-1");
    expectRefused(driver, "inspector/radii/y", "0");
    for (const char *tag : {"0", "2.7", "2e9"}) {
        expectRefused(driver, "inspector/tag", tag);
    }
    driver.fill("inspector/tag", "3");
    CHECK(driver.document().shapes[0]->tag == 3);
}

TEST_CASE("Refused fields: the tag of the region tool") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.click("tool/region");
    driver.settle();
    expectRefused(driver, "options/region/tag", "0");
    expectRefused(driver, "options/region/tag", "2.7");
}

TEST_CASE("Refused fields: the scale of an import") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({2, 2}, {4, 4});
    REQUIRE(writeProject(place.path / "part.forefront", driver.document()).empty());
    driver.key('I', {Modifiers::kControl});
    driver.frames(5);
    driver.fill("dialog/import/name", (place.path / "part.forefront").string());
    if (driver.has("dialog/import/ok")) {
        driver.click("dialog/import/ok");
        driver.settle();
    }
    REQUIRE(driver.has("dialog/importoptions/scale"));
    for (const char *scale : {"0", "-1"}) {
        driver.click("dialog/importoptions/scale");
        driver.key('A', {Modifiers::kControl});
        driver.type(scale);
        driver.key(key::kTab);
        driver.settle();
        CHECK(driver.has("dialog/importoptions/scale/fault"));
    }
}

} // namespace forefront::test
