#include "core/edit/equality.hpp"
#include "core/edit/journal_record.hpp"
#include "core/io/files.hpp"
#include "core/io/inner_edges.hpp"
#include "core/mesh/verify.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/dialogs/file_list.hpp"
#include "ui/widgets/widgets.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace forefront::test {

namespace {

void typeName(Draughtsman &driver, const std::string &dialog, const std::filesystem::path &file) {
    driver.click("dialog/" + dialog + "/name");
    driver.key('A', {Modifiers::kControl});
    driver.type(file.string());
    driver.click("dialog/" + dialog + "/ok");
    driver.settle();
}

void importFile(Draughtsman &driver, const std::filesystem::path &file) {
    driver.key('I', {Modifiers::kControl});
    driver.frames(5);
    typeName(driver, "import", file);
}

void askForExport(Draughtsman &driver) {
    driver.key('E', {Modifiers::kControl});
    driver.settle();
}

/// True if a journal in `folder` holds a document with this number of shapes.
bool isJournalled(const std::filesystem::path &folder, std::size_t shapes) {
    std::error_code failed;
    for (std::filesystem::directory_iterator file(folder, failed), end; !failed && file != end;
         file.increment(failed)) {
        std::ostringstream bytes;
        bytes << std::ifstream(file->path(), std::ios::binary).rdbuf();
        const std::optional<std::string> text = readJournal(bytes.str()).text;
        const Result<Document> document = parseProject(text.value_or(std::string()), "journal");
        if (document && document->shapes.size() == shapes) {
            return true;
        }
    }
    return false;
}

} // namespace

TEST_CASE("Files: a drawing with paint is the same after saving and opening") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.polygon({{3, 3}, {5, 3}, {4, 5}});
    driver.key('B');
    driver.dragPlaces({6, 6}, {7, 6});
    driver.key('S', {Modifiers::kControl});
    driver.frames(5);
    REQUIRE(driver.has("dialog/save/ok"));
    typeName(driver, "save", place.path / "bay");
    CHECK_FALSE(driver.has("dialog/save"));
    CHECK(driver.context().document.path() == place.path / "bay.forefront");
    CHECK_FALSE(driver.context().document.dirty());
    const Document saved = driver.document();

    driver.key('V');
    driver.dragPlaces({9, 8}, {8, 7});
    CHECK(driver.context().document.dirty());
    driver.key('O', {Modifiers::kControl});
    driver.frames(5);
    typeName(driver, "open", place.path / "bay.forefront");
    REQUIRE(driver.has("dialog/unsaved/discard")); // the drag is not saved
    driver.click("dialog/unsaved/discard");
    driver.settle();
    CHECK(sameContent(driver.document(), saved));
    CHECK_FALSE(driver.context().document.dirty());
    CHECK(driver.context().settings.recentFiles.front() == (place.path / "bay.forefront").string());
}

TEST_CASE("Files: reopening a file after saving shows the saved changes") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('S', {Modifiers::kControl});
    driver.frames(5);
    typeName(driver, "save", place.path / "bay");
    driver.rectangle({2, 2}, {3, 3});
    driver.key('O', {Modifiers::kControl});
    driver.frames(5);
    typeName(driver, "open", place.path / "bay.forefront");
    REQUIRE(driver.has("dialog/unsaved/save"));
    driver.click("dialog/unsaved/save");
    driver.settle();
    CHECK(driver.document().shapes.size() == 2);
    CHECK_FALSE(driver.context().document.dirty());
    CHECK(readDocument(place.path / "bay.forefront")->shapes.size() == 2);
}

