#include "ui/gl/mesh_batch.hpp"

#include "ui/gl/gl_kit.hpp"

#include <glad/gl.h>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>

namespace forefront {

namespace {

/// The first value in the buffer. Three attributes read the buffer at each vertex and the two entries after it, so that
/// the last vertex of an element, whose flat outputs count, has the values of all three corners.
constexpr std::size_t kSkip = 2;
/// The attribute of the edges that are drawn, and its value for all three.
constexpr unsigned kEdgesAttribute = 4;
constexpr float kAllEdges = 7.0F;
/// Stands for a missing value; the shader draws such parts in the plain colour.
constexpr float kNoValue = -1e30F;
/// Stands for infinity; more than the logarithm of any float, but less than the end of the last bar of a histogram.
constexpr float kInfinite = 86.0F;
/// Version of values of α, which change only with the mesh.
constexpr std::uint64_t kAlphaVersion = ~std::uint64_t{0};
/// Minimum number of elements for which culling pays off.
constexpr std::size_t kWorthSorting = 16384;

Vec2 centroid(const TriMesh &mesh, const Element &e) {
    return (1.0 / 3.0) * (mesh.nodes[index(e[0])] + mesh.nodes[index(e[1])] + mesh.nodes[index(e[2])]);
}

bool sameNodes(const std::vector<Vec2> &a, const std::vector<Vec2> &b) {
    const std::size_t common = std::min(a.size(), b.size());
    return common == 0 || std::memcmp(a.data(), b.data(), common * sizeof(Vec2)) == 0;
}

constexpr std::size_t kNoSide = 4;

/// Returns the side of its element that edge k of a triangle is, or is half of; kNoSide for one inside the element.
std::size_t sideOf(const MeshSnapshot &view, std::size_t triangle, std::size_t k) {
    if (!view.whole) {
        return k;
    }
    if (!view.isReal(triangle, k)) {
        return kNoSide;
    }
    const MeshView mesh = view.view();
    const std::span<const NodeId> nodes = mesh.nodesOf(view.element(triangle));
    const std::size_t corners = mesh.cornersOf(view.element(triangle)).size();
    const Element &ends = view.mesh.elements[triangle];
    for (std::size_t side = 0; side < corners; ++side) {
        const auto onSide = [&](NodeId node) {
            return node == nodes[side] || node == nodes[(side + 1) % corners] ||
                   (nodes.size() > corners && node == nodes[corners + side]);
        };
        if (onSide(ends[k]) && onSide(ends[(k + 1) % 3])) {
            return side;
        }
    }
    return kNoSide;
}

/// Returns the value of a corner of a triangle as the shader reads it.
float valueAt(const MeshSnapshot &view, const std::optional<MeshValues> &values, std::size_t triangle,
              std::size_t corner) {
    const std::size_t element = view.element(triangle);
    if (!values) {
        return element < view.alpha.size() ? view.alpha[element] : 1.0F;
    }
    const auto shown = [&](std::size_t number) {
        const double value = number < values->values.size() ? values->values[number] : std::nan("");
        const double scaled = values->logarithmic ? std::log(value) : value; // NaN below 0
        return std::isfinite(scaled) ? static_cast<float>(scaled) : value > 0.0 ? kInfinite : kNoValue;
    };
    if (values->part == MeshPart::Elements) {
        return shown(element);
    }
    if (values->part == MeshPart::Edges) {
        const std::size_t side = values->edges != nullptr ? sideOf(view, triangle, corner) : kNoSide;
        return side != kNoSide ? shown(values->edges->of(element, side)) : kNoValue;
    }
    return shown(index(view.mesh.elements[triangle][corner]));
}

GLsizeiptr bytesOf(std::size_t entries, std::size_t each) {
    return static_cast<GLsizeiptr>(entries * each);
}

} // namespace

/// Buffers for the corners and values of a number of elements.
struct MeshBatch::Page {
    unsigned array = 0, corners = 0, values = 0;
    unsigned edges = 0;       ///< per vertex, which edges of its element are drawn; 0: all, without a buffer
    std::size_t capacity = 0; ///< elements

