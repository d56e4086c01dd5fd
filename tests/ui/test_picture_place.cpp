#include "core/drawing_files/project/project.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stb_image_write.h>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

/// Writes a green picture of 400 x 200 pixels, with a red square in its lower left corner.
std::filesystem::path drawMap(const std::filesystem::path &file) {
    std::vector<std::uint8_t> rgb;
    for (int row = 0; row < 200; ++row) {
        for (int column = 0; column < 400; ++column) {
            const bool square = column < 100 && row >= 100;
            for (const int channel : square ? std::vector<int>{250, 20, 20} : std::vector<int>{20, 200, 40}) {
                rgb.push_back(static_cast<std::uint8_t>(channel));
            }
        }
    }
    REQUIRE(stbi_write_png(file.c_str(), 400, 200, 3, rgb.data(), 3 * 400) != 0);
    return file;
}

void dropMap(Draughtsman &driver, const std::filesystem::path &file) {
    driver.editor().input().push({.kind = InputKind::Drop, .paths = {file.string()}});
    driver.frames(2);
    driver.settle();
}

bool isRedAt(Draughtsman &driver, Vec2 place) {
    const Pixel pixel = driver.pixel(place);
    const Driver::Picture shot = driver.picture();
    const auto at = 4 * (static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(shot.size.width) +
                         static_cast<std::size_t>(pixel.x));
    return shot.rgba[at] > shot.rgba[at + 1] + 30;
}

} // namespace

TEST_CASE("Picture: two points with coordinates turn and scale it; kept in projects, undone in steps") {
    const TemporaryFolder place;
    Draughtsman driver;
    dropMap(driver, drawMap(place.path / "map.png"));
    driver.click("options/picture/mode/Calibrate");
    driver.clickPlace({100.0, 50.0});
    driver.clickPlace({300.0, 50.0});
    driver.settle();
    driver.key(key::kEscape); // the field of the distance has the focus
    driver.fill("options/picture/x1", "1000");
    driver.fill("options/picture/y1", "2000");
    driver.fill("options/picture/y2", "2400");
    driver.fill("options/picture/x2", "1000");
    const BackgroundPicture placed = *driver.document().picture;
    CHECK(placed.angle == doctest::Approx(90.0).epsilon(0.01));
    CHECK(placed.size.x == doctest::Approx(800.0).epsilon(0.02));
    CHECK(placed.size.x / placed.size.y == doctest::Approx(2.0));
    CHECK(driver.undoLabel() == "Place background picture");
    const Box2 visible = driver.context().view.camera.visible(), box = boundsOf(placed);
    CHECK(visible.contains(box.min)); // the view follows it
    CHECK(visible.contains(box.max));
    CHECK(isRedAt(driver, placeIn(placed, {0.1, 0.2})));
    CHECK_FALSE(isRedAt(driver, placeIn(placed, {0.4, 0.2})));
    CHECK_FALSE(isRedAt(driver, placeIn(placed, {0.1, 0.8})));
    const Result<Document> back = parseProject(projectText(driver.document()), "map.json");
    REQUIRE(back.ok());
    CHECK(back->picture == driver.document().picture);

    driver.fill("options/picture/y2", "2000"); // the first point
    CHECK(*driver.document().picture == placed);
    driver.key(key::kEscape);
    driver.key('V');
    driver.key('Z');
    driver.fill("options/picture/angle", "0");
    CHECK(driver.document().picture->angle == 0.0);
    CHECK(driver.undoLabel() == "Rotate background picture");
}

TEST_CASE("Picture: a world file beside it places it; a bad one is reported, and the picture is added as usual") {
    const TemporaryFolder place;
    const std::filesystem::path file = drawMap(place.path / "map.png");
    std::ofstream(place.path / "map.pgw") << "0.5\n0\n0\n-0.5\n1000.25\n2099.75\n";
    {
        Draughtsman driver;
        dropMap(driver, file);
        REQUIRE(driver.document().picture.has_value());
        CHECK(driver.document().picture->corner == Vec2{1000.0, 2000.0});
        CHECK(driver.document().picture->size == Vec2{200.0, 100.0});
        CHECK(driver.context().log.entries().back().diagnostic.message.find("world file") != std::string::npos);
        CHECK(driver.context().view.camera.visible().contains({1100.0, 2050.0}));
    }
    std::ofstream(place.path / "map.pgw") << "0.5\n0\n0.3\n-0.5\n1000.25\n2099.75\n";
    Draughtsman driver;
    dropMap(driver, file);
    CHECK(driver.document().picture->size == Vec2{400.0, 200.0});
    CHECK(driver.logHas("bad-world-file"));
}

} // namespace forefront::test
