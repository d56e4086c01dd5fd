#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/files/files.hpp"
#include "tests/ui/meshed_square.hpp"
#include "ui/dialogs/open_mesh.hpp"
#include "ui/dialogs/thumbnails.hpp"
#include "ui/style/measure_colours.hpp"
#include "ui/workspace/judging.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <set>
#include <thread>

namespace forefront::test {

namespace {

constexpr double kTiny = 1e-12;

/// A meshed square and the evaluation of its mesh.
struct JudgedSquare : MeshedSquare {
    const Judgement &judgement() { return *context().judgement; }
    /// Returns an edge with two elements whose ends are inside.
    std::uint32_t innerEdge() {
        std::set<NodeId> outer;
        for (const MeshEdge &edge : judgement().edges->edges) {
            if (edge.elements[1] == kNoElement) {
                outer.insert({edge.a, edge.b});
            }
        }
        const auto &edges = judgement().edges->edges;
        const auto found = std::find_if(edges.begin(), edges.end(), [&](const MeshEdge &edge) {
            return outer.count(edge.a) == 0 && outer.count(edge.b) == 0;
        });
        return static_cast<std::uint32_t>(found - edges.begin());
    }
};

/// Shows a mesh with values as an opened one, with its elements in colour and the histogram open.
void showValues(Draughtsman &driver, const MeshFields &made) {
    driver.context().run.showFile(made);
    driver.context().view.fit(made.mesh.bounds());
    showLayer(driver.context().layers, "quality", true);
    showLayer(driver.context().layers, "mesh", false);
    driver.settle();
    driver.showPanel("histogram");
}

} // namespace

TEST_CASE("Judge: a mesh of every format opens with the figures that the check command prints") {
    JudgedSquare maker;
    const TriMesh made = maker.mesh();
    TemporaryFolder folder;
    for (const FileFormat &format : allFormats().list()) {
        if (!format.readsMesh || !format.writesMesh) {
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
        const MeshQuality quality = measureQuality(read, nullptr);
        CHECK(driver.run().quality.elements == made.elements.size());
        CHECK(driver.run().quality.alphaMin == quality.alphaMin);
        CHECK(driver.run().quality.minAngle == quality.minAngle);
        CHECK(driver.run().meshHash == meshHash(read));
        const MeshEdges edges = edgesOf(read);
        for (const Measure measure :
             {Measure::ShapeFactor, Measure::MinAngle, Measure::AreaRatio, Measure::Length, Measure::Valence}) {
            chooseMeasure(driver.context(), measure);
            driver.settle();
            const MeasureSummary expected = summarise(measureValues(measure, read, edges, nullptr));
            CHECK(driver.context().judgement->summary.minimum == expected.minimum);
            CHECK(driver.context().judgement->summary.mean == expected.mean);
            CHECK(driver.context().judgement->summary.percentiles == expected.percentiles);
        }
        driver.showPanel("checks");
        driver.settle();
        CHECK(driver.has("checks/mesh/valid"));
        CHECK_FALSE(driver.document().shapes.empty()); // its outline
        CHECK_FALSE(driver.context().document.dirty());
    }
}

TEST_CASE("Judge: an invalid mesh is shown with its faults, and a file that holds none is refused") {
    JudgedSquare maker;
    TriMesh turned = maker.mesh();
    std::swap(turned.elements[7][0], turned.elements[7][1]);
    TemporaryFolder folder;
    REQUIRE_FALSE(hasErrors(writeMesh(folder / "turned.msh", turned)));
    Draughtsman driver;
    openMesh(driver.context(), folder / "turned.msh");
    driver.settle();
    CHECK(hasErrors(driver.context().judgement->faults));
    driver.showPanel("checks");
    driver.settle();
    CHECK(driver.has("checks/mesh/faulty"));
    CHECK(driver.has("checks/mesh/goto/0"));
    openMesh(driver.context(), folder / "missing.msh");
    driver.settle();
    CHECK(driver.logHas("cannot-read"));
    CHECK(driver.context().document.title() == "turned.msh");
}

TEST_CASE("Judge: too little memory to evaluate a mesh gives a fault") {
    BackgroundList background([] {});
    MeshJudge judge(background, [](const JudgeRequest &, const Judgement &) -> std::shared_ptr<const Judgement> {
        throw std::bad_alloc();
    });
    JudgeRequest request;
    request.mesh = std::make_shared<const MeshSnapshot>();
    judge.submit(request);
    while (judge.busy()) {
        std::this_thread::yield();
    }
    CHECK(judge.refresh());
    const auto answer = judge.now();
    REQUIRE(answer->faults.size() == 1);
    CHECK(answer->faults.front().code == "out-of-memory");
    CHECK(answer->of == request);
}

TEST_CASE("Thumbnails: too little memory for a project leaves it without a picture") {
    BackgroundList background([] {});
    Thumbnails thumbnails(background, {"a", "b"}, [](const std::filesystem::path &project, const std::stop_token &) {
        if (project == "a") {
            throw std::bad_alloc();
        }
        return std::make_shared<const Thumbnail>(Thumbnail{.nodes = {{1.0, 2.0}}});
    });
    while (!thumbnails.done()) {
        thumbnails.refresh();
        std::this_thread::yield();
    }
    CHECK(thumbnails.at(0)->nodes.empty());
    CHECK(thumbnails.at(1)->nodes.size() == 1);
}

TEST_CASE("Judge: elements, edges and nodes have the colours of their values") {
    JudgedSquare driver;
    driver.hideLayers({"front", "candidates", "tests", "labels", "grid", "boundary"});
    showLayer(driver.context().layers, "quality", true);
    for (const Measure measure : valuesOf<Measure>()) {
        CAPTURE(wordOf(measure));
        chooseMeasure(driver.context(), measure);
        driver.moveTo({5, 5});
        driver.context().animate();
        driver.settle();
        const Judgement &judgement = driver.judgement();
        REQUIRE(judgement.of.measure == measure);
        if (measure == Measure::Across || measure == Measure::IslandArea) {
            CHECK(judgement.summary.count ==
                  0); // no parts of the square's boundary face each other, and it has no hole
            continue;
        }
        REQUIRE(judgement.summary.count > 0);
        CHECK(driver.has("canvas/legend/quality"));
        const Driver::Picture picture = driver.picture();
        const PixelRect free = driver.canvas();
        std::size_t wrong = 0, looked = 0;
        for (std::size_t e = 0; e < driver.mesh().elements.size(); ++e) {
            const Vec2 middle = driver.middleOf(e);
            for (std::size_t k = 0; k < 3; ++k) {
                // A place in the third of the element that belongs to its edge or node.
                const Vec2 corner = driver.nodeAt(e, k), next = driver.nodeAt(e, (k + 1) % 3);
                const MeshPart part = infoOf(measure).part;
                const Vec2 place = part == MeshPart::Nodes   ? lerp(middle, corner, 0.5)
                                   : part == MeshPart::Edges ? lerp(middle, midpoint(corner, next), 0.5)
                                                             : middle;
                const std::size_t number = part == MeshPart::Nodes   ? index(driver.mesh().elements[e][k])
                                           : part == MeshPart::Edges ? judgement.edges->of(e, k)
                                                                     : e;
                const double value = judgement.values[number];
                const Pixel pixel = driver.pixel(place);
                const bool hatched = measure == Measure::ShapeFactor && value < 0.5;
                if (hatched || pixel.y > free.y + free.height - 100.0 || pixel.y < free.y + 60.0) {
                    continue; // below the legend and the notes
                }
                const double t = mapPosition(measure, measureRange(driver.context()), value);
                ++looked;
                wrong += difference(colourAt(picture, pixel), measureMap(driver.context())(std::clamp(t, 0.0, 1.0))) > 6
                             ? 1
                             : 0;
            }
        }
        CHECK(looked > 200);
        CHECK(wrong == 0);
    }
}

TEST_CASE("Judge: nodal values of a file are shown smoothly, with contour lines") {
    JudgedSquare maker;
    MeshFields made{maker.mesh(), {}, {}};
    for (const Vec2 place : made.mesh.nodes) {
        made.fields["heat"].push_back(place.x);
    }
    Draughtsman driver;
    showValues(driver, made);
    chooseField(driver.context(), MeshPart::Nodes, "heat");
    driver.moveTo({5, 5});
    driver.settle();
    const Judgement &judgement = *driver.context().judgement;
    REQUIRE(judgement.of.fieldValues);
    CHECK(judgement.summary.minimum == 1.0);
    CHECK(judgement.summary.maximum == 9.0);
    CHECK(driver.has("canvas/legend/quality"));
    const Driver::Picture picture = driver.picture();
    for (int k = 0; k < 10; ++k) {
        CAPTURE(k);
        const double t = 0.1 * k + 0.05; // between two contour lines
        CHECK(difference(colourAt(picture, driver.pixel({1.0 + 8.0 * t, 5.3})), viridis(t)) <= 8);
        const Colour line = colourAt(picture, driver.pixel({1.0 + 8.0 * (0.1 * k + (k == 0 ? 0.1 : 0.0)), 5.3}));
        CHECK(line.r + line.g + line.b < 330); // dark on any colour of the map
    }
    chooseMeasure(driver.context(), Measure::MinAngle);
    driver.settle();
    CHECK_FALSE(driver.context().judgement->of.fieldValues);
}

TEST_CASE("Judge: values of elements in a file colour their elements, with histogram and probe") {
    JudgedSquare maker;
    MeshFields made{maker.mesh(), {}, {}};
    for (std::size_t e = 0; e < made.mesh.elementCount(); ++e) {
        made.elementFields["flux"].push_back(static_cast<double>(e % 10));
    }
    made.fields["flux"].assign(made.mesh.nodes.size(), 1.0);
    Draughtsman driver;
    showValues(driver, made);
    driver.click("histogram/measure");
    driver.settle();
    CHECK(driver.has("histogram/measure/flux"));
    CHECK(driver.has("histogram/measure/flux (elements)"));
    driver.key(key::kEscape);
    driver.settle();
    chooseField(driver.context(), MeshPart::Elements, "flux");
    driver.moveTo({5, 5});
    driver.settle();
    const Judgement &judgement = *driver.context().judgement;
    REQUIRE(judgement.of.fieldValues);
    CHECK(judgement.info.part == MeshPart::Elements);
    CHECK(judgement.summary.count == made.mesh.elementCount());
    CHECK(judgement.summary.maximum == 9.0);
    CHECK(driver.has("canvas/legend/quality"));
    const Driver::Picture picture = driver.picture();
    for (std::size_t e = 0; e < 20; ++e) {
        CAPTURE(e);
        const Element &n = made.mesh.triangles()[e];
        const Vec2 middle =
            (1.0 / 3.0) * (made.mesh.nodes[index(n[0])] + made.mesh.nodes[index(n[1])] + made.mesh.nodes[index(n[2])]);
        const Colour expected = viridis(static_cast<double>(e % 10) / 9.0);
        CHECK(difference(colourAt(picture, driver.pixel(middle)), expected) <= 3);
    }
    goToPart(driver.context(), {MeshPart::Elements, 7});
    driver.settle();
    const auto rows = describePart(driver.context(), {MeshPart::Elements, 7});
    CHECK(std::find(rows.begin(), rows.end(), std::pair<std::string, std::string>("flux", "7")) != rows.end());
}

TEST_CASE("Judge: the histogram shows the chosen measure, and a bar isolates its parts") {
    JudgedSquare driver;
    driver.showPanel("histogram");
    for (const Measure measure : {Measure::MinAngle, Measure::Length, Measure::Valence}) {
        CAPTURE(wordOf(measure));
        chooseMeasure(driver.context(), measure);
        driver.moveTo({5, 5});
        driver.settle();
        const auto whole = driver.picture();
        const auto &bins = driver.judgement().histogram.bins;
        const auto fullest = std::max_element(bins.begin(), bins.end()) - bins.begin();
        CHECK(driver.click("histogram/" + std::to_string(fullest)));
        REQUIRE(driver.context().view.isolatedBin == static_cast<int>(fullest));
        CHECK(driver.has("histogram/all"));
        driver.moveTo({5, 5});
        driver.settle();
        CHECK(driver.picture().differences(whole, driver.canvas()) > 1000);
        driver.click("histogram/all");
        driver.moveTo({5, 5});
        driver.settle();
        CHECK(driver.picture().differences(whole, driver.canvas()) == 0);
    }
}

TEST_CASE("Judge: limits can be edited in the checks panel, checked, undone and saved") {
    JudgedSquare driver;
    driver.workspace(WorkspaceKind::Judge);
    const auto set = [&](const char *field, const char *value) {
        driver.click(field);
        driver.key('A', {Modifiers::kControl});
        driver.type(value);
        driver.key(key::kTab);
        driver.settle();
    };
    set("checks/min-angle", "59.5");
    CHECK(driver.document().limits[MeshLimit::MinAngle] == 59.5);
    CHECK(driver.has("checks/min-angle/broken"));
    set("checks/max-growth", "50");
    CHECK(driver.has("checks/max-growth/kept"));
    set("checks/max-angle", "20"); // not a maximum that any mesh can keep
    CHECK(driver.logHas("bad-limit"));
    CHECK_FALSE(driver.document().limits[MeshLimit::MaxAngle]);

    REQUIRE(driver.judgement().verdicts.size() == 2);
    const LimitVerdict verdict = driver.judgement().verdicts[0];
    REQUIRE(verdict.places.size() > 2);
    for (std::size_t k = 0; k < 2; ++k) { // from one place to the next
        CHECK(driver.click("checks/min-angle/next"));
        driver.settle();
        CHECK(driver.context().probe.chosen == MeshPick{MeshPart::Elements, verdict.places[k].part});
        CHECK(distance(driver.context().view.camera.centre, verdict.places[k].at) < 1e-9);
    }
    const Document saved = parseProject(projectText(driver.document()), "saved").value();
    CHECK(saved.limits == driver.document().limits);
    driver.key('Z', {Modifiers::kControl});
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK_FALSE(driver.document().limits.any());
    CHECK_FALSE(driver.has("checks/min-angle/broken"));
}

TEST_CASE("Judge: setting a limit neither makes the mesh out of date nor meshes again") {
    JudgedSquare driver;
    const std::uint64_t made = driver.run().run;
    for (const bool live : {false, true}) {
        CAPTURE(live);
        driver.context().run.live = live;
        Document next = driver.document();
        next.limits[MeshLimit::MinAngle] = live ? 20.0 : 30.0;
        driver.context().document.apply(next, "Limit");
        driver.settle();
        CHECK(driver.run().run == made);
        CHECK_FALSE(driver.context().run.outOfDate());
        REQUIRE(driver.judgement().verdicts.size() == 1);
    }
    driver.context().run.live = false;
    Document finer = driver.document();
    finer.spacing.size = 0.5;
    driver.context().document.apply(finer, "Size");
    driver.settle();
    CHECK(driver.context().run.outOfDate());
    driver.key('Z', {Modifiers::kControl});
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK_FALSE(driver.context().run.outOfDate());
}

TEST_CASE("Probe: hovering and clicking read values from elements, edges and nodes") {
    JudgedSquare driver;
    driver.showPanel("probe");
    driver.key('I');
    driver.settle();
    const std::size_t e = driver.mesh().elements.size() / 2;
    driver.moveToPlace(driver.middleOf(e));
    driver.settle();
    CHECK(driver.context().probe.hovered == MeshPick{MeshPart::Elements, static_cast<std::uint32_t>(e)});
    CHECK(driver.has("probe/Element"));
    driver.key(key::kF5); // another mesh comes under the pointer, which rests
    driver.settle();
    CHECK(driver.context().probe.hovered == MeshPick{MeshPart::Elements, static_cast<std::uint32_t>(e)});
    driver.clickPlace(driver.middleOf(e));
    driver.moveTo({5, 5});
    driver.settle();
    CHECK(driver.context().probe.chosen == MeshPick{MeshPart::Elements, static_cast<std::uint32_t>(e)});
    CHECK(driver.has("probe/Angles"));
    const auto rows = describePart(driver.context(), *driver.context().probe.chosen);
    const auto valueOf = [&](const std::string &label) {
        for (const auto &[name, value] : rows) {
            if (name == label) {
                return value;
            }
        }
        return std::string("missing");
    };
    CHECK(valueOf("Element") == std::to_string(e));
    CHECK(std::abs(std::stod(valueOf("\xce\xb1")) - static_cast<double>(driver.run().mesh->alpha[e])) < 1e-4);
    driver.clickPlace(driver.nodeAt(e, 0));
    CHECK(driver.context().probe.chosen ==
          MeshPick{MeshPart::Nodes, static_cast<std::uint32_t>(index(driver.mesh().elements[e][0]))});
    driver.clickPlace(midpoint(driver.nodeAt(e, 0), driver.nodeAt(e, 1)));
    CHECK(driver.context().probe.chosen == MeshPick{MeshPart::Edges, driver.judgement().edges->of(e, 0)});
    driver.key(key::kEscape);
    CHECK_FALSE(driver.context().probe.chosen);
    driver.key('V');
    CHECK_FALSE(driver.context().probe.active);
}

TEST_CASE("Probe: every node lists its elements and says whether it is on the boundary") {
    JudgedSquare driver;
    driver.key('I');
    driver.settle();
    REQUIRE(driver.judgement().tree);
    const TriMesh &mesh = driver.mesh();
    for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node) {
        std::string elements;
        for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
            if (std::ranges::find(mesh.elements[e], NodeId{node}) != mesh.elements[e].end()) {
                elements += (elements.empty() ? "" : "  ") + std::to_string(e);
            }
        }
        const Vec2 p = mesh.nodes[node];
        const Box2 box = mesh.bounds();
        const bool outer = p.x == box.min.x || p.x == box.max.x || p.y == box.min.y || p.y == box.max.y;
        const auto rows = describePart(driver.context(), {MeshPart::Nodes, node});
        REQUIRE(rows.size() >= 5);
        CHECK(rows[3].second == elements);
        CHECK(rows[4].second == (outer ? "on the boundary" : "inside"));
    }
}

