#include "core/files/files.hpp"
#include "tests/ui/meshed_square.hpp"
#include "ui/dialogs/open_mesh.hpp"
#include "ui/workspace/judging.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace forefront::test {

namespace {

/// A meshed square with runs to compare beside it.
class Comparing : public MeshedSquare {
  public:
    Comparing() {
        script("click menu/Learn\nclick menu/learn.sides\nsettle");
        settle();
    }
    SideBySide &sides() { return context().sides; }
};

} // namespace

TEST_CASE("Side by side: runs with the other grids are at the advance of the canvas, with the same mesh") {
    Comparing driver;
    REQUIRE(driver.sides().size() == 2);
    CHECK(driver.sides().variant(0).grid == GridKind::None);
    CHECK(driver.sides().variant(1).grid == GridKind::Uniform);
    CHECK(driver.has("sides/0"));
    CHECK(driver.has("sides/1"));
    driver.key(key::kHome);
    driver.settle();
    for (int k = 0; k < 5; ++k) {
        driver.key(key::kPeriod);
        driver.settle();
        for (std::size_t run = 0; run < 2; ++run) {
            CHECK(driver.sides().now(run).advance == driver.run().advance);
            CHECK(driver.sides().now(run).stateHash == driver.run().stateHash);
        }
    }
    driver.key(key::kEnd);
    driver.settle();
    for (std::size_t run = 0; run < 2; ++run) {
        CHECK(driver.sides().now(run).meshHash == driver.run().meshHash);
        for (const char *figure : {"advances", "elements", "front", "neighbours", "tests", "cells"}) {
            CHECK(driver.has(std::string("sides/") + figure + '/' + std::to_string(run + 1)));
        }
    }
}

TEST_CASE("Side by side: the other method runs beside the one shown") {
    Comparing driver;
    driver.click("sides/comparison/Methods");
    driver.settle();
    REQUIRE(driver.sides().size() == 1);
    CHECK(driver.sides().variant(0).method == Method::Classic);
    CHECK(driver.sides().now(0).complete);
    CHECK_FALSE(driver.has("sides/1"));
}

TEST_CASE("Side by side: dragging and scrolling over a view moves the camera of all views") {
    Comparing driver;
    const WidgetRegistry::Widget *const view = driver.context().widgets.find("sides/0");
    REQUIRE(view != nullptr);
    const Pixel middle = view->rect.centre();
    const Camera before = driver.context().view.camera;
    driver.drag(middle, middle + Pixel(40.0, 25.0));
    CHECK(distance(driver.context().view.camera.centre, before.centre) > 0.1 * 40.0 / before.zoom);
    driver.scroll(middle, 2.0);
    CHECK(driver.context().view.camera.zoom > before.zoom);
}

TEST_CASE("Side by side: a new mesh restarts the comparison, and closing restores the canvas width") {
    Comparing driver;
    const double narrow = driver.canvas().width;
    const std::uint64_t first = driver.sides().now(0).meshHash;
    Document finer = driver.document();
    finer.spacing.size = 0.7;
    driver.context().document.apply(std::move(finer), "Size");
    driver.key(key::kF5);
    driver.settle();
    CHECK(driver.sides().now(0).meshHash == driver.run().meshHash);
    CHECK(driver.sides().now(0).meshHash != first);
    driver.click("sides/close");
    driver.settle();
    CHECK(driver.sides().size() == 0);
    CHECK(driver.canvas().width > 2.5 * narrow);
}

