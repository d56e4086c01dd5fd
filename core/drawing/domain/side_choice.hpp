#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/domain/neighbour_sides.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <optional>

namespace forefront {

/// Says which of two lines stays where two shapes have drawn one.
struct SideChoice {
    bool dropped = false;                 ///< the line to drop takes the place of the kept one
    std::int32_t tag = 0;                 ///< of the line that stays
    std::optional<Diagnostic> conflict{}; ///< neither can do for both: "side-conflict", with both shapes and the cause
};

/// Chooses between two lines so that nothing is lost: a number of elements or a size that one of them has holds for
/// both, and so does a tag with boundary layers, a periodic partner, a crack or a strip. A number of elements takes
/// precedence over a size. Different values conflict, as does a tag of that kind on a boundary with another tag.
/// `sources`: of the segments of the domain.
SideChoice chooseSide(const Document &document, const Domain &domain, const DomainSources &sources,
                      const NeighbourSide &side);

} // namespace forefront
