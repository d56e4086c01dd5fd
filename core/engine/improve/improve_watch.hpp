#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace FOREFRONT_API forefront {

/// A change that improvement makes to a mesh.
enum class ImproveChange : std::uint8_t {
    Swap,        ///< an edge is swapped for the other diagonal of its two elements
    Sweep,       ///< all free nodes are smoothed at once
    Restore,     ///< nodes return, since an element around them got worse
    RelaxedSwap, ///< an edge is swapped and the nodes around it are relaxed
    Merge,       ///< a node is removed and the nodes around it are relaxed
    Divide,      ///< a node is added and the nodes around it are relaxed
    Cleanup,     ///< a poor element and its surroundings: an edge is swapped, nodes move, or both
    Growth,      ///< nodes move to even the areas of neighbours
    Polish,      ///< nodes move for the shapes alone
    Remainder,   ///< all changes not reported before, as one; comes last
    Completion,  ///< what follows improvement: the minimum angle, other parts of the mesh, cracks, second order
    Renumber,    ///< nodes and elements get other numbers; nothing changes in the plane
    // Of quadrilaterals.
    Pair,      ///< the last triangles of the front are joined, once it is closed
    Walk,      ///< a triangle left over moves to another and is joined to it, unless its way ends before
    Collapse,  ///< two opposite corners of an element become one node
    Rotate,    ///< an edge between two elements joins the next corners instead
    Split,     ///< a node becomes two, with a new element between them
    Doublet,   ///< a node of two elements is removed
    Raise,     ///< a node of the boundary gets one more element
    Insert,    ///< a node makes three elements of two
    Inset,     ///< a smaller element inside an element makes five of it
    Pass,      ///< all changes of one pass over the irregular nodes, of a mesh too large for single ones
    Refill,    ///< elements that are not convex become so: nodes around them move, or others replace them
    DividePoor ///< poor quadrilaterals are divided into triangles
};

template <>
struct EnumWords<ImproveChange> {
    static constexpr auto kLast = ImproveChange::DividePoor;
    static constexpr std::array<std::string_view, 24> kList = {
        "swap",   "sweep",     "restore",    "relaxed-swap", "merge", "divide", "cleanup",  "growth",
        "polish", "remainder", "completion", "renumber",     "pair",  "walk",   "collapse", "rotate",
        "split",  "doublet",   "raise",      "insert",       "inset", "pass",   "refill",   "divide-poor"};
};

/// The parts of a mesh that a change may have affected.
struct ChangedParts {
    bool all = true; ///< any; the lists are empty
    std::span<const NodeId> nodes{};
    std::span<const std::uint32_t> elements{};
};

/// Receives each change that improve() makes to a mesh, in order, on the thread that called it.
class ImproveWatch {
  public:
    virtual ~ImproveWatch() = default;
    /// Called after a change. `places`: of the nodes; smoothing writes them into the mesh only after its last sweep.
    /// Elements that were removed have kNoNode for their nodes until they are renumbered.
    virtual void changed(ImproveChange change, const TriMesh &mesh, std::span<const Vec2> places,
                         const ChangedParts &parts) = 0;
};

} // namespace forefront
