#pragma once

#include "core/engine/session/snapshot.hpp"
#include "ui/background/latest.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace forefront {

/// Number of elements that are drawn with one call.
inline constexpr std::size_t kMeshChunk = 4096;

/// The elements of a mesh sorted by location, so that each chunk of them covers a small part of the plane.
struct MeshOrder {
    std::vector<std::uint32_t> elements; ///< in the order of the chunks
    std::vector<Box2> boxes;             ///< one for each chunk
};

/// Sorts the elements of a mesh along a Z-order curve. `stopped`, if not empty, is called every few milliseconds; once
/// it has returned true, it is not called again, and the result is empty.
MeshOrder orderByPlace(const TriMesh &mesh, const std::function<bool()> &stopped = {});

/// Sorts the elements of a large mesh on a separate thread, so that the window does not wait for it. If no thread can
/// be started, the constructor sorts them. The destructor waits a few milliseconds at most.
class MeshSorter {
  public:
    /// `start`: replaced by tests.
    MeshSorter(BackgroundList &list, std::shared_ptr<const MeshSnapshot> view, ThreadStarter start = startThread);

    bool done() const { return !worker_.working(); }
    /// Waits until it is done and returns the order; empty if there is not enough memory. Call it once.
    MeshOrder take();

  private:
    using Mesh = std::shared_ptr<const MeshSnapshot>;

    std::optional<MeshOrder> small_; ///< of a mesh that was sorted at once
    Latest<Mesh, std::shared_ptr<MeshOrder>> worker_;
};

} // namespace forefront
