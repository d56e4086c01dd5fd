#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/recovery/journal_record.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/files/files.hpp"
#include "core/files/inner_edges.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/dialogs/file_dialog.hpp"
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
    driver.chooseFile("save", place.path / "bay");
    CHECK_FALSE(driver.has("dialog/save"));
    CHECK(driver.context().document.path() == place.path / "bay.forefront");
    CHECK_FALSE(driver.context().document.dirty());
    const Document saved = driver.document();

    driver.key('V');
    driver.dragPlaces({9, 8}, {8, 7});
    CHECK(driver.context().document.dirty());
    driver.key('O', {Modifiers::kControl});
    driver.frames(5);
    CHECK_FALSE(driver.has("dialog/open/ok"));
    REQUIRE(driver.has("dialog/unsaved/discard")); // the drag is not saved; asked before a file is chosen
    driver.click("dialog/unsaved/discard");
    driver.settle();
    driver.chooseFile("open", place.path / "bay.forefront");
    driver.settle();
    CHECK_FALSE(driver.has("dialog/unsaved/discard")); // asked once
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
    driver.chooseFile("save", place.path / "bay");
    driver.rectangle({2, 2}, {3, 3});
    driver.key('O', {Modifiers::kControl});
    driver.frames(5);
    REQUIRE(driver.has("dialog/unsaved/save"));
    driver.click("dialog/unsaved/save");
    driver.settle();
    driver.chooseFile("open", place.path / "bay.forefront");
    driver.settle();
    CHECK(driver.document().shapes.size() == 2);
    CHECK_FALSE(driver.context().document.dirty());
    CHECK(readDocument(place.path / "bay.forefront")->shapes.size() == 2);
}

TEST_CASE("Files: Save as starts beside the last project, not beside a drawing that was opened to import it") {
    const TemporaryFolder projects, downloads;
    std::ofstream(downloads.path / "plan.svg") << R"(<svg viewBox="0 0 9 9"><rect width="9" height="6"/></svg>)";
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('S', {Modifiers::kControl});
    driver.frames(5);
    driver.chooseFile("save", projects.path / "bay");
    driver.key('O', {Modifiers::kControl});
    driver.frames(5);
    driver.chooseFile("open", downloads.path / "plan.svg");
    REQUIRE(driver.context().document.title() == "plan");
    driver.key('S', {Modifiers::kControl | Modifiers::kShift});
    driver.settle();
    CHECK(driver.has("dialog/save/list/bay.forefront"));
}

TEST_CASE("Files: replacing a file needs a confirmation, and write errors are reported") {
    const TemporaryFolder place;
    std::ofstream(place.path / "old.forefront") << "keep me";
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('S', {Modifiers::kControl});
    driver.frames(5);
    driver.chooseFile("save", place.path / "old.forefront");
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
    driver.chooseFile("save", place.path / "no-such-folder" / "x");
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
    driver.chooseFile("export", place.path / "bay");
    driver.settle();
    CHECK_FALSE(driver.has("dialog/export/ok"));
    const Result<Mesh> mesh = allFormats().readMesh(place.path / "bay.msh");
    REQUIRE(mesh.ok());
    CHECK(mesh->elementCount() == driver.run().quality.elements);
    CHECK_FALSE(hasErrors(verifyAgainst(*mesh, toDomain(driver.document()))));
}

