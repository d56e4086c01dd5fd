#include "tests/ui/driver.hpp"
#include "tests/ui/meshed_square.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace forefront::test {

namespace {

/// A driver with a meshed sample.
struct Meshed : Driver {
    Meshed() {
        key(key::k2);
        settle();
    }
};

Document square(double side, double size, Vec2 offset = {}) {
    Document document;
    auto shape = std::make_shared<Shape>();
    shape->id = document.nextId++;
    shape->nodes = {offset, offset + Vec2{side, 0}, offset + Vec2{side, side}, offset + Vec2{0, side}};
    document.shapes.push_back(shape);
    document.spacing.size = size;
    return document;
}

void load(Driver &driver, Document document) {
    driver.context().document.load(std::move(document), {});
    driver.context().run.clear();
    driver.context().view.fitPending = true;
    driver.settle();
}

} // namespace

TEST_CASE("Run: the key 2 meshes the sample, and the panels show its figures") {
    Meshed driver;
    const SessionSnapshot &run = driver.run();
    CHECK(run.state == RunState::Finished);
    CHECK(run.complete);
    CHECK(run.quality.elements > 500);
    CHECK(run.meshHash != 0);
    CHECK_FALSE(driver.context().run.outOfDate());
    CHECK(driver.has("status/counts"));
    driver.showPanel("statistics");
    CHECK(driver.has("statistics/hash"));
    driver.showPanel("histogram");
    driver.frames(2);
    CHECK(driver.has("histogram/39"));
}

TEST_CASE("Run: after Home, . and , step forward and back through the same states") {
    Meshed driver;
    driver.key(key::kHome);
    driver.settle();
    CHECK(driver.run().advance == 0);
    std::map<std::uint64_t, std::uint64_t> hashes{{0, driver.run().stateHash}};
    for (int i = 0; i < 12; ++i) {
        driver.key(key::kPeriod);
        driver.settle();
        hashes[driver.run().advance] = driver.run().stateHash;
    }
    CHECK(driver.run().advance == 12);
    CHECK(hashes.size() == 13);
    for (int i = 0; i < 12; ++i) {
        driver.key(key::kComma);
        driver.settle();
        REQUIRE(hashes.count(driver.run().advance) == 1);
        CHECK(hashes[driver.run().advance] == driver.run().stateHash);
    }
    CHECK(driver.run().advance == 0);
    driver.key(key::kPeriod, {Modifiers::kShift});
    driver.settle();
    CHECK(driver.run().advance == 100);
    driver.key(key::kEnd);
    driver.settle();
    CHECK(driver.run().advance == driver.run().known);
}

TEST_CASE("Run: dragging the scrubber seeks") {
    Meshed driver;
    driver.workspace(WorkspaceKind::Step);
    const PixelRect bar = driver.context().widgets.find("timeline/scrubber")->rect;
    const double y = bar.centre().y;
    driver.drag({bar.x + bar.width - 8, y}, {bar.x + 0.5 * bar.width, y});
    driver.settle();
    const SessionSnapshot &run = driver.run();
    const double part = static_cast<double>(run.position()) / static_cast<double>(run.length());
    CHECK(std::abs(part - 0.5) < 0.03);
    REQUIRE(run.front != nullptr);
    CHECK(run.front->size() > 10);
    CHECK(run.mesh->mesh.elements.size() > 100);
}

TEST_CASE("Run: Space plays the front and pauses it") {
    Driver driver;
    driver.context().run.setSpeed(20.0);
    driver.key(key::kSpace);
    driver.until([&] { return driver.run().advance >= 20; });
    CHECK(driver.context().run.playing());
    driver.key(key::kSpace);
    driver.settle();
    CHECK(driver.run().state == RunState::Paused);
    const auto at = driver.run().advance;
    driver.settle();
    CHECK(driver.run().advance == at);
}

