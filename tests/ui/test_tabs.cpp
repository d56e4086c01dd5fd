#include "core/drawing/document/equality.hpp"
#include "core/drawing/recovery/journal_record.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/tab_commands.hpp"
#include "ui/editor/apply_settings.hpp"
#include "ui/parts/shown_panels.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace forefront::test {

namespace {

constexpr Modifiers kWithControl{Modifiers::kControl};

/// A draughtsman with tabs.
class Clerk : public Draughtsman {
  public:
    using Draughtsman::Draughtsman;

    void control(int code) {
        key(code, kWithControl);
        settle();
    }
    std::size_t tabs() { return context().tabs.size(); }
    std::size_t active() { return context().tabs.active(); }
    std::string title() { return context().document.title(); }
    std::size_t shapes() { return document().shapes.size(); }
    /// Draws as many squares side by side.
    void squares(std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            const double x = 1.0 + 2.0 * static_cast<double>(k);
            rectangle({x, 1.0}, {x + 1.5, 2.5});
        }
        settle();
    }
    void meshAll() {
        key(key::kF5);
        until([&] { return run().complete && !context().run.busy(); });
        settle();
    }
    void middleClick(std::string_view widget) {
        const PixelRect rect = context().widgets.find(widget)->rect;
        const Pixel at{rect.x + rect.width / 2, rect.y + rect.height / 2};
        moveTo(at);
        press(at, MouseButton::Middle);
        release(at, MouseButton::Middle);
        settle();
    }
};

Document square() {
    Shape shape;
    shape.nodes = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    return *addShape({}, shape);
}

/// Returns the numbers of shapes in the journals of a folder.
std::multiset<std::size_t> journalled(const std::filesystem::path &folder) {
    std::multiset<std::size_t> counts;
    std::error_code failed;
    for (std::filesystem::directory_iterator file(folder, failed), end; !failed && file != end;
         file.increment(failed)) {
        std::ostringstream bytes;
        bytes << std::ifstream(file->path(), std::ios::binary).rdbuf();
        if (const Result<Document> document =
                parseProject(readJournal(bytes.str()).text.value_or(std::string()), "journal")) {
            counts.insert(document->shapes.size());
        }
    }
    return counts;
}

} // namespace

TEST_CASE("Tabs: each keeps its drawing, undo, selection, view and workspace; one document shows no tabs") {
    Clerk driver;
    CHECK_FALSE(driver.has("tab/0"));
    const PixelRect alone = driver.canvas();
    driver.squares(1);
    driver.control('A');
    driver.context().view.pan({37.0, 11.0});
    driver.workspace(WorkspaceKind::Judge);
    driver.settle();
    const Camera camera = driver.context().view.camera;
    driver.control('T');
    REQUIRE(driver.tabs() == 2);
    CHECK(driver.has("tab/1"));
    CHECK(driver.has("tab/0/unsaved"));
    CHECK_FALSE(driver.has("tab/1/unsaved"));
    CHECK(driver.canvas().y > alone.y);
    CHECK(driver.shapes() == 0);
    CHECK(driver.title() == "Untitled 2");
    CHECK(driver.context().selection.empty());
    CHECK(driver.undoLabel().empty());
    driver.workspace(WorkspaceKind::Size);
    driver.settle();
    driver.squares(2);
    driver.control(key::kPageUp);
    CHECK(driver.active() == 0);
    CHECK(driver.shapes() == 1);
    CHECK(driver.title() == "Untitled");
    CHECK(driver.context().selection.shapes.size() == 1);
    CHECK(driver.context().settings.workspace == WorkspaceKind::Judge);
    CHECK(driver.context().view.camera.zoom == camera.zoom);
    CHECK(driver.context().view.camera.centre.x == doctest::Approx(camera.centre.x));
    driver.control('Z');
    CHECK(driver.shapes() == 0);
    driver.click("tab/1");
    driver.settle();
    CHECK(driver.shapes() == 2);
    CHECK(driver.context().settings.workspace == WorkspaceKind::Size);
    driver.control('Z');
    CHECK(driver.shapes() == 1);
    driver.control(key::kPageDown); // round to the first
    driver.key('Z', {Modifiers::kControl | Modifiers::kShift});
    driver.settle();
    CHECK(driver.shapes() == 1);
    CHECK(driver.active() == 0);
}