    Page() {
        glGenVertexArrays(1, &array);
        glGenBuffers(1, &corners);
        glGenBuffers(1, &values);
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, corners);
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(glm::vec2), nullptr);
        glBindBuffer(GL_ARRAY_BUFFER, values);
        for (unsigned corner = 0; corner < 3; ++corner) {
            glEnableVertexAttribArray(1 + corner);
            glVertexAttribPointer(1 + corner, 1, GL_FLOAT, GL_FALSE, sizeof(float),
                                  // OpenGL takes the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
                                  reinterpret_cast<const void *>(corner * sizeof(float)));
        }
        glBindVertexArray(0);
    }
    ~Page() {
        glDeleteBuffers(1, &corners);
        glDeleteBuffers(1, &values);
        glDeleteBuffers(1, &edges);
        glDeleteVertexArrays(1, &array);
    }
    Page(const Page &) = delete;
    Page &operator=(const Page &) = delete;

    /// Makes room for a number of elements; what the buffers held is lost.
    void resize(std::size_t elements) {
        capacity = elements;
        glBindBuffer(GL_ARRAY_BUFFER, corners);
        glBufferData(GL_ARRAY_BUFFER, bytesOf(3 * capacity, sizeof(glm::vec2)), nullptr, GL_DYNAMIC_DRAW);
        glBindBuffer(GL_ARRAY_BUFFER, values);
        glBufferData(GL_ARRAY_BUFFER, bytesOf(3 * capacity + kSkip, sizeof(float)), nullptr, GL_DYNAMIC_DRAW);
        dropEdges();
    }

    /// Makes a buffer for the edges that are drawn, for all its elements.
    void needEdges() {
        if (edges != 0) {
            return;
        }
        glGenBuffers(1, &edges);
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, edges);
        glBufferData(GL_ARRAY_BUFFER, bytesOf(3 * capacity, 1), nullptr, GL_DYNAMIC_DRAW);
        glEnableVertexAttribArray(kEdgesAttribute);
        glVertexAttribPointer(kEdgesAttribute, 1, GL_UNSIGNED_BYTE, GL_FALSE, 1, nullptr);
        glBindVertexArray(0);
    }
    void dropEdges() {
        if (edges != 0) {
            glBindVertexArray(array);
            glDisableVertexAttribArray(kEdgesAttribute);
            glBindVertexArray(0);
            glDeleteBuffers(1, &edges);
            edges = 0;
        }
    }
};

MeshBatch::MeshBatch(BackgroundList &list) : list_(list) {}

MeshBatch::~MeshBatch() = default;

std::size_t MeshBatch::bytes() const {
    std::size_t sum = order_.size() * sizeof(std::uint32_t) + chunks_.size() * sizeof(Chunk);
    for (const std::unique_ptr<Page> &page : pages_) {
        sum += page->capacity * 3 * (sizeof(glm::vec2) + sizeof(float));
    }
    return sum;
}

std::size_t MeshBatch::commonPrefix(const MeshSnapshot &view) const {
    if (!shown_ || byPlace_ || sorter_ || shown_->whole || view.whole ||
        !sameNodes(shown_->mesh.nodes, view.mesh.nodes)) {
        return 0;
    }
    const auto &a = shown_->mesh.elements, &b = view.mesh.elements;
    const std::size_t common = std::min({a.size(), b.size(), elements_});
    const auto differs = std::mismatch(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(common), b.begin());
    return static_cast<std::size_t>(differs.first - a.begin());
}

void MeshBatch::truncate(std::size_t elements) {
    while (!chunks_.empty() && chunks_.back().first >= elements) {
        chunks_.pop_back();
    }
    if (!chunks_.empty()) {
        Chunk &last = chunks_.back();
        last.count = elements - last.first;
        last.corners = std::min(last.corners, last.count);
        last.values = std::min(last.values, last.count);
    }
    elements_ = elements;
}

/// Adds the further elements of a mesh in their own order.
void MeshBatch::extend(const MeshSnapshot &view) {
    const std::vector<Element> &elements = view.mesh.elements;
    elements_ = elements.size();
    for (std::size_t first = chunks_.empty() ? 0 : chunks_.back().first; first < elements_; first += kMeshChunk) {
        if (chunks_.empty() || chunks_.back().first != first) {
            chunks_.push_back({.origin = centroid(view.mesh, elements[first]), .box = {}, .first = first});
        }
        Chunk &chunk = chunks_.back();
        chunk.count = std::min(kMeshChunk, elements_ - first);
        chunk.hasBox = false;
    }
    makeRoom();
}

void MeshBatch::useOrder(MeshOrder order) {
    truncate(0);
    order_ = std::move(order.elements);
    byPlace_ = true;
    if (order_.size() != shown_->mesh.elements.size()) {
        order_.clear();
    }
    extend(*shown_);
    for (std::size_t k = 0; k < chunks_.size() && !order_.empty(); ++k) {
        chunks_[k].origin = centroid(shown_->mesh, shown_->mesh.elements[order_[chunks_[k].first]]);
        chunks_[k].box = order.boxes[k];
        chunks_[k].hasBox = true;
    }
}

