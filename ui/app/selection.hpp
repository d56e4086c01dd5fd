#pragma once

#include <cstdint>
#include <optional>
#include <set>

namespace forefront {

/// A node of a shape of the document.
struct ShapeNode {
    std::uint32_t shape = 0; ///< Shape::id
    std::uint32_t node = 0;  ///< index into Shape::nodes
    friend auto operator<=>(const ShapeNode &, const ShapeNode &) = default;
};

/// What is selected for editing. Ids of shapes that are gone are ignored.
struct Selection {
    std::set<std::uint32_t> shapes;
    std::set<ShapeNode> nodes;
    std::optional<ShapeNode> segment;    ///< the segment from this node to the next
    std::optional<std::uint32_t> source; ///< index into SpacingSpec::sources

    bool empty() const { return shapes.empty() && nodes.empty() && !segment && !source; }
    void clear() { *this = {}; }
};

} // namespace forefront
