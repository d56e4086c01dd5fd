#include "core/teaching/lesson_page/lesson_page.hpp"

#include "core/drawing/domain/document_domain.hpp"
#include "core/teaching/lesson/lesson_run.hpp"
#include "core/teaching/lesson_page/lesson_parts.hpp"
#include "core/teaching/page/player.hpp"
#include "core/teaching/page/recorded_run.hpp"
#include "core/teaching/page/run_record.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns the index into `runs` of the run that a page shows, which becomes a new one if none of them is the same;
/// -1 without a drawing.
int runOf(const LessonPage &page, std::vector<const LessonPage *> &runs) {
    if (!page.document) {
        return -1;
    }
    const auto found =
        std::find_if(runs.begin(), runs.end(), [&page](const LessonPage *known) { return sameRun(*known, page); });
    const auto at = static_cast<int>(found - runs.begin());
    if (found == runs.end()) {
        runs.push_back(&page);
    }
    return at;
}

/// Maximum number of advances of a run, and of those all of whose details are in the page.
constexpr std::uint64_t kMaxAdvances = 20'000;
constexpr std::size_t kDetailed = 300;

/// Returns which advances of a run have all their details: those near the positions of pages, if there are many.
std::vector<bool> detailedOf(const RecordedRun &run, const Lesson &lesson, const LessonPage &shown) {
    const std::size_t count = run.advances.size();
    std::vector<bool> detailed(count, count <= kDetailed);
    const auto mark = [&](const LessonPosition &position) {
        constexpr std::size_t kNear = 40;
        const std::size_t at = position.atEnd ? count : std::min<std::size_t>(position.advance, count);
        for (std::size_t k = at - std::min(at, kNear); k < std::min(count, at + kNear); ++k) {
            detailed[k] = true;
        }
    };
    for (const LessonPage &page : lesson.pages) {
        if (!sameRun(page, shown)) {
            continue;
        }
        mark(page.position);
        if (page.question && page.question->show) {
            mark(*page.question->show);
        }
    }
    return detailed;
}

/// Writes the data of the pages. Runs pages again to find the values in their texts and the right answers.
class LessonData {
  public:
    LessonData(TextWriter &out, const Progress &progress) : out_(out), progress_(progress) {}

    /// Writes a page as an object. `run`: see runOf(). Errors: those of the run.
    Status page(const LessonPage &page, int run) {
        SessionSnapshot none;
        std::shared_ptr<const SessionSnapshot> shown(&none, [](const SessionSnapshot *) {});
        if (run >= 0) {
            if (Status faults = takeRun(page); !faults.empty()) {
                return faults;
            }
            shown = run_->at(page.position);
        }
        const LessonState state{*shown};
        out_ << "{\"title\":" << scriptString(page.title) << ",\"run\":" << run << ",\"at\":";
        position(page.position, run >= 0);
        out_ << ",\"view\":";
        view(page.camera);
        const bool cells =
            page.layers && std::find(page.layers->begin(), page.layers->end(), "grid") != page.layers->end();
        out_ << ",\"cells\":" << (cells ? 1 : 0) << ",\"text\":[";
        for (const std::string &paragraph : page.paragraphs) {
            out_ << (&paragraph == page.paragraphs.data() ? "" : ",") << scriptString(withValues(paragraph, state));
        }
        out_ << "],\n\"question\":";
        if (page.question) {
            question(*page.question, state, run >= 0);
        } else {
            out_ << "null";
        }
        out_ << '}';
        return {};
    }

    /// Writes the texts that tasks refer to.
    void words() {
        out_ << '[';
        for (const std::string &word : words_.words()) {
            out_ << (&word == words_.words().data() ? "" : ",\n") << scriptString(word);
        }
        out_ << ']';
    }

  private:
    Status takeRun(const LessonPage &page) {
        if (ranPage_ != nullptr && sameRun(*ranPage_, page)) {
            return {};
        }
        Result<LessonRun> run = LessonRun::create(page, progress_);
        if (!run) {
            return run.faults();
        }
        ranPage_ = &page;
        run_.emplace(*std::move(run));
        return {};
    }

    /// Writes a position of the player: advances done, event of the next one, whether the mesh is improved. The player
    /// has no moment of its own for the first event, the choice of the base, and none for steps of the improvement.
    void position(const LessonPosition &position, bool hasRun) {
        const std::uint64_t last = hasRun ? run_->advances() : 0;
        const std::uint64_t beyond = position.advance - std::min(position.advance, last);
        const bool end = hasRun && (position.atEnd ||
                                    (position.advance >= last &&
                                     beyond + static_cast<std::uint64_t>(position.events) >= run_->improveSteps()));
        const std::uint64_t done = position.atEnd ? last : std::min(position.advance, last);
        const std::int64_t event =
            position.atEnd || done == last || position.events == 0 ? 0 : std::max<std::int64_t>(position.events - 1, 1);
        out_ << '[' << done << ',' << event << ',' << (end && run_->improveSteps() > 0 ? 1 : 0) << ']';
    }

    void view(const LessonCamera &camera) {
        if (camera.follow) {
            out_ << "{\"follow\":1}";
        } else if (camera.box) {
            out_ << "{\"box\":[" << camera.box->min.x << ',' << camera.box->min.y << ',' << camera.box->max.x << ','
                 << camera.box->max.y << "]}";
        } else {
            out_ << "{}";
        }
    }

