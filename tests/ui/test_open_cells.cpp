#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/files/files.hpp"
#include "tests/ui/meshed_square.hpp"
#include "tests/unit/block_samples.hpp"
#include "ui/dialogs/open_mesh.hpp"
#include "ui/layers/layers.hpp"
#include "ui/workspace/judging.hpp"
#include "ui/workspace/mesh/element_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace forefront::test {

namespace {

/// Returns a mesh with its nodes moved so that it fills the middle of an empty canvas.
Mesh enlarged(Mesh mesh) {
    for (Vec2 &node : mesh.nodes) {
        node = 8.0 * node + Vec2{1.0, 1.0};
    }
    return mesh;
}

/// An editor that has opened a mesh.
class CellViewer : public Draughtsman {
  public:
    explicit CellViewer(const Mesh &mesh) {
        const TemporaryFolder folder;
        REQUIRE_FALSE(hasErrors(writeMesh(folder / "cells.msh", mesh)));
        openMesh(context(), folder / "cells.msh");
        settle();
        for (const char *layer : {"size", "lattice", "labels"}) {
            showLayer(context().layers, layer, false);
        }
        settle();
    }
    MeshView mesh() { return run().mesh->view(); }
    std::string row(const MeshPick &pick, const std::string &name) {
        for (const auto &[key, value] : describePart(context(), pick)) {
            if (key == name) {
                return value;
            }
        }
        return "no such row";
    }
};

} // namespace

TEST_CASE("Cells: meshes of quadrilaterals and of second order open with their figures, from every format") {
    TemporaryFolder folder;
    int opened = 0;
    for (const Mesh &made : {samples::mixedSample(), samples::bent(samples::secondOrderSample(), 0.1),
                             samples::sampleMesh(CellKind::Quadrilateral4), samples::sampleMesh(CellKind::Triangle6)}) {
        for (const FileFormat &format : allFormats().list()) {
            if (!format.readsMesh || !format.writesMesh || !checkElements(format, made).empty()) {
                continue;
            }
            CAPTURE(format.id);
            const auto file = folder / (std::string(format.id) + format.extension);
            REQUIRE_FALSE(hasErrors(writeMesh(file, made, format.id)));
            Draughtsman driver;
            openMesh(driver.context(), file);
            driver.settle();
            REQUIRE(driver.context().run.showsFile());
            const Mesh read = allFormats().readMesh(file).value();
            CHECK(driver.run().quality.elements == made.elementCount());
            CHECK(driver.run().quality.alphaMin == measureQuality(read, nullptr).alphaMin);
            CHECK(driver.run().meshHash == meshHash(read));
            const auto &log = driver.context().log.entries();
            CHECK(std::any_of(log.begin(), log.end(), [](const auto &entry) {
                return entry.diagnostic.message.find("quadrilaterals") != std::string::npos ||
                       entry.diagnostic.message.find("triangles of 6 nodes") != std::string::npos;
            }));
            ++opened;
        }
    }
    CHECK(opened >= 12);
}

TEST_CASE("Cells: the status bar counts triangles with their sign, and other elements in words") {
    const auto shortOf = [](const Mesh &mesh) { return elementsInShort(measureQuality(mesh, nullptr)); };
    const Mesh triangles = samples::sampleMesh(CellKind::Triangle6);
    const Mesh quadrilaterals = samples::sampleMesh(CellKind::Quadrilateral8), mixed = samples::mixedSample();
    const auto number = [](const Mesh &mesh) { return std::to_string(mesh.elementCount()); };
    CHECK(shortOf(triangles) == number(triangles) + " \xe2\x96\xb3");
    CHECK(shortOf(quadrilaterals) == number(quadrilaterals) + " elements");
    CHECK(shortOf(mixed) == number(mixed) + " elements");
    MeshQuality growing; // of a mesh that is being made, whose kinds are not counted
    growing.elements = 234;
    CHECK(elementsInShort(growing) == "234 \xe2\x96\xb3");
    CHECK(elementsInWords(measureQuality(mixed, nullptr).kinds) == elementsInWords(mixed));
    // A cell of words is wider than one of signs for as many elements.
    const auto width = [](CellKind kind) {
        CellViewer driver(samples::gridOfCells(30, 30, [=](std::size_t, std::size_t) { return kind; }));
        REQUIRE(driver.has("status/counts"));
        return driver.context().widgets.find("status/counts")->rect.width;
    };
    CHECK(width(CellKind::Quadrilateral8) > width(CellKind::Triangle6));
}

