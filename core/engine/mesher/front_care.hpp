#pragma once

#include "core/engine/improve/improve_level.hpp"

namespace forefront {

/// Speed/quality trade-off of the fast method. Better meshes take up to a quarter more time.
struct FrontCare {
    bool fineClasses = false; ///< take bases by 64 length classes per octave; else by two
    bool walks = true;        ///< continue from each base along its loop
    /// Take the segments of the boundary first where their lengths differ; a walk from one then ends at once. Otherwise
    /// a side whose edges are a percent longer than the others waits until the front has crossed the domain, and is met
    /// by it: a band of poor elements lies along it.
    bool boundaryFirst = false;
    /// Minimum distance of an apex from the nodes of its chain, in element sizes. A closer apex squeezes the segments
    /// that follow it.
    double minDistance = 0.78;
};

/// Returns the trade-off that pays off at a level of improvement. Where nodes will not move, the fastest front is as
/// good as any. Measured on graded domains and discs after improvement: fine classes raise δ by 0.005 to 0.012 and make
/// it depend less on the domain; without walks, which lay rings along round boundaries, discs of 10,000 elements rise
/// from α 0.995 to 0.996.
constexpr FrontCare careFor(ImproveLevel level) {
    switch (level) {
    case ImproveLevel::None:
        return {};
    case ImproveLevel::Default:
        return {true, true, true, 0.78};
    case ImproveLevel::Best:
        break;
    }
    return {true, false, true, 0.83};
}

} // namespace forefront
