#include "core/engine/boundary/discretise.hpp"
#include "core/teaching/moment/moment.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/workspace/view/chosen_candidate.hpp"
#include "ui/workspace/view/follow_camera.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace forefront::test {

namespace {

/// A driver with a run that pauses in the middle.
struct Stepping : Driver {
    explicit Stepping(Method method = Method::Classic) {
        Document document = *context().document.current();
        document.options.method = method;
        context().document.apply(std::move(document), "Method");
        workspace(WorkspaceKind::Step);
        key(key::k2);
        settle();
        context().run.seek(run().known / 2);
        settle();
        REQUIRE(run().explanation != nullptr);
    }

    /// Returns the length of the current base AB in pixels.
    double shownBase() { return context().view.camera.zoom * distance(run().explanation->a, run().explanation->b); }
    bool advanceInRoom() {
        const Box2 box = boxOf(*run().explanation);
        const View &view = context().view;
        return view.room.contains(view.camera.toPixel(box.min)) && view.room.contains(view.camera.toPixel(box.max));
    }
    /// Runs from one rejection to the next until the advance meets a condition.
    void runUntil(const std::function<bool(const AdvanceExplanation &)> &condition) {
        Breakpoints rejections;
        rejections.set(StopKind::Rejection, true);
        context().run.setBreakpoints(rejections);
        context().run.seek(0);
        settle();
        do {
            context().run.seekStop(true);
            settle();
        } while (run().stop && !condition(*run().explanation));
        REQUIRE(run().stop);
    }
};

bool isRejected(const CandidateTrace &candidate) {
    return candidate.verdict != Verdict::Accepted && candidate.verdict != Verdict::NotTried;
}

bool hasRejection(const AdvanceExplanation &e) {
    return e.candidates.size() > 1 && std::any_of(e.candidates.begin(), e.candidates.end(), isRejected);
}

} // namespace

TEST_CASE("Follow: T frames the current advance and keeps it in view while stepping; a pan ends following") {
    Stepping driver;
    View &view = driver.context().view;
    driver.key('T');
    driver.settle();
    CHECK(view.following);
    CHECK(driver.advanceInRoom());
    CHECK(driver.shownBase() >= 60.0 - 1e-6);
    CHECK(driver.shownBase() <= 120.0 + 1e-6);
    for (int i = 0; i < 6; ++i) {
        driver.key(key::kPeriod);
        driver.settle();
        CHECK(driver.advanceInRoom());
        CHECK(driver.shownBase() >= 60.0 - 1e-6);
        CHECK(driver.shownBase() <= 120.0 + 1e-6);
    }
    driver.key(key::kEqual); // zooming ends it as well
    CHECK_FALSE(view.following);
    driver.key('T');
    driver.settle();
    CHECK(view.following);
    driver.scroll(driver.canvas().centre(), 1.0);
    CHECK_FALSE(view.following);
    const Camera left = view.camera;
    driver.key(key::kPeriod);
    driver.settle();
    CHECK(view.camera == left);
}

TEST_CASE("Follow: the camera moves smoothly and stays still while the advance is well in view") {
    View view;
    view.camera.viewport = view.room = {0, 0, 800, 600};
    view.camera.centre = {50, 50};
    view.camera.zoom = 5.0;
    FollowCamera camera;
    const Box2 first = boxAround(Vec2{10, 10}, 1.0);
    double before = distance(view.camera.centre, first.centre());
    int frames = 0;
    const double base = 0.5;
    const auto follow = [&](const Box2 &box) { return camera.follow(view, {box, base}, 1.0 / 60.0, 1.0); };
    while (follow(first)) {
        const double now = distance(view.camera.centre, first.centre());
        CHECK(now <= before);
        CHECK(now >= 0.8 * before); // no jump
        before = now;
        REQUIRE(++frames < 600);
    }
    CHECK(frames > 20);
    CHECK(distance(view.camera.toPlane(view.room.centre()), first.centre()) < 0.01);
    CHECK(view.camera.zoom * base == doctest::Approx(60.0).epsilon(1.0));
    const Camera rest = view.camera;
    for (const Vec2 step : {Vec2{0.5, 0}, Vec2{-0.5, 0.3}, Vec2{0, -0.4}}) { // neighbours do not move it
        CHECK_FALSE(follow(boxAround(first.centre() + step, 0.9)));
        CHECK(view.camera == rest);
    }
    CHECK(follow(boxAround(Vec2{14, 10}, 1.0))); // out of the middle
    CHECK_FALSE(view.camera == rest);
    camera.reset();
    view.camera = rest;
    CHECK(camera.follow(view, {boxAround(first.centre(), 0.05), 0.02}, 1.0 / 60.0, 1.0)); // too small to see
    CHECK(view.camera.zoom > rest.zoom);
}

