#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/vec2.hpp"

#include <span>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

struct Domain;

/// A name for a stretch of the boundary between two nodes: from the one nearest to `from` to the one nearest to `to`,
/// with the domain on the left. If both places are the same, it is the whole loop through the nearest node.
struct PartName {
    std::string name; ///< not empty
    Vec2 from, to;

    friend bool operator==(const PartName &, const PartName &) = default;
};

/// Returns the error "part-place" for places that are farther from a box than a tenth of its diagonal: most likely in
/// other coordinates than those of the box, which the message tells.
Diagnostics checkPlaces(std::span<const PartName> parts, const Box2 &box);

/// Gives the stretches their names, one after the other: each takes the tag of the part that has the name already, or a
/// new one. Stretches inside the domain, and tags of the same name elsewhere, stay. Returns errors or, if there are
/// none, one note with the number of segments, the length and the ends of each stretch.
///
/// Errors: part-place, also where the two places are nearest to one node or to nodes of different loops; those of
/// validate() where segments cross, since there is no left side then.
Diagnostics nameParts(std::span<const PartName> parts, Domain &domain);

} // namespace forefront
