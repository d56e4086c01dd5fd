#include "tests/ui/edit_driver.hpp"
#include "tests/ui/percentile.hpp"

#include <doctest/doctest.h>
#include <glad/gl.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <thread>
#include <vector>

namespace forefront::test {

namespace {

double millisecondsNow() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seeks to random positions of a run, and measures when the worker has arrived and when the window shows it.
class SeekBench {
  public:
    SeekBench(Method method, double elements) : method_(method) {
        driver_.platform().show(true);
        driver_.rectangle({0, 0}, {8, 8});
        Document sized = driver_.document();
        sized.spacing.size = std::sqrt(64.0 / (0.433 * elements));
        sized.options.method = method;
        sized.options.improve = ImproveLevel::None;
        driver_.context().run.live = false;
        driver_.context().document.apply(std::move(sized), "Size");
        driver_.key('V');
        driver_.key(key::kF5);
        driver_.settle();
    }

    void run(int seeks) {
        std::mt19937 random(7);
        const std::uint64_t known = driver_.run().known;
        for (int i = 0; i < seeks; ++i) {
            seek(i % 10 == 8 ? 0 : i % 10 == 9 ? known : random() % known);
        }
        for (int i = 0; i < seeks; ++i) {
            step(i % 2 == 0 ? 1 : -1);
        }
        std::printf("%s,%llu", method_ == Method::Classic ? "classic" : "fast", static_cast<unsigned long long>(known));
        for (const std::vector<double> &values : {arrivals_, pictures_, frames_, steps_}) {
            for (const double part : {0.5, 0.95, 1.0}) {
                std::printf(",%.0f", percentile(values, part));
            }
        }
        std::printf("\n");
        std::fflush(stdout);
    }

  private:
    /// Draws frames as the window would until the run rests at the position and its picture is complete.
    void untilShown(std::uint64_t target, double begin, std::vector<double> *arrivals, std::vector<double> &shown) {
        double arrived = 0.0;
        while (driver_.run().advance != target || driver_.run().stateHash == 0 ||
               driver_.editor().canvas().pictureIncomplete()) {
            arrived = arrived == 0.0 && !driver_.context().run.busy() ? millisecondsNow() : arrived;
            if (!driver_.editor().needsFrame()) {
                std::this_thread::sleep_for(std::chrono::microseconds(300));
                continue;
            }
            const double before = millisecondsNow();
            driver_.frames(1);
            glFinish();
            frames_.push_back(millisecondsNow() - before);
        }
        if (arrivals != nullptr) {
            arrivals->push_back((arrived == 0.0 ? millisecondsNow() : arrived) - begin);
        }
        shown.push_back(millisecondsNow() - begin);
        driver_.settle();
    }

    void seek(std::uint64_t target) {
        if (target != driver_.run().advance) {
            const double begin = millisecondsNow();
            driver_.context().run.seek(target);
            untilShown(target, begin, &arrivals_, pictures_);
        }
    }

    void step(std::int64_t way) {
        const std::uint64_t from = driver_.run().advance;
        if (way > 0 ? from < driver_.run().known : from > 0) {
            const double begin = millisecondsNow();
            driver_.context().run.step(Granularity::Advance, way);
            untilShown(way > 0 ? from + 1 : from - 1, begin, nullptr, steps_);
        }
    }

    Method method_;
    Draughtsman driver_;
    std::vector<double> arrivals_, pictures_, frames_, steps_; ///< ms
};

} // namespace

// Not a test; prints figures: forefront_ui_tests --no-skip -tc='Bench*seek*'
TEST_CASE("Bench: seeking and stepping through long runs" * doctest::skip()) {
    std::printf("method,advances,arrived_ms_p50,p95,max,picture_ms_p50,p95,max,frame_ms_p50,p95,max,"
                "step_picture_ms_p50,p95,max\n");
    for (const Method method : {Method::Fast, Method::Classic}) {
        for (const double advances : {1e5, 1e6}) {
            SeekBench(method, method == Method::Fast ? 1.95 * advances : advances).run(40);
        }
    }
}

} // namespace forefront::test
