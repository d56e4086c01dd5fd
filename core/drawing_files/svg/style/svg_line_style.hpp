#pragma once

#include "core/engine/geometry/path_bands.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// How the ends of an open stroke look.
enum class SvgCap : std::uint8_t { Butt, Round, Square };

/// How a stroke is drawn; lengths in user units.
struct SvgLineStyle {
    double width = 1.0;
    SvgCap cap = SvgCap::Butt;
    BandCorner corner = BandCorner::Miter;
    double miterLimit = 4.0;
    std::vector<double> dashes; ///< lengths of dashes and gaps in turn, an even number; empty: a solid line
    double dashOffset = 0.0;    ///< where in the dashes the line begins
};

} // namespace forefront
