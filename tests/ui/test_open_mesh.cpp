#include "core/files/files.hpp"
#include "tests/ui/meshed_square.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/open_mesh.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <future>
#include <string>
#include <sys/stat.h>
#include <utility>
#include <vector>

namespace forefront::test {

namespace {

/// An empty editor, and a file plate.msh with the mesh of a square.
class PlateReader : public Draughtsman {
  public:
    PlateReader() { REQUIRE_FALSE(hasErrors(writeMesh(folder_ / "plate.msh", MeshedSquare().mesh()))); }

    void open() { openMesh(context(), folder_ / "plate.msh"); }
    const std::filesystem::path &folder() const { return folder_.path; }
    /// Opens the dialog of an action and chooses a file by its name.
    void choose(const char *action, const std::string &dialog, const std::string &file) {
        context().actions.run(action, context());
        settle();
        click("dialog/" + dialog + "/name");
        key('A', {Modifiers::kControl});
        type((folder_ / file).string());
        click("dialog/" + dialog + "/ok");
    }
    bool showsFile() { return context().run.showsFile(); }
    std::string lastMessage() { return context().log.entries().back().diagnostic.message; }

  private:
    TemporaryFolder folder_;
};

} // namespace

TEST_CASE("Open mesh: the file is read on another thread, and Esc drops it") {
    PlateReader driver;
    driver.open();
    CHECK(driver.context().task.busy()); // its result is used in the next frame at the earliest
    CHECK_FALSE(driver.showsFile());
    CHECK(driver.context().task.name() == "reading plate.msh");
    driver.context().actions.run("run.cancel", driver.context()); // the action of Esc
    CHECK(driver.lastMessage() == "Cancelled reading plate.msh");
    driver.settle();
    CHECK_FALSE(driver.context().task.busy());
    CHECK_FALSE(driver.showsFile());
}

TEST_CASE("Open mesh: its colours end with it, unless the user chooses colours meanwhile") {
    for (const bool sizes : {true, false}) {
        CAPTURE(sizes);
        PlateReader driver;
        driver.workspace(WorkspaceKind::Size);
        driver.unfoldLayers();
        const auto visible = [&](const char *layer) { return driver.context().layer(layer)->visible; };
        if (!sizes) {
            driver.click("layer/size"); // visible at first
        }
        const auto start = [&] {
            driver.key('N', {Modifiers::kControl});
            driver.settle();
        };
        for (int k = 0; k < 2; ++k) { // opened again
            driver.open();
            driver.settle();
            CHECK(visible("quality"));
            CHECK_FALSE(visible("size"));
        }
        start();
        CHECK_FALSE(visible("quality"));
        CHECK(visible("size") == sizes);
        driver.open();
        driver.settle();
        driver.click("layer/quality");
        driver.click("layer/quality");
        start();
        CHECK(visible("quality"));
    }
}

TEST_CASE("Open: a mesh is read on another thread to be edited as a drawing, and Esc drops it") {
    PlateReader driver;
    openDocument(driver.context(), driver.folder() / "plate.msh");
    CHECK(driver.context().task.busy());
    CHECK(driver.document().shapes.empty());
    driver.context().actions.run("run.cancel", driver.context());
    CHECK(driver.lastMessage() == "Cancelled reading plate.msh");
    driver.settle();
    CHECK(driver.document().shapes.empty());
    driver.choose("file.open", "open", "plate.msh");
    driver.settle();
    CHECK_FALSE(driver.has("dialog/open/ok"));
    CHECK(driver.document().shapes.size() == 1);
    CHECK_FALSE(driver.showsFile());
    CHECK(driver.lastMessage().starts_with("plate.msh (Gmsh MSH 2.2) opened as a new drawing with 1 shape"));
    Driver started({.file = driver.folder() / "plate.msh"}); // a file given on the command line
    started.settle();
    CHECK(started.context().document.current()->shapes.size() == 1);
    REQUIRE_FALSE(started.context().settings.recentFiles.empty());
    CHECK(started.context().settings.recentFiles.front().ends_with("plate.msh"));
}

TEST_CASE("Open: unsaved changes are asked about before the choice of a file, or once a given mesh has been read") {
    PlateReader driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.context().actions.run("file.open", driver.context());
    driver.settle();
    CHECK_FALSE(driver.has("dialog/open/ok"));
    REQUIRE(driver.has("dialog/unsaved/cancel"));
    driver.click("dialog/unsaved/cancel");
    driver.settle();
    CHECK_FALSE(driver.has("dialog/open/ok"));
    openDocument(driver.context(), driver.folder() / "plate.msh"); // such as a recent file
    driver.settle();
    REQUIRE(driver.has("dialog/unsaved/discard"));
    CHECK(driver.document().shapes.front()->kind() == ShapeKind::Rectangle);
    driver.click("dialog/unsaved/discard");
    driver.settle();
    CHECK(driver.document().shapes.front()->kind() == ShapeKind::Polygon);
}

TEST_CASE("Open mesh: the dialogs for meshes offer recent files that are meshes, and begin where the last one was") {
    PlateReader driver;
    const std::filesystem::path drawing = driver.folder() / "ell.json", other = driver.folder() / "bay.msh";
    std::filesystem::copy_file(driver.folder() / "plate.msh", other);
    driver.context().settings.recentFiles = {drawing.string(), other.string()};
    driver.open();
    driver.settle();
    CHECK(driver.context().settings.recentMeshes == std::vector<std::string>{(driver.folder() / "plate.msh").string()});
    driver.context().actions.run("file.compareMesh", driver.context());
    driver.settle();
    REQUIRE(driver.has("dialog/comparemesh/recent/1"));
    CHECK_FALSE(driver.has("dialog/comparemesh/recent/2")); // the drawing
    driver.click("dialog/comparemesh/recent/0");
    driver.settle();
    driver.click("dialog/comparemesh/ok");
    driver.settle();
    REQUIRE(driver.context().sides.mesh() != nullptr);
    CHECK(driver.context().sides.mesh()->name() == "plate.msh");
    driver.context().actions.run("file.open", driver.context());
    driver.settle();
    if (driver.has("dialog/unsaved/discard")) {
        driver.click("dialog/unsaved/discard");
        driver.settle();
    }
    CHECK(driver.has("dialog/open/recent/1"));
}

TEST_CASE("Open mesh: a file that cannot be read is reported in the dialog, which stays open until one can") {
    for (const auto &[action, dialog] :
         {std::pair("file.openMesh", "openmesh"), {"file.compareMesh", "comparemesh"}, {"file.open", "open"}}) {
        PlateReader driver;
        std::ofstream(driver.folder() / "broken.msh") << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\nmany\n";
        const std::string name = std::string("dialog/") + dialog;
        CAPTURE(name);
        if (std::string(dialog) == "comparemesh") {
            driver.open(); // something to compare with
            driver.settle();
        }
        driver.choose(action, dialog, "broken.msh");
        driver.settle();
        REQUIRE(driver.has(name + "/ok"));
        CHECK_FALSE(driver.context().task.busy());
        CHECK(driver.context().widgets.find(name + "/warning")->rect.width > 100.0);
        CHECK(driver.lastMessage().find("found 'many'") != std::string::npos); // in the log too
        driver.type("missing.msh"); // the name has the focus again, and typing replaces it
        driver.key(key::kEnter);
        driver.settle();
        REQUIRE(driver.has(name + "/ok"));
        driver.type((driver.folder() / "plate.msh").string());
        driver.key(key::kEnter);
        driver.settle();
        CHECK_FALSE(driver.has(name + "/ok"));
        CHECK((driver.showsFile() || driver.context().sides.mesh() != nullptr || !driver.document().shapes.empty()));
    }
}

TEST_CASE("Open mesh: while the file is read, the dialog shows how far that is, and Esc or Cancel ends only that") {
    for (const auto &[action, dialog] : {std::pair("file.openMesh", "openmesh"),
                                         {"file.open", "open"},
                                         {"file.import", "import"},
                                         {"file.importSpacing", "importspacing"}}) {
        for (const bool escape : {true, false}) {
            PlateReader driver;
            const std::string name = std::string("dialog/") + dialog;
            CAPTURE(name);
            CAPTURE(escape);
            // Opening a named pipe takes until something opens its other end.
            REQUIRE(::mkfifo((driver.folder() / "pipe.msh").c_str(), 0600) == 0);
            driver.choose(action, dialog, "pipe.msh");
            driver.frames(2);
            CHECK(driver.has(name + "/reading"));
            CHECK_FALSE(driver.context().widgets.find(name + "/ok")->enabled);
            escape ? driver.key(key::kEscape) : static_cast<void>(driver.click(name + "/cancel"));
            driver.frames(2);
            CHECK_FALSE(driver.context().task.busy());
            CHECK(driver.lastMessage() == "Cancelled reading pipe.msh");
            CHECK(driver.has(name + "/ok"));
            CHECK_FALSE(driver.has(name + "/reading"));
            driver.key(key::kEscape);
            driver.frames(2);
            CHECK_FALSE(driver.has(name + "/ok"));
            const std::fstream otherEnd(driver.folder() / "pipe.msh"); // the reader waits for it
        }
    }
}

TEST_CASE("Open: Return after a click on a file opens it") {
    PlateReader driver;
    driver.choose("file.openMesh", "openmesh", "");
    driver.settle();
    driver.click("dialog/openmesh/list/plate.msh");
    driver.frames(40); // no double click
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.has("dialog/openmesh/ok"));
    CHECK(driver.showsFile());
}

