#include "tests/ui/meshed_square.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace forefront::test {

namespace {

/// Opens the panel, high enough for its list of meshes.
void openPanel(Driver &driver) {
    driver.context().animate();
    driver.settle();
    driver.showPanel("adapt");
    driver.settle();
}

bool logSays(Driver &driver, std::string_view text) {
    const auto &entries = driver.context().log.entries();
    return std::any_of(entries.begin(), entries.end(), [&](const MessageLog::Entry &entry) {
        return entry.diagnostic.message.find(text) != std::string::npos;
    });
}

bool enabled(Driver &driver, std::string_view widget) {
    const WidgetRegistry::Widget *const found = driver.context().widgets.find(widget);
    return found != nullptr && found->enabled;
}

/// Makes the drawing larger.
void editDrawing(Driver &driver) {
    Document next = *driver.context().document.current();
    Shape wider = *next.shapes.front();
    wider.nodes[1].x += 1.0;
    next.shapes.front() = std::make_shared<const Shape>(wider);
    driver.context().document.apply(std::move(next), "Widen");
}

/// A meshed square with the panel that adapts meshes.
class Adapting : public MeshedSquare {
  public:
    Adapting() { openPanel(*this); }
    const AdaptProgress &adaptation() { return context().adaptation.now(); }
    const TriMesh &roundMesh(std::size_t round) { return adaptation().rounds[round]->mesh; }
};

} // namespace

TEST_CASE("Adapt: rounds meet the target of an expression; each mesh can be shown, and its spacing kept") {
    Adapting driver;
    const std::uint64_t first = driver.run().meshHash;
    driver.fill("adapt/expression", "atan(2*(x+y-9))");
    driver.fill("adapt/error", "20");
    driver.click("adapt/start");
    driver.settle();
    REQUIRE(driver.adaptation().rounds.size() >= 2);
    CHECK(driver.adaptation().met);
    CHECK(driver.adaptation().rounds.back()->error.value_or(1.0) <= 0.2);
    CHECK(meshHash(driver.roundMesh(0)) == first);
    const std::size_t last = driver.adaptation().rounds.size() - 1;
    CHECK(driver.context().adaptation.selected == last);
    CHECK(driver.run().meshHash == meshHash(driver.roundMesh(last))); // shown as it was made
    CHECK(driver.context().run.showsAdapted());
    CHECK(driver.context().judgement->of.field == "estimated error");
    CHECK(driver.context().judgement->values == driver.adaptation().rounds[last]->errors);

    driver.click("adapt/round/0");
    driver.settle();
    CHECK(driver.run().meshHash == first);
    CHECK(driver.context().judgement->values == driver.adaptation().rounds[0]->errors);
    const WidgetRegistry::Widget *const keep = driver.context().widgets.find("adapt/keep");
    REQUIRE(keep != nullptr);
    CHECK_FALSE(keep->enabled); // the first mesh has the spacing of the drawing already

    driver.click("adapt/round/1");
    driver.settle();
    driver.click("adapt/keep");
    driver.settle();
    CHECK(driver.undoLabel() == "Keep adapted spacing");
    const std::uint64_t second = meshHash(driver.roundMesh(1));
    driver.key(key::kF5);
    driver.settle();
    CHECK_FALSE(driver.context().run.showsFile());
    CHECK(driver.run().meshHash == second); // the drawing makes the same mesh
}

TEST_CASE("Adapt: Esc ends an adaptation and leaves the rounds that are finished") {
    Adapting driver;
    driver.fill("adapt/expression", "sin(3*x)*sin(3*y)");
    driver.fill("adapt/error", "0.05");
    driver.fill("adapt/rounds", "100");
    driver.click("adapt/start");
    driver.until([&] { return driver.adaptation().rounds.size() >= 2; });
    CHECK(driver.has("adapt/progress"));
    driver.moveTo(driver.canvas().centre());
    driver.key(key::kEscape);
    driver.until([&] { return !driver.context().adaptation.busy(); });
    driver.settle();
    CHECK(driver.logHas("cancelled"));
    CHECK_FALSE(logSays(driver, "Adapted: "));
    CHECK(logSays(driver, "Adapting ended early; mesh "));
    CHECK_FALSE(driver.adaptation().met);
    CHECK(driver.adaptation().rounds.size() >= 2);
    CHECK(driver.has("adapt/start"));
}

TEST_CASE("Adapt: a drawing that has changed is meshed again before its meshes are adapted further") {
    for (const bool live : {false, true}) {
        CAPTURE(live);
        Adapting driver;
        driver.context().settings.live = live;
        driver.settle();
        driver.fill("adapt/expression", "atan(2*(x+y-9))");
        driver.fill("adapt/error", "30");
        CHECK(enabled(driver, "adapt/start"));
        driver.click("adapt/start");
        driver.settle();
        REQUIRE(driver.adaptation().rounds.size() >= 2);
        CHECK(enabled(driver, "adapt/start"));
        driver.click("adapt/keep");
        driver.settle();
        CHECK(driver.undoLabel() == "Keep adapted spacing");
        CHECK(enabled(driver, "adapt/start")); // the domain is the same
        editDrawing(driver);
        driver.settle();
        CHECK_FALSE(enabled(driver, "adapt/start"));
        driver.context().actions.run("edit.undo", driver.context());
        driver.settle();
        CHECK(enabled(driver, "adapt/start"));
        editDrawing(driver);
        driver.key(key::kF5);
        driver.settle();
        CHECK(enabled(driver, "adapt/start"));
        driver.click("adapt/start");
        driver.settle();
        CHECK(driver.roundMesh(0).bounds().max.x == 10.0);
        CHECK(driver.roundMesh(1).bounds().max.x == 10.0);
    }
}

