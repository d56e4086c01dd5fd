#include "core/engine/base/number_text.hpp"
#include "core/teaching/lesson/lesson_names.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/lessons/highlight_names.hpp"
#include "ui/lessons/lesson_list.hpp"
#include "ui/platform/assets.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace forefront::test {

namespace {

/// Lessons with the drawing of a square, written to a folder of their own.
class Author : public Driver {
  public:
    explicit Author(PixelSize size = {1400, 900}) : Driver({}, size) {
        key(key::kF1 + 3);
        settle();
        std::filesystem::copy(lessonFiles().front().parent_path() / "drawings", folder_.path / "drawings");
    }
    /// Opens a lesson whose only page has these members.
    Diagnostics openPage(const std::string &members) {
        const std::filesystem::path file = folder_ / "own.json";
        std::ofstream(file) << "{\"format\": \"forefront-lesson\", \"version\": 1, \"title\": \"Mine\", \"pages\": [\n"
                               "{\"title\": \"P\", \"text\": \"Hello\", "
                            << members << "}]}";
        Diagnostics faults = openLessonFile(context(), file);
        settle();
        return faults;
    }
    /// Returns the entries of the log with this code.
    Diagnostics logged(const std::string &code) {
        Diagnostics found;
        for (const MessageLog::Entry &entry : context().log.entries()) {
            if (entry.diagnostic.code == code) {
                found.push_back(entry.diagnostic);
            }
        }
        return found;
    }
    std::vector<WidgetRegistry::Widget> outlines() {
        std::vector<WidgetRegistry::Widget> found;
        for (const auto &[name, widget] : context().widgets.all()) {
            if (name.starts_with("lesson/highlight/")) {
                found.push_back(widget);
            }
        }
        return found;
    }

  private:
    TemporaryFolder folder_;
};

const std::string kRing = R"("document": "drawings/ring.json", "panel": "statistics")";

} // namespace

TEST_CASE("Lessons: one outline goes around neighbouring rows, and rows apart have their own") {
    Author author;
    REQUIRE(
        author.openPage(kRing + R"(, "position": 3, "highlight": ["statistics/Nb", "statistics/Nc", "statistics/Ns"])")
            .empty());
    REQUIRE(author.outlines().size() == 1);
    const PixelRect box = author.outlines().front().rect;
    for (const char *row : {"statistics/Nb", "statistics/Nc", "statistics/Ns"}) {
        const PixelRect rect = author.context().widgets.find(row)->rect;
        CHECK(box.contains({rect.x, rect.y}));
        CHECK(box.contains({rect.x + rect.width - 1.0, rect.y + rect.height - 1.0}));
    }
    REQUIRE(author.openPage(kRing + R"(, "position": 3, "highlight": ["statistics/Nn", "statistics/Nb", "layer/mesh"])")
                .empty());
    const auto apart = author.outlines();
    REQUIRE(apart.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK_FALSE(apart[k].rect.overlaps(apart[(k + 1) % 3].rect));
    }
}

TEST_CASE("Lessons: an outlined row scrolls into view, and is not outlined beyond its panel once scrolled away") {
    Author author({1280, 500}); // too low for the panel, though others fold for it
    REQUIRE(author.openPage(kRing + R"(, "position": 3, "highlight": ["statistics/hash"])").empty());
    const auto find = [&] { return author.context().widgets.find("statistics/hash"); };
    REQUIRE(find() != nullptr);
    REQUIRE(find()->clip);
    CHECK(find()->rect.y + find()->rect.height <= find()->clip->y + find()->clip->height);
    CHECK(author.outlines().size() == 1);
    author.scroll({find()->rect.x + 5.0, find()->rect.y + 5.0}, 20.0);
    author.settle();
    const WidgetRegistry::Widget *const row = find();
    const double bottom = row->clip->y + row->clip->height;
    REQUIRE(row->rect.y + row->rect.height > bottom); // the window is too low for it
    for (const WidgetRegistry::Widget &outline : author.outlines()) {
        CHECK(outline.clip->y + outline.clip->height <= bottom + 8.0);
    }
    CHECK((row->visible || author.outlines().empty()));
    CHECK(row->visible == row->rect.overlaps(*row->clip));
}

