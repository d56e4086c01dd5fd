#include "core/teaching/lesson/lesson_check.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/files/common/names.hpp"
#include "core/files/json/json.hpp"
#include "core/files/source/text_place.hpp"
#include "core/teaching/lesson/position_check.hpp"
#include "core/teaching/markup/text_values.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

namespace {

/// Longer runs are searched for a state that fulfils a task only where the lesson itself leads.
constexpr std::uint64_t kMaxSearched = 20'000;

/// The members of a page in the file, for the places of faults.
class PageMembers {
  public:
    PageMembers(const JsonValue &page, std::string_view text) : page_(page), text_(text) {}

    /// Returns the place of a member, such as "question", "choices"; of the innermost that is there.
    TextPlace place(std::initializer_list<std::string_view> path) const {
        JsonValue value = page_;
        for (const std::string_view name : path) {
            const auto member = value.is(JsonKind::Object) ? value.find(name) : std::nullopt;
            if (!member) {
                break;
            }
            value = *member;
        }
        return placeOf(text_, value.offset());
    }

  private:
    JsonValue page_;
    std::string_view text_;
};

/// Checks a page at a time, and keeps the run of the last one.
class LessonChecker {
  public:
    LessonChecker(const SourceText &source, LessonRuns &runs, const Progress &progress)
        : source_(source), runs_(runs), progress_(progress) {}

    void check(const LessonPage &page, const PageMembers &members) {
        page_ = &page;
        members_ = &members;
        const SessionSnapshot none;
        if (!page.document) {
            checkTexts({none});
            checkQuestion({none});
            return;
        }
        if (!takeRun()) {
            return;
        }
        checkPosition(page.position, {"position"});
        const std::shared_ptr<const SessionSnapshot> shown = run_->at(page.position);
        checkColours(*shown);
        checkTexts({*shown});
        checkQuestion({*shown});
    }

    Diagnostics take() { return std::move(faults_); }

  private:
    using Path = std::initializer_list<std::string_view>;

    void add(Severity severity, const char *code, Path path, const std::string &message, std::string advice = {}) {
        const TextPlace place = members_->place(path);
        Diagnostic fault;
        fault.severity = severity;
        fault.code = code;
        fault.message = "page " + inQuotes(page_->title) + ": " + message;
        fault.advice = std::move(advice);
        fault.file = source_.name;
        fault.line = place.line;
        fault.column = place.column;
        faults_.push_back(std::move(fault));
    }

    /// Makes the run of the page unless it is that of the page before. Returns false if there is none.
    bool takeRun() {
        if (ranPage_ != nullptr && sameRun(*ranPage_, *page_)) {
            return run_ != nullptr;
        }
        ranPage_ = page_;
        run_.reset();
        const Result<std::shared_ptr<LessonRun>> run = runs_.of(*page_, progress_);
        if (run) {
            run_ = *run;
            return true;
        }
        if (!progress_.cancelled()) {
            const Diagnostic &fault = run.faults().front();
            add(Severity::Error, "not-meshed", {"document"},
                "the drawing " + inQuotes(page_->documentName) + " cannot be meshed: " + fault.message, fault.advice);
        }
        return false;
    }

    void checkPosition(const LessonPosition &position, Path path) {
        std::optional<Diagnostic> fault = beyondEnd(position, run_->advances(), run_->improveSteps());
        if (!fault) {
            fault = tooManyEvents(position, *run_->at(position, false));
        }
        if (fault) {
            add(Severity::Error, fault->code.c_str(), path, fault->message, fault->advice);
        }
    }

    /// Reports that an expression has no values on the mesh that it colours.
    void checkColours(const SessionSnapshot &shown) {
        if (!page_->colours.any() || !shown.mesh) {
            return;
        }
        const Result<std::vector<double>> values = coloursOn(page_->colours, shown.mesh->mesh, progress_);
        if (!values && !progress_.cancelled()) {
            const Diagnostic &fault = values.faults().front();
            add(Severity::Error, "no-values", {"colours"}, "the mesh has no colours: " + fault.message, fault.advice);
        }
    }

    /// Reports values in braces that have no number in a state.
    void checkText(std::string_view text, const LessonState &state, Path path) {
        for (const NamedValue &named : valuesNamed(text)) {
            const auto value = fromWord<LessonValue>(named.word);
            if (value && !valueOf(*value, state)) {
                add(Severity::Error, "no-value", path,
                    "the value " + inQuotes(named.word) + " has no number at the position of the page",
                    page_->document ? "choose a position where it has one, such as after an advance"
                                    : "add \"document\" to this page or to an earlier one");
            }
        }
    }

    void checkTexts(const LessonState &state) {
        for (const std::string &paragraph : page_->paragraphs) {
            checkText(paragraph, state, {"text"});
        }
    }

