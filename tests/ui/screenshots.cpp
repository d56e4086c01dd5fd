#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "tests/support/two_counties.hpp"
#include "tests/ui/edit_driver.hpp"
#include "tests/ui/shot.hpp"
#include "ui/dialogs/changed_file.hpp"
#include "ui/dialogs/import_dialog.hpp"
#include "ui/dialogs/picture_spacing.hpp"
#include "ui/dialogs/recovery.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/platform/assets.hpp"
#include "ui/widgets/widgets.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace forefront::test {

void importBracket(Driver &driver) {
    Result<std::unique_ptr<ImportDialog>> dialog = ImportDialog::open(assetFolder() / "samples/bracket.json", {});
    REQUIRE(dialog.ok());
    driver.context().dialogs.open(std::move(dialog).value());
}

void offerCombination(Driver &driver) {
    Shell &context = driver.context();
    context.actions.run("file.new", context);
    driver.settle();
    Shape left, right;
    left.form = right.form = formOf(ShapeKind::Rectangle);
    left.nodes = {{0, 0}, {6, 4}};
    right.nodes = {{4, 2}, {9, 7}};
    context.document.apply(*addShapes({}, {left, right}), "Draw");
    driver.settle();
    context.actions.run("view.fit", context);
    context.actions.run("edit.combine", context);
}

