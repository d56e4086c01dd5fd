#pragma once

#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing_files/common/line_outline.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace forefront {

/// Lines that bound nothing because ends of them do not meet. Lengths are in domain units.
struct OpenOutline {
    Vec2 at;                 ///< the first of the ends
    double gap = 0.0;        ///< maximum distance between ends that should meet
    std::size_t gaps = 1;    ///< number of places where they should
    std::size_t segment = 0; ///< the segment that ends there
    bool outer = false;      ///< closed, it would enclose area beyond the domain; otherwise it lies within
};

/// What joining the ends of lines that nearly meet would change.
struct GapFindings {
    LineGaps gaps;                   ///< those that `weld` joins; without it, all
    double weld = 0.0;               ///< a tolerance that joins them and loses nothing; 0: none is known
    std::optional<OpenOutline> open; ///< an outline that joining them closes
};

/// Examines lines whose loops have become boundary. `input`: what they were arranged from. `boundary`: number of
/// segments of these loops. Cost: up to three arrangements if ends nearly meet.
GapFindings examineGaps(const ArrangementInput &input, const Arrangement &lines, std::size_t boundary);

/// Finds a line around the boundary of a domain whose ends are closer to each other than half its length. Of several
/// such lines, only the one that extends over the largest box is examined.
std::optional<OpenOutline> findOpenOutline(const Domain &domain);

/// Returns a message: "the outline does not close at (1, 2) by 0.01, so the area within it is not meshed; ...".
std::string openOutlineText(const OpenOutline &open, double weld);

} // namespace forefront