    void question(const LessonQuestion &question, const LessonState &state, bool hasRun) {
        const auto *const task = std::get_if<LessonTask>(&question.answer);
        out_ << "{\"text\":" << scriptString(withValues(question.text, state))
             << ",\"hint\":" << scriptString(withValues(question.hint, state));
        if (task == nullptr) {
            out_ << ",\"why\":" << scriptString(withValues(question.why, state));
        }
        out_ << ",\"show\":";
        if (question.show) {
            position(*question.show, hasRun);
        } else {
            out_ << "null";
        }
        if (const auto *choices = std::get_if<LessonChoices>(&question.answer)) {
            out_ << ",\"choices\":[";
            for (std::size_t k = 0; k < choices->list.size(); ++k) {
                out_ << (k == 0 ? "" : ",") << "{\"text\":" << scriptString(withValues(choices->list[k].text, state))
                     << ",\"right\":" << (isRight(*choices, k, state) ? "true" : "false") << '}';
            }
            out_ << ']';
        } else if (const auto *number = std::get_if<LessonNumber>(&question.answer)) {
            out_ << ",\"number\":" << valueOf(number->value, state).value_or(0.0) << ",\"within\":" << number->within;
        } else if (task != nullptr) {
            out_ << ",\"asksForCandidate\":" << (asksForCandidate(*task) ? "true" : "false") << ",\"done\":[";
            moments(*task, question.why);
            out_ << ']';
        }
        out_ << '}';
    }

    /// Writes the moments at which a task is done, as lesson.js reads them.
    void moments(const LessonTask &task, const std::string &why) {
        bool first = true;
        const auto write = [&](std::uint64_t done, bool inner, bool improved, const SessionSnapshot &run) {
            const auto add = [&](std::optional<std::size_t> chosen) {
                const LessonState state{run, chosen};
                if (isDone(task, state)) {
                    out_ << (first ? "[" : ",[") << done << ',' << (inner ? 1 : 0) << ',' << (improved ? 1 : 0) << ','
                         << (chosen ? static_cast<int>(*chosen) : -1) << ',' << words_.add(withValues(why, state))
                         << ']';
                    first = false;
                }
            };
            const bool chooses = asksForCandidate(task) && run.explanation;
            for (std::size_t k = 0; chooses && k < run.explanation->candidates.size(); ++k) {
                add(k);
            }
            if (!chooses) {
                add(std::nullopt);
            }
        };
        for (std::uint64_t k = 0; k <= run_->advances() && !progress_.cancelled(); ++k) {
            write(k, false, false, *run_->at({.advance = k}));
            if (k < run_->advances()) {
                write(k, true, false, *run_->at({.advance = k, .events = 1}));
            }
        }
        if (run_->improveSteps() > 0) {
            write(run_->advances(), false, true, *run_->at({.atEnd = true}));
        }
    }

    TextWriter &out_;
    const Progress &progress_;
    const LessonPage *ranPage_ = nullptr;
    std::optional<LessonRun> run_;
    WordList words_;
};

void writeHead(TextWriter &out, const std::string &title) {
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"generator\" content=\"Forefront\">\n<title>"
        << htmlText(title) << "</title>\n<style>\n"
        << playerStyle() << lessonStyle() << "</style>\n</head>\n<body>\n"
        << lessonBody();
    // The player is a document of its own in a frame; its parts are kept here, inert.
    out << "<template id=\"player-parts\"><style>\n"
        << playerStyle() << "</style>\n"
        << playerBody() << "<!--run--><script>\n"
        << playerScript() << "</script></template>\n";
}

} // namespace

Status writeLessonPage(const Lesson &lesson, TextWriter &out, const Progress &progress) {
    std::vector<const LessonPage *> runs;
    std::vector<int> runOfPage;
    for (const LessonPage &page : lesson.pages) {
        runOfPage.push_back(runOf(page, runs));
    }
    writeHead(out, lesson.title);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const Result<RecordedRun> run = recordRun(
            jobOf(*documentOf(*runs[k])), {.title = {}, .from = 0, .steps = {}, .maxAdvances = kMaxAdvances}, progress);
        if (!run) {
            const bool large = run.faults().front().code == "too-large";
            return large ? error("too-large",
                                 "the run of page '" + runs[k]->title + "' has more than " +
                                     std::to_string(kMaxAdvances) + " advances, too many for a page",
                                 "choose a larger size for its drawing")
                         : run.faults();
        }
        out << "<script type=\"application/json\" id=\"run" << k << "\">\n";
        writeRun(out, *run, lesson.title, 0, detailedOf(*run, lesson, *runs[k]));
        out << "\n</script>\n";
    }
    out << "<script type=\"application/json\" id=\"lesson\">\n{\"title\":" << scriptString(lesson.title)
        << ",\"about\":" << scriptString(lesson.about) << ",\"pages\":[\n";
    LessonData data(out, progress);
    for (std::size_t k = 0; k < lesson.pages.size(); ++k) {
        out << (k == 0 ? "" : ",\n");
        if (Status faults = data.page(lesson.pages[k], runOfPage[k]); !faults.empty()) {
            return faults;
        }
        if (progress.cancelled()) { // the moments of its task may be incomplete
            return error("cancelled", "the page was cancelled");
        }
    }
    out << "],\n\"words\":";
    data.words();
    out << "}\n</script>\n<script>\n" << lessonScript() << "</script>\n</body>\n</html>\n";
    return {};
}

} // namespace forefront
