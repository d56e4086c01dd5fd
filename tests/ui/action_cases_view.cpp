#include "tests/ui/action_cases.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <variant>
#include <vector>

namespace forefront::test {

namespace {

std::vector<ActionCase> cameraCases() {
    return {{"view.fit",
             [](D &d) {
                 drawTriangle(d);
                 d.scroll(d.pixel({2, 2}), 12);
             },
             [](D &d, const B &) {
                 return d.context().view.camera.visible().contains({6, 2});
             }},
            {"view.zoomIn", drawTriangle,
             [](D &d, const B &b) { return d.context().view.camera.zoom > 1.3 * b.camera.zoom; }},
            {"view.zoomOut", drawTriangle,
             [](D &d, const B &b) { return d.context().view.camera.zoom < b.camera.zoom / 1.3; }},
            {"view.zoomSelection",
             [](D &d) {
                 drawThree(d);
                 d.context().selection.shapes = {d.document().shapes[0]->id};
             },
             [](D &d, const B &) {
                 return !d.context().view.camera.visible().contains({9, 8});
             }},
            {"view.present", drawMesh, [](D &d, const B &) { return d.has("presentation/1") && !d.has("menu/File"); }},
            {"view.follow", drawMesh, [](D &d, const B &) { return d.context().view.following; }},
            {"view.firstFault",
             [](D &d) {
                 Shape bow;
                 bow.nodes = {{2, 2}, {6, 6}, {6, 2}, {2, 6}};
                 drawShapes(d, {bow});
             },
             [](D &d, const B &b) { return d.context().log.entries().size() > b.logged; }}};
}

std::vector<ActionCase> interfaceCases() {
    return {
        {"view.panels", [](D &) {}, [](D &d, const B &) { return !d.has("panel/shapes"); }},
        {"view.layers", [](D &) {}, [](D &d, const B &) { return d.has("layer/mesh"); }},
        {"view.log", [](D &) {}, [](D &d, const B &) { return d.has("panel/log"); }},
        {"edit.history", [](D &) {}, [](D &d, const B &) { return d.has("panel/history"); }},
        {"view.rulers", [](D &) {}, [](D &d, const B &b) { return d.context().settings.rulers != b.settings.rulers; }},
        {"view.theme", [](D &) {}, [](D &d, const B &b) { return d.context().settings.theme != b.settings.theme; }},
        {"view.scale", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "scale"); }},
        {"view.palette", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "palette"); }},
        {"view.hints", [](D &) {}, [](D &d, const B &b) { return d.context().settings.hints != b.settings.hints; }},
        {"snap.drawing", [](D &) {},
         [](D &d, const B &b) { return d.context().snapping.toDrawing != b.snapping.toDrawing; }},
        {"snap.grid", [](D &) {}, [](D &d, const B &b) { return d.context().snapping.toGrid != b.snapping.toGrid; }},
        {"snap.guides", [](D &) {},
         [](D &d, const B &b) { return d.context().snapping.toGuides != b.snapping.toGuides; }},
        {"snap.relations", [](D &) {},
         [](D &d, const B &b) { return d.context().snapping.infers != b.snapping.infers; }},
        {"snap.constraints", [](D &) {},
         [](D &d, const B &b) { return d.context().snapping.addsConstraints != b.snapping.addsConstraints; }},
        {"help.shortcuts", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "shortcuts"); }},
        {"help.about", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "about"); }},
        {"help.glossary", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "glossary"); }},
        {"learn.samples", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "gallery"); }}};
}

/// Takes the brush and sets its numbers, in a drawing with a mesh.
void takeBrush(D &d) {
    d.rectangle({1, 1}, {9, 8});
    d.key('B');
    d.fill("options/brush/radius", "1");
    d.fill("options/brush/spacing", "0.1");
    d.moveToPlace({5, 5});
}

/// Returns the number in a field, by copying it.
double fieldValue(D &d, const char *field) {
    d.click(field);
    d.key('A', {Modifiers::kControl});
    d.key('C', {Modifiers::kControl});
    d.frames(3);
    d.key(key::kEscape);
    d.moveToPlace({5, 5});
    d.settle();
    return std::strtod(d.platform().clipboard().c_str(), nullptr);
}

std::vector<ActionCase> brushCases() {
    return {
        {"brush.smaller", takeBrush, [](D &d, const B &) { return fieldValue(d, "options/brush/radius") < 0.9; }},
        {"brush.larger", takeBrush, [](D &d, const B &) { return fieldValue(d, "options/brush/radius") > 1.1; }},
        {"brush.sizeDown", takeBrush, [](D &d, const B &) { return fieldValue(d, "options/brush/spacing") < 0.09; }},
        {"brush.sizeUp", takeBrush, [](D &d, const B &) { return fieldValue(d, "options/brush/spacing") > 0.11; }}};
}

/// Shows the mesh after some of its advances.
void drawPart(D &d) {
    drawMesh(d);
    d.context().run.seek(50);
    d.settle();
}

void drawPartWithStops(D &d) {
    drawPart(d);
    Breakpoints stops;
    stops.set(StopKind::Rejection, true);
    d.context().run.setBreakpoints(stops);
    d.settle();
}

