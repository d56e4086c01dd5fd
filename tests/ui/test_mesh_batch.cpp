#include "core/mesh/quality.hpp"
#include "ui/gl/domain_mask.hpp"
#include "ui/gl/gl_kit.hpp"
#include "ui/gl/mesh_batch.hpp"
#include "ui/platform/egl_platform.hpp"

#include <doctest/doctest.h>
#include <glad/gl.h>

#include <cmath>
#include <memory>

namespace forefront::test {

namespace {

constexpr PixelSize kSize{320, 240};

struct Stage {
    std::unique_ptr<EglPlatform> platform;
    std::unique_ptr<GlKit> gl;
    Camera camera;

    Stage() {
        std::string fault;
        platform = EglPlatform::create(kSize, 1.0, fault);
        REQUIRE_MESSAGE(platform, fault);
        gl = std::make_unique<GlKit>();
        camera.viewport = {0, 0, kSize.width, kSize.height};
    }
    ~Stage() { gl.reset(); }
    Stage(const Stage &) = delete;
    Stage &operator=(const Stage &) = delete;
};

/// n x n squares of side 1, each two elements; the first `elements` of them.
std::shared_ptr<MeshView> lattice(std::uint32_t n, std::size_t elements, std::uint64_t version, Vec2 offset = {}) {
    auto view = std::make_shared<MeshView>();
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

std::vector<std::uint8_t> draw(Stage &stage, MeshBatch &batch, double opacity = 0.0, DrawSlice *slice = nullptr) {
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
    Stage stage;
    const auto view = lattice(120, 28'800, 1);
    stage.camera.fit(view->mesh.bounds(), stage.camera.viewport);
    MeshBatch batch;
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
    Stage stage;
    stage.camera.fit({{0, 0}, {20, 20}}, stage.camera.viewport);
    MeshBatch grown;
    for (const std::size_t count : {10U, 300U, 301U, 800U, 250U, 251U, 640U}) {
        grown.update(lattice(20, count, 1000 + count), false);
        MeshBatch anew;
        anew.update(lattice(20, count, 1), false);
        CHECK(grown.elements() == count);
        CHECK(draw(stage, grown) == draw(stage, anew));
    }
    grown.update(nullptr, false);
    CHECK(painted(draw(stage, grown)) == 0);
}

TEST_CASE("MeshBatch: a mesh whose nodes have moved is uploaded again") {
    Stage stage;
    stage.camera.fit({{0, 0}, {20, 20}}, stage.camera.viewport);
    MeshBatch batch;
    batch.update(lattice(20, 800, 1), false);
    auto moved = lattice(20, 800, 2);
    for (Vec2 &node : moved->mesh.nodes) {
        node = {0.5 * node.x, node.y};
    }
    batch.update(moved, false);
    MeshBatch anew;
    anew.update(moved, false);
    CHECK(draw(stage, batch) == draw(stage, anew));
}

TEST_CASE("MeshBatch: elements already on the GPU are not uploaded again") {
    Stage stage;
    MeshBatch batch;
    const auto whole = lattice(20, 800, 1);
    batch.update(whole, false);
    CHECK(batch.sent() == 800);
    batch.update(whole, false);
    CHECK(batch.sent() == 800);
    batch.update(lattice(20, 250, 2), false); // back
    CHECK(batch.sent() == 800);
    batch.update(lattice(20, 640, 3), false); // forward
    CHECK(batch.sent() == 800 + 390);
}

TEST_CASE("MeshBatch: edges too dense to be distinguished fade to the opacity of the style") {
    Stage stage;
    stage.camera.fit({{0, 0}, {800, 800}}, stage.camera.viewport);
    MeshBatch batch;
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
    Stage stage;
    stage.camera.fit({{0, 0}, {200, 200}}, stage.camera.viewport);
    const auto view = lattice(200, 80000, 1);
    MeshBatch ordered, sorted;
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
    Stage stage;
    MeshBatch here, there;
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
