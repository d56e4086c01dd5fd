#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/common/names.hpp"
#include "core/teaching/lesson/answers.hpp"
#include "core/teaching/lesson/lesson_run.hpp"

#include <charconv>
#include <map>
#include <string_view>

namespace forefront {

namespace {

constexpr std::string_view kAdvance = "advance ", kCandidate = "candidate ";
constexpr std::size_t kMaxTries = 1000; ///< answers to a question that are checked; a learner gives a few
constexpr std::size_t kMaxShown = 20;   ///< of them in the report

/// Returns the number after a word; nothing if the text is anything else.
std::optional<std::uint64_t> numberAfter(std::string_view word, std::string_view text) {
    std::uint64_t number = 0;
    if (!text.starts_with(word)) {
        return std::nullopt;
    }
    const char *const end = text.data() + text.size();
    const auto [rest, fault] = std::from_chars(text.data() + word.size(), end, number);
    return fault == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

/// Returns true if a state fulfils a task, or would with one of its candidates chosen.
bool fulfils(const LessonTask &task, const SessionSnapshot &run) {
    if (isDone(task, {run, std::nullopt})) {
        return true;
    }
    const std::size_t candidates = asksForCandidate(task) && run.explanation ? run.explanation->candidates.size() : 0;
    for (std::size_t k = 0; k < candidates; ++k) {
        if (isDone(task, {run, k})) {
            return true;
        }
    }
    return false;
}

/// Returns true if the run fulfils a task after that many advances, at an event of the next one, or at its end.
/// Cancelled, it returns false.
bool fulfilsAt(const LessonTask &task, LessonRun &run, std::uint64_t position, const Progress &progress) {
    const bool mesh = asksForMesh(task);
    const auto next = [&](std::int64_t events) { return run.at({.advance = position, .events = events}, mesh); };
    std::shared_ptr<const SessionSnapshot> there = next(0);
    for (std::int64_t events = 1; there->position() == position && !progress.cancelled(); ++events) {
        if (fulfils(task, *there)) {
            return true;
        }
        there = position < run.advances() ? next(events) : run.at({.atEnd = true}, mesh);
        if (position >= run.advances()) {
            return fulfils(task, *there);
        }
    }
    return false;
}

/// Checks the answers to one lesson, page after page.
class AnswerCheck {
  public:
    AnswerCheck(const SourceText &source, LessonRuns &runs, const Progress &progress)
        : source_(source), runs_(runs), progress_(progress) {}

    /// Adds the page to the score, or faults. `from`, `to`: the part of the progress that the page is.
    void page(const LessonPage &page, const PageAnswers &given, AnswerScore &score, double from, double to) {
        SessionSnapshot none;
        std::shared_ptr<const SessionSnapshot> shown(&none, [](const SessionSnapshot *) {});
        std::shared_ptr<LessonRun> run;
        if (page.document) {
            const Result<std::shared_ptr<LessonRun>> made = runs_.of(page, progress_);
            if (!made) {
                faults_.insert(faults_.end(), made.faults().begin(), made.faults().end());
                return;
            }
            run = *made;
            shown = run->at(page.position);
        }
        if (given.answers.size() > kMaxTries) {
            add("too-large", given,
                "the file has " + std::to_string(given.answers.size()) + " answers to the question; expected at most " +
                    std::to_string(kMaxTries));
            return;
        }
        checked_.clear();
        std::string tries;
        std::size_t count = 0, rightAt = 0;
        for (const GivenAnswer &answer : given.answers) {
            if (progress_.cancelled()) {
                return;
            }
            progress_("checking answers",
                      from + (to - from) * static_cast<double>(count) / static_cast<double>(given.answers.size()));
            const std::optional<bool> right = isRightAnswer(*page.question, answer.text, {*shown}, run.get());
            if (!right) {
                add("other-answer", given, "the answer " + inQuotes(answer.text) + " is none that the question has");
            } else if (*right != answer.right) {
                add("false-claim", given,
                    "the answer " + inQuotes(answer.text) + " is marked " + (answer.right ? "right" : "wrong") +
                        ", but it is " + (*right ? "right" : "wrong"));
            }
            ++count;
            rightAt = rightAt == 0 && right.value_or(false) ? count : rightAt;
            if (count <= kMaxShown) {
                tries += (tries.empty() ? "" : "; ") + answer.text;
            }
        }
        if (count > kMaxShown) {
            tries += "; " + std::to_string(count - kMaxShown) + " more";
        }
        score.answered += rightAt > 0 ? 1U : 0U;
        score.firstTry += rightAt == 1 ? 1U : 0U;
        score.lines.push_back(page.title + ": " +
                              (rightAt > 0   ? "right at try " + std::to_string(rightAt)
                               : count > 0   ? "not right"
                               : given.shown ? "shown"
                                             : "not answered") +
                              (given.shown && count > 0 ? ", after Show me" : "") +
                              (tries.empty() ? "" : " (" + tries + ')'));
    }

    void add(const char *code, const PageAnswers &page, const std::string &message) {
        Diagnostic fault;
        fault.code = code;
        fault.message = "page " + inQuotes(page.title) + ": " + message;
        fault.file = source_.name;
        fault.line = page.place.line;
        fault.column = page.place.column;
        faults_.push_back(std::move(fault));
    }

    Diagnostics take() { return std::move(faults_); }

  private:
    /// Returns whether an answer is right; nothing if it answers another kind of question.
    std::optional<bool> isRightAnswer(const LessonQuestion &question, const std::string &text, const LessonState &state,
                                      LessonRun *run) {
        if (const auto *choices = std::get_if<LessonChoices>(&question.answer)) {
            for (std::size_t k = 0; k < choices->list.size(); ++k) {
                if (withValues(choices->list[k].text, state) == text) {
                    return isRight(*choices, k, state);
                }
            }
            return std::nullopt;
        }
        if (const auto *number = std::get_if<LessonNumber>(&question.answer)) {
            const std::optional<double> typed = answeredNumber(text);
            return typed ? std::optional(isRight(*number, *typed, state)) : std::nullopt;
        }
        const auto &task = std::get<LessonTask>(question.answer);
        if (numberAfter(kCandidate, text)) {
            return false; // right ones are recorded by their advance
        }
        const std::optional<std::uint64_t> position = numberAfter(kAdvance, text);
        if (!position || run == nullptr || *position > run->advances() + run->improveSteps()) {
            return std::nullopt;
        }
        const auto [known, isNew] = checked_.try_emplace(*position, false);
        if (isNew) {
            known->second = fulfilsAt(task, *run, *position, progress_);
        }
        return known->second;
    }

    const SourceText &source_;
    LessonRuns &runs_;
    const Progress &progress_;
    Diagnostics faults_;
    std::map<std::uint64_t, bool> checked_; ///< positions of the run of the page: whether they fulfil its task
};

} // namespace

std::string taskAnswer(const SessionSnapshot &run) {
    return std::string(kAdvance) + std::to_string(run.position());
}

std::string candidateAnswer(std::size_t candidate) {
    return std::string(kCandidate) + std::to_string(candidate + 1);
}

Result<AnswerScore> checkAnswers(const LessonAnswers &answers, const SourceText &source, const Lesson &lesson,
                                 LessonRuns &runs, const Progress &progress) {
    if (answers.lesson != lesson.title || answers.pages.size() != lesson.pages.size()) {
        return error("other-lesson",
                     "the answers of " + source.name + " belong to the lesson " + inQuotes(answers.lesson) + " with " +
                         countText(answers.pages.size(), "page") + ", not to " + inQuotes(lesson.title) + " with " +
                         std::to_string(lesson.pages.size()),
                     "check them with the lesson, in the version that the learner had");
    }
    AnswerCheck check(source, runs, progress);
    AnswerScore score;
    const double pages = static_cast<double>(lesson.pages.size());
    for (std::size_t k = 0; k < lesson.pages.size(); ++k) {
        if (lesson.pages[k].question) {
            ++score.questions;
            const auto before = static_cast<double>(k);
            check.page(lesson.pages[k], answers.pages[k], score, before / pages, (before + 1.0) / pages);
        } else if (!answers.pages[k].answers.empty()) {
            check.add("other-answer", answers.pages[k], "the page has no question, but the file has answers to it");
        }
        if (progress.cancelled()) {
            return cancelled("the check");
        }
    }
    if (Diagnostics faults = check.take(); !faults.empty()) {
        return faults;
    }
    return score;
}

} // namespace forefront