TEST_CASE("Run: stepping by events explains an advance from the base to the update") {
    Meshed driver;
    driver.key(key::kHome);
    driver.settle();
    driver.key(key::kPeriod, {Modifiers::kShift});
    driver.settle();
    CHECK(driver.has("timeline/granularity/Advance")); // the fast method: up to three elements
    driver.click("timeline/granularity/Event");
    std::vector<int> steps;
    int whole = 0;
    for (int i = 0; i < 40; ++i) {
        driver.key(key::kPeriod);
        driver.settle();
        const SessionSnapshot &run = driver.run();
        REQUIRE(run.explanation != nullptr);
        if (run.eventCount > 0 && run.eventCursor < run.explanation->events.size()) {
            steps.push_back(static_cast<int>(run.explanation->events[run.eventCursor].step));
        } else {
            ++whole;
        }
        CHECK_FALSE(caption(*run.explanation, run.eventCursor).empty());
    }
    CHECK(std::count(steps.begin(), steps.end(), static_cast<int>(Step::TakeBase)) >= 1);
    for (const Step step :
         {Step::EvaluateSpacing, Step::IdealPoint, Step::FindCandidates, Step::Score, Step::Sort, Step::Test}) {
        CHECK(std::count(steps.begin(), steps.end(), static_cast<int>(step)) >= 1);
    }
    CHECK(whole >= 1); // the update: the element has been made
    CHECK(driver.run().advance > 100);
}

TEST_CASE("Run: each layer changes the canvas, and hiding it restores the canvas") {
    Meshed driver;
    driver.workspace(WorkspaceKind::Step);
    driver.context().run.seek(driver.run().known / 2);
    driver.settle();
    // Zoom in on the current advance, so that even small marks change enough pixels.
    REQUIRE(driver.run().explanation != nullptr);
    // Most advances need no intersection test; step to one that does, so that the Tests layer draws something.
    for (int i = 0; i < 2000 && driver.run().explanation->tests.empty() && driver.run().advance > 1; ++i) {
        driver.context().run.step(-1);
        driver.settle();
    }
    REQUIRE_FALSE(driver.run().explanation->tests.empty());
    for (LayerSlot &slot : driver.context().layers) {
        slot.visible = true;
    }
    driver.moveTo({5, 5});
    // Zoomed out, the boundary and its names show; zoomed in on the current advance, even small marks do.
    Camera &camera = driver.context().view.camera;
    std::set<std::string> shown;
    for (const double basePixels : {0.0, 110.0}) {
        if (basePixels > 0.0) {
            const AdvanceExplanation &advance = *driver.run().explanation;
            camera.centre = advance.a;
            camera.zoomAt(driver.canvas().centre(), basePixels / (camera.zoom * distance(advance.a, advance.b)));
        }
        driver.context().animate();
        driver.settle();
        const auto all = driver.picture();
        for (LayerSlot &slot : driver.context().layers) {
            CAPTURE(std::string(slot.layer->id()));
            slot.visible = false;
            driver.context().animate();
            driver.settle();
            if (driver.picture().differences(all, driver.canvas()) > 20) {
                shown.insert(slot.layer->id());
            }
            slot.visible = true;
            driver.context().animate();
            driver.settle();
            CHECK(driver.picture().differences(all, driver.canvas()) == 0);
        }
    }
    // The tint covers the fill of the domain. There are no marks, faults, guides, constraints, picture, step of the
    // improvement or colours of nodes here.
    const std::set<std::string> covered{"domain", "marks",       "faults", "picture", "guides",
                                        "sketch", "improvement", "rays",   "links",   "colours"};
    for (const LayerSlot &slot : driver.context().layers) {
        const std::string id = slot.layer->id();
        CAPTURE(id);
        if (covered.count(id) == 0) {
            CHECK(shown.count(id) == 1);
        }
    }
}

TEST_CASE("Run: a bar of the histogram isolates its elements; a second click shows all") {
    Meshed driver;
    driver.showPanel("histogram");
    driver.moveTo({5, 5});
    driver.settle();
    const auto whole = driver.picture();
    const auto &bins = driver.run().quality.alphaHistogram;
    const auto fullest = std::max_element(bins.begin(), bins.end()) - bins.begin();
    const std::string bar = "histogram/" + std::to_string(fullest);
    driver.click(bar);
    REQUIRE(driver.context().view.isolatedBin == static_cast<int>(fullest));
    driver.moveTo({5, 5});
    driver.settle();
    CHECK(driver.picture().differences(whole, driver.canvas()) > 1000);
    driver.click(bar);
    CHECK_FALSE(driver.context().view.isolatedBin.has_value());
    driver.moveTo({5, 5});
    driver.settle();
    CHECK(driver.picture().differences(whole, driver.canvas()) == 0);
}