TEST_CASE("Lessons: a misspelt name of a highlight is refused with its place, or logged if only the screen can tell") {
    Author author;
    for (const char *name :
         {"statistics/G", "layer/fornt", "steps/11", "timeline/stop", "tool/pencil", "panel/steppes"}) {
        CAPTURE(name);
        const Diagnostics faults = author.openPage(std::string(R"("highlight": ["statistics/Nb", ")") + name + "\"]");
        REQUIRE(faults.size() == 1);
        CHECK(faults.front().message == std::string("unknown widget '") + name + "'");
        CHECK(faults.front().line == 2);
        CHECK(faults.front().column > 50);
    }
    REQUIRE(author.openPage(kRing + R"(, "highlight": ["statistics/Nb", "statistic/Nb", "spacing/siez"])").empty());
    const Diagnostics logged = author.logged("lesson-highlight");
    REQUIRE(logged.size() == 2);
    CHECK_FALSE(author.context().log.entries().back().announced); // a learner may have hidden a panel
    CHECK(logged.front().message == "nothing to outline: 'statistic/Nb' is not on the screen");
    CHECK(logged.front().line == 2);
    CHECK(logged.front().column > 100);
}

TEST_CASE("Lessons: a position beyond the end of the run is logged with its place") {
    Author author;
    REQUIRE(author.openPage(kRing + R"(, "position": 40)").empty());
    CHECK(author.logged("lesson-position").empty());
    REQUIRE(author.openPage(kRing + R"(, "position": 4000)").empty());
    const Diagnostics logged = author.logged("lesson-position");
    REQUIRE(logged.size() == 1);
    CHECK(logged.front().message == "position 4000 is beyond the end of the run, which has " +
                                        std::to_string(author.run().known) + " advances and " +
                                        countText(author.run().improveSteps, "step") + " of improvement");
    CHECK(logged.front().line == 2);
    CHECK(logged.front().column > 80);
    CHECK(logged.front().file.ends_with("own.json"));
}

TEST_CASE("Lessons: more events than an advance has are logged") {
    Author author;
    const std::string classic = kRing + R"(, "method": "classic", "position": {"advance": 6, "events": )";
    REQUIRE(author.openPage(classic + "3}").empty());
    CHECK(author.run().advance == 6);
    REQUIRE(author.openPage(classic + "200}").empty());
    const std::uint64_t reached = author.run().advance;
    CHECK(reached > 7);
    const Diagnostics logged = author.logged("lesson-position");
    REQUIRE(logged.size() == 1);
    CHECK(logged.front().message ==
          "200 events are more than advance 7 has; the page begins after " + std::to_string(reached) + " advances");
    CHECK(logged.front().line == 2);
}

TEST_CASE("Lessons: a check without a window knows the names of the editor") {
    Author author;
    const LessonNames names = editorNames();
    const auto sorted = [](std::vector<std::string> list) {
        std::sort(list.begin(), list.end());
        return list;
    };
    const auto shown = highlightNames(author.context());
    CHECK(names.widgets.size() == shown.size());
    for (const auto &[group, list] : shown) {
        CAPTURE(group);
        REQUIRE(names.widgets.count(group) == 1);
        CHECK(sorted(names.widgets.at(group)) == sorted(list));
    }
    CHECK(names.layers.size() == author.context().layers.size());
    CHECK(names.panels.size() == author.context().panels.size());
}

TEST_CASE("Lessons: the rows of the statistics are those that a lesson may name") {
    Author author;
    REQUIRE(author.openPage(kRing + R"(, "position": 3)").empty());
    std::vector<std::string> drawn;
    for (const auto &[name, widget] : author.context().widgets.all()) {
        if (name.starts_with("statistics/")) {
            drawn.push_back(name);
        }
    }
    std::vector<std::string> known = highlightNames(author.context()).at("statistics");
    std::sort(known.begin(), known.end());
    CHECK(drawn == known);
    const auto names = highlightNames(author.context());
    author.showPanel("steps");
    for (const std::string &name : names.at("steps")) {
        CHECK_MESSAGE(author.has(name), name);
    }
    author.showPanel("layers");
    for (const std::string &name : names.at("layer")) {
        CHECK_MESSAGE(author.has(name), name);
    }
    for (const std::string &name : names.at("panel")) {
        author.showPanel(name.substr(std::string_view("panel/").size()));
        CHECK_MESSAGE(author.has(name), name);
    }
    for (const std::string &name : names.at("tool")) {
        author.context().tools.choose(name.substr(std::string_view("tool/").size()), author.context());
        author.settle();
        CHECK_MESSAGE(author.has(name), name);
    }
}

} // namespace forefront::test