TEST_CASE("Files: replacing a file needs a confirmation, and write errors are reported") {
    const TemporaryFolder place;
    std::ofstream(place.path / "old.forefront") << "keep me";
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('S', {Modifiers::kControl});
    driver.frames(5);
    typeName(driver, "save", place.path / "old.forefront");
    CHECK(driver.has("dialog/save/ok")); // asks for confirmation
    std::ifstream file(place.path / "old.forefront");
    CHECK(std::string(std::istreambuf_iterator<char>(file), {}) == "keep me");
    driver.click("dialog/save/ok");
    driver.settle();
    CHECK_FALSE(driver.has("dialog/save/ok"));
    CHECK(readDocument(place.path / "old.forefront").ok());

    driver.rectangle({2, 2}, {3, 3});
    driver.key('S', {Modifiers::kControl | Modifiers::kShift});
    driver.frames(5);
    typeName(driver, "save", place.path / "no-such-folder" / "x");
    CHECK(driver.has("dialog/save/ok"));
    CHECK(driver.context().document.dirty());
    driver.key(key::kEscape);
    driver.frames(5);
    CHECK_FALSE(driver.has("dialog/save/ok"));
}

TEST_CASE("Files: a file without a drawing is refused with a message and changes nothing") {
    const TemporaryFolder place;
    std::ofstream(place.path / "bad.forefront") << "{\"this is\": [no json";
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    const Document before = driver.document();
    driver.context().document.markSaved({});
    driver.editor().input().push({.kind = InputKind::Drop, .paths = {(place.path / "bad.forefront").string()}});
    driver.settle();
    CHECK(sameContent(driver.document(), before));
    CHECK(hasErrors({driver.context().log.entries().back().diagnostic}));
}

TEST_CASE("Export: a drawing is meshed and written as a valid MSH file") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 8}, {1, 8}});
    driver.polygon({{3, 3}, {5, 3}, {4, 5}});
    askForExport(driver);
    REQUIRE(driver.has("dialog/export/ok"));
    typeName(driver, "export", place.path / "bay");
    driver.settle();
    CHECK_FALSE(driver.has("dialog/export/ok"));
    const Result<Mesh> mesh = readMesh(place.path / "bay.msh");
    REQUIRE(mesh.ok());
    CHECK(mesh->elements.size() == driver.run().quality.elements);
    CHECK_FALSE(hasErrors(verifyAgainst(*mesh, toDomain(driver.document()))));
}

TEST_CASE("Export: edges inside the domain can be left out") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('L');
    driver.clickPlace({3, 3});
    driver.clickPlace({6, 5});
    driver.key(key::kEnter);
    REQUIRE(driver.document().shapes.back()->use == ShapeUse::Constraint);
    std::size_t edges[2] = {};
    for (const bool keeps : {true, false}) {
        askForExport(driver);
        REQUIRE(driver.has("dialog/export/inner-edges"));
        if (!keeps) {
            driver.click("dialog/export/inner-edges");
        }
        typeName(driver, "export", place.path / (keeps ? "whole.msh" : "outline.msh"));
        driver.settle();
        const Result<Mesh> mesh = readMesh(place.path / (keeps ? "whole.msh" : "outline.msh"));
        REQUIRE(mesh.ok());
        CHECK(mesh->elements.size() == driver.run().quality.elements);
        edges[keeps ? 0 : 1] = mesh->edges.size();
        CHECK((withoutInnerEdges(*mesh).edges.size() == mesh->edges.size()) != keeps);
    }
    CHECK(edges[1] < edges[0]);
}

TEST_CASE("Files: the file dialog and the shortcut sheet fit into a small window") {
    Draughtsman driver;
    driver.platform().resize({1280, 800}, 2.0);
    driver.key('O', {Modifiers::kControl});
    driver.settle();
    const PixelRect dialog = driver.context().widgets.find("dialog/open")->rect;
    for (const char *part : {"dialog/open/path", "dialog/open/name", "dialog/open/filter", "dialog/open/ok"}) {
        CAPTURE(part);
        const PixelRect rect = driver.context().widgets.find(part)->rect;
        CHECK(rect.x + rect.width <= dialog.x + dialog.width - 20.0);
    }
    const TemporaryFolder place;
    const std::filesystem::path file = place.path / (std::string(60, 'm') + ".geojson");
    std::ofstream(file) << R"({"type": "Point", "coordinates": [1, 2]})";
    typeName(driver, "open", file);
    REQUIRE(driver.has("dialog/open/warning"));
    driver.platform().resize({1040, 800}, 2.0);
    driver.settle();
    const PixelRect warning = driver.context().widgets.find("dialog/open/warning")->rect;
    CHECK(warning.height > 60.0); // in several lines
    CHECK(warning.y + warning.height <= dialog.y + dialog.height - 20.0);
    driver.platform().resize({1280, 800}, 2.0);
    driver.key(key::kEscape);
    driver.key(key::kF1);
    driver.settle();
    const PixelRect sheet = driver.context().widgets.find("dialog/shortcuts")->rect;
    for (const char *part : {"shortcuts/tools", "shortcuts/mesh", "shortcuts/files"}) {
        CAPTURE(part);
        const PixelRect rect = driver.context().widgets.find(part)->rect;
        CHECK(rect.width >= 500.0);
        CHECK(rect.x + rect.width <= sheet.x + sheet.width - 20.0);
    }
}

