#include "core/drawing/document/equality.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stb_image_write.h>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

/// Writes a PNG or JPEG picture: blue water, with a red square in the lower left corner.
std::filesystem::path drawPicture(const std::filesystem::path &file, int width, int height) {
    std::vector<std::uint8_t> rgb;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const bool square = column < width / 4 && row >= height - height / 4;
            for (const int channel : square ? std::vector<int>{250, 20, 20} : std::vector<int>{20, 60, 250}) {
                rgb.push_back(static_cast<std::uint8_t>(channel));
            }
        }
    }
    const bool png = file.extension() == ".png";
    REQUIRE((png ? stbi_write_png(file.c_str(), width, height, 3, rgb.data(), 3 * width)
                 : stbi_write_jpg(file.c_str(), width, height, 3, rgb.data(), 95)) != 0);
    return file;
}

void drop(Draughtsman &driver, const std::filesystem::path &file) {
    driver.editor().input().push({.kind = InputKind::Drop, .paths = {file.string()}});
    driver.frames(2);
    driver.settle();
}

const BackgroundPicture &pictureOf(Draughtsman &driver) {
    REQUIRE(driver.document().picture.has_value());
    return *driver.document().picture;
}

std::pair<int, int> redAndBlue(const Driver::Picture &shot, Pixel pixel) {
    const auto at = 4 * (static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(shot.size.width) +
                         static_cast<std::size_t>(pixel.x));
    return {shot.rgba[at], shot.rgba[at + 2]};
}

bool looksRed(const Driver::Picture &shot, Pixel pixel) {
    const auto [red, blue] = redAndBlue(shot, pixel);
    return red > blue + 30;
}

bool looksBlue(const Driver::Picture &shot, Pixel pixel) {
    const auto [red, blue] = redAndBlue(shot, pixel);
    return blue > red + 60;
}

const Vec2 kFirst{100.0, 50.0}, kSecond{300.0, 50.0}; ///< calibration points

/// Drops a picture of 400 x 200 pixels onto an empty drawing and clicks the first calibration point.
void beginCalibration(Draughtsman &driver, const TemporaryFolder &place) {
    drop(driver, drawPicture(place.path / "lake.png", 400, 200));
    driver.click("options/picture/mode/Calibrate");
    driver.clickPlace(kFirst);
}

std::string lastMessage(Draughtsman &driver) {
    return driver.context().log.entries().back().diagnostic.message;
}

} // namespace

TEST_CASE("Picture: added by the menu, drawn below the drawing, hidden as a layer, undone") {
    const TemporaryFolder place;
    for (const char *name : {"lake.png", "lake.jpg"}) {
        Draughtsman driver;
        const std::filesystem::path file = drawPicture(place.path / name, 200, 100);
        driver.context().actions.run("file.addPicture", driver.context());
        driver.settle();
        driver.click("dialog/picture/name");
        driver.type(file.string());
        driver.click("dialog/picture/ok");
        driver.settle();
        CHECK_FALSE(driver.has("dialog/picture/ok"));
        CHECK(pictureOf(driver).file == file.string());
        CHECK(pictureOf(driver).size == Vec2{200.0, 100.0}); // an empty drawing: one unit is a pixel
        CHECK(driver.undoLabel() == "Add background picture");
        const Pixel corner = driver.pixel({20.0, 10.0}), middle = driver.pixel({120.0, 30.0});
        CHECK(looksRed(driver.picture(), corner));
        CHECK(looksBlue(driver.picture(), middle));

        driver.click("options/picture/show");
        CHECK_FALSE(looksRed(driver.picture(), corner));
        driver.unfoldLayers();
        driver.click("layer/picture");
        CHECK(looksRed(driver.picture(), corner));

        driver.rectangle({5.0, 5.0}, {195.0, 95.0}); // the domain lets the picture show through
        driver.key('V');
        driver.key('2');
        driver.settle();
        const Driver::Picture meshed = driver.picture();
        bool red = false; // beside the edges of the mesh
        for (double step = 1.0; step < 10.0; step += 1.0) {
            red = red || looksRed(meshed, corner + Pixel(step, 0.6 * step));
        }
        CHECK(red);
        driver.key('Z', {Modifiers::kControl});
        driver.key('Z', {Modifiers::kControl});
        driver.settle();
        CHECK_FALSE(driver.document().picture.has_value());
        CHECK_FALSE(looksRed(driver.picture(), corner));
        driver.key('Z', {Modifiers::kControl | Modifiers::kShift});
        driver.settle();
        CHECK(looksRed(driver.picture(), corner));
    }
}

