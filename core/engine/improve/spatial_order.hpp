#pragma once

#include "core/engine/base/thread_pool.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Sorts the nodes and elements of a mesh along a Morton curve, so that neighbours in the plane are close together in
/// memory. The front makes them row by row, and where its rows are short, neighbours of a row are far away in memory,
/// which costs more time than sorting. The order does not depend on the number of threads.
class SpatialOrder {
  public:
    /// Returns true if the nodes of many elements lie far apart in memory.
    static bool helps(const TriMesh &mesh);

    /// Sorts the mesh. Takes 6 bytes per element while the mesh is sorted.
    SpatialOrder(TriMesh &mesh, ThreadPool &pool);

    /// Gives nodes and elements their numbers back. Meanwhile nodes may have moved and elements may have got other
    /// nodes, but there must be as many.
    void restore();

  private:
    void sortNodes();
    void sortElements(const std::vector<std::uint32_t> &rank);
    void renumberTagged(const std::vector<std::uint32_t> &numbers);

    TriMesh &mesh_;
    ThreadPool &pool_;
    std::vector<std::uint32_t> nodes_;    ///< per sorted node: its number
    std::vector<std::uint32_t> elements_; ///< per sorted element: its number
};

} // namespace forefront
