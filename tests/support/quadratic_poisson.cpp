#include "tests/support/quadratic_poisson.hpp"

#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/placed_cell.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace forefront::testing {

namespace {

constexpr double kHalfPi = 0.5 * std::numbers::pi;

double solutionAt(Vec2 p) {
    return std::cos(kHalfPi * dot(p, p));
}

/// -Δ of the solution: with q = r², Δu = 4·(q·u'' + u').
double loadAt(Vec2 p) {
    const double q = dot(p, p);
    return 4.0 * (q * kHalfPi * kHalfPi * std::cos(kHalfPi * q) + kHalfPi * std::sin(kHalfPi * q));
}

/// A place of the reference triangle with a weight; the weights add up to 1/2.
struct Station {
    double x, y, weight;
};

/// The rule of degree 6 with 12 stations (D. A. Dunavant, High degree efficient symmetrical Gaussian quadrature rules
/// for the triangle, 1985).
std::vector<Station> stations() {
    std::vector<Station> all;
    const auto addThree = [&](double a, double weight) {
        const double b = 1.0 - 2.0 * a;
        all.insert(all.end(), {{a, a, weight / 2}, {b, a, weight / 2}, {a, b, weight / 2}});
    };
    addThree(0.249286745170910, 0.116786275726379);
    addThree(0.063089014491502, 0.050844906370207);
    const double a = 0.053145049844817, b = 0.310352451033784, c = 1.0 - a - b, weight = 0.082851075618374 / 2;
    for (const auto &[x, y] : {std::pair{a, b}, {b, a}, {a, c}, {c, a}, {b, c}, {c, b}}) {
        all.push_back({x, y, weight});
    }
    return all;
}

/// The shape functions of a triangle of 6 nodes with their derivatives.
struct QuadraticShape {
    std::array<double, 6> value;
    std::array<Vec2, 6> slope;
};

QuadraticShape shapeAt(double x, double y) {
    const std::array<double, 3> l = {1.0 - x - y, x, y};
    const std::array<Vec2, 3> d = {Vec2{-1, -1}, Vec2{1, 0}, Vec2{0, 1}};
    QuadraticShape shape;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        shape.value[k] = l[k] * (2.0 * l[k] - 1.0);
        shape.slope[k] = (4.0 * l[k] - 1.0) * d[k];
        shape.value[3 + k] = 4.0 * l[k] * l[next];
        shape.slope[3 + k] = 4.0 * (l[k] * d[next] + l[next] * d[k]);
    }
    return shape;
}

/// A station of an element: its place in the plane, the weight with the Jacobian determinant, and the gradients of the
/// shape functions.
struct Mapped {
    Vec2 place;
    double weight = 0.0;
    QuadraticShape shape;
};

Mapped mapped(const PlacedCell &cell, const Station &station) {
    Mapped found{{}, 0.0, shapeAt(station.x, station.y)};
    Vec2 alongX, alongY;
    for (std::size_t k = 0; k < 6; ++k) {
        found.place += found.shape.value[k] * cell.nodes[k];
        alongX += found.shape.slope[k].x * cell.nodes[k];
        alongY += found.shape.slope[k].y * cell.nodes[k];
    }
    const double determinant = cross(alongX, alongY);
    for (Vec2 &slope : found.shape.slope) {
        slope = (1.0 / determinant) *
                Vec2{slope.x * alongY.y - slope.y * alongX.y, -slope.x * alongY.x + slope.y * alongX.x};
    }
    found.weight = station.weight * determinant;
    return found;
}

/// Numbers the nodes off the boundary; -1 on it.
std::vector<int> unknowns(const MeshView &mesh, int &count) {
    std::vector<bool> fixed(mesh.nodes.size(), false);
    const EdgeTable table(mesh);
    table.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
        if (sides.size() == 1) {
            fixed[index(a)] = fixed[index(b)] = fixed[index(table.halfEdges().middleOf(sides[0]))] = true;
        }
    });
    std::vector<int> numbers(mesh.nodes.size(), -1);
    count = 0;
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        numbers[n] = fixed[n] ? -1 : count++;
    }
    return numbers;
}

} // namespace

double quadraticPoissonError(const MeshView &mesh) {
    int count = 0;
    const std::vector<int> unknown = unknowns(mesh, count);
    const std::vector<Station> rule = stations();
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    forEachCell(mesh, [&](const PlacedCell &cell, std::size_t e) {
        const std::span<const NodeId> nodes = mesh.nodesOf(e);
        for (const Station &station : rule) {
            const Mapped at = mapped(cell, station);
            for (std::size_t i = 0; i < 6; ++i) {
                const int row = unknown[index(nodes[i])];
                if (row < 0) {
                    continue;
                }
                right[row] += at.weight * loadAt(at.place) * at.shape.value[i];
                for (std::size_t j = 0; j < 6; ++j) {
                    if (const int column = unknown[index(nodes[j])]; column >= 0) {
                        entries.emplace_back(row, column, at.weight * dot(at.shape.slope[i], at.shape.slope[j]));
                    }
                }
            }
        }
    });
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd solution = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
    double square = 0.0;
    forEachCell(mesh, [&](const PlacedCell &cell, std::size_t e) {
        const std::span<const NodeId> nodes = mesh.nodesOf(e);
        for (const Station &station : rule) {
            const Mapped at = mapped(cell, station);
            double value = 0.0;
            for (std::size_t i = 0; i < 6; ++i) {
                const int n = unknown[index(nodes[i])];
                value += n >= 0 ? at.shape.value[i] * solution[n] : 0.0;
            }
            square += at.weight * (value - solutionAt(at.place)) * (value - solutionAt(at.place));
        }
    });
    return std::sqrt(square);
}

} // namespace forefront::testing
