#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

void importFile(Draughtsman &driver, const std::filesystem::path &file) {
    driver.key('I', {Modifiers::kControl});
    driver.frames(5);
    driver.chooseFile("import", file);
}

/// Two filled shapes, one of which leaves the page, a line and a stroke: every checkbox is offered.
constexpr const char *kInked = R"(<svg viewBox="0 0 10 10"><rect x="-5" width="9" height="6"/>)"
                               R"(<rect x="2" y="1" width="1" height="1"/>)"
                               R"(<path fill="none" stroke="black" d="M1 1L3 5"/></svg>)";

} // namespace

TEST_CASE("Import: Enter imports, unless a field takes it to accept its number") {
    const TemporaryFolder place;
    std::ofstream(place.path / "inked.svg") << kInked;
    Draughtsman driver;
    const auto imported = [&] {
        driver.settle();
        return !driver.has("dialog/importoptions/ok") && driver.undoLabel() == "Import drawing";
    };
    const auto open = [&] {
        driver.key('N', {Modifiers::kControl});
        driver.settle();
        if (driver.has("dialog/unsaved/discard")) {
            driver.click("dialog/unsaved/discard");
            driver.settle();
        }
        importFile(driver, place.path / "inked.svg");
        REQUIRE(driver.has("dialog/importoptions/ok"));
    };
    SUBCASE("right after the file was read") {
        open();
    }
    SUBCASE("on the keypad") {
        open();
        driver.key(key::kKeypadEnter);
        CHECK(imported());
        open();
    }
    SUBCASE("after a checkbox was clicked") {
        open();
        driver.click("dialog/importoptions/lines");
        driver.settle();
    }
    SUBCASE("after a number was entered") {
        open();
        driver.fill("dialog/importoptions/weld", "0.01");
        CHECK_FALSE(imported());
    }
    SUBCASE("after a field was left unchanged") {
        open();
        driver.click("dialog/importoptions/scale");
        driver.key(key::kEnter);
        CHECK_FALSE(imported());
    }
    driver.key(key::kEnter);
    CHECK(imported());
}

TEST_CASE("Import: Enter does not import while a text is refused") {
    const TemporaryFolder place;
    std::ofstream(place.path / "inked.svg") << kInked;
    Draughtsman driver;
    importFile(driver, place.path / "inked.svg");
    driver.fill("dialog/importoptions/scale", "abc");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.has("dialog/importoptions/scale/fault"));
    CHECK(driver.has("dialog/importoptions/ok"));
    driver.fill("dialog/importoptions/scale", "2");
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.document().shapes.empty());
}

TEST_CASE("Import: Tab reaches every field and checkbox in order, and Space switches a checkbox") {
    const TemporaryFolder place;
    std::ofstream(place.path / "inked.svg") << kInked;
    Draughtsman driver;
    importFile(driver, place.path / "inked.svg");
    REQUIRE(driver.has("dialog/importoptions/page"));
    const auto focus = [&] {
        driver.frames(3);
        const FieldFocus &fields = driver.context().widgets.fields;
        const std::string name = fields.entry ? fields.entry->name : fields.held();
        return name.substr(name.find_last_of('/') + 1);
    };
    const std::vector<std::string> order{"scale", "weld", "page", "lines", "strokes", "regions"};
    for (std::size_t k = 0; k + 1 < 2 * order.size(); ++k) {
        driver.key(key::kTab);
        CHECK(focus() == order[k % order.size()]);
    }
    driver.key(key::kTab, {Modifiers::kShift});
    CHECK(focus() == "lines");
    driver.key(key::kSpace);
    driver.settle();
    CHECK(focus() == "lines");
    driver.key(key::kTab, {Modifiers::kShift});
    driver.key(key::kTab, {Modifiers::kShift});
    driver.type("0.01");
    driver.key(key::kTab);
    CHECK(focus() == "page");
    driver.key(key::kEnter);
    driver.settle();
    CHECK_FALSE(driver.has("dialog/importoptions/ok"));
    CHECK(driver.document().shapes.size() == 1); // without the line
    CHECK(driver.logHas("dropped-lines"));
}

