#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/lazy_faces.hpp"
#include "core/engine/spacing/sites/steep_sites.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <limits>

namespace forefront {

/// Everything a part of the spacing is built from.
struct PartInput {
    const SpacingSpec &spec;
    const Domain &domain;
    const LazyFaces &faces; ///< of the domain
    Box2 box;               ///< of the domain
    double minimum;         ///< the given minimum spacing; 0: none
    /// Maximum gradation for parts that are always limited: the given one, or a default.
    double gradation;
    const Progress &progress;

    /// Returns the maximum gradation for expressions and background meshes: the given one, or the steepest that
    /// elements can follow.
    double steepest() const { return spec.gradation.value_or(kSteepestGradation); }
    /// Returns where and how steep slopes of expressions and functions are looked for.
    SteepSearch steepSearch() const { return {box, faces.inside(), steepest(), spec.gradation.has_value()}; }
    /// Returns the maximum gradation for parts with a growth of their own: the given one, or infinity.
    double givenGradation() const { return spec.gradation.value_or(std::numeric_limits<double>::infinity()); }
};

} // namespace forefront
