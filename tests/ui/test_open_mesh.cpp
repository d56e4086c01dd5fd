#include "core/io/files.hpp"
#include "tests/ui/meshed_square.hpp"
#include "ui/dialogs/open_mesh.hpp"

#include <doctest/doctest.h>

#include <future>
#include <string>

namespace forefront::test {

namespace {

/// An empty editor, and a file plate.msh with the mesh of a square.
class PlateReader : public Draughtsman {
  public:
    PlateReader() { REQUIRE_FALSE(hasErrors(writeMesh(folder_ / "plate.msh", MeshedSquare().mesh()))); }

    void open() { openMesh(context(), folder_ / "plate.msh"); }
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
    driver.settle();
    CHECK_FALSE(driver.context().task.busy());
    CHECK_FALSE(driver.showsFile());
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
