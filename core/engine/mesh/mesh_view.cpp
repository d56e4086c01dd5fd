#include "core/engine/mesh/mesh_view.hpp"

#include <algorithm>

namespace forefront {

MeshView::MeshView(const TriMesh &mesh)
    : nodes(mesh.nodes), edges(mesh.edges), points(mesh.points), curves(mesh.curves), edgeStretches(mesh.edgeStretches),
      boundaryNames(mesh.boundaryNames), regionNames(mesh.regionNames) {
    if (!mesh.elements.empty()) {
        add({CellKind::Triangle3, 0, {mesh.elements.front().data(), 3 * mesh.elements.size()}, mesh.regions});
    }
}

MeshView::MeshView(const Mesh &mesh)
    : nodes(mesh.nodes), edges(mesh.edges), points(mesh.points), curves(mesh.curves), edgeStretches(mesh.edgeStretches),
      periodic(mesh.periodic), boundaryNames(mesh.boundaryNames), regionNames(mesh.regionNames) {
    for (const CellBlock &block : mesh.blocks) {
        if (block.size() != 0) {
            add({block.kind(), count_, block.connectivity(), block.regions});
        }
    }
}

void MeshView::add(const Block &block) {
    if (blockCount_ < few_.size()) {
        few_[blockCount_] = block;
    } else {
        if (many_.empty()) {
            many_.assign(few_.begin(), few_.end());
        }
        many_.push_back(block);
    }
    ++blockCount_;
    count_ += block.size();
}

bool MeshView::hasSecondOrder() const {
    return std::any_of(blocks().begin(), blocks().end(), [](const Block &block) { return block.traits().order == 2; });
}

Box2 MeshView::bounds() const {
    Box2 box;
    for (const Vec2 p : nodes) {
        box.add(p);
    }
    return box;
}

Mesh copyOf(const MeshView &view) {
    Mesh mesh;
    mesh.nodes.assign(view.nodes.begin(), view.nodes.end());
    for (const MeshView::Block &from : view.blocks()) {
        CellBlock &to = mesh.blocks.emplace_back(from.kind);
        to.reserve(from.size());
        for (std::size_t k = 0; k < from.size(); ++k) {
            to.add(from.nodesOf(k));
        }
        to.regions.assign(from.regions.begin(), from.regions.end());
    }
    mesh.edges.assign(view.edges.begin(), view.edges.end());
    mesh.points.assign(view.points.begin(), view.points.end());
    mesh.curves.assign(view.curves.begin(), view.curves.end());
    mesh.edgeStretches.assign(view.edgeStretches.begin(), view.edgeStretches.end());
    mesh.periodic.assign(view.periodic.begin(), view.periodic.end());
    mesh.boundaryNames = view.boundaryNames;
    mesh.regionNames = view.regionNames;
    return mesh;
}

} // namespace forefront