TEST_CASE("Probe: next and previous step through the worst parts, zoomed") {
    JudgedSquare driver;
    driver.showPanel("probe");
    driver.settle();
    const double before = driver.context().view.camera.zoom;
    CHECK(driver.click("probe/next"));
    driver.settle();
    const std::vector<std::uint32_t> worst = driver.judgement().worst;
    CHECK(ElementId{worst[0]} == driver.run().quality.worst);
    CHECK(driver.context().probe.chosen == MeshPick{MeshPart::Elements, worst[0]});
    CHECK(driver.context().view.camera.zoom > before);
    CHECK(distance(driver.context().view.camera.centre, driver.middleOf(worst[0])) < kTiny);
    CHECK(driver.click("probe/next"));
    CHECK(driver.context().probe.chosen == MeshPick{MeshPart::Elements, worst[1]});
    driver.settle();
    CHECK(driver.click("probe/previous"));
    CHECK(driver.context().probe.chosen == MeshPick{MeshPart::Elements, worst[0]});
}

TEST_CASE("Probe: a pinned node and a kept edge are in the next mesh") {
    JudgedSquare driver;
    driver.showPanel("probe");
    driver.key('I');
    driver.settle();
    const MeshEdge edge = driver.judgement().edges->edges[driver.innerEdge()];
    const Vec2 a = driver.mesh().nodes[index(edge.a)], b = driver.mesh().nodes[index(edge.b)];
    driver.clickPlace(a);
    driver.settle();
    CHECK(driver.click("probe/pin"));
    CHECK(driver.undoLabel() == "Pin node");
    driver.clickPlace(midpoint(a, b));
    driver.settle();
    CHECK(driver.click("probe/keep"));
    CHECK(driver.undoLabel() == "Keep edge");
    Document other = driver.document();
    other.spacing.size = 0.7; // another mesh
    driver.context().document.apply(std::move(other), "Size");
    driver.key(key::kF5);
    driver.settle();
    const std::vector<Vec2> &nodes = driver.mesh().nodes;
    const auto has = [&](Vec2 place) { return std::find(nodes.begin(), nodes.end(), place) != nodes.end(); };
    CHECK(has(a));
    CHECK(has(b));
    CHECK(std::any_of(driver.mesh().edges.begin(), driver.mesh().edges.end(), [](const TaggedEdge &e) {
        return e.tag == 2; // the kept edge, perhaps divided
    }));
}

} // namespace forefront::test
