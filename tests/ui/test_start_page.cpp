#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/ui/driver.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/platform/assets.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

namespace forefront::test {

namespace {

EditorSetup withStartPage(const std::filesystem::path &settings = {}) {
    EditorSetup setup;
    setup.settingsFolder = settings;
    setup.sample = false;
    setup.startPage = true;
    return setup;
}

} // namespace

TEST_CASE("Start page: it is shown without a file, is not modal, and goes with the first shape") {
    Driver driver(withStartPage());
    REQUIRE(driver.has("start"));
    for (const char *name : {"start/new", "start/open", "start/trace", "start/import"}) {
        CHECK(driver.has(name));
    }
    CHECK(driver.context().dialogs.top() == nullptr);
    driver.key('R');
    driver.settle();
    CHECK_FALSE(driver.has("start")); // the canvas is free for drawing
    driver.key('V');
    driver.settle();
    CHECK(driver.has("start"));
    driver.key('R');
    driver.drag(driver.canvas().centre(), driver.canvas().centre() + Pixel(150, 150));
    driver.key('V');
    driver.settle();
    REQUIRE(driver.context().document.current()->shapes.size() == 1);
    CHECK_FALSE(driver.has("start"));
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.context().document.current()->shapes.empty());
    CHECK_FALSE(driver.has("start"));
}

TEST_CASE("Start page: New leaves an empty canvas with a tool to draw") {
    Driver driver(withStartPage());
    driver.click("start/new");
    driver.settle();
    CHECK_FALSE(driver.has("start"));
    CHECK(std::string_view(driver.context().tools.current().id()) == "rectangle");
}

TEST_CASE("Start page: it opens samples, recent drawings and lessons") {
    const testing::TemporaryFolder place;
    const std::filesystem::path file = place.path / "bracket.forefront";
    {
        Driver driver(withStartPage(place.path));
        const Sample sample = sampleDrawings().front();
        driver.click("start/sample/" + sample.path.stem().string());
        driver.until([&] { return driver.context().document.title() == sample.title; });
        driver.settle();
        CHECK_FALSE(driver.has("start"));
        REQUIRE(writeProject(file, *driver.context().document.current()).empty());
        rememberFile(driver.context(), file);
    }
    {
        Driver driver(withStartPage(place.path));
        driver.click("start/recent/bracket");
        driver.until([&] { return driver.context().document.path() == file; });
        CHECK_FALSE(driver.has("start"));
    }
    Driver driver(withStartPage(place.path));
    REQUIRE(driver.has("start/lesson/1-front"));
    driver.scroll(driver.context().widgets.find("start")->rect.centre(), -20.0);
    driver.settle();
    driver.click("start/lesson/1-front");
    driver.settle();
    CHECK(driver.context().lessons.open.has_value());
    CHECK_FALSE(driver.has("start"));
}

TEST_CASE("Start page: it fits into windows of any size and scale") {
    const std::pair<PixelSize, double> sizes[] = {
        {{1280, 800}, 1.0}, {{1440, 900}, 1.5}, {{2560, 1600}, 2.0}, {{1280, 800}, 2.0}};
    Driver driver(withStartPage());
    for (const auto &each : sizes) {
        driver.platform().resize(each.first, each.second);
        driver.settle();
        CAPTURE(each.first.width);
        CAPTURE(each.second);
        const PixelRect page = driver.context().widgets.find("start")->rect, canvas = driver.canvas();
        CHECK(page.x >= canvas.x);
        CHECK(page.x + page.width <= canvas.x + canvas.width);
        CHECK(page.y + page.height <= canvas.y + canvas.height);
        CHECK(driver.context().widgets.find("start/new")->visible);
    }
}

TEST_CASE(
    "Last project: its absolute path is kept, other drawings leave it, and it is not kept while it is being opened") {
    const testing::TemporaryFolder place;
    const std::filesystem::path file = place / "plate.forefront", other = place / "plate.poly";
    Shape shape;
    shape.nodes = {{0, 0}, {3, 0}, {3, 2}};
    REQUIRE(writeProject(file, *addShape({}, shape)).empty());
    std::ofstream(other) << "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";
    EditorSetup setup = withStartPage(place.path);
    setup.reopens = true;
    const auto kept = [&] { return loadSettings(setup.settingsFolder / "settings.json").lastFile; };
    {
        Driver driver(setup);
        REQUIRE(driver.editor().open(std::filesystem::relative(file)));
        driver.settle();
        CHECK(kept() == file.string());
        driver.editor().open(other);
        driver.settle();
        CHECK(kept() == file.string());
    }
    std::string fault;
    const auto platform = EglPlatform::create({640, 480}, 1.0, fault);
    REQUIRE(platform);
    {
        Editor editor(*platform, setup);
        CHECK(kept().empty()); // a project that ends the program here is not opened at the next start
        CHECK(editor.context().document.path() == file);
    }
    CHECK(kept() == file.string());
}

TEST_CASE("Last drawing: it comes back at the next start without a file, unless that is turned off or it is gone") {
    const testing::TemporaryFolder place;
    const std::filesystem::path file = place / "plate.forefront";
    Shape shape;
    shape.nodes = {{0, 0}, {3, 0}, {3, 2}};
    const Document drawing = *addShape({}, shape);
    REQUIRE(writeProject(file, drawing).empty());
    EditorSetup setup = withStartPage(place.path);
    setup.reopens = true;
    {
        Driver driver(setup);
        CHECK(driver.has("start"));
        REQUIRE(driver.editor().open(file));
        driver.settle();
    }
    {
        Driver driver(setup);
        driver.settle();
        CHECK_FALSE(driver.has("start"));
        CHECK(driver.context().document.path() == file);
        CHECK(driver.context().document.current()->shapes.size() == 1);
        CHECK_FALSE(driver.context().document.dirty());
        driver.context().settings.reopens = false;
        driver.settle();
    }
    {
        Driver driver(setup);
        CHECK(driver.has("start"));
        CHECK(driver.context().document.path().empty());
        driver.context().settings.reopens = true;
        REQUIRE(driver.editor().open(file));
        driver.settle();
    }
    std::filesystem::remove(file);
    Driver driver(setup);
    CHECK(driver.has("start"));
}

} // namespace forefront::test