TEST_CASE(
    "Picture: two clicks and a distance set its scale; its corner stays, or the first point once that is placed") {
    const TemporaryFolder place;
    Draughtsman driver;
    beginCalibration(driver, place);
    CHECK_FALSE(driver.has("options/picture/distance"));
    const Pixel onScreen = driver.pixel(kSecond);
    driver.clickPlace(kSecond);
    driver.settle();
    REQUIRE(driver.has("options/picture/distance"));
    driver.key('A', {Modifiers::kControl}); // the field has the focus
    driver.type("5*10");
    driver.key(key::kEnter);
    driver.settle();
    const double pixel = driver.context().view.camera.length(1.0);
    CHECK(pictureOf(driver).size.x == doctest::Approx(100.0).epsilon(0.01));
    CHECK(pictureOf(driver).size.y == doctest::Approx(50.0).epsilon(0.01));
    CHECK(pictureOf(driver).corner == Vec2{}); // not 75 units away from where it was put
    // Nothing else is drawn, so the picture stays where it is on the screen.
    CHECK(glm::distance(driver.pixel({75.0, 12.5}), onScreen) < 4.0);
    CHECK(driver.undoLabel() == "Calibrate background picture");

    driver.fill("options/picture/x1", "0");
    driver.fill("options/picture/y1", "0");
    CHECK(distance(pictureOf(driver).corner, {-25.0, -12.5}) < 4.0 * pixel);
    driver.fill("options/picture/distance", "100"); // the first point is at 0, 0 and stays there
    CHECK(distance(pictureOf(driver).corner, {-50.0, -25.0}) < 8.0 * pixel);
    for (int k = 0; k < 4; ++k) {
        driver.key('Z', {Modifiers::kControl});
    }
    CHECK(pictureOf(driver).size == Vec2{400.0, 200.0});
    CHECK(pictureOf(driver).corner == Vec2{});

    driver.key('F');
    driver.clickPlace({20.0, 20.0});
    driver.key('Z', {Modifiers::kControl}); // takes back the point, not the picture
    CHECK(driver.document().picture.has_value());
}

TEST_CASE("Picture: a calibration scales what was traced, too, in one step, unless it is switched off") {
    const TemporaryFolder place;
    Draughtsman driver;
    beginCalibration(driver, place);
    driver.key('R');
    driver.dragPlaces({150.0, 60.0}, {250.0, 120.0});
    const Box2 drawn = boundsOf(*driver.document().shapes[0]);
    driver.key('Z');
    const auto clickPoints = [&](Vec2 first, Vec2 second) {
        driver.click("options/picture/mode/Calibrate");
        driver.clickPlace(first);
        driver.clickPlace(second);
        driver.settle();
    };
    clickPoints(kFirst, kSecond);
    const Pixel onScreen = driver.pixel(drawn.max);
    driver.fill("options/picture/distance", "50");
    const Box2 scaled = boundsOf(*driver.document().shapes[0]);
    const double factor = pictureOf(driver).size.x / 400.0;
    CHECK(factor == doctest::Approx(0.25).epsilon(0.01));
    CHECK(scaled.size().x == doctest::Approx(factor * drawn.size().x));
    const Vec2 corner = pictureOf(driver).corner;
    CHECK(distance(scaled.min, corner + factor * drawn.min) < 1e-9 * drawn.size().x); // on the same pixels of it
    CHECK(glm::distance(driver.pixel(scaled.max), onScreen) < 1.0);
    driver.key('Z', {Modifiers::kControl});
    CHECK(boundsOf(*driver.document().shapes[0]) == drawn);
    CHECK(pictureOf(driver).size.x == 400.0);
    CHECK(glm::distance(driver.pixel(drawn.max), onScreen) < 1.0);

    driver.click("options/picture/scaledrawing");
    driver.fill("options/picture/distance", "50");
    CHECK(boundsOf(*driver.document().shapes[0]) == drawn);
    CHECK(pictureOf(driver).size.x == doctest::Approx(100.0).epsilon(0.01));
    CHECK(driver.undoLabel() == "Calibrate background picture");
}

