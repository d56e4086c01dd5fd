#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

namespace forefront::test {

TEST_CASE("Tags: the field of the next shape takes a number, a name in use or a new name, and says so otherwise") {
    Draughtsman driver;
    driver.key('R');
    driver.fill("options/tag", "inlet"); // a new name: a tag of its own
    CHECK(driver.undoLabel() == "Name boundary");
    driver.dragPlaces({1, 1}, {3, 3});
    const std::int32_t inlet = driver.document().shapes[0]->tag;
    CHECK(driver.document().boundaryNames.at(inlet) == "inlet");
    driver.fill("options/tag", "9");
    driver.dragPlaces({4, 1}, {6, 3});
    CHECK(driver.document().shapes[1]->tag == 9);
    driver.fill("options/tag", " inlet ");
    driver.dragPlaces({7, 1}, {9, 3});
    CHECK(driver.document().shapes[2]->tag == inlet);
    driver.fill("options/tag", "boundary_9"); // the name of a tag without one
    driver.dragPlaces({1, 4}, {3, 6});
    CHECK(driver.document().shapes[3]->tag == 9);
    CHECK(driver.document().boundaryNames.size() == 1);
    for (const char *wrong : {"0", "-2", "1.5"}) {
        CAPTURE(wrong);
        driver.fill("options/tag", wrong);
        CHECK(driver.has("options/tag/fault"));
        CHECK(driver.context().log.entries().back().diagnostic.message.find("expected a tag") != std::string::npos);
    }
    driver.dragPlaces({4, 4}, {6, 6});
    CHECK(driver.document().shapes[4]->tag == 9);
    driver.key('L'); // constraints, too
    driver.fill("options/tag", "crack");
    driver.clickPlace({7, 5});
    driver.clickPlace({9, 6});
    driver.key(key::kEnter);
    const Shape &line = *driver.document().shapes.back();
    CHECK(driver.document().boundaryNames.at(line.tag) == "crack");
    CHECK(line.tag != inlet);
}

TEST_CASE("Tags: a hole gets a tag of its own, until the user chooses one") {
    Draughtsman driver;
    driver.key('R');
    driver.dragPlaces({0, 0}, {10, 8});
    driver.dragPlaces({1, 1}, {2, 2});
    driver.dragPlaces({4, 1}, {5, 2});
    driver.dragPlaces({11, 1}, {13, 3}); // beside the first, not in it
    driver.fill("options/tag", "7");
    driver.dragPlaces({7, 1}, {8, 2});
    const auto shapes = driver.document().shapes;
    REQUIRE(shapes.size() == 5);
    CHECK(shapes[0]->tag == 1);
    CHECK(shapes[1]->tag == 2);
    CHECK(shapes[2]->tag == 3);
    CHECK(shapes[3]->tag == 1);
    CHECK(shapes[4]->tag == 7);
    driver.fill("options/tag", " "); // nothing chosen any more
    driver.dragPlaces({7, 4}, {8, 5});
    CHECK(driver.document().shapes[5]->tag == 8);
    driver.fill("options/tag", "1"); // the number that the empty field shows
    driver.dragPlaces({4, 4}, {5, 5});
    CHECK(driver.document().shapes[6]->tag == 1);
    driver.key('L');
    driver.clickPlace({0.5, 6});
    driver.clickPlace({3, 7});
    driver.key(key::kEnter);
    CHECK(driver.document().shapes[7]->tag == 9); // not that of the first hole
}

} // namespace forefront::test