TEST_CASE("Run: an edit marks the mesh out of date, and undo clears the mark") {
    Meshed driver;
    Document next = *driver.context().document.current();
    next.spacing.size = 9.0;
    driver.context().document.apply(next, "change the size");
    driver.settle();
    CHECK(driver.context().run.outOfDate());
    REQUIRE(driver.has("canvas/remesh"));
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK_FALSE(driver.context().run.outOfDate());
    CHECK_FALSE(driver.has("canvas/remesh"));
    driver.key('Z', {Modifiers::kControl | Modifiers::kShift});
    driver.settle();
    const auto before = driver.run().quality.elements;
    driver.click("canvas/remesh");
    driver.settle();
    CHECK(driver.run().quality.elements > before);
    CHECK_FALSE(driver.context().run.outOfDate());
}

TEST_CASE("Run: live meshing follows every edit") {
    Driver driver;
    load(driver, square(10, 2.0));
    driver.context().settings.live = true;
    Document next = *driver.context().document.current();
    next.spacing.size = 1.0;
    driver.context().document.apply(next, "finer");
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
    CHECK_FALSE(driver.context().run.outOfDate());
    CHECK(driver.run().quality.elements > 150);
}

TEST_CASE("Run: Esc cancels and keeps the partial mesh") {
    Driver driver;
    load(driver, square(1000, 0.7)); // millions of elements, slow enough to be cancelled
    driver.key(key::k2);
    driver.until([&] { return driver.run().known >= 1000; });
    REQUIRE(driver.run().state != RunState::Finished);
    driver.key(key::kEscape);
    driver.settle();
    CHECK(driver.run().state == RunState::Cancelled);
    REQUIRE(driver.run().mesh != nullptr);
    CHECK_FALSE(driver.run().mesh->mesh.elements.empty());
    driver.key(key::kComma);
    driver.settle();
    CHECK(driver.run().advance + 1 == driver.run().known);
}

TEST_CASE("Run: a refused domain is reported with its location, and the log links to it") {
    Driver driver;
    Document document = square(10, 1.0);
    auto bow = std::make_shared<Shape>(*document.shapes[0]);
    bow->nodes = {{0, 0}, {10, 10}, {10, 0}, {0, 10}}; // crosses itself at (5, 5)
    document.shapes[0] = bow;
    load(driver, document);
    CHECK(driver.has("status/checks"));
    driver.key(key::k2);
    driver.settle();
    CHECK(driver.run().state == RunState::Failed);
    driver.showPanel("log");
    driver.frames(3);
    std::string link;
    for (const auto &[name, widget] : driver.context().widgets.all()) {
        link = name.rfind("log/goto/", 0) == 0 && widget.visible ? name : link;
    }
    REQUIRE_FALSE(link.empty());
    driver.click(link);
    CHECK(distance(driver.context().view.camera.centre, {5, 5}) < 1e-6);
    CHECK(driver.context().view.flag.has_value());
}

TEST_CASE("Run: a refused run keeps the previous mesh, out of date, and undo makes it current") {
    Driver driver;
    load(driver, square(8, 0.8));
    driver.key(key::k2);
    driver.settle();
    REQUIRE(driver.run().state == RunState::Finished);
    const std::uint64_t hash = driver.run().meshHash, known = driver.run().known;
    Document tooFine = *driver.context().document.current();
    tooFine.spacing.size = 1e-6;
    driver.context().document.apply(std::move(tooFine), "Change size");
    driver.key(key::k2);
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
    CHECK(driver.run().meshHash == hash);
    CHECK(driver.run().known == known);
    REQUIRE(driver.run().mesh != nullptr);
    CHECK(driver.run().mesh->mesh.elements.size() > 100);
    CHECK(driver.has("canvas/outofdate"));
    CHECK(driver.has("canvas/error"));
    const auto faults = [&] {
        const auto &entries = driver.context().log.entries();
        return std::count_if(entries.begin(), entries.end(),
                             [](const auto &entry) { return entry.diagnostic.severity == Severity::Error; });
    };
    CHECK(faults() == 1);
    // Its timeline is still there, and the refusal is reported once.
    driver.key(key::kHome);
    driver.settle();
    CHECK(driver.run().advance == 0);
    driver.key(key::kEnd);
    driver.settle();
    CHECK(driver.run().meshHash == hash);
    CHECK(faults() == 1);
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK_FALSE(driver.context().run.outOfDate());
    CHECK_FALSE(driver.has("canvas/outofdate"));
    driver.key(key::k2);
    driver.settle();
    CHECK(driver.run().meshHash == hash);
    CHECK(driver.run().diagnostics.empty());
}

