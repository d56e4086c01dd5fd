#pragma once

#include "core/engine/mesher/options.hpp"

#include <span>
#include <string_view>

namespace forefront {

/// A row of the published tables.
struct TableCase {
    std::string_view row; ///< 1A ... 1E, 2A ... 2E, 3, 4
    double rhoMin = 0.0;
    bool adaptive = false; ///< 3 and 4: the domain and the field are ours, see adaptive_case.hpp
};

/// Returns all rows, in the order of the tables.
std::span<const TableCase> tableCases();
/// Returns the row with this name, or null. Ignores case, and accepts a star after 3 and 4, whose cases are our own.
const TableCase *tableCase(std::string_view row);

/// Returns the job of a row that is not adaptive; it keeps the given boundary and does not improve the mesh.
///
/// 1A to 2E: the rectangle [0,90]x[0,60] in 50 segments of length 6. The published domain had 50 boundary nodes
/// (2·Nn − Ne − 2 in every row without grid) and nothing else is known of it; the node spacing
///   first function:  max(ρmin, 0.303·| r(45,30) − 16 |)
///   second function: max(ρmin, 0.298·min(| r(22.5,30) − 12 |, | r(67.5,30) − 12 |)),   r(p): distance to p,
/// reproduces the published numbers of elements within 3 % by ∫ 4/(√3·ρ²) dA.
MeshingJob tableJob(const TableCase &row);

} // namespace forefront
