#include "core/engine/quads/quad_blocks.hpp"

#include "core/engine/mesher/mesher.hpp"

#include <array>
#include <utility>

namespace forefront {

std::vector<std::uint32_t> numbersInMesh(const CellView &view, std::size_t boundaryNodes) {
    constexpr std::uint32_t kUsed = 0;
    std::vector<std::uint32_t> numbers(view.nodes.size(), kNoIndex);
    std::fill_n(numbers.begin(), std::min(boundaryNodes, numbers.size()), kUsed);
    for (const QuadCell &cell : view.cells) {
        for (unsigned k = 0; isAlive(cell) && k < cornersOf(cell); ++k) {
            numbers[cell[k]] = kUsed;
        }
    }
    std::uint32_t next = 0;
    for (std::uint32_t &number : numbers) {
        number = number == kUsed ? next++ : kNoIndex;
    }
    return numbers;
}

Mesh meshOfCells(const CellView &view, const DiscreteDomain &boundary) {
    TriMesh tags;
    addTags(tags, boundary, {});
    tags.regions.clear();
    const std::vector<std::uint32_t> numbers = numbersInMesh(view, boundary.nodes.size());
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        if (numbers[n] != kNoIndex) {
            tags.nodes.push_back(view.nodes[n]);
        }
    }
    Mesh result(std::move(tags));
    result.blocks.clear();
    CellBlock triangles(CellKind::Triangle3), quads(CellKind::Quadrilateral4);
    for (std::size_t c = 0; c < view.cells.size(); ++c) {
        const QuadCell &cell = view.cells[c];
        if (!isAlive(cell)) {
            continue;
        }
        std::array<NodeId, 4> nodes{};
        for (unsigned k = 0; k < cornersOf(cell); ++k) {
            nodes[k] = NodeId{numbers[cell[k]]};
        }
        CellBlock &block = isTriangle(cell) ? triangles : quads;
        block.add(std::span(nodes).first(cornersOf(cell)));
        const std::uint32_t face = view.faces.empty() ? 0 : view.faces[c];
        block.regions.push_back(boundary.regions.empty() ? 1 : boundary.regions[face].tag);
    }
    for (CellBlock *block : {&triangles, &quads}) {
        if (block->size() > 0) {
            result.blocks.push_back(std::move(*block));
        }
    }
    return result;
}

} // namespace forefront
