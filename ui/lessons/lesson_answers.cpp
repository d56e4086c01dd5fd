#include "ui/lessons/lesson_answers.hpp"

#include "core/files/text/atomic_file.hpp"
#include "core/teaching/lesson/answers.hpp"
#include "core/teaching/lesson/random_numbers.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/dialogs/question_dialog.hpp"
#include "ui/lessons/lesson_list.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/parts/shell.hpp"

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Asks for a file, writes the answers to a lesson, and then runs `then`.
void saveAnswersTo(Shell &context, const std::string &id, const std::function<void(Shell &)> &then) {
    const LearnerAnswers &answers = context.lessons.answers.at(id);
    FileRequest request;
    request.id = "saveanswers";
    request.title = "Save answers";
    request.action = "Save";
    request.saves = true;
    request.filters = {{"Answers to a lesson (.json)", {".json"}, "answers"}};
    request.folder = startFolder(context);
    request.name = answers.lesson.file.stem().string() + "-answers.json";
    request.chosen = [id, then, text = answersText(answers.given)](Shell &c, const std::filesystem::path &file,
                                                                   const FileFilter &) {
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
    progress.answered.clear();
    context.lessons.answers.erase(drawn->id);
    for (LessonEntry &known : context.lessons.list) {
        if (known.id == drawn->id) {
            known = *drawn;
        }
    }
    context.lessons.open->entry = *drawn;
    goToPage(context, page);
}

} // namespace

void recordAnswer(Shell &context, std::string text, bool right) {
    const OpenLesson &open = *context.lessons.open;
    LearnerAnswers &answers =
        context.lessons.answers.try_emplace(open.entry.id, LearnerAnswers{noAnswers(*open.entry.lesson), open.entry})
            .first->second;
    PageAnswers &page = answers.given.pages[open.page];
    page.question = withValues(open.now().question->text, questionState(context));
    page.answers.push_back({std::move(text), right});
    answers.saved = false;
}

bool hasAnswersToSave(const Shell &context) {
    if (!context.lessons.open) {
        return false;
    }
    const auto answers = context.lessons.answers.find(context.lessons.open->entry.id);
    return answers != context.lessons.answers.end() && hasAnswers(answers->second.given);
}

void saveAnswers(Shell &context) {
    if (hasAnswersToSave(context)) {
        saveAnswersTo(context, context.lessons.open->entry.id, {});
    }
}

void afterUnsavedAnswers(Shell &context, const LessonEntry &entry, const std::string &why, const std::string &verb,
                         std::function<void(Shell &)> then) {
    const auto answers = context.lessons.answers.find(entry.id);
    if (answers == context.lessons.answers.end() || answers->second.saved || !hasAnswers(answers->second.given)) {
        then(context);
        return;
    }
    context.dialogs.open(std::make_unique<QuestionDialog>(
        "answers", "Save your answers?", why + " They have not been saved, and will be forgotten.",
        std::vector<QuestionDialog::Answer>{
            {"cancel", "Cancel", false, {}},
            {"forget", verb, false, then},
            {"save", "Save\xe2\x80\xa6", true, [id = entry.id, then](Shell &c) { saveAnswersTo(c, id, then); }}}));
}

void chooseOtherNumbers(Shell &context) {
    afterUnsavedAnswers(context, context.lessons.open->entry,
                        "Your answers belong to the numbers of seed " +
                            std::to_string(context.lessons.open->entry.lesson->seed) + '.',
                        "Other numbers", drawNumbers);
}

} // namespace forefront