TEST_CASE("Export: the format and its note follow the extension while it is typed") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.context().settings.exportFormat = "msh2";
    driver.context().actions.run("file.export", driver.context());
    driver.settle();
    const auto chosen = [&] {
        const auto *const dialog = dynamic_cast<const FileDialog *>(driver.context().dialogs.top());
        REQUIRE(dialog != nullptr);
        return dialog->filter().id;
    };
    CHECK(chosen() == "msh2");
    driver.click("dialog/export/name");
    driver.key('A', {Modifiers::kControl});
    driver.type("part.vt");
    CHECK(chosen() == "msh2");
    driver.type("u");
    CHECK(chosen() == "vtu");
    driver.key(key::kBackspace);
    driver.type("k");
    CHECK(chosen() == "vtk");
    driver.click("dialog/export/preset/gmsh");
    CHECK(chosen() == "msh41");
    driver.click("dialog/export/name");
    driver.key('A', {Modifiers::kControl});
    driver.type("other.msh"); // the extension of three formats
    CHECK(chosen() == "msh41");
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
        driver.chooseFile("export", place.path / (keeps ? "whole.msh" : "outline.msh"));
        driver.settle();
        const Result<Mesh> mesh = allFormats().readMesh(place.path / (keeps ? "whole.msh" : "outline.msh"));
        REQUIRE(mesh.ok());
        CHECK(mesh->elementCount() == driver.run().quality.elements);
        edges[keeps ? 0 : 1] = mesh->edges.size();
        CHECK((withoutInnerEdges(*mesh).edges.size() == mesh->edges.size()) != keeps);
    }
    CHECK(edges[1] < edges[0]);
    askForExport(driver);
    driver.click("dialog/export/name");
    driver.key('A', {Modifiers::kControl});
    driver.type("flow.su2"); // for SU2, every tagged edge is a boundary
    CHECK(driver.has("dialog/export/no-inner-edges"));
    CHECK_FALSE(driver.has("dialog/export/inner-edges"));
    driver.chooseFile("export", place.path / "flow.su2");
    driver.settle();
    const Result<Mesh> flow = allFormats().readMesh(place.path / "flow.su2");
    REQUIRE(flow.ok());
    CHECK(flow->edges.size() == edges[1]);
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
    driver.chooseFile("open", file);
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
    driver.chooseFile("export", place.path / "bay.msh");
    REQUIRE(driver.has("canvas/note"));
    const std::string message = driver.context().log.entries().back().diagnostic.message;
    CHECK(message.find((place.path / "bay.msh").string()) != std::string::npos);
    CHECK(message.find(ui::count(driver.run().quality.elements) + " triangles") != std::string::npos);
    CHECK(message.find(fileSizeText(std::filesystem::file_size(place.path / "bay.msh"))) != std::string::npos);
    driver.frames(600);
    CHECK_FALSE(driver.has("canvas/note"));

    askForExport(driver);
    driver.chooseFile("export", place.path / (std::string(300, 'm') + ".msh")); // longer than a name can be
    CHECK(driver.has("canvas/error"));
    CHECK_FALSE(driver.has("canvas/note"));
}

TEST_CASE("Export: a missing folder is reported in the dialog, which stays open") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    askForExport(driver);
    driver.chooseFile("export", place.path / "no-such-folder" / "bay.msh");
    REQUIRE(driver.has("dialog/export/ok"));
    CHECK(driver.context().widgets.find("dialog/export/warning")->rect.width > 100.0);
    CHECK_FALSE(driver.has("canvas/error"));
    const Diagnostic &fault = driver.context().log.entries().back().diagnostic;
    CHECK(fault.message.find("folder " + (place.path / "no-such-folder").string() + " not found") != std::string::npos);
    CHECK(fault.advice == "create it, or choose another");
    CHECK_FALSE(std::filesystem::exists(place.path / "no-such-folder"));
    driver.chooseFile("export", place.path / "bay.msh");
    CHECK_FALSE(driver.has("dialog/export/ok"));
    CHECK(allFormats().readMesh(place.path / "bay.msh").ok());
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
    REQUIRE(driver.has("dialog/unsaved/discard"));
    driver.click("dialog/unsaved/discard");
    driver.settle();
    driver.chooseFile("open", place.path / "points.geojson");
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
    driver.chooseFile("open", place.path / "square.geojson");
    driver.settle();
    CHECK_FALSE(driver.has("dialog/unsaved/discard"));
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
    for (const FileFormat &format : allFormats().list()) {
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
