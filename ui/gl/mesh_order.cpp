#include "ui/gl/mesh_order.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

namespace forefront {

namespace {

/// Cells of the lattice in each direction, as a power of two; a key has twice as many bits.
constexpr unsigned kLatticeBits = 10;
/// Number of elements between two looks at the stop token.
constexpr std::size_t kPatience = 65536;
/// Meshes with at most this many elements are sorted in a few milliseconds, without another thread.
constexpr std::size_t kQuicklySorted = 100'000;

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

bool stopsAt(std::size_t i, const std::stop_token &stop) {
    return i % kPatience == 0 && stop.stop_requested();
}

/// An element and the key of its place.
struct Placed {
    std::uint32_t key = 0, element = 0;
};

/// Sorts by ten bits of the keys; elements with the same bits keep their order.
void sortByBits(const std::vector<Placed> &from, std::vector<Placed> &to, unsigned shift) {
    constexpr std::uint32_t kMask = (1U << kLatticeBits) - 1U;
    std::array<std::size_t, kMask + 2> begin{};
    for (const Placed &placed : from) {
        ++begin[((placed.key >> shift) & kMask) + 1];
    }
    for (std::size_t k = 1; k < begin.size(); ++k) {
        begin[k] += begin[k - 1];
    }
    for (const Placed &placed : from) {
        to[begin[(placed.key >> shift) & kMask]++] = placed;
    }
}

std::vector<Box2> chunkBoxes(const Mesh &mesh, const std::vector<std::uint32_t> &elements,
                             const std::stop_token &stop) {
    std::vector<Box2> boxes((elements.size() + kMeshChunk - 1) / kMeshChunk);
    for (std::size_t i = 0; i < elements.size() && !stopsAt(i, stop); ++i) {
        for (const NodeId node : mesh.elements[elements[i]]) {
            boxes[i / kMeshChunk].add(mesh.nodes[index(node)]);
        }
    }
    return boxes;
}

} // namespace

MeshOrder orderByPlace(const Mesh &mesh, const std::stop_token &stop) {
    const std::size_t count = mesh.elements.size();
    const Box2 box = mesh.bounds();
    MeshOrder order;
    {
        std::vector<Placed> placed(count), sorted(count);
        for (std::size_t i = 0; i < count && !stopsAt(i, stop); ++i) {
            const Element &e = mesh.elements[i];
            const Vec2 centroid =
                (1.0 / 3.0) * (mesh.nodes[index(e[0])] + mesh.nodes[index(e[1])] + mesh.nodes[index(e[2])]);
            placed[i] = {placeKey(centroid, box), static_cast<std::uint32_t>(i)};
        }
        sortByBits(placed, sorted, 0);
        if (stop.stop_requested()) {
            return order;
        }
        sortByBits(sorted, placed, kLatticeBits);
        sorted = {};
        order.elements.resize(count);
        std::transform(placed.begin(), placed.end(), order.elements.begin(), [](const Placed &p) { return p.element; });
    }
    order.boxes = chunkBoxes(mesh, order.elements, stop);
    return order;
}

MeshSorter::MeshSorter(std::shared_ptr<const MeshView> view) : view_(std::move(view)) {
    if (view_->mesh.elements.size() <= kQuicklySorted) {
        order_ = orderByPlace(view_->mesh);
        done_ = true;
        return;
    }
    thread_ = std::jthread([this](const std::stop_token &stop) {
        try {
            order_ = orderByPlace(view_->mesh, stop);
        } catch (const std::bad_alloc &) {
            order_ = {}; // the mesh is drawn in its own order
        }
        done_ = true;
    });
}

MeshOrder MeshSorter::take() {
    if (thread_.joinable()) {
        thread_.join();
    }
    return std::move(order_);
}

} // namespace forefront