TEST_CASE("Side by side: another mesh of the domain is shown beside ours, with the figures of both") {
    MeshedSquare driver;
    const TriMesh ours = driver.mesh();
    const TemporaryFolder folder;
    TriMesh other;
    other.nodes = {{1, 1}, {9, 1}, {9, 8}, {1, 8}, {5, 4}};
    for (std::uint32_t k = 0; k < 4; ++k) {
        other.elements.push_back({NodeId{k}, NodeId{(k + 1) % 4}, NodeId{4}});
    }
    REQUIRE_FALSE(hasErrors(writeMesh(folder / "other.vtu", other)));
    driver.script("click menu/File\nclick menu/file.compareMesh\nsettle");
    driver.click("dialog/comparemesh/name");
    driver.key('A', {Modifiers::kControl});
    driver.type((folder / "other.vtu").string());
    driver.click("dialog/comparemesh/ok");
    driver.settle();
    const SideBySide &sides = driver.context().sides;
    REQUIRE(sides.mesh() != nullptr);
    CHECK(driver.has("sides/0"));
    for (const char *figure : {"nodes", "elements", "alphaMean", "alphaMin", "minAngle", "maxAngle", "delta", "time"}) {
        CHECK(driver.has(std::string("sides/") + figure + "/0"));
        CHECK(driver.has(std::string("sides/") + figure + "/1"));
    }
    // Everything is in view: the choices in one row, and both rows of the table.
    const auto rectOf = [&driver](const char *name) { return driver.context().widgets.find(name)->rect; };
    CHECK(std::abs(rectOf("sides/other").centre().y - rectOf("sides/arrangement/Overlaid").centre().y) < 3.0);
    CHECK(rectOf("sides/other").x >=
          rectOf("sides/arrangement/Overlaid").x + rectOf("sides/arrangement/Overlaid").width);
    const WidgetRegistry::Widget *const last = driver.context().widgets.find("sides/nodes/1");
    CHECK(last->visible);
    if (last->clip) {
        CHECK(last->rect.y + last->rect.height <= last->clip->y + last->clip->height);
    }
    const auto figures = figuresOf(*sides.mesh()->judgement());
    REQUIRE(figures);
    const MeshQuality expected = measureQuality(other, driver.run().spacing.get());
    CHECK(figures->quality.elements == 4);
    CHECK(figures->quality.alphaMin == expected.alphaMin);
    CHECK(figures->quality.maxAngle == expected.maxAngle);
    CHECK(figures->quality.deltaMean == expected.deltaMean);
    CHECK(expected.deltaMean > 0.0);
    CHECK_FALSE(figures->seconds);
    REQUIRE(driver.context().judgement->quality);
    CHECK(driver.context().judgement->quality->alphaMean == driver.run().quality.alphaMean);
    CHECK(driver.mesh().elements == ours.elements); // the canvas keeps its mesh

    // A coarser mesh of our own is evaluated again with its own spacing.
    Document coarser = driver.document();
    coarser.spacing.size = 1.6;
    driver.context().document.apply(std::move(coarser), "Size");
    driver.key(key::kF5);
    driver.settle();
    CHECK(figuresOf(*sides.mesh()->judgement())->quality.deltaMean ==
          measureQuality(other, driver.run().spacing.get()).deltaMean);

    driver.click("sides/close");
    driver.settle();
    CHECK(sides.mesh() == nullptr);
    CHECK(sides.size() == 0);
}

TEST_CASE("Side by side: the compared mesh shows its own values of the field on the canvas, or no colours") {
    MeshedSquare maker;
    MeshFields made{maker.mesh(), {}, {}};
    for (const Vec2 place : made.mesh.nodes) {
        made.fields["heat"].push_back(place.x);
    }
    for (std::size_t e = 0; e < made.mesh.elementCount(); ++e) {
        made.elementFields["flux"].push_back(static_cast<double>(e));
    }
    MeshFields other = made;
    for (double &value : other.fields["heat"]) {
        value *= 0.5;
    }
    other.elementFields.clear();
    Draughtsman driver;
    driver.context().run.showFile(made);
    driver.context().sides.compareWith("other.vtu", comparedFile(other));
    showLayer(driver.context().layers, "quality", true);
    chooseField(driver.context(), MeshPart::Nodes, "heat");
    driver.settle();
    const Judgement &heat = *driver.context().sides.mesh()->judgement();
    CHECK(heat.values == other.fields["heat"]);
    CHECK(heat.of.measure == driver.context().judgement->of.measure);
    const auto coloured = [&] { // by pixels of the view that have the colour of an element without a value
        const Driver::Picture picture = driver.picture();
        const PixelRect rect = driver.context().widgets.find("sides/0")->rect;
        std::size_t plain = 0, seen = 0;
        for (double x = rect.x + 30.0; x < rect.x + rect.width - 30.0; x += 7.0) {
            for (double y = rect.y + 40.0; y < rect.y + rect.height - 10.0; y += 7.0) {
                const Colour found = colourAt(picture, {x, y});
                plain += difference(found, driver.context().theme.element) <= 3 ? 1U : 0U;
                seen += difference(found, driver.context().theme.canvas) > 3 ? 1U : 0U;
            }
        }
        CHECK(seen > 100);
        return plain < seen / 10;
    };
    CHECK(coloured());
    chooseField(driver.context(), MeshPart::Elements, "flux"); // only on the canvas
    driver.settle();
    CHECK(driver.context().judgement->of.field == "flux");
    CHECK_FALSE(coloured());
    chooseMeasure(driver.context(), Measure::MinAngle);
    driver.settle();
    CHECK(coloured());
}

