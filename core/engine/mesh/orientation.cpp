#include "core/engine/mesh/orientation.hpp"

#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

// The triangles at opposite corners of a quadrilateral add up to its area, on either diagonal. So the sign that most
// corners have is that of the area. With two against two it crosses itself, or, if two are zero, has no area.
CornerSigns cornerSigns(std::span<const Vec2> nodes, std::span<const NodeId> corners) {
    CornerSigns signs;
    const auto place = [&](std::size_t k) { return nodes[index(corners[k % corners.size()])]; };
    const auto count = [&](int sign, int times) {
        (sign > 0 ? signs.positive : sign < 0 ? signs.negative : signs.zero) += times;
    };
    if (corners.size() == 3) {
        count(orientation(place(0), place(1), place(2)), 3);
        return signs;
    }
    for (std::size_t k = 0; k < corners.size(); ++k) {
        count(orientation(place(k), place(k + 1), place(k + 2)), 1);
    }
    return signs;
}

bool isClockwise(const MeshView &mesh) {
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            if (cornerSigns(mesh.nodes, block.nodesOf(k).first(block.traits().corners)).ofArea() >= 0) {
                return false;
            }
        }
    }
    return mesh.elementCount() != 0;
}

ClockwiseElements clockwiseElements(const MeshView &mesh) {
    ClockwiseElements found;
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            if (cornerSigns(mesh.nodes, block.nodesOf(k).first(block.traits().corners)).ofArea() < 0) {
                found.first = found.count == 0 ? block.first + k : found.first;
                ++found.count;
            }
        }
    }
    return found;
}

TriMesh turned(TriMesh mesh) {
    for (Element &element : mesh.elements) {
        std::swap(element[1], element[2]);
    }
    return mesh;
}

Mesh turned(Mesh mesh) {
    for (CellBlock &block : mesh.blocks) {
        const CellTraits &traits = block.traits();
        const std::span<NodeId> all = block.connectivity();
        for (std::size_t first = 0; first < all.size(); first += traits.nodes) {
            const auto element = all.begin() + static_cast<std::ptrdiff_t>(first);
            std::reverse(element + 1, element + traits.corners);
            if (traits.order == 2) { // the edge that ended at the first corner now starts there
                std::reverse(element + traits.corners, element + 2 * traits.corners);
            }
        }
    }
    return mesh;
}

} // namespace forefront