TEST_CASE("Step: the labels of A, B and C cover no segment of the front and no other label") {
    Stepping driver;
    driver.key('T');
    driver.settle();
    int seen = 0;
    for (int step = 0; step < 10; ++step) {
        const std::vector<CanvasPainter::Placed> labels = driver.editor().canvas().labels();
        for (std::size_t k = 0; k < labels.size(); ++k) {
            const std::string &text = labels[k].text;
            if (!text.starts_with("A ") && !text.starts_with("B ") && text != "C") {
                continue;
            }
            CAPTURE(step);
            CAPTURE(text);
            ++seen;
            for (const FrontSegmentView &segment : *driver.run().front) {
                const Camera &camera = driver.context().view.camera;
                CHECK_FALSE(meets(labels[k].rect, camera.toPixel(segment.a), camera.toPixel(segment.b)));
            }
            for (std::size_t other = 0; other < labels.size(); ++other) {
                CHECK((other == k || !labels[k].rect.overlaps(labels[other].rect)));
            }
        }
        driver.key(key::kPeriod);
        driver.settle();
    }
    CHECK(seen >= 25);
}

TEST_CASE("Step: a step beyond the end or the start of the run says so, and a held key says it once") {
    Stepping driver;
    const auto said = [&](const std::string &words) {
        const auto &entries = driver.context().log.entries();
        return std::count_if(entries.begin(), entries.end(),
                             [&](const auto &entry) { return entry.diagnostic.message == words; });
    };
    driver.key(key::kEnd);
    driver.settle();
    CHECK(said("End of the run") == 0);
    for (int k = 0; k < 3; ++k) {
        driver.key(key::kPeriod);
        driver.settle();
    }
    CHECK(driver.run().atEnd());
    CHECK(said("End of the run") == 1);
    driver.key(key::kHome);
    driver.settle();
    driver.key(key::kComma);
    driver.settle();
    CHECK(said("Start of the run") == 1);
    driver.key(key::kPeriod);
    driver.settle();
    CHECK(driver.run().position() == 1);
}

TEST_CASE("Breakpoints: the popup sets them, N runs to the next, Shift+N back to the previous, and the caption says "
          "why it stopped") {
    Stepping driver;
    driver.key(key::kHome);
    driver.settle();
    driver.key('N'); // nothing is set
    driver.settle();
    CHECK(driver.run().advance == 0);
    driver.click("timeline/breakpoints");
    driver.frames(2);
    REQUIRE(driver.has("breakpoints"));
    driver.click("breakpoints/" + std::to_string(static_cast<int>(StopKind::Closure)));
    CHECK(driver.context().run.breakpoints().has(StopKind::Closure));
    driver.key(key::kEscape);
    driver.frames(2);
    CHECK_FALSE(driver.has("breakpoints"));
    driver.key('N');
    driver.settle();
    const std::uint64_t first = driver.run().advance;
    REQUIRE(driver.run().stop);
    CHECK(driver.run().stop->kind == StopKind::Closure);
    CHECK(driver.run().state == RunState::Paused);
    driver.key('N');
    driver.settle();
    CHECK(driver.run().advance > first);
    driver.key('N', {Modifiers::kShift});
    driver.settle();
    CHECK(driver.run().advance == first);
    // Playing stops there, too; meshing does not.
    driver.key(key::kHome);
    driver.settle();
    driver.context().run.setSpeed(1000.0);
    driver.key(key::kSpace);
    driver.until([&] { return driver.run().state == RunState::Paused && driver.run().advance > 0; });
    CHECK(driver.run().advance == first);
    driver.key(key::k2);
    driver.settle();
    CHECK(driver.run().state == RunState::Finished);
}

