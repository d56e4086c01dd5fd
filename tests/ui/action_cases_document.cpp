#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/files/files.hpp"
#include "tests/support/two_counties.hpp"
#include "tests/ui/action_cases.hpp"

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

std::size_t tabs(D &d) {
    return d.context().tabs.size();
}

/// Draws a triangle and opens a second, empty tab.
void drawTwoTabs(D &d) {
    drawTriangle(d);
    d.key('T', {Modifiers::kControl});
    d.settle();
}

std::vector<ActionCase> fileCases() {
    return {{"file.new", drawTriangle, [](D &d, const B &) { return dialogIs(d, "unsaved"); }},
            {"file.open", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "open"); }},
            {"file.openMesh", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "openmesh"); }},
            {"file.compareMesh", drawMesh, [](D &d, const B &) { return dialogIs(d, "comparemesh"); }},
            {"file.recent", [](D &d) { d.context().settings.recentFiles = {"/bay/lake.forefront"}; },
             [](D &d, const B &) { return d.has("menu/file.recent/0"); }},
            {"file.newTab", drawTriangle, [](D &d, const B &) { return tabs(d) == 2 && d.document().shapes.empty(); }},
            {"file.openInTab", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "opentab"); }},
            {"file.tabs", drawTwoTabs, [](D &d, const B &) { return d.has("menu/file.tabs/1"); }},
            {"file.nextTab", drawTwoTabs, [](D &d, const B &) { return !d.document().shapes.empty(); }},
            {"file.previousTab", drawTwoTabs, [](D &d, const B &) { return !d.document().shapes.empty(); }},
            {"file.closeTab", drawTwoTabs, [](D &d, const B &) { return tabs(d) == 1; }},
            {"file.samples", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "gallery"); }},
            {"file.save", drawTriangle, [](D &d, const B &) { return dialogIs(d, "save"); }},
            {"file.saveAs", drawTriangle, [](D &d, const B &) { return dialogIs(d, "save"); }},
            {"file.reload",
             [](D &d) {
                 d.rectangle({1, 1}, {9, 8});
                 d.context().document.markSaved("/no/such/folder/bay.forefront");
             },
             [](D &d, const B &) { return d.logHas("cannot-read"); }},
            {"file.import", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "import"); }},
            {"file.importSpacing", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "importspacing"); }},
            {"file.addRaster", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "addraster"); }},
            {"file.openRules", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "openrules"); }},
            {"file.saveRules", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "saverules"); }},
            {"file.addPicture", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "picture"); }},
            {"file.export", drawMesh, [](D &d, const B &) { return dialogIs(d, "export"); }},
            {"file.exportPicture", drawMesh, [](D &d, const B &) { return dialogIs(d, "export"); }},
            {"file.exportMoment", drawMesh, [](D &d, const B &) { return dialogIs(d, "moment"); }},
            {"file.exportFilm", drawMesh, [](D &d, const B &) { return dialogIs(d, "film"); }},
            {"file.recordScript", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "recordscript"); }},
            {"file.quit", [](D &) {}, [](D &d, const B &) { return d.context().quit; }}};
}

/// Draws two squares that cross, in one loop that crosses itself.
void drawCrossing(D &d) {
    Shape bow;
    bow.nodes = {{2, 2}, {6, 6}, {6, 2}, {2, 6}};
    drawShapes(d, {bow});
}

void paintSpot(D &d) {
    d.rectangle({1, 1}, {9, 8});
    d.key('B');
    d.dragPlaces({3, 3}, {5, 5});
    d.settle();
}

std::size_t count(D &d) {
    return d.document().shapes.size();
}

std::vector<ActionCase> editCases() {
    return {
        {"edit.undo", drawTriangle, [](D &d, const B &) { return count(d) == 0; }},
        {"edit.redo",
         [](D &d) {
             drawTriangle(d);
             d.key('Z', {Modifiers::kControl});
         },
         [](D &d, const B &) { return count(d) == 1; }},
        {"edit.cut", drawTriangle,
         [](D &d, const B &) { return count(d) == 0 && d.platform().clipboard().find("svg") != std::string::npos; }},
        {"edit.copy", drawTriangle,
         [](D &d, const B &) { return d.platform().clipboard().find("svg") != std::string::npos; }},
        {"edit.paste",
         [](D &d) {
             drawTriangle(d);
             d.key('C', {Modifiers::kControl});
         },
         [](D &d, const B &) { return count(d) == 2; }},
        {"edit.delete", drawTriangle, [](D &d, const B &) { return count(d) == 0; }},
        {"edit.duplicate", drawTriangle,
         [](D &d, const B &b) { return count(d) == 2 && d.context().selection != b.selection; }},
        {"edit.selectBorder",
         [](D &d) {
             d.context().document.apply(twoCounties(), "Map");
             d.context().selection = {.markers = {0}};
         },
         [](D &d, const B &) {
             return d.context().selection.shapes == std::set<std::uint32_t>{1, 3};
         }},
        {"edit.selectAll",
         [](D &d) {
             drawThree(d);
             d.context().selection.clear();
         },
         [](D &d, const B &) { return d.context().selection.shapes.size() == 3; }},
        {"edit.toPath", drawThree,
         [](D &d, const B &) { return d.document().shapes[0]->kind() == ShapeKind::Polygon; }},
        {"edit.repair", drawCrossing, [](D &d, const B &) { return d.context().preview->faults.empty(); }},
        {"edit.clearPaint", paintSpot, [](D &d, const B &) { return d.document().spacing.paint.tiles.empty(); }},
        {"edit.unit", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "unit"); }},
        {"edit.preferences", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "preferences"); }}};
}

/// Returns true if what is typed now goes into a field of the inspector.
bool sizeFollows(D &d, const B &) {
    if (!hasSegmentSizes(d.document())) {
        d.type("0.5");
        d.key(key::kEnter);
        d.settle();
    }
    return hasSegmentSizes(d.document());
}

std::vector<ActionCase> namingCases() {
    return {{"edit.rename", drawTriangle, [](D &d, const B &) { return d.has("naming/name"); }},
            {"edit.setTag", drawTriangle, [](D &d, const B &) { return d.has("naming/name"); }},
            {"edit.setSize", drawTriangle, sizeFollows}};
}

} // namespace

std::vector<ActionCase> documentActionCases() {
    std::vector<ActionCase> cases = fileCases();
    for (auto &&list : {editCases(), namingCases()}) {
        cases.insert(cases.end(), list.begin(), list.end());
    }
    return cases;
}

} // namespace forefront::test
