#include "ui/lessons/lesson_answers.hpp"

#include "core/files/text/atomic_file.hpp"
#include "core/teaching/lesson/answers.hpp"
#include "core/teaching/lesson/random_numbers.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/parts/shell.hpp"

#include <filesystem>
#include <memory>
#include <utility>

namespace forefront {

void recordAnswer(Shell &context, std::string text, bool right) {
    const OpenLesson &open = *context.lessons.open;
    LessonAnswers &answers =
        context.lessons.answers.try_emplace(open.entry.id, noAnswers(*open.entry.lesson)).first->second;
    PageAnswers &page = answers.pages[open.page];
    page.question = withValues(open.now().question->text, questionState(context));
    page.answers.push_back({std::move(text), right});
}

bool hasAnswersToSave(const Shell &context) {
    if (!context.lessons.open) {
        return false;
    }
    const auto answers = context.lessons.answers.find(context.lessons.open->entry.id);
    return answers != context.lessons.answers.end() && hasAnswers(answers->second);
}

void saveAnswers(Shell &context) {
    if (!hasAnswersToSave(context)) {
        return;
    }
    const LessonEntry &entry = context.lessons.open->entry;
    FileRequest request;
    request.id = "saveanswers";
    request.title = "Save answers";
    request.action = "Save";
    request.saves = true;
    request.filters = {{"Answers to a lesson (.json)", {".json"}, "answers"}};
    request.folder = startFolder(context);
    request.name = entry.file.stem().string() + "-answers.json";
    request.chosen = [text = answersText(context.lessons.answers.at(entry.id))](
                         Shell &c, const std::filesystem::path &file, const FileFilter &) {
        Status status = notRegular(file);
        if (status.empty()) {
            status = writeFileAtomically(file, text);
        }
        if (status.empty()) {
            c.log.announce("Saved answers to " + file.string());
        }
        return status;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

void chooseOtherNumbers(Shell &context) {
    const LessonEntry entry = context.lessons.open->entry;
    LessonProgress &progress = context.settings.lessons[entry.id];
    const std::uint64_t seed = progress.seed % static_cast<std::uint64_t>(kMaxLessonSeed) + 1;
    Result<Lesson> lesson = loadLesson(context, entry.file, seed);
    if (!lesson) {
        context.log.add(lesson.faults());
        return;
    }
    const std::size_t page = context.lessons.open->page;
    if (page >= lesson->pages.size()) {
        context.log.refuse("The lesson has fewer pages than before; close it and open it again");
        return;
    }
    progress.seed = seed;
    progress.answered.clear();
    context.lessons.answers.erase(entry.id);
    const auto shared = std::make_shared<const Lesson>(*std::move(lesson));
    for (LessonEntry &known : context.lessons.list) {
        known.lesson = known.id == entry.id ? shared : known.lesson;
    }
    context.lessons.open->entry.lesson = shared;
    goToPage(context, page);
}

} // namespace forefront
