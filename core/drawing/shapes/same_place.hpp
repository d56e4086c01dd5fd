#pragma once

#include "core/drawing/document/document.hpp"

namespace forefront {

/// Distance within which two places of a drawing are the same, as a fraction of the diagonal of its lines, since a
/// stray point far away changes nothing of what is drawn: the one tolerance of the joints of the editor, of the nodes
/// and sides that are one in the domain, and of what commands and constraints join.
///
/// Files give six or seven digits of a coordinate at times, and the solver of sketches leaves less; both are within
/// it, and so is what an import joins. What is meant to be apart lies farther apart than that by far: a millionth of
/// the drawing cannot be seen or meshed well.
inline constexpr double kSamePlace = 1e-6;

/// Returns that distance in units of the drawing; 0 for an empty one.
double samePlaceDistance(const Document &document);

} // namespace forefront