TEST_CASE("Adapt: waits until live meshing has caught up with the drawing") {
    Adapting driver;
    driver.context().settings.live = true;
    driver.settle();
    driver.fill("adapt/expression", "x*x");
    REQUIRE(enabled(driver, "adapt/start"));
    editDrawing(driver);
    driver.frames(1);
    CHECK_FALSE(enabled(driver, "adapt/start"));
    driver.settle();
    CHECK(enabled(driver, "adapt/start"));
    driver.click("adapt/start");
    driver.settle();
    REQUIRE(driver.adaptation().rounds.size() >= 2);
    CHECK(driver.roundMesh(0).bounds().max.x == 10.0);
    CHECK(driver.roundMesh(1).bounds().max.x == 10.0);
}

TEST_CASE("Adapt: a run that was started meanwhile is not replaced by a mesh of an adaptation") {
    Adapting driver;
    driver.fill("adapt/expression", "atan(2*(x+y-9))");
    driver.click("adapt/start");
    driver.key(key::kF5);
    driver.settle();
    CHECK_FALSE(driver.context().run.showsFile());
    CHECK(driver.run().complete);
    CHECK(driver.adaptation().rounds.size() >= 2);
}

TEST_CASE("Adapt: dropping the rounds of a running adaptation does not wait for its thread") {
    std::promise<void> begun, dropped;
    std::atomic<bool> cancelledWork = false;
    {
        BackgroundList background([] {});
        Adaptation adaptation(background, [&](const AdaptRequest &, const Progress &progress, const AdaptReport &) {
            begun.set_value();
            dropped.get_future().wait(); // for ever, if clear() waits for this thread
            cancelledWork = progress.cancelled();
            return Result<AdaptOutcome>(error("cancelled", "test"));
        });
        AdaptRequest request;
        request.mesh = std::make_shared<const MeshSnapshot>();
        adaptation.start(request);
        begun.get_future().wait();
        adaptation.clear();
        CHECK_FALSE(adaptation.busy());
        CHECK(background.atRest());
        dropped.set_value();
    }
    CHECK(cancelledWork);
}

TEST_CASE("Adapt: nodal values of an opened mesh give one new mesh, without an error until they are computed again") {
    MeshedSquare maker;
    MeshFields made{maker.mesh(), {}, {}};
    for (const Vec2 place : made.mesh.nodes) {
        made.fields["heat"].push_back(std::atan(4.0 * (place.x - 5.0)));
        made.fields["flow"].push_back(place.y);
    }
    Draughtsman driver;
    driver.context().run.showFile(made);
    openPanel(driver);
    driver.click("adapt/field");
    driver.settle();
    driver.click("adapt/field/heat");
    driver.fill("adapt/error", "10");
    driver.click("adapt/start");
    driver.settle();
    const AdaptProgress &now = driver.context().adaptation.now();
    REQUIRE(now.rounds.size() == 2);
    CHECK(now.rounds[0]->error.value_or(0.0) > 0.1);
    CHECK_FALSE(now.rounds[1]->error);
    const std::size_t elements = driver.run().quality.elements;
    CHECK(elements > made.mesh.elementCount());
    CHECK(driver.context().view.field.empty());

    // The values are used again from the new mesh: they still start from the opened one.
    const std::uint64_t opened = meshHash(made.mesh);
    driver.fill("adapt/error", "5");
    driver.click("adapt/start");
    driver.settle();
    REQUIRE(now.rounds.size() == 2);
    CHECK(meshHash(now.rounds[0]->mesh) == opened);
    CHECK(driver.run().quality.elements > elements);
    driver.click("adapt/round/0");
    driver.settle();
    REQUIRE(driver.context().run.fields());
    CHECK(driver.context().run.fields()->nodes.contains("flow")); // with all its values

    // An expression goes on from the mesh shown, and the values can still be chosen.
    driver.click("adapt/round/1");
    driver.settle();
    driver.click("adapt/field");
    driver.settle();
    driver.click("adapt/field/Expression");
    driver.fill("adapt/expression", "atan(4*(x-5))");
    driver.click("adapt/start");
    driver.settle();
    CHECK(meshHash(now.rounds[0]->mesh) != opened);
    driver.click("adapt/field");
    driver.settle();
    driver.click("adapt/field/heat");
    driver.click("adapt/start");
    driver.settle();
    REQUIRE(now.rounds.size() == 2);
    CHECK(meshHash(now.rounds[0]->mesh) == opened);
}

TEST_CASE("Adapt: bad fields and sizes are refused with a message, and another document drops the rounds") {
    Adapting driver;
    const WidgetRegistry::Widget *start = driver.context().widgets.find("adapt/start");
    REQUIRE(start != nullptr);
    CHECK_FALSE(start->enabled); // no field yet
    driver.fill("adapt/expression", "1+*x");
    CHECK(driver.has("adapt/expression/fault"));
    CHECK(driver.logHas("expression-syntax"));
    CHECK_FALSE(driver.context().widgets.find("adapt/start")->enabled);
    CHECK(driver.adaptation().rounds.empty());
    CHECK_FALSE(driver.context().run.showsFile());
    driver.fill("adapt/expression", "x*x");
    driver.fill("adapt/minimum", "2");
    driver.fill("adapt/maximum", "1.5");
    driver.click("adapt/start");
    driver.settle();
    CHECK(driver.logHas("bad-size"));
    driver.fill("adapt/minimum", "0.4");
    driver.click("adapt/start");
    driver.settle();
    REQUIRE_FALSE(driver.adaptation().rounds.empty());
    driver.context().document.load({}, {});
    driver.settle();
    CHECK(driver.adaptation().rounds.empty());
}

} // namespace forefront::test