TEST_CASE("Export: a message on the canvas reports the file and its size, or the error") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    askForExport(driver);
    typeName(driver, "export", place.path / "bay.msh");
    REQUIRE(driver.has("canvas/note"));
    const std::string message = driver.context().log.entries().back().diagnostic.message;
    CHECK(message.find((place.path / "bay.msh").string()) != std::string::npos);
    CHECK(message.find(ui::count(driver.run().quality.elements) + " triangles") != std::string::npos);
    CHECK(message.find(fileSizeText(std::filesystem::file_size(place.path / "bay.msh"))) != std::string::npos);
    driver.frames(600);
    CHECK_FALSE(driver.has("canvas/note"));

    askForExport(driver);
    typeName(driver, "export", place.path / (std::string(300, 'm') + ".msh")); // longer than a name can be
    CHECK(driver.has("canvas/error"));
    CHECK_FALSE(driver.has("canvas/note"));
}

TEST_CASE("Export: a missing folder is reported in the dialog, which stays open") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    askForExport(driver);
    typeName(driver, "export", place.path / "no-such-folder" / "bay.msh");
    REQUIRE(driver.has("dialog/export/ok"));
    CHECK(driver.context().widgets.find("dialog/export/warning")->rect.width > 100.0);
    CHECK_FALSE(driver.has("canvas/error"));
    const Diagnostic &fault = driver.context().log.entries().back().diagnostic;
    CHECK(fault.message.find("folder " + (place.path / "no-such-folder").string() + " not found") != std::string::npos);
    CHECK(fault.advice == "create it, or choose another");
    CHECK_FALSE(std::filesystem::exists(place.path / "no-such-folder"));
    typeName(driver, "export", place.path / "bay.msh");
    CHECK_FALSE(driver.has("dialog/export/ok"));
    CHECK(readMesh(place.path / "bay.msh").ok());
}

TEST_CASE("Open: an unreadable file is reported in the dialog, and the drawing stays") {
    const TemporaryFolder place;
    std::ofstream(place.path / "points.geojson") << R"({"type": "Point", "coordinates": [1, 2]})";
    std::ofstream(place.path / "square.geojson")
        << R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]]})";
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('O', {Modifiers::kControl});
    driver.frames(5);
    typeName(driver, "open", place.path / "points.geojson");
    REQUIRE(driver.has("dialog/open/warning")); // the dialog is still open, without another question
    CHECK_FALSE(driver.has("dialog/unsaved/discard"));
    const auto warning = [&] { return driver.context().widgets.find("dialog/open/warning")->rect; };
    CHECK(warning().width > 100.0);
    CHECK(warning().x + warning().width < driver.context().widgets.find("dialog/open/cancel")->rect.x);
    CHECK(driver.document().shapes.size() == 1);
    driver.click("dialog/open/name");
    driver.key('A', {Modifiers::kControl});
    driver.type("s");
    driver.frames(2);
    CHECK(warning().width < 1.0);
    typeName(driver, "open", place.path / "square.geojson");
    REQUIRE(driver.has("dialog/unsaved/discard"));
    driver.click("dialog/unsaved/discard");
    driver.settle();
    CHECK(boundsOf(driver.document()).size() == Vec2{4, 3});
    CHECK(driver.has("canvas/note"));
    CHECK(driver.context().log.entries().back().diagnostic.message.find("GeoJSON") != std::string::npos);
}

