#include "core/drawing/recovery/journal_record.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/source/file_stamp.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stb_image_write.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace forefront::test {

namespace {

Document squareOf(double side) {
    Shape shape;
    shape.id = 1;
    shape.form = RectangleForm{};
    shape.nodes = {{0, 0}, {side, side}};
    Document document;
    document.shapes = {std::make_shared<const Shape>(shape)};
    document.nextId = 2;
    return document;
}

double sideOf(const Document &document) {
    REQUIRE(document.shapes.size() == 1);
    return document.shapes[0]->nodes[1].x;
}

/// A window with a project that it has opened and then changed: a square of side 3 in the file, of side 5 in the
/// window.
class ChangedWindow : public Draughtsman {
  public:
    explicit ChangedWindow(EditorSetup setup = {}) : Draughtsman(std::move(setup)) {
        REQUIRE(writeProject(file, squareOf(3)).empty());
        REQUIRE(editor().open(file));
        context().document.replace(squareOf(5), "Enlarge");
        settle();
    }
    /// Lets another program write to the file.
    void writeElsewhere(double side) { REQUIRE(writeProject(file, squareOf(side)).empty()); }
    double sideInFile() const {
        const Result<Document> read = readDocument(file);
        REQUIRE(read.ok());
        return sideOf(*read);
    }
    void save() {
        key('S', {Modifiers::kControl});
        settle();
    }

    const TemporaryFolder place;
    const std::filesystem::path file = place.path / "bay.forefront";
};

} // namespace

TEST_CASE("Files: saving asks before it overwrites what another program has saved, and may overwrite it") {
    ChangedWindow window;
    window.writeElsewhere(7);
    window.save();
    REQUIRE(window.has("dialog/changed/overwrite"));
    CHECK(window.sideInFile() == 7);
    window.click("dialog/changed/cancel");
    window.settle();
    CHECK(window.sideInFile() == 7);
    CHECK(window.context().document.dirty());
    window.save();
    window.click("dialog/changed/overwrite");
    window.settle();
    CHECK_FALSE(window.has("dialog/changed/overwrite"));
    CHECK(window.sideInFile() == 5);
    CHECK_FALSE(window.context().document.dirty());
    window.context().document.replace(squareOf(6), "Enlarge");
    window.save(); // nobody else has written since
    CHECK_FALSE(window.has("dialog/changed/overwrite"));
    CHECK(window.sideInFile() == 6);
}

TEST_CASE("Files: a file that another program has changed can be reloaded, and undo brings one's own work back") {
    ChangedWindow window;
    window.writeElsewhere(7);
    window.save();
    REQUIRE(window.has("dialog/changed/reload"));
    window.click("dialog/changed/reload");
    window.settle();
    CHECK(sideOf(window.document()) == 7);
    CHECK(window.sideInFile() == 7);
    CHECK_FALSE(window.context().document.dirty());
    window.key('Z', {Modifiers::kControl});
    window.settle();
    CHECK(sideOf(window.document()) == 5);
    CHECK(window.context().document.dirty());
    window.save(); // now the user knows
    CHECK_FALSE(window.has("dialog/changed/reload"));
    CHECK(window.sideInFile() == 5);
}

TEST_CASE("Files: what another program has saved can be kept by saving elsewhere") {
    ChangedWindow window;
    window.writeElsewhere(7);
    window.save();
    window.click("dialog/changed/saveAs");
    window.settle();
    window.chooseFile("save", window.place.path / "mine.forefront");
    CHECK(window.sideInFile() == 7);
    CHECK(sideOf(*readDocument(window.place.path / "mine.forefront")) == 5);
}

TEST_CASE("Files: a file that was deleted is saved again only after a question") {
    ChangedWindow window;
    std::filesystem::remove(window.file);
    window.save();
    REQUIRE(window.has("dialog/changed/overwrite"));
    CHECK_FALSE(window.has("dialog/changed/reload"));
    CHECK_FALSE(std::filesystem::exists(window.file));
    window.click("dialog/changed/overwrite");
    window.settle();
    CHECK(window.sideInFile() == 5);
}

TEST_CASE("Files: a file rewritten with the same content is not called changed") {
    ChangedWindow window;
    window.writeElsewhere(3);
    window.save();
    CHECK_FALSE(window.has("dialog/changed/overwrite"));
    CHECK(window.sideInFile() == 5);
}

TEST_CASE("Files: a change by another program is told while the file is open, and so is its deletion") {
    ChangedWindow window;
    window.writeElsewhere(7);
    window.until([&] { return window.logHas("file-changed"); });
    CHECK(sideOf(window.document()) == 5);
    window.context().actions.run("file.reload", window.context());
    window.settle();
    CHECK(sideOf(window.document()) == 7);
    std::filesystem::remove(window.file);
    window.editor().input().push({.kind = InputKind::Focus, .pressed = true}); // looks at once
    window.until([&] { return window.logHas("file-deleted"); });
}

TEST_CASE("Files: when the program ends, closing asks about a file that has changed, too") {
    ChangedWindow window;
    window.writeElsewhere(7);
    window.key('Q', {Modifiers::kControl});
    window.settle();
    window.click("dialog/unsaved/save");
    window.settle();
    REQUIRE(window.has("dialog/changed/overwrite"));
    CHECK_FALSE(window.context().quit);
    window.click("dialog/changed/overwrite");
    window.settle();
    CHECK(window.context().quit);
    CHECK(window.sideInFile() == 5);
}

