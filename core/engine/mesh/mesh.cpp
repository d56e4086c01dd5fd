#include "core/engine/mesh/mesh.hpp"

#include "core/engine/base/assert.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace forefront {

namespace {

// The rows of a block are passed on as one array.
static_assert(sizeof(std::array<NodeId, 6>) == 6 * sizeof(NodeId) &&
              sizeof(std::array<NodeId, 9>) == 9 * sizeof(NodeId));

template <class Rows>
auto flat(Rows &rows) {
    using Node = std::conditional_t<std::is_const_v<Rows>, const NodeId, NodeId>;
    return std::span<Node>(rows.empty() ? nullptr : rows.front().data(),
                           rows.size() * std::tuple_size_v<typename std::remove_const_t<Rows>::value_type>);
}

} // namespace

CellBlock::CellBlock(CellKind kind) : kind_(kind) {
    switch (traitsOf(kind).nodes) {
    case 4:
        rows_.emplace<Rows<4>>();
        break;
    case 6:
        rows_.emplace<Rows<6>>();
        break;
    case 8:
        rows_.emplace<Rows<8>>();
        break;
    case 9:
        rows_.emplace<Rows<9>>();
        break;
    default:
        FOREFRONT_ASSERT(kind == CellKind::Triangle3);
    }
}

std::size_t CellBlock::size() const {
    return std::visit([](const auto &rows) { return rows.size(); }, rows_);
}

std::span<const NodeId> CellBlock::connectivity() const {
    return std::visit([](const auto &rows) { return flat(rows); }, rows_);
}

std::span<NodeId> CellBlock::connectivity() {
    return std::visit([](auto &rows) { return flat(rows); }, rows_);
}

std::span<const NodeId> CellBlock::nodesOf(std::size_t element) const {
    return std::visit([&](const auto &rows) { return std::span<const NodeId>(rows[element]); }, rows_);
}

void CellBlock::add(std::span<const NodeId> nodes) {
    FOREFRONT_ASSERT(nodes.size() == traits().nodes);
    std::visit([&](auto &rows) { std::copy(nodes.begin(), nodes.end(), rows.emplace_back().begin()); }, rows_);
}

void CellBlock::reserve(std::size_t elements) {
    std::visit([&](auto &rows) { rows.reserve(elements); }, rows_);
}

std::span<const Element> CellBlock::triangles() const {
    return kind_ == CellKind::Triangle3 ? std::span<const Element>(std::get<Rows<3>>(rows_))
                                        : std::span<const Element>();
}

std::vector<Element> CellBlock::takeTriangles() && {
    FOREFRONT_ASSERT(kind_ == CellKind::Triangle3);
    return std::move(std::get<Rows<3>>(rows_));
}

Mesh::Mesh(TriMesh triangles)
    : nodes(std::move(triangles.nodes)), edges(std::move(triangles.edges)), points(std::move(triangles.points)),
      curves(std::move(triangles.curves)), edgeStretches(std::move(triangles.edgeStretches)),
      boundaryNames(std::move(triangles.boundaryNames)), regionNames(std::move(triangles.regionNames)) {
    if (!triangles.elements.empty()) {
        blocks.emplace_back(std::move(triangles.elements), std::move(triangles.regions));
    }
}

std::size_t Mesh::elementCount() const {
    std::size_t count = 0;
    for (const CellBlock &block : blocks) {
        count += block.size();
    }
    return count;
}

CellBlock &Mesh::block(CellKind kind) {
    const auto found =
        std::find_if(blocks.begin(), blocks.end(), [&](const CellBlock &block) { return block.kind() == kind; });
    return found != blocks.end() ? *found : blocks.emplace_back(kind);
}

std::span<const Element> Mesh::triangles() const {
    const auto found = std::find_if(blocks.begin(), blocks.end(),
                                    [](const CellBlock &block) { return block.kind() == CellKind::Triangle3; });
    return found != blocks.end() ? found->triangles() : std::span<const Element>();
}

bool Mesh::isTriangular() const {
    return std::all_of(blocks.begin(), blocks.end(),
                       [](const CellBlock &block) { return block.kind() == CellKind::Triangle3 || block.size() == 0; });
}

Box2 Mesh::bounds() const {
    Box2 box;
    for (const Vec2 p : nodes) {
        box.add(p);
    }
    return box;
}

TriMesh takeTriMesh(Mesh mesh) {
    FOREFRONT_ASSERT(mesh.isTriangular());
    TriMesh triangles;
    triangles.nodes = std::move(mesh.nodes);
    for (CellBlock &block : mesh.blocks) {
        if (block.size() == 0) {
            continue;
        }
        std::vector<std::int32_t> regions = std::move(block.regions);
        std::vector<Element> elements = std::move(block).takeTriangles();
        if (triangles.elements.empty()) {
            triangles.elements = std::move(elements);
            triangles.regions = std::move(regions);
        } else { // several blocks, made by hand
            triangles.regions.resize(triangles.elements.size(), 1);
            triangles.elements.insert(triangles.elements.end(), elements.begin(), elements.end());
            regions.resize(elements.size(), 1);
            triangles.regions.insert(triangles.regions.end(), regions.begin(), regions.end());
        }
    }
    triangles.edges = std::move(mesh.edges);
    triangles.points = std::move(mesh.points);
    triangles.curves = std::move(mesh.curves);
    triangles.edgeStretches = std::move(mesh.edgeStretches);
    triangles.boundaryNames = std::move(mesh.boundaryNames);
    triangles.regionNames = std::move(mesh.regionNames);
    return triangles;
}

} // namespace forefront
