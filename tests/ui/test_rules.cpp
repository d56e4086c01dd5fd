#include "core/engine/mesher/front_rules.hpp"
#include "core/teaching/moment/moment.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

namespace forefront::test {

namespace {

/// A meshed square in a window so high that all rules are in sight.
class RuledSquare : public Draughtsman {
  public:
    explicit RuledSquare(Method method = Method::Classic) : Draughtsman({}, {1280, 1800}) {
        rectangle({1, 1}, {9, 8});
        key('V');
        key(key::kEscape);
        Document next = document();
        next.spacing.size = 0.9;
        next.options.method = method;
        context().document.apply(std::move(next), "Method");
        context().settings.live = true;
        workspace(WorkspaceKind::Step);
        showPanel("rules");
        settle();
    }
    const FrontRules &rules() { return document().options.rules; }
    /// Returns the place of the knob of a slider at a share of its range.
    Pixel knob(const std::string &rule, double share) {
        const PixelRect rect = context().widgets.find("rules/" + rule + "/slider")->rect;
        return {rect.x + 6.0 + share * (rect.width - 12.0), rect.y + 0.5 * rect.height};
    }
};

} // namespace

TEST_CASE("Rules: the panel has a row for each rule, with its origin; a change is marked and can be reset") {
    RuledSquare driver;
    for (const FrontRule rule : valuesOf<FrontRule>()) {
        INFO(wordOf(rule));
        const bool chosen = frontRuleInfo(rule).kind == RuleKind::Choice;
        CHECK(driver.has("rules/" + std::string(wordOf(rule)) + (chosen ? "/Shortest" : "")));
        CHECK(driver.has("rules/" + std::string(wordOf(rule)) + "/origin"));
        CHECK_FALSE(driver.has("rules/" + std::string(wordOf(rule)) + "/reset"));
    }
    driver.click("rules/defer");
    driver.settle();
    CHECK_FALSE(driver.rules().defer);
    CHECK(driver.undoLabel() == "Change rule deferral");
    driver.click("rules/defer/reset");
    driver.settle();
    CHECK(driver.rules() == FrontRules());
    CHECK_FALSE(driver.has("rules/defer/reset"));
}

TEST_CASE("Rules: the live mesh follows a slider; a drag is one undo step, and Esc takes it back") {
    RuledSquare driver;
    const std::uint64_t before = driver.run().meshHash;
    REQUIRE(before != 0);
    driver.press(driver.knob("minRho", 0.5));
    driver.moveTo(driver.knob("minRho", 0.8));
    driver.settle();
    const double first = driver.rules().minRho;
    driver.moveTo(driver.knob("minRho", 1.0));
    driver.settle();
    CHECK(driver.rules().minRho == 1.0);
    CHECK(first < 1.0);
    CHECK(driver.run().meshHash != before);
    driver.release(driver.knob("minRho", 1.0));
    driver.settle();
    CHECK(driver.undoLabel() == "Change rule minimum of \xcf\x81");
    driver.key('Z', {Modifiers::kControl});
    driver.settle();
    CHECK(driver.rules() == FrontRules());
    CHECK(driver.undoLabel() == "Method");
    CHECK(driver.run().meshHash == before);
    driver.press(driver.knob("minRho", 0.5));
    driver.moveTo(driver.knob("minRho", 0.9));
    driver.frames(3);
    driver.key(key::kEscape);
    driver.moveTo(driver.knob("minRho", 0.2));
    driver.release(driver.knob("minRho", 0.2));
    driver.settle();
    CHECK(driver.rules() == FrontRules());
    CHECK(driver.undoLabel() == "Method");
}

TEST_CASE("Rules: a number beyond the limits of its rule is refused") {
    RuledSquare driver;
    const auto enter = [&](const char *number) {
        driver.click("rules/radius");
        driver.key('A', {Modifiers::kControl});
        driver.type(number);
        driver.key(key::kEnter);
        driver.settle();
    };
    enter("2.5");
    CHECK(driver.rules().radius == 2.5);
    enter("7");
    CHECK(driver.rules().radius == 2.5);
    driver.key(key::kEscape);
    driver.click("rules/reset");
    driver.settle();
    CHECK(driver.rules() == FrontRules());
    CHECK(driver.undoLabel() == "Reset rules");
}

TEST_CASE("Rules: a run that rests in its course rests there again under other rules") {
    RuledSquare driver;
    driver.context().run.seek(20);
    driver.settle();
    REQUIRE(driver.run().explanation != nullptr);
    driver.click("rules/base/Longest");
    driver.settle();
    CHECK(driver.rules().base == BaseRule::Longest);
    CHECK(driver.run().advance == 20);
    CHECK(driver.run().complete); // the length of the run is known
    CHECK(driver.run().known > 20);
    const Moment moment = momentOf(driver.run());
    REQUIRE(moment);
    CHECK(moment.advance->rules.base == BaseRule::Longest);
    CHECK_FALSE(driver.context().run.outOfDate());

    Document guided = driver.document(); // what does not change the mesh leaves the run where it is
    guided.guides.emplace_back();
    guided.unit = LengthUnit::Metre;
    driver.context().document.apply(std::move(guided), "Guide");
    driver.settle();
    driver.click("rules/base/Shortest");
    driver.settle();
    CHECK(driver.rules().base == BaseRule::Shortest);
    CHECK(driver.run().advance == 20);
}

TEST_CASE("Rules: with the fast method the panel offers the classic one") {
    RuledSquare driver(Method::Fast);
    CHECK(driver.has("rules/offer"));
    CHECK_FALSE(driver.has("rules/radius"));
    driver.click("rules/classic");
    driver.settle();
    CHECK(driver.document().options.method == Method::Classic);
    CHECK(driver.has("rules/radius"));
    driver.workspace(WorkspaceKind::Mesh);
    driver.click("meshing/rules");
    driver.settle();
    CHECK(driver.has("rules/radius"));
}

TEST_CASE("Rules: they are saved to a file and opened from one; a faulty file is refused") {
    const testing::TemporaryFolder folder;
    RuledSquare driver;
    Document next = driver.document();
    next.options.rules.radius = 2.0;
    next.options.rules.base = BaseRule::Oldest;
    const FrontRules changed = next.options.rules;
    driver.context().document.apply(std::move(next), "Rules");
    driver.settle();
    driver.click("rules/save");
    driver.settle();
    driver.chooseFile("saverules", folder / "mine.json");
    next = driver.document();
    next.options.rules = {};
    next.options.method = Method::Fast;
    driver.context().document.apply(std::move(next), "Fast");
    driver.context().actions.run("file.openRules", driver.context());
    driver.settle();
    driver.chooseFile("openrules", folder / "mine.json");
    CHECK(driver.rules() == changed);
    CHECK(driver.document().options.method == Method::Classic);
    CHECK(driver.undoLabel() == "Open rules");
    std::ofstream(folder / "bad.json") << "{\"radius\": 70}";
    driver.context().actions.run("file.openRules", driver.context());
    driver.settle();
    driver.chooseFile("openrules", folder / "bad.json");
    CHECK(driver.has("dialog/openrules/name")); // stays open
    CHECK(driver.rules() == changed);
}

} // namespace forefront::test