TEST_CASE("Picture: a calibration scales the expressions of lengths, and undo brings them back") {
    const TemporaryFolder place;
    Draughtsman driver;
    beginCalibration(driver, place);
    driver.key('R');
    driver.dragPlaces({150.0, 60.0}, {250.0, 120.0});
    Document document = driver.document();
    const double width = boundsOf(document).size().x;
    document.formulas["shape/1/width"_number] = "w";
    driver.context().document.apply(*setParameters(document, {{"w", std::to_string(width)}}), "Set parameters");
    REQUIRE(driver.document().formulas.size() == 1);
    driver.key('Z');
    driver.click("options/picture/mode/Calibrate");
    driver.clickPlace(kFirst);
    driver.clickPlace(kSecond);
    driver.settle();
    driver.fill("options/picture/distance", "50");
    REQUIRE(driver.document().formulas.size() == 1);
    CHECK(driver.document().formulas.at("shape/1/width"_number).ends_with("*(w)"));
    CHECK(boundsOf(driver.document()).size().x != doctest::Approx(width));
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().formulas.at("shape/1/width"_number) == "w");
}

TEST_CASE("Picture: undo and redo of a scale keep it in place on the screen") {
    const TemporaryFolder place;
    Draughtsman driver;
    beginCalibration(driver, place);
    driver.clickPlace(kSecond);
    driver.settle();
    const auto corners = [&] {
        const Box2 box = boundsOf(pictureOf(driver));
        return std::pair(driver.pixel(box.min), driver.pixel(box.max));
    };
    const auto [low, high] = corners();
    const auto stays = [&, low = low, high = high] {
        const auto now = corners();
        return glm::distance(now.first, low) < 1.0 && glm::distance(now.second, high) < 1.0;
    };
    driver.fill("options/picture/distance", "2000");
    CHECK(pictureOf(driver).size.x == doctest::Approx(4000.0).epsilon(0.01));
    CHECK(stays());
    driver.key('Z', {Modifiers::kControl});
    CHECK(pictureOf(driver).size.x == 400.0);
    CHECK(stays());
    driver.key('Y', {Modifiers::kControl});
    CHECK(stays());
    driver.showPanel("history");
    driver.settle();
    driver.click("history/1"); // the step that added it
    CHECK(pictureOf(driver).size.x == 400.0);
    CHECK(stays());
}

TEST_CASE("Picture: a calibration point cannot be dragged onto the other") {
    const TemporaryFolder place;
    Draughtsman driver;
    beginCalibration(driver, place);
    driver.clickPlace(kSecond);
    driver.settle();
    driver.dragPlaces(kSecond, kFirst);
    driver.settle();
    driver.fill("options/picture/distance", "50");
    CHECK(std::isfinite(pictureOf(driver).size.x));
    CHECK(std::isfinite(pictureOf(driver).corner.x));
    CHECK(driver.undoLabel() == "Calibrate background picture");
}

TEST_CASE("Picture: moved with the mouse in one step, unless it is locked") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    drop(driver, drawPicture(place.path / "lake.png", 200, 100));
    const Vec2 corner = pictureOf(driver).corner;
    CHECK(boundsOf(pictureOf(driver)).size().x > 5.0); // fitted to the view of the drawing
    CHECK(boundsOf(pictureOf(driver)).size().x < 20.0);
    driver.dragPlaces({5.0, 4.0}, {6.0, 5.0});
    CHECK(distance(pictureOf(driver).corner, corner + Vec2{1.0, 1.0}) < 0.05);
    CHECK(driver.document().shapes.size() == 1);
    driver.key('Z', {Modifiers::kControl});
    CHECK(pictureOf(driver).corner == corner);

    driver.fill("options/picture/width", "4");
    CHECK(pictureOf(driver).size.x == doctest::Approx(4.0));
    CHECK(pictureOf(driver).size.y == doctest::Approx(2.0));
    driver.click("options/picture/lock");
    CHECK(pictureOf(driver).locked);
    CHECK_FALSE(driver.has("options/picture/width"));
    driver.dragPlaces(corner + Vec2{0.5, 0.5}, corner + Vec2{1.5, 0.5});
    CHECK(pictureOf(driver).corner == corner);
    driver.click("options/picture/remove");
    CHECK_FALSE(driver.document().picture.has_value());
    CHECK(driver.has("options/picture/add"));
}

