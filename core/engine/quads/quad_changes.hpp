#pragma once

#include "core/engine/quads/quad_workspace.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace forefront {

/// A change of the elements around some nodes, described but not made.
struct QuadChange {
    enum class Kind : std::uint8_t {
        Collapse, ///< two opposite corners of an element become one node
        Rotate,   ///< an edge between two elements joins the next corners instead
        Split,    ///< a node becomes two, with a new element between them
        Doublet,  ///< a node of two elements is removed
        Raise,    ///< a node of the boundary gets one more element, from inside
        Insert,   ///< a node joined to every second corner of two elements makes three of them
        Inset     ///< a smaller element inside an element makes five of it
    };
    static constexpr unsigned kMost = 24;    ///< elements removed or added
    static constexpr unsigned kMaxNodes = 4; ///< added
    /// Stands for the k-th new node in `added`.
    static constexpr std::uint32_t newNode(unsigned k) { return kNoIndex - 1 - k; }

    Kind kind = Kind::Collapse;
    std::uint8_t removedCount = 0, addedCount = 0, nodeCount = 0;
    std::array<std::uint32_t, kMost> removed{};
    std::array<QuadCell, kMost> added{};
    std::array<Vec2, kMaxNodes> places{}; ///< of new nodes
    std::uint32_t killed = kNoIndex;      ///< node that goes
    std::uint32_t moved = kNoIndex;       ///< free node that first moves `to` there
    Vec2 to;
    int irregularity = 0; ///< change of the sum of squares of valence minus target, once known

    void remove(std::uint32_t cell) { removed[removedCount++] = cell; }
    void add(const QuadCell &cell) { added[addedCount++] = cell; }
};

/// Appends the changes that may help an irregular node, without those that would raise the irregularity too much; the
/// most helpful ones first. `generous`: allow changes that raise it more.
void findChanges(const QuadWorkspace &mesh, std::uint32_t node, bool generous, std::vector<QuadChange> &changes);

/// Describes the removal of a node of two elements. Returns false if the node is not one.
bool describeDoublet(const QuadWorkspace &mesh, std::uint32_t node, QuadChange &change);
/// Describes five elements in the place of a convex one.
bool describeInset(const QuadWorkspace &mesh, std::uint32_t cell, QuadChange &change);

} // namespace forefront
