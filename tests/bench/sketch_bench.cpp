// Times of constrained sketches: forefront_sketch_bench [CONSTRAINTS]... (default: 100 500 2000)
//
// The sketch is one connected profile of steps, in which everything moves when its upper corner is dragged.
#include "core/drawing/sketch/freedom.hpp"
#include "core/drawing/sketch/judge_constraint.hpp"
#include "core/drawing/sketch/sketch_drag.hpp"
#include "tests/support/random_sketch.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace forefront;
using namespace forefront::tests;

namespace {

template <class Work>
double milliseconds(const Work &work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void measure(std::size_t constraints) {
    RandomSketch sketch = steppedProfile(constraints);
    SketchDrag drag(sketch.system);
    const SketchPoint corner = sketch.system.edges[2 * (sketch.system.circles.size() / 2)].second;
    const Vec2 from = sketch.system.place(corner);
    constexpr int kSteps = 60;
    int failed = 0;
    std::vector<double> times;
    for (int k = 1; k <= kSteps; ++k) { // 1 % of the size a step, up and down
        const double reach = 0.3 * from.y * std::sin(0.1 * k);
        const std::array<SketchPull, 2> pulls = {SketchPull{corner.x, from.x}, SketchPull{corner.y, from.y + reach}};
        times.push_back(milliseconds([&] { failed += drag.pull(pulls) ? 0 : 1; }));
    }
    std::sort(times.begin(), times.end());
    SketchFreedom freedom;
    const double freedomTime = milliseconds([&] { freedom = freedomOf(sketch.system); });
    sketch.add({makeDistance(sketch.points.front(), sketch.points.back(), 1.0)});
    const double judgementTime = milliseconds([&] { judgeConstraint(sketch.system, sketch.constraints); });
    std::printf("%u,%zu,%zu,%.3f,%.3f,%d,%zu,%.1f,%.1f\n", sketch.constraints - 1, sketch.system.values.size(),
                sketch.system.equations.size() - 1, times[times.size() / 2], times.back(), failed, freedom.degrees,
                freedomTime, judgementTime);
}

} // namespace

int main(int count, char **arguments) {
    std::puts(
        "constraints,unknowns,equations,drag_median_ms,drag_max_ms,failed,degrees_of_freedom,freedom_ms,judgement_ms");
    if (count < 2) {
        for (const std::size_t constraints : {100, 500, 2000}) {
            measure(constraints);
        }
    }
    for (int k = 1; k < count; ++k) {
        measure(static_cast<std::size_t>(std::max(1, std::atoi(arguments[k]))));
    }
}
