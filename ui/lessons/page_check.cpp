#include "ui/lessons/page_check.hpp"

#include "core/teaching/lesson/position_check.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/parts/shell.hpp"

#include <optional>
#include <utility>

namespace forefront {

namespace {

/// Logs that a page asks for something that is not there.
void logPage(Shell &context, Severity severity, LessonPlace place, Diagnostic fault) {
    fault.severity = severity;
    fault.file = context.lessons.open->entry.file.string();
    fault.line = place.line;
    fault.column = place.column;
    context.log.add(std::move(fault));
}

/// Checks a position against the run, once its length is known.
void checkPosition(Shell &context, const LessonPosition &position) {
    const SessionSnapshot &run = context.run.now();
    if (!run.complete) {
        return;
    }
    if (std::optional<Diagnostic> fault = beyondEnd(position, run.known, run.improveSteps)) {
        logPage(context, Severity::Warning, position.place, *std::move(fault));
    }
}

void checkPositions(Shell &context, const LessonPage &page) {
    if (!page.document) {
        return;
    }
    checkPosition(context, page.position);
    if (std::optional<Diagnostic> fault = tooManyEvents(page.position, context.run.now())) {
        logPage(context, Severity::Warning, page.position.place, *std::move(fault));
    }
    if (page.question && page.question->show) {
        checkPosition(context, *page.question->show);
    }
}

void checkHighlights(Shell &context, const LessonPage &page) {
    for (const LessonHighlight &highlight : page.highlights) {
        if (context.widgets.find(highlight.widget) == nullptr) {
            // A learner may have hidden its panel, which is no reason to be told so on the canvas.
            logPage(context, Severity::Note, highlight.place,
                    {.code = "lesson-highlight",
                     .message = "nothing to outline: '" + highlight.widget + "' is not on the screen",
                     .advice = "correct the name, or show its panel with \"panel\""});
        }
    }
}

} // namespace

void checkPage(Shell &context) {
    constexpr int kFrames = 4; // until the panel that the page shows is drawn
    OpenLesson &open = *context.lessons.open;
    if (!open.settled || open.checked.contains(open.page) || context.dialogs.any() || lessonIsElsewhere(context)) {
        return;
    }
    context.animate();
    if (open.framesSettled == 0) {
        checkPositions(context, open.now());
    }
    if (++open.framesSettled > kFrames) {
        checkHighlights(context, open.now());
        open.checked.insert(open.page);
    }
}

} // namespace forefront
