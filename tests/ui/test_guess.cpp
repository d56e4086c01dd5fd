#include "core/teaching/moment/moment.hpp"
#include "tests/ui/meshed_square.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace forefront::test {

namespace {

/// A meshed square at its first base, with the guess tool.
class Guessing : public MeshedSquare {
  public:
    Guessing() {
        key(key::kHome);
        settle();
        key('Q');
        settle();
    }
    const AdvanceExplanation &advance() { return *run().explanation; }
    Vec2 chosen() {
        const auto &list = advance().candidates;
        const auto found =
            std::find_if(list.begin(), list.end(), [](const auto &c) { return c.verdict == Verdict::Accepted; });
        REQUIRE(found != list.end());
        return found->position;
    }
    bool waits() { return !momentOf(run()).idealKnown; }
};

} // namespace

TEST_CASE("Guess: a click on the chosen node earns ten points and shows the whole advance") {
    Guessing driver;
    for (int k = 1; k <= 3; ++k) {
        CAPTURE(k);
        REQUIRE(driver.waits()); // only the base is shown
        driver.clickPlace(driver.chosen());
        driver.settle();
        CHECK(momentOf(driver.run()).updated);
        CHECK(driver.run().advance == static_cast<std::uint64_t>(k));
        const auto &log = driver.context().log.entries();
        REQUIRE_FALSE(log.empty());
        CHECK(log.back().diagnostic.message.starts_with("Right: "));
        CHECK(driver.click("options/guess/next"));
        driver.settle();
    }
    CHECK(driver.waits());
    CHECK(driver.has("options/guess/score"));
}

TEST_CASE("Guess: a wrong click is explained, and the following click moves to the next base") {
    Guessing driver;
    const AdvanceExplanation &advance = driver.advance();
    const Vec2 along = advance.b - advance.a, left{-along.y, along.x};
    driver.clickPlace(midpoint(advance.a, advance.b) + 3.0 * left);
    driver.settle();
    CHECK(driver.context().log.entries().back().diagnostic.message.starts_with("There is no candidate"));
    CHECK_FALSE(driver.waits());
    driver.clickPlace({5, 5});
    driver.settle();
    CHECK(driver.waits());
    CHECK(driver.run().explanation->advance == 2);
}

TEST_CASE("Guess: Next base leaves a base that was not guessed, and clicks are guesses again") {
    Guessing driver;
    for (std::uint64_t k = 2; k <= 5; ++k) {
        CAPTURE(k);
        REQUIRE(driver.click("options/guess/next"));
        driver.settle();
        CHECK(driver.waits());
        CHECK(driver.advance().advance == k);
    }
    driver.clickPlace(driver.chosen());
    driver.settle();
    CHECK(driver.context().log.entries().back().diagnostic.message.starts_with("Right: "));
}

TEST_CASE(
    "Guess: the camera shows each base at a size that can be guessed on, and a guess without points has no tick") {
    Guessing driver;
    CHECK(driver.context().view.following);
    const AdvanceExplanation &advance = driver.advance();
    const Pixel a = driver.pixel(advance.a), b = driver.pixel(advance.b);
    CHECK(std::hypot(b.x - a.x, b.y - a.y) >= 50.0);
    const Vec2 along = advance.b - advance.a, left{-along.y, along.x};
    driver.clickPlace(midpoint(advance.a, advance.b) + 3.0 * left);
    driver.settle();
    CHECK(driver.context().log.entries().back().diagnostic.code == "information");
}

TEST_CASE("Guess: another tool shows the end again that was shown before") {
    MeshedSquare driver;
    const std::uint64_t end = driver.run().known;
    const std::vector<Vec2> nodes = driver.mesh().nodes;
    REQUIRE(driver.run().advance == end);
    driver.key('Q');
    driver.settle();
    REQUIRE(driver.run().advance < end);
    driver.key('V');
    driver.settle();
    CHECK(driver.run().advance == end);
    CHECK(driver.mesh().nodes == nodes);
    driver.key(key::kHome); // chosen by the user, who returns there
    driver.settle();
    const std::uint64_t start = driver.run().advance;
    driver.key('Q');
    driver.settle();
    driver.key('V');
    driver.settle();
    CHECK(driver.run().advance == start);
}

} // namespace forefront::test
