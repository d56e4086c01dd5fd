#pragma once

#include "core/base/vec2.hpp"

#include <cstddef>
#include <vector>

namespace forefront {

struct DiscreteDomain;
class SpacingField;

/// The parts of the plane in which the fast method advances one after the other, or at once on several threads: in each
/// it takes only bases whose whole search stays inside. Regions of one phase do not overlap, so their advances do not
/// depend on each other; the last region is the whole plane. They follow from the domain and the spacing alone, never
/// from the number of threads.
struct FrontRegions {
    std::vector<Box2> boxes;
    /// Index of the first box of each phase; then boxes.size().
    std::vector<std::size_t> phases;
    std::vector<double> leastCoarse; ///< per strip: the least length that is coarse in it

    /// One region: everything.
    FrontRegions();
    /// Where there will be enough elements: everything that is coarse, since long segments fit into no strip and fronts
    /// start at coarse boundaries; then strips across the longer side of the domain, each with about as many elements
    /// to come; then strips over their seams; then everything. `perStrip`: elements that make a strip worth while.
    FrontRegions(const DiscreteDomain &domain, const SpacingField &spacing, double perStrip);
    static constexpr double kPerStrip = 62'500.0;

    bool last(std::size_t region) const { return region + 1 == boxes.size(); }
    /// True if a base of this length at this place is left to the strips.
    bool tooFine(std::size_t region, Vec2 middle, double length) const {
        if (region > 0 || boxes.size() == 1) {
            return false;
        }
        std::size_t strip = phases[1];
        while (!holds(boxes[strip], middle)) {
            ++strip;
        }
        return length < leastCoarse[strip - phases[1]];
    }
};

} // namespace forefront
