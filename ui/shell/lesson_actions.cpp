#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/dialogs/glossary_dialog.hpp"
#include "ui/dialogs/tables_dialog.hpp"
#include "ui/lessons/lesson_answers.hpp"
#include "ui/lessons/lesson_list.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/shell/main_window.hpp"

#include <memory>
#include <string>
#include <string_view>

namespace forefront::shell {

namespace {

bool isOpen(const Shell &context) {
    return context.lessons.visible && context.lessons.open.has_value();
}

void chooseLessonFile(Shell &context) {
    FileRequest request;
    request.id = "openlesson";
    request.title = "Open lesson";
    request.action = "Open";
    request.filters = {{"Lessons (.json)", {".json"}, "lesson"}};
    request.folder = startFolder(context);
    request.chosen = [](Shell &c, const std::filesystem::path &file, const FileFilter &) {
        return openLessonFile(c, file);
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

/// Opens the glossary at a term; empty: at the first.
void openGlossary(Shell &context, std::string_view term) {
    context.dialogs.open(std::make_unique<GlossaryDialog>(term));
}

void addGlossaryActions(ActionRegistry &actions) {
    actions.add({.id = "help.glossary",
                 .menu = "Help",
                 .title = "Glossary\xe2\x80\xa6",
                 .shortcuts = {{key::kF1 + 2, kNoModifiers}},
                 .run = [](Shell &c) { openGlossary(c, {}); }});
    for (const GlossaryTerm &term : glossary()) {
        actions.add({.id = "glossary." + std::string(term.id),
                     .menu = "",
                     .title = "Glossary: " + std::string(term.name),
                     .run = [id = term.id](Shell &c) { openGlossary(c, id); }});
    }
}

/// Shows the next page; after the last one, the list of lessons.
void turnPage(Shell &context) {
    const std::size_t next = context.lessons.open->page + 1;
    next < context.lessons.open->entry.lesson->pages.size() ? goToPage(context, next) : finishLesson(context);
}

/// Picks an answer of the open lesson, or a lesson from the list.
void choose(Shell &context, std::size_t index) {
    if (context.lessons.open) {
        answerChoice(context, index);
    } else if (index < context.lessons.list.size()) {
        openLesson(context, LessonEntry(context.lessons.list[index]));
    }
}

/// Moves the keyboard to the field for a number, or picks the tenth lesson from the list.
void typeOrChoose(Shell &context) {
    if (!context.lessons.open) {
        choose(context, 9);
        return;
    }
    context.lessons.open->focus = true;
    context.animate();
}

void addPageActions(ActionRegistry &actions) {
    actions.add({.id = "lesson.next",
                 .menu = "Learn",
                 .title = "Next page",
                 .shortcuts = {{key::kPageDown, kNoModifiers}},
                 .run = turnPage,
                 .enabled = isOpen});
    actions.add({.id = "lesson.previous",
                 .menu = "Learn",
                 .title = "Previous page",
                 .shortcuts = {{key::kPageUp, kNoModifiers}},
                 .run = [](Shell &c) { goToPage(c, c.lessons.open->page - 1); },
                 .enabled = [](const Shell &c) { return isOpen(c) && c.lessons.open->page > 0; }});
    actions.add({.id = "lesson.saveAnswers",
                 .menu = "Learn",
                 .title = "Save answers\xe2\x80\xa6",
                 .run = saveAnswers,
                 .enabled = hasAnswersToSave});
    actions.add({.id = "lesson.forgetAnswers",
                 .menu = "Learn",
                 .title = "Forget answers",
                 .run = forgetAnswers,
                 .enabled = [](const Shell &c) { return isOpen(c) && hasAnswersToSave(c); }});
    actions.add(
        {.id = "lesson.close", .menu = "Learn", .title = "Close lesson", .run = closeLesson, .enabled = isOpen});
    for (int k = 0; k < 9; ++k) {
        actions.add({.id = "lesson.choice" + std::to_string(k + 1),
                     .menu = "",
                     .title = "Lessons: choose " + std::to_string(k + 1),
                     .shortcuts = {{key::k0 + 1 + k, kAlt}},
                     .run = [k](Shell &c) { choose(c, static_cast<std::size_t>(k)); },
                     .enabled = [](const Shell &c) { return c.lessons.visible; }});
    }
    actions.add({.id = "lesson.number",
                 .menu = "",
                 .title = "Lessons: type the answer, or choose 10",
                 .shortcuts = {{key::k0, kAlt}},
                 .run = typeOrChoose,
                 .enabled = [](const Shell &c) { return c.lessons.visible; }});
    for (int k = 10; k < 19; ++k) {
        actions.add({.id = "lesson.choice" + std::to_string(k + 1),
                     .menu = "",
                     .title = "Lessons: choose " + std::to_string(k + 1),
                     .shortcuts = {{key::k0 + k - 9, Modifiers{Modifiers::kAlt | Modifiers::kShift}}},
                     .run = [k](Shell &c) { choose(c, static_cast<std::size_t>(k)); },
                     .enabled = [](const Shell &c) { return c.lessons.visible && !c.lessons.open; }});
    }
    actions.add({.id = "lesson.show",
                 .menu = "",
                 .title = "Lesson: show me",
                 .shortcuts = {{'H', kAlt}},
                 .run = showAnswer,
                 .enabled = isOpen});
}

} // namespace

void addLessonActions(ActionRegistry &actions) {
    actions.add({.id = "help.lessons",
                 .menu = "Help",
                 .title = "Lessons",
                 .shortcuts = {{key::kF1 + 3, kNoModifiers}},
                 .run =
                     [](Shell &c) {
                         c.lessons.visible = !c.lessons.visible;
                         c.lessons.drawingLoaded = 0; // what is drawn from now on is the user's
                         c.animate();
                     },
                 .checked = [](const Shell &c) { return c.lessons.visible; }});
    addGlossaryActions(actions);
    actions.add({.id = "learn.lessons", .menu = "Learn", .title = "Lessons", .run = [](Shell &c) {
                     c.lessons.visible = true;
                     c.animate();
                 }});
    actions.add(
        {.id = "learn.openLesson", .menu = "Learn", .title = "Open lesson\xe2\x80\xa6", .run = chooseLessonFile});
    addPageActions(actions);
    actions.add({.id = "learn.tables",
                 .menu = "Learn",
                 .title = "Lo's tables\xe2\x80\xa6",
                 .run = [rows = std::make_shared<TableRows>()](Shell &c) {
                     c.dialogs.open(std::make_unique<TablesDialog>(c.background, rows));
                 }});
    actions.add({.id = "learn.sides",
                 .menu = "Learn",
                 .title = "Compare grids or methods side by side",
                 .run =
                     [](Shell &c) {
                         const bool shown = c.sides.visible && c.sides.mesh() == nullptr;
                         c.sides.close();
                         c.sides.visible = !shown;
                         if (c.sides.visible && c.run.outOfDate()) {
                             c.log.refuse("The drawing has changed since it was meshed; mesh it again to compare");
                         }
                         c.animate();
                     },
                 .enabled = [](const Shell &c) { return c.sides.visible || (c.run.hasRun() && !c.run.showsFile()); },
                 .checked = [](const Shell &c) { return c.sides.visible && c.sides.mesh() == nullptr; },
                 .separatorBefore = true});
}

} // namespace forefront::shell
