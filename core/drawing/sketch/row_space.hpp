#pragma once

#include "core/drawing/sketch/normal_equations.hpp"

namespace forefront {

/// The space spanned by the rows of a matrix, each scaled to length 1. Sparse: a test takes as long as a step of the
/// solver, where a dense decomposition of 500 rows takes 100 times as long.
class RowSpace {
  public:
    explicit RowSpace(const SketchRows &rows);

    /// The part of a row outside the space, and the coefficients of the rows that make up the rest.
    struct Split {
        SketchVector outside;
        SketchVector coefficients;
    };
    Split split(SketchVector row) const;

    /// Returns for each row how much it takes part in linear dependences of rows, from 0 (in none) to 1.
    SketchVector dependence() const;

  private:
    SketchRows rows_;
    NormalEquations projection_, damped_;
};

/// Length outside a row space, of a row of length 1, up to which the row counts as dependent.
inline constexpr double kDependent = 1e-6;

/// Returns the rows scaled to length 1; rows of zeros are unchanged.
SketchRows unitRows(const SketchRows &given);

} // namespace forefront
