#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/recovery/recovery_journal.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/dialogs/tab_commands.hpp"
#include "ui/parts/settings.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <iterator>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

Document triangle() {
    Shape shape;
    shape.nodes = {{0, 0}, {4, 0}, {1, 3}};
    return *addShape({}, shape);
}

/// Stops a thread where it calls pass(), until the gate is opened. A test that fails does not hang: the gate opens by
/// itself after a while.
class Gate {
  public:
    void pass() {
        std::unique_lock lock(mutex_);
        waits_ = true;
        changed_.notify_all();
        changed_.wait_for(lock, std::chrono::seconds(20), [this] { return open_; });
        waits_ = false;
    }
    void awaitThread() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return waits_; });
    }
    bool threadWaits() {
        const std::lock_guard lock(mutex_);
        return waits_;
    }
    void open() {
        const std::lock_guard lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool waits_ = false, open_ = false;
};

/// The three projects of a test about the next start.
struct ThreeProjects {
    testing::TemporaryFolder place;
    std::vector<std::string> files;
    EditorSetup setup{.settingsFolder = place.path / "settings", .stateFolder = place.path / "state", .sample = false};

    ThreeProjects() {
        for (const char *name : {"a.forefront", "b.forefront", "c.forefront"}) {
            files.push_back((place / name).string());
            REQUIRE(writeProject(files.back(), triangle()).empty());
        }
        setup.reopens = true;
        Settings settings;
        settings.openFiles = files;
        settings.lastFile = files.back();
        std::filesystem::create_directories(setup.settingsFolder);
        saveSettings(setup.settingsFolder / "settings.json", settings);
    }
    Settings saved() const { return loadSettings(setup.settingsFolder / "settings.json"); }
    /// Leaves a drawing behind as a program that was killed does.
    void leaveJournal() const {
        const std::filesystem::path folder = setup.stateFolder / "recovery";
        std::filesystem::create_directories(folder);
        RecoveryJournal journal(folder, projectText);
        journal.record(std::make_shared<const Document>(triangle()), {.savedAt = {}, .title = "Bracket"});
        journal.flush();
        std::filesystem::copy_file(journal.file(), folder / "1-1.journal");
    }
};

} // namespace

TEST_CASE("Tabs: dropping a run does not wait for its worker") {
    Gate gate;
    BackgroundList list([&gate] { gate.pass(); });
    DocumentStore document;
    MessageLog log(document);
    RunControl control(document, log, list);
    auto run = std::make_unique<DocumentRun>(list.wake(), std::make_shared<RunNumbers>());
    run->session.start(std::make_shared<const MeshingJob>(jobOf(triangle())), StartMode::Run);
    gate.awaitThread();
    control.drop(std::move(run));
    CHECK(gate.threadWaits()); // it has not been waited for
    CHECK(control.ending() == 1);
    CHECK(control.working());
    control.refresh();
    CHECK(control.ending() == 1);
    gate.open();
    while (control.working()) {
    }
    control.refresh();
    CHECK(control.ending() == 0);
}

TEST_CASE("Tabs: closing one whose mesh is being made, or dropping its mesh, leaves the run to end by itself") {
    Draughtsman driver;
    Shell &context = driver.context();
    driver.rectangle({1, 1}, {9, 8});
    Document fine = driver.document();
    fine.spacing.size = 0.01;
    context.document.apply(std::move(fine), "Size");
    context.run.mesh();
    context.tabs.open(context);
    REQUIRE(context.tabs.at(0).left->run->session.busy());
    context.tabs.close(0, context);
    CHECK(context.run.ending() == 1);
    CHECK(context.tabs.size() == 1);
    driver.settle();
    driver.frames(1);
    CHECK(context.run.ending() == 0);
    driver.rectangle({1, 1}, {2, 2});
    context.run.mesh();
    driver.settle();
    context.tabs.open(context);
    context.tabs.limitMemory(context, 0);
    CHECK(context.run.ending() == 1);
    driver.settle();
    driver.frames(1);
    CHECK(context.run.ending() == 0);
    CHECK(context.tabs.at(0).left->run->elements() == 0);
}

TEST_CASE("Tabs: views beside the canvas end by themselves when another tab is shown") {
    Draughtsman driver;
    Shell &context = driver.context();
    driver.rectangle({1, 1}, {9, 8});
    context.run.mesh();
    driver.settle();
    context.sides.visible = true;
    driver.settle();
    REQUIRE(context.sides.size() > 0);
    context.tabs.open(context);
    driver.frames(1);
    CHECK(context.sides.size() == 0);
    driver.settle();
    CHECK_FALSE(context.sides.working());
}

TEST_CASE("Tabs: the journal of one that was closed is removed once it is written") {
    const testing::TemporaryFolder place;
    Gate gate;
    {
        RecoveryJournal journal(place.path / "slow", [&gate](const Document &document) {
            gate.pass();
            return projectText(document);
        });
        CHECK(journal.resting());
        journal.record(std::make_shared<const Document>(triangle()), {});
        gate.awaitThread();
        CHECK_FALSE(journal.resting()); // its destructor would wait
        gate.open();
        journal.flush();
        CHECK(journal.resting());
    }
    Draughtsman driver({.stateFolder = place.path / "state"});
    driver.rectangle({1, 1}, {9, 8});
    driver.key('T', kControl);
    driver.settle();
    const std::filesystem::path folder = place.path / "state" / "recovery";
    const auto journals = [&] {
        return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
    };
    driver.until([&] { return std::filesystem::exists(folder) && journals() == 1; });
    driver.context().tabs.close(0, driver.context());
    driver.until([&] { return journals() == 0; });
}

TEST_CASE("Tabs: a kill during the question about unsaved drawings loses no project that waits to be opened again") {
    const ThreeProjects projects;
    projects.leaveJournal();
    Driver driver(projects.setup);
    driver.settle();
    REQUIRE(driver.has("dialog/recovery/later"));
    CHECK(driver.context().tabs.waiting.size() == 2);
    CHECK(projects.saved().openFiles == projects.files); // what a kill leaves
    CHECK(projects.saved().lastFile == projects.files.back());
    driver.click("dialog/recovery/later");
    driver.until([&] { return driver.context().tabs.waiting.empty(); });
    driver.settle();
    CHECK(driver.context().tabs.size() == 3);
    CHECK(projects.saved().openFiles == projects.files);
}

TEST_CASE("Tabs: a project that ends the program while it is opened again is the only one left out at the next start") {
    const ThreeProjects projects;
    std::string fault;
    const auto platform = EglPlatform::create({640, 480}, 1.0, fault);
    REQUIRE(platform);
    Editor editor(*platform, projects.setup);
    const std::vector<std::string> &files = projects.files;
    CHECK(projects.saved().openFiles == std::vector<std::string>{files[1], files[2]});
    while (editor.context().tabs.waiting.size() == 2) {
        editor.frame();
    }
    CHECK(projects.saved().openFiles == std::vector<std::string>{files[2]}); // neither is shown yet
    while (editor.context().tabs.waiting.size() == 1) {
        editor.frame();
    }
    CHECK(projects.saved().openFiles.empty());
    while (!editor.settled()) {
        editor.frame();
    }
    CHECK(projects.saved().openFiles == files);
}

} // namespace forefront::test