TEST_CASE("Picture: saved as a link, and a missing file does not refuse the drawing") {
    const TemporaryFolder place;
    const std::filesystem::path file = drawPicture(place.path / "lake.png", 200, 100);
    Draughtsman driver;
    drop(driver, file);
    driver.rectangle({20.0, 20.0}, {150.0, 80.0});
    const Document drawn = driver.document();
    REQUIRE(writeProject(place.path / "lake.forefront", drawn).empty());
    drop(driver, place.path / "lake.forefront");
    driver.click("dialog/unsaved/discard");
    driver.settle();
    CHECK(sameContent(driver.document(), drawn));
    CHECK(looksBlue(driver.picture(), driver.pixel({170.0, 50.0})));

    std::filesystem::remove(file);
    drop(driver, place.path / "lake.forefront");
    CHECK(sameContent(driver.document(), drawn)); // the link is kept
    CHECK_FALSE(looksBlue(driver.picture(), driver.pixel({170.0, 50.0})));
    CHECK(lastMessage(driver) == "cannot read picture 'lake.png': No such file or directory");
    CHECK(driver.context().log.entries().back().diagnostic.severity == Severity::Warning);
    CHECK(driver.context().log.entries().back().diagnostic.file == file.string());

    drawPicture(file, 200, 100);
    drop(driver, file); // adds it again: same place
    CHECK(sameContent(driver.document(), drawn));
    CHECK(looksBlue(driver.picture(), driver.pixel({170.0, 50.0})));
}

TEST_CASE("Picture: another file takes the place, the scale and the lock of the one before") {
    const TemporaryFolder place;
    Draughtsman driver;
    drop(driver, drawPicture(place.path / "old.png", 200, 100));
    driver.fill("options/picture/width", "50");
    driver.fill("options/picture/x", "7");
    driver.click("options/picture/lock");
    driver.rectangle({20.0, 20.0}, {40.0, 24.0});
    const BackgroundPicture old = pictureOf(driver);
    drop(driver, drawPicture(place.path / "finer.png", 400, 200));
    BackgroundPicture expected = old;
    expected.file = (place.path / "finer.png").string();
    CHECK(pictureOf(driver) == expected);
    CHECK(driver.undoLabel() == "Replace background picture");
    CHECK(lastMessage(driver) == "finer.png replaces the previous picture and keeps its scale");

    drop(driver, drawPicture(place.path / "square.png", 300, 300));
    CHECK(pictureOf(driver).size == Vec2{50.0, 50.0});
    CHECK(pictureOf(driver).corner == old.corner);
    CHECK(lastMessage(driver).ends_with("its proportions differ, so check the calibration"));

    driver.key('Z');
    driver.click("options/picture/replace");
    driver.settle();
    CHECK(driver.has("dialog/picture/ok"));
}

TEST_CASE("Picture: a file that replaces a missing one keeps its calibration") {
    const TemporaryFolder place;
    Draughtsman driver;
    drop(driver, drawPicture(place.path / "lake.png", 200, 100));
    driver.fill("options/picture/width", "50");
    const BackgroundPicture old = pictureOf(driver);
    REQUIRE(writeProject(place.path / "lake.forefront", driver.document()).empty());
    std::filesystem::rename(place.path / "lake.png", place.path / "moved.png");
    drop(driver, place.path / "lake.forefront");
    driver.click("dialog/unsaved/discard");
    driver.settle();
    drop(driver, place.path / "moved.png");
    CHECK(pictureOf(driver).corner == old.corner);
    CHECK(pictureOf(driver).size == old.size);
    CHECK(looksRed(driver.picture(), driver.pixel({5.0, 3.0})));
}

