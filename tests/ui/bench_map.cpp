#include "tests/ui/edit_driver.hpp"
#include "tests/ui/percentile.hpp"
#include "ui/platform/steady_seconds.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <memory>
#include <utility>
#include <vector>

namespace forefront::test {
namespace {

constexpr int kRows = 60;  ///< counties along each side of the map
constexpr int kParts = 12; ///< segments of each side of a county

/// Returns a corner of the counties, out of line so that none is a rectangle.
Vec2 cornerAt(int column, int row) {
    return {10.0 * column + 2.0 * std::sin(7.0 * column + 13.0 * row),
            10.0 * row + 2.0 * std::cos(11.0 * column + 5.0 * row)};
}

/// Returns a border between two corners of counties.
std::shared_ptr<const Shape> sideOf(Vec2 from, Vec2 to, bool outer, std::uint32_t id) {
    auto shape = std::make_shared<Shape>();
    shape->id = id;
    shape->form = PathForm{.closed = false};
    shape->use = outer ? ShapeUse::Boundary : ShapeUse::Constraint;
    for (int k = 0; k <= kParts; ++k) {
        const double t = static_cast<double>(k) / kParts;
        const double off = k == 0 || k == kParts ? 0.0 : 0.25 * std::sin(3.0 * k + from.x);
        shape->nodes.push_back(lerp(from, to, t) + off * leftNormal((1.0 / distance(from, to)) * (to - from)));
    }
    return shape;
}

/// Returns a map of 3,600 counties as an import makes it: borders as lines, and a region marker in each county.
Document mapOfCounties() {
    Document map;
    for (int row = 0; row <= kRows; ++row) {
        for (int column = 0; column <= kRows; ++column) {
            const Vec2 here = cornerAt(column, row);
            if (column < kRows) {
                map.shapes.push_back(sideOf(here, cornerAt(column + 1, row), row == 0 || row == kRows, map.nextId++));
            }
            if (row < kRows) {
                map.shapes.push_back(
                    sideOf(here, cornerAt(column, row + 1), column == 0 || column == kRows, map.nextId++));
            }
            if (row < kRows && column < kRows) {
                const Vec2 middle = midpoint(here, cornerAt(column + 1, row + 1));
                map.regionMarkers.push_back({middle, static_cast<std::int32_t>(map.regionMarkers.size()) + 2});
            }
        }
    }
    return map;
}

/// Prints percentiles of the CPU time of frames, in ms.
template <class Change>
void printFrames(Driver &driver, const char *what, int count, const Change &change) {
    std::vector<double> times;
    for (int k = 0; k < count; ++k) {
        const std::clock_t begin = std::clock();
        change(k);
        driver.frames(1);
        times.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    const double median = percentile(times, 0.5), most = percentile(times, 1.0);
    std::printf("%s,%.1f,%.1f\n", what, median, most);
    std::fflush(stdout);
}

} // namespace

// Not a test; prints figures: forefront_ui_tests --no-skip -tc='Bench*map*'
TEST_CASE("Bench: CPU time of frames while counties of a map are picked" * doctest::skip()) {
    Draughtsman driver;
    driver.platform().show(true);
    driver.context().settings.live = false;
    driver.context().document.apply(mapOfCounties(), "Map");
    driver.key('V');
    driver.context().actions.run("view.fit", driver.context());
    const double begin = steadySeconds();
    driver.until([&] { return driver.context().preview->revision == driver.context().document.revision(); });
    std::printf("preview_s,%.2f\n", steadySeconds() - begin);
    driver.settle();
    std::printf("frames,median_ms,longest_ms\n");
    const auto hover = [&](int k) {
        const Pixel p = driver.pixel({20.0 + 9.0 * k, 305.0});
        driver.editor().input().push({.kind = InputKind::MouseMove, .x = p.x, .y = p.y});
    };
    for (const bool faces : {false, true}) {
        driver.click("options/picks");
        driver.click("picks/markers");
        driver.key(key::kEscape);
        driver.settle();
        printFrames(driver, faces ? "hover" : "hover without faces", 60, hover);
    }
    printFrames(driver, "click", 20, [&](int k) { driver.clickAt(driver.pixel({35.0 + 20.0 * k, 305.0})); });
    driver.context().selection = selectAll(driver.document());
    driver.context().selection.shapes.clear();
    driver.frames(3);
    printFrames(driver, "hover, all picked", 20, hover);
    driver.settle();
    driver.clickPlace({305, 305});
    driver.settle();
    driver.press(driver.pixel({305, 305}));
    printFrames(driver, "drag", 30, [&](int k) { driver.moveTo(driver.pixel({305.0 + 0.1 * k, 305.0})); });
    driver.release(driver.pixel({308, 305}));
    printFrames(driver, "click after an edit", 1, [&](int) { driver.clickAt(driver.pixel({405.0, 305.0})); });
}

} // namespace forefront::test