TEST_CASE("Cells: the edges of elements are drawn, the lines that split them for drawing are not") {
    for (const CellKind kind : {CellKind::Quadrilateral4, CellKind::Quadrilateral8, CellKind::Quadrilateral9}) {
        CAPTURE(static_cast<int>(kind));
        CellViewer driver(enlarged(samples::gridOfCells(2, 1, [&](std::size_t, std::size_t) { return kind; })));
        driver.moveTo({9.9, 0.0});
        driver.settle();
        const Driver::Picture picture = driver.picture();
        const auto at = [&](double x, double y) { return colourAt(picture, driver.pixel({x, y})); };
        const Colour face = at(2.1, 3.3);
        CHECK(difference(at(5.0, 3.0), face) > 20); // between the elements
        int lines = 0;
        for (int k = 15; k <= 185; ++k) { // along a line across the left element, through all that could split it
            lines += difference(at(1.0 + 4.0 * k / 200.0, 1.9 + 0.005 * k), face) > 8 ? 1 : 0;
        }
        CHECK(lines == 0);
    }
}

TEST_CASE("Cells: the probe finds and describes whole elements, their middle nodes and their edges") {
    CellViewer driver(enlarged(samples::gridOfCells(
        2, 1, [](std::size_t i, std::size_t) { return i == 0 ? CellKind::Quadrilateral8 : CellKind::Triangle6; })));
    driver.context().probe.active = true;
    driver.context().animate();
    driver.settle();
    const auto pick = [&](Vec2 place) { return partAt(*driver.context().judgement, place, 0.5).value_or(MeshPick{}); };
    const auto isElement = [&](const MeshPick &found, CellKind kind) {
        return found.part == MeshPart::Elements && driver.mesh().kindOf(found.index) == kind;
    };
    const MeshPick left = pick({2.6, 4.3}), sameLeft = pick({3.4, 5.9}), right = pick({6.4, 3.0});
    REQUIRE(isElement(left, CellKind::Quadrilateral8));
    CHECK(sameLeft == left);
    REQUIRE(isElement(right, CellKind::Triangle6));
    CHECK(driver.row(left, "Kind") == "quadrilateral of 8 nodes");
    CHECK(driver.row(left, "Scaled Jacobian") == "1.0000");
    CHECK(driver.row(left, "Area") == "32");
    CHECK(driver.row(right, "Area") == "16");
    const MeshPick middle = pick({3.02, 1.02});
    CHECK(middle.part == MeshPart::Nodes);
    CHECK(driver.row(middle, "Position") == "3, 1");
    const MeshPick edge = pick({5.0, 3.4});
    REQUIRE(edge.part == MeshPart::Edges);
    CHECK(driver.row(edge, "Length") == "8");
}

TEST_CASE("Cells: values colour all triangles of an element alike") {
    CellViewer driver(enlarged(samples::gridOfCells(
        2, 1, [](std::size_t, std::size_t) { return CellKind::Quadrilateral9; }, 0.0)));
    showLayer(driver.context().layers, "quality", true);
    showLayer(driver.context().layers, "mesh", false);
    chooseMeasure(driver.context(), Measure::Region);
    driver.moveTo({9.9, 0.0});
    driver.settle();
    const Driver::Picture picture = driver.picture();
    const auto at = [&](double x, double y) { return colourAt(picture, driver.pixel({x, y})); };
    for (const Vec2 place : {Vec2{1.7, 2.1}, Vec2{4.1, 2.3}, Vec2{2.2, 7.3}, Vec2{4.3, 8.1}}) {
        CHECK(difference(at(place.x, place.y), at(2.6, 4.2)) <= 1);
        CHECK(difference(at(place.x + 4.0, place.y), at(2.6, 4.2)) > 20);
    }
}

TEST_CASE("Cells: a format that cannot hold the mesh says so, and nothing is exported") {
    CellViewer driver(enlarged(samples::secondOrderSample()));
    driver.context().settings.exportFormat = "su2";
    driver.context().actions.run("file.export", driver.context());
    driver.settle();
    CHECK(driver.has("dialog/export/not-held"));
    driver.context().settings.exportFormat = "vtu";
    driver.key(key::kEscape);
    driver.settle();
    driver.context().actions.run("file.export", driver.context());
    driver.settle();
    CHECK_FALSE(driver.has("dialog/export/not-held"));
}

} // namespace forefront::test
