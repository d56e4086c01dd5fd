#include "tests/ui/driver.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/style/colour_map.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace forefront::test {

TEST_CASE("Colour maps: published colours at the ends, evenly interpolated between") {
    CHECK(viridis(0.0) == rgb(0x440154));
    CHECK(viridis(1.0) == rgb(0xfde725));
    CHECK(cividis(0.0) == rgb(0x00204d));
    CHECK(cividis(1.0) == rgb(0xffea46));
    CHECK(viridis(2.0) == viridis(1.0));
}

TEST_CASE("Legend: ticks of a logarithmic scale are in order, between the ends") {
    for (const auto &[minimum, maximum] : {std::pair{0.05, 0.5}, {1e-4, 3.0}, {2.0, 2.1}, {1e-9, 1e6}}) {
        const auto ticks = logarithmicTicks(minimum, maximum, 5);
        REQUIRE(ticks.size() >= 2);
        CHECK(ticks.size() <= 7);
        CHECK(ticks.front().at == 0.0);
        CHECK(ticks.back().at == 1.0);
        for (std::size_t i = 1; i < ticks.size(); ++i) {
            CHECK(ticks[i].at > ticks[i - 1].at);
        }
    }
}

TEST_CASE("Legend: contour lines have round values, but none at the ends of the range, where a field is limited") {
    const auto has = [](const std::vector<double> &values, double value) {
        return std::any_of(values.begin(), values.end(),
                           [value](double each) { return std::abs(each - value) < 1e-9 * value; });
    };
    const std::vector<double> limited = contourValues(0.3, 2.0, 8); // as in lesson 6
    CHECK(has(roundValues(0.3, 2.0, 8), 2.0));
    CHECK_FALSE(has(limited, 2.0));
    CHECK(has(limited, 0.5));
    CHECK(has(limited, 1.0));
    CHECK(contourValues(0.5, 5.0, 8) == std::vector<double>{1.0, 2.0});
    CHECK(has(contourValues(0.9, 2.05, 8), 2.0)); // clear of the end
}

TEST_CASE("Legend: labels do not overlap, and the ends are always labelled") {
    Driver driver;
    ImFont *font = driver.context().fonts.small;
    constexpr double kBar = 192.0;
    std::size_t between = 0;
    for (double ratio = 1.03; ratio < 1e6; ratio *= 1.07) {
        for (const double minimum : {0.034, 0.05, 0.00123, 17.0}) {
            CAPTURE(minimum);
            CAPTURE(ratio);
            const auto ticks = logarithmicTicks(minimum, ratio * minimum, 5);
            auto labels = legendLabels(font, ticks, kBar, 6.0);
            REQUIRE(labels.size() >= 2);
            CHECK(labels[0].text == ticks.front().text);
            CHECK(labels[1].text == ticks.back().text);
            between += labels.size() - 2;
            std::sort(labels.begin(), labels.end(), [](const auto &a, const auto &b) { return a.left < b.left; });
            for (std::size_t i = 1; i < labels.size(); ++i) {
                CHECK(labels[i].left >= labels[i - 1].left + labels[i - 1].width + 6.0);
            }
            CHECK(labels.back().left + labels.back().width <= kBar + 0.5);
        }
    }
    CHECK(between > 500); // where there is room, round numbers are labelled too
}

} // namespace forefront::test
