#include "tests/ui/edit_driver.hpp"
#include "ui/canvas/camera.hpp"
#include "ui/input/input_queue.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace forefront::test {

namespace {

InputEvent button(bool pressed) {
    return {.kind = InputKind::MouseButton, .code = 0, .pressed = pressed};
}
InputEvent keyEvent(int code, bool pressed) {
    return {.kind = InputKind::Key, .code = code, .pressed = pressed};
}
InputEvent move(double x, double y) {
    return {.kind = InputKind::MouseMove, .x = x, .y = y};
}

std::size_t framesToEmpty(InputQueue &queue) {
    std::size_t frames = 0;
    while (!queue.empty() && frames < 1000) {
        queue.takeFrame();
        ++frames;
    }
    return frames;
}

} // namespace

TEST_CASE("InputQueue: lets one change of a button through per frame") {
    InputQueue queue;
    for (int i = 0; i < 10; ++i) {
        queue.push(button(true));
        queue.push(button(false));
    }
    CHECK(framesToEmpty(queue) == 20);
}

TEST_CASE("InputQueue: moves share a frame, but not after a click") {
    InputQueue queue;
    queue.push(move(1, 1));
    queue.push(move(2, 2));
    queue.push(button(true));
    queue.push(move(3, 3));
    const auto first = queue.takeFrame();
    REQUIRE(first.size() == 3);
    CHECK(first.back().kind == InputKind::MouseButton);
    const auto second = queue.takeFrame();
    REQUIRE(second.size() == 1);
    CHECK(second.front().x == 3.0);
}

TEST_CASE("InputQueue: a key and its text share a frame, and the next key waits") {
    InputQueue queue;
    queue.push(keyEvent('A', true));
    queue.push({.kind = InputKind::Text, .code = 'a'});
    queue.push(keyEvent('A', false));
    CHECK(queue.takeFrame().size() == 2);
    CHECK(queue.takeFrame().size() == 1);
    CHECK(queue.empty());
}

TEST_CASE("InputQueue: wheel notches share a frame despite pointer jitter between them") {
    InputQueue queue;
    queue.push(move(100, 100));
    for (int i = 0; i < 20; ++i) {
        queue.push({.kind = InputKind::Scroll, .y = 1.0});
        queue.push(move(100 + i % 3, 100));
    }
    queue.push(move(160, 100)); // somewhere else: the earlier notches must not apply there
    CHECK(queue.takeFrame().size() == 41);
    CHECK(queue.takeFrame().size() == 1);
}

TEST_CASE("InputQueue: keys that the caller names share a frame, other keys and clicks do not") {
    InputQueue queue;
    const auto shares = [](const InputEvent &event) { return event.code == key::kPeriod; };
    for (int i = 0; i < 20; ++i) {
        queue.push(keyEvent(key::kPeriod, true));
        queue.push({.kind = InputKind::Text, .code = '.'});
        queue.push(keyEvent(key::kPeriod, false));
    }
    queue.push(keyEvent('A', true));
    queue.push(keyEvent(key::kPeriod, true));
    queue.push(button(true));
    CHECK(queue.takeFrame(shares).size() == 60);
    CHECK(queue.takeFrame(shares).size() == 1);
    CHECK(queue.takeFrame(shares).size() == 1);
    CHECK(queue.takeFrame(shares).size() == 1);
    CHECK(queue.empty());
}

TEST_CASE("InputQueue: a recording is replayed event by event, frame by frame") {
    InputQueue queue;
    queue.startRecording();
    queue.push(move(1.25, -3));
    queue.push(button(true));
    queue.push(button(false));
    queue.push({.kind = InputKind::Key, .code = 'Z', .pressed = true, .modifiers = {Modifiers::kControl}});
    queue.push({.kind = InputKind::Drop, .paths = {"/tmp/a file.poly", "b.json"}});
    std::vector<std::vector<InputEvent>> taken;
    while (!queue.empty()) {
        taken.push_back(queue.takeFrame());
    }
    InputQueue other;
    REQUIRE(other.replay(queue.recording()));
    for (const auto &frame : taken) {
        const auto again = other.takeFrame();
        REQUIRE(again.size() == frame.size());
        for (std::size_t i = 0; i < frame.size(); ++i) {
            CHECK(again[i].kind == frame[i].kind);
            CHECK(again[i].x == frame[i].x);
            CHECK(again[i].code == frame[i].code);
            CHECK(again[i].pressed == frame[i].pressed);
            CHECK(again[i].modifiers == frame[i].modifiers);
            CHECK(again[i].paths == frame[i].paths);
        }
    }
    CHECK_FALSE(other.replaying());
}