TEST_CASE("Background task: the window shows its progress, and Esc does not wait for it") {
    Draughtsman driver;
    std::promise<void> begun, released;
    std::shared_future<void> release = released.get_future().share();
    bool used = false;
    driver.context().task.start("waiting", [&begun, release, &used](const Progress &progress) {
        progress("half of it", 0.5);
        begun.set_value();
        release.wait();
        return [&used] { used = true; };
    });
    begun.get_future().wait();
    driver.frames(2);
    CHECK(driver.has("canvas/task"));
    CHECK(driver.context().task.name() == "half of it");
    CHECK(driver.context().task.fraction() == 0.5);
    driver.key(key::kEscape);
    CHECK_FALSE(driver.context().task.busy());
    driver.settle();
    CHECK_FALSE(driver.has("canvas/task"));
    released.set_value();
    driver.settle();
    CHECK_FALSE(used);
}

TEST_CASE("Open mesh: the mesh is shown when the gesture that began meanwhile has ended") {
    PlateReader driver;
    driver.press(driver.pixel({5, 5}));
    driver.open();
    driver.settle();
    CHECK(driver.context().task.ready());
    CHECK_FALSE(driver.showsFile());
    driver.release(driver.pixel({5, 5}));
    driver.settle();
    CHECK(driver.showsFile());
    CHECK_FALSE(driver.context().task.busy());
}