/// Makes pages for all elements. A page that changes its size loses what it held.
void MeshBatch::makeRoom() {
    const std::size_t pages = (elements_ + kPageElements - 1) / kPageElements;
    for (std::size_t k = 0; k < pages; ++k) {
        if (k == pages_.size()) {
            pages_.push_back(std::make_unique<Page>());
        }
        const std::size_t needed = std::min(kPageElements, elements_ - k * kPageElements);
        const std::size_t capacity = pages_[k]->capacity;
        const bool wasteful = byPlace_ && capacity > needed + needed / 4; // a sorted mesh does not grow
        if (needed <= capacity && !wasteful) {
            continue;
        }
        pages_[k]->resize(byPlace_ ? needed : std::min(kPageElements, std::max(needed, 2 * capacity)));
        for (Chunk &chunk : chunks_) {
            if (chunk.first / kPageElements == k) {
                chunk.corners = chunk.values = 0;
            }
        }
    }
    if (pages_.size() > 2 * pages) {
        pages_.resize(pages);
    }
}

/// Uploads which edges of the elements to come are drawn, if some are not.
void MeshBatch::uploadEdges(const Chunk &chunk) {
    Page &page = pageOf(chunk);
    if (shown_->realEdges.empty()) {
        page.dropEdges();
        return;
    }
    std::array<std::uint8_t, 3 * kMeshChunk> edges;
    std::size_t end = 0;
    for (std::size_t i = chunk.corners; i < chunk.count; ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            edges[end++] = shown_->realEdges[elementAt(chunk.first + i)];
        }
    }
    page.needEdges();
    glBindBuffer(GL_ARRAY_BUFFER, page.edges);
    glBufferSubData(GL_ARRAY_BUFFER, bytesOf(3 * (chunk.first % kPageElements + chunk.corners), 1), bytesOf(end, 1),
                    edges.data());
}

void MeshBatch::uploadCorners(Chunk &chunk) {
    std::array<glm::vec2, 3 * kMeshChunk> corners;
    std::size_t end = 0;
    for (std::size_t i = chunk.corners; i < chunk.count; ++i) {
        for (const NodeId id : shown_->mesh.elements[elementAt(chunk.first + i)]) {
            const Vec2 p = shown_->mesh.nodes[index(id)];
            const Vec2 d = p - chunk.origin;
            chunk.box.add(p);
            corners[end++] = {d.x, d.y};
        }
    }
    glBindBuffer(GL_ARRAY_BUFFER, pageOf(chunk).corners);
    glBufferSubData(GL_ARRAY_BUFFER, bytesOf(3 * (chunk.first % kPageElements + chunk.corners), sizeof(glm::vec2)),
                    bytesOf(end, sizeof(glm::vec2)), corners.data());
    uploadEdges(chunk);
    uploadedElements_ += chunk.count - chunk.corners;
    chunk.corners = chunk.count;
    chunk.hasBox = true;
}

void MeshBatch::uploadValues(Chunk &chunk) {
    std::array<float, 3 * kMeshChunk> values;
    std::size_t end = 0;
    for (std::size_t i = chunk.values; i < chunk.count; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            values[end++] = valueAt(*shown_, values_, elementAt(chunk.first + i), k);
        }
    }
    glBindBuffer(GL_ARRAY_BUFFER, pageOf(chunk).values);
    glBufferSubData(GL_ARRAY_BUFFER, bytesOf(3 * (chunk.first % kPageElements + chunk.values) + kSkip, sizeof(float)),
                    bytesOf(end, sizeof(float)), values.data());
    chunk.values = chunk.count;
}

/// Uploads the missing parts of a chunk.
void MeshBatch::upload(Chunk &chunk) {
    if (chunk.corners < chunk.count) {
        uploadCorners(chunk);
    }
    if (chunk.values < chunk.count) {
        uploadValues(chunk);
    }
}