TEST_CASE("Import: a drawing is added to the current one, scaled by the chosen unit") {
    const TemporaryFolder place;
    {
        Draughtsman driver;
        driver.rectangle({2, 2}, {4, 4});
        REQUIRE(writeProject(place.path / "part.forefront", driver.document()).empty());
    }
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    importFile(driver, place.path / "part.forefront");
    REQUIRE(driver.has("dialog/importoptions/ok"));
    driver.click("dialog/importoptions/inch");
    driver.click("dialog/importoptions/ok");
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 2);
    CHECK(boundsOf(*driver.document().shapes[1]).size().x == doctest::Approx(50.8));
    CHECK(driver.undoLabel() == "Import drawing");
}

TEST_CASE(
    "Import spacing: a grid of sizes becomes the spacing, in one undo step; a broken file is reported in the dialog") {
    const TemporaryFolder place;
    const std::string header = "ncols 2\nnrows 2\nxllcorner 1\nyllcorner 1\ncellsize 4\n";
    std::ofstream(place.path / "good.asc") << header << "1 1\n0.5 1\n";
    std::ofstream(place.path / "bad.asc") << header << "1 1\n-5 1\n";
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 9});
    const auto import = [&](const char *name) {
        driver.context().actions.run("file.importSpacing", driver.context());
        driver.frames(5);
        driver.chooseFile("importspacing", place.path / name);
        driver.settle();
    };
    import("bad.asc");
    CHECK(driver.context().dialogs.any());
    CHECK(driver.document().spacing.automatic());
    driver.context().dialogs.closeAll();
    import("good.asc");
    CHECK_FALSE(driver.context().dialogs.any());
    CHECK(driver.undoLabel() == "Import spacing");
    REQUIRE(driver.context().preview->spacing != nullptr);
    CHECK(driver.context().preview->spacing->at({3, 3}) == doctest::Approx(0.5));
    driver.key('Z', kControl);
    CHECK(driver.document().spacing.automatic());
}

TEST_CASE("Import: the weld tolerance closes gaps of a map, and the dialog says what changed") {
    const TemporaryFolder place;
    const auto polygon = [](const char *name, const char *corners) {
        return std::string(R"({"type": "Feature", "properties": {"name": ")") + name +
               R"("}, "geometry": {"type": "Polygon", "coordinates": [[)" + corners + "]]}}";
    };
    std::ofstream(place.path / "map.geojson")
        << R"({"type": "FeatureCollection", "features": [)" << polygon("A", "[0,0],[4,0],[4,3],[0,3],[0,0]") << ", "
        << polygon("B", "[4.01,0],[8,0],[8,3],[4.01,3],[4.01,0]") << "]}";
    Draughtsman driver;
    importFile(driver, place.path / "map.geojson");
    REQUIRE(driver.has("dialog/importoptions/weld"));
    CHECK(driver.has("dialog/importoptions/overlap/later wins"));
    REQUIRE(driver.has("dialog/importoptions/note/0")); // the gap
    driver.click("dialog/importoptions/note/0");        // goes there
    driver.settle();
    CHECK(distance(driver.context().view.camera.centre, {4.005, 0}) < 0.02);
    CHECK(driver.context().view.camera.visible().size().x < 8.0);
    driver.click("dialog/importoptions/weld");
    driver.type("0.02");
    driver.key(key::kEnter);
    driver.settle();
    REQUIRE(driver.has("dialog/importoptions/note/0"));
    driver.click("dialog/importoptions/ok");
    driver.settle();
    const Domain domain = toDomain(driver.document());
    CHECK(domain.nodes.size() == 6);
    CHECK(driver.logHas("welded-nodes"));
    CHECK_FALSE(driver.logHas("feature-gaps"));
}

TEST_CASE("Import: a drawing that leaves its page can be read in full") {
    const TemporaryFolder place;
    std::ofstream(place.path / "wide.svg") << R"(<svg viewBox="0 0 10 10"><rect x="-5" width="9" height="6"/></svg>)";
    Draughtsman driver;
    importFile(driver, place.path / "wide.svg");
    REQUIRE(driver.has("dialog/importoptions/page"));
    CHECK(driver.has("dialog/importoptions/note/0"));
    driver.click("dialog/importoptions/page");
    driver.settle();
    CHECK_FALSE(driver.has("dialog/importoptions/note/0"));
    CHECK(driver.has("dialog/importoptions/page"));
    driver.click("dialog/importoptions/ok");
    driver.settle();
    CHECK(boundsOf(driver.document()).size() == Vec2{9, 6});
}

