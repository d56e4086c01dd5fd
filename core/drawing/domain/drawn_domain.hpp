#pragma once

#include "core/drawing/domain/divide_at_joints.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/domain/neighbour_sides.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// A domain in the making: what the shapes of a document have drawn, each for itself, and which shape drew what.
struct DrawnDomain {
    Domain domain;
    DomainSources *sources = nullptr;  ///< null: nobody needs them
    std::vector<SegmentRun> loops;     ///< of the closed shapes
    std::vector<JointNode> joints;     ///< nodes that shapes are held by
    std::vector<std::uint32_t> shapes; ///< per segment, as drawn: index into Document::shapes
    std::vector<std::uint32_t> shares; ///< per segment: see DividedSegments::elements; may be shorter
    bool flattened = false;            ///< some chords were chosen regardless of what is near
};

/// Removes the items of a list that are marked; an empty list has none.
template <class Item>
void eraseMarked(const std::vector<bool> &marked, std::vector<Item> &list) {
    std::erase_if(list, [&](const Item &item) { return marked[static_cast<std::size_t>(&item - list.data())]; });
}

} // namespace forefront
