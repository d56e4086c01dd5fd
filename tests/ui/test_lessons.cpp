#include "tests/ui/edit_driver.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/platform/assets.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>

namespace forefront::test {

namespace {

constexpr Modifiers kAlt{Modifiers::kAlt};

/// Answers the questions of lessons as a learner does, with the keyboard.
class Learner : public Driver {
  public:
    explicit Learner(EditorSetup setup = {}) : Driver(std::move(setup), {1400, 900}) {
        key(key::kF1 + 1);
        settle();
    }

    const OpenLesson &open() { return *context().lessons.open; }
    LessonState state() { return lessonState(context()); }

    void answerChoice(const LessonChoices &choices) {
        std::vector<std::size_t> right;
        for (std::size_t k = 0; k < choices.list.size(); ++k) {
            if (isRight(choices, k, state())) {
                right.push_back(k);
            }
        }
        REQUIRE(right.size() == 1);
        for (std::size_t k = 0; k < choices.list.size(); ++k) {
            if (k != right.front()) {
                pick(k);
                CHECK(has("lesson/wrong"));
            }
        }
        pick(right.front());
    }

    void answerNumber(const LessonNumber &question) {
        const std::optional<double> value = valueOf(question.value, state());
        REQUIRE(value);
        enter(std::to_string(std::lround(*value) + 100));
        CHECK(has("lesson/wrong"));
        enter(withValues(std::string("{").append(wordOf(question.value)) + '}', state()));
    }

    void doTask(const LessonQuestion &question) {
        CHECK_FALSE(has("lesson/right"));
        if (question.show) {
            key('H', kAlt);
        } else {
            const auto winner = valueOf(LessonValue::Winner, state());
            REQUIRE(winner);
            click("candidates/" + std::to_string(std::lround(*winner) - 1));
        }
        settle();
    }

    void answer(const LessonQuestion &question) {
        if (const auto *choices = std::get_if<LessonChoices>(&question.answer)) {
            answerChoice(*choices);
        } else if (const auto *number = std::get_if<LessonNumber>(&question.answer)) {
            answerNumber(*number);
        } else {
            doTask(question);
        }
        CHECK(has("lesson/right"));
        CHECK_FALSE(has("lesson/wrong"));
    }

  private:
    void pick(std::size_t choice) {
        key(key::k0 + 1 + static_cast<int>(choice), kAlt);
        settle();
    }
    void enter(const std::string &text) {
        context().lessons.open->typed.clear();
        key(key::k0, kAlt);
        settle();
        type(text);
        key(key::kEnter);
        settle();
    }
};

} // namespace

TEST_CASE("Lessons: every page of the eight lessons shows what it speaks of, and its question can be answered") {
    Learner learner;
    REQUIRE(learner.context().lessons.list.size() == 8);
    for (const LessonEntry &entry : std::vector<LessonEntry>(learner.context().lessons.list)) {
        CAPTURE(entry.id);
        learner.click("lessons/" + entry.id);
        learner.settle();
        REQUIRE(learner.context().lessons.open);
        const std::size_t pages = entry.lesson->pages.size();
        CHECK(pages >= 5);
        for (std::size_t page = 0; page < pages; ++page) {
            CAPTURE(page);
            REQUIRE(learner.open().page == page);
            const LessonPage &now = learner.open().now();
            CHECK(learner.has("lesson/title"));
            for (const std::string &name : now.highlights) {
                CHECK_MESSAGE(learner.has(name), name);
            }
            for (const std::string &paragraph : now.paragraphs) {
                CHECK(withValues(paragraph, learner.state()).find("\xe2\x80\x93") == std::string::npos);
            }
            REQUIRE(now.question);
            learner.answer(*now.question);
            CHECK(learner.context().settings.lessons[entry.id].answered.contains(page));
            page + 1 < pages ? learner.key(key::kPageDown) : static_cast<void>(learner.click("lesson/next"));
            learner.settle();
        }
        CHECK_FALSE(learner.context().lessons.open);
    }
}

TEST_CASE("Lessons: a lesson opens again where it was left, and leaves layers and tab as they were") {
    const TemporaryFolder folder;
    const std::string id = "1-front";
    {
        Learner learner({.settingsFolder = folder.path});
        LayerSlot *const labels = learner.context().layer("labels");
        showLayer(learner.context().layers, "labels", true);
        learner.context().settings.tab = "log";
        learner.click("lessons/" + id);
        learner.settle();
        CHECK_FALSE(labels->visible);
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
        CHECK(learner.context().settings.tab == "log");
        CHECK(learner.has("lessons/" + id + "/progress"));
    }
    Learner again({.settingsFolder = folder.path});
    again.click("lessons/" + id);
    again.settle();
    CHECK(again.open().page == 1);
    CHECK(again.run().advance == 1);
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
    CHECK(learner.click("dialog/unsaved/discard"));
    learner.settle();
    CHECK(learner.open().page == 1);
    CHECK(learner.context().document.current()->shapes.size() == shapes);
    CHECK(learner.run().advance == 1);
    CHECK_FALSE(learner.context().document.dirty());
}

TEST_CASE("Lessons: a lesson of one's own is opened from its file, a broken one is refused with its place") {
    const TemporaryFolder folder;
    const auto write = [&](const char *name, const std::string &text) {
        const std::filesystem::path file = folder.path / name;
        std::ofstream(file) << text;
        return file;
    };
    Learner learner;
    const std::string head = "{\"format\": \"forefront-lesson\", \"version\": 1, \"title\": \"Mine\",\n\"pages\": [";
    const auto own = write("mine.json", head + "{\"title\": \"P\", \"text\": \"Hello\"}]}");
    CHECK(openLessonFile(learner.context(), own).empty());
    learner.settle();
    CHECK(learner.open().entry.id == "mine");
    CHECK(learner.has("lesson/place"));
    const auto broken = write("broken.json", head + "{\"title\": \"P\", \"text\": \"Hello\", \"layers\": [\"sky\"]}]}");
    const Diagnostics faults = openLessonFile(learner.context(), broken);
    REQUIRE(faults.size() == 1);
    CHECK(faults.front().line == 2);
    CHECK(faults.front().column > 50);
    CHECK(faults.front().file == broken.string());
    CHECK(learner.open().entry.id == "mine");
}

} // namespace forefront::test
