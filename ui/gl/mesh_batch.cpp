#include "ui/gl/mesh_batch.hpp"

#include "ui/gl/gl_kit.hpp"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace forefront {

namespace {

constexpr std::size_t kChunk = 4096;
/// Minimum number of elements for which culling pays off.
constexpr std::size_t kWorthSorting = 16384;

/// Returns a key that orders points along a Z-order curve on a 1024 x 1024 lattice.
std::uint32_t placeKey(Vec2 p, const Box2 &box) {
    const Vec2 size = box.size();
    const auto lattice = [](double t) { return static_cast<std::uint32_t>(std::clamp(t, 0.0, 1.0) * 1023.0); };
    const auto spread = [](std::uint32_t v) {
        v = (v | (v << 8)) & 0x00ff00ffU;
        v = (v | (v << 4)) & 0x0f0f0f0fU;
        v = (v | (v << 2)) & 0x33333333U;
        return (v | (v << 1)) & 0x55555555U;
    };
    return spread(lattice((p.x - box.min.x) / std::max(size.x, 1e-300))) |
           (spread(lattice((p.y - box.min.y) / std::max(size.y, 1e-300))) << 1);
}

Vec2 centroid(const Mesh &mesh, const Element &e) {
    return (1.0 / 3.0) * (mesh.nodes[index(e[0])] + mesh.nodes[index(e[1])] + mesh.nodes[index(e[2])]);
}

bool sameNodes(const std::vector<Vec2> &a, const std::vector<Vec2> &b) {
    const std::size_t common = std::min(a.size(), b.size());
    return common == 0 || std::memcmp(a.data(), b.data(), common * sizeof(Vec2)) == 0;
}

} // namespace

MeshBatch::MeshBatch() {
    glGenVertexArrays(1, &array_);
    glGenBuffers(1, &cornerBuffer_);
    glGenBuffers(1, &valueBuffer_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, cornerBuffer_);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(glm::vec2), nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, valueBuffer_);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, sizeof(float), nullptr);
    glBindVertexArray(0);
}

MeshBatch::~MeshBatch() {
    glDeleteBuffers(1, &cornerBuffer_);
    glDeleteBuffers(1, &valueBuffer_);
    glDeleteVertexArrays(1, &array_);
}

std::size_t MeshBatch::commonPrefix(const MeshView &view) const {
    if (!shown_ || byPlace_ || !sameNodes(shown_->mesh.nodes, view.mesh.nodes)) {
        return 0;
    }
    const auto &a = shown_->mesh.elements, &b = view.mesh.elements;
    const std::size_t common = std::min({a.size(), b.size(), uploaded_});
    const auto differs = std::mismatch(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(common), b.begin());
    return static_cast<std::size_t>(differs.first - a.begin());
}

void MeshBatch::truncate(std::size_t elements) {
    while (!chunks_.empty() && chunks_.back().first >= elements) {
        chunks_.pop_back();
    }
    if (!chunks_.empty()) {
        chunks_.back().count = elements - chunks_.back().first;
    }
    corners_.resize(3 * elements);
    values_.resize(3 * elements);
    uploaded_ = elements;
}

void MeshBatch::writeElement(const MeshView &view, std::size_t element, Chunk &chunk) {
    const float alpha = element < view.alpha.size() ? view.alpha[element] : 1.0F;
    for (const NodeId id : view.mesh.elements[element]) {
        const Vec2 p = view.mesh.nodes[index(id)];
        const Vec2 d = p - chunk.origin;
        chunk.box.add(p);
        corners_.emplace_back(d.x, d.y);
        values_.push_back(alpha);
    }
    ++chunk.count;
}

void MeshBatch::appendInOrder(const MeshView &view, std::size_t from) {
    for (std::size_t i = from; i < view.mesh.elements.size(); ++i) {
        if (chunks_.empty() || chunks_.back().count >= kChunk) {
            chunks_.push_back({centroid(view.mesh, view.mesh.elements[i]), {}, i, 0});
        }
        writeElement(view, i, chunks_.back());
    }
}

