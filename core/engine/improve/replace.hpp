#pragma once

#include "core/engine/improve/cutout.hpp"
#include "core/engine/improve/improve_workspace.hpp"

#include <vector>

namespace forefront {

/// Puts changed cutouts back into the mesh, even if their numbers of nodes and elements have changed. Removed nodes and
/// elements leave gaps, which new ones fill, until compact() closes them. Updates the neighbours, valences and rings of
/// the workspace, but not α.
class Replacer {
  public:
    /// `rho`: ρ per node; grows with new nodes.
    Replacer(ImproveWorkspace &work, RawVector<float> &rho) : work_(work), rho_(rho) {}

    /// Replaces `before`, which must agree with the mesh, by `after`. Returns false and changes nothing if an element
    /// would not be positive (exact sign), if its α would be below `floor`, or if the mesh would be too large.
    bool replace(const Cutout &before, const Cutout &after, double floor);

    /// Returns the nodes and elements that the last replacement may have changed.
    ChangedParts changed() const { return {.all = false, .nodes = changedNodes_, .elements = changedElements_}; }

    /// Closes the gaps with the last elements and nodes. Fast, except for one pass over all elements.
    void compact();

  private:
    /// The local nodes of an element, from the upper byte down.
    using Triple = std::uint32_t;
    struct Side {
        NodeId from, to;
        HalfEdge half;
    };

    bool isValid(const Cutout &after, double floor) const;
    void compare(const Cutout &before, const Cutout &after);
    bool countsFit(const Cutout &before, const Cutout &after) const;
    void removeOld(const Cutout &before);
    NodeId newNode();
    void writeNodes(const Cutout &before, const Cutout &after);
    std::uint32_t slotFor(std::size_t added);
    void insertNew();
    void moveElement(std::uint32_t from, std::uint32_t to);
    void compactElements();
    void compactNodes();
    void renumber(std::size_t kept, const std::vector<NodeId> &places);
    void joinSide(NodeId from, NodeId to, HalfEdge h);

    ImproveWorkspace &work_;
    RawVector<float> &rho_;
    std::vector<std::uint32_t> freeElements_;
    std::vector<NodeId> freeNodes_;
    // For the current cutout:
    std::vector<Triple> before_, after_; ///< elements of only the old and only the new cutout
    std::vector<std::uint32_t> old_;     ///< the elements before_ in the mesh
    std::vector<Side> rim_;              ///< their outer sides; half: the half-edge across, if any
    std::vector<Side> open_;             ///< sides of new elements without a partner so far
    std::vector<NodeId> ids_;
    std::vector<NodeId> changedNodes_;
    std::vector<std::uint32_t> changedElements_;
    std::int32_t region_ = 1;
};

} // namespace forefront