TEST_CASE("Tabs: each keeps its mesh and its place on the timeline, also if memory runs short") {
    Clerk driver;
    driver.squares(1);
    driver.meshAll();
    driver.context().run.seek(5);
    driver.settle();
    const std::uint64_t hash = driver.run().meshHash, version = driver.run().mesh->version;
    const std::uint64_t state = driver.run().stateHash;
    REQUIRE(driver.run().advance == 5);
    driver.control('T');
    CHECK(driver.run().mesh == nullptr);
    driver.squares(2);
    driver.meshAll();
    const std::uint64_t second = driver.run().meshHash;
    CHECK(driver.run().mesh->version != version);
    driver.control(key::kPageUp);
    CHECK(driver.run().advance == 5);
    CHECK(driver.run().meshHash == hash);
    CHECK(driver.run().mesh->version == version);
    driver.context().tabs.limitMemory(driver.context(), 0); // drops the mesh of the other tab
    CHECK(driver.context().tabs.at(1).left->run->elements() == 0);
    driver.control(key::kPageDown);
    driver.until([&] { return driver.run().complete && !driver.context().run.busy(); });
    driver.settle();
    CHECK(driver.run().meshHash == second);
    driver.context().tabs.limitMemory(driver.context(), 0);
    driver.control(key::kPageUp);
    driver.until([&] { return driver.run().advance == 5 && !driver.context().run.busy(); });
    driver.settle();
    CHECK(driver.run().stateHash == state);
    driver.context().run.step(1);
    driver.settle();
    CHECK(driver.run().advance == 6);
    driver.context().run.seekEnd();
    driver.until([&] { return driver.run().complete && !driver.context().run.busy(); });
    driver.settle();
    CHECK(driver.run().meshHash == hash);
}

TEST_CASE("Tabs: what is being drawn is finished, and what is copied can be pasted in another tab") {
    Clerk driver;
    driver.key('P');
    for (const Vec2 corner : {Vec2{1, 1}, Vec2{5, 1}, Vec2{5, 4}}) {
        driver.clickPlace(corner);
    }
    driver.control('T');
    driver.control(key::kPageUp);
    REQUIRE(driver.shapes() == 1);
    driver.control('A');
    driver.control('C');
    driver.control(key::kPageDown);
    CHECK(driver.shapes() == 0);
    driver.control('V');
    CHECK(driver.shapes() == 1);
    CHECK(driver.document().shapes[0]->nodes.size() == 3);
}

TEST_CASE("Tabs: a drag does not go on in a tab that is shown meanwhile") {
    Clerk driver;
    driver.squares(1);
    driver.control('T');
    driver.squares(1);
    const Document here = driver.document();
    driver.control(key::kPageUp);
    driver.key('V');
    driver.settle();
    driver.press(driver.pixel({1.0, 1.7})); // on an edge
    driver.moveTo(driver.pixel({1.4, 2.2}));
    driver.moveTo(driver.pixel({1.8, 2.6}));
    const Document moved = driver.document();
    driver.control(key::kPageDown);
    CHECK(driver.active() == 0); // keys wait for the end of a drag
    showTab(driver.context(), 1);
    driver.moveTo(driver.pixel({3.0, 3.0}));
    driver.release(driver.pixel({3.5, 3.5}));
    driver.settle();
    CHECK(sameContent(driver.document(), here));
    driver.control(key::kPageUp);
    CHECK(sameContent(driver.document(), moved));
    CHECK_FALSE(sameContent(moved, here));
}

