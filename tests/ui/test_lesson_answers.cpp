#include "core/teaching/lesson/lesson_run.hpp"
#include "tests/ui/edit_driver.hpp"
#include "tests/ui/own_lesson.hpp"
#include "ui/dialogs/tab_commands.hpp"
#include "ui/lessons/kept_answers.hpp"
#include "ui/lessons/lesson_list.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/workspace/judging.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

namespace forefront::test {

namespace {

/// Reads the lessons with the keyboard alone, but for clicks on the canvas and in panels.
class Reader : public Driver {
  public:
    Reader() : Driver({}, {1400, 900}) {
        key(key::kF1 + 3);
        settle();
    }
    /// Opens a lesson by its number in the list, at a page; both count from 1.
    void open(int lesson, std::size_t page) {
        key(key::k0 + lesson, kAlt);
        settle();
        REQUIRE(context().lessons.open);
        goToPage(context(), page - 1);
        settle();
    }
    void answer(const std::string &number) {
        key(key::k0, kAlt);
        settle();
        retype(number);
    }
    /// Types over the text of the field that has the focus.
    void retype(const std::string &text) {
        key('A', kControl);
        type(text);
        key(key::kEnter);
        settle();
    }
};

} // namespace

TEST_CASE("Lessons: a number may have a comma, and a text that is no number is said to be none") {
    Reader reader;
    reader.open(3, 3);
    reader.answer("abc");
    CHECK(reader.has("lesson/complaint"));
    CHECK_FALSE(reader.has("lesson/wrong"));
    CHECK(reader.context().lessons.open->complaint == "'abc' is not a number; expected one such as 12 or 0.5.");
    reader.retype("0,5"); // the field keeps the focus for another try
    CHECK_FALSE(reader.has("lesson/complaint"));
    CHECK(reader.has("lesson/wrong"));
    reader.retype("0,99");
    CHECK(reader.has("lesson/right"));
    CHECK(reader.context().selection.empty());
}

TEST_CASE("Lessons: a wrong candidate gets a hint, and choosing none takes it away") {
    Reader reader;
    reader.open(3, 4);
    CHECK_FALSE(reader.has("lesson/wrong"));
    reader.click("candidates/1");
    reader.settle();
    CHECK(reader.has("lesson/wrong"));
    reader.click("candidates/1");
    reader.settle();
    CHECK_FALSE(reader.has("lesson/wrong"));
    reader.click("candidates/0");
    reader.settle();
    CHECK(reader.has("lesson/right"));
}

TEST_CASE("Lessons: the text of a page is about its position, wherever the run has moved since") {
    Reader reader;
    reader.open(7, 2);
    REQUIRE(valueOf(LessonValue::Front, pageState(reader.context())) == 3.0);
    reader.key(key::kEnd);
    reader.settle();
    REQUIRE(reader.run().frontSegments == 0);
    CHECK(valueOf(LessonValue::Front, pageState(reader.context())) == 3.0);
}

TEST_CASE("Lessons: Page Down on the last page returns to the list, and the lesson begins anew") {
    Reader reader;
    reader.open(2, 5);
    reader.key(key::kPageDown);
    reader.settle();
    CHECK_FALSE(reader.context().lessons.open);
    CHECK(reader.has("lessons/2-ten-steps/progress"));
    reader.key(key::k0 + 2, kAlt);
    reader.settle();
    REQUIRE(reader.context().lessons.open);
    CHECK(reader.context().lessons.open->page == 0);
}

TEST_CASE("Lessons: one that is left at its last page with all questions answered begins anew, too") {
    Reader reader;
    const auto leaveAtLastPage = [&] {
        reader.open(4, 5);
        reader.click("lesson/list");
        reader.settle();
        reader.key(key::k0 + 4, kAlt);
        reader.settle();
        return reader.context().lessons.open->page;
    };
    CHECK(leaveAtLastPage() == 4);
    reader.click("lesson/list");
    reader.settle();
    LearnerAnswers &answers = openAnswers(reader.context(), reader.context().lessons.list[3]);
    REQUIRE(answers.given.pages.size() == 5);
    for (PageAnswers &page : answers.given.pages) {
        page.answers = {{"as it was", true}};
    }
    CHECK(leaveAtLastPage() == 0);
}

TEST_CASE("Lessons: a drawing of one's own is not left without asking, one that a lesson brought is") {
    Reader reader;
    const auto clear = [&] {
        Document changed = *reader.context().document.current();
        changed.shapes.clear();
        reader.context().document.apply(std::move(changed), "Delete");
        reader.settle();
    };
    reader.open(1, 1);
    clear();
    reader.click("lesson/list");
    reader.settle();
    reader.key(key::k0 + 2, kAlt);
    reader.settle();
    REQUIRE(reader.context().lessons.open);
    CHECK(reader.context().lessons.open->entry.id == "2-ten-steps");
    reader.context().document.load(*reader.context().document.current(), {}); // New and Open load a document, too
    clear();
    reader.key(key::kPageDown);
    reader.settle();
    CHECK(reader.has("dialog/unsaved/cancel"));
    CHECK(reader.context().lessons.open->page == 0);
}

TEST_CASE("Lessons: pages that compare the shapes of two meshes use the same colours") {
    Reader reader;
    for (const std::size_t page : {2, 3}) {
        reader.open(6, page);
        CHECK(reader.context().view.measureRange == ColourRange{0.4, 1.0});
        closeLesson(reader.context());
        reader.settle();
        CHECK_FALSE(reader.context().view.measureRange);
    }
}

TEST_CASE("Lessons: the measure and the colour range of before come back when a lesson is left") {
    Reader reader;
    chooseMeasure(reader.context(), Measure::MinAngle);
    reader.context().view.measureRange = ColourRange{20.0, 50.0};
    reader.open(6, 2);
    REQUIRE(reader.context().view.measure == Measure::ShapeFactor);
    reader.click("lesson/list");
    reader.settle();
    CHECK(reader.context().view.measure == Measure::MinAngle);
    CHECK(reader.context().view.measureRange == ColourRange{20.0, 50.0});
}

TEST_CASE("Lessons: the user's drawing comes back when the lesson is closed, and the tool is the one for selecting") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {4, 3});
    driver.settle();
    const std::shared_ptr<const Document> mine = driver.context().document.current();
    listLessons(driver.context());
    REQUIRE(driver.context().lessons.list.size() >= 2);
    openLesson(driver.context(), driver.context().lessons.list[0]);
    driver.settle();
    if (driver.has("dialog/unsaved/discard")) {
        driver.click("dialog/unsaved/discard");
        driver.settle();
    }
    REQUIRE(driver.context().lessons.open);
    CHECK(driver.context().tools.current().id() == std::string("select"));
    CHECK(driver.document().shapes.size() != 1);
    openLesson(driver.context(), driver.context().lessons.list[1]); // from one lesson to the next
    driver.settle();
    closeLesson(driver.context());
    driver.settle();
    REQUIRE(driver.document().shapes.size() == 1);
    CHECK(driver.document().shapes == mine->shapes);
    CHECK(driver.context().document.dirty());
}

