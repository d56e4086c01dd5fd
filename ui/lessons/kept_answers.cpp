#include "ui/lessons/kept_answers.hpp"

#include "core/engine/base/hash.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/atomic_file.hpp"
#include "ui/parts/shell.hpp"

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace forefront {

namespace {

constexpr std::size_t kMaxAnswers = std::size_t{16} << 20; ///< bytes

/// Returns the file of the answers to a lesson. Lessons of the user have paths as ids, of which several may end alike.
std::filesystem::path fileOf(const Shell &context, const std::string &id) {
    const std::filesystem::path path(id);
    if (!path.has_parent_path()) {
        return context.lessons.folder / (id + ".json");
    }
    Hash64 hash;
    hash.add(id);
    return context.lessons.folder / (path.stem().string() + '-' + toHex(hash.value()) + ".json");
}

/// Sets a file aside that cannot be read, since the next answer would replace it, and logs why.
void setAside(Shell &context, const std::filesystem::path &file, Diagnostics faults) {
    std::filesystem::path copy = file;
    copy += ".old";
    std::error_code failed;
    std::filesystem::rename(file, copy, failed);
    for (Diagnostic &fault : faults) {
        fault.severity = Severity::Warning;
        fault.message = "cannot use the kept answers: " + fault.message;
        fault.advice = failed ? std::string() : "repair the copy in " + copy.string();
    }
    context.log.add(std::move(faults));
}

Result<LessonAnswers> answersOf(const std::filesystem::path &file, std::string_view text) {
    SourceText source;
    source.name = file.string();
    source.text = text;
    return readAnswers(source);
}

/// Adds the answers that another window has written to the file since this one did. Those to other numbers or another
/// version of the lesson are set aside.
void addOthers(Shell &context, const std::filesystem::path &file, LearnerAnswers &answers) {
    std::error_code none;
    if (!std::filesystem::exists(file, none)) {
        return;
    }
    const Result<std::string> text = readRegularFile(file, kMaxAnswers);
    if (!text || *text == answers.keptText) {
        return; // writing tells why
    }
    Result<LessonAnswers> others = answersOf(file, *text);
    if (!others) {
        setAside(context, file, others.faults());
    } else if (!mergeAnswers(answers.given, answers.kept, *others)) {
        setAside(
            context, file,
            error("other-answers", "another window has answered the lesson with other numbers or in another version"));
    }
}

} // namespace

const LearnerAnswers *knownAnswers(const Shell &context, const std::string &id) {
    const auto known = context.lessons.answers.find(id);
    return known == context.lessons.answers.end() || !hasAnswers(known->second.given) ? nullptr : &known->second;
}

const LearnerAnswers *answersTo(Shell &context, const std::string &id) {
    std::error_code none;
    const std::filesystem::path file = fileOf(context, id);
    if (context.lessons.folder.empty() || !context.lessons.looked.insert(id).second ||
        !std::filesystem::exists(file, none)) {
        return knownAnswers(context, id);
    }
    const Result<std::string> text = readRegularFile(file, kMaxAnswers);
    Result<LessonAnswers> read = text ? answersOf(file, *text) : Result<LessonAnswers>(text.faults());
    if (!read) {
        setAside(context, file, read.faults());
        return knownAnswers(context, id);
    }
    context.lessons.answers.try_emplace(id, LearnerAnswers{*read, false, *read, *text});
    return knownAnswers(context, id);
}

AnswerCount countKnown(const Shell &context, const std::string &id) {
    const LearnerAnswers *const known = knownAnswers(context, id);
    return known == nullptr ? AnswerCount() : countAnswers(known->given);
}

LearnerAnswers &openAnswers(Shell &context, const LessonEntry &entry) {
    const auto [place, isNew] = context.lessons.answers.try_emplace(entry.id);
    if (isNew) {
        place->second.given = noAnswers(*entry.lesson);
        place->second.given.edition = entry.edition;
    }
    place->second.saved = false;
    return place->second;
}

void keepAnswers(Shell &context, const std::string &id) {
    const LearnerAnswers *const known = knownAnswers(context, id);
    if (known == nullptr || context.lessons.folder.empty()) {
        return;
    }
    std::error_code ignored;
    std::filesystem::create_directories(context.lessons.folder, ignored);
    const std::filesystem::path file = fileOf(context, id);
    Status status = notRegular(file);
    if (status.empty()) {
        LearnerAnswers &answers = context.lessons.answers.at(id);
        addOthers(context, file, answers);
        std::string text = answersText(answers.given);
        status = writeFileAtomically(file, text);
        if (status.empty()) {
            answers.kept = answers.given;
            answers.keptText = std::move(text);
        }
    }
    context.log.add(status);
}

void dropAnswers(Shell &context, const std::string &id) {
    context.lessons.answers.erase(id);
    if (!context.lessons.folder.empty()) {
        std::error_code ignored;
        std::filesystem::remove(fileOf(context, id), ignored);
    }
}

bool belongTo(const LessonAnswers &given, const LessonEntry &entry) {
    return given.edition == entry.edition && given.seed == entry.lesson->seed &&
           given.pages.size() == entry.lesson->pages.size();
}

} // namespace forefront
