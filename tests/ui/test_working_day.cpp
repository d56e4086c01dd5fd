#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/recovery/recovery_journal.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/base/hash.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/files.hpp"
#include "tests/ui/edit_driver.hpp"
#include "tests/ui/replayed_script.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/thumbnails.hpp"
#include "ui/platform/assets.hpp"

#include <doctest/doctest.h>
#include <imgui.h>

#include <atomic>
#include <cmath>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace forefront::test {

namespace {

/// Opens the dialog of an action and waits for it.
void openDialog(Driver &driver, const char *action, const char *dialog) {
    driver.context().actions.run(action, driver.context());
    driver.settle();
    REQUIRE(driver.context().dialogs.top() != nullptr);
    CHECK(std::string(driver.context().dialogs.top()->id()) == dialog);
}

} // namespace

TEST_CASE("Gallery: there are at least twelve samples, each with a description and a mesh in its thumbnail") {
    const std::vector<Sample> gallery = sampleDrawings();
    REQUIRE(gallery.size() >= 12);
    std::vector<std::filesystem::path> paths;
    std::set<std::string> titles;
    for (const Sample &sample : gallery) {
        CAPTURE(sample.title);
        CHECK_FALSE(sample.about.empty());
        titles.insert(sample.title);
        paths.push_back(sample.path);
    }
    CHECK(titles.size() == gallery.size());
    std::atomic<std::size_t> wakes = 0;
    BackgroundList background([&] { ++wakes; });
    Thumbnails thumbnails(background, paths);
    while (!thumbnails.done()) {
        thumbnails.refresh();
        std::this_thread::yield();
    }
    for (std::size_t i = 0; i < gallery.size(); ++i) {
        CAPTURE(gallery[i].title);
        const Thumbnail &thumbnail = *thumbnails.at(i);
        CHECK(thumbnail.elements.size() > 100);
        CHECK(thumbnail.elements.size() < 6000);
        CHECK(thumbnail.fineness.size() == thumbnail.elements.size());
        CHECK(thumbnail.boundary.size() > 3);
        CHECK(thumbnail.edges.size() > thumbnail.elements.size());
    }
}

TEST_CASE("Gallery: a click on a card opens the sample as a document without a file") {
    Driver driver;
    openDialog(driver, "file.samples", "gallery");
    driver.click("dialog/gallery/plate");
    driver.settle();
    CHECK(driver.context().dialogs.top() == nullptr);
    CHECK(driver.context().document.title() == "Plate with a hole");
    CHECK(driver.context().document.path().empty());
}

TEST_CASE("Recent files: the submenu opens files, drops missing ones, and can be cleared") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.rectangle({0, 0}, {4, 4});
    for (const char *name : {"one.forefront", "two.forefront"}) {
        REQUIRE(writeProject(place.path / name, driver.document()).empty());
    }
    const std::string gone = (place.path / "gone.forefront").string();
    driver.context().settings.recentFiles = {gone, (place.path / "one.forefront").string(),
                                             (place.path / "two.forefront").string()};
    driver.context().document.markSaved({});
    driver.click("menu/File");
    driver.hover("menu/file.recent");
    driver.frames(40); // the submenu opens after a moment
    driver.click("menu/file.recent/2");
    driver.settle();
    CHECK(driver.context().document.title() == "two.forefront");
    CHECK(driver.context().settings.recentFiles.front() == (place.path / "two.forefront").string());
    const auto entries = driver.context().actions.find("file.recent")->entries(driver.context());
    REQUIRE(entries.size() == 4);
    CHECK(entries[1].title == "gone.forefront");
    CHECK(entries[1].detail == place.path.string());
    entries[1].run(driver.context());
    CHECK(driver.context().settings.recentFiles.size() == 2);
    CHECK(driver.context().document.title() == "two.forefront");
    entries.back().run(driver.context());
    CHECK(driver.context().settings.recentFiles.empty());
}

