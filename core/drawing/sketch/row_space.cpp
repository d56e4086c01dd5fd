#include "core/drawing/sketch/row_space.hpp"

#include <cmath>
#include <utility>

namespace forefront {
namespace {

// Dampings, far below the squares of the singular values of sketches. The second is larger, since what it measures is
// relative to it. Repeating a projection removes its error, whose factor is damping/(singular value² + damping).
constexpr double kProjectionDamping = 1e-12, kDependenceDamping = 1e-9;
constexpr int kProjections = 4, kDependenceSteps = 3;

} // namespace

SketchRows unitRows(const SketchRows &given) {
    SketchRows rows = given;
    for (int k = 0; k < rows.rows(); ++k) {
        double squares = 0.0;
        for (SketchRows::InnerIterator entry(rows, k); entry; ++entry) {
            squares += entry.value() * entry.value();
        }
        for (SketchRows::InnerIterator entry(rows, k); entry && squares > 0.0; ++entry) {
            entry.valueRef() /= std::sqrt(squares);
        }
    }
    return rows;
}

RowSpace::RowSpace(const SketchRows &rows) : rows_(unitRows(rows)) {
    const SketchVector ones = SketchVector::Ones(rows_.cols());
    projection_.set(rows_, ones);
    projection_.factorise(kProjectionDamping);
    damped_.set(rows_, ones);
    damped_.factorise(kDependenceDamping);
}

RowSpace::Split RowSpace::split(SketchVector row) const {
    Split split{std::move(row), SketchVector::Zero(rows_.rows())};
    for (int k = 0; k < kProjections && rows_.rows() > 0; ++k) {
        const SketchVector coefficients = projection_.solve(rows_ * split.outside);
        split.coefficients += coefficients;
        split.outside -= rows_.transpose() * coefficients;
    }
    return split;
}

SketchVector RowSpace::dependence() const {
    SketchVector dependence = SketchVector::Zero(rows_.rows());
    for (int k = 0; k < rows_.rows(); ++k) {
        SketchVector share = SketchVector::Unit(rows_.rows(), k);
        for (int step = 0; step < kDependenceSteps; ++step) {
            share = kDependenceDamping * damped_.solve(share);
        }
        dependence[k] = share[k];
    }
    return dependence;
}

} // namespace forefront