TEST_CASE("Import: the options stay under the pointer when the notes change, and long notes scroll") {
    const TemporaryFolder place;
    std::ofstream(place.path / "inked.svg") << kInked;
    Draughtsman driver;
    importFile(driver, place.path / "inked.svg");
    const auto rect = [&](const char *part) {
        const WidgetRegistry::Widget *const widget =
            driver.context().widgets.find(std::string("dialog/importoptions") + part);
        REQUIRE(widget != nullptr);
        return widget->rect;
    };
    const PixelRect before = rect("/page"), dialog = rect("");
    CHECK(dialog.x >= driver.canvas().x + driver.canvas().width); // the drawing is seen beside it
    const auto notes = [&] {
        std::vector<PixelRect> rects;
        for (int k = 0; driver.has("dialog/importoptions/note/" + std::to_string(k)); ++k) {
            rects.push_back(rect(("/note/" + std::to_string(k)).c_str()));
        }
        return rects;
    };
    const std::vector<PixelRect> first = notes();
    for (const char *option : {"/page", "/lines", "/strokes"}) {
        driver.click(std::string("dialog/importoptions") + option);
        driver.settle();
        CHECK(rect("/page") == before);
        CHECK(rect("") == dialog);
    }
    CHECK_FALSE(notes() == first);
    driver.click("dialog/importoptions/cancel");
    driver.settle();
    std::ofstream odd(place.path / "odd.svg");
    odd << kInked;
    odd.seekp(-6, std::ios::end); // the end tag
    for (int k = 0; k < 40; ++k) {
        odd << "<odd" << k << "/>";
    }
    odd << "</svg>";
    odd.close();
    importFile(driver, place.path / "odd.svg");
    REQUIRE(driver.has("dialog/importoptions/note/5"));
    CHECK(rect("/report").height == doctest::Approx(150.0)); // the limit; without it, 40 notes would need far more
}

TEST_CASE("Import: the lines of a drawing with filled shapes can be left out") {
    const TemporaryFolder place;
    std::ofstream(place.path / "inked.svg") << R"(<svg viewBox="0 0 10 10"><rect width="9" height="6"/>)"
                                            << R"(<path fill="none" stroke="black" d="M1 1L8 5"/></svg>)";
    std::ofstream(place.path / "plain.svg") << R"(<svg viewBox="0 0 10 10"><rect width="9" height="6"/></svg>)";
    Draughtsman driver;
    importFile(driver, place.path / "plain.svg");
    CHECK_FALSE(driver.has("dialog/importoptions/lines"));
    driver.click("dialog/importoptions/cancel");
    driver.settle();
    importFile(driver, place.path / "inked.svg");
    REQUIRE(driver.has("dialog/importoptions/lines"));
    driver.click("dialog/importoptions/lines");
    driver.settle();
    CHECK(driver.has("dialog/importoptions/lines"));
    driver.click("dialog/importoptions/ok");
    driver.settle();
    CHECK(driver.document().shapes.size() == 1);
    CHECK(driver.logHas("dropped-lines"));
}

TEST_CASE("Import: the lines of a map with polygons can be left out; borders that polygons share are no lines") {
    const TemporaryFolder place;
    const auto feature = [](const char *kind, const char *coordinates) {
        return std::string(R"({"type": "Feature", "properties": {}, "geometry": {"type": ")") + kind +
               R"(", "coordinates": )" + coordinates + "}}";
    };
    const std::string polygons = feature("Polygon", "[[[0,0],[4,0],[4,3],[0,3],[0,0]]]") + ", " +
                                 feature("Polygon", "[[[4,0],[8,0],[8,3],[4,3],[4,0]]]");
    const std::string start = R"({"type": "FeatureCollection", "features": [)";
    std::ofstream(place.path / "areas.geojson") << start << polygons << "]}";
    std::ofstream(place.path / "river.geojson")
        << start << polygons << ", " << feature("LineString", "[[1,1],[3,2]]") << "]}";
    Draughtsman driver;
    importFile(driver, place.path / "areas.geojson");
    CHECK_FALSE(driver.has("dialog/importoptions/lines"));
    driver.click("dialog/importoptions/cancel");
    driver.settle();
    importFile(driver, place.path / "river.geojson");
    REQUIRE(driver.has("dialog/importoptions/lines"));
    driver.click("dialog/importoptions/lines");
    driver.settle();
    driver.click("dialog/importoptions/ok");
    driver.settle();
    CHECK(driver.logHas("dropped-lines"));
    CHECK(toDomain(driver.document()).nodes.size() == 6);
}