TEST_CASE("Picture: the first one turns snapping to the grid off and says so") {
    const TemporaryFolder place;
    Draughtsman driver;
    REQUIRE(driver.context().snapping.toGrid);
    drop(driver, drawPicture(place.path / "lake.png", 200, 100));
    CHECK_FALSE(driver.context().snapping.toGrid);
    CHECK(lastMessage(driver).ends_with("Snapping to the grid is off for tracing"));
    driver.context().snapping.toGrid = true;
    drop(driver, drawPicture(place.path / "other.png", 200, 100));
    CHECK(driver.context().snapping.toGrid); // the user has turned it on again
}

TEST_CASE("Picture: a distance that is not positive or has a unit is refused beside its field") {
    const TemporaryFolder place;
    Draughtsman driver;
    drop(driver, drawPicture(place.path / "lake.png", 200, 100));
    const BackgroundPicture before = pictureOf(driver);
    driver.fill("options/picture/width", "0");
    CHECK(pictureOf(driver) == before);
    CHECK(lastMessage(driver) == "expected a positive number, got 0");
    CHECK(driver.has("options/picture/width/fault"));
    driver.fill("options/picture/width", "500 m");
    CHECK(pictureOf(driver) == before);
    CHECK(lastMessage(driver) ==
          "expected a number, got '500 m': the drawing has no unit; enter 500 alone, or choose Edit > Unit");
}

TEST_CASE("Picture: damaged, huge and other files are refused with a reason") {
    const TemporaryFolder place;
    Draughtsman driver;
    const std::filesystem::path file = drawPicture(place.path / "lake.png", 300, 200);
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    drop(driver, file);
    CHECK_FALSE(driver.document().picture.has_value());
    CHECK(lastMessage(driver).starts_with("cannot decode picture 'lake.png': the file is damaged or incomplete ("));
    CHECK(driver.has("canvas/error"));

    std::ofstream(place.path / "note.png") << "no picture at all";
    drop(driver, place.path / "note.png");
    CHECK(lastMessage(driver) == "'note.png' is not a picture; expected a PNG or JPEG file");

    // Only the header, which is all that is read of it.
    std::string huge("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x4e\x20\0\0\x4e\x20\x08\x02\0\0\0\0\0\0\0", 33);
    std::ofstream(place.path / "huge.png", std::ios::binary) << huge;
    drop(driver, place.path / "huge.png");
    CHECK(lastMessage(driver) == "picture 'huge.png' has 20000 x 20000 pixels; expected at most 100 million");
    CHECK_FALSE(driver.document().picture.has_value());
}

TEST_CASE("Picture: it does not make the mesh out of date") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.key('2');
    driver.settle();
    REQUIRE(driver.run().state == RunState::Finished);
    drop(driver, drawPicture(place.path / "lake.png", 200, 100));
    CHECK_FALSE(driver.context().run.outOfDate());
    CHECK(driver.context().document.dirty());
}

TEST_CASE("Picture: a drawing that differs from the one before in its picture alone is meshed when it is opened") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    REQUIRE(writeProject(place.path / "plain.forefront", driver.document()).empty());
    drop(driver, drawPicture(place.path / "lake.png", 200, 100));
    REQUIRE(writeProject(place.path / "traced.forefront", driver.document()).empty());
    driver.context().settings.live = true;
    drop(driver, place.path / "plain.forefront");
    driver.click("dialog/unsaved/discard");
    for (const char *name : {"traced.forefront", "plain.forefront"}) {
        driver.settle();
        CHECK(driver.run().state == RunState::Finished);
        CHECK(driver.run().quality.elements > 0);
        drop(driver, place.path / name);
    }
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
}

TEST_CASE("Picture: panning and zooming redraw a large picture without reading or sending it again") {
    const TemporaryFolder place;
    Draughtsman driver;
    drop(driver, drawPicture(place.path / "map.png", 9000, 300)); // wider than the largest texture
    const std::shared_ptr<const Picture> shown = driver.context().pictures.shown();
    REQUIRE(shown);
    CHECK(shown->size == PixelSize{9000, 300});
    CHECK(shown->columns == 4500);
    CHECK(pictureOf(driver).size == Vec2{9000.0, 300.0});
    CHECK(looksBlue(driver.picture(), driver.canvas().centre()));
    driver.scroll(driver.canvas().centre(), 5.0);
    driver.settle();
    CHECK(driver.context().pictures.shown() == shown);
    CHECK(looksBlue(driver.picture(), driver.canvas().centre()));
}

} // namespace forefront::test
