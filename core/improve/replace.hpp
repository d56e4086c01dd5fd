#pragma once

#include "core/improve/cutout.hpp"
#include "core/improve/workspace.hpp"

#include <vector>

namespace forefront {

/// Puts changed cutouts back into the mesh, also with other numbers of nodes and elements than they were taken out
/// with. Gone ones leave gaps, which new ones take, until compact() closes them. Of the workspace, neighbours, valences
/// and rings follow; α does not.
class Replacer {
  public:
    /// `rho`: per node, and of new ones.
    Replacer(ImproveWorkspace &work, RawVector<float> &rho) : work_(work), rho_(rho) {}

    /// Puts `is` in the place of `was`, which must be as the mesh is. False, and nothing is changed, where an element
    /// would not be positive (exact sign) or its α less than `floor`, or the mesh too large.
    bool replace(const Cutout &was, const Cutout &is, double floor);

    /// Moves the last elements and nodes into the gaps. Takes little time but for one look at all elements.
    void compact();

  private:
    /// Its local nodes, from the upper byte on.
    using Triple = std::uint32_t;
    struct Side {
        NodeId from, to;
        HalfEdge half;
    };

    bool mayHold(const Cutout &is, double floor) const;
    void compare(const Cutout &was, const Cutout &is);
    bool countsFit(const Cutout &was, const Cutout &is) const;
    void takeOut(const Cutout &was);
    NodeId newNode();
    void writeNodes(const Cutout &was, const Cutout &is);
    std::uint32_t slotFor(std::size_t added);
    void putIn();
    void moveElement(std::uint32_t from, std::uint32_t to);
    void compactElements();
    void compactNodes();
    void renumber(std::size_t kept, const std::vector<NodeId> &places);
    void joinSide(NodeId from, NodeId to, HalfEdge h);

    ImproveWorkspace &work_;
    RawVector<float> &rho_;
    std::vector<std::uint32_t> freeElements_;
    std::vector<NodeId> freeNodes_;
    // Of the cutout at hand:
    std::vector<Triple> before_, after_; ///< elements that only the old, only the new one has
    std::vector<std::uint32_t> old_;     ///< the former in the mesh
    std::vector<Side> rim_;              ///< their outer sides; half: across, none where there is nothing
    std::vector<Side> open_;             ///< sides of new elements that still wait for the other side
    std::vector<NodeId> ids_;
    std::int32_t region_ = 1;
};

} // namespace forefront