namespace {

/// Opens the dialog for a picture with dark rings.
void importRings(Driver &driver) {
    GreyPicture picture{4000, 2600, 500, 325, {}};
    for (int row = 0; row < 325; ++row) {
        for (int column = 0; column < 500; ++column) {
            const double radius = std::hypot(column - 250, row - 160);
            picture.values.push_back(radius > 240.0 ? kNoGrey : 0.5 + 0.5 * std::sin(0.05 * radius));
        }
    }
    Shell &context = driver.context();
    context.dialogs.open(std::make_unique<PictureSpacingDialog>(context, "sizes.png", std::move(picture)));
}

/// Shows a drawing with regions and a box source.
void showRegions(Driver &driver) {
    Shell &context = driver.context();
    context.actions.run("file.new", context);
    driver.settle();
    const auto shape = [](ShapeKind kind, ShapeUse use, std::vector<Vec2> nodes) {
        Shape item;
        item.form = formOf(kind);
        item.use = use;
        item.nodes = std::move(nodes);
        return item;
    };
    constexpr ShapeUse kOutline = ShapeUse::Boundary, kInner = ShapeUse::Constraint;
    Document drawing =
        *addShapes({}, {shape(ShapeKind::Polygon, kOutline, {{0, 0}, {5, 0}, {9, 0}, {9, 6}, {5, 6}, {0, 6}}),
                        shape(ShapeKind::Circle, kOutline, {{2.5, 3}, {3.3, 3}}),
                        shape(ShapeKind::Circle, kInner, {{2.5, 3}, {4.2, 3}}),
                        shape(ShapeKind::Polyline, kInner, {{5, 0}, {5.5, 3}, {5, 6}}),
                        shape(ShapeKind::Rectangle, kInner, {{6.5, 1}, {8, 2.5}})});
    drawing.regionNames = {{2, "steel"}, {3, "resin"}};
    drawing.regionMarkers = {{{2.5, 4.3}, 2, 0.0, 0.15}, {{6.5, 4.5}, 3}, {{1, 5.5}, 4}};
    drawing.spacing.sources = {{SourceShape::Box, {6, 3.2}, {8.2, 5.0}, 0.0, 0.12, 0.2, "wake", {}, 20.0}};
    drawing.spacing.keepAutomatic = true;
    context.document.apply(drawing, "Draw");
    driver.settle();
    context.actions.run("view.fit", context);
    showLayer(context.layers, "size", false);
    context.selection.clear();
    context.selection.markers = {0};
}

/// Returns the open drawing, meshed by the classic method with these rules.
Document ruledBy(const Shell &context, const FrontRules &rules) {
    Document ruled = *context.document.current();
    ruled.options.method = Method::Classic;
    ruled.options.rules = rules;
    return ruled;
}

/// Runs a small row of Lo's tables in their dialog.
void runTable(Driver &driver) {
    driver.context().actions.run("learn.tables", driver.context());
    driver.settle();
    for (const char *other : {"row/1B", "row/2A", "row/2B", "grid/none"}) {
        driver.click(std::string("dialog/tables/") + other);
    }
    driver.click("dialog/tables/run");
    driver.settle();
}

/// Offers a drawing that was unsaved when another program crashed.
void offerRecovery(Driver &driver) {
    static const testing::TemporaryFolder place;
    const std::filesystem::path folder = place / "recovery";
    RecoveryJournal journal(folder, projectText);
    journal.record(driver.context().document.current(), {.savedAt = {}, .title = "Old harbour"});
    journal.flush();
    const std::filesystem::path file = journal.file();
    std::filesystem::copy_file(file, folder / ("0" + file.filename().string()),
                               std::filesystem::copy_options::overwrite_existing);
    static Recovery recovery(place.path);
    recovery.offer(driver.context());
}

/// Opens tabs with drawings of different names, one of them too long for its tab.
void openTabs(Driver &driver) {
    Shell &context = driver.context();
    const Document drawing = *context.document.current();
    for (const char *title : {"Bracket", "Harbour with a long name that a tab cannot show whole, version 7", "Plate"}) {
        context.tabs.open(context);
        context.document.load(drawing, {}, title[0] != 'P', title);
        driver.settle();
    }
    driver.key(key::kPageUp, {Modifiers::kControl});
}

/// Picks a county of a map, and points at its neighbour.
void pickCounty(Driver &driver) {
    Shell &context = driver.context();
    context.actions.run("file.new", context);
    driver.settle();
    context.document.apply(twoCounties({1, 2}), "Import");
    context.tools.choose("select", context);
    context.actions.run("view.fit", context);
    driver.settle();
    driver.clickAt(context.view.camera.toPixel({2, 4}));
    driver.settle();
    driver.moveTo(context.view.camera.toPixel({8, 4}));
}

std::vector<Shot> scenes() {
    const auto panel = [](const char *id) { return [id](Driver &driver) { driver.showPanel(id); }; };
    const auto action = [](const char *id) {
        return [id](Driver &driver) { driver.context().actions.run(id, driver.context()); };
    };
    const auto operation = [](const char *id) {
        return [id](Driver &driver) {
            Shell &context = driver.context();
            context.selection.clear();
            context.selection.shapes = {context.document.current()->shapes.front()->id};
            driver.settle();
            context.actions.run(id, context);
        };
    };
    const auto rightClick = [](Vec2 place) {
        return [place](Driver &driver) {
            driver.context().selection.clear();
            const Pixel at = driver.context().view.camera.toPixel(place);
            driver.moveTo(at);
            driver.press(at, MouseButton::Right);
            driver.release(at, MouseButton::Right);
        };
    };
    const auto preferences = [](const char *page) {
        return [page](Driver &driver) {
            driver.context().actions.run("edit.preferences", driver.context());
            driver.settle();
            driver.click(std::string("dialog/preferences/page/") + page);
        };
    };
    const auto tool = [](const char *id) {
        return [id](Driver &driver) {
            driver.context().tools.choose(id, driver.context());
            driver.settle();
        };
    };
    const auto inspect = [](Driver &driver) {
        driver.click("tool/select");
        driver.context().selection.segments = {{driver.context().document.current()->shapes.front()->id, 0}};
    };
    const auto inspectShape = [](Driver &driver) {
        driver.click("tool/select");
        driver.context().selection.shapes = {driver.context().document.current()->shapes.front()->id};
        showLayer(driver.context().layers, "dimensions", true);
    };
    return {{"meshed", [](Driver &) {}},
            {"inspector", inspect},
            {"rectangle", tool("rectangle")},
            {"polygon", tool("polygon")},
            {"brush", tool("brush")},
            {"source", tool("source")},
            {"picture-tool", tool("picture")},
            {"unfolded",
             [](Driver &driver) {
                 driver.click("tool/select");
                 driver.context().selection.clear();
                 driver.unfoldLayers();
             }},
            {"quality", [](Driver &driver) { showLayer(driver.context().layers, "quality", true); }},
            {"rulers", action("view.rulers")},
            {"dimensions",
             [](Driver &driver) {
                 driver.context().selection.clear();
                 showLayer(driver.context().layers, "size", false);
                 showLayer(driver.context().layers, "dimensions", true);
             }},
            {"dimensions-selected", inspectShape},
            {"steps", panel("steps")},
            {"candidates",
             [](Driver &driver) {
                 driver.context().run.seek(60);
                 driver.showPanel("candidates");
             }},
            {"improvement-front",
             [](Driver &driver) {
                 driver.workspace(WorkspaceKind::Step);
                 driver.context().run.seek(driver.run().known);
             }},
            {"improvement-swap", [](Driver &driver) { driver.context().run.step(Granularity::Advance, 1); }},
            {"improvement-sweep",
             [](Driver &driver) {
                 while (!driver.run().atEnd() &&
                        !(driver.run().improvement && driver.run().improvement->change == ImproveChange::Sweep)) {
                     driver.context().run.step(Granularity::Advance, 1);
                     driver.settle();
                 }
             }},
            {"rules",
             [](Driver &driver) {
                 driver.context().document.apply(ruledBy(driver.context(), {.radius = 2.0}), "Rules");
                 driver.showPanel("rules");
             }},
            {"openrules", action("file.openRules")},
            {"saverules", action("file.saveRules")},
            {"histogram",
             [](Driver &driver) {
                 driver.context().run.seekEnd();
                 driver.showPanel("histogram");
             }},
            {"probe", panel("probe")},
            {"adapt", panel("adapt")},
            {"parameters", panel("parameters")},
            {"nodes",
             [](Driver &driver) {
                 driver.context().actions.run("edit.selectAll", driver.context());
                 driver.showPanel("nodes");
             }},
            {"unit", action("edit.unit")},
            {"statistics", panel("statistics")},
            {"checks", panel("checks")},
            {"log", panel("log")},
            {"names", panel("names")},
            {"shapes", panel("shapes")},
            {"history", panel("history")},
            {"gallery", action("file.samples")},
            {"export", action("file.export")},
            {"film", action("file.exportFilm")},
            {"moment", action("file.exportMoment")},
            {"picturespacing", importRings},
            {"glossary", action("glossary.candidates")},
            {"open", action("file.open")},
            {"openmesh", action("file.openMesh")},
            {"opentab", action("file.openInTab")},
            {"comparemesh", action("file.compareMesh")},
            {"save", action("file.saveAs")},
            {"import", action("file.import")},
            {"importspacing", action("file.importSpacing")},
            {"addraster", action("file.addRaster")},
            {"recordscript", action("file.recordScript")},
            {"picture", action("file.addPicture")},
            {"openlesson", action("learn.openLesson")},
            {"tables", runTable},
            {"savetables",
             [](Driver &driver) {
                 runTable(driver);
                 driver.click("dialog/tables/save");
             }},
            {"importoptions", importBracket},
            {"recovery", offerRecovery},
            {"transform", operation("shape.transform")},
            {"lineararray", operation("shape.linearArray")},
            {"polararray", operation("shape.polarArray")},
            {"combine", offerCombination},
            {"fillet", operation("shape.fillet")},
            {"chamfer", operation("shape.chamfer")},
            {"offset", operation("shape.offset")},
            {"scale", action("view.scale")},
            {"preferences", action("edit.preferences")},
            {"preferences-live", preferences("Live meshing")},
            {"preferences-snapping", preferences("Snapping")},
            {"preferences-new", preferences("New drawings")},
            {"preferences-keys", preferences("Keys")},
            {"shortcuts", action("help.shortcuts")},
            {"palette", action("view.palette")},
            {"about", action("help.about")},
            {"sides",
             [](Driver &driver) {
                 driver.context().run.seek(60);
                 driver.context().actions.run("learn.sides", driver.context());
             }},
            {"guess",
             [](Driver &driver) {
                 driver.context().actions.run("learn.sides", driver.context());
                 driver.key('Q');
             }},
            {"regions", showRegions},
            {"regions-values", [](Driver &driver) { showLayer(driver.context().layers, "size", true); }},
            {"region-tool",
             [](Driver &driver) {
                 showLayer(driver.context().layers, "size", false);
                 driver.click("tool/region");
                 driver.settle();
                 driver.moveTo(driver.context().view.camera.toPixel({7.2, 2.0}));
             },
             true},
            {"source-box",
             [](Driver &driver) {
                 driver.click("tool/select");
                 driver.context().selection.clear();
                 driver.context().selection.sources = {0};
             }},
            {"menu-canvas", rightClick({9.6, 7.0}), true},
            {"menu-shape", rightClick({9.0, 4.0}), true},
            {"menu-region", rightClick({6.5, 4.5}), true},
            {"menu-source", rightClick({6.0, 4.1}), true},
            {"worst", panel("worst")},
            {"unsaved", action("file.new")},
            {"changed", [](Driver &driver) { askAboutChange(driver.context(), FileStamp{}, {}); }},
            {"lessons", action("learn.lessons")},
            {"lesson",
             [](Driver &driver) {
                 driver.context().document.markSaved({});
                 driver.click("lessons/1-front");
             }},
            {"tabs", openTabs},
            {"saveanswers",
             [](Driver &driver) {
                 driver.key(key::k0, kAlt);
                 driver.settle();
                 driver.type("34");
                 driver.key(key::kEnter);
                 driver.settle();
                 driver.context().actions.run("lesson.saveAnswers", driver.context());
             }},
            {"squares",
             [](Driver &driver) {
                 constexpr int kPageOfRefusals = 4;
                 driver.click("lesson/list");
                 driver.settle();
                 driver.scroll(driver.context().widgets.find("lessons/1-front")->rect.centre(), -30.0);
                 driver.settle();
                 driver.click("lessons/13-quadrilaterals");
                 driver.settle();
                 for (int page = 0; page < kPageOfRefusals; ++page) {
                     driver.key(key::kPageDown);
                     driver.settle();
                 }
             }},
            {"squares-cleanup",
             [](Driver &driver) {
                 for (int page = 0; page < 3; ++page) {
                     driver.key(key::kPageDown);
                     driver.settle();
                 }
             }},
            {"answers",
             [](Driver &driver) { // of a lesson with random numbers, when others are chosen
                 const std::vector<LessonEntry> list = driver.context().lessons.list;
                 const auto grid = std::find_if(list.begin(), list.end(),
                                                [](const LessonEntry &entry) { return entry.id == "10-dynamic-grid"; });
                 REQUIRE(grid != list.end());
                 openLesson(driver.context(), *grid);
                 driver.settle();
                 driver.key(key::k0 + 2, kAlt);
                 driver.settle();
                 driver.click("lesson/numbers");
             }},
            {"regions", pickCounty, true}};
}

} // namespace