TEST_CASE("Log: a click anywhere on an entry with a place goes there") {
    Draughtsman driver;
    driver.context().log.add(
        Diagnostic{.severity = Severity::Warning, .code = "test", .message = "look here", .at = Vec2{3, 2}});
    driver.showPanel("log");
    driver.frames(3);
    const std::string name = "log/entry/" + std::to_string(driver.context().log.entries().back().number);
    REQUIRE(driver.has(name));
    const PixelRect rect = driver.context().widgets.find(name)->rect;
    driver.clickAt({rect.x + 0.8 * rect.width, rect.y + 4.0});
    CHECK(distance(driver.context().view.camera.centre, {3, 2}) < 1e-6);
    CHECK(driver.context().view.flag.has_value());
}

TEST_CASE("History: the panel lists the commands, and clicks move back and forward among them") {
    Draughtsman driver;
    driver.rectangle({0, 0}, {4, 4});
    driver.rectangle({1, 1}, {2, 2});
    driver.rectangle({5, 5}, {6, 6});
    driver.showPanel("history");
    driver.settle();
    CHECK(driver.context().document.history().size() == 4);
    driver.click("history/1");
    CHECK(driver.document().shapes.size() == 1);
    driver.click("history/3");
    CHECK(driver.document().shapes.size() == 3);
    driver.click("history/0");
    CHECK(driver.document().shapes.empty());
    driver.key('Z', {Modifiers::kControl | Modifiers::kShift});
    CHECK(driver.document().shapes.size() == 1);
}

TEST_CASE("Export: a button for each solver chooses its format and says what the file keeps") {
    Draughtsman driver;
    driver.rectangle({0, 0}, {4, 4});
    driver.settle();
    openDialog(driver, "file.export", "export");
    const struct {
        const char *preset, *extension;
    } presets[] = {{"gmsh", ".msh"}, {"freefem", ".mesh"}, {"calculix", ".inp"}, {"abaqus", ".inp"},
                   {"su2", ".su2"},  {"paraview", ".vtu"}, {"triangle", ".node"}};
    const TemporaryFolder place;
    for (const auto &[preset, extension] : presets) {
        CAPTURE(preset);
        if (driver.context().dialogs.top() == nullptr) {
            openDialog(driver, "file.export", "export");
        }
        driver.click(std::string("dialog/export/preset/") + preset);
        CHECK(driver.has("dialog/export/note"));
        driver.click("dialog/export/name");
        driver.key('A', {Modifiers::kControl});
        driver.type((place.path / preset).string());
        driver.click("dialog/export/ok");
        driver.settle();
        CHECK(std::filesystem::exists(place.path / (std::string(preset) + extension)));
    }
}

TEST_CASE("Export: the note on a format is shown whole, also in a narrow window") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {3, 3});
    for (const double scale : {1.0, 2.0}) {
        CAPTURE(scale);
        driver.platform().resize({1280, 800}, scale);
        driver.key('E', {Modifiers::kControl});
        driver.settle();
        driver.click("dialog/export/preset/calculix");
        driver.settle();
        const PixelRect note = driver.context().widgets.find("dialog/export/note")->rect;
        const PixelRect dialog = driver.context().widgets.find("dialog/export")->rect;
        const PixelRect ok = driver.context().widgets.find("dialog/export/ok")->rect;
        const ImFont *font = driver.context().fonts.small;
        constexpr const char *kLetters = "etaoin shrdlu cmfgyp etaoin shrdl etaoin"; // about as frequent as in a text
        const double line = static_cast<double>(font->FontSize),
                     letter = static_cast<double>(font->CalcTextSizeA(font->FontSize, 1e6F, 0.0F, kLetters).x) / 40.0,
                     text = 163.0 * letter; // of 163 letters
        CHECK(note.height >= std::ceil(text / note.width) * line);
        CHECK(note.x + note.width <= dialog.x + dialog.width);
        CHECK(ok.y >= note.y + note.height);
        CHECK(ok.y + ok.height <= dialog.y + dialog.height);
        driver.key(key::kEscape);
    }
}