void MeshBatch::rebuildByPlace(const MeshView &view) {
    truncate(0);
    const Mesh &mesh = view.mesh;
    const Box2 box = mesh.bounds();
    std::vector<std::uint64_t> order(mesh.elements.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = (static_cast<std::uint64_t>(placeKey(centroid(mesh, mesh.elements[i]), box)) << 32) | i;
    }
    std::sort(order.begin(), order.end());
    corners_.reserve(3 * order.size());
    values_.reserve(3 * order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto element = static_cast<std::size_t>(order[i] & 0xffffffffU);
        if (i % kChunk == 0) {
            chunks_.push_back({centroid(mesh, mesh.elements[element]), {}, i, 0});
        }
        writeElement(view, element, chunks_.back());
    }
}

void MeshBatch::upload(std::size_t fromElement) {
    const std::size_t total = values_.size() / 3;
    const auto bytes = [](std::size_t elements, std::size_t each) {
        return static_cast<GLsizeiptr>(3 * elements * each);
    };
    if (total > capacity_) {
        capacity_ = std::max(total, std::min(2 * capacity_, total + 262144));
        fromElement = 0;
        glBindBuffer(GL_ARRAY_BUFFER, cornerBuffer_);
        glBufferData(GL_ARRAY_BUFFER, bytes(capacity_, sizeof(glm::vec2)), nullptr, GL_DYNAMIC_DRAW);
        glBindBuffer(GL_ARRAY_BUFFER, valueBuffer_);
        glBufferData(GL_ARRAY_BUFFER, bytes(capacity_, sizeof(float)), nullptr, GL_DYNAMIC_DRAW);
    }
    if (fromElement < total) {
        const std::size_t count = total - fromElement;
        sent_ += count;
        glBindBuffer(GL_ARRAY_BUFFER, cornerBuffer_);
        glBufferSubData(GL_ARRAY_BUFFER, bytes(fromElement, sizeof(glm::vec2)), bytes(count, sizeof(glm::vec2)),
                        &corners_[3 * fromElement]);
        glBindBuffer(GL_ARRAY_BUFFER, valueBuffer_);
        glBufferSubData(GL_ARRAY_BUFFER, bytes(fromElement, sizeof(float)), bytes(count, sizeof(float)),
                        &values_[3 * fromElement]);
    }
    uploaded_ = total;
}

void MeshBatch::update(const std::shared_ptr<const MeshView> &view, bool atRest) {
    if (!view) {
        truncate(0);
        shown_ = nullptr;
        return;
    }
    const bool sort = atRest && view->mesh.elements.size() > kWorthSorting;
    if (shown_ && shown_->version == view->version && (byPlace_ || !sort)) {
        return;
    }
    if (sort) {
        rebuildByPlace(*view);
        upload(0);
    } else {
        const std::size_t kept = commonPrefix(*view);
        truncate(kept);
        appendInOrder(*view, kept);
        upload(kept);
    }
    byPlace_ = sort;
    shown_ = view;
}

void MeshBatch::draw(const GlKit &gl, const Camera &camera, const MeshStyle &style) {
    chunksDrawn_ = 0;
    if (uploaded_ == 0) {
        return;
    }
    const ShaderProgram &program = gl.mesh();
    program.use();
    program.set("zoom", static_cast<float>(camera.zoom));
    program.set("viewport", glm::vec2(camera.viewport.width, camera.viewport.height));
    program.set("face", style.face);
    program.set("edge", style.edge);
    program.set("edgeWidth", static_cast<float>(style.edgeWidth));
    program.set("coloured", style.coloured ? 1 : 0);
    program.set("range", glm::vec2(style.range.from, style.range.to));
    program.set("denseEdges", static_cast<float>(style.denseEdges));
    program.set("badBelow", static_cast<float>(style.badBelow));
    program.set("hatch", style.hatch);
    program.set("isolate", glm::vec2(style.isolateFrom, style.isolateTo));
    program.set("map", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, gl.cividis());
    glBindVertexArray(array_);
    const Box2 visible = camera.visible();
    for (const Chunk &chunk : chunks_) {
        if (chunk.count == 0 || !chunk.box.overlaps(visible)) {
            continue;
        }
        const Vec2 offset = camera.zoom * (chunk.origin - camera.centre);
        program.set("offset", glm::vec2(offset.x, offset.y));
        glDrawArrays(GL_TRIANGLES, static_cast<int>(3 * chunk.first), static_cast<int>(3 * chunk.count));
        ++chunksDrawn_;
    }
    glBindVertexArray(0);
}

} // namespace forefront