    void checkQuestion(const LessonState &state) {
        if (!page_->question) {
            return;
        }
        const LessonQuestion &question = *page_->question;
        checkText(question.text, state, {"question", "text"});
        checkText(question.hint, state, {"question", "hint"});
        if (run_ && page_->document && question.show) {
            checkPosition(*question.show, {"question", "show"});
        }
        if (const auto *choices = std::get_if<LessonChoices>(&question.answer)) {
            checkChoices(*choices, state);
            checkText(question.why, state, {"question", "why"});
        } else if (const auto *number = std::get_if<LessonNumber>(&question.answer)) {
            if (!valueOf(number->value, state)) {
                add(Severity::Error, "no-answer", {"question", "number"},
                    "the value " + inQuotes(number->value.text) + " has no number at the position of the page");
            }
            checkMistakes(*number, state);
            checkText(question.why, state, {"question", "why"});
        } else {
            checkTask(std::get<LessonTask>(question.answer), state);
        }
    }

    void checkChoices(const LessonChoices &choices, const LessonState &state) {
        std::size_t right = 0;
        for (std::size_t k = 0; k < choices.list.size(); ++k) {
            checkText(choices.list[k].text, state, {"question", "choices"});
            checkText(choices.list[k].hint, state, {"question", "choices"});
            right += isRight(choices, k, state) ? 1U : 0U;
        }
        if (right == 0) {
            add(Severity::Error, "no-answer", {"question", "choices"}, "no choice is right at the position of the page",
                "correct the conditions, or the position");
        } else if (right == choices.list.size()) {
            add(Severity::Warning, "all-right", {"question", "choices"}, "every choice is right");
        }
    }

    /// Reports mistakes that are right answers here, since their hint would never show.
    void checkMistakes(const LessonNumber &number, const LessonState &state) {
        for (const LessonNumber::Mistake &mistake : number.mistakes) {
            checkText(mistake.hint, state, {"question", "mistakes"});
            const std::optional<double> wrong = valueOf(mistake.value, state);
            if (!wrong || isRight(number, *wrong, state)) {
                add(Severity::Warning, "no-mistake", {"question", "mistakes"},
                    wrong ? "the number of this mistake is the right answer"
                          : "the value of this mistake has no number at the position of the page");
            }
        }
    }

    void checkTask(const LessonTask &task, const LessonState &state) {
        if (!run_ || !page_->document) {
            add(Severity::Error, "no-answer", {"question", "until"}, "a task needs a run",
                "add \"document\" to this page or to an earlier one");
            return;
        }
        if (isDone(task, state)) {
            add(Severity::Warning, "done-already", {"question", "until"},
                "the task is done at the position of the page");
        }
        const auto &show = page_->question->show;
        const std::shared_ptr<const SessionSnapshot> shown = show ? run_->at(*show) : nullptr;
        if (shown && !canBeDone(task, *shown)) {
            add(Severity::Error, "wrong-show", {"question", "show"},
                "the task is not done at this position, where Show me leads");
        }
        if (!shown && !isReachable(task)) {
            add(Severity::Error, "no-answer", {"question", "until"}, "no position of the run fulfils the task");
        }
    }

    /// Returns true if a state fulfils a task, or would with one of its candidates chosen.
    static bool canBeDone(const LessonTask &task, const SessionSnapshot &run) {
        if (isDone(task, {run, std::nullopt})) {
            return true;
        }
        const std::size_t candidates =
            asksForCandidate(task) && run.explanation ? run.explanation->candidates.size() : 0;
        for (std::size_t k = 0; k < candidates; ++k) {
            if (isDone(task, {run, k})) {
                return true;
            }
        }
        return false;
    }

    bool isReachable(const LessonTask &task) {
        if (canBeDone(task, *run_->at(page_->position)) || canBeDone(task, *run_->at({.atEnd = true}))) {
            return true;
        }
        if (run_->advances() > kMaxSearched) {
            return true; // not known
        }
        const bool ofMesh = asksForMesh(task);
        for (std::uint64_t k = 0; k <= run_->advances() + run_->improveSteps() && !progress_.cancelled(); ++k) {
            if (canBeDone(task, *run_->at({.advance = k}, ofMesh))) {
                return true;
            }
        }
        return false;
    }

    const SourceText &source_;
    LessonRuns &runs_;
    const Progress &progress_;
    Diagnostics faults_;
    const LessonPage *page_ = nullptr;
    const PageMembers *members_ = nullptr;
    const LessonPage *ranPage_ = nullptr; ///< whose run it is
    std::shared_ptr<LessonRun> run_;
};

} // namespace

Diagnostics checkLesson(const Lesson &lesson, const SourceText &source, const Progress &progress) {
    LessonRuns runs;
    return checkLesson(lesson, source, runs, progress);
}

Diagnostics checkLesson(const Lesson &lesson, const SourceText &source, LessonRuns &runs, const Progress &progress) {
    const auto json = JsonDocument::parse(source);
    const auto pages = json ? json->root().find("pages") : std::nullopt;
    if (!pages) {
        return json ? Diagnostics{} : json.faults();
    }
    Diagnostics faults = pictureFaults(lesson, source.name, true);
    LessonChecker checker(source, runs, progress);
    std::size_t number = 0;
    for (const JsonValue item : *pages) {
        if (progress.cancelled()) {
            return cancelled("the check");
        }
        checker.check(lesson.pages[number++], PageMembers(item, source.text));
    }
    if (progress.cancelled()) {
        return cancelled("the check");
    }
    const Diagnostics found = checker.take();
    faults.insert(faults.end(), found.begin(), found.end());
    return faults;
}

} // namespace forefront
