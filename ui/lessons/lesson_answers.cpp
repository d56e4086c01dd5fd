#include "ui/lessons/lesson_answers.hpp"

#include "core/files/text/atomic_file.hpp"
#include "core/teaching/lesson/answers.hpp"
#include "core/teaching/lesson/random_numbers.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/dialogs/question_dialog.hpp"
#include "ui/lessons/kept_answers.hpp"
#include "ui/lessons/lesson_list.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/parts/shell.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace forefront {

namespace {

/// Returns the name that a file of answers to a lesson gets at first.
std::string answersName(const std::string &id) {
    const std::filesystem::path path(id);
    return (path.has_parent_path() ? path.stem().string() : id) + "-answers.json";
}

/// Asks for a file, writes the answers to a lesson, and then runs `then`.
void saveThen(Shell &context, const std::string &id, const std::function<void(Shell &)> &then) {
    FileRequest request;
    request.id = "saveanswers";
    request.title = "Save answers";
    request.action = "Save";
    request.saves = true;
    request.filters = {{"Answers to a lesson (.json)", {".json"}, "answers"}};
    request.folder = startFolder(context);
    request.name = answersName(id);
    request.chosen = [id, then, text = answersText(context.lessons.answers.at(id).given)](
                         Shell &c, const std::filesystem::path &file, const FileFilter &) {
        Status status = notRegular(file);
        if (status.empty()) {
            status = writeFileAtomically(file, text);
        }
        if (status.empty()) {
            c.log.announce("Saved answers to " + file.string());
            if (const auto known = c.lessons.answers.find(id); known != c.lessons.answers.end()) {
                known->second.saved = true;
            }
            if (then) {
                then(c);
            }
        }
        return status;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

/// Shows the page again with the random numbers of another seed.
void drawNumbers(Shell &context) {
    if (!context.lessons.open) {
        return;
    }
    LessonProgress &progress = context.settings.lessons[context.lessons.open->entry.id];
    const std::uint64_t seed = progress.seed % static_cast<std::uint64_t>(kMaxLessonSeed) + 1;
    const Result<LessonEntry> drawn =
        loadLesson(context, context.lessons.open->entry.id, context.lessons.open->entry.file, seed);
    if (!drawn) {
        context.log.add(drawn.faults());
        return;
    }
    const std::size_t page = context.lessons.open->page;
    if (page >= drawn->lesson->pages.size()) {
        context.log.refuse("The lesson has fewer pages than before; close it and open it again");
        return;
    }
    progress.seed = seed;
    dropAnswers(context, drawn->id);
    for (LessonEntry &known : context.lessons.list) {
        if (known.id == drawn->id) {
            known = *drawn;
        }
    }
    context.lessons.open->entry = *drawn;
    goToPage(context, page);
}

/// Returns the id of the lesson that is open, or was open last.
const std::string &lessonInHand(const Shell &context) {
    return context.lessons.open ? context.lessons.open->entry.id : context.lessons.last;
}

/// Returns the answer that a page shows again: the last right one, else the last one.
const GivenAnswer &answerToShow(const PageAnswers &page) {
    const auto right = std::find_if(page.answers.rbegin(), page.answers.rend(),
                                    [](const GivenAnswer &answer) { return answer.right; });
    return right == page.answers.rend() ? page.answers.back() : *right;
}

/// Shows a choice or a number again, unless it is no answer to the question as it is now.
void restore(OpenLesson &open, const GivenAnswer &given, const LessonState &state) {
    const LessonQuestion &question = *open.now().question;
    bool right = !given.right;
    if (const auto *choices = std::get_if<LessonChoices>(&question.answer)) {
        for (std::size_t k = 0; k < choices->list.size(); ++k) {
            if (withValues(choices->list[k].text, state) == given.text) {
                open.picked = k;
                open.hint = hintAfter(question, k);
                right = isRight(*choices, k, state);
                break;
            }
        }
    } else if (const auto *number = std::get_if<LessonNumber>(&question.answer)) {
        if (const std::optional<double> typed = answeredNumber(given.text)) {
            open.typed = given.text;
            open.hint = hintAfter(question, *typed, state);
            right = isRight(*number, *typed, state);
        }
    }
    if (right != given.right) {
        open.picked.reset();
        open.typed.clear();
        open.hint = question.hint;
        return;
    }
    open.reply = right ? OpenLesson::Reply::Right : OpenLesson::Reply::Wrong;
}

} // namespace

void recordAnswer(Shell &context, std::string text, bool right) {
    const OpenLesson &open = *context.lessons.open;
    PageAnswers &page = openAnswers(context, open.entry).given.pages[open.page];
    page.question = withValues(open.now().question->text, questionState(context));
    page.answers.push_back({std::move(text), right});
    keepAnswers(context, open.entry.id);
}

void recordShown(Shell &context) {
    const OpenLesson &open = *context.lessons.open;
    PageAnswers &page = openAnswers(context, open.entry).given.pages[open.page];
    if (!page.shown && !hasRightAnswer(page)) {
        page.shown = true;
        page.question = withValues(open.now().question->text, questionState(context));
        keepAnswers(context, open.entry.id);
    }
}

void restoreAnswer(Shell &context) {
    OpenLesson &open = *context.lessons.open;
    if (open.restored || !open.arrived) {
        return;
    }
    open.restored = true;
    const LearnerAnswers *const known = knownAnswers(context, open.entry.id);
    if (known == nullptr || !open.now().question || open.reply != OpenLesson::Reply::None) {
        return;
    }
    const PageAnswers &page = known->given.pages[open.page];
    if (!std::holds_alternative<LessonTask>(open.now().question->answer)) {
        if (!page.answers.empty()) {
            restore(open, answerToShow(page), pageState(context));
        }
    } else if (hasRightAnswer(page)) {
        open.before = "Done before, at " + answerToShow(page).text;
    } else if (page.shown) {
        open.before = "Shown before, not done";
    }
}

bool hasAnswersToSave(const Shell &context) {
    return knownAnswers(context, lessonInHand(context)) != nullptr;
}

void saveAnswers(Shell &context) {
    saveAnswersTo(context, lessonInHand(context));
}

void saveAnswersTo(Shell &context, const std::string &id) {
    if (answersTo(context, id) != nullptr) {
        saveThen(context, id, {});
    }
}

void afterUnsavedAnswers(Shell &context, const LessonEntry &entry, const std::string &why, const std::string &verb,
                         std::function<void(Shell &)> then) {
    const LearnerAnswers *const answers = answersTo(context, entry.id);
    if (answers == nullptr || answers->saved) {
        then(context);
        return;
    }
    context.dialogs.open(std::make_unique<QuestionDialog>(
        "answers", "Save your answers?", why + " They have not been saved as a file, and will be forgotten.",
        std::vector<QuestionDialog::Answer>{
            {"cancel", "Cancel", false, {}},
            {"forget", verb, false, then},
            {"save", "Save\xe2\x80\xa6", true, [id = entry.id, then](Shell &c) { saveThen(c, id, then); }}}));
}

void afterEarlierAnswers(Shell &context, const LessonEntry &entry, std::function<void(Shell &)> then) {
    const LearnerAnswers *const answers = answersTo(context, entry.id);
    if (answers == nullptr || belongTo(answers->given, entry)) {
        then(context);
        return;
    }
    afterUnsavedAnswers(context, entry,
                        "The lesson \"" + entry.lesson->title +
                            "\" has changed, and your answers belong to its earlier version.",
                        "Open without them", std::move(then));
}

void forgetAnswers(Shell &context) {
    afterUnsavedAnswers(context, context.lessons.open->entry, "The lesson begins anew, without your answers.",
                        "Forget answers", [](Shell &c) {
                            if (c.lessons.open) {
                                dropAnswers(c, c.lessons.open->entry.id);
                                goToPage(c, 0);
                            }
                        });
}

void chooseOtherNumbers(Shell &context) {
    afterUnsavedAnswers(context, context.lessons.open->entry,
                        "Your answers belong to the numbers of seed " +
                            std::to_string(context.lessons.open->entry.lesson->seed) + '.',
                        "Other numbers", drawNumbers);
}

} // namespace forefront
