#pragma once

#include "core/drawing/sketch/scaled_part.hpp"

#include <vector>

namespace forefront {

// The steps of the solver on one part. All leave the part as it was if they fail.

/// Residual, in sizes of the part, down to which equations are solved.
inline constexpr double kSketchTolerance = 1e-11;
/// Residual up to which a constraint counts as satisfied: coordinates of a map are rounded to this.
inline constexpr double kSketchHolds = 1e-9;

struct SatisfyOptions {
    const SketchVector *residuals = nullptr; ///< that are to remain; null: 0
    const SketchVector *weights = nullptr;   ///< of the changes of unknowns, infinite if they stay; null: 1
    double longestStep = 0.3;                ///< change of an unknown in one step, in sizes of the part
    int iterations = 80;
};

/// Finds a solution near x by Levenberg-Marquardt with steps of minimum norm. Returns false if there is none near by,
/// or only one where lines vanish.
bool satisfy(ScaledPart &part, const SatisfyOptions &options = {});

/// Moves x to a place near by where the sum of the squares of the residuals is least, as far as a few steps lead.
void approach(ScaledPart &part);

/// The same, in `steps` equal parts of the way from the residuals at x to 0, which keeps to one branch of solutions.
bool follow(ScaledPart &part, int steps, const SketchVector *weights = nullptr);

/// Moves x to the place nearest to `reference`, by the weights, that satisfies all equations.
bool project(ScaledPart &part, const SketchVector &reference, const SketchVector &weights);

/// Does the same with the unknowns marked as `firm` exactly where they are in `reference`. Gives up soon, since often
/// there is no such place.
bool projectFirm(ScaledPart &part, const SketchVector &reference, const std::vector<bool> &firm);

} // namespace forefront