TEST_CASE("Preferences: every change takes effect at once and is saved") {
    const TemporaryFolder place;
    const EditorSetup setup{.settingsFolder = place.path, .sample = false};
    {
        Driver driver(setup);
        openDialog(driver, "edit.preferences", "preferences");
        driver.click("dialog/preferences/theme/Light");
        CHECK(driver.context().theme.kind == ThemeKind::Light);
        driver.click("dialog/preferences/page/Snapping");
        driver.click("dialog/preferences/snap/grid");
        CHECK_FALSE(driver.context().snapping.toGrid);
        driver.click("dialog/preferences/page/New drawings");
        driver.click("dialog/preferences/new/method/Classic");
        driver.key(key::kEscape);
        driver.key('N', {Modifiers::kControl});
        driver.settle();
        CHECK(driver.context().document.current()->options.method == Method::Classic);
    }
    const Settings saved = loadSettings(place.path / "settings.json");
    CHECK(saved.theme == ThemeKind::Light);
    CHECK_FALSE(saved.snapping.toGrid);
    CHECK(saved.newMethod == Method::Classic);
    Driver again(setup);
    CHECK_FALSE(again.context().snapping.toGrid);
}

TEST_CASE("Keys: no two commands share a key by default") {
    Driver driver;
    for (const Action &action : driver.context().actions.all()) {
        CAPTURE(action.id);
        CHECK(driver.context().actions.conflicts(action).empty());
        for (const Shortcut &shortcut : action.shortcuts) {
            CHECK((parseShortcut(toString(shortcut)) == shortcut));
        }
    }
    CHECK_FALSE(parseShortcut("Hyper+Q").has_value());
    CHECK_FALSE(parseShortcut("").has_value());
}

TEST_CASE("Keys: a command can be given another key, shows a conflict, and returns to its default key") {
    const TemporaryFolder place;
    const EditorSetup setup{.settingsFolder = place.path, .sample = false};
    const std::string row = "dialog/preferences/key/view.fit";
    {
        Driver driver(setup);
        openDialog(driver, "edit.preferences", "preferences");
        driver.click("dialog/preferences/page/Keys");
        driver.click("dialog/preferences/keys/find");
        driver.type("zoom to fit");
        driver.click(row);
        driver.key('G', {Modifiers::kControl});
        CHECK(toString(driver.context().actions.find("view.fit")->shortcuts.front()) == "Ctrl+G");
        driver.click(row);
        driver.key(key::kEscape); // leaves it as it is, and the dialog open
        CHECK(driver.context().dialogs.top() != nullptr);
        CHECK(toString(driver.context().actions.find("view.fit")->shortcuts.front()) == "Ctrl+G");
        driver.click(row);
        driver.key('Z', {Modifiers::kControl});
        driver.frames(2);
        CHECK(driver.has("dialog/preferences/conflict/view.fit"));
        driver.click(row);
        driver.key('G', {Modifiers::kControl});
    }
    Driver driver(setup);
    driver.context().view.zoomAt({400, 400}, 20.0);
    REQUIRE_FALSE(driver.context().view.fitted.has_value());
    driver.key('G', {Modifiers::kControl});
    CHECK(driver.context().view.fitted.has_value());
    openDialog(driver, "edit.preferences", "preferences");
    driver.click("dialog/preferences/page/Keys");
    driver.click("dialog/preferences/keys/reset");
    CHECK(driver.context().settings.keys.empty());
    CHECK(toString(driver.context().actions.find("view.fit")->shortcuts.front()) == "F");
}