// Not a test; writes pictures of the panels and dialogs, dark and light, at scales 1 and 2, into the folder that
// FOREFRONT_SCREENSHOTS names: forefront_ui_tests --no-skip -tc='Screenshots*'
TEST_CASE("Screenshots: panels and dialogs" * doctest::skip()) {
    const char *const folder = std::getenv("FOREFRONT_SCREENSHOTS");
    REQUIRE_MESSAGE(folder != nullptr, "set FOREFRONT_SCREENSHOTS to a folder");
    for (const int scale : {1, 2}) {
        for (const ThemeKind theme : {ThemeKind::Dark, ThemeKind::Light}) {
            Driver driver({}, {1280, 800}, scale);
            driver.context().settings.theme = theme;
            driver.context().settings.live = true;
            driver.settle();
            for (const Shot &scene : scenes()) {
                scene.show(driver);
                driver.settle();
                if (!scene.hovers) {
                    driver.moveTo({4, 790});
                    driver.settle();
                }
                writePicture(driver.picture(),
                             std::filesystem::path(folder) /
                                 (std::string(scene.name) + (theme == ThemeKind::Dark ? "-dark" : "-light") +
                                  std::to_string(scale) + ".ppm"));
                if (driver.has("contextmenu")) {
                    driver.key(key::kEscape);
                    driver.settle();
                }
                driver.context().dialogs.dismissPreviews(driver.context());
                driver.context().dialogs.closeAll();
                driver.context().settings.rulers = false;
                showLayer(driver.context().layers, "size", true);
                showLayer(driver.context().layers, "dimensions", false);
                driver.settle();
            }
        }
    }
}

} // namespace forefront::test
