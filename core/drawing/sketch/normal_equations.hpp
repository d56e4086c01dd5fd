#pragma once

#include "core/drawing/sketch/linear_algebra.hpp"

namespace forefront {

/// The equations (J W⁻¹ Jᵀ + μI) λ = b of a step, by sparse LDLᵀ: one row for each equation of a part. They need no
/// independence of the rows, since μ > 0. Dense matrices take 100 times as long at 500 constraints.
class NormalEquations {
  public:
    /// Sets J, the derivatives of the residuals, and the weights W. Later J must have the same pattern.
    void set(const SketchRows &slopes, const SketchVector &weights);
    /// Factorises with a damping. Returns false if that fails.
    bool factorise(double damping);
    SketchVector solve(const SketchVector &right) const { return factors_.solve(right); }
    /// Returns J·step.
    SketchVector apply(const SketchVector &step) const { return slopes_ * step; }
    /// Returns W⁻¹ Jᵀ·λ.
    SketchVector stepOf(const SketchVector &lambda) const;

  private:
    SketchRows slopes_;
    SketchVector inverse_; ///< of the weights
    SketchColumns matrix_;
    forefront_eigen::SimplicialLDLT<SketchColumns> factors_;
    bool analysed_ = false;
};

} // namespace forefront
