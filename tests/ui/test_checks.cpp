// The fix beside a broken limit in the checks panel.
#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/limits.hpp"
#include "tests/ui/meshed_square.hpp"
#include "ui/parts/fix_trial.hpp"

#include <doctest/doctest.h>

#include <string>

namespace forefront::test {

TEST_CASE("Checks: the fix of a broken limit says what it changes, and is one undo step") {
    MeshedSquare driver;
    driver.showPanel("checks");
    driver.fill("checks/max-length", "0.6");
    const auto centreOf = [&](const char *name) { return driver.context().widgets.find(name)->rect.centre(); };
    REQUIRE(driver.has("checks/max-length/fix"));
    driver.scroll(centreOf("checks/max-length"), -4.0); // the fix is below the visible part of the panel
    driver.click("checks/max-length/fix");
    CHECK(driver.document().spacing.maximum == doctest::Approx(0.54));
    CHECK(driver.undoLabel() == "Fix maximum edge length");
    driver.key('Z', {Modifiers::kControl});
    CHECK_FALSE(driver.document().spacing.maximum.has_value());
    for (int round = 0; round < 3 && driver.has("checks/max-length/fix"); ++round) { // single edges are longer
        driver.click("checks/max-length/fix");
        driver.key(key::kF5);
        driver.settle();
    }
    CHECK(driver.has("checks/max-length/kept"));
    CHECK_FALSE(driver.has("checks/max-length/fix"));
}

TEST_CASE("Checks: a fix whose mesh is no better is taken back, which is said") {
    MeshedSquare driver;
    driver.showPanel("checks");
    driver.fill("checks/max-length", "0.6");
    const LimitVerdict verdict = driver.context().judgement->verdicts.at(0);
    REQUIRE(verdict.broken > 0);
    Document next = driver.document();
    next.spacing.segmentsPerTurn = 24.0; // changes nothing in a square
    tryFix(driver.context(), verdict, {"segments per turn auto \xe2\x86\x92 24", next});
    CHECK(driver.document().spacing.segmentsPerTurn == 24.0);
    driver.key(key::kF5);
    driver.settle();
    CHECK_FALSE(driver.document().spacing.segmentsPerTurn.has_value());
    const std::string said = driver.context().log.entries().back().diagnostic.message;
    CHECK(said == "Took back segments per turn auto \xe2\x86\x92 24: " + countText(verdict.broken, "place") +
                      " violate a limit, as before");
}

} // namespace forefront::test