TEST_CASE("Tabs: closing asks about unsaved changes, and the last tab becomes an empty drawing") {
    const testing::TemporaryFolder place;
    Clerk driver;
    driver.squares(1);
    driver.control('T');
    driver.control('T');
    REQUIRE(driver.tabs() == 3);
    driver.middleClick("tab/1"); // unchanged
    CHECK(driver.tabs() == 2);
    CHECK(driver.active() == 1);
    driver.middleClick("tab/0"); // shown before the question
    CHECK(driver.active() == 0);
    REQUIRE(driver.has("dialog/unsaved/cancel"));
    driver.click("dialog/unsaved/cancel");
    driver.settle();
    CHECK(driver.tabs() == 2);
    driver.click("tab/0/close");
    driver.settle();
    driver.click("dialog/unsaved/save");
    driver.settle();
    driver.chooseFile("save", place / "square.forefront");
    CHECK(driver.tabs() == 1);
    CHECK(std::filesystem::exists(place / "square.forefront"));
    CHECK(driver.context().settings.lastFile.empty()); // it was closed
    CHECK_FALSE(driver.has("tab/0"));
    driver.squares(1);
    driver.control('W');
    REQUIRE(driver.has("dialog/unsaved/discard"));
    driver.click("dialog/unsaved/discard");
    driver.settle();
    CHECK(driver.tabs() == 1);
    CHECK(driver.shapes() == 0);
    CHECK(driver.editor().running());
}

TEST_CASE("Tabs: quitting asks about each unsaved one") {
    Clerk driver;
    driver.squares(1);
    driver.control('T');
    driver.squares(2);
    driver.control('T');
    driver.key('Q', kWithControl);
    driver.frames(6);
    CHECK(driver.active() == 0);
    REQUIRE(driver.has("dialog/unsaved/discard"));
    driver.click("dialog/unsaved/discard");
    driver.frames(6);
    CHECK(driver.active() == 1);
    REQUIRE(driver.has("dialog/unsaved/cancel"));
    driver.click("dialog/unsaved/cancel");
    driver.settle();
    CHECK(driver.editor().running());
    CHECK(driver.tabs() == 3);
    driver.key('Q', kWithControl);
    driver.frames(6);
    driver.click("dialog/unsaved/discard");
    driver.frames(6);
    driver.click("dialog/unsaved/discard");
    driver.frames(6);
    CHECK_FALSE(driver.editor().running());
}

TEST_CASE("Tabs: files open beside each other once, and come back at the next start with the one shown") {
    const testing::TemporaryFolder place;
    std::vector<std::filesystem::path> files;
    for (const char *name : {"a.forefront", "b.forefront", "c.forefront"}) {
        files.push_back(place / name);
        REQUIRE(writeProject(files.back(), square()).empty());
    }
    EditorSetup setup{.settingsFolder = place.path / "settings", .file = files[0], .others = {files[1], files[2]}};
    setup.sample = false;
    {
        Driver driver(setup);
        driver.until([&] { return driver.context().tabs.waiting.empty(); });
        driver.settle();
        REQUIRE(driver.context().tabs.size() == 3);
        CHECK(driver.context().document.path() == files[2]);
        openInTab(driver.context(), files[1]);
        driver.settle();
        CHECK(driver.context().tabs.size() == 3);
        CHECK(driver.context().tabs.active() == 1);
        driver.editor().input().push({.kind = InputKind::Drop, .paths = {files[1].string(), files[0].string()}});
        driver.settle();
        CHECK(driver.context().tabs.size() == 3);
        CHECK(driver.context().tabs.active() == 0);
        for (const std::size_t tab : {1U, 0U}) { // a recent file, say
            openDocument(driver.context(), files[tab]);
            driver.settle();
            CHECK(driver.context().tabs.size() == 3);
            CHECK(driver.context().tabs.active() == tab);
        }
        closeTab(driver.context(), 2);
        driver.settle();
        driver.context().tabs.waiting = {files[2], place / "map.dxf"};
        const Settings saved = settingsToSave(driver.context());
        CHECK(saved.openFiles == std::vector<std::string>{files[0].string(), files[1].string(), files[2].string()});
        CHECK(saved.lastFile == files[2].string());
        driver.context().tabs.waiting.clear();
    }
    setup.file.clear();
    setup.others.clear();
    setup.reopens = true;
    Driver driver(setup);
    driver.until([&] { return driver.context().tabs.waiting.empty(); });
    driver.settle();
    REQUIRE(driver.context().tabs.size() == 2);
    CHECK(captionOf(driver.context(), 1).path == files[1]);
    CHECK(driver.context().document.path() == files[0]);
    CHECK(driver.context().document.current()->shapes.size() == 1);
    driver.frames(30);
    CHECK(driver.context().settings.lastFile == files[0].string());
}

