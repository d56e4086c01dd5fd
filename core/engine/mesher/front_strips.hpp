#pragma once

#include "core/engine/base/vec2.hpp"

#include <cstddef>
#include <vector>

namespace forefront {

struct DiscreteDomain;
class SpacingField;

/// The strips of the plane in which the fast method advances, one after the other or several at once on threads. In
/// each strip it takes only bases whose whole search stays inside. The strips of a phase do not overlap, so their
/// advances do not depend on each other; the last strip is the whole plane. Strips follow from the domain and the
/// spacing alone, never from the number of threads.
struct FrontStrips {
    std::vector<Box2> boxes; ///< one per strip, phase by phase
    /// Index of the first box of each phase; then boxes.size().
    std::vector<std::size_t> phases;
    std::vector<double> minCoarse; ///< per strip of the second phase: segments from this length on are coarse there

    /// One strip, the whole plane.
    FrontStrips();
    /// One strip, unless at least eight times `perStrip` elements are expected. Then four phases: the coarse segments
    /// of the whole plane, since long segments fit into no strip and fronts start at coarse boundaries; strips across
    /// the longer side of the domain with about equal numbers of elements; strips over their seams; the whole plane.
    /// `perStrip`: number of elements that makes a strip worthwhile. Long boundaries of much finer segments than the
    /// strips are wide get more of them.
    FrontStrips(const DiscreteDomain &domain, const SpacingField &spacing, double perStrip);
    static constexpr double kPerStrip = 62'500.0;

    bool last(std::size_t strip) const { return strip + 1 == boxes.size(); }
    /// Returns the index of the phase of a strip.
    std::size_t phaseOf(std::size_t strip) const;
    /// Returns the strip of a phase that may hold a place: no other one of the phase does.
    std::size_t stripAt(std::size_t phase, Vec2 place) const;
    /// Returns true if the phase of coarse segments leaves a base of this length at this place to a later strip.
    bool tooFine(std::size_t strip, Vec2 middle, double length) const {
        if (strip > 0 || boxes.size() == 1) {
            return false;
        }
        return length < minCoarse[stripAt(1, middle) - phases[1]];
    }
};

} // namespace forefront