TEST_CASE("InputQueue: an invalid recording is refused") {
    InputQueue queue;
    CHECK_FALSE(queue.replay("1 2 3\n"));
    CHECK_FALSE(queue.replay("1 99 0 0 0 0 0 0\n"));
}

TEST_CASE("Camera: zooming keeps the place under the pointer") {
    Camera camera;
    camera.viewport = {100, 50, 800, 600};
    camera.centre = {1.0e5, -2.0e5};
    camera.zoom = 37.0;
    const Pixel pixel{230, 411};
    const Vec2 place = camera.toPlane(pixel);
    for (int i = 0; i < 40; ++i) {
        camera.zoomAt(pixel, i % 3 == 0 ? 0.7 : 1.3);
    }
    const Pixel after = camera.toPixel(place);
    CHECK(std::abs(after.x - pixel.x) < 1e-3);
    CHECK(std::abs(after.y - pixel.y) < 1e-3);
}

TEST_CASE("Camera: fit shows the whole box, even a thin one") {
    Camera camera;
    camera.viewport = {0, 0, 900, 500};
    for (const Box2 &box : {Box2{{0, 0}, {10, 7}}, Box2{{1e5, 1e5}, {1e5 + 1, 1e5}}, Box2{{-3, -1e-9}, {-3, 1e-9}}}) {
        camera.fit(box, camera.viewport);
        const Pixel low = camera.toPixel(box.min), high = camera.toPixel(box.max);
        CHECK(low.x >= 0.0);
        CHECK(low.y <= 500.0);
        CHECK(high.x <= 900.0);
        CHECK(high.y >= 0.0);
    }
}

TEST_CASE("Editor: ten quick clicks on a switch are ten clicks") {
    Driver driver;
    driver.unfoldLayers();
    const auto *widget = driver.context().widgets.find("layer/labels");
    REQUIRE(widget != nullptr);
    const Pixel at = widget->rect.centre();
    const bool before = driver.context().layer("labels")->visible;
    InputQueue &input = driver.editor().input();
    input.push(move(at.x, at.y));
    for (int i = 0; i < 10; ++i) { // all between two frames
        input.push(button(true));
        input.push(button(false));
    }
    input.push(button(true));
    input.push(button(false));
    driver.settle();
    CHECK(driver.context().layer("labels")->visible != before);
}

TEST_CASE("Editor: twenty step keys and twenty wheel notches take a frame each, and every one counts") {
    Driver driver;
    driver.key(key::k2);
    driver.settle();
    driver.key(key::kHome);
    driver.settle();
    InputQueue &input = driver.editor().input();
    for (int i = 0; i < 20; ++i) {
        input.push(keyEvent(key::kPeriod, true));
        input.push({.kind = InputKind::Text, .code = '.'});
        input.push(keyEvent(key::kPeriod, false));
    }
    driver.frames(1);
    CHECK(input.empty());
    driver.settle();
    CHECK(driver.run().advance == 20);
    const double zoom = driver.context().view.camera.zoom;
    driver.moveTo(driver.canvas().centre());
    for (int i = 0; i < 20; ++i) {
        input.push({.kind = InputKind::Scroll, .y = 1.0});
    }
    driver.frames(1);
    CHECK(input.empty());
    CHECK(driver.context().view.camera.zoom == doctest::Approx(zoom * std::pow(1.18, 20)));
}

TEST_CASE("Editor: in a text field every key press counts, even of keys that step elsewhere") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.click("inspector/name");
    InputQueue &input = driver.editor().input();
    for (int i = 0; i < 3; ++i) {
        input.push(keyEvent(key::kPeriod, true));
        input.push({.kind = InputKind::Text, .code = '.'});
        input.push(keyEvent(key::kPeriod, false));
    }
    driver.settle();
    driver.key(key::kBackspace);
    driver.key(key::kEnter);
    CHECK(driver.document().shapes[0]->name == "..");
}

TEST_CASE("Editor: a recorded session replays to the same picture") {
    Driver first;
    first.editor().input().startRecording();
    first.scroll(first.canvas().centre(), 3);
    first.click("canvas/layers");
    first.settle();
    first.click("layer/size");
    first.click("menu/theme");
    first.settle();
    first.frames(40); // past the delay of the hovered button's tooltip
    const auto wanted = first.picture();
    const std::string recording = first.editor().input().recording();

    Driver second;
    REQUIRE(second.editor().input().replay(recording));
    while (second.editor().input().replaying()) {
        second.frames(1);
    }
    second.settle();
    second.frames(40);
    CHECK(second.picture().differences(wanted) < 400);
    CHECK(second.context().theme.kind == first.context().theme.kind);
    CHECK(second.context().view.camera == first.context().view.camera);
}

} // namespace forefront::test