TEST_CASE("Lessons: a wrong answer has a hint of its own, and answers are saved as a file") {
    const TemporaryFolder folder;
    Reader reader;
    reader.click("lessons/10-dynamic-grid");
    reader.settle();
    CHECK_FALSE(reader.has("lesson/save"));
    reader.key(key::k0 + 1, kAlt); // 5 by 4 cells
    reader.settle();
    CHECK(reader.context().lessons.open->hint == "20.8 + 2.1 = 22.9. Another grid has less.");
    reader.key(key::k0 + 2, kAlt);
    reader.settle();
    CHECK(reader.has("lesson/right"));
    goToPage(reader.context(), 3);
    reader.settle();
    reader.answer("232"); // triangles, not segments
    CHECK(reader.context().lessons.open->hint.starts_with("That is the number of triangles."));
    reader.retype("129");
    CHECK(reader.has("lesson/right"));
    reader.click("lesson/save");
    reader.settle();
    REQUIRE(reader.has("dialog/saveanswers"));
    const LessonAnswers &given = reader.context().lessons.answers.at("10-dynamic-grid").given;
    REQUIRE(given.pages.size() == 6);
    CHECK(given.seed == 1);
    REQUIRE(given.pages[0].answers.size() == 2);
    CHECK(given.pages[0].answers[1].text == "10 by 7");
    CHECK(given.pages[0].answers[1].right);
    REQUIRE(given.pages[3].answers.size() == 2);
    CHECK_FALSE(given.pages[3].answers[0].right);
    CHECK(given.pages[3].question.find("after 232 advances") != std::string::npos);
}

