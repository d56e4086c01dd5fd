#include "tests/support/temporary_folder.hpp"
#include "tests/ui/driver.hpp"
#include "tests/ui/own_lesson.hpp"
#include "ui/lessons/kept_answers.hpp"
#include "ui/lessons/lesson_list.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/parts/shell.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace forefront::test {

namespace {

using testing::TemporaryFolder;

/// A learner whose answers are kept in a folder.
class Keeper : public Driver {
  public:
    explicit Keeper(const std::filesystem::path &folder) : Driver({.settingsFolder = folder}, {1280, 800}) {
        key(key::kF1 + 3);
        settle();
    }
    void open(const std::string &lesson, std::size_t page) {
        listLessons(context());
        for (const LessonEntry &entry : std::vector<LessonEntry>(context().lessons.list)) {
            if (entry.id == lesson) {
                openLesson(context(), entry);
            }
        }
        settle();
        REQUIRE(context().lessons.open);
        turnTo(page);
    }
    /// Pages count from 1.
    void turnTo(std::size_t page) {
        goToPage(context(), page - 1);
        settle();
    }
    void answer(const std::string &number) {
        key(key::k0, kAlt);
        settle();
        key('A', kControl);
        type(number);
        key(key::kEnter);
        settle();
    }
    const OpenLesson &lesson() { return *context().lessons.open; }
};

std::string contentOf(const std::filesystem::path &file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

} // namespace

TEST_CASE("Lessons: answers are kept as they are given, and a program started anew shows and saves them") {
    const TemporaryFolder folder;
    Keeper killed(folder.path); // never quits
    killed.open("10-dynamic-grid", 1);
    killed.key(key::k0 + 2, kAlt);
    killed.settle();
    REQUIRE(killed.has("lesson/right"));
    killed.turnTo(4);
    killed.answer("232");
    killed.answer("129");
    REQUIRE(killed.has("lesson/right"));

    Keeper again(folder.path);
    again.open("10-dynamic-grid", 1);
    CHECK(again.has("lesson/right"));
    CHECK(again.lesson().picked == 1U);
    CHECK(again.has("lesson/save"));
    again.turnTo(2);
    CHECK_FALSE(again.has("lesson/right"));
    again.turnTo(4);
    CHECK(again.has("lesson/right"));
    CHECK(again.lesson().typed == "129");
    const LearnerAnswers *const kept = knownAnswers(again.context(), "10-dynamic-grid");
    REQUIRE(kept != nullptr);
    REQUIRE(kept->given.pages[3].answers.size() == 2); // with the wrong try
    CHECK(kept->given.pages[3].answers[0].text == "232");
    again.turnTo(6);
    again.click("lesson/next"); // Finish
    again.settle();
    CHECK_FALSE(again.context().lessons.open);
    CHECK(again.context().actions.find("lesson.saveAnswers")->enabled(again.context()));
    again.click("lessons/10-dynamic-grid/save");
    again.settle();
    CHECK(again.has("dialog/saveanswers"));
}

TEST_CASE("Lessons: the random numbers of a lesson are kept with the answers to them") {
    const TemporaryFolder folder;
    {
        Keeper first(folder.path);
        first.open("10-dynamic-grid", 4);
        first.click("lesson/numbers");
        first.settle();
        REQUIRE(first.lesson().entry.lesson->seed == 2);
        first.answer("1");
    }
    std::filesystem::remove(folder.path / "settings.json");
    Keeper again(folder.path);
    again.open("10-dynamic-grid", 4);
    CHECK(again.lesson().entry.lesson->seed == 2);
    CHECK(again.has("lesson/wrong"));
    CHECK(again.lesson().typed == "1");
}

TEST_CASE("Lessons: Forget answers begins anew, after asking, and removes what was kept") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "answers" / "3-ideal-point.json";
    Keeper keeper(folder.path);
    keeper.open("3-ideal-point", 3);
    keeper.answer("0.99");
    REQUIRE(keeper.has("lesson/right"));
    REQUIRE(std::filesystem::exists(file));
    keeper.click("lesson/forget");
    keeper.settle();
    keeper.click("dialog/answers/cancel");
    keeper.settle();
    CHECK(std::filesystem::exists(file));
    keeper.click("lesson/forget");
    keeper.settle();
    keeper.click("dialog/answers/forget");
    keeper.settle();
    CHECK_FALSE(std::filesystem::exists(file));
    CHECK(keeper.lesson().page == 0);
    CHECK_FALSE(keeper.has("lesson/save"));
    keeper.turnTo(3);
    CHECK_FALSE(keeper.has("lesson/right"));
    CHECK(keeper.lesson().typed.empty());
}

TEST_CASE("Lessons: kept answers that cannot be read are set aside with a warning") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "answers" / "3-ideal-point.json";
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << "{\"format\": \"forefront-ans";
    Keeper keeper(folder.path);
    keeper.open("3-ideal-point", 3);
    CHECK_FALSE(std::filesystem::exists(file));
    CHECK(contentOf(file.string() + ".old") == "{\"format\": \"forefront-ans");
    bool warned = false;
    for (const MessageLog::Entry &entry : keeper.context().log.entries()) {
        warned = warned || entry.diagnostic.message.starts_with("cannot use the kept answers: ");
    }
    CHECK(warned);
}

