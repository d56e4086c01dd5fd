#include "core/engine/mesh/uneven_elements.hpp"

#include "core/engine/mesh/jacobian.hpp"
#include "core/engine/mesh/placed_cell.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace forefront {

namespace {

double uniformityOf(const PlacedCell &cell) {
    if (cell.isStraight()) {
        return straightUniformity(cell);
    }
    return twiceArea(cell) > 0.0 ? jacobianUniformity(cell) : -1.0; // then its maximum is positive
}

} // namespace

std::vector<UnevenElement> unevenElements(const MeshView &mesh) {
    std::vector<UnevenElement> found;
    forEachCell(mesh, [&](const PlacedCell &cell, std::size_t e) {
        if (cell.traits().order != 2) {
            return;
        }
        if (const double ratio = uniformityOf(cell); ratio < kReportedUniformity) {
            found.push_back({static_cast<std::uint32_t>(e), cell.centre(), ratio});
        }
    });
    std::ranges::stable_sort(found, {}, &UnevenElement::ratio);
    return found;
}

std::optional<double> leastJacobianUniformity(const MeshView &mesh) {
    std::optional<double> least;
    forEachCell(mesh, [&](const PlacedCell &cell, std::size_t) {
        if (cell.traits().order == 2) {
            const double ratio = uniformityOf(cell);
            least = std::min(least.value_or(ratio), ratio);
        }
    });
    return least;
}

} // namespace forefront
