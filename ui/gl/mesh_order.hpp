#pragma once

#include "core/engine/session/snapshot.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <thread>
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

/// Runs a function on another thread. Throws std::system_error if no thread can be started.
using ThreadStarter = std::function<std::jthread(std::function<void(const std::stop_token &)>)>;

/// Starts a std::jthread.
std::jthread startThread(std::function<void(const std::stop_token &)> run);

/// Sorts the elements of a large mesh on a separate thread, so that the window does not wait for it. If no thread can
/// be started, the constructor sorts them. The destructor waits a few milliseconds at most.
class MeshSorter {
  public:
    /// `start`: replaced by tests.
    explicit MeshSorter(std::shared_ptr<const MeshSnapshot> view, const ThreadStarter &start = startThread);

    bool done() const { return done_; }
    /// Waits until it is done and returns the order; empty if there is not enough memory. Call it once.
    MeshOrder take();

  private:
    void sort(const std::function<bool()> &stopped);

    std::shared_ptr<const MeshSnapshot> view_;
    MeshOrder order_;
    std::atomic<bool> done_ = false;
    std::jthread thread_; ///< last, so that it ends before what it uses
};

} // namespace forefront
