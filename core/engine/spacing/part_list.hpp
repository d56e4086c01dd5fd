#pragma once

#include "core/engine/spacing/combined_field.hpp"
#include "core/engine/spacing/parts/part_input.hpp"

#include <span>
#include <string_view>

namespace forefront {

/// One kind of spacing part, with everything needed to build, check, compare, read and write it.
struct SpacingPartKind {
    std::string_view name; ///< as in project files, where it is a member of "spacing" unless it belongs to a place
    bool (*given)(const SpacingSpec &);
    /// Adds the faults of its numbers.
    void (*check)(const SpacingSpec &, Diagnostics &);
    /// Returns true if two specifications agree in this part.
    bool (*same)(const SpacingSpec &, const SpacingSpec &);
    /// Adds the part to the field. Only called if it is given and has no faults.
    Diagnostics (*add)(const PartInput &, FieldParts &);
};

/// Returns all kinds of parts, in the order in which they are added to a field.
std::span<const SpacingPartKind> spacingPartKinds();

/// Returns all faults of the numbers in a specification. Codes: bad-size (sizes, limits, gradation), bad-source,
/// bad-region-area, bad-element-counts; sources and regions by index in `ids`, with a place if known. Paint and
/// background meshes are checked while they are built. `domain`: the domain of the placed sizes.
Diagnostics checkSpacing(const SpacingSpec &spec, const Domain &domain);

/// Returns true if two specifications have the same content, wherever it is in memory.
bool sameContent(const SpacingSpec &a, const SpacingSpec &b);

} // namespace forefront
