#include "core/teaching/lesson_page/lesson_page.hpp"

#include "core/drawing/domain/document_domain.hpp"
#include "core/teaching/lesson_page/lesson_parts.hpp"
#include "core/teaching/lesson_page/page_colours.hpp"
#include "core/teaching/lesson_page/text_html.hpp"
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

/// A run that pages show.
struct ShownRun {
    const LessonPage *page = nullptr; ///< the first of them
    std::size_t moments = 0;          ///< after the front, that the player has, see RecordedRun::improveMoments()
};

/// Returns the index into `runs` of the run that a page shows, which becomes a new one if none of them is the same;
/// -1 without a drawing.
int runOf(const LessonPage &page, std::vector<ShownRun> &runs) {
    if (!page.document) {
        return -1;
    }
    const auto found =
        std::find_if(runs.begin(), runs.end(), [&page](const ShownRun &known) { return sameRun(*known.page, page); });
    const auto at = static_cast<int>(found - runs.begin());
    if (found == runs.end()) {
        runs.push_back({&page});
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

/// Writes the data of the pages, with the values in their texts and the right answers.
class LessonData {
  public:
    LessonData(const Lesson &lesson, TextWriter &out, const Progress &progress)
        : out_(out), progress_(progress), html_(lesson) {}

    /// Writes a page as an object. `number`: the index of its run, which is `run`; -1 and null: it has none. `moments`:
    /// see ShownRun.
    void page(const LessonPage &page, int number, LessonRun *run, std::size_t moments) {
        page_ = &page;
        run_ = run;
        moments_ = moments;
        SessionSnapshot none;
        std::shared_ptr<const SessionSnapshot> shown(&none, [](const SessionSnapshot *) {});
        if (run != nullptr) {
            shown = run_->at(page.position);
        }
        const LessonState state{*shown};
        out_ << "{\"title\":" << scriptString(page.title) << ",\"run\":" << number << ",\"at\":";
        position(page.position);
        if (shown->improveStep > 0 && !momentOf(shown->improveStep)) {
            out_ << ",\"note\":"
                 << scriptString("This page is about step " + std::to_string(shown->improveStep) + " of " +
                                 std::to_string(shown->improveSteps) +
                                 " of the improvement, which the editor shows. Here you see the improved mesh.");
        }
        out_ << ",\"view\":";
        view(page.camera);
        const auto shows = [&page](const char *layer) {
            return page.layers && std::find(page.layers->begin(), page.layers->end(), layer) != page.layers->end();
        };
        const bool bare = page.layers && !shows("front") && !shows("candidates");
        out_ << ",\"cells\":" << (shows("grid") ? 1 : 0) << ",\"numbers\":" << (shows("numbers") ? 1 : 0)
             << ",\"bare\":" << (bare ? 1 : 0) << ",\"colours\":";
        if (run_ != nullptr) {
            writePageColours(out_, page, *run_, *shown);
        } else {
            out_ << "null";
        }
        out_ << ",\"text\":[";
        for (const std::string &paragraph : page.paragraphs) {
            out_ << (&paragraph == page.paragraphs.data() ? "" : ",") << html(paragraph, state);
        }
        out_ << "],\n\"question\":";
        if (page.question) {
            question(*page.question, state);
        } else {
            out_ << "null";
        }
        out_ << '}';
    }

    /// Writes the texts that tasks refer to.
    void words() {
        out_ << '[';
        for (const std::string &word : words_.words()) {
            out_ << (&word == words_.words().data() ? "" : ",\n") << scriptString(word);
        }
        out_ << ']';
    }

    /// Writes the pictures that the texts show.
    void pictures() {
        out_ << '[';
        const std::vector<std::string> urls = html_.pictures();
        for (const std::string &url : urls) {
            out_ << (&url == urls.data() ? "" : ",\n") << scriptString(url);
        }
        out_ << ']';
    }

    /// Returns the warnings about the pages written so far.
    Diagnostics takeWarnings() { return std::move(warnings_); }

  private:
    /// Returns a text as HTML in a string of the script.
    std::string html(const std::string &text, const LessonState &state) {
        return scriptString(html_.of(withValues(text, state)));
    }

    /// Writes a text as it is kept with answers, and as HTML if that differs.
    void markedText(const std::string &text, const LessonState &state, MarkupKind kind) {
        const std::string shown = withValues(text, state), marked = html_.of(shown, kind);
        out_ << "\"text\":" << scriptString(shown);
        if (marked != shown) {
            out_ << ",\"html\":" << scriptString(marked);
        }
    }

    /// Returns the moment of the player after so many steps of the improvement; nothing if it has none. Long
    /// improvements are not recorded whole; their last moment is the end.
    std::optional<std::size_t> momentOf(std::size_t step) const {
        return step == run_->improveSteps() ? std::optional(moments_)
               : step < moments_            ? std::optional(step)
                                            : std::nullopt;
    }

    /// Writes a position of the player: advances done, event of the next one, moment of the improvement. The player has
    /// no moment of its own for the first event, the choice of the base.
    void position(const LessonPosition &position) {
        const std::uint64_t last = run_ != nullptr ? run_->advances() : 0;
        const std::uint64_t done = position.atEnd ? last : std::min(position.advance, last);
        const bool inFront = run_ == nullptr || (done < last && !position.atEnd);
        const std::int64_t event =
            !inFront || position.events == 0 ? 0 : std::max<std::int64_t>(position.events - 1, 1);
        std::size_t moment = 0;
        if (!inFront) {
            const std::uint64_t steps = position.advance - done + static_cast<std::uint64_t>(position.events);
            moment = position.atEnd
                         ? moments_
                         : momentOf(static_cast<std::size_t>(std::min<std::uint64_t>(steps, run_->improveSteps())))
                               .value_or(moments_);
        }
        out_ << '[' << done << ',' << event << ',' << moment << ']';
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

    void question(const LessonQuestion &question, const LessonState &state) {
        const auto *const task = std::get_if<LessonTask>(&question.answer);
        out_ << '{';
        markedText(question.text, state, MarkupKind::All);
        out_ << ",\"hint\":" << html(question.hint, state);
        if (task == nullptr) {
            out_ << ",\"why\":" << html(question.why, state);
        }
        out_ << ",\"show\":";
        if (question.show) {
            position(*question.show);
        } else {
            out_ << "null";
        }
        if (const auto *choices = std::get_if<LessonChoices>(&question.answer)) {
            out_ << ",\"choices\":[";
            for (std::size_t k = 0; k < choices->list.size(); ++k) {
                out_ << (k == 0 ? "" : ",") << '{';
                markedText(choices->list[k].text, state, MarkupKind::Formulas);
                out_ << ",\"right\":" << (isRight(*choices, k, state) ? "true" : "false")
                     << ",\"hint\":" << html(hintAfter(question, k), state) << '}';
            }
            out_ << ']';
        } else if (const auto *number = std::get_if<LessonNumber>(&question.answer)) {
            out_ << ",\"number\":" << valueOf(number->value, state).value_or(0.0)
                 << ",\"within\":" << toleranceOf(*number, state) << ",\"mistakes\":[";
            mistakes(*number, state);
            out_ << ']';
        } else if (task != nullptr) {
            out_ << ",\"asksForCandidate\":" << (asksForCandidate(*task) ? "true" : "false") << ",\"done\":[";
            const bool any = run_ != nullptr && moments(*task, question.why);
            out_ << ']';
            if (!any) {
                out_ << ",\"note\":"
                     << scriptString("This task needs a moment that the editor shows, such as a step of the "
                                     "improvement. Open the lesson there to do it.");
                warnOfTask(question);
            }
        }
        out_ << '}';
    }

    /// Writes [number, tolerance, hint] for each mistake that has a number.
    void mistakes(const LessonNumber &number, const LessonState &state) {
        bool first = true;
        for (const KnownMistake &mistake : mistakesOf(number, state)) {
            out_ << (first ? "[" : ",[") << mistake.number << ',' << mistake.within << ',' << html(*mistake.hint, state)
                 << ']';
            first = false;
        }
    }

    void warnOfTask(const LessonQuestion &question) {
        Diagnostic warning;
        warning.severity = Severity::Warning;
        warning.code = "not-on-page";
        warning.message = "page '" + page_->title +
                          "': no moment of the page for a browser fulfils the task; the "
                          "page says that the editor shows it";
        warning.advice = "choose a condition that holds after an advance, or at the end";
        warning.line = question.place.line;
        warning.column = question.place.column;
        warnings_.push_back(std::move(warning));
    }

    /// Writes the moments at which a task is done, as lesson.js reads them. Returns false if there are none.
    bool moments(const LessonTask &task, const std::string &why) {
        const bool ofMesh = asksForMesh(task) || needsMesh(why);
        bool first = true;
        const auto write = [&](std::uint64_t done, bool inner, std::size_t moment, const SessionSnapshot &run) {
            const auto add = [&](std::optional<std::size_t> chosen) {
                const LessonState state{run, chosen};
                if (isDone(task, state)) {
                    out_ << (first ? "[" : ",[") << done << ',' << (inner ? 1 : 0) << ',' << moment << ','
                         << (chosen ? static_cast<int>(*chosen) : -1) << ','
                         << words_.add(html_.of(withValues(why, state))) << ']';
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
            write(k, false, 0, *run_->at({.advance = k}, ofMesh));
            if (k < run_->advances()) {
                write(k, true, 0, *run_->at({.advance = k, .events = 1}, ofMesh));
            }
        }
        for (std::size_t moment = 1; moment <= moments_ && !progress_.cancelled(); ++moment) {
            write(run_->advances(), false, moment,
                  *run_->at(moment == moments_ ? LessonPosition{.atEnd = true}
                                               : LessonPosition{.advance = run_->advances() + moment}));
        }
        return !first;
    }

    TextWriter &out_;
    const Progress &progress_;
    const LessonPage *page_ = nullptr;
    LessonRun *run_ = nullptr;
    std::size_t moments_ = 0; ///< of the improvement, that the player has
    WordList words_;
    TextHtml html_;
    Diagnostics warnings_;
};

void writeHead(TextWriter &out, const std::string &title) {
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"generator\" content=\"Forefront\">\n<title>"
        << htmlText(title) << "</title>\n<style id=\"player-style\">\n"
        << playerStyle() << "</style>\n<style>\n"
        << lessonStyle() << "</style>\n</head>\n<body>\n"
        << lessonBody();
    // The player is a document of its own in a frame; its parts are kept here, inert. It has the style of this page.
    out << "<template id=\"player-parts\"><!--style-->\n"
        << playerBody() << "<!--run--><script>\n"
        << playerScript() << "</script></template>\n";
}

/// The text of a run, without the steps of its improvement, which must share what is left of the page.
struct RunText {
    std::string text;
    std::optional<RecordedImprovement> improvement; ///< not set: it has none
};

/// Records the run of a page for the player.
Result<RunText> runText(const Lesson &lesson, const ShownRun &shown, LessonRun &run, std::size_t maxImproveBytes,
                        const Progress &progress) {
    const RunPagePlan plan{
        .title = {}, .from = 0, .steps = {}, .maxAdvances = kMaxAdvances, .maxImproveBytes = maxImproveBytes};
    Result<RecordedRun> recorded = run.options().order == ElementOrder::First
                                       ? recordRun(run.stepper(), run.options(), plan, progress)
                                       : recordRun(jobOf(*documentOf(*shown.page)), plan, progress);
    if (!recorded) {
        const bool large = recorded.faults().front().code == "too-large";
        return large ? error("too-large",
                             "the run of page '" + shown.page->title + "' has more than " +
                                 std::to_string(kMaxAdvances) + " advances, too many for a page",
                             "choose a larger size for its drawing")
                     : recorded.faults();
    }
    StringSink sink;
    TextWriter out(sink);
    writeRunWithoutSteps(out, *recorded, lesson.title, 0, detailedOf(*recorded, lesson, *shown.page));
    out.flush();
    RunText text{std::move(sink.text), {}};
    if (recorded->improved) {
        text.improvement = std::move(recorded->improvement);
    }
    return text;
}

/// Writes the runs that the pages show, each with as many steps of its improvement as there is room for.
Status writeRuns(const Lesson &lesson, std::vector<ShownRun> &shown, LessonRuns &runs, std::size_t maxImproveBytes,
                 TextWriter &out, const Progress &progress) {
    constexpr std::size_t kRunBytes = 890'000; // so that pages of long runs stay below a megabyte, if they can
    std::vector<RunText> texts;
    std::size_t bytes = 0;
    for (const ShownRun &each : shown) {
        const Result<std::shared_ptr<LessonRun>> run = runs.of(*each.page, progress);
        if (!run) {
            return run.faults();
        }
        Result<RunText> text = runText(lesson, each, **run, maxImproveBytes, progress);
        if (!text) {
            return text.faults();
        }
        texts.push_back(*std::move(text));
        bytes += texts.back().text.size();
    }
    const std::size_t room = std::min(maxImproveBytes, kRunBytes - std::min(kRunBytes, bytes));
    for (std::size_t k = 0; k < shown.size(); ++k) {
        std::optional<RecordedImprovement> &improvement = texts[k].improvement;
        if (improvement) {
            improvement->limit(room / shown.size());
            shown[k].moments = improvement->moments();
        }
        out << "<script type=\"application/json\" id=\"run" << k << "\">\n" << texts[k].text;
        writeSteps(out, improvement ? &*improvement : nullptr);
        out << "\n</script>\n";
    }
    return {};
}

} // namespace

Status writeLessonPage(const Lesson &lesson, TextWriter &out, const Progress &progress) {
    LessonRuns runs(LessonRuns::Keep::All);
    return writeLessonPage(lesson, runs, out, progress);
}

Status writeLessonPage(const Lesson &lesson, LessonRuns &runs, TextWriter &out, const Progress &progress,
                       std::size_t maxImproveBytes) {
    std::vector<ShownRun> shown;
    std::vector<int> runOfPage;
    for (const LessonPage &page : lesson.pages) {
        runOfPage.push_back(runOf(page, shown));
    }
    writeHead(out, lesson.title);
    if (Status faults = writeRuns(lesson, shown, runs, maxImproveBytes, out, progress); !faults.empty()) {
        return faults;
    }
    out << "<script type=\"application/json\" id=\"lesson\">\n{\"title\":" << scriptString(lesson.title)
        << ",\"about\":" << scriptString(lesson.about) << ",\"seed\":" << lesson.seed << ",\"pages\":[\n";
    LessonData data(lesson, out, progress);
    for (std::size_t k = 0; k < lesson.pages.size(); ++k) {
        out << (k == 0 ? "" : ",\n");
        if (!lesson.pages[k].document) {
            data.page(lesson.pages[k], -1, nullptr, 0);
            continue;
        }
        const Result<std::shared_ptr<LessonRun>> run = runs.of(lesson.pages[k], progress);
        if (!run) {
            return run.faults();
        }
        const std::size_t moments = runOfPage[k] >= 0 ? shown[static_cast<std::size_t>(runOfPage[k])].moments : 0;
        data.page(lesson.pages[k], runOfPage[k], run->get(), moments);
        if (progress.cancelled()) { // the moments of its task may be incomplete
            return error("cancelled", "the page was cancelled");
        }
    }
    out << "],\n\"words\":";
    data.words();
    out << ",\n\"pictures\":";
    data.pictures();
    out << "}\n</script>\n<script>\n" << lessonScript() << "</script>\n</body>\n</html>\n";
    return data.takeWarnings();
}

} // namespace forefront
