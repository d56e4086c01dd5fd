#include "core/teaching/moment/moment.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/lessons/kept_answers.hpp"
#include "ui/lessons/lesson_list.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/workspace/view/follow_camera.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

/// Answers the questions of lessons as a learner does, with the keyboard.
class Learner : public Driver {
  public:
    explicit Learner(EditorSetup setup = {}, PixelSize size = {1400, 900}) : Driver(std::move(setup), size) {
        key(key::kF1 + 3);
        settle();
    }

    const OpenLesson &open() { return *context().lessons.open; }
    LessonState state() { return lessonState(context()); }

    /// Picks every wrong choice, then the right one, counted from 1.
    void answerChoice(const LessonChoices &choices, std::size_t right) {
        REQUIRE(right >= 1);
        REQUIRE(right <= choices.list.size());
        for (std::size_t k = 1; k <= choices.list.size(); ++k) {
            if (k != right) {
                pick(k);
                CHECK(has("lesson/wrong"));
            }
        }
        pick(right);
    }

    void answerNumber(const std::string &number) {
        enter('1' + number);
        CHECK(has("lesson/wrong"));
        enter(number);
    }
    void enter(const std::string &text) {
        key(key::k0, kAlt);
        settle();
        key('A', kControl);
        type(text);
        key(key::kEnter);
        settle();
    }

    /// Returns the rank of the candidate that a task asks for: the winner, or a number.
    std::optional<double> askedCandidate(const LessonTask &task) {
        for (const LessonCondition &condition : task.until) {
            if (condition.value == LessonValue::Chosen) {
                return condition.other ? valueOf(*condition.other, state()) : condition.number;
            }
        }
        return std::nullopt;
    }

    void doTask(const LessonQuestion &question) {
        CHECK_FALSE(has("lesson/right"));
        if (question.show) {
            key('H', kAlt);
        } else {
            const std::optional<double> asked = askedCandidate(std::get<LessonTask>(question.answer));
            REQUIRE(asked);
            click("candidates/" + std::to_string(std::lround(*asked) - 1));
        }
        settle();
    }

    /// `expected`: the right choice, counted from 1, or the number; nothing for a task.
    void answer(const LessonQuestion &question, const std::string &expected) {
        if (const auto *choices = std::get_if<LessonChoices>(&question.answer)) {
            answerChoice(*choices, std::stoul(expected));
        } else if (std::holds_alternative<LessonNumber>(question.answer)) {
            answerNumber(expected);
        } else {
            doTask(question);
        }
        const bool shown = question.show && std::holds_alternative<LessonTask>(question.answer);
        CHECK(has(shown ? "lesson/shown" : "lesson/right"));
        CHECK_FALSE(has("lesson/wrong"));
    }

  private:
    void pick(std::size_t choice) {
        key(key::k0 + static_cast<int>(choice), kAlt);
        settle();
    }
};

/// The answers page by page: choices counted from 1, numbers, nothing for tasks. Worked out by hand or, where they
/// depend on the run, read from the statistics and the captions of films that the batch program writes.
const std::map<std::string, std::vector<std::string>> &rightAnswers() {
    static const std::map<std::string, std::vector<std::string>> kAnswers = {
        {"1-front", {"34", "2", "", "1", "", "2", "2"}},
        {"2-ten-steps", {"2", "1", "", "", "1"}},
        {"3-ideal-point", {"1", "3", "0.99", "", "1"}},
        {"4-rejections", {"1", "2", "", "3", ""}},
        {"5-background-grid", {"1", "", "2", "3", "3"}},
        {"6-spacing", {"2", "7", "1", "0.93", "2"}},
        {"7-closing", {"1", "3", "29", "2", "3"}},
        {"8-classic-and-fast", {"3", "2", "2", "1", "3", "2"}},
        {"9-adaptive", {"2", "2", "2", "2", "", "2", "1"}},
        {"10-dynamic-grid", {"2", "2", "2", "129", "", "2"}},
        {"11-many-at-once", {"2", "2", "3", "1", "2", ""}},
        {"12-three-dimensions", {"2", "2", "2", "2", "", "0.849", "1"}},
        {"13-quadrilaterals", {"2", "2", "", "1", "", "1", "22", "", "1"}}};
    return kAnswers;
}

} // namespace

