#include "ui/gl/mesh_order.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

namespace forefront {

namespace {

/// Cells of the lattice in each direction, as a power of two; a key has twice as many bits.
constexpr unsigned kLatticeBits = 10;
/// Number of elements between two checks for a stop.
constexpr std::size_t kStopInterval = 65536;
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

/// An element and the key of its place.
struct Placed {
    std::uint32_t key = 0, element = 0;
};

/// Calls `visit` for the numbers from 0 to `count`. Returns false once `stopped` has returned true.
template <class Visit>
bool forEachUntil(std::size_t count, const std::function<bool()> &stopped, Visit visit) {
    for (std::size_t begin = 0; begin < count; begin += kStopInterval) {
        if (stopped && stopped()) {
            return false;
        }
        const std::size_t end = std::min(count, begin + kStopInterval);
        for (std::size_t i = begin; i < end; ++i) {
            visit(i);
        }
    }
    return true;
}

/// Sorts by ten bits of the keys; elements with the same bits keep their order. Returns false if it was stopped.
bool sortByBits(const std::vector<Placed> &from, std::vector<Placed> &to, unsigned shift,
                const std::function<bool()> &stopped) {
    constexpr std::uint32_t kMask = (1U << kLatticeBits) - 1U;
    std::array<std::size_t, kMask + 2> begin{};
    if (!forEachUntil(from.size(), stopped, [&](std::size_t i) { ++begin[((from[i].key >> shift) & kMask) + 1]; })) {
        return false;
    }
    for (std::size_t k = 1; k < begin.size(); ++k) {
        begin[k] += begin[k - 1];
    }
    return forEachUntil(from.size(), stopped,
                        [&](std::size_t i) { to[begin[(from[i].key >> shift) & kMask]++] = from[i]; });
}

/// Returns the elements in the order of their places; empty if it was stopped.
std::vector<std::uint32_t> sortedElements(const TriMesh &mesh, const std::function<bool()> &stopped) {
    const std::size_t count = mesh.elements.size();
    const Box2 box = mesh.bounds();
    std::vector<Placed> placed(count), sorted(count);
    const bool complete = forEachUntil(count, stopped,
                                       [&](std::size_t i) {
                                           const Element &e = mesh.elements[i];
                                           const Vec2 centroid =
                                               (1.0 / 3.0) * (mesh.nodes[index(e[0])] + mesh.nodes[index(e[1])] +
                                                              mesh.nodes[index(e[2])]);
                                           placed[i] = {placeKey(centroid, box), static_cast<std::uint32_t>(i)};
                                       }) &&
                          sortByBits(placed, sorted, 0, stopped) && sortByBits(sorted, placed, kLatticeBits, stopped);
    if (!complete) {
        return {};
    }
    sorted = {};
    std::vector<std::uint32_t> elements(count);
    std::transform(placed.begin(), placed.end(), elements.begin(), [](const Placed &p) { return p.element; });
    return elements;
}

} // namespace

MeshOrder orderByPlace(const TriMesh &mesh, const std::function<bool()> &stopped) {
    MeshOrder order;
    order.elements = sortedElements(mesh, stopped);
    order.boxes.resize((order.elements.size() + kMeshChunk - 1) / kMeshChunk);
    const bool complete = forEachUntil(order.elements.size(), stopped, [&](std::size_t i) {
        for (const NodeId node : mesh.elements[order.elements[i]]) {
            order.boxes[i / kMeshChunk].add(mesh.nodes[index(node)]);
        }
    });
    return complete ? order : MeshOrder();
}

namespace {

/// Returns the order; empty if there is not enough memory: the mesh is then drawn in its own order.
MeshOrder orderWithinMemory(const TriMesh &mesh, const std::function<bool()> &stopped) {
    try {
        return orderByPlace(mesh, stopped);
    } catch (const std::bad_alloc &) {
        return {};
    }
}

} // namespace

MeshSorter::MeshSorter(BackgroundList &list, std::shared_ptr<const MeshSnapshot> view, ThreadStarter start)
    : worker_(
          list,
          [](const LatestTurn<Mesh, std::shared_ptr<MeshOrder>> &turn) {
              return std::make_shared<MeshOrder>(
                  orderWithinMemory(turn.request->mesh, [&turn] { return turn.stop.stop_requested(); }));
          },
          std::make_shared<MeshOrder>(), LeavableThread::kForever, NewsPace::WhenUsed, std::move(start)) {
    if (view->mesh.elements.size() > kQuicklySorted) {
        worker_.submit(std::move(view));
    } else {
        small_ = orderWithinMemory(view->mesh, {});
    }
}

MeshOrder MeshSorter::take() {
    if (small_) {
        return *std::move(small_);
    }
    worker_.wait();
    worker_.refresh();
    return std::move(*worker_.now());
}

} // namespace forefront
