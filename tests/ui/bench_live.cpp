#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>
#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <deque>
#include <thread>
#include <vector>

namespace forefront::test {

namespace {

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double percentile(const std::vector<double> &sorted, double part) {
    return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

/// Drags a node of a live-meshed square around a small circle without a pause, and measures latencies.
class DragBench {
  public:
    explicit DragBench(double elements) {
        driver_.polygon({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
        Document sized = driver_.document();
        sized.spacing.size = std::sqrt(64.0 / (0.433 * elements));
        driver_.context().document.apply(std::move(sized), "Size");
        driver_.key('V');
        driver_.context().run.live = true;
        driver_.settle();
        driver_.press(driver_.pixel({8, 8}));
    }

    void run(double seconds) {
        const double begin = secondsNow(), end = begin + seconds;
        for (double next = begin; secondsNow() < end;) {
            for (; next <= secondsNow(); next += kPointerPeriod) {
                move(next);
            }
            if (!driver_.editor().needsFrame()) {
                std::this_thread::sleep_for(std::chrono::duration<double>(kPointerPeriod / 4));
                continue;
            }
            drawFrame();
        }
        print(secondsNow() - begin);
    }

  private:
    static constexpr double kPointerPeriod = 1.0 / 125.0; ///< seconds, as with a common mouse

    struct Input {
        double time = 0.0;
        std::uint64_t revision = 0; ///< of the resulting document; 0: not handled yet
    };

    void move(double time) {
        const double angle = 1.5 * (time - std::floor(time)) * 2.0 * 3.14159265358979;
        const Pixel at = driver_.pixel({7.5 + 0.4 * std::cos(angle), 7.5 + 0.4 * std::sin(angle)});
        driver_.editor().input().push({.kind = InputKind::MouseMove, .x = at.x, .y = at.y});
        inputs_.push_back({time, 0});
    }

    void drawFrame() {
        driver_.frames(1);
        glFinish();
        ++frames_;
        const double now = secondsNow();
        for (Input &input : inputs_) {
            input.revision = input.revision == 0 ? driver_.context().document.revision() : input.revision;
        }
        const std::uint64_t shown = driver_.context().run.shownRevision();
        meshes_ += shown != shown_ ? 1 : 0;
        shown_ = shown;
        for (; !inputs_.empty() && inputs_.front().revision <= shown; inputs_.pop_front()) {
            latencies_.push_back(1e3 * (now - inputs_.front().time));
        }
    }

    void print(double seconds) {
        std::sort(latencies_.begin(), latencies_.end());
        std::printf("%zu,%.1f,%.1f,%.0f,%.0f,%.0f,%.0f\n", driver_.run().quality.elements, frames_ / seconds,
                    meshes_ / seconds, percentile(latencies_, 0.5), percentile(latencies_, 0.95),
                    percentile(latencies_, 0.99), percentile(latencies_, 1.0));
        std::fflush(stdout);
    }

    Draughtsman driver_;
    std::deque<Input> inputs_;
    std::vector<double> latencies_; ///< ms from the pointer's move to a picture with its mesh
    std::uint64_t shown_ = 0;
    double frames_ = 0.0, meshes_ = 0.0;
};

} // namespace

// Not a test; prints figures: forefront_ui_tests --no-skip -tc='Bench*live*'
TEST_CASE("Bench: live meshes per second and latency from input to picture while a node is dragged" * doctest::skip()) {
    std::printf("elements,frames_per_s,meshes_per_s,input_to_picture_ms_p50,p95,p99,max\n");
    for (const double elements : {5e3, 2e4}) {
        DragBench(elements).run(6.0);
    }
}

} // namespace forefront::test
