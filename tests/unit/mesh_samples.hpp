#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/boundary/discretise.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace forefront::samples {

inline NodeId node(std::size_t n) {
    return NodeId{static_cast<std::uint32_t>(n)};
}

/// A small deterministic generator (xorshift64*), uniform in [0, 1).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ULL + 1) {}
    double operator()() {
        state_ ^= state_ >> 12;
        state_ ^= state_ << 25;
        state_ ^= state_ >> 27;
        return static_cast<double>((state_ * 0x2545f4914f6cdd1dULL) >> 11) * 0x1p-53;
    }
    double operator()(double low, double high) { return low + (high - low) * (*this)(); }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>((*this)() * static_cast<double>(n)); }

  private:
    std::uint64_t state_;
};

/// Returns the square [0,1]² moved by `offset`, as columns x rows cells of two triangles each, with random diagonals;
/// inner nodes displaced by up to `jitter` cells (below 0.25 nothing folds). Boundary edges tagged 1 bottom, 2 right, 3
/// top, 4 left.
inline TriMesh square(std::size_t columns, std::size_t rows, double jitter = 0.0, Vec2 offset = {},
                      std::uint64_t seed = 1) {
    Random random(seed);
    TriMesh mesh;
    const double dx = 1.0 / static_cast<double>(columns), dy = 1.0 / static_cast<double>(rows);
    const auto at = [columns](std::size_t i, std::size_t j) { return node(j * (columns + 1) + i); };
    for (std::size_t j = 0; j <= rows; ++j) {
        for (std::size_t i = 0; i <= columns; ++i) {
            Vec2 p{static_cast<double>(i) * dx, static_cast<double>(j) * dy};
            if (i > 0 && i < columns && j > 0 && j < rows) {
                p += {dx * random(-jitter, jitter), dy * random(-jitter, jitter)};
            }
            mesh.nodes.push_back(p + offset);
        }
    }
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            const NodeId a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            if (random() < 0.5) {
                mesh.elements.insert(mesh.elements.end(), {{a, b, c}, {a, c, d}});
            } else {
                mesh.elements.insert(mesh.elements.end(), {{a, b, d}, {b, c, d}});
            }
        }
    }
    for (std::size_t i = 0; i < columns; ++i) {
        mesh.edges.push_back({at(i, 0), at(i + 1, 0), 1});
        mesh.edges.push_back({at(i + 1, rows), at(i, rows), 3});
    }
    for (std::size_t j = 0; j < rows; ++j) {
        mesh.edges.push_back({at(columns, j), at(columns, j + 1), 2});
        mesh.edges.push_back({at(0, j + 1), at(0, j), 4});
    }
    mesh.boundaryNames = {{1, "bottom"}, {2, "right"}, {3, "top"}, {4, "left"}};
    return mesh;
}

/// Returns the discrete domain of `square`: its tagged edges, with the only region on their left.
inline DiscreteDomain squareDomain(const TriMesh &mesh, double area = 1.0) {
    DiscreteDomain domain;
    domain.regions = {{1, area}};
    for (const TaggedEdge &edge : mesh.edges) {
        const auto a = static_cast<std::uint32_t>(domain.nodes.size());
        domain.nodes.push_back(mesh.nodes[index(edge.a)]);
        domain.nodes.push_back(mesh.nodes[index(edge.b)]);
        domain.segments.push_back({a, a + 1, edge.tag, 0, kOutside, 0});
    }
    return domain;
}

using Codes = std::set<std::string>;

inline Codes codes(const Diagnostics &diagnostics) {
    Codes all;
    for (const Diagnostic &d : diagnostics) {
        all.insert(d.code);
    }
    return all;
}

inline std::string list(const Diagnostics &diagnostics) {
    std::string text;
    for (const Diagnostic &d : diagnostics) {
        text += toString(d) + '\n';
    }
    return text;
}

/// Returns a square whose right half is another region, with a tagged inner line and a tagged inner point.
inline TriMesh constrainedSquare(std::size_t n, double jitter, Vec2 offset, std::uint64_t seed) {
    TriMesh mesh = samples::square(n, n, jitter, offset, seed);
    for (const Element &e : mesh.elements) {
        const std::size_t column = std::min({index(e[0]) % (n + 1), index(e[1]) % (n + 1), index(e[2]) % (n + 1)});
        mesh.regions.push_back(column < n / 2 ? 1 : 2);
    }
    for (std::size_t i = 0; i < n / 3; ++i) {
        const std::size_t row = n / 3;
        mesh.edges.push_back({node(row * (n + 1) + i), node(row * (n + 1) + i + 1), 8});
    }
    mesh.points = {{node((n - 2) * (n + 1) + n - 2), 3}};
    return mesh;
}

} // namespace forefront::samples
