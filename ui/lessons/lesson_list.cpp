#include "ui/lessons/lesson_list.hpp"

#include "core/drawing/document/equality.hpp"
#include "core/teaching/lesson/lesson_file.hpp"
#include "ui/lessons/highlight_names.hpp"
#include "ui/lessons/lesson_answers.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/parts/shell.hpp"
#include "ui/platform/assets.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns the seed of the random numbers of a lesson.
std::uint64_t seedOf(const Shell &context, const std::string &id) {
    const auto progress = context.settings.lessons.find(id);
    return progress == context.settings.lessons.end() ? LessonProgress().seed : progress->second.seed;
}

} // namespace

bool sameLesson(const LessonEntry &a, const LessonEntry &b) {
    const auto sameDrawing = [](const LessonPage &one, const LessonPage &other) {
        return one.document == other.document ||
               (one.document && other.document && sameContent(*one.document, *other.document));
    };
    return a.lesson == b.lesson || (a.textHash == b.textHash && a.lesson->seed == b.lesson->seed &&
                                    std::equal(a.lesson->pages.begin(), a.lesson->pages.end(), b.lesson->pages.begin(),
                                               b.lesson->pages.end(), sameDrawing));
}

Result<LessonEntry> loadLesson(const Shell &context, const std::string &id, const std::filesystem::path &file,
                               std::uint64_t seed) {
    LessonNames names;
    names.seed = seed;
    for (const LayerSlot &slot : context.layers) {
        names.layers.emplace_back(slot.layer->id());
    }
    for (const auto &panel : context.panels) {
        names.panels.emplace_back(panel->id());
    }
    names.widgets = highlightNames(context);
    Result<LessonFile> read = readLessonFile(file, std::move(names));
    if (!read) {
        return read.faults();
    }
    return LessonEntry{id, file, std::make_shared<const Lesson>(std::move(read->lesson)),
                       std::hash<std::string>()(read->text)};
}

void listLessons(Shell &context) {
    if (std::exchange(context.lessons.listed, true)) {
        return;
    }
    for (const std::filesystem::path &file : lessonFiles()) {
        const std::string id = file.stem().string();
        Result<LessonEntry> entry = loadLesson(context, id, file, seedOf(context, id));
        if (!entry) {
            context.log.add(entry.faults());
            continue;
        }
        context.lessons.list.push_back(*std::move(entry));
    }
}

Diagnostics openLessonFile(Shell &context, const std::filesystem::path &file) {
    listLessons(context);
    std::error_code ignored;
    const std::filesystem::path path = std::filesystem::weakly_canonical(file, ignored);
    const std::vector<LessonEntry> &list = context.lessons.list;
    const auto own = std::find_if(list.begin(), list.end(), [&](const LessonEntry &known) {
        return std::filesystem::equivalent(known.file, file, ignored);
    });
    const std::string id = own != list.end() ? own->id : path.string();
    Result<LessonEntry> entry = loadLesson(context, id, file, seedOf(context, id));
    if (!entry) {
        return entry.faults();
    }
    const auto open = [entry = *entry](Shell &c) {
        std::erase_if(c.lessons.list, [&](const LessonEntry &known) { return known.id == entry.id; });
        c.lessons.list.push_back(entry);
        openLesson(c, entry);
    };
    const auto answers = context.lessons.answers.find(id);
    if (answers != context.lessons.answers.end() && !sameLesson(answers->second.lesson, *entry)) {
        afterUnsavedAnswers(context, *entry,
                            "The lesson \"" + entry->lesson->title +
                                "\" has changed, and your answers belong to its earlier version.",
                            "Open without them", open);
    } else {
        open(context);
    }
    return {};
}

} // namespace forefront
