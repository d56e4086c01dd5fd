#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <numbers>
#include <stb_image_write.h>
#include <vector>

namespace forefront::test {

namespace {

constexpr Vec2 kLake{200.0, 150.0}, kIsle{240.0, 150.0};
constexpr double kLakeRadius = 100.0, kIsleRadius = 25.0;

/// Adds a picture of a round lake with a round island, 400 x 300 pixels, of which each is a unit.
class LakeDraughtsman : public Draughtsman {
  public:
    LakeDraughtsman() {
        std::vector<std::uint8_t> rgb;
        for (int row = 0; row < 300; ++row) {
            for (int column = 0; column < 400; ++column) {
                const Vec2 at{column + 0.5, 299.5 - row};
                const bool wet = distance(at, kLake) < kLakeRadius && distance(at, kIsle) > kIsleRadius;
                for (const int channel : wet ? std::vector<int>{70, 110, 190} : std::vector<int>{120, 150, 70}) {
                    rgb.push_back(static_cast<std::uint8_t>(channel));
                }
            }
        }
        const std::filesystem::path file = place_.path / "lake.png";
        REQUIRE(stbi_write_png(file.c_str(), 400, 300, 3, rgb.data(), 3 * 400) != 0);
        editor().input().push({.kind = InputKind::Drop, .paths = {file.string()}});
        frames(2);
        settle();
        key('Y');
    }

    double areaOfShape(std::size_t k) { return areaOf(*document().shapes.at(k)); }

  private:
    TemporaryFolder place_;
};

} // namespace

TEST_CASE("Trace by colour: a click and Enter make a lake with its island, in one step that is undone") {
    LakeDraughtsman driver;
    driver.clickPlace({130.0, 150.0});
    driver.settle();
    CHECK(driver.document().shapes.empty()); // a preview
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 2);
    constexpr double kPi = std::numbers::pi;
    CHECK(driver.areaOfShape(0) == doctest::Approx(kPi * kLakeRadius * kLakeRadius).epsilon(0.005));
    CHECK(driver.areaOfShape(1) == doctest::Approx(kPi * kIsleRadius * kIsleRadius).epsilon(0.015));
    CHECK(driver.document().shapes[0]->nodes.size() <= 8);
    CHECK(driver.document().shapes[0]->use == ShapeUse::Boundary);
    CHECK(driver.document().shapes[0]->tag == 1);
    CHECK(driver.document().shapes[1]->tag == 2); // holes apart, as the bar says
    CHECK(driver.context().selection.shapes.size() == 2);
    CHECK(driver.undoLabel() == "Trace by colour");
    driver.key('2');
    driver.settle();
    CHECK(driver.run().mesh != nullptr);
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().shapes.empty());
    CHECK(driver.document().picture.has_value());
}

TEST_CASE("Trace by colour: sliders change the preview; Esc and undo drop it") {
    LakeDraughtsman driver;
    driver.clickPlace({130.0, 150.0});
    driver.settle();
    CHECK(driver.click("options/outline/take"));
    driver.settle();
    const double lake = driver.areaOfShape(0);
    const std::size_t nodes = driver.document().shapes[0]->nodes.size();
    driver.key('Z', {Modifiers::kControl});
    driver.clickPlace({130.0, 150.0});
    driver.settle();
    const WidgetRegistry::Widget *const slider = driver.context().widgets.find("options/outline/smoothness");
    REQUIRE(slider != nullptr);
    const Pixel middle = slider->rect.centre();
    driver.drag(middle, middle + Pixel(600.0, 0.0)); // to the end: 20 pixels
    driver.settle();
    CHECK(driver.click("options/outline/take"));
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1); // the island is smaller than that
    CHECK(driver.areaOfShape(0) == doctest::Approx(lake).epsilon(0.1));
    CHECK(driver.document().shapes[0]->nodes.size() < nodes);
    driver.key('Z', {Modifiers::kControl});

    driver.clickPlace({130.0, 150.0});
    driver.settle();
    driver.key(key::kEscape);
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.document().shapes.empty());
    driver.clickPlace({130.0, 150.0});
    driver.settle();
    driver.key('Z', {Modifiers::kControl}); // the preview, not the picture
    CHECK(driver.document().picture.has_value());
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.document().shapes.empty());
}

TEST_CASE("Trace by colour: Enter before the outline is found takes it then") {
    LakeDraughtsman driver;
    driver.clickAt(driver.pixel({130.0, 150.0}));
    driver.key(key::kEnter);
    driver.settle();
    driver.frames(2);
    CHECK(driver.document().shapes.size() == 2);
}

TEST_CASE("Trace by colour: without a picture, or beside it, a click says what to do") {
    Draughtsman bare;
    bare.key('Y');
    CHECK(bare.has("options/outline/add"));
    bare.clickPlace({5.0, 5.0});
    CHECK(bare.context().log.entries().back().diagnostic.message.find("File > Add background picture") !=
          std::string::npos);
    LakeDraughtsman driver;
    driver.clickPlace({-30.0, 150.0});
    CHECK(driver.context().log.entries().back().diagnostic.message.find("inside the background picture") !=
          std::string::npos);
}

} // namespace forefront::test