TEST_CASE("Canvas: the picture of a drawing does not depend on its offset from the origin") {
    const auto shot = [](Vec2 offset) {
        Driver driver;
        for (const char *hidden : {"labels", "lattice", "marks"}) {
            driver.context().layer(hidden)->visible = false;
        }
        Document document = square(8, 0.5, offset);
        document.spacing.sources.push_back({.a = offset + Vec2{4, 4}, .size = 0.01, .growth = 0.25});
        load(driver, document);
        driver.context().view.camera.centre = offset + Vec2{7.75, 7.75};
        driver.context().view.camera.zoomAt(driver.canvas().centre(), 30.0);
        driver.moveTo({5, 5});
        driver.settle();
        return std::pair{driver.picture(), driver.canvas()};
    };
    // The offsets are sums of powers of two, so that the coordinates are exact.
    const auto [here, canvas] = shot({0, 0});
    const auto [there, other] = shot({131072, 65536});
    CHECK(canvas == other);
    CHECK(there.differences(here, canvas) < 300);
    CHECK(here.differences(Driver().picture(), canvas) > 10000);
}

TEST_CASE("Run: files dropped on the window are opened") {
    Driver driver;
    const auto plate = std::filesystem::path(driver.context().document.path());
    CHECK(plate.empty());
    driver.editor().input().push({.kind = InputKind::Drop, .paths = {"/nowhere/at/all.poly"}});
    driver.settle();
    REQUIRE_FALSE(driver.context().log.entries().empty());
    CHECK(driver.context().log.entries().back().diagnostic.severity == Severity::Error);
    CHECK(driver.has("canvas/error"));
}

TEST_CASE("Run: second order chosen in the panel Meshing gives elements of second order") {
    MeshedSquare driver;
    driver.showPanel("meshing");
    driver.click("meshing/order/2");
    CHECK(driver.document().options.order == ElementOrder::Second);
    driver.click("meshing/elements/Quads");
    driver.click("meshing/quadnodes/9");
    CHECK(driver.document().options.quadNodes == QuadNodes::Nine);
    driver.key(key::kF5);
    driver.settle();
    const SessionSnapshot &run = driver.context().run.now();
    REQUIRE(run.state == RunState::Finished);
    CHECK(run.quality.kinds[static_cast<std::size_t>(CellKind::Quadrilateral9)] == run.quality.elements);
    CHECK(run.order != nullptr);
}

TEST_CASE("Run: a least angle is typed in the panel Meshing, and the log names what forces smaller ones") {
    MeshedSquare driver;
    driver.showPanel("meshing");
    driver.fill("meshing/leastangle", "40");
    CHECK_FALSE(driver.document().options.leastAngle);
    driver.key(key::kEscape);
    driver.fill("meshing/leastangle", "30");
    CHECK(driver.document().options.leastAngle == 30.0);
    driver.key(key::kF5);
    driver.settle();
    const SessionSnapshot &run = driver.context().run.now();
    REQUIRE(run.state == RunState::Finished);
    REQUIRE(run.leastAngle);
    CHECK(run.leastAngle->reached >= 30.0);
    CHECK(run.leastAngle->forced.empty());
    driver.click("meshing/elements/Quads");
    CHECK_FALSE(driver.has("meshing/leastangle"));
}

} // namespace forefront::test
