#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesher/options.hpp"

#include <cstdint>
#include <functional>

namespace forefront {

/// The largest deviation of a mesh from a target number of elements that counts as reached, as a fraction of it.
inline constexpr double kTargetTolerance = 0.05;

/// The sizes that lead to a number of elements, or come nearest to it.
struct TargetSizes {
    double factor = 1.0;        ///< of the element sizes; four significant digits
    std::uint64_t elements = 0; ///< of the mesh with it
    int meshes = 0;             ///< that were made to find it

    bool reaches(std::uint64_t target) const {
        const auto wanted = static_cast<double>(target), difference = static_cast<double>(elements) - wanted;
        return (difference < 0.0 ? -difference : difference) <= kTargetTolerance * wanted;
    }
};

/// Returns the factor that brings the estimated number of elements of a job to a target, with four significant digits;
/// `estimate` >= 1.
double estimatedFactor(double estimate, std::uint64_t target);

/// Finds the factor for all sizes at which the mesh of `jobWith(factor)` has about `target` elements, by meshing:
/// first with the factor that the estimate suggests, then where the counts so far lead, by secants and bisection. Ends
/// within 2 % of the target, two meshes after one within kTargetTolerance, when the factor is found to four digits, or
/// when further factors change nothing, since limits hold the sizes. Deterministic. Errors: bad-target (0, or more than
/// the options allow), those of meshDomain().
Result<TargetSizes> sizesForElements(const std::function<MeshingJob(double factor)> &jobWith, std::uint64_t target,
                                     const Progress &progress = {});

/// Returns a warning that says which number the sizes lead to and which limits hold them; empty if the target is
/// reached. `job`: with these sizes.
Diagnostics missedTarget(const TargetSizes &sizes, std::uint64_t target, const MeshingJob &job);

} // namespace forefront