TEST_CASE("Lessons: other numbers are drawn for another seed, and answers are forgotten after a question") {
    Reader reader;
    reader.click("lessons/10-dynamic-grid");
    reader.settle();
    goToPage(reader.context(), 3);
    reader.settle();
    REQUIRE(reader.run().advance == 232);
    reader.answer("129");
    REQUIRE(reader.has("lesson/right"));
    reader.click("lesson/numbers");
    reader.settle();
    reader.click("dialog/answers/cancel");
    reader.settle();
    CHECK(reader.context().lessons.open->entry.lesson->seed == 1);
    CHECK(reader.has("lesson/save"));
    reader.click("lesson/numbers");
    reader.settle();
    reader.click("dialog/answers/forget");
    reader.settle();
    CHECK(reader.context().lessons.open->page == 3);
    CHECK(reader.context().lessons.open->entry.lesson->seed == 2);
    CHECK(reader.context().settings.lessons["10-dynamic-grid"].seed == 2);
    CHECK(reader.run().advance != 232);
    CHECK_FALSE(reader.has("lesson/right"));
    CHECK_FALSE(reader.has("lesson/save"));
    CHECK(countKnown(reader.context(), "10-dynamic-grid").answered == 0);
    reader.click("lesson/numbers"); // no answers, no question
    reader.settle();
    CHECK(reader.context().lessons.open->entry.lesson->seed == 3);
}

TEST_CASE("Lessons: what is done with another drawing or other options is no answer, which the page says at once") {
    Reader reader;
    reader.open(1, 3); // until 10 elements are made
    CHECK_FALSE(reader.has("lesson/changed"));
    Document changed = *reader.context().document.current();
    changed.options.rules.radius = 2.5;
    reader.context().document.apply(std::move(changed), "Rules");
    reader.settle();
    CHECK_FALSE(reader.has("lesson/changed")); // the run is still that of the page
    reader.context().run.mesh();
    reader.settle();
    CHECK(reader.has("lesson/changed"));
    reader.context().run.seek(10);
    reader.settle();
    REQUIRE(reader.run().work.elements == 10);
    CHECK_FALSE(reader.has("lesson/right"));
    CHECK_FALSE(reader.has("lesson/save")); // nothing was recorded
    reader.context().document.undo();
    reader.settle();
    CHECK(reader.has("lesson/changed")); // the run is not undone
    reader.click("lesson/bringback");
    reader.settle();
    CHECK_FALSE(reader.has("lesson/changed"));
    reader.context().run.seek(10);
    reader.settle();
    CHECK(reader.has("lesson/right"));
    const LearnerAnswers &answers = reader.context().lessons.answers.at("1-front");
    REQUIRE(answers.given.pages[2].answers.size() == 1);
    LessonRuns runs;
    const std::string text = answersText(answers.given);
    SourceText source;
    source.text = text;
    const Result<AnswerScore> score =
        checkAnswers(answers.given, source, *reader.context().lessons.open->entry.lesson, runs, {});
    REQUIRE(score.ok());
    CHECK(score->answered == 1);
}

TEST_CASE("Lessons: a candidate of another run is no wrong answer") {
    Reader reader;
    reader.open(3, 4); // asks for the winner
    Document changed = *reader.context().document.current();
    changed.spacing.size = 1.1 * changed.spacing.size.value_or(0.5);
    reader.context().document.apply(std::move(changed), "Size");
    reader.context().run.mesh();
    reader.settle();
    reader.context().run.seek(3);
    reader.settle();
    reader.click("candidates/0");
    reader.settle();
    CHECK(reader.has("lesson/changed"));
    CHECK_FALSE(reader.has("lesson/wrong"));
    CHECK_FALSE(reader.has("lesson/right"));
    CHECK_FALSE(reader.has("lesson/save"));
}

