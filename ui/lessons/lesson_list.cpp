#include "ui/lessons/lesson_list.hpp"

#include "core/engine/base/hash.hpp"
#include "core/files/source/source.hpp"
#include "core/teaching/lesson/lesson_file.hpp"
#include "ui/lessons/highlight_names.hpp"
#include "ui/lessons/kept_answers.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/parts/shell.hpp"
#include "ui/platform/assets.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr std::size_t kMaxDrawing = std::size_t{64} << 20; ///< bytes

/// Returns a text that differs between versions of a lesson: of its file, or of the files of its drawings and images.
std::string editionOf(const LessonFile &file) {
    std::set<std::string> drawings;
    for (const LessonPage &page : file.lesson.pages) {
        drawings.insert(page.documentName);
    }
    Hash64 hash;
    hash.add(file.text);
    for (const std::string &drawing : drawings) {
        const Result<std::string> bytes = readRegularFile(file.path.parent_path() / drawing, kMaxDrawing);
        hash.add(drawing);
        hash.add(bytes ? *bytes : std::string());
    }
    for (const auto &[name, picture] : file.lesson.pictures) {
        hash.add(name);
        hash.add(picture->bytes);
    }
    return toHex(hash.value());
}

/// Returns the seed of the random numbers of a lesson: that of its answers, if there are some.
std::uint64_t seedOf(Shell &context, const std::string &id) {
    if (const LearnerAnswers *const known = answersTo(context, id); known != nullptr && known->given.seed > 0) {
        return known->given.seed;
    }
    const auto progress = context.settings.lessons.find(id);
    return progress == context.settings.lessons.end() ? LessonProgress().seed : progress->second.seed;
}

} // namespace

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
    std::string edition = editionOf(*read);
    return LessonEntry{id, file, std::make_shared<const Lesson>(std::move(read->lesson)), std::move(edition)};
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
    openLesson(context, *entry);
    return {};
}

} // namespace forefront