TEST_CASE("Lessons: answers to another version of a lesson are not dropped without asking") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "mine.json";
    writeOwnLesson(file, "first");
    {
        Keeper keeper(folder.path);
        REQUIRE(openLessonFile(keeper.context(), file).empty());
        keeper.settle();
        keeper.click("lesson/choice/0");
        keeper.settle();
        REQUIRE(keeper.has("lesson/right"));
    }
    writeOwnLesson(file, "second");
    Keeper keeper(folder.path);
    REQUIRE(openLessonFile(keeper.context(), file).empty());
    keeper.settle();
    REQUIRE(keeper.has("dialog/answers/cancel"));
    keeper.click("dialog/answers/cancel");
    keeper.settle();
    CHECK_FALSE(keeper.context().lessons.open);
    writeOwnLesson(file, "first");
    REQUIRE(openLessonFile(keeper.context(), file).empty());
    keeper.settle();
    CHECK(keeper.has("lesson/right"));
}

TEST_CASE("Lessons: of two windows that answer one lesson, the file holds the answers of both") {
    const TemporaryFolder folder;
    Keeper one(folder.path), two(folder.path);
    one.open("10-dynamic-grid", 4);
    two.open("10-dynamic-grid", 1);
    one.answer("232");
    two.key(key::k0 + 2, kAlt); // does not know the answer of the other window
    two.settle();
    one.answer("129");
    REQUIRE(one.has("lesson/right"));

    Keeper again(folder.path);
    again.open("10-dynamic-grid", 4);
    const LearnerAnswers *const kept = knownAnswers(again.context(), "10-dynamic-grid");
    REQUIRE(kept != nullptr);
    REQUIRE(kept->given.pages[0].answers.size() == 1);
    REQUIRE(kept->given.pages[3].answers.size() == 2); // each once
    CHECK(kept->given.pages[3].answers[0].text == "232");
    CHECK(kept->given.pages[3].answers[1].text == "129");

    // Answers to other numbers are no answers to these: they are set aside.
    one.click("lesson/numbers");
    one.settle();
    one.click("dialog/answers/forget");
    one.settle();
    one.answer("1");
    two.turnTo(4);
    two.answer("129");
    CHECK(std::filesystem::exists(folder.path / "answers" / "10-dynamic-grid.json.old"));
    bool warned = false;
    for (const MessageLog::Entry &entry : two.context().log.entries()) {
        warned = warned || entry.diagnostic.message.find("another window has answered") != std::string::npos;
    }
    CHECK(warned);
}

TEST_CASE("Lessons: a task done by Show me counts as shown, in the list and in the file") {
    const TemporaryFolder folder;
    Keeper keeper(folder.path);
    keeper.open("10-dynamic-grid", 5);
    keeper.key('H', kAlt);
    keeper.settle();
    CHECK(keeper.has("lesson/shown"));
    CHECK_FALSE(keeper.has("lesson/right"));
    const auto [answered, shown] = countKnown(keeper.context(), "10-dynamic-grid");
    CHECK(answered == 0);
    CHECK(shown == 1);
    const std::string kept = contentOf(folder.path / "answers" / "10-dynamic-grid.json");
    CHECK(kept.find("\"shown\": true") != std::string::npos);
    CHECK(kept.find("\"right\": true") == std::string::npos);
    keeper.turnTo(4);
    keeper.turnTo(5);
    CHECK(keeper.lesson().before == "Shown before, not done");
}

TEST_CASE("Lessons: the pane scrolls to the verdict and its explanation, and to the top of the next page") {
    Keeper keeper({});
    struct Asked {
        const char *lesson;
        std::size_t page;
        int right;
    };
    for (const Asked &asked :
         {Asked{"12-three-dimensions", 4, 2}, Asked{"9-adaptive", 2, 2}, Asked{"10-dynamic-grid", 3, 2},
          Asked{"11-many-at-once", 3, 3}, Asked{"11-many-at-once", 4, 1}}) {
        CAPTURE(asked.lesson);
        CAPTURE(asked.page);
        keeper.open(asked.lesson, asked.page);
        keeper.key(key::k0 + asked.right, kAlt);
        keeper.settle();
        for (const char *part : {"lesson/right", "lesson/why"}) {
            CAPTURE(part);
            const WidgetRegistry::Widget *const widget = keeper.context().widgets.find(part);
            REQUIRE(widget != nullptr);
            REQUIRE(widget->clip);
            CHECK(widget->rect.y >= widget->clip->y - 0.5);
            CHECK(widget->rect.y + widget->rect.height <= widget->clip->y + widget->clip->height + 0.5);
        }
        keeper.key(key::kPageDown);
        keeper.settle();
        const WidgetRegistry::Widget *const title = keeper.context().widgets.find("lesson/title");
        REQUIRE(title != nullptr);
        CHECK(title->rect.y >= title->clip->y - 0.5);
        closeLesson(keeper.context());
        keeper.settle();
    }
}