TEST_CASE("Recovery: a file that was changed after a crash is not overwritten without a question") {
    const TemporaryFolder state;
    const std::filesystem::path file = state.path / "bay.forefront";
    REQUIRE(writeProject(file, squareOf(3)).empty());
    const std::uint64_t hash = stampOf(file).hash;
    {
        std::filesystem::create_directories(state.path / "recovery");
        std::ofstream(state.path / "recovery" / "1-0.journal")
            << kJournalMagic << encodeRecord(JournalRecord::Path, file.string())
            << encodeRecord(JournalRecord::SavedHash, encodeHash(hash))
            << encodeRecord(JournalRecord::FullText, projectText(squareOf(5)));
    }
    REQUIRE(writeProject(file, squareOf(7)).empty());
    EditorSetup setup;
    setup.stateFolder = state.path;
    setup.sample = false;
    Driver driver(setup);
    REQUIRE(driver.has("dialog/recovery/recover"));
    driver.click("dialog/recovery/recover");
    driver.settle();
    driver.key('S', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.has("dialog/changed/overwrite"));
    CHECK(sideOf(*readDocument(file)) == 7);
}

TEST_CASE("Picture: a background picture that another program has changed is read again") {
    const TemporaryFolder place;
    const std::filesystem::path picture = place.path / "lake.png";
    const auto paint = [&](std::uint8_t red) {
        const std::vector<std::uint8_t> rgb(3UL * 8 * 8, red);
        REQUIRE(stbi_write_png(picture.c_str(), 8, 8, 3, rgb.data(), 24) != 0);
    };
    paint(10);
    Draughtsman driver;
    driver.editor().input().push({.kind = InputKind::Drop, .paths = {picture.string()}});
    driver.frames(2);
    driver.settle();
    const auto red = [&] { return driver.context().pictures.shown() ? driver.context().pictures.shown()->rgba[0] : 0; };
    REQUIRE(red() == 10);
    paint(200);
    driver.until([&] { return red() == 200; });
    std::filesystem::remove(picture);
    driver.until([&] { return driver.logHas("picture-changed"); });
    CHECK(red() == 200); // as last read
    paint(90);
    driver.until([&] { return red() == 90; });
}

TEST_CASE("Picture: a pipe in place of a background picture neither hangs the window nor its end") {
    const TemporaryFolder place;
    const std::filesystem::path file = place.path / "bay.forefront", pipe = place.path / "lake.png";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    Document document = squareOf(3);
    document.picture = BackgroundPicture{.file = pipe.string(), .size = {4, 4}};
    REQUIRE(writeProject(file, document).empty());
    {
        Draughtsman driver;
        REQUIRE(driver.editor().open(file));
        driver.settle();
        CHECK(driver.logHas("missing-picture"));
        CHECK(driver.context().pictures.failed());
    } // the end of the window waits for no reader
}

TEST_CASE("Files: a reader that hangs is left behind when the window ends") {
    const TemporaryFolder place;
    const std::filesystem::path pipe = place.path / "bay.msh";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    {
        Draughtsman driver;
        driver.editor().input().push({.kind = InputKind::Drop, .paths = {pipe.string()}}); // named by the user
        driver.frames(3);
        CHECK(driver.context().task.busy());
    }
    const int otherEnd = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK); // lets the reader end
    CHECK(otherEnd >= 0);
    ::close(otherEnd);
}

TEST_CASE("Start: pipes and folders in place of settings and projects are reported, and waited for by nobody") {
    const TemporaryFolder place;
    for (const bool pipe : {true, false}) {
        std::filesystem::remove_all(place.path / "settings.json");
        if (pipe) {
            REQUIRE(::mkfifo((place.path / "settings.json").c_str(), 0600) == 0);
            REQUIRE(::mkfifo((place.path / "plan.forefront").c_str(), 0600) == 0);
        } else {
            std::filesystem::create_directory(place.path / "settings.json");
        }
        EditorSetup setup;
        setup.settingsFolder = place.path;
        setup.file = place.path / "plan.forefront";
        Draughtsman driver(setup);
        CHECK(driver.logHas("bad-settings"));
        CHECK(driver.logHas("cannot-read"));
        driver.context().settings.hints = !driver.context().settings.hints; // to be saved
        driver.settle();
    }
}

TEST_CASE("Start: settings that cannot be read are kept beside the new ones") {
    const TemporaryFolder place;
    std::ofstream(place.path / "settings.json") << "{\"theme\": \"light\",";
    EditorSetup setup;
    setup.settingsFolder = place.path;
    {
        Draughtsman driver(setup);
        CHECK(driver.logHas("bad-settings"));
        driver.context().settings.hints = !driver.context().settings.hints;
        driver.settle();
    }
    std::ifstream kept(place.path / "settings.json.old");
    CHECK(std::string(std::istreambuf_iterator<char>(kept), {}) == "{\"theme\": \"light\",");
}

TEST_CASE("Export: replacing any file of a format with several needs a confirmation") {
    const TemporaryFolder place;
    std::ofstream(place.path / "bay.ele") << "keep me";
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('E', {Modifiers::kControl});
    driver.settle();
    driver.until([&] { return driver.has("dialog/export/ok") && driver.run().complete; });
    driver.settle();
    driver.click("dialog/export/preset/triangle");
    driver.chooseFile("export", place.path / "bay.node");
    CHECK(driver.has("dialog/export/ok")); // asks
    CHECK(std::filesystem::file_size(place.path / "bay.ele") == 7);
    driver.click("dialog/export/ok");
    driver.settle();
    driver.until([&] { return !driver.context().dialogs.any(); });
    CHECK(std::filesystem::file_size(place.path / "bay.ele") > 7);
}

} // namespace forefront::test