TEST_CASE("Open: saving does not overwrite a GeoJSON file named .json") {
    const TemporaryFolder place;
    std::ofstream(place.path / "square.json")
        << R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]]})";
    Draughtsman driver;
    REQUIRE(driver.editor().open(place.path / "square.json"));
    CHECK(driver.context().document.path().empty());
    driver.key('S', {Modifiers::kControl});
    driver.frames(5);
    CHECK(driver.has("dialog/save/ok"));
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
        typeName(driver, "importspacing", place.path / name);
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
    CHECK_FALSE(driver.has("dialog/importoptions/note/0"));
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
    CHECK(driver.document().shapes.front()->kind == ShapeKind::Polygon);
}

TEST_CASE("Quit: asks about unsaved changes; Cancel stays, and Don't save leaves") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.editor().input().push({.kind = InputKind::Close});
    driver.settle();
    REQUIRE(driver.has("dialog/unsaved/cancel"));
    driver.click("dialog/unsaved/cancel");
    CHECK(driver.editor().running());
    driver.key('Q', {Modifiers::kControl});
    driver.frames(5);
    driver.click("dialog/unsaved/discard");
    CHECK_FALSE(driver.editor().running());
}

// Not a test in itself: this is the process that the next test kills.
TEST_CASE("Recovery: draws in the folder of FOREFRONT_TEST_VICTIM and waits" * doctest::skip()) {
    const char *folder = std::getenv("FOREFRONT_TEST_VICTIM");
    REQUIRE(folder != nullptr);
    Draughtsman driver({.stateFolder = std::filesystem::path(folder) / "state"});
    driver.rectangle({1, 1}, {9, 8});
    driver.polygon({{3, 3}, {5, 3}, {4, 5}});
    REQUIRE(driver.document().shapes.size() == 2);
    for (;;) {
        ::pause();
    }
}

TEST_CASE("Recovery: after kill -9 the next start offers the unsaved drawing and recovers it") {
    const TemporaryFolder place;
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ::setenv("FOREFRONT_TEST_VICTIM", place.path.c_str(), 1);
        ::execl("/proc/self/exe", "victim", "--no-skip", "-tc=*FOREFRONT_TEST_VICTIM*", static_cast<char *>(nullptr));
        ::_exit(1);
    }
    int status = 0;
    while (!isJournalled(place.path / "state" / "recovery", 2)) {
        REQUIRE(::waitpid(child, &status, WNOHANG) == 0);
        ::usleep(20000);
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
    const EditorSetup setup{.stateFolder = place.path / "state", .sample = false};
    {
        Driver driver(setup);
        REQUIRE(driver.has("dialog/recovery/recover"));
        driver.click("dialog/recovery/recover");
        driver.settle();
        const Document &document = *driver.context().document.current();
        REQUIRE(document.shapes.size() == 2);
        CHECK(document.shapes[1]->nodes == std::vector<Vec2>{{3, 3}, {5, 3}, {4, 5}});
        CHECK(driver.context().document.dirty());
        CHECK(driver.context().document.path().empty());
    }
    // That session ended normally, so nothing is offered.
    Driver driver(setup);
    CHECK_FALSE(driver.has("dialog/recovery/recover"));
}

TEST_CASE("Files: dialogs that open files offer every format that can be read") {
    const auto filters = openFilters("All meshes", {}, [](const FileFormat &format) { return format.readsMesh; });
    REQUIRE(filters.size() > 3);
    CHECK(filters.front().name == "All meshes");
    CHECK(filters.back().extensions.empty());
    for (const FileFormat &format : fileFormats()) {
        CAPTURE(format.id);
        const std::string name = std::string("x") + format.extension;
        if (format.readsMesh) {
            CHECK(passes(filters.front(), name));
            CHECK(std::count_if(filters.begin() + 1, filters.end() - 1,
                                [&](const FileFilter &filter) { return passes(filter, name); }) == 1);
        }
    }
    CHECK_FALSE(passes(filters.front(), "notes.txt"));
}

} // namespace forefront::test