TEST_CASE("Lessons: the unit of the steps that a page asks for ends with the lesson") {
    Keeper keeper({});
    keeper.context().run.granularity = Granularity::Layer;
    keeper.open("10-dynamic-grid", 3);
    CHECK(keeper.context().run.granularity == Granularity::Advance); // lessons count in advances
    keeper.click("timeline/granularity/Event");
    keeper.settle();
    REQUIRE(keeper.context().run.granularity == Granularity::Event);
    keeper.open("11-many-at-once", 1);
    CHECK(keeper.context().run.granularity == Granularity::Advance);
    keeper.click("lesson/list");
    keeper.settle();
    CHECK(keeper.context().run.granularity == Granularity::Layer);
}

TEST_CASE("Lessons: keys turn the page while the field for a number has the focus") {
    Keeper keeper({});
    keeper.open("3-ideal-point", 3);
    keeper.answer("0.5");
    REQUIRE(keeper.has("lesson/wrong"));
    keeper.key(key::kPageDown);
    keeper.settle();
    CHECK(keeper.lesson().page == 3);
    keeper.turnTo(3);
    keeper.answer("0.5");
    keeper.key(key::kPageUp);
    keeper.settle();
    CHECK(keeper.lesson().page == 1);
}

TEST_CASE("Lessons: each of the list has a number and a key, and the list shows the one that was left") {
    Keeper keeper({});
    listLessons(keeper.context());
    REQUIRE(keeper.context().lessons.list.size() == 13);
    const auto opened = [&](int key, Modifiers modifiers) {
        keeper.key(key, modifiers);
        keeper.settle();
        REQUIRE(keeper.context().lessons.open);
        const std::string id = keeper.lesson().entry.id;
        closeLesson(keeper.context());
        keeper.settle();
        return id;
    };
    constexpr Modifiers kAltShift{Modifiers::kAlt | Modifiers::kShift};
    CHECK(opened(key::k0 + 9, kAlt) == "9-adaptive");
    CHECK(opened(key::k0, kAlt) == "10-dynamic-grid");
    CHECK(opened(key::k0 + 1, kAltShift) == "11-many-at-once");
    CHECK(opened(key::k0 + 3, kAltShift) == "13-quadrilaterals");
    const WidgetRegistry::Widget *const row = keeper.context().widgets.find("lessons/13-quadrilaterals");
    REQUIRE(row != nullptr);
    REQUIRE(row->clip);
    CHECK(row->rect.y >= row->clip->y);
    CHECK(row->rect.y + row->rect.height <= row->clip->y + row->clip->height + 0.5);
}

TEST_CASE("Lessons: the panels that a page is about have room at 1280 by 800, and so has one that the learner opens") {
    Keeper keeper({});
    const auto isInSight = [&](const char *name) {
        const WidgetRegistry::Widget *const widget = keeper.context().widgets.find(name);
        return widget != nullptr && widget->clip && widget->rect.y >= widget->clip->y - 0.5 &&
               widget->rect.y + widget->rect.height <= widget->clip->y + widget->clip->height + 0.5;
    };
    keeper.open("12-three-dimensions", 4);
    keeper.click("panel/rules");
    keeper.settle();
    REQUIRE(keeper.has("rules/save"));
    CHECK(keeper.context().widgets.find("rules/save")->clip->height > 200.0);
    const PixelRect heading = keeper.context().widgets.find("panel/rules")->rect;
    keeper.key(key::kPeriod);
    keeper.settle();
    CHECK(keeper.context().widgets.find("panel/rules")->rect.y == heading.y); // stays where it is while stepping
    keeper.open("10-dynamic-grid", 5); // what was opened there does not take its room
    CHECK(isInSight("steps/5"));
    keeper.turnTo(6);
    CHECK(isInSight("steps/5"));
    CHECK(isInSight("statistics/cells"));
    keeper.open("9-adaptive", 7);
    CHECK(isInSight("adapt/start"));
    CHECK(isInSight("steps/5"));
    keeper.click("adapt/expression");
    keeper.type("atan(2*(hypot(x-10,y-7)-4))");
    keeper.key(key::kEnter);
    keeper.settle();
    keeper.click("adapt/error");
    keeper.key('A', kControl);
    keeper.type("20");
    keeper.key(key::kEnter);
    keeper.settle();
    keeper.click("adapt/start");
    keeper.until([&] { return !keeper.context().adaptation.busy(); });
    keeper.settle();
    CHECK(isInSight("adapt/round/3"));
    CHECK(isInSight("adapt/slope"));
}

TEST_CASE("Lessons: colours of a mesh that a lesson has shown end with it") {
    Keeper keeper({});
    keeper.open("9-adaptive", 7);
    showMeshColours(keeper.context()); // as a round of the adaptation does
    closeLesson(keeper.context());
    keeper.settle();
    for (const WorkspaceKind kind : {WorkspaceKind::Mesh, WorkspaceKind::Step}) {
        keeper.workspace(kind);
        keeper.settle();
        CHECK_FALSE(keeper.context().layer("quality")->visible);
    }
}

} // namespace forefront::test