TEST_CASE("Import: the rule for overlaps is offered for maps, and not for drawings, where it changes nothing") {
    const TemporaryFolder place;
    std::ofstream(place.path / "inked.svg") << kInked;
    Draughtsman driver;
    importFile(driver, place.path / "inked.svg");
    CHECK(driver.has("dialog/importoptions/weld"));
    CHECK_FALSE(driver.has("dialog/importoptions/overlap/later wins"));
}

TEST_CASE("Import: a layer of a map and the property with its names can be chosen") {
    const TemporaryFolder place;
    std::ofstream(place.path / "atlas.json")
        << R"({"type": "Topology", "arcs": [[[0, 0], [4, 0], [4, 3], [0, 0]], [[6, 0], [8, 0], [8, 1], [6, 0]], )"
        << R"([[7, 0.25], [7.5, 0.25]]], "objects": {"counties": {"type": "Polygon", "arcs": [[0]], "properties": )"
        << R"({"nom": "A", "": "unnamed"}}, "gauges": {"type": "Point", "coordinates": [1, 1]}, "nation": )"
        << R"({"type": "GeometryCollection", "geometries": [{"type": "Polygon", "arcs": [[1]], "properties": )"
        << R"({"NAME_1": "B", "code": 12}}, {"type": "LineString", "arcs": [2]}]}}})";
    Draughtsman driver;
    importFile(driver, place.path / "atlas.json");
    const std::string dialog = "dialog/importoptions/", layer = dialog + "layer", names = dialog + "names";
    const auto choose = [&](const std::string &combo, const std::string &label) {
        driver.click(combo);
        driver.frames(3);
        REQUIRE(driver.has(combo + '/' + label));
        driver.click(combo + '/' + label);
        driver.settle();
    };
    const auto hasNote = [&] { return driver.has(dialog + "note/0"); };
    REQUIRE(driver.has(layer));
    CHECK(hasNote()); // the other layers
    CHECK_FALSE(driver.has(dialog + "lines"));
    choose(names, "nom");
    choose(layer, "gauges");
    CHECK(hasNote()); // refused: no polygon and no line
    CHECK_FALSE(driver.has(names));
    choose(layer, "nation");
    CHECK(driver.has(dialog + "lines"));
    choose(names, "code");
    choose(names, "automatic");
    choose(names, "code");
    driver.click(dialog + "ok");
    driver.settle();
    const Domain domain = toDomain(driver.document());
    CHECK(domain.bounds().max == Vec2{8, 1});
    CHECK(domain.regionNames == std::map<std::int32_t, std::string>{{1, "12"}});
}

TEST_CASE("Import: the layers of a DXF drawing are switched on and off") {
    const TemporaryFolder place;
    std::ofstream(place.path / "part.dxf")
        << "0\nSECTION\n2\nHEADER\n9\n$"
           "INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nplate\n10\n5\n20\n5\n40\n4\n"
           "0\nCIRCLE\n8\nhole\n10\n5\n20\n5\n40\n1\n0\nENDSEC\n0\nEOF\n";
    Draughtsman driver;
    importFile(driver, place.path / "part.dxf");
    const std::string layer = "dialog/importoptions/layer/";
    REQUIRE(driver.has(layer + "1"));
    CHECK(driver.document().shapes.size() == 2);
    driver.click(layer + "1");
    driver.settle();
    CHECK(driver.document().shapes.size() == 1);
    driver.click(layer + "0"); // one layer stays
    driver.settle();
    CHECK(driver.document().shapes.size() == 1);
    driver.click("dialog/importoptions/ok");
    driver.settle();
    const Domain domain = toDomain(driver.document());
    CHECK(domain.bounds().max.x == doctest::Approx(9.0));
    CHECK(domain.boundaryNames == std::map<std::int32_t, std::string>{{1, "plate"}});
}

