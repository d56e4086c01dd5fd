#include "core/engine/mesh/quality.hpp"
#include "ui/gl/domain_mask.hpp"
#include "ui/gl/draw_pace.hpp"
#include "ui/gl/gl_kit.hpp"
#include "ui/gl/mesh_batch.hpp"
#include "ui/platform/egl_platform.hpp"

#include <doctest/doctest.h>
#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace forefront::test {

namespace {

constexpr PixelSize kSize{320, 240};

struct DrawStage {
    std::unique_ptr<EglPlatform> platform;
    BackgroundList background{[] {}};
    std::unique_ptr<GlKit> gl;
    Camera camera;

    DrawStage() {
        std::string fault;
        platform = EglPlatform::create(kSize, 1.0, fault);
        REQUIRE_MESSAGE(platform, fault);
        gl = std::make_unique<GlKit>(background);
        camera.viewport = {0, 0, kSize.width, kSize.height};
    }
    ~DrawStage() { gl.reset(); }
    DrawStage(const DrawStage &) = delete;
    DrawStage &operator=(const DrawStage &) = delete;
};

/// n x n squares of side 1, each two elements; the first `elements` of them.
std::shared_ptr<MeshSnapshot> lattice(std::uint32_t n, std::size_t elements, std::uint64_t version, Vec2 offset = {}) {
    auto view = std::make_shared<MeshSnapshot>();
    view->version = version;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i <= n; ++i) {
            view->mesh.nodes.push_back(offset + Vec2{static_cast<double>(i), static_cast<double>(j)});
        }
    }
    const auto id = [n](std::uint32_t i, std::uint32_t j) { return NodeId{j * (n + 1) + i}; };
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            view->mesh.elements.push_back({id(i, j), id(i + 1, j), id(i, j + 1)});
            view->mesh.elements.push_back({id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    }
    view->mesh.elements.resize(std::min(elements, view->mesh.elements.size()));
    view->alpha = shapeFactors(view->mesh);
    return view;
}

std::vector<std::uint8_t> draw(DrawStage &stage, MeshBatch &batch, double opacity = 0.0, DrawSlice *slice = nullptr) {
    glBindFramebuffer(GL_FRAMEBUFFER, stage.platform->targetFramebuffer());
    glViewport(0, 0, kSize.width, kSize.height);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    MeshStyle style;
    style.face = rgb(0x3060a0);
    style.edge = rgb(0xffffff);
    style.denseEdges = opacity;
    batch.draw(*stage.gl, stage.camera, style, slice);
    return stage.platform->pixels();
}

std::size_t painted(const std::vector<std::uint8_t> &picture) {
    std::size_t count = 0;
    for (std::size_t i = 2; i < picture.size(); i += 4) {
        count += picture[i] > 0 ? 1 : 0;
    }
    return count;
}

} // namespace