void MeshBatch::update(const std::shared_ptr<const MeshSnapshot> &view, bool atRest, const MeshValues *values) {
    if (!view) {
        truncate(0);
        order_ = {};
        pages_.clear();
        sorter_.reset();
        shown_ = nullptr;
        return;
    }
    const bool sort = atRest && view->mesh.elements.size() > kWorthSorting;
    const bool sameMesh = shown_ && shown_->version == view->version && (byPlace_ || sorter_ || !sort);
    if (!sameMesh && sort) {
        sorter_ = std::make_unique<MeshSorter>(list_, view);
    } else if (!sameMesh) {
        const std::size_t kept = commonPrefix(*view);
        sorter_.reset();
        order_ = {};
        byPlace_ = false;
        truncate(kept);
        extend(*view);
    }
    // α of an element never changes; other values may.
    const std::uint64_t version = values != nullptr ? values->version : kAlphaVersion;
    if (version != valuesVersion_) {
        for (Chunk &chunk : chunks_) {
            chunk.values = 0;
        }
    }
    shown_ = view;
    valuesVersion_ = version;
    values_ = values != nullptr ? std::optional(*values) : std::nullopt;
}

/// Makes a program current, sets what all chunks share, and returns it.
const ShaderProgram &MeshBatch::use(const GlKit &gl, const Camera &camera, const MeshStyle &style) const {
    const bool isolates = style.isolateFrom <= style.isolateTo;
    const bool plain = style.map == nullptr && !isolates;
    const ShaderProgram &program = plain ? gl.plainMesh() : gl.mesh();
    program.use();
    program.set("zoom", static_cast<float>(camera.zoom));
    program.set("viewport", glm::vec2(camera.viewport.width, camera.viewport.height));
    program.set("face", style.face);
    program.set("edge", style.edge);
    program.set("edgeWidth", static_cast<float>(style.edgeWidth));
    program.set("denseEdges", static_cast<float>(style.denseEdges));
    if (plain) {
        return program;
    }
    const auto scaled = [this](double value) {
        return static_cast<float>(values_ && values_->logarithmic && value > 0.0 ? std::log(value) : value);
    };
    program.set("coloured", style.map != nullptr ? 1 : 0);
    program.set("cyclic", style.cyclic ? 1 : 0);
    const MeshPart part = values_ ? values_->part : MeshPart::Elements;
    program.set("part", values_ && values_->smooth ? 3 : static_cast<int>(part));
    program.set("range", glm::vec2(scaled(style.range.from), scaled(style.range.to)));
    program.set("badBelow", scaled(style.badBelow));
    program.set("badAbove", scaled(style.badAbove));
    program.set("hatch", style.hatch);
    program.set("isolate",
                isolates ? glm::vec2(scaled(style.isolateFrom), scaled(style.isolateTo)) : glm::vec2(1.0F, 0.0F));
    program.set("map", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, gl.map(style.map != nullptr ? style.map : cividis));
    return program;
}

void MeshBatch::draw(const GlKit &gl, const Camera &camera, const MeshStyle &style, DrawSlice *slice) {
    chunksDrawn_ = 0;
    if (sorter_) {
        if (slice != nullptr && !sorter_->done()) {
            slice->more = slice->waits = true;
            return;
        }
        useOrder(sorter_->take());
        sorter_.reset();
    }
    const Box2 visible = camera.visible();
    const auto inView = [&visible](const Chunk &chunk) { return !chunk.hasBox || chunk.box.overlaps(visible); };
    // All uploads come before all draws: some drivers wait for a draw before they change its buffer.
    const std::size_t first = slice != nullptr ? slice->first : 0;
    std::size_t end = first, done = 0;
    for (; end < chunks_.size(); ++end) {
        Chunk &chunk = chunks_[end];
        if (!inView(chunk)) {
            continue;
        }
        if (slice != nullptr && done > 0 && done + chunk.count > slice->elements) {
            slice->first = end;
            slice->more = true;
            break;
        }
        upload(chunk);
        done += chunk.count;
    }
    if (slice != nullptr) {
        slice->done += done;
    }
    const ShaderProgram &program = use(gl, camera, style);
    glVertexAttrib1f(kEdgesAttribute, kAllEdges); // where a page has no buffer of them
    for (std::size_t k = first; k < end; ++k) {
        const Chunk &chunk = chunks_[k];
        if (!inView(chunk)) {
            continue;
        }
        const Vec2 offset = camera.zoom * (chunk.origin - camera.centre);
        program.set("offset", glm::vec2(offset.x, offset.y));
        glBindVertexArray(pageOf(chunk).array);
        glDrawArrays(GL_TRIANGLES, static_cast<int>(3 * (chunk.first % kPageElements)),
                     static_cast<int>(3 * chunk.count));
        ++chunksDrawn_;
    }
    glBindVertexArray(0);
}

} // namespace forefront