TEST_CASE("Tabs: closing the window shows no other tab below a dialog") {
    Clerk driver;
    driver.squares(1);
    driver.control('T');
    driver.squares(2);
    driver.key('S', kWithControl);
    driver.settle();
    REQUIRE(driver.has("dialog/save/ok"));
    driver.editor().input().push({.kind = InputKind::Close});
    driver.settle();
    CHECK(driver.active() == 1);
    CHECK(driver.has("dialog/save/ok"));
    CHECK_FALSE(driver.has("dialog/unsaved/cancel"));
    CHECK(driver.context().log.entries().back().diagnostic.message.find("Close the dialog") != std::string::npos);
    CHECK(driver.editor().running());
}

TEST_CASE("Tabs: what is read in the background is shown in the tab that asked for it") {
    const testing::TemporaryFolder place;
    std::ofstream(place / "square.json")
        << R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]]})";
    Clerk driver;
    driver.squares(2);
    driver.control('T');
    openDocument(driver.context(), place / "square.json");
    showTab(driver.context(), 0);
    driver.until([&] { return !driver.context().task.busy(); });
    driver.settle();
    CHECK(driver.active() == 1);
    CHECK(driver.shapes() == 1);
    CHECK(driver.context().tabs.at(0).left->document.history.shared()->shapes.size() == 2);
}

TEST_CASE("Tabs: a picture among dropped files is no drawing") {
    const testing::TemporaryFolder place;
    REQUIRE(writeProject(place / "a.forefront", square()).empty());
    Clerk driver;
    driver.editor().input().push(
        {.kind = InputKind::Drop, .paths = {(place / "a.forefront").string(), (place / "map.png").string()}});
    driver.settle();
    CHECK(driver.tabs() == 1);
    CHECK(driver.shapes() == 1);
    CHECK(driver.context().log.entries().back().diagnostic.message.starts_with("map.png was not added"));
}

TEST_CASE("Tabs: only new ones use up a name, and each leaves a presentation for its own workspace") {
    Clerk driver;
    driver.workspace(WorkspaceKind::Size);
    driver.control('T');
    driver.workspace(WorkspaceKind::Judge);
    driver.context().actions.run("view.present", driver.context());
    driver.settle();
    REQUIRE(driver.context().presentedFrom);
    driver.context().actions.run("file.nextTab", driver.context());
    driver.settle();
    CHECK(driver.context().settings.workspace == WorkspaceKind::Step);
    driver.context().actions.run("view.present", driver.context());
    driver.settle();
    CHECK(driver.context().settings.workspace == WorkspaceKind::Size);
    driver.control(key::kPageDown);
    CHECK(driver.context().settings.workspace == WorkspaceKind::Judge);
    driver.control('T');
    CHECK(driver.title() == "Untitled 3");
}

