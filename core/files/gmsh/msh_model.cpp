#include "core/files/gmsh/msh_model.hpp"

#include "core/files/common/tagged_sides.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

MshModel::MshModel(const MeshView &mesh, const MshGroups &groups)
    : mesh_(mesh), groups_(groups), owner_(mesh.nodes.size(), kNoIndex) {
    const std::int32_t firstPoint = groups.unusedNumbers(mesh.points.size());
    for (std::uint32_t p = 0; p < mesh.points.size(); ++p) {
        MshEntity &entity = entities_.emplace_back();
        entity.tag = firstPoint + static_cast<std::int32_t>(p);
        entity.physical = groups.number(0, mesh.points[p].tag);
        add(entities_.size() - 1, p);
    }
    for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
        add(entityOf(1, mesh.edges[e].tag), e);
    }
    addElements();
    findBounds();
    for (MshEntity &entity : entities_) {
        findRuns(entity);
    }
    for (std::uint32_t n = 0; n < owner_.size(); ++n) {
        if (owner_[n] == kNoIndex && !entities_.empty()) {
            owner_[n] = static_cast<std::uint32_t>(entities_.size() - 1);
        }
        if (owner_[n] != kNoIndex) {
            entities_[owner_[n]].nodes.push_back(n);
        }
    }
}

std::size_t MshModel::count(int dimension) const {
    return static_cast<std::size_t>(std::count_if(
        entities_.begin(), entities_.end(), [=](const MshEntity &entity) { return entity.dimension == dimension; }));
}

std::size_t MshModel::nodeBlocks() const {
    return static_cast<std::size_t>(std::count_if(entities_.begin(), entities_.end(),
                                                  [](const MshEntity &entity) { return !entity.nodes.empty(); }));
}

std::size_t MshModel::cellBlocks() const {
    std::size_t count = 0;
    for (const MshEntity &entity : entities_) {
        count += entity.runs.size();
    }
    return count;
}

std::size_t MshModel::entityOf(int dimension, std::int32_t tag) {
    const auto [entry, added] = numbers_.emplace(std::pair(dimension, tag), entities_.size());
    if (added) {
        MshEntity &entity = entities_.emplace_back();
        entity.dimension = dimension;
        entity.tag = entity.physical = groups_.number(dimension, tag);
    }
    return entry->second;
}

void MshModel::add(std::size_t number, std::uint32_t part) {
    MshEntity &entity = entities_[number];
    entity.parts.push_back(part);
    forEachNode(entity.dimension, part, [&](NodeId node) {
        entity.box.add(mesh_.nodes[index(node)]);
        std::uint32_t &owner = owner_[index(node)];
        owner = owner == kNoIndex ? static_cast<std::uint32_t>(number) : owner;
    });
}

/// Elements come in long runs of one region, and most of their nodes have already been seen in that region.
void MshModel::addElements() {
    for (const MeshView::Block &block : mesh_.blocks()) {
        for (std::size_t begin = 0, end = 0; begin < block.size(); begin = end) {
            const std::int32_t region = block.region(begin);
            for (end = begin + 1; end < block.size() && block.region(end) == region;) {
                ++end;
            }
            const auto number = static_cast<std::uint32_t>(entityOf(2, region));
            MshEntity &entity = entities_[number];
            const std::size_t before = entity.parts.size();
            entity.parts.resize(before + (end - begin));
            std::iota(entity.parts.begin() + static_cast<std::ptrdiff_t>(before), entity.parts.end(),
                      static_cast<std::uint32_t>(block.first + begin));
            const std::size_t nodes = block.traits().nodes;
            for (const NodeId node : block.connectivity.subspan(begin * nodes, (end - begin) * nodes)) {
                std::uint32_t &owner = owner_[index(node)];
                if (owner != number) {
                    entity.box.add(mesh_.nodes[index(node)]);
                    owner = owner == kNoIndex ? number : owner;
                }
            }
        }
    }
}

/// The elements along tagged edges.
void MshModel::findBounds() {
    const TaggedSides sides(mesh_);
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
        for (const ElementSide &side : sides.of(e)) {
            const std::size_t surface = entityOf(2, mesh_.region(side.element));
            entities_[surface].bounds.insert(groups_.number(1, mesh_.edges[e].tag));
        }
    }
}

CellKind MshModel::kindOf(int dimension, std::uint32_t part) const {
    return dimension == 0 ? CellKind::Point : dimension == 1 ? cellKindOf(mesh_.edges[part]) : mesh_.kindOf(part);
}

/// Sorts the parts of an entity by kind, since a block of an MSH file is of one.
void MshModel::findRuns(MshEntity &entity) const {
    const auto kindOfPart = [&](std::uint32_t part) { return kindOf(entity.dimension, part); };
    std::stable_sort(entity.parts.begin(), entity.parts.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return kindOfPart(a) < kindOfPart(b); });
    for (std::size_t k = 0; k < entity.parts.size(); ++k) {
        const CellKind kind = kindOfPart(entity.parts[k]);
        if (entity.runs.empty() || entity.runs.back().kind != kind) {
            entity.runs.push_back({kind, k, k});
        }
        entity.runs.back().end = k + 1;
    }
}

} // namespace forefront
