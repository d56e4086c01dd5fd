#include "core/drawing/document/document.hpp"
#include "tests/ui/meshed_square.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace forefront::test {

namespace {

std::string textOf(const std::filesystem::path &file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Exports films of a meshed square through the dialog.
class Filmmaker : public MeshedSquare {
  public:
    void openDialog() {
        script("click menu/File\nclick menu/file.exportFilm\nsettle");
        REQUIRE(has("dialog/film/name"));
    }
    /// Opens the dialog for the run up to an advance.
    void openDialog(const std::string &to, const std::string &frames) {
        openDialog();
        enter("to", to);
        enter("frames", frames);
    }
    void enter(const std::string &field, const std::string &value) {
        click("dialog/film/" + field);
        key('A', {Modifiers::kControl});
        type(value);
        key(key::kTab);
        settle();
    }
    void choose(const std::filesystem::path &file) {
        click("dialog/film/name");
        key('A', {Modifiers::kControl});
        type(file.string());
        click("dialog/film/ok");
        settle();
    }
    void confirm(const std::filesystem::path &file) {
        choose(file);
        until([this] { return !context().dialogs.any(); });
        settle();
    }
};

} // namespace

TEST_CASE("Film: numbers out of range are refused at their fields, and the old ones kept") {
    Filmmaker driver;
    driver.openDialog();
    for (const char *field : {"from", "to", "frames", "width", "speed"}) {
        CAPTURE(field);
        driver.enter(field, "-1");
        CHECK(driver.has(std::string("dialog/film/") + field + "/fault"));
    }
    driver.enter("frames", "2.5");
    CHECK(driver.has("dialog/film/frames/fault"));
    driver.enter("frames", "5");
    CHECK_FALSE(driver.has("dialog/film/frames/fault"));
}

TEST_CASE("Film: nothing is exported while a number is refused") {
    const TemporaryFolder place;
    Filmmaker driver;
    driver.openDialog();
    driver.click("dialog/film/name");
    driver.key('A', {Modifiers::kControl});
    driver.type((place.path / "run.gif").string());
    driver.click("dialog/film/width");
    driver.key('A', {Modifiers::kControl});
    driver.type("abc");
    driver.click("dialog/film/ok");
    driver.settle();
    CHECK(driver.has("dialog/film/width/fault"));
    CHECK(driver.has("dialog/film/ok"));
    CHECK_FALSE(std::filesystem::exists(place.path / "run.gif"));
}

TEST_CASE("Film: the dialog writes an animation, numbered pictures and a drawing of one moment") {
    Filmmaker driver;
    const TemporaryFolder folder;
    driver.openDialog("20", "5");
    driver.enter("width", "200");
    driver.confirm(folder / "run.gif");
    const std::string gif = textOf(folder / "run.gif");
    CHECK(gif.starts_with("GIF89a"));
    CHECK(gif.back() == ';');
    CHECK(static_cast<unsigned char>(gif[6]) == 200);

    driver.openDialog();
    driver.enter("frames", "3");
    driver.enter("width", "200");
    driver.confirm(folder / "frame.png");
    CHECK(folder.fileCount() == 4);
    for (const char *name : {"frame-1.png", "frame-2.png", "frame-3.png"}) {
        CHECK(textOf(folder / name).starts_with("\x89PNG"));
    }

    driver.openDialog(); // frames of an earlier film are not overwritten
    driver.enter("frames", "2");
    driver.choose(folder / "frame.png");
    CHECK(driver.has("dialog/film/name"));
    driver.key(key::kEscape);
    driver.settle();
    CHECK_FALSE(driver.context().dialogs.any());

    driver.openDialog();
    driver.enter("from", "7");
    driver.click("dialog/film/layer/caption");
    driver.confirm(folder / "moment.svg");
    const std::string svg = textOf(folder / "moment.svg");
    CHECK(svg.starts_with("<svg"));
    CHECK(svg.find("<text") == std::string::npos);
    CHECK(svg.find('Z') != std::string::npos); // elements
    driver.openDialog();
    driver.enter("from", "7");
    driver.confirm(folder / "caption.svg");
    CHECK(textOf(folder / "caption.svg").find(">Advance 7, ") != std::string::npos);
}

TEST_CASE("Film: a name with %d writes one drawing per frame, even with the filter for one moment") {
    Filmmaker driver;
    const TemporaryFolder folder;
    driver.openDialog("20", "3");
    driver.confirm(folder / "run-%d.svg");
    CHECK(folder.fileCount() == 3);
    CHECK(textOf(folder / "run-1.svg") != textOf(folder / "run-3.svg"));
}

TEST_CASE("Film: a cancelled film leaves no file") {
    Filmmaker driver;
    const TemporaryFolder folder;
    driver.openDialog();
    driver.enter("frames", "5000");
    driver.enter("width", "3000");
    driver.click("dialog/film/name");
    driver.key('A', {Modifiers::kControl});
    driver.type((folder / "run.gif").string());
    driver.click("dialog/film/ok");
    driver.until([&] { return driver.has("dialog/writing/cancel"); });
    driver.click("dialog/writing/cancel");
    driver.until([&] { return !driver.context().dialogs.any(); });
    CHECK(driver.logHas("cancelled"));
    CHECK(folder.fileCount() == 0);
}

TEST_CASE("Moment: its picture shows the canvas with labels, and the run stays where it is") {
    const testing::TemporaryFolder folder;
    Filmmaker driver;
    showLayer(driver.context().layers, "candidates", true);
    driver.context().run.seek(10);
    driver.settle();
    REQUIRE(driver.run().advance == 10);
    const std::uint64_t run = driver.run().run, hash = driver.run().stateHash;
    for (const char *name : {"moment.svg", "moment.pdf", "moment.png"}) {
        CAPTURE(name);
        const std::filesystem::path file = folder / name;
        driver.script("click menu/File\nclick menu/file.exportMoment\nsettle");
        REQUIRE(driver.has("dialog/moment/name"));
        driver.click("dialog/moment/name");
        driver.key('A', {Modifiers::kControl});
        driver.type(file.string());
        driver.click("dialog/moment/ok");
        driver.until([&] { return !driver.context().dialogs.any(); });
        CHECK(std::filesystem::file_size(file) > 1000);
    }
    const std::string svg = textOf(folder / "moment.svg");
    for (const char *label : {">A</text>", ">B</text>", ">C</text>", ">Advance 10, "}) {
        CAPTURE(label);
        CHECK(svg.find(label) != std::string::npos);
    }
    driver.settle();
    CHECK(driver.run().run == run);
    CHECK(driver.run().advance == 10);
    CHECK(driver.run().stateHash == hash);
}

} // namespace forefront::test