TEST_CASE("Lessons: opening the file of a lesson again keeps the answers, or asks if the file has changed") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "mine.json";
    writeOwnLesson(file, "first");
    Draughtsman driver;
    driver.rectangle({1, 1}, {4, 3});
    const auto open = [&] {
        const Diagnostics faults = openLessonFile(driver.context(), file);
        CHECK(faults.empty());
        driver.settle();
    };
    open();
    driver.click("dialog/unsaved/discard");
    driver.settle();
    REQUIRE(driver.context().lessons.open);
    const std::string id = driver.context().lessons.open->entry.id;
    const auto answers = [&] {
        const auto known = driver.context().lessons.answers.find(id);
        return known == driver.context().lessons.answers.end() ? 0 : known->second.given.pages[0].answers.size();
    };
    driver.click("lesson/choice/0");
    driver.settle();
    REQUIRE(answers() == 1);
    open(); // unchanged
    CHECK_FALSE(driver.has("dialog/answers/cancel"));
    if (driver.has("dialog/unsaved/discard")) {
        driver.click("dialog/unsaved/discard");
        driver.settle();
    }
    CHECK(answers() == 1);
    writeOwnLesson(file, "second");
    open();
    REQUIRE(driver.has("dialog/answers/cancel"));
    CHECK(answers() == 1);
    driver.click("dialog/answers/cancel");
    driver.settle();
    CHECK(answers() == 1);
    CHECK(driver.context().lessons.open->entry.lesson->pages[0].paragraphs[0] == "first");
    open();
    driver.click("dialog/answers/forget");
    driver.settle();
    if (driver.has("dialog/unsaved/cancel")) { // about the drawing of one's own, which the lesson would replace
        driver.click("dialog/unsaved/cancel");
        driver.settle();
        CHECK(answers() == 1); // nothing is forgotten until the lesson opens
        open();
        driver.click("dialog/answers/forget");
        driver.settle();
        driver.click("dialog/unsaved/discard");
        driver.settle();
    }
    CHECK(answers() == 0);
    CHECK(driver.context().lessons.open->entry.lesson->pages[0].paragraphs[0] == "second");
}

TEST_CASE("Lessons: a lesson goes on in its own tab, and the drawing that it replaced comes back there") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {4, 3});
    newTab(driver.context());
    driver.settle();
    driver.rectangle({1, 1}, {4, 3});
    driver.rectangle({5, 1}, {8, 3});
    listLessons(driver.context());
    REQUIRE_FALSE(driver.context().lessons.list.empty());
    openLesson(driver.context(), driver.context().lessons.list[0]);
    driver.settle();
    driver.click("dialog/unsaved/discard");
    driver.settle();
    REQUIRE(driver.context().lessons.open);
    showTab(driver.context(), 0);
    driver.settle();
    goToPage(driver.context(), 1);
    driver.settle();
    CHECK(driver.context().tabs.active() == 1);
    showTab(driver.context(), 0);
    driver.settle();
    CHECK(driver.document().shapes.size() == 1);
    closeLesson(driver.context());
    driver.settle();
    CHECK(driver.context().tabs.active() == 1);
    CHECK(driver.document().shapes.size() == 2);
    openLesson(driver.context(), driver.context().lessons.list[0]);
    driver.settle();
    driver.click("dialog/unsaved/discard");
    driver.settle();
    showTab(driver.context(), 0);
    closeTab(driver.context(), 1);
    driver.settle();
    REQUIRE(driver.has("dialog/unsaved/cancel")); // about the drawing that came back
    driver.click("dialog/unsaved/cancel");
    driver.settle();
    CHECK_FALSE(driver.context().lessons.open);
    CHECK(driver.document().shapes.size() == 2);
}

} // namespace forefront::test