TEST_CASE("MeshBatch: slices together draw the same as one draw, and each at most what was asked for") {
    DrawStage stage;
    const auto view = lattice(120, 28'800, 1);
    stage.camera.fit(view->mesh.bounds(), stage.camera.viewport);
    MeshBatch batch(stage.background);
    batch.update(view, true);
    const auto whole = draw(stage, batch);
    const std::size_t chunks = batch.chunksDrawn();
    REQUIRE(chunks > 6);
    std::size_t first = 0, drawn = 0, pixels = 0;
    for (bool more = true; more;) {
        DrawSlice slice{.elements = 10'000, .first = first};
        const auto part = draw(stage, batch, 0.0, &slice); // on an empty picture
        more = slice.more;
        CHECK((!more || slice.first > first));
        first = slice.first;
        CHECK(batch.chunksDrawn() >= 1);
        CHECK(batch.chunksDrawn() <= 2); // 4096 elements each
        drawn += batch.chunksDrawn();
        pixels += painted(part);
    }
    CHECK(drawn == chunks);
    CHECK(pixels == painted(whole));
}

TEST_CASE("MeshBatch: growing and shrinking in place draws the same as rebuilding") {
    DrawStage stage;
    stage.camera.fit({{0, 0}, {20, 20}}, stage.camera.viewport);
    MeshBatch grown(stage.background);
    for (const std::size_t count : {10U, 300U, 301U, 800U, 250U, 251U, 640U}) {
        grown.update(lattice(20, count, 1000 + count), false);
        MeshBatch anew(stage.background);
        anew.update(lattice(20, count, 1), false);
        CHECK(grown.elements() == count);
        CHECK(draw(stage, grown) == draw(stage, anew));
    }
    grown.update(nullptr, false);
    CHECK(painted(draw(stage, grown)) == 0);
}

TEST_CASE("MeshBatch: a mesh whose nodes have moved is uploaded again") {
    DrawStage stage;
    stage.camera.fit({{0, 0}, {20, 20}}, stage.camera.viewport);
    MeshBatch batch(stage.background);
    batch.update(lattice(20, 800, 1), false);
    auto moved = lattice(20, 800, 2);
    for (Vec2 &node : moved->mesh.nodes) {
        node = {0.5 * node.x, node.y};
    }
    batch.update(moved, false);
    MeshBatch anew(stage.background);
    anew.update(moved, false);
    CHECK(draw(stage, batch) == draw(stage, anew));
}

TEST_CASE("MeshBatch: elements already on the GPU are not uploaded again") {
    DrawStage stage;
    stage.camera.fit({{0, 0}, {20, 20}}, stage.camera.viewport);
    MeshBatch batch(stage.background);
    const auto show = [&](const std::shared_ptr<MeshSnapshot> &view) {
        batch.update(view, false);
        draw(stage, batch);
        return batch.uploadedElements();
    };
    const auto whole = lattice(20, 800, 1);
    CHECK(show(whole) == 800);
    CHECK(show(whole) == 800);
    CHECK(show(lattice(20, 250, 2)) == 800);       // back
    CHECK(show(lattice(20, 640, 3)) == 800 + 390); // forward
}

TEST_CASE("MeshBatch: a slice uploads no more than it draws, and chunks out of view are never uploaded") {
    DrawStage stage;
    const auto view = lattice(120, 28'800, 1);
    stage.camera.fit(view->mesh.bounds(), stage.camera.viewport);
    for (const bool atRest : {false, true}) {
        CAPTURE(atRest);
        MeshBatch batch(stage.background);
        batch.update(view, atRest);
        CHECK(batch.uploadedElements() == 0);
        DrawSlice slice{.elements = 9000};
        draw(stage, batch, 0.0, &slice);
        CHECK(batch.uploadedElements() == 8192);
        CHECK(slice.done == 8192);
        draw(stage, batch);
        CHECK(batch.uploadedElements() == 28'800);
    }
    MeshBatch near(stage.background);
    near.update(view, true);
    stage.camera.zoomAt({147, 131}, 30.0);
    draw(stage, near);
    CHECK(near.uploadedElements() < 28'800 / 2);
}

TEST_CASE("MeshBatch: a large mesh is sorted in the background, while slices draw nothing") {
    DrawStage stage;
    const auto view = lattice(400, 320'000, 1);
    stage.camera.fit(view->mesh.bounds(), stage.camera.viewport);
    MeshBatch batch(stage.background);
    batch.update(view, true);
    std::size_t drawn = 0;
    DrawSlice slice;
    do {
        slice = {.elements = 1'000'000};
        draw(stage, batch, 0.0, &slice);
        CHECK((slice.waits ? slice.more && slice.done == 0 : slice.done == 320'000));
        drawn += slice.done;
    } while (slice.waits);
    CHECK(drawn == 320'000);
    CHECK(batch.bytes() < 42 * view->mesh.elements.size());
    MeshBatch other(stage.background);
    other.update(view, true);
    CHECK(draw(stage, other) == draw(stage, batch)); // without a slice, it waits
}

TEST_CASE("MeshBatch: pages of a mesh that grows beyond them draw the same as a new mesh") {
    DrawStage stage;
    stage.camera.fit({{0, 0}, {400, 400}}, stage.camera.viewport);
    MeshBatch grown(stage.background);
    for (const std::size_t count : {100'000U, 150'000U, 262'000U, 263'000U, 320'000U}) {
        CAPTURE(count);
        grown.update(lattice(400, count, count), false);
        MeshBatch anew(stage.background);
        anew.update(lattice(400, count, 1), false);
        CHECK(draw(stage, grown) == draw(stage, anew));
    }
    const std::size_t all = grown.bytes();
    grown.update(lattice(400, 270'000, 1), true); // sorted, it needs no room to grow
    draw(stage, grown);
    CHECK(grown.bytes() < 42 * 270'000);
    grown.update(nullptr, false);
    CHECK(grown.bytes() < all / 100);
}

TEST_CASE("Mesh order: holds each element once, and each chunk lies in its box") {
    const auto view = lattice(150, 45'000, 1);
    const MeshOrder order = orderByPlace(view->mesh);
    REQUIRE(order.elements.size() == 45'000);
    REQUIRE(order.boxes.size() == 11);
    std::vector<bool> seen(45'000);
    double area = 0.0;
    for (std::size_t i = 0; i < order.elements.size(); ++i) {
        seen[order.elements[i]] = true;
        for (const NodeId node : view->mesh.elements[order.elements[i]]) {
            REQUIRE(order.boxes[i / kMeshChunk].contains(view->mesh.nodes[index(node)]));
        }
    }
    CHECK(std::count(seen.begin(), seen.end(), true) == 45'000);
    for (const Box2 &box : order.boxes) {
        area += box.size().x * box.size().y;
    }
    CHECK(area < 3.0 * 150.0 * 150.0); // the boxes overlap little
}

TEST_CASE("Mesh order: a thread sorts a large mesh as the caller would, or is given up") {
    const auto view = lattice(400, 320'000, 1);
    BackgroundList background([] {});
    MeshSorter sorter(background, view);
    const MeshSorter dropped(background, view); // its thread must not outlive it
    const MeshOrder order = sorter.take();
    CHECK(sorter.done());
    CHECK(order.elements == orderByPlace(view->mesh).elements);
}

TEST_CASE("Mesh order: sorting can be stopped many times in each pass over the elements") {
    const auto view = lattice(400, 320'000, 1);
    std::size_t checks = 0, last = 0;
    const auto stopped = [&] { return ++checks == last; };
    CHECK(orderByPlace(view->mesh, stopped).elements.size() == 320'000);
    const std::size_t all = std::exchange(checks, 0);
    CHECK(all >= 6 * 4); // the keys, two passes over each half of their bits, the boxes
    for (last = 1; last <= all; ++last) {
        checks = 0;
        const MeshOrder order = orderByPlace(view->mesh, stopped);
        CHECK(checks == last);
        CHECK(order.elements.empty());
        CHECK(order.boxes.empty());
    }
}

TEST_CASE("Mesh order: a mesh is sorted although no thread can be started") {
    const auto view = lattice(400, 320'000, 1);
    BackgroundList background([] {});
    MeshSorter sorter(background, view, [](const auto &) -> std::thread {
        throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
    });
    CHECK(sorter.done());
    CHECK(sorter.take().elements == orderByPlace(view->mesh).elements);
}

TEST_CASE("Draw pace: pieces follow the time that drawing takes, and begin small") {
    constexpr double kFrame = 0.03;
    DrawPace pace;
    const std::size_t first = pace.next(kFrame);
    CHECK(first <= 10'000);
    const auto drawAt = [&pace](double rate) { // elements per second
        const std::size_t piece = pace.next(kFrame);
        pace.record(piece, static_cast<double>(piece) / rate);
        return piece;
    };
    std::size_t last = 0;
    for (int k = 0; k < 10; ++k) {
        last = drawAt(3e6);
    }
    CHECK(last > 25'000);
    CHECK(last < 35'000); // a hundredth of a second
    drawAt(1e9);
    CHECK(drawAt(1e9) <= 4 * last + 4);
    for (int k = 0; k < 10; ++k) {
        last = drawAt(1e9);
    }
    CHECK(last > 5'000'000);
    drawAt(1e6);
    CHECK(drawAt(1e6) == 10'000);
    CHECK(pace.next(0.0) == first);
    pace.record(10, 1.0); // too few to tell
    CHECK(pace.next(kFrame) == 10'000);
    pace.restart();
    CHECK(pace.next(kFrame) == first);
}

TEST_CASE("MeshBatch: edges too dense to be distinguished fade to the opacity of the style") {
    DrawStage stage;
    stage.camera.fit({{0, 0}, {800, 800}}, stage.camera.viewport);
    MeshBatch batch(stage.background);
    batch.update(lattice(800, 640000, 1), false); // half of it
    for (const double opacity : {0.0, 0.4}) {
        CAPTURE(opacity);
        const std::vector<std::uint8_t> picture = draw(stage, batch, opacity);
        std::size_t faded = 0, bare = 0;
        for (std::size_t i = 0; i < picture.size(); i += 4) {
            faded += picture[i] > 0x30 + 30 && picture[i] < 0xff - 60 ? 1 : 0; // red: between face and edge
            bare += picture[i] == 0x30 ? 1 : 0;
        }
        CHECK((opacity > 0.0 ? faded : bare) > 10000);
        CHECK((opacity > 0.0 ? bare < faded / 20 : faded < bare / 20));
    }
}

TEST_CASE("MeshBatch: sorting by location draws the same, and fewer chunks when zoomed in") {
    DrawStage stage;
    stage.camera.fit({{0, 0}, {200, 200}}, stage.camera.viewport);
    const auto view = lattice(200, 80000, 1);
    MeshBatch ordered(stage.background), sorted(stage.background);
    ordered.update(view, false);
    sorted.update(view, true);
    // The same area is covered either way; single pixels on shared edges may round differently.
    const std::size_t a = painted(draw(stage, ordered)), b = painted(draw(stage, sorted));
    CHECK(a > 30000);
    CHECK(std::max(a, b) - std::min(a, b) < 50);
    const std::size_t all = sorted.chunksDrawn();
    stage.camera.zoomAt({147, 131}, 16.0);
    draw(stage, sorted);
    CHECK(sorted.chunksDrawn() <= all / 3);
    CHECK(sorted.chunksDrawn() >= 1);
}

TEST_CASE("MeshBatch: far from the origin the picture is the same") {
    DrawStage stage;
    MeshBatch here(stage.background), there(stage.background);
    const Vec2 offset{131072.0, -262144.0};
    here.update(lattice(6, 72, 1), false);
    there.update(lattice(6, 72, 1, offset), false);
    stage.camera.fit({{0, 0}, {6, 6}}, stage.camera.viewport);
    stage.camera.zoomAt({100, 90}, 40.0);
    const auto near = draw(stage, here);
    stage.camera.centre += offset;
    CHECK(draw(stage, there) == near);
    CHECK(painted(near) > 1000);
}

TEST_CASE("Domain mask: a square with a hole covers its area, and an open chain is ignored") {
    Camera camera;
    camera.viewport = {0, 0, 100, 100};
    camera.centre = {5, 5};
    camera.zoom = 10.0;
    Domain domain;
    domain.nodes = {{1, 1}, {9, 1}, {9, 9}, {1, 9}, {4, 4}, {6, 4}, {6, 6}, {4, 6}};
    domain.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
    const auto area = [&] {
        double sum = 0.0;
        for (const std::uint8_t cover : rasteriseDomain(domain, camera, 100, 100)) {
            sum += cover / 255.0;
        }
        return sum / 100.0;
    };
    CHECK(std::abs(area() - 60.0) < 0.5);
    domain.segments.pop_back();
    CHECK(area() >= 0.0);
    domain.nodes[0] = {std::nan(""), 1};
    CHECK(area() >= 0.0);
}

} // namespace forefront::test