TEST_CASE("Side by side: the other mesh is laid over that of the canvas, in its own colour and with the table") {
    MeshedSquare driver;
    driver.hideLayers({"lattice", "front"});
    MeshFields other;
    other.mesh.nodes = {{1, 1}, {9, 1}, {9, 8}, {1, 8}, {5.2, 4.1}};
    for (std::uint32_t k = 0; k < 4; ++k) {
        other.mesh.block(CellKind::Triangle3).add(std::array{NodeId{k}, NodeId{(k + 1) % 4}, NodeId{4}});
    }
    driver.context().sides.compareWith("other.msh", comparedFile(other));
    driver.settle();
    const double narrow = driver.canvas().width;
    /// Counts the places along the inner edges of the other mesh where its colour is seen.
    const auto seen = [&] {
        const Driver::Picture picture = driver.picture();
        std::size_t count = 0;
        for (std::size_t corner = 0; corner < 4; ++corner) {
            for (double t = 0.2; t < 0.9; t += 0.1) {
                const Vec2 &from = other.mesh.nodes[corner], &to = other.mesh.nodes[4];
                const Pixel at = driver.pixel(from + t * (to - from));
                bool found = false;
                for (const Pixel near : {at, at + Pixel(1, 0), at + Pixel(0, 1), at - Pixel(1, 0), at - Pixel(0, 1)}) {
                    found = found || difference(colourAt(picture, near), driver.context().theme.compared) < 70;
                }
                count += found ? 1U : 0U;
            }
        }
        return count;
    };
    CHECK(seen() < 4);
    driver.click("sides/arrangement/Overlaid");
    driver.settle();
    CHECK(driver.canvas().width > 1.9 * narrow);
    CHECK_FALSE(driver.has("sides/0"));
    CHECK(driver.has("sides/key"));
    CHECK(driver.has("sides/elements/1"));
    CHECK(seen() > 24);
    driver.context().view.camera.zoom *= 1.2; // it moves with the canvas
    driver.settle();
    CHECK(seen() > 20);
    driver.click("sides/arrangement/Side by side");
    driver.settle();
    CHECK(driver.has("sides/0"));
    CHECK(seen() < 4);
    driver.click("sides/arrangement/Overlaid");
    driver.settle();
    driver.click("sides/close");
    driver.settle();
    CHECK(seen() < 4);
}

TEST_CASE("Side by side: the compared mesh has the colours of the canvas and moves with its camera") {
    MeshedSquare driver;
    const TemporaryFolder folder;
    REQUIRE_FALSE(hasErrors(writeMesh(folder / "same.msh", driver.mesh())));
    compareMesh(driver.context(), folder / "same.msh");
    showLayer(driver.context().layers, "quality", true);
    driver.hideLayers({"mesh", "lattice"});
    driver.settle();
    const WidgetRegistry::Widget *const view = driver.context().widgets.find("sides/0");
    REQUIRE(view != nullptr);
    const Pixel middle = view->rect.centre(); // drawing a picture invalidates the pointer
    const auto offset = middle - driver.canvas().centre();
    const auto coloursMatch = [&] {
        const auto picture = driver.picture();
        std::size_t same = 0, seen = 0;
        for (std::size_t e = 0; e < driver.mesh().elements.size(); ++e) {
            const Pixel p = driver.pixel(driver.middleOf(e));
            if (driver.canvas().centre().x - 90 < p.x && p.x < driver.canvas().centre().x + 90 &&
                driver.canvas().centre().y - 90 < p.y && p.y < driver.canvas().centre().y + 90) {
                ++seen;
                same += difference(colourAt(picture, p), colourAt(picture, p + offset)) <= 3 ? 1U : 0U;
            }
        }
        CHECK(seen >= 10);
        CHECK(same >= seen - seen / 10);
    };
    coloursMatch();
    driver.scroll(middle, 2.0);
    driver.settle();
    coloursMatch();
    compareMesh(driver.context(), folder / "missing.msh");
    driver.settle();
    CHECK(driver.logHas("cannot-read"));
    CHECK(driver.context().sides.mesh()->name() == "same.msh");
}

} // namespace forefront::test
