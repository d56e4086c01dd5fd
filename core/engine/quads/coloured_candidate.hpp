#pragma once

#include "core/engine/mesher/apex_search.hpp"

#include <cstdint>

namespace forefront {

/// The figures by which an apex of the two-coloured front is chosen.
struct ColouredScore {
    double shape = 0.0;   ///< 1 for half a square, with its right angle where the colours ask for it
    double deltaAC = 1.0; ///< of the side AC; 1 where it is a diagonal
    double deltaCB = 1.0;

    double product() const { return shape * deltaAC * deltaCB; }
};

/// An apex with its colour.
struct ColouredCandidate {
    Candidate apex; ///< its score is the product, more for existing nodes
    std::uint8_t colour;
    ColouredScore figures;
};

} // namespace forefront