TEST_CASE("Breakpoints: the value of a condition is entered in its field, which enables it") {
    Stepping driver;
    driver.click("timeline/breakpoints");
    driver.frames(2);
    driver.click("breakpoints/" + std::to_string(static_cast<int>(StopKind::LowAlpha)) + "/value");
    driver.type("0.8");
    driver.key(key::kEnter);
    driver.frames(2);
    CHECK(driver.context().run.breakpoints().alphaBelow == doctest::Approx(0.8));
    CHECK(driver.context().run.breakpoints().has(StopKind::LowAlpha));
    driver.context().run.seek(0);
    driver.settle();
    driver.click("breakpoints/next");
    driver.settle();
    REQUIRE(driver.run().stop);
    CHECK(driver.run().stop->value < 0.8);
    driver.click("breakpoints/clear");
    CHECK_FALSE(driver.context().run.breakpoints().any());
}

TEST_CASE("Timeline: marks can be filtered and clicked") {
    Stepping driver;
    REQUIRE(driver.run().marks != nullptr);
    const auto closure = std::find_if(driver.run().marks->begin(), driver.run().marks->end(),
                                      [](const TimelineMark &mark) { return mark.kind == MarkKind::Closure; });
    REQUIRE(closure != driver.run().marks->end());
    const std::uint64_t advance = closure->advance;
    driver.click("timeline/breakpoints");
    driver.frames(2);
    for (const MarkKind kind : {MarkKind::NewNode, MarkKind::Connection, MarkKind::Deferral, MarkKind::Forced}) {
        driver.click("marks/" + std::to_string(static_cast<int>(kind)));
        CHECK_FALSE(driver.context().view.marks[static_cast<std::size_t>(kind)]);
    }
    driver.key(key::kEscape);
    driver.frames(2);
    const PixelRect bar = driver.context().widgets.find("timeline/scrubber")->rect;
    const double left = bar.x + 7.0, right = bar.x + bar.width - 7.0;
    const double x = left + (right - left) * static_cast<double>(advance) / static_cast<double>(driver.run().known);
    driver.clickAt({std::round(x) + 1.0, bar.centre().y + 8.0});
    driver.settle();
    const std::uint64_t at = driver.run().advance;
    const auto &marks = *driver.run().marks;
    CHECK(std::any_of(marks.begin(), marks.end(),
                      [at](const TimelineMark &mark) { return mark.kind == MarkKind::Closure && mark.advance == at; }));
}

TEST_CASE("Trace: a click on an element goes to the advance that made it") {
    Stepping driver;
    const AdvanceExplanation made = *driver.run().explanation;
    REQUIRE_FALSE(made.made.empty());
    const auto &[a, b, c] = made.made.front();
    driver.key(key::kEnd);
    driver.settle();
    driver.key('W');
    CHECK(driver.context().tools.current().id() == std::string("trace"));
    Camera &camera = driver.context().view.camera;
    camera.centre = (1.0 / 3.0) * (a + b + c);
    camera.zoomAt(driver.canvas().centre(), 100.0 / (camera.zoom * distance(a, b)));
    driver.context().animate();
    driver.settle();
    driver.clickAt(driver.canvas().centre());
    driver.settle();
    REQUIRE(driver.run().birth);
    CHECK(driver.run().birth->kind == Birth::Kind::Triangle);
    CHECK(driver.run().advance == made.advance);
    CHECK(driver.run().explanation->made == made.made);
}

