#include "app/batch/option_notes.hpp"

#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cstddef>

namespace forefront {

Diagnostics replacedSpacing(const std::string &option, const SpacingSpec &spacing) {
    std::string list;
    const auto add = [&list](bool given, const std::string &part) {
        list += !given ? "" : (list.empty() ? "" : ", ") + part;
    };
    add(!spacing.sources.empty(), countText(spacing.sources.size(), "size source"));
    add(!spacing.partSizes.empty(), "the sizes of " + countText(spacing.partSizes.size(), "boundary part"));
    add(!spacing.placed.elements.empty(), "the numbers of elements of boundary parts");
    add(!spacing.placed.segments.empty(), "the sizes of segments");
    add(!spacing.paint.tiles.empty(), "the painted sizes");
    add(spacing.background != nullptr, "the background mesh");
    add(spacing.fromBoundary, "the lengths of the boundary segments");
    add(spacing.minimum.has_value(), "the minimum size");
    add(spacing.maximum.has_value(), "the maximum size");
    add(spacing.gradation.has_value(), "the gradation");
    add(spacing.segmentsPerTurn.has_value(), "the elements per turn");
    add(spacing.elementsAcross.has_value(), "the elements across narrow places");
    return list.empty()
               ? Diagnostics()
               : Diagnostics{noteOf("replaced-spacing", option + " replaces the spacing of the project, with " + list)};
}

Diagnostics violatedLimits(const MeshView &mesh, const MeshLimits &limits, const SpacingField *spacing) {
    return limits.any() ? warningsOf(checkLimits(mesh, limits, spacing, 1)) : Diagnostics();
}

} // namespace forefront