TEST_CASE("Views: a file reopens with its last view, layers and panels") {
    const TemporaryFolder place;
    const EditorSetup setup{.settingsFolder = place.path / "settings", .sample = false};
    const std::filesystem::path file = place.path / "square.forefront";
    {
        Draughtsman driver(setup);
        driver.rectangle({0, 0}, {4, 4});
        REQUIRE(writeProject(file, driver.document()).empty());
        REQUIRE(driver.editor().open(file));
        rememberFile(driver.context(), file);
        driver.settle();
        driver.context().view.zoomAt({500, 300}, 7.0);
        driver.context().view.camera.centre = {1.25, 2.5};
        showLayer(driver.context().layers, "quality", true);
        driver.workspace(WorkspaceKind::Step);
        driver.key(key::kTab);
        driver.settle();
    }
    Draughtsman driver(setup);
    CHECK_FALSE(driver.context().view.panels);
    CHECK(driver.context().settings.workspace == WorkspaceKind::Step);
    driver.workspace(WorkspaceKind::Draw);
    CHECK(driver.context().layer("quality")->visible);
    REQUIRE(driver.editor().open(file));
    driver.settle();
    CHECK(driver.context().view.camera.centre == Vec2{1.25, 2.5});
}

TEST_CASE("Recovery: a drawing that was never saved is offered with its title") {
    const TemporaryFolder place;
    const EditorSetup setup{.stateFolder = place.path, .sample = true};
    std::string bytes;
    {
        Driver driver(setup);
        Document changed = *driver.context().document.current();
        changed.spacing.size = 20.0;
        driver.context().document.apply(std::move(changed), "Size");
        driver.settle();
        // The journal is written within a second; it is copied as a crash would leave it.
        driver.until([&] {
            std::error_code missing;
            for (const auto &entry : std::filesystem::directory_iterator(place.path / "recovery", missing)) {
                std::ifstream stream(entry.path(), std::ios::binary);
                bytes.assign(std::istreambuf_iterator<char>(stream), {});
            }
            return bytes.find("\"shapes\"") != std::string::npos;
        });
    }
    std::ofstream(place.path / "recovery" / "1-1.journal", std::ios::binary) << bytes;
    {
        // The program that was killed is still ending, and holds its lock.
        const int held = ::open((place.path / "recovery" / "1-1.journal").c_str(), O_RDWR | O_CLOEXEC);
        REQUIRE(::flock(held, LOCK_EX) == 0);
        Driver driver(setup);
        CHECK(driver.context().dialogs.top() == nullptr);
        ::close(held);
        driver.until([&] { return driver.context().dialogs.top() != nullptr; });
        CHECK(std::string(driver.context().dialogs.top()->id()) == "recovery");
    }
    Driver driver(setup);
    REQUIRE(driver.context().dialogs.top() != nullptr);
    CHECK(std::string(driver.context().dialogs.top()->id()) == "recovery");
    driver.key(key::kEnter); // as for the main button of every question
    driver.settle();
    REQUIRE(driver.context().dialogs.top() == nullptr);
    CHECK(driver.context().document.title() == "Harbour with a pier");
    CHECK(driver.context().document.dirty());
}

TEST_CASE("Recovery: what is not recovered at once stays on the start page, with its picture") {
    const TemporaryFolder place;
    const EditorSetup setup{.stateFolder = place.path, .sample = false, .startPage = true};
    std::filesystem::create_directories(place.path / "recovery");
    {
        RecoveryJournal journal(place.path / "recovery", projectText);
        Document drawing;
        Shape shape;
        shape.id = drawing.nextId++;
        shape.form = formOf(ShapeKind::Rectangle);
        shape.nodes = {{0, 0}, {4, 3}};
        drawing.shapes.push_back(std::make_shared<const Shape>(shape));
        journal.record(std::make_shared<const Document>(drawing), {.savedAt = {}, .title = "Bracket"});
        journal.flush();
        std::filesystem::copy_file(journal.file(), place.path / "recovery" / "1-1.journal");
    }
    Driver driver(setup);
    REQUIRE(driver.has("dialog/recovery/later"));
    driver.click("dialog/recovery/later");
    driver.settle();
    REQUIRE(driver.has("start/recent/1-1"));
    driver.click("start/recent/1-1");
    driver.settle();
    CHECK(driver.context().document.title() == "Bracket");
    CHECK(driver.context().document.dirty());
    CHECK(driver.context().document.current()->shapes.size() == 1);
    CHECK(driver.context().unsaved.empty());
    CHECK_FALSE(std::filesystem::exists(place.path / "recovery" / "1-1.journal"));
}

