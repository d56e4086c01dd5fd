#include "core/teaching/lesson/glossary.hpp"
#include "tests/ui/meshed_square.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>

namespace forefront::test {

TEST_CASE("Glossary: every term can be opened and shows its own figure") {
    Draughtsman driver;
    driver.script("click menu/Help\nclick menu/help.glossary\nsettle");
    CHECK(driver.has("dialog/glossary/figure"));
    driver.key(key::kEscape);
    driver.settle();
    for (const GlossaryTerm &term : glossary()) {
        CAPTURE(term.name);
        const std::string id(term.id);
        driver.context().actions.run("glossary." + id, driver.context());
        driver.settle();
        CHECK(driver.has("dialog/glossary/term/" + id));
        const Driver::Picture now = driver.picture();
        const WidgetRegistry::Widget *const figure = driver.context().widgets.find("dialog/glossary/figure");
        REQUIRE(figure != nullptr);
        REQUIRE(figure->rect.y + figure->rect.height <= now.size.height);
        std::size_t drawn = 0; // pixels whose colour differs from the figure's corner
        const auto at = [&](int x, int y) {
            return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(now.size.width) +
                        static_cast<std::size_t>(x));
        };
        const int left = static_cast<int>(figure->rect.x) + 8, top = static_cast<int>(figure->rect.y) + 8;
        const int right = static_cast<int>(figure->rect.x + figure->rect.width) - 8;
        const int bottom = static_cast<int>(figure->rect.y + figure->rect.height) - 8;
        for (int y = top; y < bottom; ++y) {
            for (int x = left; x < right; ++x) {
                drawn += now.rgba[at(x, y)] != now.rgba[at(left, top)] ? 1 : 0;
            }
        }
        CHECK(drawn > 400);
        for (const std::string_view other : term.related) {
            CHECK(driver.has("dialog/glossary/related/" + std::string(other)));
        }
        driver.key(key::kEscape);
        driver.settle();
    }
}

TEST_CASE("Glossary: links lead from one term to another, and from panels and lessons to their terms") {
    MeshedSquare driver;
    driver.context().actions.run("glossary.front", driver.context());
    driver.settle();
    driver.click("dialog/glossary/related/base");
    driver.settle();
    CHECK(driver.has("dialog/glossary/term/base"));
    driver.click("dialog/glossary/list/grid");
    driver.settle();
    CHECK(driver.has("dialog/glossary/term/grid"));
    driver.key(key::kDown);
    driver.settle();
    CHECK(driver.has("dialog/glossary/term/neighbours"));
    driver.key(key::kUp);
    driver.settle();
    CHECK(driver.has("dialog/glossary/term/grid"));
    driver.key(key::kEscape);
    driver.settle();
    driver.showPanel("steps");
    driver.settle();
    driver.click("steps/4");
    driver.settle();
    CHECK(driver.has("dialog/glossary/term/ideal-point"));
    driver.key(key::kEscape);
    driver.showPanel("statistics");
    driver.settle();
    driver.click("statistics/Nc");
    driver.settle();
    CHECK(driver.has("dialog/glossary/term/counters"));
    Driver learner({}, {1400, 900});
    learner.key(key::kF1 + 3);
    learner.settle();
    learner.click("lessons/1-front");
    learner.settle();
    CHECK(learner.has("lesson/term/spacing"));
    learner.click("lesson/term/front");
    learner.settle();
    CHECK(learner.has("dialog/glossary/term/front"));
}

} // namespace forefront::test
