#pragma once

#include "core/drawing/document/document.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>

namespace forefront {

/// What the constraints of a document leave free, for display.
struct SketchState {
    /// Of freedom: of all shapes, those that no constraint names included, so that a constraint never raises it.
    std::size_t degrees = 0;
    std::set<std::uint32_t> redundant; ///< constraints that follow from constraints before them
    std::set<std::uint32_t> violated;  ///< constraints that do not hold
    /// Parts that constraints name, and whether they cannot move. Those of other shapes are free.
    std::map<SketchPart, bool> determined;

    /// Returns true if a part cannot move without violating a constraint.
    bool isDetermined(const SketchPart &part) const {
        const auto found = determined.find(part);
        return found != determined.end() && found->second;
    }
};

/// Returns the state of a sketch. It takes about as long as a solution.
SketchState sketchState(const Document &document);

} // namespace forefront