TEST_CASE("Lessons: every page of the thirteen lessons shows what it speaks of, and its question can be answered") {
    Learner learner;
    REQUIRE(learner.context().lessons.list.size() == 13);
    CHECK(learner.context().lessons.list[9].id == "10-dynamic-grid"); // after 9, not after 1
    for (const LessonEntry &entry : std::vector<LessonEntry>(learner.context().lessons.list)) {
        CAPTURE(entry.id);
        learner.click("lessons/" + entry.id);
        learner.settle();
        REQUIRE(learner.context().lessons.open);
        const std::size_t pages = entry.lesson->pages.size();
        REQUIRE(rightAnswers().at(entry.id).size() == pages);
        for (std::size_t page = 0; page < pages; ++page) {
            CAPTURE(page);
            REQUIRE(learner.open().page == page);
            const LessonPage &now = learner.open().now();
            CHECK(learner.has("lesson/title"));
            for (const LessonHighlight &highlight : now.highlights) {
                CHECK_MESSAGE(learner.has(highlight.widget), highlight.widget);
            }
            for (const std::string &paragraph : now.paragraphs) {
                CHECK(withValues(paragraph, learner.state()).find("\xe2\x80\x93") == std::string::npos);
            }
            REQUIRE(now.question);
            learner.answer(*now.question, rightAnswers().at(entry.id).at(page));
            const AnswerCount count = countKnown(learner.context(), entry.id);
            CHECK(count.answered + count.shown == page + 1);
            page + 1 < pages ? learner.key(key::kPageDown) : static_cast<void>(learner.click("lesson/next"));
            learner.settle();
        }
        CHECK_FALSE(learner.context().lessons.open);
    }
    for (const MessageLog::Entry &entry : learner.context().log.entries()) {
        CHECK_MESSAGE(!entry.diagnostic.code.starts_with("lesson-"), entry.diagnostic.message);
    }
}

TEST_CASE("Lessons: the list scrolls to the last lesson in a window too low for all of them") {
    Learner learner({}, {1280, 800}); // as laptops have
    const std::string last = "lessons/" + learner.context().lessons.list.back().id;
    const auto isInSight = [&] {
        const WidgetRegistry::Widget *const row = learner.context().widgets.find(last);
        return row != nullptr && row->visible && row->clip &&
               row->rect.y + row->rect.height <= row->clip->y + row->clip->height + 0.5;
    };
    REQUIRE_FALSE(isInSight());
    const PixelRect first = learner.context().widgets.find("lessons/1-front")->rect;
    learner.scroll(first.centre(), -30.0);
    learner.settle();
    CHECK(isInSight());
    learner.click(last);
    learner.settle();
    REQUIRE(learner.context().lessons.open);
    CHECK("lessons/" + learner.open().entry.id == last);
}

TEST_CASE("Lessons: a question is about the position of its page, wherever the run has moved since") {
    Learner learner;
    learner.click("lessons/4-rejections");
    learner.settle();
    learner.key(key::kPageDown);
    learner.settle();
    REQUIRE(valueOf(LessonValue::Rejected, learner.state()) == 2.0);
    learner.key(key::kPeriod);
    learner.settle();
    REQUIRE(learner.run().advance == 31);
    REQUIRE(valueOf(LessonValue::Rejected, learner.state()) == 0.0);
    learner.answer(*learner.open().now().question, "2");
    CHECK(valueOf(LessonValue::Advance, questionState(learner.context())) == 30.0);
}

TEST_CASE("Lessons: the explanation of a task stays about the state in which it was done") {
    Learner learner;
    learner.click("lessons/2-ten-steps");
    learner.settle();
    for (int page = 0; page < 3; ++page) {
        learner.key(key::kPageDown);
        learner.settle();
    }
    learner.answer(*learner.open().now().question, {});
    learner.key(key::kPeriod);
    learner.settle();
    CHECK(learner.run().advance == 66);
    CHECK(learner.has("lesson/shown"));
    CHECK(valueOf(LessonValue::Advance, questionState(learner.context())) == 65.0);
}

