#pragma once

#include "core/drawing/domain/divide_at_joints.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/domain/neighbour_sides.hpp"
#include "core/engine/base/diagnostic.hpp"
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
    bool flattened = false;            ///< some chords were chosen regardless of what is near
    double samePlace = 0.0;            ///< see samePlaceDistance()
    double farthest = 0.0; ///< greatest distance of a node from the place or the side that it was joined with
    Diagnostics findings;  ///< what the user should know of how shapes meet; errors: two want different
};

/// Removes the items of a list that are marked; an empty list has none.
template <class Item>
void eraseMarked(const std::vector<bool> &marked, std::vector<Item> &list) {
    std::erase_if(list, [&](const Item &item) { return marked[static_cast<std::size_t>(&item - list.data())]; });
}

} // namespace forefront
