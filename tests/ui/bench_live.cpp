#include "core/drawing/constraints/constraint_commands.hpp"
#include "tests/ui/edit_driver.hpp"
#include "tests/ui/percentile.hpp"

#include <doctest/doctest.h>
#include <glad/gl.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <numbers>
#include <thread>
#include <vector>

namespace forefront::test {

namespace {

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

enum class Gesture { Node, Constrained, Source, Brush };
constexpr const char *kGestures[] = {"node", "constrained node", "source", "brush"};

/// Returns the square as a parallelogram that stands on a side of fixed length: its opposite side follows each corner.
Document constrainedSquare(Document document) {
    const std::uint32_t id = document.shapes[0]->id;
    const auto side = [id](std::uint32_t k) { return SketchPart{id, SketchPartKind::Segment, k}; };
    const auto add = [&](ConstraintKind kind, const std::vector<SketchPart> &parts) {
        Result<Document> next = addConstraint(document, kind, parts);
        REQUIRE(next.ok());
        document = *std::move(next);
    };
    add(ConstraintKind::Fixed, {{id, SketchPartKind::Node, 0}});
    add(ConstraintKind::Horizontal, {side(0)});
    add(ConstraintKind::Length, {side(0)});
    add(ConstraintKind::Parallel, {side(0), side(2)});
    add(ConstraintKind::Equal, {side(0), side(2)});
    return document;
}

/// Drags a node, free or constrained, or a source around a small circle, or the brush along a spiral so that every dab
/// changes the spacing, on a live-meshed square without pausing, and measures latencies.
class DragBench {
  public:
    DragBench(Gesture gesture, double elements) : gesture_(gesture), wanted_(elements) {
        driver_.platform().show(true);
        driver_.polygon({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
        Document sized = driver_.document();
        sized.spacing.size = std::sqrt(64.0 / (0.433 * elements));
        if (gesture == Gesture::Constrained) {
            sized = constrainedSquare(std::move(sized));
        } else if (gesture != Gesture::Node) {
            sized.spacing.sources.push_back({.a = {6, 6}, .size = 0.7 * *sized.spacing.size, .growth = 0.2});
        }
        driver_.context().document.apply(std::move(sized), "Size");
        driver_.key(gesture == Gesture::Brush ? 'B' : 'V');
        if (gesture == Gesture::Brush) {
            driver_.fill("options/brush/radius", std::to_string(kBrushRadius));
            driver_.fill("options/brush/spacing", std::to_string(0.7 * *driver_.document().spacing.size));
        }
        driver_.context().settings.live = true;
        driver_.settle();
        driver_.press(driver_.pixel(start()));
    }

    void run(double seconds) {
        const double begin = secondsNow(), end = begin + seconds;
        for (double next = begin; secondsNow() < end;) {
            for (; next <= secondsNow(); next += kPointerPeriod) {
                move(next - begin);
                inputs_.push_back({next, 0});
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
    static constexpr double kPi = std::numbers::pi;
    static constexpr double kBrushRadius = 0.4;
    static constexpr double kSpeed = 3.75; ///< of the pointer in every gesture, units of the drawing a second

    struct Input {
        double time = 0.0;
        std::uint64_t revision = 0; ///< of the resulting document; 0: not handled yet
    };

    Vec2 start() const {
        return gesture_ == Gesture::Brush ? Vec2{4.0, 4.0} : gesture_ == Gesture::Source ? Vec2{6, 6} : Vec2{8, 8};
    }

    /// Returns a place on a spiral whose turns are as far apart as the brush is wide, after a path of the given length.
    Vec2 onSpiral(double length) const {
        const double width = 2.0 * kBrushRadius, radius = std::sqrt(length * width / kPi);
        const double angle = 2.0 * kPi * radius / width;
        return start() + radius * Vec2{std::cos(angle), std::sin(angle)};
    }

    void move(double time) {
        const double angle = 3.0 * kPi * time;
        const Vec2 centre = start() - Vec2{0.5, 0.5};
        const Vec2 place = gesture_ == Gesture::Brush ? onSpiral(kSpeed * time)
                                                      : centre + 0.4 * Vec2{std::cos(angle), std::sin(angle)};
        const Pixel at = driver_.pixel(place);
        driver_.editor().input().push({.kind = InputKind::MouseMove, .x = at.x, .y = at.y});
    }

    void drawFrame() {
        const double begin = secondsNow();
        driver_.frames(1);
        glFinish();
        const double now = secondsNow();
        frames_.push_back(1e3 * (now - begin));
        for (Input &input : inputs_) {
            input.revision = input.revision == 0 ? driver_.context().document.revision() : input.revision;
        }
        const std::uint64_t shown = driver_.context().run.shownRevision();
        meshes_ += shown != shown_ ? 1 : 0;
        shown_ = shown;
        for (; !inputs_.empty() && inputs_.front().revision <= shown; inputs_.pop_front()) {
            latencies_.push_back(1e3 * (now - inputs_.front().time));
        }
        const std::uint64_t tint = driver_.context().examiner.raster()->revision;
        tints_ += tint != tint_ ? 1 : 0;
        tint_ = tint;
    }

    void print(double seconds) {
        double load[1] = {0.0};
        static_cast<void>(getloadavg(load, 1));
        std::printf("%s,%.0f,%zu,%.1f,%.0f,%.0f,%.1f,%.1f,%.0f,%.0f,%.0f,%.0f,%.1f\n",
                    kGestures[static_cast<int>(gesture_)], wanted_, driver_.run().quality.elements,
                    static_cast<double>(frames_.size()) / seconds, percentile(frames_, 0.5), percentile(frames_, 0.95),
                    meshes_ / seconds, tints_ / seconds, percentile(latencies_, 0.5), percentile(latencies_, 0.95),
                    percentile(latencies_, 0.99), percentile(latencies_, 1.0), load[0]);
        std::fflush(stdout);
    }

    Gesture gesture_;
    double wanted_;
    Draughtsman driver_;
    std::deque<Input> inputs_;
    std::vector<double> latencies_; ///< ms from the pointer's move to a picture with its mesh
    std::vector<double> frames_;    ///< ms
    std::uint64_t shown_ = 0, tint_ = 0;
    double meshes_ = 0.0, tints_ = 0.0;
};

} // namespace

// Not a test; prints figures: forefront_ui_tests --no-skip -tc='Bench*live*'. The last column is the load of the
// machine, without which the others cannot be interpreted.
TEST_CASE("Bench: live meshes per second and latency from input to picture during gestures" * doctest::skip()) {
    std::printf("gesture,wanted,elements,frames_per_s,frame_ms_p50,p95,meshes_per_s,tints_per_s,"
                "input_to_picture_ms_p50,p95,p99,max,load\n");
    for (const Gesture gesture : {Gesture::Node, Gesture::Constrained, Gesture::Source, Gesture::Brush}) {
        for (const double elements : {5e3, 2e4, 2e5}) {
            DragBench(gesture, elements).run(5.0);
        }
    }
}

} // namespace forefront::test
