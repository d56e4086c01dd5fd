#include "tests/ui/edit_driver.hpp"
#include "ui/dialogs/tab_commands.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/workspace/judging.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>

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
    reader.context().settings.lessons["4-rejections"].answered = {0, 1, 2, 3, 4};
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
    const LessonAnswers &given = reader.context().lessons.answers.at("10-dynamic-grid");
    REQUIRE(given.pages.size() == 6);
    CHECK(given.seed == 1);
    REQUIRE(given.pages[0].answers.size() == 2);
    CHECK(given.pages[0].answers[1].text == "10 by 7");
    CHECK(given.pages[0].answers[1].right);
    REQUIRE(given.pages[3].answers.size() == 2);
    CHECK_FALSE(given.pages[3].answers[0].right);
    CHECK(given.pages[3].question.find("after 232 advances") != std::string::npos);
}

TEST_CASE("Lessons: other numbers are drawn for another seed, and answers are forgotten") {
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
    CHECK(reader.context().lessons.open->page == 3);
    CHECK(reader.context().lessons.open->entry.lesson->seed == 2);
    CHECK(reader.context().settings.lessons["10-dynamic-grid"].seed == 2);
    CHECK(reader.run().advance != 232);
    CHECK_FALSE(reader.has("lesson/right"));
    CHECK_FALSE(reader.has("lesson/save"));
    CHECK(reader.context().settings.lessons["10-dynamic-grid"].answered.empty());
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
