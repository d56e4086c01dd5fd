#include "tests/support/poisson.hpp"

#include "core/engine/adapt/gradient_recovery.hpp"
#include "core/engine/mesh/edge_table.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cmath>
#include <numbers>

namespace forefront::testing {

namespace {

double angleFromAxis(Vec2 p) {
    const double angle = std::atan2(p.y, p.x);
    return angle < -1e-12 ? angle + 2.0 * std::numbers::pi : std::max(angle, 0.0);
}

/// ∇u; p is not the origin.
Vec2 cornerGradient(Vec2 p) {
    const double r = length(p), theta = angleFromAxis(p);
    const double size = 2.0 / 3.0 * std::pow(r, -1.0 / 3.0);
    // The component along r is sin(2θ/3), the one across it cos(2θ/3); turned by θ.
    const double along = size * std::sin(2.0 * theta / 3.0), across = size * std::cos(2.0 * theta / 3.0);
    return {along * std::cos(theta) - across * std::sin(theta), along * std::sin(theta) + across * std::cos(theta)};
}

/// ∫ |∇u − g|² over a triangle: three points, on pieces that get small towards the origin.
double squareOver(Vec2 a, Vec2 b, Vec2 c, Vec2 g, int depth) {
    const double size = std::max({distance(a, b), distance(b, c), distance(c, a)});
    const double away = std::min({length(a), length(b), length(c)});
    const Vec2 ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    if (depth > 0 && (depth > 11 || size > 0.3 * away)) {
        return squareOver(a, ab, ca, g, depth - 1) + squareOver(ab, b, bc, g, depth - 1) +
               squareOver(ca, bc, c, g, depth - 1) + squareOver(ab, bc, ca, g, depth - 1);
    }
    const double area = 0.5 * cross(b - a, c - a);
    const auto square = [g](Vec2 p) { return lengthSquared(cornerGradient(p) - g); };
    return area / 3.0 * (square(ab) + square(bc) + square(ca));
}

std::vector<bool> boundaryNodes(const TriMesh &mesh) {
    std::vector<bool> on(mesh.nodes.size(), false);
    EdgeTable(mesh).forEach([&on](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
        if (sides.size() == 1) {
            on[index(a)] = on[index(b)] = true;
        }
    });
    return on;
}

} // namespace

Domain lShape() {
    Domain domain;
    domain.nodes = {{0, 0}, {1, 0}, {1, 1}, {-1, 1}, {-1, -1}, {0, -1}};
    for (std::uint32_t i = 0; i < 6; ++i) {
        domain.segments.push_back({i, (i + 1) % 6, 1, SegmentRole::Boundary});
    }
    return domain;
}

double cornerSolution(Vec2 p) {
    return std::pow(length(p), 2.0 / 3.0) * std::sin(2.0 / 3.0 * angleFromAxis(p));
}

std::vector<double> solveCornerProblem(const TriMesh &mesh) {
    const std::vector<bool> fixed = boundaryNodes(mesh);
    std::vector<double> values(mesh.nodes.size(), 0.0);
    std::vector<int> unknown(mesh.nodes.size(), -1);
    int count = 0;
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (fixed[n]) {
            values[n] = cornerSolution(mesh.nodes[n]);
        } else {
            unknown[n] = count++;
        }
    }
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    for (const Element &element : mesh.elements) {
        Vec2 sides[3]; // opposite to each corner; the gradient of its shape function is the side turned, / 2·area
        for (std::size_t k = 0; k < 3; ++k) {
            sides[k] = mesh.nodes[index(element[(k + 2) % 3])] - mesh.nodes[index(element[(k + 1) % 3])];
        }
        const double area = 0.5 * cross(sides[0], sides[1]);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                const int row = unknown[index(element[i])], column = unknown[index(element[j])];
                const double entry = dot(sides[i], sides[j]) / (4.0 * area);
                if (row >= 0 && column >= 0) {
                    entries.emplace_back(row, column, entry);
                } else if (row >= 0) {
                    right[row] -= entry * values[index(element[j])];
                }
            }
        }
    }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd solution = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (unknown[n] >= 0) {
            values[n] = solution[unknown[n]];
        }
    }
    return values;
}

double cornerEnergyError(const TriMesh &mesh, const std::vector<double> &values) {
    const std::vector<Vec2> gradients = *elementGradients(mesh, values);
    double square = 0.0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Element &n = mesh.elements[e];
        square += squareOver(mesh.nodes[index(n[0])], mesh.nodes[index(n[1])], mesh.nodes[index(n[2])], gradients[e],
                             12); // at least one subdivision
    }
    return std::sqrt(square);
}

} // namespace forefront::testing
