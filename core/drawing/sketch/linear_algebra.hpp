#pragma once

// Eigen, without vector instructions, so that every compiler gives the same bits, and without its parts under licences
// other than MPL 2. It has a namespace of its own here: a program that links this library may use Eigen with other
// settings, and the linker would otherwise keep one of the two copies of each function for both.
#ifdef EIGEN_CORE_H
#error "Eigen is included before core/drawing/sketch/linear_algebra.hpp, with other settings"
#endif
#define EIGEN_DONT_VECTORIZE
#define EIGEN_DONT_PARALLELIZE
#define EIGEN_MPL2_ONLY
#define Eigen forefront_eigen
#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#undef Eigen

namespace forefront {

using SketchVector = forefront_eigen::VectorXd;
using SketchMatrix = forefront_eigen::MatrixXd;
using SketchRows = forefront_eigen::SparseMatrix<double, forefront_eigen::RowMajor>;
using SketchColumns = forefront_eigen::SparseMatrix<double>;

} // namespace forefront
