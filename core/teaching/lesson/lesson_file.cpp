#include "core/teaching/lesson/lesson_file.hpp"

#include "core/drawing_files/documents.hpp"
#include "core/files/files.hpp"

#include <utility>

namespace forefront {

namespace {

/// Files beyond this size are no lessons.
constexpr std::size_t kMaxBytes = std::size_t{4} << 20U;

} // namespace

SourceText LessonFile::source() const {
    SourceText source;
    source.text = text;
    source.name = path.string();
    source.path = path;
    return source;
}

Result<Lesson> LessonFile::withSeed(std::uint64_t seed, LessonNames names) const {
    names.seed = seed;
    names.document = nullptr;
    names.picture = [this](const std::string &file) {
        const auto known = lesson.pictures.find(file);
        return known == lesson.pictures.end() ? readLessonPicture(path.parent_path() / file) : *known->second;
    };
    Result<Lesson> other = readLesson(source(), names);
    for (std::size_t k = 0; other && k < other->pages.size(); ++k) {
        other->pages[k].document = lesson.pages[k].document;
    }
    return other;
}

Result<LessonFile> readLessonFile(const std::filesystem::path &path, LessonNames names) {
    Result<std::string> bytes = readRegularFile(path, kMaxBytes);
    if (!bytes) {
        return bytes.faults();
    }
    LessonFile file{path, *std::move(bytes), {}};
    names.document = [folder = path.parent_path()](const std::string &name) {
        ImportOptions options;
        options.regularFile = true;
        return readDocument(folder / name, options);
    };
    names.picture = [folder = path.parent_path()](const std::string &picture) {
        return readLessonPicture(folder / picture);
    };
    Result<Lesson> lesson = readLesson(file.source(), names);
    if (!lesson) {
        return lesson.faults();
    }
    file.lesson = *std::move(lesson);
    return file;
}

} // namespace forefront