/// Plays a run slowly.
void drawPlaying(D &d) {
    drawMesh(d);
    d.key(key::kHome);
    d.settle();
    d.context().run.setSpeed(0.1);
    d.context().run.togglePlay();
    d.until([&d] { return d.context().run.playing(); }); // else waiting for rest would wait for the whole run
}

std::vector<ActionCase> runCases() {
    return {{"run.mesh", drawTriangle, [](D &d, const B &b) { return d.run().run > b.run && d.run().complete; }},
            {"run.live", [](D &) {}, [](D &d, const B &b) { return d.context().settings.live != b.settings.live; }},
            {"run.play", drawPart, // which may be over before the window comes to rest
             [](D &d, const B &b) { return d.context().run.playing() || d.run().advance > b.advance; }},
            {"run.cancel", drawPlaying,
             [](D &d, const B &) { return d.context().run.cancelling() || !d.context().run.busy(); }},
            {"run.forward", drawPart, [](D &d, const B &b) { return d.run().advance == b.advance + 1; }},
            {"run.back", drawPart, [](D &d, const B &b) { return d.run().advance + 1 == b.advance; }},
            {"run.forward100", drawPart, [](D &d, const B &b) { return d.run().advance == b.advance + 100; }},
            {"run.back100", drawPart, [](D &d, const B &b) { return d.run().advance == 0 && b.advance > 0; }},
            {"run.nextStop", drawPartWithStops,
             [](D &d, const B &b) { return d.run().advance > b.advance && d.run().stop.has_value(); }},
            {"run.previousStop", drawPartWithStops, [](D &d, const B &b) { return d.run().advance < b.advance; }},
            {"run.start", drawPart, [](D &d, const B &) { return d.run().advance == 0; }},
            {"run.end", drawPart, [](D &d, const B &b) { return d.run().advance > b.advance && d.run().complete; }},
            {"run.worst", drawMesh, [](D &d, const B &b) { return d.context().view.camera.centre != b.camera.centre; }},
            {"learn.sides", drawMesh, [](D &d, const B &) { return d.context().sides.visible; }}};
}

/// Opens the first page of a lesson that asks for a number.
void openLesson(D &d) {
    d.key(key::kF1 + 3);
    d.settle();
    d.click("lessons/1-front");
    d.settle();
}

std::size_t page(D &d) {
    return d.context().lessons.open ? d.context().lessons.open->page : 1000;
}

/// Opens the first page of any lesson that fulfils a condition.
template <class Wanted>
void openPage(D &d, Wanted wanted) {
    d.key(key::kF1 + 3);
    d.settle();
    for (const LessonEntry &entry : std::vector<LessonEntry>(d.context().lessons.list)) {
        const auto &pages = entry.lesson->pages;
        const auto found = std::find_if(pages.begin(), pages.end(), wanted);
        if (found == pages.end()) {
            continue;
        }
        d.click("lessons/" + entry.id);
        for (auto page = pages.begin(); page != found; ++page) {
            d.settle();
            d.key(key::kPageDown);
        }
        d.settle();
        return;
    }
}

void openNumber(D &d) {
    openPage(d, [](const LessonPage &page) {
        return page.question && std::holds_alternative<LessonNumber>(page.question->answer);
    });
}

void openShown(D &d) {
    openPage(d, [](const LessonPage &page) { return page.question && page.question->show; });
}

/// Opens the first page of a lesson that asks for a number, and answers it.
void answerNumber(Draughtsman &d) {
    openNumber(d);
    d.key(key::k0, kAlt);
    d.settle();
    d.type("7");
    d.key(key::kEnter);
}

std::vector<ActionCase> lessonCases() {
    return {{"help.lessons", [](D &) {}, [](D &d, const B &) { return d.context().lessons.visible; }},
            {"learn.lessons", [](D &) {}, [](D &d, const B &) { return d.context().lessons.visible; }},
            {"learn.openLesson", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "openlesson"); }},
            {"lesson.next", openLesson, [](D &d, const B &) { return page(d) == 1; }},
            {"lesson.previous",
             [](D &d) {
                 openLesson(d);
                 d.key(key::kPageDown);
                 d.settle();
                 d.key(key::kPageDown);
             },
             [](D &d, const B &) { return page(d) == 1; }},
            {"lesson.saveAnswers", answerNumber, [](D &d, const B &) { return dialogIs(d, "saveanswers"); }},
            {"lesson.forgetAnswers", answerNumber, [](D &d, const B &) { return dialogIs(d, "answers"); }},
            {"learn.tables", [](D &) {}, [](D &d, const B &) { return dialogIs(d, "tables"); }},
            {"lesson.close", openLesson, [](D &d, const B &) { return !d.context().lessons.open.has_value(); }},
            {"lesson.number", openNumber,
             [](D &d, const B &) {
                 d.type("7");
                 d.settle();
                 return d.context().lessons.open && d.context().lessons.open->typed == "7";
             }},
            {"lesson.show", openShown, [](D &d, const B &b) { return d.run().sequence != b.sequence; }}};
}

} // namespace

std::vector<ActionCase> viewActionCases() {
    std::vector<ActionCase> cases = cameraCases();
    for (auto &&list : {interfaceCases(), brushCases(), runCases(), lessonCases()}) {
        cases.insert(cases.end(), list.begin(), list.end());
    }
    return cases;
}

} // namespace forefront::test