TEST_CASE("Open mesh: a document that was opened while the file was read stays") {
    PlateReader driver;
    driver.open();
    driver.context().document.load({}, "other.forefront");
    driver.settle();
    CHECK_FALSE(driver.context().task.busy());
    CHECK_FALSE(driver.showsFile());
    CHECK(driver.context().document.title() == "other.forefront");
    CHECK(driver.lastMessage() == "plate.msh is not shown: another document was opened while it was read");
}

TEST_CASE("Open mesh: meshing the outline replaces the mesh of the file") {
    PlateReader driver;
    driver.open();
    driver.settle();
    REQUIRE(driver.showsFile());
    driver.key('W'); // a click of the trace tool must not discard it
    driver.clickPlace({4, 4});
    driver.settle();
    REQUIRE(driver.showsFile());
    driver.key(key::kF5);
    driver.settle();
    CHECK_FALSE(driver.showsFile());
    CHECK(driver.run().quality.elements > 0);
    CHECK(driver.run().known > 0);
}

TEST_CASE("Open mesh: keys that step through a run leave the mesh unchanged and say so") {
    PlateReader driver;
    driver.open();
    driver.settle();
    for (const int key : {key::kPeriod, key::kComma, key::kSpace, key::kHome, key::kEnd}) {
        CAPTURE(key);
        driver.key(key);
        driver.settle();
        CHECK(driver.showsFile());
    }
    CHECK(driver.lastMessage().find("no run to step through") != std::string::npos);
}

} // namespace forefront::test