TEST_CASE("Import: neither layers nor properties are offered for a map without them") {
    const TemporaryFolder place;
    std::ofstream(place.path / "map.geojson") << R"({"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,3],[0,0]]]})";
    Draughtsman driver;
    importFile(driver, place.path / "map.geojson");
    CHECK(driver.has("dialog/importoptions/ok"));
    CHECK_FALSE(driver.has("dialog/importoptions/layer"));
    CHECK_FALSE(driver.has("dialog/importoptions/names"));
}

TEST_CASE("Import: what strokes paint can be meshed") {
    struct Sample {
        const char *path;
        std::size_t segments;
        Vec2 size;
    };
    for (const Sample &sample : {Sample{"M2 2H8V8H2Z", 8, {7, 7}}, Sample{"M2 2H8", 4, {6, 1}}}) {
        const TemporaryFolder place;
        std::ofstream(place.path / "strokes.svg")
            << R"(<svg viewBox="0 0 10 10" fill="none" stroke="black"><path d=")" << sample.path << R"("/></svg>)";
        Draughtsman driver;
        importFile(driver, place.path / "strokes.svg");
        REQUIRE(driver.has("dialog/importoptions/strokes"));
        driver.click("dialog/importoptions/strokes");
        driver.settle();
        driver.click("dialog/importoptions/ok");
        driver.settle();
        CHECK(toDomain(driver.document()).segments.size() == sample.segments);
        CHECK(boundsOf(driver.document()).size() == sample.size);
    }
}

TEST_CASE("Import: an exact file is repaired only with a weld tolerance") {
    const TemporaryFolder place;
    std::ofstream(place.path / "gap.poly")
        << "5 2\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n5 0 0.01\n4\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n0\n";
    Draughtsman driver;
    importFile(driver, place.path / "gap.poly");
    REQUIRE(driver.has("dialog/importoptions/weld"));
    CHECK_FALSE(driver.has("dialog/importoptions/overlap/later wins"));
    driver.click("dialog/importoptions/weld");
    driver.type("0.02");
    driver.key(key::kEnter);
    driver.settle();
    CHECK(driver.has("dialog/importoptions/note/0"));
    driver.click("dialog/importoptions/ok");
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes.front()->kind() == ShapeKind::Polygon);
}

TEST_CASE("Import: regions are offered only where a drawing has several filled shapes") {
    const TemporaryFolder place;
    std::ofstream(place.path / "disc.svg") << R"(<svg viewBox="0 0 10 10"><circle cx="5" cy="5" r="4"/>)"
                                           << R"(<path fill="none" stroke="black" d="M4 5H6"/></svg>)";
    Draughtsman driver;
    importFile(driver, place.path / "disc.svg");
    REQUIRE(driver.has("dialog/importoptions/strokes"));
    CHECK_FALSE(driver.has("dialog/importoptions/regions"));
    driver.click("dialog/importoptions/strokes"); // what the stroke paints is a second shape
    driver.settle();
    REQUIRE(driver.has("dialog/importoptions/regions"));
    driver.click("dialog/importoptions/regions");
    driver.click("dialog/importoptions/strokes");
    driver.settle();
    REQUIRE(driver.has("dialog/importoptions/regions"));
    driver.click("dialog/importoptions/regions");
    driver.settle();
    CHECK_FALSE(driver.has("dialog/importoptions/regions"));
}

TEST_CASE("Import: filled shapes of a drawing can become regions") {
    const TemporaryFolder place;
    std::ofstream(place.path / "two.svg") << R"(<svg viewBox="0 0 20 10"><rect id="steel" width="12" height="10"/>)"
                                          << R"(<rect id="copper" x="10" width="10" height="10"/></svg>)";
    Draughtsman driver;
    importFile(driver, place.path / "two.svg");
    REQUIRE(driver.has("dialog/importoptions/regions"));
    driver.click("dialog/importoptions/regions");
    driver.settle();
    driver.click("dialog/importoptions/ok");
    driver.settle();
    CHECK_FALSE(driver.logHas("svg-regions"));
    const Document &document = driver.document();
    REQUIRE(document.regionMarkers.size() == 2);
    CHECK(document.regionNames.size() == 2);
}

} // namespace forefront::test