TEST_CASE("Tabs: a mesh that is made at full speed goes on in the background, and is not dropped meanwhile") {
    Clerk driver;
    driver.squares(1);
    bool making = false;
    for (double size = 0.004; !making && size > 0.003; size *= 0.97) { // again where the run was over too soon
        showTab(driver.context(), 0);
        driver.settle();
        Document fine = driver.document();
        fine.spacing.size = size;
        driver.context().document.apply(std::move(fine), "Size");
        driver.context().run.mesh();
        driver.until([&] { return driver.run().state == RunState::Running || driver.run().complete; });
        driver.context().tabs.open(driver.context());
        making = driver.context().tabs.at(0).left->run->session.busy();
        if (making) {
            driver.context().tabs.limitMemory(driver.context(), 0);
        }
    }
    REQUIRE(making);
    driver.until([&] { return !driver.context().tabs.at(0).left->run->session.busy(); });
    CHECK(driver.context().tabs.at(0).left->run->session.latest()->state == RunState::Finished);
}

TEST_CASE("Tabs: titles can be read in a window of 1280 pixels, and those without room are in a list") {
    Clerk driver;
    for (int k = 0; k < 19; ++k) {
        driver.key('T', kWithControl);
    }
    driver.settle();
    REQUIRE(driver.tabs() == 20);
    CHECK(driver.has("tab/19"));
    CHECK_FALSE(driver.has("tab/0"));
    for (std::size_t tab = 0; tab < 20; ++tab) {
        const auto *const found = driver.context().widgets.find("tab/" + std::to_string(tab));
        if (driver.has("tab/" + std::to_string(tab))) {
            CHECK(found->rect.width > 80.0);
            CHECK(found->rect.x + found->rect.width < 1280.0);
        }
    }
    driver.click("tab/more");
    driver.settle();
    REQUIRE(driver.has("contextmenu/tab0"));
    driver.click("contextmenu/tab0");
    driver.settle();
    CHECK(driver.active() == 0);
    CHECK(driver.has("tab/0"));
    driver.click("tab/new");
    driver.settle();
    CHECK(driver.tabs() == 21);
    CHECK(driver.active() == 1);
}

// Not a test in itself: this is the process that the next test kills.
TEST_CASE("Tabs: draws in three tabs in the folder of FOREFRONT_TEST_TABBED and waits" * doctest::skip()) {
    const char *const folder = std::getenv("FOREFRONT_TEST_TABBED");
    if (folder == nullptr) {
        return;
    }
    Clerk driver({.stateFolder = std::filesystem::path(folder) / "state"});
    for (std::size_t count = 1; count <= 3; ++count) {
        driver.squares(count);
        if (count < 3) {
            driver.control('T');
        }
    }
    for (;;) {
        ::pause();
    }
}

TEST_CASE("Tabs: after kill -9 the next start recovers all three, each in a tab") {
    const testing::TemporaryFolder place;
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ::setenv("FOREFRONT_TEST_TABBED", place.path.c_str(), 1);
        ::execl("/proc/self/exe", "victim", "--no-skip", "-tc=*FOREFRONT_TEST_TABBED*", static_cast<char *>(nullptr));
        ::_exit(1);
    }
    int status = 0;
    const std::multiset<std::size_t> all{1, 2, 3};
    while (journalled(place.path / "state" / "recovery") != all) {
        REQUIRE(::waitpid(child, &status, WNOHANG) == 0);
        ::usleep(20000);
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
    Driver driver({.stateFolder = place.path / "state", .sample = false});
    REQUIRE(driver.has("dialog/recovery/all"));
    driver.click("dialog/recovery/all");
    driver.settle();
    CHECK(driver.context().dialogs.top() == nullptr);
    REQUIRE(driver.context().tabs.size() == 3);
    std::multiset<std::size_t> found;
    for (std::size_t tab = 0; tab < 3; ++tab) {
        CHECK(captionOf(driver.context(), tab).dirty);
        showTab(driver.context(), tab);
        driver.settle();
        found.insert(driver.context().document.current()->shapes.size());
    }
    CHECK(found == all);
    driver.until([&] { return journalled(place.path / "state" / "recovery") == all; }); // protected again
}

} // namespace forefront::test