TEST_CASE("Names of documents: each new drawing has its own, also beside those to be recovered") {
    Draughtsman driver;
    CHECK(driver.context().document.title() == "Untitled");
    driver.key('N', kControl); // nothing was drawn, so the name is still free
    driver.settle();
    CHECK(driver.context().document.title() == "Untitled");
    driver.rectangle({1, 1}, {5, 5});
    driver.settle();
    driver.key('N', kControl);
    driver.settle();
    driver.click("dialog/unsaved/discard");
    driver.settle();
    CHECK(driver.context().document.title() == "Untitled 2");
    CHECK(driver.platform().title().find("Untitled 2") != std::string::npos);
    DocumentStore store;
    store.reserveTitle("Untitled 2");
    store.reserveTitle("Untitled");
    CHECK(store.title() == "Untitled 3");
    DocumentStore titled;
    titled.load({}, {}, false, "Plate with a hole"); // as at the start of the program
    titled.load({}, {});
    CHECK(titled.title() == "Untitled");
}

TEST_CASE("Record script: what is drawn, sized, undone, meshed and exported is repeated with the same mesh") {
    const TemporaryFolder place;
    Draughtsman driver;
    driver.context().actions.run("file.recordScript", driver.context());
    driver.settle();
    driver.chooseFile("recordscript", place / "day.jsonl");
    driver.rectangle({1, 1}, {9, 8});
    driver.key('C');
    driver.dragPlaces({5, 4.5}, {6, 4.5});
    driver.key('V');
    driver.key(key::kEscape);
    driver.dragPlaces({5, 5.5}, {6, 5.5}); // moves the circle
    driver.showPanel("spacing");
    driver.fill("spacing/size", "0.2");
    driver.key('Z', {Modifiers::kControl});
    driver.fill("spacing/size", "0.7");
    driver.key(key::kF5);
    driver.settle();
    REQUIRE(driver.run().mesh != nullptr);
    const std::uint64_t hash = meshHash(driver.run().mesh->view());
    driver.context().actions.run("file.recordScript", driver.context()); // stops
    driver.settle();

    std::ifstream file(place / "day.jsonl");
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    INFO(text);
    CHECK(text.find(toHex(hash)) != std::string::npos);
    const Document replayed = replayedScript(text);
    CHECK(sameContent(replayed, driver.document()));
    const Result<MeshingOutcome> repeated = meshDomain(jobOf(replayed));
    REQUIRE(repeated.ok());
    CHECK(meshHash(repeated->mesh) == hash);
}

TEST_CASE("Record script: exported meshes and saved projects are in it, by paths from its folder") {
    const TemporaryFolder place, other;
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    CHECK_FALSE(driver.has("status/recording"));
    driver.context().actions.run("file.recordScript", driver.context());
    driver.settle();
    driver.chooseFile("recordscript", place / "day.jsonl");
    CHECK(driver.has("status/recording"));
    driver.key(key::kF5);
    driver.settle();
    for (const std::filesystem::path &file : {place / "day.msh", place / "day.inp", other / "day.su2"}) {
        openDialog(driver, "file.export", "export");
        driver.chooseFile("export", file);
        REQUIRE(std::filesystem::exists(file));
    }
    openDialog(driver, "file.saveAs", "save");
    driver.chooseFile("save", place / "day.forefront");
    driver.settle();
    driver.click("status/recording"); // stops
    driver.settle();
    CHECK_FALSE(driver.has("status/recording"));

    std::ifstream file(place / "day.jsonl");
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    INFO(text);
    CHECK(text.find("\"export\", \"file\": \"day.msh\"") != std::string::npos);
    CHECK(text.find("\"export\", \"file\": \"day.inp\"") != std::string::npos);
    CHECK(text.find("\"export\", \"file\": \"" + (other / "day.su2").string()) != std::string::npos);
    CHECK(text.find("\"save\", \"file\": \"day.forefront\"") != std::string::npos);
}

} // namespace forefront::test