TEST_CASE("Lessons: a lesson opens again where it was left, and leaves layers and workspace as they were") {
    const TemporaryFolder folder;
    const std::string id = "1-front";
    {
        Learner learner({.settingsFolder = folder.path});
        LayerSlot *const labels = learner.context().layer("labels");
        showLayer(learner.context().layers, "labels", true);
        learner.workspace(WorkspaceKind::Size);
        learner.click("lessons/" + id);
        learner.settle();
        CHECK_FALSE(labels->visible);
        CHECK(learner.context().settings.workspace == WorkspaceKind::Step);
        learner.key(key::kPageDown);
        learner.settle();
        learner.key(key::kPageDown);
        learner.settle();
        learner.key(key::kPageUp);
        learner.settle();
        CHECK(learner.run().advance == 1);
        learner.click("lesson/list");
        learner.settle();
        CHECK(labels->visible);
        CHECK(learner.context().settings.workspace == WorkspaceKind::Size);
        CHECK(learner.has("lessons/" + id + "/progress"));
    }
    {
        Learner again({.settingsFolder = folder.path});
        again.click("lessons/" + id);
        again.settle();
        CHECK(again.open().page == 1);
        CHECK(again.run().advance == 1);
    }
    Learner last({.settingsFolder = folder.path}); // the one before was quit inside the lesson
    CHECK(last.context().layer("labels")->visible);
    CHECK(last.context().settings.workspace == WorkspaceKind::Size);
}

TEST_CASE("Lessons: pages set the scene again, whatever the learner did to it") {
    Learner learner;
    learner.click("lessons/1-front");
    learner.settle();
    const std::size_t shapes = learner.context().document.current()->shapes.size();
    Document changed = *learner.context().document.current();
    changed.shapes.clear();
    learner.context().document.apply(std::move(changed), "Delete");
    learner.settle();
    learner.key(key::kPageDown);
    learner.settle();
    CHECK_FALSE(learner.has("dialog/unsaved/discard")); // nobody drew it
    CHECK(learner.open().page == 1);
    CHECK(learner.context().document.current()->shapes.size() == shapes);
    CHECK(learner.run().advance == 1);
    CHECK_FALSE(learner.context().document.dirty());
}

TEST_CASE("Lessons: a page can follow the current advance, and resizing the window does not end that") {
    Learner learner;
    learner.click("lessons/2-ten-steps");
    learner.settle();
    const std::vector<LessonPage> &pages = learner.open().entry.lesson->pages;
    const auto page = std::find_if(pages.begin(), pages.end(), [](const LessonPage &p) { return p.camera.follow; });
    REQUIRE(page != pages.end());
    goToPage(learner.context(), static_cast<std::size_t>(page - pages.begin()));
    learner.settle();
    CHECK(learner.context().view.following);
    const Moment moment = momentOf(learner.run());
    REQUIRE(moment);
    const Box2 seen = learner.context().view.camera.visible(), advance = boxOf(*moment.advance);
    CHECK(seen.contains(advance.centre()));
    CHECK(seen.size().x < boundsOf(*learner.context().document.current()).size().x);
    learner.context().view.panels = false;
    learner.settle();
    CHECK(learner.context().view.following);
}

TEST_CASE("Lessons: a lesson of one's own is opened from its file, a broken one is refused with its place") {
    const TemporaryFolder folder;
    const auto write = [&](const char *name, const std::string &text) {
        std::filesystem::path file = folder.path / name;
        std::ofstream(file) << text;
        return file;
    };
    Learner learner;
    const std::string head = "{\"format\": \"forefront-lesson\", \"version\": 1, \"title\": \"Mine\",\n\"pages\": [";
    const auto own = write("mine.json", head + "{\"title\": \"P\", \"text\": \"Hello\"}]}");
    CHECK(openLessonFile(learner.context(), own).empty());
    learner.settle();
    CHECK(learner.open().entry.id == std::filesystem::canonical(own).string());
    CHECK(learner.has("lesson/place"));
    const auto broken = write("broken.json", head + "{\"title\": \"P\", \"text\": \"Hello\", \"layers\": [\"sky\"]}]}");
    const Diagnostics faults = openLessonFile(learner.context(), broken);
    REQUIRE(faults.size() == 1);
    CHECK(faults.front().line == 2);
    CHECK(faults.front().column > 50);
    CHECK(faults.front().file == broken.string());
    CHECK(learner.open().entry.file == own);
}

} // namespace forefront::test