TEST_CASE("Trace: a click sets a breakpoint at a place or at a cell of the grid") {
    Stepping driver;
    driver.key(key::kHome);
    driver.settle();
    driver.key('W');
    driver.frames(2);
    driver.click("options/trace/mode/Point");
    driver.clickAt(driver.context().view.camera.toPixel(driver.run().boundary->bounds().centre()));
    REQUIRE(driver.context().run.breakpoints().has(StopKind::Place));
    driver.key('N');
    driver.settle();
    REQUIRE(driver.run().stop);
    CHECK(driver.run().stop->kind == StopKind::Place);
    driver.key(key::kHome);
    driver.settle();
    driver.click("options/trace/mode/Cell");
    driver.moveTo(driver.canvas().centre());
    driver.settle();
    CHECK(driver.context().layer("grid")->visible);
    driver.clickAt(driver.canvas().centre());
    REQUIRE(driver.context().run.breakpoints().has(StopKind::Cell));
    driver.context().run.setBreakpoints([&] {
        Breakpoints cell = driver.context().run.breakpoints();
        cell.set(StopKind::Place, false);
        return cell;
    }());
    driver.key('N');
    driver.settle();
    REQUIRE(driver.run().stop);
    CHECK(driver.run().stop->kind == StopKind::Cell);
}

TEST_CASE("Candidates: the table lists them; a click on a row shows its numbers and highlights it on the canvas") {
    Stepping driver;
    driver.showPanel("candidates");
    driver.runUntil(hasRejection);
    driver.key('T');
    driver.settle();
    const AdvanceExplanation &e = *driver.run().explanation;
    for (std::size_t i = 0; i < std::min<std::size_t>(e.candidates.size(), 4); ++i) {
        CHECK(driver.has("candidates/" + std::to_string(i)));
    }
    const auto rejected = std::find_if(e.candidates.begin(), e.candidates.end(), isRejected);
    const auto row = static_cast<std::size_t>(rejected - e.candidates.begin());
    driver.moveTo({5, 5});
    driver.settle();
    const auto before = driver.picture();
    driver.click("candidates/" + std::to_string(row));
    driver.moveTo({5, 5});
    driver.settle();
    CHECK(chosenCandidate(driver.context().view, driver.run()) == row);
    CHECK(driver.has("candidates/worked"));
    CHECK(driver.picture().differences(before, driver.canvas()) > 100);
    driver.click("candidates/" + std::to_string(row)); // a second click ends it
    driver.moveTo({5, 5});
    driver.settle();
    CHECK_FALSE(chosenCandidate(driver.context().view, driver.run()));
    CHECK(driver.picture().differences(before, driver.canvas()) == 0);
    driver.click("candidates/0");
    driver.key(key::kPeriod); // belongs to its advance
    driver.settle();
    CHECK_FALSE(chosenCandidate(driver.context().view, driver.run()));
}

TEST_CASE("Moment: the work of each step adds up to the cells and segments of the advance") {
    for (const Method method : {Method::Classic, Method::Fast}) {
        Stepping driver(method);
        for (int i = 0; i < 4; ++i) {
            driver.context().run.step(1);
            driver.settle();
            const Moment moment = momentOf(driver.run());
            REQUIRE(moment);
            StepWork sum;
            for (const StepWork &work : moment.work) {
                sum.cells += work.cells;
                sum.segments += work.segments;
            }
            CHECK(sum.cells == moment.advance->cells.size());
            CHECK(sum.segments == moment.advance->delivered);
        }
        CHECK(momentOf(driver.run()).advance->delivered > 0);
    }
}

TEST_CASE("Run plot: shows the curves above the timeline, and a click in them seeks") {
    Stepping driver;
    REQUIRE(driver.run().curves != nullptr);
    CHECK(driver.run().curves->samples.size() <= RunCurves::kSamples);
    const double high = driver.canvas().height;
    driver.click("timeline/plotswitch");
    driver.settle();
    REQUIRE(driver.has("timeline/plot"));
    CHECK(driver.canvas().height < high);
    const PixelRect plot = driver.context().widgets.find("timeline/plot")->rect;
    driver.clickAt({plot.x + 0.25 * plot.width, plot.centre().y});
    driver.settle();
    const double part = static_cast<double>(driver.run().advance) / static_cast<double>(driver.run().known);
    CHECK(std::abs(part - 0.25) < 0.01);
    driver.click("timeline/plotswitch");
    driver.settle();
    CHECK(driver.canvas().height == high);
}

} // namespace forefront::test
