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
/// The first value in the buffer. Three attributes read the buffer at each vertex and the two entries after it, so that
/// the last vertex of an element, whose flat outputs count, has the values of all three corners.
constexpr std::size_t kSkip = 2;
/// Stands for a missing value; the shader draws such parts in the plain colour.
constexpr float kNoValue = -1e30F;
/// Stands for infinity; more than the logarithm of any float, but less than the end of the last bar of a histogram.
constexpr float kInfinite = 86.0F;
/// Version of values of α, which change only with the mesh.
constexpr std::uint64_t kAlphaVersion = ~std::uint64_t{0};
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
    for (unsigned corner = 0; corner < 3; ++corner) {
        glEnableVertexAttribArray(1 + corner);
        glVertexAttribPointer(1 + corner, 1, GL_FLOAT, GL_FALSE, sizeof(float),
                              // OpenGL takes the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
                              reinterpret_cast<const void *>(corner * sizeof(float)));
    }
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
    uploaded_ = elements;
}

void MeshBatch::writeElement(const MeshView &view, std::size_t element, Chunk &chunk) {
    for (const NodeId id : view.mesh.elements[element]) {
        const Vec2 p = view.mesh.nodes[index(id)];
        const Vec2 d = p - chunk.origin;
        chunk.box.add(p);
        corners_.emplace_back(d.x, d.y);
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
    order_.resize(mesh.elements.size());
    const Box2 box = mesh.bounds();
    std::vector<std::uint64_t> order(mesh.elements.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = (static_cast<std::uint64_t>(placeKey(centroid(mesh, mesh.elements[i]), box)) << 32) | i;
    }
    std::sort(order.begin(), order.end());
    corners_.reserve(3 * order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto element = static_cast<std::size_t>(order[i] & 0xffffffffU);
        order_[i] = static_cast<std::uint32_t>(element);
        if (i % kChunk == 0) {
            chunks_.push_back({centroid(mesh, mesh.elements[element]), {}, i, 0});
        }
        writeElement(view, element, chunks_.back());
    }
}

/// Writes the values of the elements from one on, in the order of the buffers.
void MeshBatch::writeValues(const MeshView &view, const MeshValues *values, std::size_t fromElement) {
    const std::size_t total = slots();
    values_.resize(3 * total + kSkip);
    const auto shown = [&](std::size_t number) {
        const double value = number < values->values.size() ? values->values[number] : std::nan("");
        const double scaled = values->logarithmic ? std::log(value) : value; // NaN below 0
        return std::isfinite(scaled) ? static_cast<float>(scaled) : value > 0.0 ? kInfinite : kNoValue;
    };
    for (std::size_t slot = fromElement; slot < total; ++slot) {
        const std::size_t element = elementAt(slot);
        for (std::size_t k = 0; k < 3; ++k) {
            float &value = values_[3 * slot + k + kSkip];
            if (values == nullptr) {
                value = element < view.alpha.size() ? view.alpha[element] : 1.0F;
            } else if (values->part == MeshPart::Elements) {
                value = shown(element);
            } else if (values->part == MeshPart::Edges) {
                value = values->edges != nullptr ? shown(values->edges->ofElement[element][k]) : kNoValue;
            } else {
                value = shown(index(view.mesh.elements[element][k]));
            }
        }
    }
}

void MeshBatch::upload(std::size_t fromElement, std::size_t fromValue) {
    const std::size_t total = slots();
    const auto bytes = [](std::size_t entries, std::size_t each) { return static_cast<GLsizeiptr>(entries * each); };
    if (total > capacity_) {
        capacity_ = std::max(total, std::min(2 * capacity_, total + 262144));
        fromElement = fromValue = 0;
        glBindBuffer(GL_ARRAY_BUFFER, cornerBuffer_);
        glBufferData(GL_ARRAY_BUFFER, bytes(3 * capacity_, sizeof(glm::vec2)), nullptr, GL_DYNAMIC_DRAW);
        glBindBuffer(GL_ARRAY_BUFFER, valueBuffer_);
        glBufferData(GL_ARRAY_BUFFER, bytes(3 * capacity_ + kSkip, sizeof(float)), nullptr, GL_DYNAMIC_DRAW);
    }
    if (fromElement < total) {
        const std::size_t count = total - fromElement;
        sent_ += count;
        glBindBuffer(GL_ARRAY_BUFFER, cornerBuffer_);
        glBufferSubData(GL_ARRAY_BUFFER, bytes(3 * fromElement, sizeof(glm::vec2)), bytes(3 * count, sizeof(glm::vec2)),
                        &corners_[3 * fromElement]);
    }
    if (fromValue < total) {
        glBindBuffer(GL_ARRAY_BUFFER, valueBuffer_);
        glBufferSubData(GL_ARRAY_BUFFER, bytes(3 * fromValue + kSkip, sizeof(float)),
                        bytes(3 * (total - fromValue), sizeof(float)), &values_[3 * fromValue + kSkip]);
    }
    uploaded_ = total;
}

void MeshBatch::update(const std::shared_ptr<const MeshView> &view, bool atRest, const MeshValues *values) {
    if (!view) {
        truncate(0);
        order_.clear();
        shown_ = nullptr;
        return;
    }
    const bool sort = atRest && view->mesh.elements.size() > kWorthSorting;
    const std::uint64_t version = values != nullptr ? values->version : kAlphaVersion;
    const bool sameMesh = shown_ && shown_->version == view->version && (byPlace_ || !sort);
    if (sameMesh && version == valuesVersion_) {
        return;
    }
    std::size_t kept = uploaded_;
    if (!sameMesh && sort) {
        rebuildByPlace(*view);
        kept = 0;
    } else if (!sameMesh) {
        kept = commonPrefix(*view);
        order_.clear();
        truncate(kept);
        appendInOrder(*view, kept);
    }
    // α of an element never changes; other values may.
    const std::size_t keptValues = version == kAlphaVersion && valuesVersion_ == kAlphaVersion ? kept : 0;
    writeValues(*view, values, keptValues);
    upload(kept, keptValues);
    byPlace_ = sameMesh ? byPlace_ : sort;
    if (byPlace_) { // the OpenGL buffers hold a copy, and nothing is appended to a sorted mesh
        corners_ = {};
        values_ = {};
    }
    shown_ = view;
    valuesVersion_ = version;
    part_ = values != nullptr ? values->part : MeshPart::Elements;
    smooth_ = values != nullptr && values->smooth;
    logarithmic_ = values != nullptr && values->logarithmic;
}

void MeshBatch::draw(const GlKit &gl, const Camera &camera, const MeshStyle &style, DrawSlice *slice) {
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
    const auto scaled = [this](double value) {
        return static_cast<float>(logarithmic_ && value > 0.0 ? std::log(value) : value);
    };
    program.set("coloured", style.map != nullptr ? 1 : 0);
    program.set("cyclic", style.cyclic ? 1 : 0);
    program.set("part", smooth_ ? 3 : static_cast<int>(part_));
    program.set("range", glm::vec2(scaled(style.range.from), scaled(style.range.to)));
    program.set("denseEdges", static_cast<float>(style.denseEdges));
    program.set("badBelow", static_cast<float>(style.badBelow));
    program.set("hatch", style.hatch);
    program.set("isolate", style.isolateFrom > style.isolateTo
                               ? glm::vec2(1.0F, 0.0F)
                               : glm::vec2(scaled(style.isolateFrom), scaled(style.isolateTo)));
    program.set("map", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, gl.map(style.map != nullptr ? style.map : cividis));
    glBindVertexArray(array_);
    const Box2 visible = camera.visible();
    std::size_t drawn = 0;
    for (std::size_t k = slice != nullptr ? slice->first : 0; k < chunks_.size(); ++k) {
        const Chunk &chunk = chunks_[k];
        if (chunk.count == 0 || !chunk.box.overlaps(visible)) {
            continue;
        }
        if (slice != nullptr && drawn > 0 && drawn + chunk.count > slice->elements) {
            slice->first = k;
            slice->more = true;
            break;
        }
        drawn += chunk.count;
        const Vec2 offset = camera.zoom * (chunk.origin - camera.centre);
        program.set("offset", glm::vec2(offset.x, offset.y));
        glDrawArrays(GL_TRIANGLES, static_cast<int>(3 * chunk.first), static_cast<int>(3 * chunk.count));
        ++chunksDrawn_;
    }
    glBindVertexArray(0);
}

} // namespace forefront
