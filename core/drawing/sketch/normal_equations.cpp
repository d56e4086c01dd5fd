#include "core/drawing/sketch/normal_equations.hpp"

namespace forefront {

void NormalEquations::set(const SketchRows &slopes, const SketchVector &weights) {
    slopes_ = slopes;
    inverse_ = weights.cwiseInverse();
    const SketchRows weighted = slopes_ * inverse_.asDiagonal();
    matrix_ = SketchColumns(weighted * slopes_.transpose());
}

bool NormalEquations::factorise(double damping) {
    SketchColumns damped = matrix_;
    for (int k = 0; k < damped.rows(); ++k) {
        damped.coeffRef(k, k) += damping;
    }
    if (!analysed_) {
        factors_.analyzePattern(damped);
        analysed_ = true;
    }
    factors_.factorize(damped);
    return factors_.info() == forefront_eigen::Success;
}

SketchVector NormalEquations::stepOf(const SketchVector &lambda) const {
    return inverse_.cwiseProduct(slopes_.transpose() * lambda);
}

} // namespace forefront
